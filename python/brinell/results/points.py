# SPDX-License-Identifier: BSD-3-Clause
"""Histories of stress and strain at points within the bodies, one value for each step."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from brinell._names import did_you_mean
from brinell.results.errors import RunError, listed, reports_damage
from brinell.results.result_file import ResultFile, Source

__all__ = ["PointHistory", "point_histories"]

FloatArray = NDArray[np.float64]

FILE_NAME = "points.csv"
"""Name of the file with the histories in the folder of a run."""

_PLACE = ("step", "point", "body", "x", "y", "depth")


@dataclass(frozen=True, eq=False)
class PointHistory:
    """History of a point of `output.points`: `point["stress_xx"]`, `point["temperature"]` over `point.step`.

    The values are those of the cell around the point; they are NaN in steps in which the grid of the body did not yet
    reach there.
    """

    body: Literal["lower", "upper"]
    x: float
    """Centre of the cell on the surface of the body, along the motion [m]."""
    y: float
    """Centre of the cell across [m]."""
    depth: float
    """Depth of the centre of the cell [m]."""
    step: NDArray[np.int64]
    """Numbers of the steps."""
    columns: Mapping[str, FloatArray]
    """Stress and plastic strain by component, their equivalents, and temperature, in SI units (deg C)."""

    def __getitem__(self, name: str) -> FloatArray:
        """A column, such as "stress_xx", "von_mises_stress" or "temperature"."""
        if name not in self.columns:
            known = list(self.columns)
            raise KeyError(f"a point has no {name!r}; {did_you_mean(name, known)}allowed: {listed(known)}")
        return self.columns[name]

    def __repr__(self) -> str:
        return (
            f"<PointHistory {self.body} x={self.x:g} m, y={self.y:g} m, depth={self.depth:g} m, {len(self.step)} steps>"
        )


def point_histories(path: Path, file: Source) -> list[PointHistory]:
    """Histories of a run, in the order of the points in the case; empty if it has no points.

    Args:
        path: folder of the run, whose points.csv has all finished steps, or its file.
        file: its result file.

    Raises:
        RunError: the file is damaged.
    """
    table = _of_csv(path / FILE_NAME) if (path / FILE_NAME).is_file() else _of_file(file)
    if not table:
        return []
    return [_history(table, table["point"] == number) for number in np.unique(table["point"])]


def _of_csv(path: Path) -> dict[str, FloatArray]:
    with reports_damage(path):
        names = path.open(encoding="utf-8").readline().strip().split(",")
        values = np.loadtxt(path, delimiter=",", skiprows=1, ndmin=2)
        if values.size and values.shape[1] != len(names):
            raise RunError(f"{path}: {values.shape[1]} values in a row, the header has {len(names)}")
    return dict(zip(names, values.T, strict=True)) if values.size else {}


def _of_file(source: Source) -> dict[str, FloatArray]:
    with ResultFile(source) as file:
        return file.table("points")


def _history(table: Mapping[str, FloatArray], rows: NDArray[np.bool_]) -> PointHistory:
    place = {name: float(np.nanmax(table[name][rows], initial=-np.inf)) for name in ("x", "y", "depth")}
    return PointHistory(
        body="lower" if table["body"][rows][0] == 1.0 else "upper",
        step=table["step"][rows].astype(np.int64),
        columns={name: values[rows] for name, values in table.items() if name not in _PLACE},
        **{name: value if np.isfinite(value) else np.nan for name, value in place.items()},
    )
