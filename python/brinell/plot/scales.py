# SPDX-License-Identifier: BSD-3-Clause
"""Scales by which quantities are divided in figures, and the labels of their axes.

A complete run with a body that yields is drawn in units of its values at first yield, which the label gives in SI. If
these do not exist (elastic bodies, a pyramid, an unfinished run), and within `in_si`, the axis is in SI.
"""

from __future__ import annotations

import contextlib
from collections.abc import Iterator, Sequence
from contextvars import ContextVar
from dataclasses import astuple, dataclass
from typing import Literal

import numpy as np
from matplotlib.axes import Axes

from brinell.plot import style
from brinell.results import Run
from brinell.scenarios import SCENARIOS

__all__ = [
    "DEGREES",
    "PERCENT",
    "Scale",
    "Scales",
    "area_scale",
    "common_scales",
    "draws_si",
    "in_si",
    "si",
    "twin_axis",
]

_IN_SI: ContextVar[bool] = ContextVar("in_si", default=False)


@contextlib.contextmanager
def in_si() -> Iterator[None]:
    """Context in which figures are drawn in SI, µm and MPa, even if values at first yield exist.

    Example:
        >>> with brinell.plot.in_si():
        ...     figure = brinell.plot.section(run, run.snapshot("aligned"))
    """
    token = _IN_SI.set(True)
    try:
        yield
    finally:
        _IN_SI.reset(token)


def draws_si() -> bool:
    """Whether figures are drawn in SI."""
    return _IN_SI.get()


@dataclass(frozen=True)
class Scale:
    """A divisor and the texts for its axis."""

    size: float
    """What to divide the SI value by."""
    symbol: str
    """Symbol of the divisor (LaTeX), empty for SI."""
    unit: str
    """SI unit with its prefix, or that of the divisor without."""

    def label(self, name: str, symbol: str, *, value: bool = True) -> str:
        """Axis label: the quantity over its scale and the value of the scale, or the quantity and its unit.

        Args:
            name: in words; may be empty.
            symbol: LaTeX of the quantity.
            value: whether to say what the scale is worth.
        """
        head = f"{name}  " if name else ""
        if not self.symbol:
            return f"{head}${symbol}$  [{self.unit}]"
        note = f"    (${self.symbol}$ = {style.quantity(self.size, self.unit)})" if value else ""
        return f"{head}${symbol}/{self.symbol}${note}"


PERCENT = Scale(0.01, "", "%")
"""Of strains."""

DEGREES = Scale(1.0, "", "°C")
"""Of temperatures, which have no prefixes."""


def twin_axis(ax: Axes, which: Literal["x", "y"], drawn: Scale, other: Scale, symbol: str) -> None:
    """A second axis on the far side: the same quantity over another scale.

    Args:
        ax: drawn over `drawn`.
        which: axis to double.
        drawn: its scale.
        other: scale of the second axis; without a symbol (SI) there is nothing more to say, and no second axis.
        symbol: LaTeX of the quantity.
    """
    if not other.symbol:
        return
    ratio = drawn.size / other.size
    functions = (lambda value: value * ratio, lambda value: value / ratio)
    if which == "x":
        ax.secondary_xaxis("top", functions=functions).set_xlabel(other.label("", symbol))
    else:
        ax.secondary_yaxis("right", functions=functions).set_ylabel(other.label("", symbol))


def si(largest: float, unit: str) -> Scale:
    """SI with the prefix that suits the largest value [SI]."""
    for size, prefix in style.PREFIXES:
        if abs(largest) >= size:
            return Scale(size, "", f"{prefix}{unit}")
    return Scale(1.0, "", unit)


def area_scale(largest: float) -> Scale:
    """SI for areas up to a value [m^2], without a prefix, which would apply to the length and not to the area."""
    return Scale(1e-12, "", "µm²") if largest < 1e-7 else Scale(1e-6, "", "mm²")


class Scales:
    """Scales of one run; each takes the largest value to be drawn [SI], which only matters for SI axes."""

    def __init__(self, run: Run):
        normalised = run.complete and not draws_si()
        self._critical = run.critical if normalised and run.has_critical_values else None
        self._radius = run.equivalent_radius if normalised and SCENARIOS[run.scenario].abscissa else None

    @property
    def normalised(self) -> bool:
        """Whether values at first yield exist."""
        return self._critical is not None

    def radius(self, largest: float) -> Scale:
        """Scale of an abscissa of the history that is a length: the equivalent radius R."""
        return Scale(self._radius, "R", "m") if self._radius is not None else si(largest, "m")

    def length(self, largest: float) -> Scale:
        """Scale of lengths along the surface and of depths: a_c, for cylinders the half-width."""
        return Scale(self._critical.contact_radius, "a_c", "m") if self._critical else si(largest, "m")

    def displacement(self, largest: float) -> Scale:
        """Scale of displacements: alpha_c."""
        return Scale(self._critical.interference, r"\alpha_c", "m") if self._critical else si(largest, "m")

    def pressure(self, largest: float) -> Scale:
        """Scale of contact pressures: the peak pressure at first yield, p0_c."""
        return Scale(self._critical.peak_pressure, r"p_{0,c}", "Pa") if self._critical else si(largest, "Pa")

    def stress(self, largest: float) -> Scale:
        """Scale of stresses: the yield stress S_y."""
        return Scale(self._critical.yield_stress, "S_y", "Pa") if self._critical else si(largest, "Pa")

    def force(self, largest: float) -> Scale:
        """Scale of forces: P_c."""
        return Scale(self._critical.load, "P_c", "N") if self._critical else si(largest, "N")

    def energy(self, largest: float) -> Scale:
        """Scale of energies: U_c."""
        return Scale(self._critical.energy, "U_c", "J") if self._critical else si(largest, "J")

    def area(self, largest: float) -> Scale:
        """Scale of contact areas: A_c."""
        if self._critical:
            return Scale(self._critical.contact_area, "A_c", "m²")
        return Scale(1e-6, "", "mm²") if largest < 1.0 else Scale(1.0, "", "m²")


def common_scales(runs: Sequence[Run]) -> Scales | None:
    """Values at first yield, if all runs have the same."""
    if not all(run.complete and run.has_critical_values for run in runs):
        return None
    each = np.array([astuple(run.critical) for run in runs])
    return Scales(runs[0]) if np.allclose(each, each[0], rtol=1e-6, atol=0.0) else None
