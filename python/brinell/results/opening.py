# SPDX-License-Identifier: BSD-3-Clause
"""Opening of results, with the checks before anything is read."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import numpy as np

from brinell.results.errors import FORMAT_VERSION, RunError, other_version
from brinell.results.history import History, read_history
from brinell.results.result_file import MemoryFile, ResultFile
from brinell.results.run import Run
from brinell.scenarios import Scenario
from brinell.summary import summary_place, unfinished

__all__ = ["kept_results", "open_run", "run_of_image"]


def open_run(path: str | Path, *, allow_unfinished: bool = False) -> Run:
    """Opens a result. History and summary are read at once, fields only when they are used.

    Args:
        path: folder of a result of `brinell run -o`, or its file result.vtkhdf alone.
        allow_unfinished: also accept a run that is still running or was stopped; its summary is then None. The file
            alone then has the history only up to the last stored step.

    Raises:
        RunError: the folder or file does not exist, is incomplete or damaged, or the run has not finished.
    """
    path = Path(path)
    if not path.exists():
        raise RunError(f"{path}: no such {'file' if path.suffix == '.vtkhdf' else 'folder'}")
    history, summary = _file_content(path) if path.is_file() else _folder_content(path)
    if summary is None:
        if not allow_unfinished:
            raise unfinished(path, history.steps)
        return Run(path, history, None)
    run = Run(path, history, _of_scenario(summary, path, history.scenario))
    _require_all_steps(run)
    return run


def kept_results(folder: Path) -> str:
    """Message about the results that a stopped run has left, and how to resume it; empty if there are none.

    Args:
        folder: folder of the run, or of the whole series of runs for an accuracy.
    """
    how_to_resume = "the same call with resume = True goes on"
    if (folder / "accuracy").is_dir():
        return f"the runs for the accuracy so far are kept in {folder}: {how_to_resume}"
    try:
        steps = open_run(folder, allow_unfinished=True).history.steps
    except RunError:
        return ""
    if steps == 0:
        return ""
    which = "the first step is" if steps == 1 else f"the first {steps} steps are"
    return f"{which} kept in {folder}: {how_to_resume}, brinell.open with allow_unfinished = True reads them"


def run_of_image(image: bytes) -> Run:
    """Result of a run in memory, from the bytes of its result file."""
    memory = MemoryFile(image)
    with ResultFile(memory) as file:
        history, summary = file.history(), file.text("summary")
    path = Path("memory")
    return Run(path, history, _of_scenario(_parsed(summary or "", path), path, history.scenario), memory)


def _require_all_steps(run: Run) -> None:
    """Raises RunError if rows are missing in the history of a complete run."""
    steps = run._number("run", "steps")
    if not np.array_equal(run.history["step"], np.arange(steps)):
        folder = run.path.is_dir()
        raise RunError(
            f"{run.path / 'history.csv' if folder else f'{run.path}: /history'}: has {run.history.steps} rows, the run "
            f"had {steps:.0f} steps, one row each: it was cut or altered"
            + (f"; {run.file} by itself may hold the history still" if folder else "")
        )


def _file_content(path: Path) -> tuple[History, dict[str, Any] | None]:
    with ResultFile(path) as file:
        history, text = file.history(), file.text("summary")
    return history, None if text is None else _parsed(text, path)


def _folder_content(path: Path) -> tuple[History, dict[str, Any] | None]:
    if (path / "sweep.json").is_file():
        raise RunError(f"{path}: is a sweep; name a run in its folder runs/, or take brinell.sweeps.open_sweep")
    file = path / "summary.json"
    if not file.is_file():
        return read_history(path), None
    try:
        text = file.read_text(encoding="utf-8")
    except (OSError, UnicodeDecodeError) as error:
        raise RunError(f"{file}: cannot be read ({error})") from error
    summary = _parsed(text, path)  # first, because history.csv has no format version and may have other columns
    return read_history(path), summary


def _parsed(text: str, path: Path) -> dict[str, Any]:
    place = summary_place(path)
    try:
        summary = json.loads(text)
    except json.JSONDecodeError as error:
        raise RunError(f"{place}:{error.lineno}: not valid JSON ({error.msg})") from error
    except RecursionError as error:
        raise RunError(f"{place}: not a summary of brinell") from error
    if not isinstance(summary, dict) or summary.get("format") != "brinell-summary":
        raise RunError(f"{place}: not a summary of brinell")
    version = summary.get("format_version")
    if version != FORMAT_VERSION:
        raise other_version(place, version)
    return summary


def _of_scenario(summary: dict[str, Any], path: Path, scenario: Scenario) -> dict[str, Any]:
    """The summary, if it is of the scenario of the history."""
    found = summary.get("scenario")
    if found != scenario:
        raise RunError(f"{summary_place(path)}: is of scenario {found!r}, but the history of {scenario!r}")
    return summary
