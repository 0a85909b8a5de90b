# SPDX-License-Identifier: BSD-3-Clause
"""The bodies of a scenario: what they are where they touch, what lies on their surfaces, what they are made of.

Lengths are in m, or text with a unit such as "3.85 mm". The fields are the keys of the case file
(docs/reference/case-file.md), which says what they mean and which values are allowed.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, fields
from typing import Any, ClassVar, Protocol, TypeAlias

from brinell.errors import InputError
from brinell.surfaces.heightmap import HeightMap

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
    "RandomSurface",
    "Shape",
    "Sinusoid",
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
        """As nested dictionaries, without what is not given."""
        values = {f.name: getattr(self, f.name) for f in fields(self)}  # type: ignore[arg-type]
        return {"type": self.type} | {name: value for name, value in values.items() if value is not None}


class Shape(_Typed):
    """Shape of a surface near the point where it touches."""


@dataclass(frozen=True)
class Sphere(Shape):
    """A sphere, as the paraboloid r^2/(2 radius)."""

    type: ClassVar[str] = "sphere"
    radius: Quantity


@dataclass(frozen=True)
class Ellipsoid(Shape):
    """Two radii of curvature at the apex, in the planes x z and y z; below 0 for a hollow, as the groove of a raceway.

    Both bodies together must be convex.
    """

    type: ClassVar[str] = "ellipsoid"
    radius_x: Quantity
    radius_y: Quantity


@dataclass(frozen=True)
class Cylinder(Shape):
    """A roller with its axis along y and plane ends; on a grid that is periodic along y it needs no length."""

    type: ClassVar[str] = "cylinder"
    radius: Quantity
    length: Quantity | None = None


@dataclass(frozen=True)
class Cone(Shape):
    """A cone; the angle is that between axis and flank, in degrees or with a unit, "1.2 rad"."""

    type: ClassVar[str] = "cone"
    half_angle: float | str
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
class Sinusoid(_Typed):
    """Waves: the height amplitude cos(2 pi (X - x)/wavelength_x) cos(2 pi (Y - y)/wavelength_y) at (X, Y).

    Along an axis without a wavelength there are no waves.
    """

    type: ClassVar[str] = "sinusoid"
    amplitude: Quantity
    wavelength_x: Quantity | None = None
    wavelength_y: Quantity | None = None
    x: Quantity = 0.0
    y: Quantity = 0.0


@dataclass(frozen=True)
class RandomSurface(_Typed):
    """Roughness: Gaussian, isotropic, self-affine between two wavelengths, the same for any cells and on any machine.

    Its power spectral density is constant down to the wavelength `rolloff`, falls as q^(-2 (1 + hurst)) from there to
    `cutoff` and is zero for shorter waves. The heights themselves: `brinell.surfaces.random`.

    Args:
        cutoff: shortest wavelength.
        rms_height: root mean square of the height over a period; or
        rms_slope: that of the gradient's length. One of the two.
        hurst: exponent of Hurst.
        rolloff: wavelength above which waves are not higher any more; None: self-affine up to the size.
        size: (along x, along y), period and longest wavelength; None: 8 rolloff.
        seed: other numbers give other surfaces of the same spectrum.
    """

    type: ClassVar[str] = "random"
    cutoff: Quantity
    rms_height: Quantity | None = None
    rms_slope: float | None = None
    hurst: float = 0.8
    rolloff: Quantity | None = None
    size: Sequence[Quantity] | None = None
    seed: int = 0


@dataclass(frozen=True)
class Body:
    """One of the two bodies.

    Args:
        shape: where it touches.
        material: `brinell.Material` or `brinell.RIGID`.
        texture: what lies on its surface: `Dent`, `Bump`, `Sinusoid`, `RandomSurface`, `brinell.HeightMap` or a map of
            SurfaceTopography, or a list of them, which add up; None: smooth.
    """

    shape: Shape
    material: Part
    texture: Part | Sequence[Part] | Any | None = None

    def __post_init__(self) -> None:
        if isinstance(self.material, Shape) or hasattr(self.shape, "young_modulus"):
            raise InputError(
                f"shape = {self.shape!r} and material = {self.material!r} of a body: the shape comes first, as in "
                "brinell.Body(brinell.Sphere('1 mm'), steel)"
            )
        texture = self.texture
        if isinstance(texture, list | tuple):
            object.__setattr__(self, "texture", [HeightMap.of_part(part) for part in texture])
        else:
            object.__setattr__(self, "texture", HeightMap.of_part(texture))
        for name, allowed in (
            ("shape", "a shape such as brinell.Sphere('1 mm')"),
            ("material", "a brinell.Material, or brinell.RIGID"),
            (
                "texture",
                "brinell.Dent, Bump, Sinusoid, RandomSurface or HeightMap, a list, a SurfaceTopography, or None",
            ),
        ):
            given = getattr(self, name)
            several = name == "texture" and isinstance(given, list | tuple)
            for part in given if several else [given]:
                is_smooth = name == "texture" and given is None
                if isinstance(part, type) or not (hasattr(part, "to_case") or is_smooth):
                    raise InputError(f"{name} = {part!r} of a body; allowed: {allowed}")

    def to_case(self) -> dict[str, Any]:
        """As nested dictionaries."""
        tables: dict[str, Any] = {"shape": self.shape.to_case(), "material": self.material.to_case()}
        if self.texture is None:
            return tables
        if isinstance(self.texture, Sequence):
            return tables | {"texture": [part.to_case() for part in self.texture]}
        return tables | {"texture": self.texture.to_case()}

    def parts(self) -> dict[str, Any]:
        """By their keys, as they are: a case takes the heights of a map without making text of them."""
        return {"shape": self.shape, "material": self.material, "texture": self.texture}
