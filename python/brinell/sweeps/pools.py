# SPDX-License-Identifier: BSD-3-Clause
"""Pools that compute the runs: what they have in common, and processes of this machine.

A pool takes a portion of tasks, returns a future of concurrent.futures, and converts a finished future to outcomes.
"""

from __future__ import annotations

import _thread
import contextlib
import multiprocessing
import os
import signal
import sys
import threading
from collections.abc import Iterator, Sequence
from concurrent.futures import Future, ProcessPoolExecutor
from concurrent.futures.process import BrokenProcessPool
from multiprocessing.connection import Connection
from pathlib import Path
from typing import Protocol

from brinell.errors import BrinellError
from brinell.sweeps.point import ONE_AT_A_TIME, Outcome, Task, compute, stopped

__all__ = ["LocalPool", "Lost", "Pool"]


class Lost(Exception):  # noqa: N818 (the driver mends it)
    """The process of a run died; what has no outcome may be submitted again."""

    def __init__(self, outcomes: Sequence[Outcome] = ()):
        """Of a chunk.

        Args:
            outcomes: outcomes of its runs that had ended before.
        """
        super().__init__()
        self.outcomes = list(outcomes)


class Pool(Protocol):
    """Interface of the pools for the driver."""

    threads: int
    """Number of threads of each run; 0: as the worker decides."""

    @property
    def has_room(self) -> bool:
        """Whether another task may be submitted now."""

    def chunks(self, tasks: Sequence[Task]) -> list[list[Task]]:
        """The tasks in portions that are submitted together."""

    def submit(self, chunk: Sequence[Task]) -> Future[list[Outcome]]:
        """Starts a portion of tasks."""

    def collect(self, future: Future[list[Outcome]]) -> list[Outcome]:
        """Outcomes of a finished portion.

        Raises:
            Lost: the process of a task died.
        """

    def losses(self) -> list[str]:
        """Messages about processes or workers that have died since the last call."""

    def stop(self) -> None:
        """Requests all runs to stop; their outcomes can still be collected."""

    def close(self) -> None:
        """Ends the processes of this machine, or disconnects from the cluster."""


class LocalPool:
    """Processes of this machine, each in an executor of its own so that a killed process affects only one run."""

    def __init__(self, workers: int, threads: int):
        """Starts the first process, to check that processes can be started.

        Args:
            workers: number of processes.
            threads: number of threads of each run.

        Raises:
            BrinellError: no process can be started.
        """
        script = getattr(sys.modules["__main__"], "__file__", None)
        if script is not None and not Path(script).is_file():
            raise BrinellError("a sweep starts processes that import its script: that must be a file, or a notebook")
        self.threads = threads
        self._listener, self._teller = multiprocessing.Pipe(duplex=False)
        self._executors: dict[Future[list[Outcome]], tuple[ProcessPoolExecutor, int]] = {}
        self._idle: list[ProcessPoolExecutor | None] = [None] * (workers - 1)
        self._all: list[ProcessPoolExecutor] = []  # also one that Ctrl-C has taken between idle and busy
        self._losses: list[str] = []
        first = self._executor()
        self._idle.append(first)
        try:
            with _ctrl_c_held():
                ready = first.submit(os.getpid)
            ready.result()
        except BrokenProcessPool as error:
            raise BrinellError(
                "no process for the runs can be started; a script that sweeps needs the line "
                "if __name__ == '__main__': before it, as each process imports the script"
            ) from error

    @property
    def has_room(self) -> bool:
        """Whether a process is idle."""
        return bool(self._idle)

    def chunks(self, tasks: Sequence[Task]) -> list[list[Task]]:
        """Each task alone: a message between two processes of a machine costs nothing."""
        return [[task] for task in tasks]

    def submit(self, chunk: Sequence[Task]) -> Future[list[Outcome]]:
        """Gives the task to an idle process."""
        (task,) = chunk
        executor = self._idle.pop() or self._executor()
        with _ctrl_c_held():
            future = executor.submit(_compute_here, task)
            self._executors[future] = (executor, task.index)
        return future

    def collect(self, future: Future[list[Outcome]]) -> list[Outcome]:
        """Outcome of a finished task; its process becomes idle, or is replaced if it has died.

        Raises:
            Lost: the process died.
        """
        executor, index = self._executors.pop(future)
        try:
            outcomes = future.result()
        except BrokenProcessPool as error:
            executor.shutdown()
            self._all.remove(executor)
            self._idle.append(None)
            self._losses.append(
                f"run {index}: a process came to a sudden end; its run is computed again by another one"
            )
            raise Lost from error
        self._idle.append(executor)
        return outcomes

    def losses(self) -> list[str]:
        """Messages about processes that were killed or ran out of memory, since the last call."""
        losses, self._losses = self._losses, []
        return losses

    def _executor(self) -> ProcessPoolExecutor:
        context = multiprocessing.get_context("spawn")  # a fork would copy the state of OpenMP's threads
        executor = ProcessPoolExecutor(1, mp_context=context, initializer=_begin, initargs=(self._listener,))
        self._all.append(executor)
        return executor

    def stop(self) -> None:
        """Interrupts the runs as Ctrl-C does."""
        self._teller.close()

    def close(self) -> None:
        """Waits for the processes to end."""
        self._teller.close()
        for executor in self._all:
            executor.shutdown(cancel_futures=True)
        self._listener.close()


@contextlib.contextmanager
def _ctrl_c_held() -> Iterator[None]:
    """Blocks Ctrl-C for processes started inside the context; the terminal sends it to all, they stop by the pipe."""
    before = signal.pthread_sigmask(signal.SIG_BLOCK, {signal.SIGINT})
    try:
        yield
    finally:
        signal.pthread_sigmask(signal.SIG_SETMASK, before)


_STOP = threading.Event()
"""Event that is set in a process of a `LocalPool` to stop it."""


_ENDS = (signal.SIGINT, signal.SIGTERM)
"""Signals that stop a run. A batch system sends them to all processes of a job."""


def _begin(teller: Connection) -> None:
    for number in _ENDS:
        signal.signal(number, signal.SIG_IGN)  # outside of a run
    threading.Thread(target=_heed, args=(teller,), daemon=True).start()


def _heed(teller: Connection) -> None:
    """Interrupts the run when the other end of the pipe closes, on request or because the parent process died."""
    with contextlib.suppress(EOFError, OSError):
        teller.recv()
    _STOP.set()
    _thread.interrupt_main()
    parent = multiprocessing.parent_process()
    if parent is not None:
        parent.join()
        with ONE_AT_A_TIME:  # after the checkpoint
            os._exit(1)


def _compute_here(task: Task) -> list[Outcome]:
    try:
        for number in _ENDS:
            signal.signal(number, signal.default_int_handler)
        return [compute(task, _STOP.is_set)]
    except KeyboardInterrupt:
        return [stopped(task)]
    finally:
        for number in _ENDS:
            signal.signal(number, signal.SIG_IGN)
