# SPDX-License-Identifier: BSD-3-Clause
"""Processes that work for the server: they keep the engine loaded, and what goes wrong in them harms nobody else."""

from __future__ import annotations

import asyncio
import contextlib
import importlib
import multiprocessing
import signal
import threading
import warnings
from collections.abc import AsyncIterator, Callable, Iterator
from multiprocessing.connection import Connection
from typing import Any

from brinell.errors import BrinellError, InputError

__all__ = ["Worker", "WorkerLostError"]

Stopped = Callable[[], bool]
Task = Callable[..., Iterator[Any]]


class WorkerLostError(BrinellError):
    """The process has ended, or taken too long and was ended."""


class Worker:
    """A process that does one task after the other. It is begun with the first one, and anew if it was lost."""

    def __init__(self, name: str, *modules: str):
        """Begins nothing yet.

        Args:
            name: name of the process.
            modules: what it imports before its first task, so that this need not wait for it.
        """
        self._name = name
        self._modules = modules
        self._process: Any = None
        self._connection: Connection | None = None
        self._turn = threading.Lock()

    def start(self) -> None:
        """Begins the process, so that the first task need not wait for it."""
        with self._turn:
            self._begun()

    def _begun(self) -> Connection:
        if self._connection is None or not self._process.is_alive():
            spawn = multiprocessing.get_context("spawn")
            ours, theirs = spawn.Pipe()
            self._process = spawn.Process(target=_work, args=(theirs, self._modules), name=self._name, daemon=True)
            self._process.start()
            theirs.close()
            self._connection = ours
        return self._connection

    async def call(self, task: Task, *arguments: Any, timeout: float = 60.0) -> Any:
        """The only, or last, thing that a task yields.

        Raises:
            BrinellError: what the task has raised; WorkerLostError if its process has ended or it took too long.
        """
        result = None
        async for thing in self.stream(task, *arguments, timeout=timeout):
            result = thing
        return result

    async def stream(self, task: Task, *arguments: Any, timeout: float = 60.0) -> AsyncIterator[Any]:
        """What a task yields, one after the other. The task is stopped when nobody listens any more.

        Args:
            task: function of a module; it gets a function that tells whether it is to stop, and the arguments.
            arguments: what can be pickled.
            timeout: most seconds between two things.

        Raises:
            BrinellError: what the task has raised; WorkerLostError if its process has ended or it took too long.
        """
        stop = threading.Event()
        loop = asyncio.get_running_loop()
        queue: asyncio.Queue[tuple[str, Any]] = asyncio.Queue()

        def put(kind: str, value: Any) -> None:
            with contextlib.suppress(RuntimeError):  # the loop is closed when the server ends
                loop.call_soon_threadsafe(queue.put_nowait, (kind, value))

        thread = threading.Thread(target=self._attend, args=(task, arguments, timeout, stop, put), daemon=True)
        thread.start()
        try:
            while True:
                kind, value = await queue.get()
                if kind == "end":
                    return
                if kind == "error":
                    raise value
                yield value
        finally:
            stop.set()

    def _attend(
        self,
        task: Task,
        arguments: tuple[Any, ...],
        timeout: float,
        stop: threading.Event,
        put: Callable[[str, Any], None],
    ) -> None:
        """Hands on what the process sends, in a thread of the server."""
        with self._turn:
            if stop.is_set():
                put("end", None)
                return
            try:
                connection = self._begun()
                connection.send((task, arguments))
                waited, told = 0.0, False
                while True:
                    if stop.is_set() and not told:
                        connection.send("stop")
                        told = True
                    if not connection.poll(0.02):
                        waited += 0.02
                        if waited > timeout:
                            self._end()
                            put("error", WorkerLostError(f"this took longer than {timeout:g} s and was ended"))
                            return
                        continue
                    kind, value = connection.recv()
                    waited = 0.0
                    put(kind, value)
                    if kind in ("end", "error"):
                        return
            except (EOFError, OSError):
                self._end()
                put("error", WorkerLostError("the process that computed this has ended, perhaps for want of memory"))

    def _end(self) -> None:
        if self._process is not None:
            self._process.kill()
            self._process.join(5.0)
        if self._connection is not None:
            self._connection.close()
        self._connection = None

    def close(self) -> None:
        """Ends the process."""
        self._end()


def _work(connection: Connection, modules: tuple[str, ...]) -> None:
    """Does the tasks of the process, until the server is gone."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)  # Ctrl-C in the terminal is for the server
    for module in modules:
        importlib.import_module(module)

    def is_to_stop() -> bool:
        if connection.poll():
            connection.recv()
            return True
        return False

    while True:
        try:
            request = connection.recv()
        except (EOFError, OSError):
            return
        if request == "stop":  # it came when the task had ended
            continue
        task, arguments = request
        try:
            with warnings.catch_warnings():
                warnings.simplefilter("ignore")
                for thing in task(is_to_stop, *arguments):
                    connection.send(("thing", thing))
            connection.send(("end", None))
        except BrinellError as error:
            connection.send(("error", type(error)(str(error)) if _is_plain(error) else InputError(str(error))))
        except (BrokenPipeError, EOFError):
            return
        except Exception as error:
            connection.send(("error", InputError(f"{type(error).__name__}: {error}")))


def _is_plain(error: BrinellError) -> bool:
    """Whether an error is made of its text alone."""
    try:
        type(error)(str(error))
    except TypeError:
        return False
    return True
