# SPDX-License-Identifier: BSD-3-Clause
"""Thermal constants of a material, and tabulated thermal softening of its yield stress."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, fields
from functools import cached_property
from typing import Any, ClassVar

from brinell import _core
from brinell._tables import CaseTable, Quantity, Softening
from brinell._values import plain
from brinell.errors import InputError
from brinell.materials.checking import case_of

__all__ = ["SofteningTable", "Thermal"]


@dataclass(frozen=True)
class SofteningTable(Softening):
    """Tabulated factor: linear between points, constant outside them.

    Attributes:
        temperature: temperatures of the points, ascending [deg C], or text with a unit.
        factor: factors on the yield stress at these temperatures, > 0 [-].
    """

    law: ClassVar[str] = "table"
    temperature: Sequence[Quantity]
    factor: Sequence[float]

    def __post_init__(self) -> None:
        object.__setattr__(self, "temperature", tuple(plain(self.temperature)))
        object.__setattr__(self, "factor", tuple(plain(self.factor)))


@dataclass(frozen=True)
class Thermal(CaseTable):
    """Thermal constants of a body.

    Attributes:
        conductivity: thermal conductivity K, > 0 [W/(m K)].
        density: density rho, > 0 [kg/m^3].
        specific_heat: specific heat c, > 0 [J/(kg K)].
        expansion: coefficient of linear thermal expansion alpha [1/K]; it does not affect temperatures.
        temperature: bulk temperature [deg C], or text such as "293.15 K".

    Raises:
        InputError: a value or unit that the case file does not allow.
    """

    conductivity: Quantity
    density: Quantity
    specific_heat: Quantity
    expansion: Quantity = 0.0
    temperature: Quantity = 20.0

    def __post_init__(self) -> None:
        self._engine  # noqa: B018 (checks the values)

    @classmethod
    def carbon_steel(cls, temperature: Quantity = 20.0) -> Thermal:
        """Structural steel at 20 deg C (EN 1993-1-2:2005, section 3.4)."""
        return cls(53.3, 7850.0, 440.0, 12.2e-6, temperature)

    @classmethod
    def stainless_steel(cls, temperature: Quantity = 20.0) -> Thermal:
        """Austenitic steel 1.4301 (AISI 304) at 20 deg C (EN 10088-1:2005, annex E)."""
        return cls(15.0, 7900.0, 500.0, 16.0e-6, temperature)

    @property
    def diffusivity(self) -> float:
        """Thermal diffusivity K/(rho c) [m^2/s]."""
        return self._engine.diffusivity

    @cached_property
    def _engine(self) -> _core.Thermal:
        """The engine's object, validated and in SI units.

        Raises:
            InputError: a value or unit that the case file does not allow.
        """
        try:
            case = case_of({"young_modulus": 1e12, "poisson_ratio": 0.3, "thermal": self.to_case()})
        except InputError as error:
            raise InputError(str(error).replace("material.thermal.", "")) from None
        thermal = _core.lower_material(case).thermal
        assert thermal is not None
        return thermal

    def __getstate__(self) -> dict[str, Any]:
        return {field.name: getattr(self, field.name) for field in fields(self)}  # what is pickled: not the engine's
