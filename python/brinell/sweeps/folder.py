# SPDX-License-Identifier: BSD-3-Clause
"""The folder of a sweep: its definition (sweep.json), one folder per run, the table, and the reasons of failures.

All files are replaced atomically, so that they can be read at any time.
"""

from __future__ import annotations

import contextlib
import fcntl
import json
import os
import time
from collections.abc import Callable, Collection, Iterator, Mapping
from pathlib import Path
from typing import Any

import pandas as pd

from brinell._toml import tomllib
from brinell.errors import InputError, IoError
from brinell.sweeps.designs import Point
from brinell.sweeps.lists import entry_of
from brinell.sweeps.point import HARMLESS, Outcome, finished_summary

__all__ = [
    "FORMAT_VERSION",
    "Ledger",
    "flattened",
    "locked",
    "read_record",
    "run_folder",
    "start_folder",
    "without_formulas",
    "write_table",
]

FORMAT_VERSION = 1
_FILES = ("table.csv", "table.parquet", "failures.json")
"""Files that a sweep writes after sweep.json."""
_NOT_RESULTS = ("format", "format_version", "case", "complete", "scenario", "title", "versions")
"""Entries of a summary that are not results of the run."""
_WRITING_SHARE = 0.05
"""Fraction of the time that may be spent on updating the table."""


@contextlib.contextmanager
def locked(path: Path) -> Iterator[None]:
    """Makes the folder and locks it for this process.

    Raises:
        IoError: the folder cannot be made, or another sweep is using it.
    """
    try:
        path.mkdir(parents=True, exist_ok=True)
        descriptor = os.open(path, os.O_RDONLY | os.O_DIRECTORY)
    except OSError as error:
        raise IoError(f"{path}: the folder of the sweep cannot be made: {error.strerror}") from error
    try:
        try:
            fcntl.flock(descriptor, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except BlockingIOError as error:
            raise IoError(f"{path}: another sweep is working there") from error
        except OSError:
            pass  # not every file system has locks
        yield
    finally:
        os.close(descriptor)


def run_folder(path: Path, index: int) -> Path:
    """Folder of one run of the sweep in `path`."""
    return path / "runs" / f"{index:06d}"


def start_folder(path: Path, record: Mapping[str, Any], *, resume: bool, retry_failed: bool = False) -> set[str]:
    """Writes the definition of a sweep, or compares it with the one in the folder.

    Args:
        path: folder of the sweep.
        record: definition of the sweep.
        resume: whether the folder may hold the same sweep.
        retry_failed: whether grid and solver may differ from before; finished runs are kept.

    Returns:
        Dotted keys of grid and solver in which runs of the folder differ from each other.

    Raises:
        InputError: the folder holds another sweep (the text says what differs), or any sweep if `resume` is False.
    """
    earlier = read_record(path)
    if earlier is None:
        foreign = [name for name in _FILES if (path / name).exists()]
        if foreign:
            raise InputError(
                f"{path}: holds other files: {', '.join(foreign)}. A sweep writes files of these names, but none has "
                "written these: move them away, or choose another folder"
            )
        _write_record(path, record)
        return set()
    if not resume:
        raise InputError(f"{path}: holds a sweep; choose another folder, or go on with that one (resume)")
    now = json.loads(json.dumps(record))  # tuples become lists
    of_case = _case_differences(earlier["case"], now["case"])
    changed = {key for key in of_case if retry_failed and _is_numerical(key)}
    differences = [text for key, text in of_case.items() if key not in changed]
    differences += _axis_differences(earlier["axes"], now["axes"])
    differences += [
        f"{key} was {earlier[key]}, is {now[key]}" for key in ("design", "samples", "seed") if earlier[key] != now[key]
    ]
    if differences:
        remedy = "choose another folder"
        if of_case and not retry_failed and all(_is_numerical(key) for key in of_case):
            remedy += ", or change grid and solver of the failed runs alone (retry_failed)"
        raise InputError(f"{path}: holds another sweep; {remedy}. {'; '.join(differences)}")
    changed |= set(earlier.get("changed", []))
    if changed != set(earlier.get("changed", [])):
        _write_record(path, {**earlier, "changed": sorted(changed)})
    return changed


def _write_record(path: Path, record: Mapping[str, Any]) -> None:
    _replace(path / "sweep.json", lambda part: part.write_text(json.dumps(record, indent=2) + "\n", "utf-8"))


def read_record(path: Path) -> dict[str, Any] | None:
    """Content of sweep.json; None if the file is missing.

    Raises:
        InputError: the file is damaged, or has another format.
    """
    file = path / "sweep.json"
    try:
        record = json.loads(file.read_text(encoding="utf-8"))
    except FileNotFoundError:
        return None
    except (OSError, ValueError) as error:
        raise InputError(f"{file}: cannot be read ({error})") from error
    if not isinstance(record, dict) or record.get("format") != "brinell-sweep":
        raise InputError(f"{file}: is not of a sweep of brinell")
    if record.get("format_version") != FORMAT_VERSION:
        raise InputError(
            f"{file}: has format version {record.get('format_version')}, but this brinell reads version "
            f"{FORMAT_VERSION}; choose another folder"
        )
    return record


def _case_differences(earlier: str, now: str) -> dict[str, str]:
    """Texts about the differences of two cases by dotted key."""
    before = flattened(tomllib.loads(earlier), lists=True)
    after = flattened(tomllib.loads(now), lists=True)
    keys = [key for key in {**before, **after} if before.get(key) != after.get(key) and key not in HARMLESS]
    return {key: f"{key} of the case was {_short(before.get(key))}, is {_short(after.get(key))}" for key in keys}


def _is_numerical(key: str) -> bool:
    """Whether a key belongs to the numerical method (grid or solver) and not to the physical problem."""
    return key.startswith(("grid.", "solver."))


def _axis_differences(earlier: Mapping[str, Any], now: Mapping[str, Any]) -> list[str]:
    keys = [key for key in {**earlier, **now} if earlier.get(key) != now.get(key)]
    texts = [f"the axis {key} was {_axis_text(earlier.get(key))}, is {_axis_text(now.get(key))}" for key in keys]
    if not texts and list(earlier) != list(now):
        texts = [f"the axes were in the order {', '.join(earlier)}, are in the order {', '.join(now)}"]
    return texts


def _axis_text(axis: Any) -> str:
    """An axis as it is written after --over."""
    if not isinstance(axis, Mapping) or "start" not in axis:
        return _short(axis)
    unit = f" {axis['unit']}" if axis.get("unit") else ""
    count = f":{axis['count']}" if axis.get("count") is not None else ""
    return f"{'log:' if axis.get('logarithmic') else ''}{axis['start']}{unit}:{axis['stop']}{unit}{count}"


_LONGEST = 60
"""Largest number of characters of a value in a message."""


def _short(value: object) -> str:
    text = "not set" if value is None else json.dumps(value)
    if len(text) <= _LONGEST:
        return text
    end = max(text.rfind(mark, 0, _LONGEST) for mark in ", ")  # cut between two words
    return text[: end if end > 0 else _LONGEST].rstrip(", ") + " ..."


def flattened(entry: Mapping[str, Any], *, lists: bool = False) -> dict[str, Any]:
    """Flattens nested tables to dotted keys; tables in a list are numbered from 0.

    Args:
        entry: the tables.
        lists: whether lists of numbers are kept or left out.
    """
    flat: dict[str, Any] = {}

    def add(name: str, value: Any) -> None:
        if isinstance(value, list) and value and all(isinstance(item, Mapping) for item in value):
            value = {str(i): item for i, item in enumerate(value)}
        if isinstance(value, Mapping):
            for key, item in value.items():
                add(f"{name}.{key}" if name else key, item)
        elif lists or not isinstance(value, list):
            flat[name] = value

    add("", entry)
    return flat


class Ledger:
    """The rows of the table and the failures, kept current on disk while runs finish."""

    def __init__(self, path: Path, points: list[Point], texts: list[str], changed: Collection[str] = ()):
        """Reads the results of an earlier call from the folder.

        Args:
            path: folder of the sweep.
            points: values of the axes of each run.
            texts: text of the case of each run, with all defaults.
            changed: keys that differ between runs although they are not axes; they become columns of the table.
        """
        self._path = path
        self._points = points
        self._texts = texts
        self._changed = sorted(changed)
        self._rows: dict[int, dict[str, Any]] = {}
        self._failures: dict[str, Any] = _read_failures(path)
        self._next_writing = 0.0
        for index, text in enumerate(texts):
            summary = finished_summary(run_folder(path, index), text, self._changed)
            if summary is not None:
                self._put(Outcome(index, "done", summary=summary))
            elif str(index) in self._failures:
                self._put(Outcome(index, "failed", **self._failures[str(index)]))

    def missing(self, *, retry_failed: bool) -> list[int]:
        """Indices of the runs that have to be computed, with `retry_failed` including the failed ones."""
        if retry_failed:
            self._rows = {index: row for index, row in self._rows.items() if row["status"] == "done"}
            self._failures = {}
        return [index for index in range(len(self._texts)) if index not in self._rows]

    @property
    def failed(self) -> int:
        """Number of failed runs."""
        return len(self._failures)

    def __len__(self) -> int:
        return len(self._rows)

    def add(self, outcome: Outcome) -> None:
        """Adds the outcome of a finished or failed run."""
        self._put(outcome)
        now = time.perf_counter()
        if now >= self._next_writing:
            self.write()
            spent = time.perf_counter() - now
            self._next_writing = now + spent / _WRITING_SHARE

    def _put(self, outcome: Outcome) -> None:
        index = outcome.index
        row: dict[str, Any] = {"index": index}
        case = tomllib.loads(self._texts[index])
        for key, given in self._points[index].items():
            row[key] = _cell(_at(case, key, given))
        for key in self._changed:
            row[key] = _cell(_at(outcome.summary.get("case", case), key, None))
        row |= {
            "status": outcome.status,
            "reason": outcome.reason,
            "wall_time_s": outcome.wall_time,
            "folder": str(run_folder(self._path, index).relative_to(self._path)),
        }
        self._failures.pop(str(index), None)
        if outcome.status == "failed":
            self._failures[str(index)] = {
                "reason": outcome.reason,
                "traceback": outcome.traceback,
                "wall_time": outcome.wall_time,
            }
        else:
            row["wall_time_s"] = outcome.summary["run"]["wall_time_s"]
        results = {key: value for key, value in outcome.summary.items() if key not in _NOT_RESULTS}
        self._rows[index] = row | flattened(results)

    def table(self) -> pd.DataFrame:
        """Table with one row per finished or failed run, in the order of the runs."""
        frame = pd.DataFrame([self._rows[index] for index in sorted(self._rows)])
        for name, column in frame.items():
            kinds = {isinstance(value, str) for value in column.dropna()}
            if len(kinds) > 1:  # a column of a file has one type
                frame[name] = column.map(str, na_action="ignore")
        return frame

    def write(self) -> None:
        """Writes table.csv, table.parquet and failures.json."""
        frame = self.table()
        failures = json.dumps(self._failures, indent=2) + "\n"
        _replace(self._path / "failures.json", lambda part: part.write_text(failures, "utf-8"))
        write_table(self._path, frame)


def write_table(path: Path, frame: pd.DataFrame) -> None:
    """Writes table.csv and table.parquet of a sweep."""
    _replace(path / "table.csv", lambda part: without_formulas(frame).to_csv(part, index=False))
    _replace(path / "table.parquet", lambda part: frame.to_parquet(part, index=False))


def without_formulas(frame: pd.DataFrame) -> pd.DataFrame:
    """Protects texts that a spreadsheet would evaluate as formulas by an apostrophe in front."""
    return frame.map(lambda cell: f"'{cell}" if _is_formula(cell) else cell)


def _is_formula(cell: object) -> bool:
    if not isinstance(cell, str) or not cell.startswith(("=", "+", "-", "@", "\t", "\r")):
        return False
    try:
        float(cell)
    except ValueError:
        return True
    return False


def _at(case: Mapping[str, Any], key: str, otherwise: object) -> Any:
    """Value in SI units of a dotted key, or of an entry of a list, in a case; `otherwise` if it is missing."""
    of_list = entry_of(key, otherwise)
    if of_list is not None:
        whole = _at(case, of_list[0], [])
        return whole[of_list[1]] if len(whole) > of_list[1] else otherwise
    entry: Any = case
    for part in key.replace("[", ".[").split("."):
        if part.startswith("[") and isinstance(entry, list):
            index = int(part[1:-1])
            entry = entry[index] if index < len(entry) else None
        elif isinstance(entry, Mapping) and part in entry:
            entry = entry[part]
        else:
            return otherwise  # for example the key of a file whose content is stored in the case instead
    return entry


def _cell(value: Any) -> Any:
    return json.dumps(value) if isinstance(value, list | Mapping) else value


def _read_failures(path: Path) -> dict[str, Any]:
    try:
        failures = json.loads((path / "failures.json").read_text(encoding="utf-8"))
    except (OSError, ValueError):
        return {}
    return dict(failures)


def _replace(path: Path, write: Callable[[Path], object]) -> None:
    part = path.with_name(path.name + ".part")
    try:
        write(part)
        part.replace(path)
    except OSError as error:
        raise IoError(f"{path}: cannot be written: {error}") from error
