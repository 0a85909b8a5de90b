# SPDX-License-Identifier: BSD-3-Clause
"""The folder of a sweep: its definition (sweep.json), folders of runs, the table, and the reasons of failures.

All files are replaced atomically, so that they can be read at any time.
"""

from __future__ import annotations

import contextlib
import fcntl
import json
import os
from collections.abc import Callable, Iterator, Mapping
from pathlib import Path
from typing import Any

import pandas as pd

from brinell._toml import tomllib
from brinell.errors import InputError, IoError
from brinell.sweeps.point import HARMLESS

__all__ = [
    "FORMAT_VERSION",
    "flattened",
    "locked",
    "read_failures",
    "read_record",
    "run_folder",
    "start_folder",
    "without_formulas",
    "write_failures",
    "write_table",
]

FORMAT_VERSION = 1
_FILES = ("table.csv", "table.parquet", "failures.json")
"""Files that a sweep writes after sweep.json."""


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


def read_failures(path: Path) -> dict[str, Any]:
    """Reasons of failures by the index of the run; none if the file is missing or damaged."""
    try:
        failures = json.loads((path / "failures.json").read_text(encoding="utf-8"))
    except (OSError, ValueError):
        return {}
    return dict(failures)


def write_failures(path: Path, failures: Mapping[str, Any]) -> None:
    """Writes failures.json."""
    text = json.dumps(failures, indent=2) + "\n"
    _replace(path / "failures.json", lambda part: part.write_text(text, "utf-8"))


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


def _replace(path: Path, write: Callable[[Path], object]) -> None:
    part = path.with_name(path.name + ".part")
    try:
        write(part)
        part.replace(path)
    except OSError as error:
        raise IoError(f"{path}: cannot be written: {error}") from error
