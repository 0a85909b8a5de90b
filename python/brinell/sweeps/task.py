# SPDX-License-Identifier: BSD-3-Clause
"""A task of a job array, on a node of a cluster: ``python -m brinell.sweeps.task FOLDER NUMBER``.

It computes the runs of its chunk that its journal does not have yet, in as many processes as it has cores. A process
that dies is replaced. Exit code 0: each run has an outcome, if only that it has failed; 72, 74, 78: the folder is not
there, cannot be written, is of another version of brinell; 130: stopped.
"""

from __future__ import annotations

import contextlib
import os
import signal
import sys
from pathlib import Path

from brinell.errors import BrinellError, InputError, IoError
from brinell.sweeps.arrays import read_tasks
from brinell.sweeps.journal import Journal, JournalReader
from brinell.sweeps.loop import compute_all
from brinell.sweeps.point import Task
from brinell.sweeps.pools import LocalPool

__all__ = ["EXIT_CODES", "main"]

EXIT_CODES = {
    72: "the folder of the sweep is not there on its node: is it shared under the same path?",
    74: "the folder of the sweep cannot be read or written on its node: is the disk full?",
    78: "its node has another version of brinell",
    126: "Python cannot be started on its node",
    127: "Python is not there on its node",
}
"""Reasons with which a task ends that another attempt would not change."""


def main(folder: Path, number: int) -> int:
    """Computes the task; returns its exit code."""
    signal.signal(signal.SIGTERM, signal.default_int_handler)
    try:
        tasks, file = read_tasks(folder, number)
        done = {entry["index"] for entry in JournalReader(file.parent).entries_of(file) if "index" in entry}
        missing = [task for task in tasks if task.index not in done]
        if missing:
            _compute(missing, Journal(file))
    except KeyboardInterrupt:
        _say("stopped")
        return 130
    except InputError as error:
        _say(str(error))
        return 78
    except (IoError, OSError) as error:
        _say(str(error))
        return 74 if folder.is_dir() else 72
    except BrinellError as error:
        _say(str(error))
        return 1
    return 0


def _compute(tasks: list[Task], journal: Journal) -> None:
    cores = _cores()
    threads = tasks[0].threads
    workers = min(max(1, cores // (threads or 1)), len(tasks))
    with contextlib.closing(LocalPool(workers, threads or max(1, cores // workers))) as pool:
        each = [Task(one.index, one.text, one.folder, pool.threads, one.keep, one.numbers) for one in tasks]
        compute_all(each, pool, journal, _say)


def _cores() -> int:
    """Number of cores that Slurm gives the task; those that the process may use if Slurm does not say."""
    given = os.environ.get("SLURM_CPUS_PER_TASK") or os.environ.get("SLURM_CPUS_ON_NODE") or ""
    here = len(os.sched_getaffinity(0))
    return min(int(given), here) if given.isdecimal() and int(given) > 0 else here


def _say(message: str) -> None:
    print(f"brinell: {message}", file=sys.stderr, flush=True)


if __name__ == "__main__":
    sys.exit(main(Path(sys.argv[1]), int(sys.argv[2])))
