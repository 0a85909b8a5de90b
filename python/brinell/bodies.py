# SPDX-License-Identifier: BSD-3-Clause
"""The bodies of a scenario: what they are where they touch, what lies on their surfaces, what they are made of.

Lengths are in m, or text with a unit such as "3.85 mm". The fields are the keys of the case file
(docs/reference/case-file.md), which says what they mean and which values are allowed.
"""

from __future__ import annotations

from dataclasses import dataclass, fields
from typing import Any, ClassVar, Protocol, TypeAlias

from brinell.errors import InputError

__all__ = [
    "Berkovich",
    "Body",
    "Bump",
    "Cone",
    "Cylinder",
    "Dent",
    "Ellipsoid",
    "Flat",
    "Quantity",
    "Shape",
    "Sphere",
    "Vickers",
]

Quantity: TypeAlias = float | str
"""A number in SI, or text with a unit."""


class Part(Protocol):
    """Something that knows its table in a case file."""

    def to_case(self) -> dict[str, Any]:
        """As nested dictionaries."""
        ...


class _Typed:
    """A table of the case file: its type and the fields of a dataclass."""

    type: ClassVar[str]

    def to_case(self) -> dict[str, Any]:
        """As nested dictionaries."""
        return {"type": self.type} | {f.name: getattr(self, f.name) for f in fields(self)}  # type: ignore[arg-type]


class Shape(_Typed):
    """Shape of a surface near the point where it touches."""


@dataclass(frozen=True)
class Sphere(Shape):
    """A sphere, as the paraboloid r^2/(2 radius)."""

    type: ClassVar[str] = "sphere"
    radius: Quantity


@dataclass(frozen=True)
class Ellipsoid(Shape):
    """Two radii of curvature at the apex, in the planes x z and y z."""

    type: ClassVar[str] = "ellipsoid"
    radius_x: Quantity
    radius_y: Quantity


@dataclass(frozen=True)
class Cylinder(Shape):
    """A roller with its axis along y and plane ends."""

    type: ClassVar[str] = "cylinder"
    radius: Quantity
    length: Quantity


@dataclass(frozen=True)
class Cone(Shape):
    """A cone; the angle is that between axis and flank, in degrees."""

    type: ClassVar[str] = "cone"
    half_angle: float
    tip_radius: Quantity = 0.0


@dataclass(frozen=True)
class Vickers(Shape):
    """A pyramid of four faces at 68 degrees to the axis, one of them facing x."""

    type: ClassVar[str] = "vickers"
    tip_radius: Quantity = 0.0


@dataclass(frozen=True)
class Berkovich(Shape):
    """A pyramid of three faces at 65.27 degrees to the axis, one of them facing x."""

    type: ClassVar[str] = "berkovich"
    tip_radius: Quantity = 0.0


@dataclass(frozen=True)
class Flat(Shape):
    """A plane."""

    type: ClassVar[str] = "flat"


@dataclass(frozen=True)
class Dent(_Typed):
    """A dent with its shoulder: depth 10^(-10 (r/radius)^2) cos(2 pi r/radius)."""

    type: ClassVar[str] = "dent"
    depth: Quantity
    radius: Quantity
    x: Quantity = 0.0
    y: Quantity = 0.0


@dataclass(frozen=True)
class Bump(_Typed):
    """A dent upside down."""

    type: ClassVar[str] = "bump"
    height: Quantity
    radius: Quantity
    x: Quantity = 0.0
    y: Quantity = 0.0


@dataclass(frozen=True)
class Body:
    """One of the two bodies.

    Args:
        shape: where it touches.
        material: `brinell.Material` or `brinell.RIGID`.
        texture: what lies on its surface: `Dent`, `Bump` or `brinell.HeightMap`; None: smooth.
    """

    shape: Shape
    material: Part
    texture: Part | None = None

    def __post_init__(self) -> None:
        for name, allowed in (
            ("shape", "a shape such as brinell.Sphere('1 mm')"),
            ("material", "a brinell.Material, or brinell.RIGID"),
            ("texture", "brinell.Dent, Bump or HeightMap, or None"),
        ):
            part = getattr(self, name)
            if isinstance(part, type) or not (hasattr(part, "to_case") or (part is None and name == "texture")):
                raise InputError(f"{name} = {part!r} of a body; allowed: {allowed}")

    def to_case(self) -> dict[str, Any]:
        """As nested dictionaries."""
        tables = {"shape": self.shape.to_case(), "material": self.material.to_case()}
        return tables if self.texture is None else tables | {"texture": self.texture.to_case()}
