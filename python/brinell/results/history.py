# SPDX-License-Identifier: BSD-3-Clause
"""history.csv: one row per step of a run."""

from __future__ import annotations

import csv
import difflib
import itertools
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from brinell._reprs import column_table
from brinell.errors import MissingExtraError
from brinell.results.columns import COLUMN_UNITS, INTEGER_COLUMNS, NOT_ALWAYS_FINITE, scenario_of
from brinell.results.errors import RunError, listed
from brinell.scenarios import Scenario

if TYPE_CHECKING:
    import pandas

__all__ = ["History", "read_history"]

Column = NDArray[Any]
"""Values of a column: floats, or integers if the column is a count or a number."""


class History(dict[str, Column]):
    """Columns of history.csv by name, in SI units, with one value per step; `HISTORY_COLUMNS` lists them.

    Counts and numbers of steps are integers. The steps of several passes follow each other; `passes` separates them.
    `to_pandas` or ``pandas.DataFrame(run.history)`` makes a table for pandas.

    Raises:
        RunError: the columns of no scenario are complete.
    """

    def __init__(self, columns: Mapping[str, Column]):
        self.scenario: Scenario = scenario_of(columns)
        """Scenario, recognised by the columns."""
        counts = INTEGER_COLUMNS[self.scenario]
        super().__init__(
            {
                name: np.asarray(column, dtype=np.int64 if name in counts else np.float64)
                for name, column in columns.items()
            }
        )

    def __missing__(self, name: str) -> Column:
        raise KeyError(f"no column {name!r}; {self._alternatives(str(name))}")

    def __reduce__(self) -> tuple[Any, ...]:
        return type(self), (dict(self),)

    def _alternatives(self, name: str) -> str:
        """Suggestions for an unknown column."""
        by_lower = {column.lower(): column for column in self}
        close = difflib.get_close_matches(name.lower(), by_lower)
        return f"close: {listed([by_lower[one] for one in close])}" if close else f"allowed: {listed(list(self))}"

    def to_pandas(self) -> pandas.DataFrame:
        """The history as a pandas table with one row per step; the units are in `attrs["units"]`.

        Raises:
            MissingExtraError: pandas is not installed.
        """
        try:
            import pandas
        except ImportError as error:
            raise MissingExtraError("to_pandas", "pandas", "pandas") from error
        table = pandas.DataFrame(dict(self))
        table.attrs["units"] = {name: unit for name, unit in self.units.items() if name in self}
        return table

    @property
    def units(self) -> Mapping[str, str]:
        """Unit of each column by name; "1" for a dimensionless column."""
        return COLUMN_UNITS[self.scenario]

    def _repr_html_(self) -> str:
        """For notebooks: the first and the last rows, with units."""
        return column_table(f"History of the {self.scenario}: {self.steps} steps", self, self.units)

    def __repr__(self) -> str:
        return f"<History {self.scenario} {self.steps} steps, {len(self)} columns>"

    @property
    def steps(self) -> int:
        """Number of steps, one row each."""
        return len(self["step"])

    @property
    def in_contact(self) -> NDArray[np.bool_]:
        """(steps,) true where the bodies touch."""
        return (self["contact_area"] > 0.0) & (self["F_n"] > 0.0)

    def passes(self) -> list[History]:
        """Histories of the passes; in an indentation a pass is one cycle at one place."""
        return self.split("pass")

    def split(self, name: str) -> list[History]:
        """Splits the history wherever the value of a column changes.

        Args:
            name: name of the column.
        """
        starts = np.flatnonzero(np.diff(self[name])) + 1
        bounds = [0, *starts.tolist(), self.steps]
        return [self.part(slice(a, b)) for a, b in itertools.pairwise(bounds)]

    def part(self, rows: slice) -> History:
        """History of a slice of the rows."""
        return History({name: column[rows] for name, column in self.items()})


def read_history(folder: Path) -> History:
    """Reads the history of a result folder.

    Raises:
        RunError: history.csv is missing or damaged, or has no finished step.
    """
    path = folder / "history.csv"
    if not path.is_file():
        raise RunError(f"{folder}: no history.csv, so this is not a result of 'brinell run'")
    try:
        text = path.read_text(encoding="utf-8")
    except (OSError, UnicodeDecodeError) as error:
        raise RunError(f"{path}: cannot be read ({error})") from error
    # A killed run may leave an incomplete last row without its line end; the rows before are valid.
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
        if not np.isfinite(value) and name not in NOT_ALWAYS_FINITE:
            raise RunError(f"{where}: {name} = {value} is not a finite number")
    return row
