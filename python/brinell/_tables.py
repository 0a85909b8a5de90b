# SPDX-License-Identifier: BSD-3-Clause
"""Base classes of the tables of a case, whose fields tools/render_python.py takes from the schema."""

from __future__ import annotations

from dataclasses import fields
from typing import Any, ClassVar, TypeAlias

from brinell._values import plain

__all__ = ["CaseTable", "DentOrBump", "Hardening", "Quantity", "Shape", "Softening", "Texture"]

Quantity: TypeAlias = float | str
"""A number in SI, or text with a unit."""


class CaseTable:
    """A dataclass whose fields are the keys of a table of the case file; it may also have a type or a law."""

    def to_case(self) -> dict[str, Any]:
        """The table of the case file as a dictionary, without fields that are None."""
        values = {name: getattr(type(self), name) for name in ("type", "law") if name in vars(type(self))}
        values |= {field.name: getattr(self, field.name) for field in fields(self)}  # type: ignore[arg-type]
        return {name: value for name, value in values.items() if value is not None}


class Shape(CaseTable):
    """Base class of the shapes of a surface near the point of first contact."""

    type: ClassVar[str]


class Texture(CaseTable):
    """Base class of the textures of a surface that are given by numbers."""

    type: ClassVar[str]


class DentOrBump(Texture):
    """Base class of dent and bump, of which one number may be given without its name: the second one was the radius."""

    _retired: ClassVar[dict[str, str]] = {
        "radius": "edge_radius is the radius at which the surface is crossed; the earlier radius was the wavelength of "
        "the profile: edge_radius = 0.25 x radius"
    }


class Hardening(CaseTable):
    """A hardening law: the yield stress as a function of the equivalent plastic strain."""

    law: ClassVar[str]

    def to_case(self) -> dict[str, Any]:
        """The table `material.hardening` of the case file."""
        table: dict[str, Any] = plain(super().to_case())
        return table


class Softening(CaseTable):
    """Thermal softening: a factor on the yield stress as a function of temperature.

    The factor is at least 0.01, also above the melting temperature. Temperatures are in deg C, or text such as
    "293.15 K". Back stresses are not softened.
    """

    law: ClassVar[str]

    def to_case(self) -> dict[str, Any]:
        """The table `material.softening` of the case file."""
        table: dict[str, Any] = plain(super().to_case())
        return table
