# SPDX-License-Identifier: BSD-3-Clause
"""history.csv: one row per step of a run."""

from __future__ import annotations

import csv
import difflib
import itertools
from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from brinell.results.errors import RunError, listed
from brinell.results.scenarios import Scenario, scenario_of

__all__ = ["History", "read_history"]

FloatArray = NDArray[np.float64]


class History(Mapping[str, FloatArray]):
    """Columns of history.csv by name, SI, one value per step; see HISTORY_COLUMNS.

    Steps of several passes follow each other; `passes` takes them apart.

    Raises:
        RunError: columns are missing, whatever the scenario.
    """

    def __init__(self, columns: Mapping[str, FloatArray]):
        self._columns = {name: np.asarray(column, dtype=np.float64) for name, column in columns.items()}
        self.scenario: Scenario = scenario_of(self._columns)
        """Told by the columns."""

    def __getitem__(self, name: str) -> FloatArray:
        try:
            return self._columns[name]
        except KeyError:
            raise KeyError(f"no column {name!r}; {self._alternatives(str(name))}") from None

    def _alternatives(self, name: str) -> str:
        """Columns that may be meant by a name that is none."""
        by_lower = {column.lower(): column for column in self}
        close = difflib.get_close_matches(name.lower(), by_lower)
        return f"close: {listed([by_lower[one] for one in close])}" if close else f"allowed: {listed(list(self))}"

    def __iter__(self) -> Iterator[str]:
        return iter(self._columns)

    def __len__(self) -> int:
        return len(self._columns)

    def __repr__(self) -> str:
        return f"<History {self.scenario} {self.steps} steps, {len(self)} columns>"

    @property
    def steps(self) -> int:
        """Number of rows."""
        return len(self._columns["step"])

    @property
    def in_contact(self) -> NDArray[np.bool_]:
        """Steps at which the bodies touch."""
        return (self["contact_area"] > 0.0) & (self["F_n"] > 0.0)

    def passes(self) -> list[History]:
        """One history per pass; in an indentation a pass is one cycle at one place."""
        return self.split("pass")

    def split(self, name: str) -> list[History]:
        """One history per run of equal values of a column."""
        starts = np.flatnonzero(np.diff(self[name])) + 1
        bounds = [0, *starts.tolist(), self.steps]
        return [self.part(slice(a, b)) for a, b in itertools.pairwise(bounds)]

    def part(self, rows: slice) -> History:
        """Some of the rows."""
        return History({name: column[rows] for name, column in self.items()})


def read_history(folder: Path) -> History:
    """The history of a result folder.

    Raises:
        RunError: it is missing or damaged, or has no finished step.
    """
    path = folder / "history.csv"
    if not path.is_file():
        raise RunError(f"{folder}: no history.csv, so this is not a result of 'brinell run'")
    try:
        text = path.read_text(encoding="utf-8")
    except (OSError, UnicodeDecodeError) as error:
        raise RunError(f"{path}: cannot be read ({error})") from error
    # A run that was killed may leave half a row without its line end: the finished rows stay good.
    lines = text[: text.rfind("\n") + 1].splitlines()
    names = lines[0].split(",") if lines else []
    try:
        scenario_of(names)
    except RunError as error:
        raise RunError(f"{path}:1: {error}") from error
    rows = [_row(cells, names, f"{path}:{line}") for line, cells in enumerate(csv.reader(lines[1:]), start=2)]
    if not rows:
        raise RunError(f"{path}: no finished step")
    table = np.array(rows, dtype=np.float64)
    return History({name: table[:, i] for i, name in enumerate(names)})


def _row(cells: Sequence[str], names: Sequence[str], where: str) -> list[float]:
    if len(cells) != len(names):
        raise RunError(f"{where}: {len(cells)} values, expected {len(names)}")
    try:
        row = [float(cell) for cell in cells]
    except ValueError as error:
        raise RunError(f"{where}: {error}") from error
    for name, value in zip(names, row, strict=True):
        if not np.isfinite(value):
            raise RunError(f"{where}: {name} = {value} is not a finite number")
    return row
