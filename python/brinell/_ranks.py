# SPDX-License-Identifier: BSD-3-Clause
"""What several processes of mpi4py do together."""

from __future__ import annotations

import sys
import time
import traceback
from collections.abc import Callable
from typing import TYPE_CHECKING

from brinell import errors

if TYPE_CHECKING:
    from mpi4py import MPI

_PATIENCE = 5.0
"""Time [s] that a process which has failed leaves the others to end as well, before it ends them: as in the program."""


def done_together(comm: MPI.Comm, work: Callable[[MPI.Comm], None]) -> None:
    """Does work by all processes. What one of them raises all raise.

    Where one alone has failed, others wait for it within their work and cannot be told: all of them are ended, after
    the traceback of that one has been printed.

    Args:
        comm: the processes.
        work: gets them as a communicator that nothing else uses.

    Raises:
        BaseException: what this process has raised, else an error of the same kind as the first other one.
    """
    within, around = comm.Dup(), comm.Dup()
    failure: BaseException | None = None
    try:
        work(within)
    except BaseException as error:
        failure = error
    all_have_ended = around.Ibarrier()
    start = time.monotonic()
    while not all_have_ended.Test():
        if failure is not None and time.monotonic() - start > _PATIENCE:
            print(f"brinell: process {comm.Get_rank()} has failed, and the others wait for it:", file=sys.stderr)
            traceback.print_exception(failure)
            sys.stderr.flush()
            around.Abort(1)
        time.sleep(1e-3)
    told = around.allgather(None if failure is None else (type(failure).__name__, str(failure)))
    within.Free()
    around.Free()
    if failure is not None:
        raise failure
    for rank, other in enumerate(told):
        if other is not None:
            kind, text = other
            raise getattr(errors, kind, RuntimeError)(f"process {rank}: {text}")
