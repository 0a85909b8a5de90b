# SPDX-License-Identifier: BSD-3-Clause
"""The bodies of a scenario: shape near the contact, texture of the surface, and material.

Lengths are in m, or text with a unit such as "3.85 mm". The fields are the keys of the case file;
docs/reference/case-file.md explains them and lists the allowed values.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field, fields
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
    """Object that can be written as a table of a case file."""

    def to_case(self) -> dict[str, Any]:
        """The table as nested dictionaries."""
        ...


class _Typed:
    """Dataclass whose type and fields are a table of the case file."""

    type: ClassVar[str]

    def to_case(self) -> dict[str, Any]:
        """The table of the case file as a dictionary, without fields that are None."""
        values = {f.name: getattr(self, f.name) for f in fields(self)}  # type: ignore[arg-type]
        return {"type": self.type} | {name: value for name, value in values.items() if value is not None}


class Shape(_Typed):
    """Base class of the shapes of a surface near the point of first contact."""


@dataclass(frozen=True)
class Sphere(Shape):
    """A sphere, approximated by the paraboloid r^2/(2 radius).

    At a distance r from the apex the sphere is higher by a share of about (r/(2 radius))^2: 1 % at r = 0.2 radius.
    """

    type: ClassVar[str] = "sphere"
    radius: Quantity


@dataclass(frozen=True)
class Ellipsoid(Shape):
    """A surface with two radii of curvature at the apex, in the planes xz and yz.

    A negative radius is a concave surface, such as the groove of a raceway; the gap between both bodies must be convex.
    """

    type: ClassVar[str] = "ellipsoid"
    radius_x: Quantity
    radius_y: Quantity


@dataclass(frozen=True)
class Cylinder(Shape):
    """A roller with its axis along y and plane ends; the length is not needed on a grid that is periodic along y."""

    type: ClassVar[str] = "cylinder"
    radius: Quantity
    length: Quantity | None = None


@dataclass(frozen=True)
class Cone(Shape):
    """A cone; `half_angle` is the angle between axis and flank, in degrees or as text with a unit, "1.2 rad"."""

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


# By name only: the second argument without a name was the radius.
_RADIUS_OF_DENTS = {
    "radius": "edge_radius is the radius at which the surface is crossed; the earlier radius was the wavelength of the "
    "profile: edge_radius = 0.25 x radius"
}


@dataclass(frozen=True)
class Dent(_Typed):
    """A dent with a raised shoulder, centred at (x, y): depth 10^(-10 (r/w)^2) cos(2 pi r/w) with w = 4 edge_radius.

    Attributes:
        depth: at the centre.
        edge_radius: radius at which the dent crosses the undisturbed surface, half of the diameter that is read from a
            profile at its level. Half of the depth is at half of this radius, the crest of the shoulder, 4 % of the
            depth high, at 1.26 times this radius.
        x: of the centre.
        y: of the centre.
    """

    type: ClassVar[str] = "dent"
    _retired: ClassVar[dict[str, str]] = _RADIUS_OF_DENTS
    depth: Quantity
    edge_radius: Quantity = field(kw_only=True)
    x: Quantity = field(default=0.0, kw_only=True)
    y: Quantity = field(default=0.0, kw_only=True)


@dataclass(frozen=True)
class Bump(_Typed):
    """A bump of the shape of an inverted `Dent`, centred at (x, y)."""

    type: ClassVar[str] = "bump"
    _retired: ClassVar[dict[str, str]] = _RADIUS_OF_DENTS
    height: Quantity
    edge_radius: Quantity = field(kw_only=True)
    x: Quantity = field(default=0.0, kw_only=True)
    y: Quantity = field(default=0.0, kw_only=True)


@dataclass(frozen=True)
class Sinusoid(_Typed):
    """A wavy surface: height amplitude cos(2 pi (X - x)/wavelength_x) cos(2 pi (Y - y)/wavelength_y) at (X, Y).

    Along an axis whose wavelength is None the height is constant.
    """

    type: ClassVar[str] = "sinusoid"
    amplitude: Quantity
    wavelength_x: Quantity | None = None
    wavelength_y: Quantity | None = None
    x: Quantity = 0.0
    y: Quantity = 0.0


@dataclass(frozen=True)
class RandomSurface(_Typed):
    """Random roughness: Gaussian, isotropic, self-affine between two wavelengths.

    The power spectral density is constant for wavelengths above `rolloff`, falls as q^(-2 (1 + hurst)) from there to
    `cutoff`, where q is the wavenumber, and is zero for shorter waves. The surface depends neither on the cell size nor
    on the machine. `brinell.surfaces.random` computes the heights.

    Args:
        cutoff: shortest wavelength.
        rms_height: root mean square of the height over a period. Exactly one of `rms_height` and `rms_slope` is given.
        rms_slope: root mean square of the magnitude of the gradient [-].
        hurst: Hurst exponent [-].
        rolloff: wavelength above which the spectrum is constant; None: self-affine up to `size`.
        size: period along x and y, which is the longest wavelength; None: 8 rolloff.
        seed: seed of the random numbers; other seeds give other surfaces with the same spectrum.
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
        shape: shape near the point of first contact, such as `Sphere`.
        material: `brinell.Material` or `brinell.RIGID`.
        texture: heights added to the shape: `Dent`, `Bump`, `Sinusoid`, `RandomSurface`, `brinell.HeightMap` or a
            topography of the package SurfaceTopography, or a list of them, which are summed; None: smooth.

    Raises:
        InputError: shape, material or texture is of another type.
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
        """The tables of the body in the case file, as nested dictionaries."""
        tables: dict[str, Any] = {"shape": self.shape.to_case(), "material": self.material.to_case()}
        if self.texture is None:
            return tables
        if isinstance(self.texture, Sequence):
            return tables | {"texture": [part.to_case() for part in self.texture]}
        return tables | {"texture": self.texture.to_case()}

    def parts(self) -> dict[str, Any]:
        """Shape, material and texture as objects, so that a case can pass the heights of a map on without text."""
        return {"shape": self.shape, "material": self.material, "texture": self.texture}
