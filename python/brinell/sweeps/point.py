# SPDX-License-Identifier: BSD-3-Clause
"""One run of a sweep in a worker: the module can be imported anywhere, and outcomes are only text and numbers."""

from __future__ import annotations

import threading
import time
import traceback
import warnings
from collections.abc import Callable, Collection, Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import TYPE_CHECKING, Any, Literal

from brinell._toml import tomllib
from brinell.errors import BrinellError, GridError, InputError, IoError

# Cases and results are imported where a run is computed: a process that only tells others what to do starts without
# them in a fifth of the time, and a job array starts one for each of its tasks.
if TYPE_CHECKING:
    from brinell.case import Case

__all__ = ["HARMLESS", "ONE_AT_A_TIME", "Outcome", "Task", "compute", "finished_summary", "stopped"]

HARMLESS = ("grid.extent",)
"""Keys of a case that do not affect the result: they set the initial extent of grids, which grow as needed."""
ONE_AT_A_TIME = threading.RLock()
"""Lock by which a process computes one case at a time: a Dask worker may call from several threads. The same thread may
take it again."""


@dataclass(frozen=True)
class Task:
    """Description of a run for a worker."""

    index: int
    text: str
    """The case with all defaults filled in, as TOML; it refers to no other file."""
    folder: str
    """Folder of the run."""
    threads: int
    """Number of threads; 0: as the worker decides."""
    keep: bool = True
    """Whether the run writes its folder; otherwise it is computed in memory."""
    numbers: tuple[str | bytes, ...] = ()
    """Functions of the run that are called while it is in memory, as `numbers.packed` returns them."""


@dataclass(frozen=True)
class Outcome:
    """Outcome of a run, as a worker reports it."""

    index: int
    status: Literal["done", "failed", "stopped"]
    wall_time: float = 0.0
    """Time spent by this worker [s]; less than the time of the whole run if the run was resumed."""
    reason: str = ""
    traceback: str = ""
    summary: dict[str, Any] = field(default_factory=dict)
    numbers: dict[str, dict[str, Any]] = field(default_factory=dict)
    """Numbers of a run in memory by the names of the functions that return them."""


class _StopRequest(Exception):  # noqa: N818 (no error)
    """Raised between two steps to stop a run."""


def compute(task: Task, wants_stop: Callable[[], bool]) -> Outcome:
    """Computes one run, resumes it from its checkpoint, or returns its results if it is complete.

    Args:
        task: description of the run.
        wants_stop: function that is called before the run and after each step; True stops the run.

    Returns:
        The outcome; errors are reported in it and not raised.
    """
    with ONE_AT_A_TIME:
        start = time.perf_counter()
        try:
            if wants_stop():
                return stopped(task)
            if not task.keep:
                summary, numbers = _run_in_memory(task, wants_stop)
                return Outcome(task.index, "done", time.perf_counter() - start, summary=summary, numbers=numbers)
            found = finished_summary(task.folder, task.text)
            if found is None:
                _run(task, wants_stop)
                found = finished_summary(task.folder, task.text)
            if found is None:
                raise IoError(f"{task.folder}: the results that were written there cannot be read")
            return Outcome(task.index, "done", time.perf_counter() - start, summary=found)
        except (KeyboardInterrupt, _StopRequest):
            return stopped(task)
        except Exception as error:
            reason = str(error) if isinstance(error, BrinellError) else f"{type(error).__name__}: {error}"
            return Outcome(task.index, "failed", time.perf_counter() - start, reason, traceback.format_exc())


def stopped(task: Task) -> Outcome:
    """Outcome of a run that was stopped on request; its finished steps are kept in its folder."""
    return Outcome(task.index, "stopped")


def finished_summary(folder: str | Path, text: str, other: Collection[str] = ()) -> dict[str, Any] | None:
    """Summary of a complete run of exactly this case; None if there is none.

    Args:
        folder: folder of the run.
        text: text of the case with all defaults filled in.
        other: dotted keys in which the run may differ from the case.
    """
    from brinell.results import RunError, open_run

    try:
        summary = open_run(folder).summary
    except (RunError, OSError):
        return None
    if summary is None:
        return None
    ignored = {*other, *HARMLESS}
    return summary if _without(summary.get("case", {}), ignored) == _without(tomllib.loads(text), ignored) else None


def _without(case: Mapping[str, Any], keys: Collection[str]) -> dict[str, Any]:
    return {
        name: {key: value for key, value in entry.items() if f"{name}.{key}" not in keys}
        if isinstance(entry, Mapping)
        else entry
        for name, entry in {"grid": {}, "solver": {}, **case}.items()
    }


def _run(task: Task, wants_stop: Callable[[], bool]) -> None:
    from brinell.case import ResolutionWarning

    began = False

    def on_step(*_: object) -> None:
        nonlocal began
        began = True
        if wants_stop():
            raise _StopRequest

    with warnings.catch_warnings():
        warnings.simplefilter("ignore", ResolutionWarning)  # stored in the summary of each run
        _compute(_case(task), task, on_step, lambda: began)


def _run_in_memory(task: Task, wants_stop: Callable[[], bool]) -> tuple[dict[str, Any], dict[str, dict[str, Any]]]:
    """Summary of the run and numbers of it; nothing else is kept."""
    from brinell.case import ResolutionWarning

    def on_step(*_: object) -> None:
        if wants_stop():
            raise _StopRequest

    with warnings.catch_warnings():
        warnings.simplefilter("ignore", ResolutionWarning)  # stored in the summary of each run
        run = _case(task).run(in_memory=True, progress=on_step, threads=task.threads or None)
    if not task.numbers:
        return dict(run.summary or {}), {}
    from brinell.sweeps.numbers import numbers_of  # only where they are asked for

    return dict(run.summary or {}), numbers_of(run, task.numbers, task.index)


def _case(task: Task) -> Case:
    from brinell.case import Case, CaseWarning

    with warnings.catch_warnings():
        warnings.simplefilter("ignore", CaseWarning)  # issued once, before the first run
        return Case(task.text, file=Path(task.folder) / "case.toml")


def _compute(case: Case, task: Task, on_step: Callable[..., None], began: Callable[[], bool]) -> None:
    """Resumes the run in its folder if possible, otherwise computes it from the start."""
    if Path(task.folder).exists():
        try:
            case.run(task.folder, progress=on_step, threads=task.threads or None, resume=True)
            return
        except GridError:
            raise
        except (InputError, IoError):
            if began():
                raise
            # The run cannot be resumed: no checkpoint, another case, another build, or a damaged file.
    case.run(task.folder, progress=on_step, threads=task.threads or None, replace=True)
