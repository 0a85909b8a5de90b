# SPDX-License-Identifier: BSD-3-Clause
"""Runs, sweeps and fits of the page: one at a time, each a process of its own that writes as the commands do."""

from __future__ import annotations

import asyncio
import json
import os
import signal
import sys
import time
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, Literal

from brinell.app.folder import Folder
from brinell.errors import InputError

__all__ = ["Job", "Jobs", "writers_of"]

State = Literal["waiting", "running", "finished", "stopped", "failed"]

_MOST_WAITING = 50


@dataclass
class Job:
    """A run, a sweep or a fit of this server."""

    name: str
    """Its folder."""
    task: Mapping[str, Any]
    state: State = "waiting"
    done: int = 0
    of: int = 0
    place: str = ""
    error: str = ""
    ending: State = "failed"
    """State once its process has ended."""
    seconds: float = 0.0
    """That it took."""
    process: asyncio.subprocess.Process | None = field(default=None, repr=False)

    def as_json(self) -> dict[str, Any]:
        """For the page."""
        return {name: getattr(self, name) for name in ("name", "state", "done", "of", "place", "error", "seconds")}


def writers_of(folders: Iterable[Path]) -> dict[Path, int]:
    """Processes of brinell that write results into some folders, of whichever server or command.

    A run holds its folder open, and locked. Trying the lock could be in the way of a run that just begins; what
    processes hold open is looked at instead. Systems without /proc tell none.
    """
    wanted = {str(one.resolve()): one for one in folders}
    found: dict[Path, int] = {}
    for process in Path("/proc").glob("[0-9]*"):
        try:
            words = (process / "cmdline").read_bytes().split(b"\0")
            if not any(word.rpartition(b"/")[2] == b"brinell" or word.startswith(b"brinell.") for word in words):
                continue
            held = {os.readlink(one.path) for one in os.scandir(process / "fd")}
        except OSError:  # it has ended, or is not ours
            continue
        for path in held & set(wanted):
            found[wanted[path]] = int(process.name)
    return found


class Jobs:
    """The runs of this server, in the order in which they were begun."""

    def __init__(self, folder: Folder):
        """Begins without any.

        Args:
            folder: where their results go.
        """
        self._folder = folder
        self._jobs: dict[str, Job] = {}
        self._turn = asyncio.Semaphore(1)
        self._tasks: set[asyncio.Task[None]] = set()

    def begin(self, name: str, task: Mapping[str, Any]) -> Job:
        """Begins a run, once those before it have ended.

        Args:
            name: name of its folder.
            task: what `brinell.app.runner` reads.

        Raises:
            InputError: too many runs are waiting, or this one is still running.
        """
        if sum(job.state in ("waiting", "running") for job in self._jobs.values()) >= _MOST_WAITING:
            raise InputError(f"{_MOST_WAITING} runs are waiting already")
        earlier = self._jobs.get(name)
        if earlier is not None and earlier.state in ("waiting", "running"):
            raise InputError(f"{name} is still running")
        self._jobs.pop(name, None)
        job = self._jobs[name] = Job(name, {**task, "output": str(self._folder.inside(name))})
        following = asyncio.create_task(self._follow(job))
        self._tasks.add(following)
        following.add_done_callback(self._tasks.discard)
        return job

    async def _follow(self, job: Job) -> None:
        async with self._turn:
            if job.state != "waiting":
                return
            job.process = await asyncio.create_subprocess_exec(
                sys.executable,
                "-m",
                "brinell.app.runner",
                stdin=asyncio.subprocess.PIPE,
                stdout=asyncio.subprocess.PIPE,
                stderr=asyncio.subprocess.DEVNULL,
                start_new_session=True,  # Ctrl-C in the terminal of the server is for the server
            )
            job.state, begun = "running", time.monotonic()
            assert job.process.stdin is not None
            assert job.process.stdout is not None
            job.process.stdin.write(json.dumps(job.task).encode())
            job.process.stdin.close()
            async for line in job.process.stdout:
                self._hear(job, line)
            code = await job.process.wait()
            job.seconds = time.monotonic() - begun
            if job.ending == "failed":
                job.error = job.error or f"the process has ended with {code}"
            job.state = job.ending

    def _hear(self, job: Job, line: bytes) -> None:
        try:
            message = json.loads(line)
        except ValueError:
            return
        if "done" in message:
            job.done, job.of, job.place = message["done"], message["of"], message["place"]
        elif "error" in message:
            job.error = message["error"].replace("; choose another folder with -o", "")
        elif "stopped" in message:
            job.ending = "stopped"
        elif "finished" in message:
            job.ending = "finished"
            job.done = job.of = max(job.done, job.of)

    def get(self, name: str) -> Job | None:
        """The job of a folder, if this server has begun it."""
        return self._jobs.get(name)

    def all(self) -> list[Job]:
        """The jobs, that begun last first."""
        return list(reversed(self._jobs.values()))

    def stop(self, name: str) -> Job:
        """Stops a run after its current step; one that waits does not begin.

        Raises:
            InputError: there is no such run.
        """
        job = self._jobs.get(name)
        if job is None or job.state not in ("waiting", "running"):
            raise InputError(f"{name[:200]!r} is not running")
        if job.process is None:
            job.state = "stopped"
        elif job.process.returncode is None:
            os.kill(job.process.pid, signal.SIGINT)
        return job

    async def close(self) -> None:
        """Stops all, so that their finished steps can be read and resumed."""
        for job in self._jobs.values():
            if job.state in ("waiting", "running"):
                self.stop(job.name)
        if self._tasks:
            await asyncio.wait(self._tasks, timeout=10.0)
