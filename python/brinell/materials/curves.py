# SPDX-License-Identifier: BSD-3-Clause
"""Measured stress-strain curves and the hardening curves that they become."""

from __future__ import annotations

import warnings
from collections.abc import Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import TYPE_CHECKING, Any, Literal

import numpy as np
from numpy.typing import NDArray

from brinell import _core
from brinell._names import level_of_caller
from brinell._tables import Quantity
from brinell.case import CaseWarning
from brinell.errors import InputError
from brinell.materials.hardening import Table

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

__all__ = ["MeasuredCurve"]

FloatArray = NDArray[np.float64]

_CURVE = "the curve "
_OF_CURVE = ("has ", "begins ", "reaches ")
"""Beginnings of messages that continue a sentence about the curve."""


def _si(value: Quantity, unit: str, name: str) -> float:
    """The number, or the number of a text with a unit, in SI."""
    if not isinstance(value, str):
        return float(value)
    try:
        return _core.quantity_like(value, unit)
    except InputError as error:
        raise InputError(f"{name} = {error}") from None


def _values(values: Sequence[float] | FloatArray, name: str) -> FloatArray:
    array = np.ascontiguousarray(values, dtype=np.float64)
    if array.ndim != 1:
        raise InputError(f"{name} has {array.ndim} axes; allowed: one, with a value per point")
    return array


@dataclass(frozen=True, eq=False)
class MeasuredCurve:
    """A measured stress-strain curve, and the hardening curve that it becomes.

    Unloading, repeated strains and what follows the largest force are left out; scatter of up to 2 % is levelled.
    `notes` says what was done. The keywords are those of `material.hardening` in a case file.

    Attributes:
        strain: measured strains in the order of the measurement [-].
        stress: measured stresses [Pa].
        young_modulus: Young's modulus, > 0 [Pa], for the elastic strains.
        strain_type: whether the strains are "total" or "plastic".
        measure: whether strains and stresses are "true" values, or "engineering" ones (per initial length and area).
        test: "tension", "compression", or "automatic": compression if strains and stresses are below 0.
        yield_from: where the material begins to yield: at the "offset", by a "fit" of a law beyond it, or at the
            "first_point"; None: "offset" for total and "first_point" for plastic strains.
        yield_offset: plastic strain of `yield_from`, in (0, 1) or as "0.2 %".
        elastic_slope: whether the elastic strains follow from the "young_modulus", or from the slope and the zero of
            the "curve" itself.
        monotone: whether a stress below an earlier one by more than scatter is raised to it; otherwise that is an
            error.
        table: the hardening curve, as the law of a material.
        loading: true strains [-] and true stresses [Pa] of the points that were used.
        slope: slope of the elastic part of the curve [Pa]; None if too few points are there.
        zero: strain at which the elastic part begins [-]; other than 0 only with `elastic_slope="curve"`.
        notes: what was done, one line each.
        warnings: what is doubtful; these texts are also given as `CaseWarning`.

    Raises:
        InputError: the curve cannot become a hardening curve; the text says why, and what to do.
    """

    strain: FloatArray
    stress: FloatArray
    young_modulus: Quantity | None = None
    strain_type: Literal["total", "plastic"] = "total"
    measure: Literal["true", "engineering"] = "true"
    test: Literal["automatic", "tension", "compression"] = "automatic"
    yield_from: Literal["offset", "fit", "first_point"] | None = None
    yield_offset: Quantity = 0.002
    elastic_slope: Literal["young_modulus", "curve"] = "young_modulus"
    monotone: bool = False
    table: Table = field(init=False)
    loading: tuple[FloatArray, FloatArray] = field(init=False)
    slope: float | None = field(init=False)
    zero: float = field(init=False)
    notes: tuple[str, ...] = field(init=False)
    warnings: tuple[str, ...] = field(init=False)

    def __post_init__(self) -> None:
        strain, stress = _values(self.strain, "strain"), _values(self.stress, "stress")
        modulus = None if self.young_modulus is None else _si(self.young_modulus, "Pa", "young_modulus")
        if modulus is not None and not modulus > 0.0:
            raise InputError(f"young_modulus = {self.young_modulus!r} is out of range; allowed: above 0")
        names = ("strain_type", "measure", "test", "yield_from", "elastic_slope")
        words = {name: str(word) for name in names if (word := getattr(self, name)) is not None}
        offset = _si(self.yield_offset, "", "yield_offset")
        try:
            made = _core.hardening_curve(strain, stress, words, offset, modulus, self.monotone)
        except InputError as error:
            text = str(error)
            raise InputError(f"{_CURVE}{text}" if text.startswith(_OF_CURVE) else text) from None
        values: dict[str, Any] = {
            "strain": strain,
            "stress": stress,
            "table": Table(made.plastic_strain, made.stress),
            "loading": tuple(map(np.array, made.loading)),
            "slope": made.slope,
            "zero": made.zero,
            "notes": tuple(made.notes),
            "warnings": tuple(made.warnings),
        }
        for name, value in values.items():
            object.__setattr__(self, name, value)
        for text in self.warnings:
            warnings.warn(f"the curve: {text}", CaseWarning, stacklevel=level_of_caller())

    @classmethod
    def from_file(
        cls, path: str | Path, *, unit: str = "Pa", strain: Literal["1", "%"] = "1", **how: Any
    ) -> MeasuredCurve:
        """Reads a curve from a text file with strain and stress of one point per line, as `Table.from_file` does.

        Args:
            path: path of the file.
            unit: unit of the stresses in the file, such as "MPa".
            strain: unit of the strains in the file, "1" or "%".
            how: keywords of `MeasuredCurve`, such as young_modulus="210 GPa", measure="engineering".

        Raises:
            InputError: the file, a unit or the curve is invalid.
        """
        if strain not in ("1", "%"):
            raise InputError(f'strain = "{strain}" is not known; allowed: "1" or "%"')
        _si(f"1 {unit}", "Pa", "unit")
        try:
            strains, stresses = _core.read_curve(Path(path), strain, unit, how.get("strain_type", "total"))
        except InputError as error:
            raise InputError(f"{path} {error}") from None
        try:
            return cls(np.array(strains), np.array(stresses), **how)
        except InputError as error:
            text = str(error)
            raise InputError(f"{path} {text.removeprefix(_CURVE)}" if text.startswith(_CURVE) else text) from None

    @property
    def yield_stress(self) -> float:
        """Yield stress before any plastic strain [Pa]."""
        return float(self.table.stress[0])

    @property
    def plastic_strain(self) -> FloatArray:
        """Plastic strains of the hardening curve, from 0 [-]."""
        return np.array(self.table.plastic_strain)

    @property
    def flow_stress(self) -> FloatArray:
        """Yield stresses at these plastic strains [Pa]."""
        return np.array(self.table.stress, dtype=np.float64)

    def plot(self, *, ax: Axes | None = None) -> Figure:
        """Draws the measured curve and the hardening curve; see `brinell.plot.measured_curve`."""
        from brinell.plot.curves import measured_curve

        return measured_curve(self, ax=ax)

    def __repr__(self) -> str:
        points = len(self.table.stress)
        return (
            f"MeasuredCurve({self.strain.size} points, yield stress {self.yield_stress:.4g} Pa, {points} points kept)"
        )
