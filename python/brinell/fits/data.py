# SPDX-License-Identifier: BSD-3-Clause
"""Measured data of one test, and how they compare to a run."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import Any, Literal, TypeAlias, get_args

import numpy as np
from numpy.typing import NDArray

from brinell import _core
from brinell._names import did_you_mean
from brinell.case import Case
from brinell.errors import InputError
from brinell.fits.columns import TextTable

__all__ = ["Data", "Kind", "data_from_file"]

FloatArray: TypeAlias = NDArray[np.float64]
Kind: TypeAlias = Literal["load-depth", "history", "imprint", "number"]

_FEWEST = 3
"""Points of a curve below which there is nothing to compare."""

TITLES = {
    "x": {"load-depth": ("depth", "displacement", "approach", "penetration"), "imprint": ("x", "distance", "position")},
    "y": {"load-depth": ("load", "force"), "imprint": ("height", "z", "profile")},
}
"""Words in titles of columns, by kind, by which the columns are found that the user does not name."""


@dataclass(frozen=True, eq=False)
class Data:
    """Measured data of one test, in SI units.

    Attributes:
        x: depth [m], positive into the body (kind "load-depth"); the column of the history on the abscissa ("history");
            coordinate along x from the middle of the place [m] ("imprint"); nothing ("number").
        y: load [N], positive in compression; the column of the history; height of the surface at the end of the run,
            positive outwards [m]; the number.
        kind: "load-depth": load over depth, with unloading and reloading in the order of the test; "history": any
            column of history.csv over another one, such as "F_X" over "X"; "imprint": profile along x of the residual
            surface of the lower body; "number": one number of the summary by its dotted key.
        name: name in messages and figures.
        case: the case of the test; None: that of the fit.
        set: keys of the case that differ in this test, such as {"indentation.load": ["50 mN", 0]}.
        columns: names of the columns of the history, of kind "history"; (key,) of the summary, of kind "number".
        noise: standard deviation of y: a quantity, or a share of each value as "1 %", at least that of 5 % of the
            largest; None: estimated from the residuals.
        noise_x: standard deviation of x, likewise; None: 0.
        time: time of each point [s], for drift.
        place: number, from 1, of the place of an indentation.
        passed: number, from 1, of the pass, cycle or stroke, of kind "history"; None: all.
        holds: what becomes of points at a held load: "leave_out", "subtract" (and the depth that the hold has added),
            or "keep".
        level: whether a constant is free that is added to the heights of an imprint.

    Raises:
        InputError: the values are no curve; the text says why.
    """

    x: FloatArray
    y: FloatArray
    kind: Kind = "load-depth"
    name: str = "data"
    case: Case | str | Path | None = None
    set: Mapping[str, Any] = field(default_factory=dict)
    columns: Sequence[str] = ()
    noise: float | str | None = None
    noise_x: float | str | None = None
    time: FloatArray | None = None
    place: int = 1
    passed: int | None = None
    holds: Literal["leave_out", "subtract", "keep"] = "leave_out"
    level: bool = True

    def __post_init__(self) -> None:
        for name in ("x", "y", "time"):
            if (given := getattr(self, name)) is not None:
                object.__setattr__(self, name, np.atleast_1d(np.asarray(given, dtype=np.float64)))
        allowed = {"kind": get_args(Kind), "holds": ("leave_out", "subtract", "keep")}
        for name, words in allowed.items():
            if (word := getattr(self, name)) not in words:
                raise self.error(f"{name} = {word!r}; {did_you_mean(word, words)}allowed: {', '.join(words)}")
        if self.kind == "number":
            object.__setattr__(self, "x", np.zeros(1))
        sizes = {len(one) for one in (self.x, self.y, self.time) if one is not None}
        if self.x.ndim != 1 or len(sizes) != 1:
            raise self.error(f"columns of {sorted(sizes)} points; allowed: one axis, as many points in each")
        if self.kind != "number" and self.x.size < _FEWEST:
            raise self.error(f"{self.x.size} points; allowed: {_FEWEST} or more")
        if not all(np.isfinite(one).all() for one in (self.x, self.y, self.time) if one is not None):
            raise self.error("a value is not finite; allowed: finite numbers")
        wanted = {"history": 2, "number": 1}.get(self.kind, 0)
        if len(self.columns) != wanted:
            names = {0: "no columns", 1: "the key of the summary", 2: "two columns of the history, x and y"}[wanted]
            raise self.error(f"columns = {list(self.columns)!r}; kind {self.kind!r} needs {names}")
        if self.kind == "number" and self.noise is None:
            raise self.error("a number needs its noise, the standard deviation; allowed: a quantity, or as '2 %'")
        if self.place < 1 or (self.passed is not None and self.passed < 1):
            raise self.error("place and pass are counted from 1")
        self.deviations()

    def error(self, text: str) -> InputError:
        """An error about these data."""
        return InputError(f"data {self.name!r}: {text}")

    @property
    def units(self) -> tuple[str, str]:
        """Units of x and y; empty: those of the column."""
        return units_of(self.kind, self.columns)

    def deviations(self) -> tuple[FloatArray | None, FloatArray]:
        """Standard deviations of y (None: not known) and of x, of all points.

        Raises:
            InputError: one is no quantity above 0.
        """
        spread = None if self.noise is None else self._deviation("noise", self.noise, self.y, self.units[1])
        along = np.zeros(self.x.size)
        if self.noise_x is not None:
            along = self._deviation("noise_x", self.noise_x, self.x, self.units[0])
        return spread, along

    def _deviation(self, name: str, given: float | str, values: FloatArray, unit: str) -> FloatArray:
        try:
            if isinstance(given, str) and given.strip().endswith("%"):
                share = _core.quantity_like(given, "")
                size = np.abs(values)
                found: FloatArray = share * np.maximum(size, _LEAST_SHARE * size.max(initial=0.0))
            else:
                number = _core.quantity_like(given, unit) if isinstance(given, str) and unit else float(given)
                found = np.full(values.size, number)
        except (InputError, TypeError, ValueError) as error:
            raise self.error(f"{name} = {given!r}: {error}; allowed: a quantity, or a share as '1 %'") from None
        if not (np.isfinite(found).all() and found.min() > 0.0):
            raise self.error(f"{name} = {given!r}; allowed: above 0")
        return found

    def at(self, keep: NDArray[np.bool_]) -> Data:
        """Some of the points."""
        return replace(self, x=self.x[keep], y=self.y[keep], time=None if self.time is None else self.time[keep])


_LEAST_SHARE = 0.05
"""Part of the largest value below which noise that is a share of the value no longer becomes smaller."""


def units_of(kind: str, columns: Sequence[str]) -> tuple[str, str]:
    """Units of x and y; empty for plain numbers, and for a column that is not known."""
    if kind == "history" and len(columns) == 2:
        known = {one.name: one.unit for part in _core.columns().values() for one in part}
        found = tuple(known.get(name, "").replace("1", "") for name in columns)
        return found[0], found[1]
    return {"load-depth": ("m", "N"), "imprint": ("m", "m")}.get(kind, ("", ""))


def data_from_file(
    path: str | Path,
    kind: Kind = "load-depth",
    *,
    x: str | int | None = None,
    y: str | int | None = None,
    time: str | int | None = None,
    units: Mapping[str, str] | None = None,
    reverse: Sequence[str] = (),
    **how: Any,
) -> Data:
    """Reads a curve from a text file with one point per line.

    Args:
        path: path of the file.
        kind: "load-depth", "history" or "imprint".
        x: title or number, from 1, of the column of x; None: by its title ("depth", "displacement"), otherwise the
            first.
        y: column of y; None: by its title ("load", "force", "height"), otherwise the second.
        time: column of the time; None: by its title, if it has one.
        units: units in the file, {"x": "um", "y": "mN", "time": "s"}; without them those of the titles, otherwise SI.
        reverse: "x", "y": columns with the opposite sign.
        how: further fields of `Data`.

    Raises:
        InputError: the file, a column or a unit is wrong.
    """
    table = TextTable.read(Path(path))
    given = dict(units or {})
    if wrong := sorted(given.keys() - {"x", "y", "time"}):
        raise InputError(f"{path}: units.{wrong[0]} is not known; allowed: x, y, time")
    if wrong := [one for one in reverse if one not in ("x", "y")]:
        raise InputError(f"{path}: reverse = {wrong[0]!r}; allowed: x, y")
    name = str(how.pop("name", Path(path).stem))
    columns = {
        "x": x if x is not None else table.has(*TITLES["x"].get(kind, ())) or 1,
        "y": y if y is not None else table.has(*TITLES["y"].get(kind, ())) or 2,
    }
    if columns["x"] == columns["y"]:
        raise InputError(f"{path}: x and y are both column {columns['x']!r}; allowed: two columns")
    values: dict[str, Any] = {
        axis: table.column(columns[axis], given.get(axis), unit)
        for axis, unit in zip(("x", "y"), units_of(kind, how.get("columns", ())), strict=True)
    }
    for axis in reverse:
        values[axis] = -values[axis]
    when = time if time is not None else table.has("time", "zeit")
    if when is not None and when not in columns.values():
        values["time"] = table.column(when, given.get("time"), "s")
    return Data(kind=kind, name=name, **values, **how)
