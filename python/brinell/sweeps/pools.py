# SPDX-License-Identifier: BSD-3-Clause
"""Pools that compute the runs: processes of this machine, or workers of a Dask cluster.

Both take a `Task`, return a future of concurrent.futures, and convert a finished future to an `Outcome`.
"""

from __future__ import annotations

import _thread
import contextlib
import multiprocessing
import os
import signal
import sys
import threading
from collections.abc import Iterator
from concurrent.futures import CancelledError, Future, ProcessPoolExecutor
from concurrent.futures.process import BrokenProcessPool
from multiprocessing.connection import Connection
from pathlib import Path
from typing import Any, Protocol

from brinell.errors import BrinellError, IoError, MissingExtraError
from brinell.sweeps.point import ONE_AT_A_TIME, Outcome, Task, compute, stopped

__all__ = ["DaskPool", "LocalPool", "Lost", "Pool"]


class Lost(Exception):  # noqa: N818 (the driver mends it)
    """The process of a run died; the run may be submitted again."""


class Pool(Protocol):
    """Interface of the pools for the driver."""

    threads: int
    """Number of threads of each run; 0: as the worker decides."""

    @property
    def has_room(self) -> bool:
        """Whether another task may be submitted now."""

    def submit(self, task: Task) -> Future[Outcome]:
        """Starts a task."""

    def collect(self, future: Future[Outcome]) -> Outcome:
        """Outcome of a finished task.

        Raises:
            Lost: the process of the task died.
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
        self._executors: dict[Future[Outcome], ProcessPoolExecutor] = {}
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

    def submit(self, task: Task) -> Future[Outcome]:
        """Gives the task to an idle process."""
        executor = self._idle.pop() or self._executor()
        with _ctrl_c_held():
            future = executor.submit(_compute_here, task)
            self._executors[future] = executor
        return future

    def collect(self, future: Future[Outcome]) -> Outcome:
        """Outcome of a finished task; its process becomes idle, or is replaced if it has died.

        Raises:
            Lost: the process died.
        """
        executor = self._executors.pop(future)
        try:
            outcome = future.result()
        except BrokenProcessPool as error:
            executor.shutdown()
            self._all.remove(executor)
            self._idle.append(None)
            self._losses.append("a process came to a sudden end; its run is computed again by another one")
            raise Lost from error
        self._idle.append(executor)
        return outcome

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


def _begin(teller: Connection) -> None:
    signal.signal(signal.SIGINT, signal.SIG_IGN)  # outside of a run
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


def _compute_here(task: Task) -> Outcome:
    try:
        signal.signal(signal.SIGINT, signal.default_int_handler)
        return compute(task, _STOP.is_set)
    except KeyboardInterrupt:
        return stopped(task)
    finally:
        signal.signal(signal.SIGINT, signal.SIG_IGN)


class DaskPool:
    """Workers of a Dask cluster; the folder of the sweep must have the same path on all of them."""

    def __init__(self, cluster: Any, stop_file: Path, threads: int):
        """Connects to the cluster.

        Args:
            cluster: address of a scheduler, path of a scheduler file, or a cluster or client object of Dask.
            stop_file: file in the sweep's folder; runs stop while it exists.
            threads: number of threads of each run; 0: as many as its worker has.

        Raises:
            IoError: the cluster does not answer.
        """
        try:
            from distributed import Client
        except ModuleNotFoundError as error:
            raise MissingExtraError("a cluster", "distributed", "sweep") from error
        self.threads = threads
        self._stop_file = stop_file
        stop_file.unlink(missing_ok=True)
        self._is_mine = not isinstance(cluster, Client)
        try:
            if not self._is_mine:
                self._client = cluster
            elif isinstance(cluster, str) and Path(cluster).is_file():
                self._client = Client(scheduler_file=cluster)
            else:
                self._client = Client(cluster)
        except (OSError, TimeoutError, ValueError) as error:
            raise IoError(f"the Dask cluster {cluster!r} does not answer: {error}") from error
        self._executor = self._client.get_executor(pure=False)
        self._tasks: dict[Future[Outcome], Task] = {}
        self._workers = self._addresses()

    @property
    def has_room(self) -> bool:
        """Always true: the scheduler queues tasks, and an adaptive cluster grows with them."""
        return True

    def submit(self, task: Task) -> Future[Outcome]:
        """Gives the task to the scheduler, which repeats it on another worker if its own is lost."""
        future: Future[Outcome] = self._executor.submit(_compute_on_cluster, task, str(self._stop_file))
        self._tasks[future] = task
        return future

    def collect(self, future: Future[Outcome]) -> Outcome:
        """Outcome of a finished task; a task during which several workers died has failed."""
        from distributed import KilledWorker

        task = self._tasks.pop(future)
        try:
            return future.result()
        except KilledWorker as error:
            return Outcome(task.index, "failed", reason=f"its worker was lost again and again: {error}")
        except CancelledError as error:
            raise IoError("the Dask cluster is lost; the same sweep goes on with what is missing") from error
        except Exception as error:  # not an error of the run, which would be in its outcome
            raise BrinellError(f"a worker of the cluster cannot compute; has it the same brinell? {error}") from error

    def losses(self) -> list[str]:
        """Messages about workers that have left the cluster: killed, out of memory, or retired by the scheduler."""
        before, self._workers = self._workers, self._addresses()
        return [f"the worker {one} has left; its run goes to another one" for one in sorted(before - self._workers)]

    def _addresses(self) -> set[str]:
        return set(self._client.scheduler_info(n_workers=-1)["workers"])

    def stop(self) -> None:
        """Requests all runs to stop after their current step; runs that have not started return at once."""
        self._stop_file.touch()

    def close(self) -> None:
        """Disconnects from the cluster; after an error the remaining runs are stopped."""
        if self._tasks:
            self.stop()
            self._executor.shutdown(wait=False)
        else:
            self._stop_file.unlink(missing_ok=True)
        if self._is_mine:
            self._client.close()


def _compute_on_cluster(task: Task, stop_file: str) -> Outcome:
    from distributed import get_worker

    threads = task.threads or get_worker().state.nthreads
    return compute(Task(task.index, task.text, task.folder, threads), Path(stop_file).exists)
