# SPDX-License-Identifier: BSD-3-Clause
"""Journals of a sweep: what became of each run, a line each, written by whoever computes it.

A run whose folder is not kept leaves nothing else, and the tasks of a cluster tell the process that waits for them in
this way. Each line is appended by itself, so that no end of a process damages more than its last line, which is then
left out.
"""

from __future__ import annotations

import hashlib
import json
import os
from collections import Counter
from collections.abc import Collection, Iterable, Iterator, Mapping
from pathlib import Path
from typing import Any

from brinell._toml import tomllib
from brinell.errors import IoError
from brinell.sweeps.point import HARMLESS, Outcome, Task

__all__ = [
    "Journal",
    "JournalReader",
    "attempts",
    "case_key",
    "is_of",
    "journal_folder",
    "key_of",
    "outcome_of",
    "write_journal",
]

_NUMERICAL = ("grid", "solver")
"""Tables of a case that belong to the numerical method."""


def journal_folder(path: Path) -> Path:
    """Folder of the journals of the sweep in `path`."""
    return path / "journal"


def case_key(text: str) -> dict[str, Any]:
    """What identifies the case of a run: a digest of the physical problem, and its tables grid and solver."""
    return key_of(tomllib.loads(text))


def key_of(case: Mapping[str, Any]) -> dict[str, Any]:
    """What identifies a case that has been parsed."""
    numerical = {name: dict(case.get(name, {})) for name in _NUMERICAL}
    case = {name: value for name, value in case.items() if name not in _NUMERICAL}
    for key in HARMLESS:
        table, _, name = key.partition(".")
        numerical.get(table, {}).pop(name, None)
    physics = hashlib.sha256(json.dumps(case, sort_keys=True, default=str).encode()).hexdigest()
    return {"physics": physics, "numerical": numerical}


def is_of(entry: Mapping[str, Any], now: Mapping[str, Any], other: Collection[str] = ()) -> bool:
    """Whether a line of a journal is of exactly a case, except for the dotted keys `other` of grid and solver.

    Args:
        entry: the line.
        now: what identifies the case, as `case_key` returns it.
        other: keys that may differ.
    """
    if entry.get("physics") != now["physics"]:
        return False

    def compared(numerical: Mapping[str, Mapping[str, Any]]) -> dict[str, Any]:
        flat = {f"{table}.{name}": value for table, entries in numerical.items() for name, value in entries.items()}
        return {key: value for key, value in flat.items() if key not in other}

    return compared(entry.get("numerical", {})) == compared(now["numerical"])


def outcome_of(entry: Mapping[str, Any]) -> Outcome:
    """The outcome that a line tells."""
    summary = entry.get("summary", {})
    return Outcome(
        entry["index"],
        entry["status"],
        entry.get("wall_time", 0.0),
        entry.get("reason", ""),
        entry.get("traceback", ""),
        {**summary, "case": entry.get("numerical", {})} if summary else {},
        entry.get("numbers", {}),
    )


class Journal:
    """A journal that this process writes."""

    def __init__(self, file: Path):
        """Writes nothing yet.

        Args:
            file: the journal, which may exist.
        """
        self.file = file
        self._begun = False

    def begun(self, task: Task) -> None:
        """Notes that a run begins: if no outcome follows, it has taken its process with it."""
        self._append({"begun": task.index})

    def stopped(self, task: Task) -> None:
        """Notes that a run was stopped on request."""
        self._append({"stopped": task.index})

    def lost(self, task: Task, what: str) -> None:
        """Notes that the process of a run died."""
        self._append({"lost": task.index, "what": what})

    def add(self, outcome: Outcome, text: str, key: Mapping[str, Any] | None = None) -> None:
        """Notes the outcome of a finished or failed run.

        Args:
            outcome: the outcome.
            text: text of the case.
            key: what identifies the case, if that is known: parsing a text takes a millisecond.
        """
        self._append(_entry_of(outcome, text, key))

    def _append(self, entry: Mapping[str, Any]) -> None:
        line = json.dumps(entry).encode() + b"\n"
        try:
            if not self._begun:
                self.file.parent.mkdir(parents=True, exist_ok=True)
            # Opened and closed for each line: a network file system passes on what is closed.
            with self.file.open("ab", buffering=0) as stream:
                if not self._begun and _is_broken_off(self.file):
                    line = b"\n" + line
                if stream.write(line) != len(line):
                    raise OSError(28, os.strerror(28))
        except OSError as error:
            raise IoError(f"{self.file}: cannot be written: {error.strerror}") from error
        self._begun = True


def _entry_of(outcome: Outcome, text: str, key: Mapping[str, Any] | None) -> dict[str, Any]:
    """The line that tells an outcome of the case `text`."""
    entry: dict[str, Any] = {"index": outcome.index, "status": outcome.status, "wall_time": outcome.wall_time}
    if outcome.status == "failed":
        return entry | {"reason": outcome.reason, "traceback": outcome.traceback}
    summary = {key: value for key, value in outcome.summary.items() if key != "case"}
    return entry | {**(key or case_key(text))} | {"summary": summary, "numbers": outcome.numbers}


def write_journal(file: Path, entries: Iterable[Mapping[str, Any]]) -> None:
    """Replaces a journal as a whole."""
    part = file.with_name(file.name + ".part")
    try:
        file.parent.mkdir(parents=True, exist_ok=True)
        with part.open("w", encoding="utf-8") as stream:
            for entry in entries:
                stream.write(json.dumps(entry) + "\n")
        part.replace(file)
    except OSError as error:
        raise IoError(f"{file}: cannot be written: {error.strerror}") from error


class JournalReader:
    """All journals of a folder, read as they grow."""

    def __init__(self, folder: Path):
        """Reads nothing yet.

        Args:
            folder: folder of the journals; it may be missing.
        """
        self._folder = folder
        self._read: dict[Path, int] = {}

    def entries(self) -> Iterator[dict[str, Any]]:
        """Lines that have been written since the last call, in the order of the files' names."""
        for file in sorted(self._folder.glob("*.jsonl")):
            yield from self.entries_of(file)

    def entries_of(self, file: Path) -> list[dict[str, Any]]:
        """New lines of one journal."""
        entries, self._read[file] = _entries(file, self._read.get(file, 0))
        return entries


def attempts(entries: Iterable[Mapping[str, Any]]) -> Counter[int]:
    """How often runs have begun without an end, by their indices."""
    count: Counter[int] = Counter()
    for entry in entries:
        if "begun" in entry:
            count[entry["begun"]] += 1
        elif "stopped" in entry:
            count[entry["stopped"]] -= 1
        elif "index" in entry:
            count[entry["index"]] = 0
    return +count


def _entries(file: Path, start: int) -> tuple[list[dict[str, Any]], int]:
    """Whole lines of a file from a place on, and the place after them."""
    try:
        with file.open("rb") as stream:
            stream.seek(start)
            content = stream.read()
    except OSError:
        return [], start
    end = content.rfind(b"\n") + 1
    entries = []
    for line in content[:end].splitlines():
        try:
            entry = json.loads(line)
        except ValueError:  # broken off by a full disk or the end of its process
            continue
        if isinstance(entry, dict):
            entries.append(entry)
    return entries, start + end


def _is_broken_off(file: Path) -> bool:
    """Whether the last line has no end."""
    with file.open("rb") as stream:
        if stream.seek(0, os.SEEK_END) == 0:
            return False
        stream.seek(-1, os.SEEK_END)
        return stream.read() != b"\n"
