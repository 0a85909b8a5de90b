# SPDX-License-Identifier: BSD-3-Clause
"""Job arrays of a sweep: their folders, from which their tasks read their runs and by which they are found again."""

from __future__ import annotations

import base64
import contextlib
import json
import re
import secrets
import shutil
import sys
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from brinell import _core
from brinell.errors import InputError, IoError
from brinell.sweeps import slurm
from brinell.sweeps.journal import journal_folder
from brinell.sweeps.point import Task
from brinell.sweeps.slurm import Slurm

__all__ = ["Array", "array_script", "arrays_of", "chunks_of", "read_tasks", "refuse_running", "submit"]

_MOST_TASKS = 200
"""Number of tasks of an array if the user gives no chunk: enough for a cluster, few enough for its scheduler."""
_RECORD = "submission.json"


@dataclass(frozen=True)
class Array:
    """A job array that has been submitted."""

    folder: Path
    """slurm/0001 in the folder of the sweep."""
    job: str
    """Number of the job."""
    chunks: list[list[int]]
    """Indices of the runs of each task."""

    def log(self, number: int) -> str:
        """Last line that a task has printed; empty if there is none."""
        try:
            lines = (self.folder / f"{number}.log").read_text("utf-8", errors="replace").split("\n")
        except OSError:
            return ""
        return next((line.strip() for line in reversed(lines) if line.strip()), "")

    def close(self, *, is_complete: bool) -> None:
        """Ends the bookkeeping: no task of the array computes any more. Logs of an incomplete one are kept."""
        if is_complete:
            shutil.rmtree(self.folder, ignore_errors=True)
            with contextlib.suppress(OSError):  # others are there
                self.folder.parent.rmdir()
        else:
            (self.folder / _RECORD).unlink(missing_ok=True)


def chunks_of(tasks: Sequence[Task], wanted: Slurm, largest: int) -> list[list[Task]]:
    """Runs of each task of an array, which has no more tasks than the cluster allows."""
    size = wanted.chunk or -(-len(tasks) // min(_MOST_TASKS, largest))
    size = max(size, -(-len(tasks) // largest))
    return [list(tasks[i : i + size]) for i in range(0, len(tasks), size)]


def array_script(path: Path, wanted: Slurm, tasks: int, *, number: int | None = None, token: str = "") -> str:
    """Script of the next array of the sweep in `path`."""
    folder = _folder(path, number or _next_number(path))
    label = re.sub(r"[^\w.+-]", "_", path.name)[:40]
    name = f"brinell-{label}-{token}" if token else f"brinell-{label}"
    command = [sys.executable, "-m", "brinell.sweeps.task"]
    return slurm.script(wanted, name=name, tasks=tasks, folder=folder, command=command)


def submit(path: Path, wanted: Slurm, chunks: Sequence[Sequence[Task]]) -> Array:
    """Submits runs as a job array.

    Args:
        path: folder of the sweep.
        wanted: how.
        chunks: runs of each task.

    Raises:
        InputError: Slurm refuses the options; nothing is left of the array.
        IoError: a file cannot be written, or Slurm does not answer.
    """
    number, token = _next_number(path), secrets.token_hex(4)
    folder = _folder(path, number)
    text = array_script(path, wanted, len(chunks), number=number, token=token)
    found = re.search(r"--job-name=(\S+)", text)
    record = {
        "name": found[1] if found else "",
        "job": None,
        "chunks": [[task.index for task in one] for one in chunks],
    }
    try:
        folder.mkdir(parents=True)
        for i, chunk in enumerate(chunks):
            (folder / f"{i}.json").write_text(json.dumps(_record_of(chunk, token, i)), "utf-8")
        (folder / "array.sh").write_text(text, "utf-8")
        # A process that is killed before it knows the number of the job finds it again by the name.
        _write_record(folder, record)
        try:
            job = slurm.submitted(text)
        except (InputError, IoError):
            shutil.rmtree(folder, ignore_errors=True)
            raise
        _write_record(folder, {**record, "job": job})
    except OSError as error:
        if isinstance(error, IoError):
            raise
        raise IoError(f"{folder}: cannot be written: {error.strerror}") from error
    return Array(folder, job, [list(map(int, one)) for one in record["chunks"] or []])


def arrays_of(path: Path) -> list[Array]:
    """Arrays of the sweep in `path` whose end has not been seen yet.

    Raises:
        IoError: the process that submitted one was killed in the midst, and Slurm does not answer whether it did.
    """
    found = []
    for folder in sorted((path / "slurm").glob("[0-9]*")):
        try:
            record = json.loads((folder / _RECORD).read_text("utf-8"))
        except (OSError, ValueError):
            continue  # seen, or not yet submitted
        job = record["job"] or slurm.job_named(record["name"])
        if job is None:
            shutil.rmtree(folder, ignore_errors=True)
        else:
            found.append(Array(folder, str(job), record["chunks"]))
    return found


def refuse_running(path: Path) -> None:
    """Refuses to compute runs that an array is computing.

    Raises:
        IoError: an array of the sweep may be running.
    """
    for array in arrays_of(path):
        try:
            states = slurm.task_states(array.job)
        except IoError:
            states = None
        if states is None:
            raise IoError(
                f"{path}: job {array.job} of Slurm may compute there, and Slurm does not answer; if it has ended, "
                f"remove {array.folder}"
            )
        if not all(state.has_ended for state in states.values()):
            raise IoError(
                f"{path}: job {array.job} of Slurm computes there; --submit slurm collects what it does, "
                f"'scancel {array.job}' ends it"
            )
        array.close(is_complete=False)


def read_tasks(folder: Path, number: int) -> tuple[list[Task], Path]:
    """Runs of a task of an array, and its journal.

    Args:
        folder: folder of the array.
        number: number of the task.

    Raises:
        IoError: the file cannot be read.
        InputError: this is another version of brinell.
    """
    file = folder / f"{number}.json"
    try:
        record = json.loads(file.read_text("utf-8"))
    except (OSError, ValueError) as error:
        raise IoError(f"{file}: cannot be read: {error}") from error
    here = _core.library_versions()["brinell"]
    if record["version"] != here:
        raise InputError(f"this machine has brinell {here}, but the sweep was submitted with {record['version']}")
    path = folder.parent.parent
    numbers = tuple(base64.b64decode(one["pickle"]) if isinstance(one, Mapping) else one for one in record["numbers"])
    tasks = [Task(numbers=() if entry["keep"] else numbers, **entry) for entry in record["runs"]]
    return tasks, journal_folder(path) / record["journal"]


def _record_of(chunk: Sequence[Task], token: str, number: int) -> dict[str, Any]:
    numbers = next((one.numbers for one in chunk if one.numbers), ())  # those with a folder have none
    return {
        "version": _core.library_versions()["brinell"],
        "journal": f"slurm-{token}-{number:05d}.jsonl",
        "numbers": [one if isinstance(one, str) else {"pickle": base64.b64encode(one).decode()} for one in numbers],
        "runs": [
            {"index": one.index, "text": one.text, "folder": one.folder, "threads": one.threads, "keep": one.keep}
            for one in chunk
        ],
    }


def _folder(path: Path, number: int) -> Path:
    return path / "slurm" / f"{number:04d}"


def _next_number(path: Path) -> int:
    return max((int(one.name) for one in (path / "slurm").glob("[0-9]*") if one.name.isdecimal()), default=0) + 1


def _write_record(folder: Path, record: Mapping[str, Any]) -> None:
    part = folder / f"{_RECORD}.part"
    part.write_text(json.dumps(record), "utf-8")
    part.replace(folder / _RECORD)
