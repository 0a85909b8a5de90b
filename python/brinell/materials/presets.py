# SPDX-License-Identifier: BSD-3-Clause
"""Materials whose constants a standard gives, with that standard."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from types import MappingProxyType

from brinell._names import did_you_mean
from brinell.errors import InputError
from brinell.materials.laws import Linear, Perfect
from brinell.materials.material import Material
from brinell.materials.thermal import Thermal

__all__ = ["PRESETS", "Preset", "preset"]


@dataclass(frozen=True)
class Preset:
    """A material of a name, and where its constants come from.

    Attributes:
        name: as in the standard.
        material: the constants, at 20 deg C.
        source: the standards, and what they say nothing of.
    """

    name: str
    material: Material
    source: str


def _structural_steel(grade: str, yield_stress: str) -> Preset:
    # EN 1993-1-5 allows a hardening of E / 100 in computations with finite elements.
    return Preset(
        grade,
        Material("210 GPa", 0.3, Linear(yield_stress, "2.1 GPa"), thermal=Thermal.carbon_steel()),
        "EN 1993-1-1:2005, table 3.1 (up to 40 mm thick; the least yield stress) and 3.2.6; hardening EN 1993-1-5:2006 "
        "C.6; heat EN 1993-1-2:2005, 3.4",
    )


_ALL = (
    _structural_steel("S235", "235 MPa"),
    _structural_steel("S275", "275 MPa"),
    _structural_steel("S355", "355 MPa"),
    Preset(
        "1.4301",
        Material("200 GPa", 0.3, Perfect("210 MPa"), thermal=Thermal.stainless_steel()),
        "AISI 304; EN 1993-1-4:2006, 2.1 (hot rolled; the least 0.2 % proof stress; its strong hardening is left out); "
        "heat EN 10088-1:2005, annex E",
    ),
    Preset(
        "EN AW-6082-T6",
        Material("70 GPa", 0.3, Perfect("260 MPa"), thermal=Thermal(191.0, 2700.0, 911.0, 23e-6)),
        "EN 1999-1-1:2007, 3.2.5 and table 3.2a (sheet up to 6 mm; the least 0.2 % proof stress; its hardening is left "
        "out); heat EN 1999-1-2:2007, 3.3",
    ),
    Preset(
        "bearing steel",
        Material("207 GPa", 0.3),
        "ISO/TS 16281:2008; elastic: how hardened steel yields depends on its heat treatment, and no standard says it",
    ),
)

PRESETS: Mapping[str, Preset] = MappingProxyType({one.name: one for one in _ALL})
"""The presets by name."""


def preset(name: str, thermal: bool = False) -> Material:
    """The material of a preset.

    Args:
        name: a key of `PRESETS`; small letters will do.
        thermal: with the thermal constants, which a case without heat warns of.

    Raises:
        InputError: there is no such preset.
    """
    for one in _ALL:
        if str(name).casefold() == one.name.casefold():
            return one.material if thermal else replace(one.material, thermal=None)
    raise InputError(f"there is no material {name!r}; {did_you_mean(name, PRESETS)}allowed: {', '.join(PRESETS)}")
