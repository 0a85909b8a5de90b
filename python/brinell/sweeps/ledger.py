# SPDX-License-Identifier: BSD-3-Clause
"""What is known of the runs of a sweep: the rows of its table, kept current on disk while runs finish."""

from __future__ import annotations

import contextlib
import json
import time
from collections.abc import Collection, Iterable, Iterator, Mapping
from pathlib import Path
from typing import Any

import pandas as pd

from brinell._toml import tomllib
from brinell.sweeps.designs import Point
from brinell.sweeps.folder import flattened, read_failures, run_folder, write_failures, write_table
from brinell.sweeps.journal import Journal, JournalReader, is_of, journal_folder, key_of, outcome_of, write_journal
from brinell.sweeps.lists import entry_of
from brinell.sweeps.point import Outcome, Task, finished_summary

__all__ = ["Ledger"]

_NOT_RESULTS = ("format", "format_version", "case", "complete", "scenario", "title", "versions")
"""Entries of a summary that are not results of the run."""
_WRITING_SHARE = 0.05
"""Fraction of the time that may be spent on updating the table."""


class Ledger:
    """The rows of the table and the failures, kept current on disk while runs finish."""

    def __init__(
        self,
        path: Path,
        points: list[Point],
        texts: list[str],
        changed: Collection[str] = (),
        *,
        kept: Collection[int] | None = None,
    ):
        """Reads the results of an earlier call from the folder.

        Args:
            path: folder of the sweep.
            points: values of the axes of each run.
            texts: text of the case of each run, with all defaults.
            changed: keys that differ between runs although they are not axes; they become columns of the table.
            kept: indices of the runs that write folders; None: all.
        """
        self._path = path
        self._points = points
        self._texts = texts
        self._changed = sorted(changed)
        self._kept = range(len(texts)) if kept is None else frozenset(kept)
        self._keys: dict[int, dict[str, Any]] = {}
        self._of_axes: dict[int, dict[str, Any]] = {}
        self._rows: dict[int, dict[str, Any]] = {}
        self._failures: dict[str, Any] = read_failures(path)
        self._next_writing = 0.0
        self._reader = JournalReader(journal_folder(path))
        self.numbers: dict[int, dict[str, dict[str, Any]]] = {}
        """Numbers of runs without a folder by the names of the functions."""
        self.is_awaited = False
        """Whether others still write journals."""
        self.journal: Journal | None = None
        """Where the outcomes of runs without a folder are written, unless who computes them does it."""
        for index, text in enumerate(texts):
            folder = run_folder(path, index)
            summary = finished_summary(folder, text, self._changed) if folder.exists() else None
            if summary is not None:
                self._put(Outcome(index, "done", summary=summary))
        self.take(self._reader.entries(), shown=False)
        for index in range(len(texts)):
            if index not in self._rows and str(index) in self._failures:
                self._put(Outcome(index, "failed", **self._failures[str(index)]))

    def take(self, entries: Iterable[Mapping[str, Any]], *, shown: bool = True) -> list[int]:
        """Adds what journals tell.

        Args:
            entries: lines of journals; those that tell no outcome of a run of this sweep are left out.
            shown: whether the table on disk follows.

        Returns:
            Indices of the runs that are new in the table.
        """
        new = []
        for entry in entries:
            index = entry.get("index", -1)
            if not 0 <= index < len(self._texts) or self._is_done(index):
                continue
            if entry["status"] == "done":
                is_there = index not in self._kept or run_folder(self._path, index).exists()
                if not is_there or not is_of(entry, self._key(index), self._changed):
                    continue
            if index not in self._rows:
                new.append(index)
            if shown:
                self.add(outcome_of(entry), self._texts[index])
            else:
                self._put(outcome_of(entry))
        return new

    def take_new(self) -> tuple[list[int], list[dict[str, Any]]]:
        """Adds what the journals of the folder tell since the last call.

        Returns:
            Indices of the runs that are new in the table, and the lines that were read.
        """
        entries = list(self._reader.entries())
        return self.take(entries), entries

    def tidy_journals(self) -> None:
        """Puts all journals into one, with what only they know: nobody may be writing them."""
        folder = journal_folder(self._path)
        files = sorted(folder.glob("*.jsonl"))
        if not files:
            return
        kept_lines: dict[int, None] = {}

        def worth_keeping() -> Iterator[Mapping[str, Any]]:
            for file in files:
                for entry in JournalReader(folder).entries_of(file):
                    index = entry.get("index", -1)
                    if not 0 <= index < len(self._texts):
                        continue
                    if index in kept_lines or index in self._kept or entry.get("status") != "done":
                        continue
                    if self._is_done(index) and is_of(entry, self._key(index), self._changed):
                        kept_lines[index] = None
                        yield entry

        whole = folder / "results.jsonl"
        write_journal(whole, worth_keeping())
        for file in files:
            if file != whole:
                file.unlink(missing_ok=True)
        if not kept_lines:
            whole.unlink()
            with contextlib.suppress(OSError):
                folder.rmdir()
        self._reader = JournalReader(folder)
        list(self._reader.entries())  # known

    def _is_done(self, index: int) -> bool:
        return index in self._rows and self._rows[index]["status"] == "done"

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

    def __contains__(self, index: object) -> bool:
        return index in self._rows

    def begun(self, task: Task) -> None:
        """Nothing: a run that has begun is not in the table."""

    def stopped(self, task: Task) -> None:
        """Nothing: a run that was stopped is not in the table."""

    def lost(self, task: Task, what: str) -> None:
        """Nothing: the run is computed again."""

    def add(self, outcome: Outcome, text: str) -> None:
        """Adds the outcome of a finished or failed run of the case `text`."""
        if self.journal is not None and outcome.index not in self._kept and outcome.status == "done":
            self.journal.add(outcome, text, self._key(outcome.index))
        self._put(outcome)
        now = time.perf_counter()
        if now >= self._next_writing:
            self.write()
            spent = time.perf_counter() - now
            self._next_writing = now + spent / _WRITING_SHARE

    def _put(self, outcome: Outcome) -> None:
        index = outcome.index
        row: dict[str, Any] = {"index": index}
        row |= self._values(index)
        for key in self._changed:
            case = outcome.summary.get("case") or tomllib.loads(self._texts[index])
            row[key] = _cell(_at(case, key, None))
        row |= {
            "status": outcome.status,
            "reason": outcome.reason,
            "wall_time_s": outcome.wall_time,
            "folder": self._folder(index),
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
            self.numbers[index] = outcome.numbers
        results = {key: value for key, value in outcome.summary.items() if key not in _NOT_RESULTS}
        self._rows[index] = row | flattened(results)

    def _key(self, index: int) -> dict[str, Any]:
        """What identifies the case of a run."""
        if index not in self._keys:
            self._read_case(index)
        return self._keys[index]

    def _values(self, index: int) -> dict[str, Any]:
        """Values of the axes of a run."""
        if index not in self._of_axes:
            self._read_case(index)
        return self._of_axes[index]

    def _read_case(self, index: int) -> None:
        """Takes from the text of a case what is needed of it, at once: parsing takes a millisecond."""
        case = tomllib.loads(self._texts[index])
        self._keys[index] = key_of(case)
        self._of_axes[index] = {key: _cell(_at(case, key, given)) for key, given in self._points[index].items()}

    def _folder(self, index: int) -> str:
        """Folder of a run as in the table; empty if there is none."""
        folder = run_folder(self._path, index)
        is_there = index in self._kept or (folder / "summary.json").exists()
        return str(folder.relative_to(self._path)) if is_there else ""

    def table(self) -> pd.DataFrame:
        """Table with one row per finished or failed run, in the order of the runs."""
        rows = [self._rows[index] for index in sorted(self._rows)]
        frame = pd.DataFrame(rows, columns=None if rows else ["index", "status", "reason", "wall_time_s", "folder"])
        for name, column in frame.items():
            kinds = {isinstance(value, str) for value in column.dropna()}
            if len(kinds) > 1:  # a column of a file has one type
                frame[name] = column.map(str, na_action="ignore")
        return frame

    def write(self) -> None:
        """Writes table.csv, table.parquet and failures.json."""
        frame = self.table()
        write_failures(self._path, self._failures)
        write_table(self._path, frame)


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
