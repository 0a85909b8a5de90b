# SPDX-License-Identifier: BSD-3-Clause
# Written by tools/render_python.py from the engine's schema; do not edit.
"""Shapes and textures of bodies."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import KW_ONLY, dataclass
from typing import ClassVar

from brinell._tables import DentOrBump, Quantity, Shape, Texture

__all__ = [
    "Berkovich",
    "Bump",
    "Cone",
    "Cylinder",
    "Dent",
    "Ellipsoid",
    "Flat",
    "RandomSurface",
    "Sinusoid",
    "Sphere",
    "Vickers",
]


@dataclass(frozen=True)
class Sphere(Shape):
    """Sphere: the paraboloid r^2/(2 radius).

    A share of about (r/(2 radius))^2 lower than a sphere, 1 % at r = 0.2 radius.

    Attributes:
        radius: Radius of the sphere or cylinder. In m, > 0.
    """

    type: ClassVar[str] = "sphere"
    radius: Quantity


@dataclass(frozen=True)
class Ellipsoid(Shape):
    """Ellipsoid: two radii of curvature at the apex, in the planes xz and yz.

    Attributes:
        radius_x: Radius of curvature at the apex in the plane x z; negative for a concave surface, such as a raceway
            along its track. The gap between both bodies must be convex. In m, other than 0.
        radius_y: Radius of curvature at the apex in the plane y z; negative for a concave surface, such as the groove
            of a ball bearing. In m, other than 0.
    """

    type: ClassVar[str] = "ellipsoid"
    radius_x: Quantity
    radius_y: Quantity


@dataclass(frozen=True)
class Cylinder(Shape):
    """Cylinder: a roller with its axis along y and plane ends.

    Attributes:
        radius: Radius of the sphere or cylinder. In m, > 0.
        length: Length of the cylinder, which has plane ends. Without a length the cylinder is infinite, for example in
            plane strain. In m, > 0; default: none, with a grid that is periodic along y.
    """

    type: ClassVar[str] = "cylinder"
    radius: Quantity
    length: Quantity | None = None


@dataclass(frozen=True)
class Cone(Shape):
    """Cone: straight flanks, and a tip that may be rounded.

    Attributes:
        half_angle: Angle between axis and flank of the cone, in degrees. Allowed: in (0, 90).
        tip_radius: Radius of the ball that rounds the tip, and the edges of a pyramid. In m, >= 0; default: 0.0.
    """

    type: ClassVar[str] = "cone"
    half_angle: Quantity
    tip_radius: Quantity = 0.0


@dataclass(frozen=True)
class Vickers(Shape):
    """Vickers: a pyramid of four faces at 68 degrees to the axis, one of them facing x.

    Attributes:
        tip_radius: Radius of the ball that rounds the tip, and the edges of a pyramid. In m, >= 0; default: 0.0.
    """

    type: ClassVar[str] = "vickers"
    tip_radius: Quantity = 0.0


@dataclass(frozen=True)
class Berkovich(Shape):
    """Berkovich: a pyramid of three faces at 65.27 degrees to the axis, one of them facing x.

    Attributes:
        tip_radius: Radius of the ball that rounds the tip, and the edges of a pyramid. In m, >= 0; default: 0.0.
    """

    type: ClassVar[str] = "berkovich"
    tip_radius: Quantity = 0.0


@dataclass(frozen=True)
class Flat(Shape):
    """Flat: a plane."""

    type: ClassVar[str] = "flat"


@dataclass(frozen=True)
class Dent(DentOrBump):
    """Dent: a dent with a raised shoulder, depth 10^(-10 (r/w)^2) cos(2 pi r/w) with w = 4 edge_radius.

    Attributes:
        depth: Depth of the dent's centre. In m, > 0.
        edge_radius: Radius at which a dent or a bump crosses the undisturbed surface, half of the diameter that is read
            from a profile at its level. Half of the depth is at half of this radius, the crest of the shoulder, 4 % of
            the depth high, at 1.26 times this radius. In m, > 0.
        x: Position of the centre on the body's surface along x; for a sinusoid the position of a crest, for a periodic
            map with an even number of columns that of the column after the middle, which then lies on a column of
            cells. In m; default: 0.0.
        y: Position of the centre on the body's surface along y; for a sinusoid the position of a crest. In m; default:
            0.0.
    """

    type: ClassVar[str] = "dent"
    depth: Quantity
    _: KW_ONLY
    edge_radius: Quantity
    x: Quantity = 0.0
    y: Quantity = 0.0


@dataclass(frozen=True)
class Bump(DentOrBump):
    """Bump: a dent upwards.

    Attributes:
        height: Height of the bump's centre. In m, > 0.
        edge_radius: Radius at which a dent or a bump crosses the undisturbed surface, half of the diameter that is read
            from a profile at its level. Half of the depth is at half of this radius, the crest of the shoulder, 4 % of
            the depth high, at 1.26 times this radius. In m, > 0.
        x: Position of the centre on the body's surface along x; for a sinusoid the position of a crest, for a periodic
            map with an even number of columns that of the column after the middle, which then lies on a column of
            cells. In m; default: 0.0.
        y: Position of the centre on the body's surface along y; for a sinusoid the position of a crest. In m; default:
            0.0.
    """

    type: ClassVar[str] = "bump"
    height: Quantity
    _: KW_ONLY
    edge_radius: Quantity
    x: Quantity = 0.0
    y: Quantity = 0.0


@dataclass(frozen=True)
class Sinusoid(Texture):
    """Sinusoid: waves, amplitude cos(2 pi (X - x)/wavelength_x) cos(2 pi (Y - y)/wavelength_y) at X, Y.

    Attributes:
        amplitude: Height of the crests above the mean. In m.
        wavelength_x: Wavelength along x. In m, > 0; default: no waves along x.
        wavelength_y: Wavelength along y. In m, > 0; default: no waves along y.
        x: Position of the centre on the body's surface along x; for a sinusoid the position of a crest, for a periodic
            map with an even number of columns that of the column after the middle, which then lies on a column of
            cells. In m; default: 0.0.
        y: Position of the centre on the body's surface along y; for a sinusoid the position of a crest. In m; default:
            0.0.
    """

    type: ClassVar[str] = "sinusoid"
    amplitude: Quantity
    wavelength_x: Quantity | None = None
    wavelength_y: Quantity | None = None
    x: Quantity = 0.0
    y: Quantity = 0.0


@dataclass(frozen=True)
class RandomSurface(Texture):
    """Random surface: Gaussian roughness.

    Isotropic and self-affine, with a power spectral density that is constant for wavelengths above rolloff, falls as
    q^(-2 (1 + hurst)) with the wavenumber q from there to cutoff, and is zero for shorter waves.

    Attributes:
        cutoff: Shortest wavelength, independent of the cells; it should span at least eight cells. In m, > 0.
        rms_height: Root mean square of the height over a period. The surface is scaled to this value exactly. In m,
            >= 0; default: from rms_slope; not together with rms_slope.
        rms_slope: Root mean square of the magnitude of the gradient over a period. The surface is scaled to this value
            exactly. Allowed: >= 0; default: from rms_height; not together with rms_height.
        hurst: Hurst exponent; smaller values make short waves rougher. Allowed: in [0, 1]; default: 0.8.
        rolloff: Roll-off wavelength: for longer waves the power spectral density is constant. In m, > 0; default: none:
            self-affine up to the size.
        size: Period [along x, along y], which is the longest wavelength: up to 4096 times the cutoff. In m, > 0;
            default: grid.size along axes that are periodic, otherwise 8 rolloff.
        seed: Seed of the random numbers; different seeds give different surfaces with the same spectrum. The heights
            depend neither on the cells nor on the machine. Allowed: >= 0; default: 0.
    """

    type: ClassVar[str] = "random"
    cutoff: Quantity
    rms_height: Quantity | None = None
    rms_slope: float | None = None
    hurst: float = 0.8
    rolloff: Quantity | None = None
    size: Quantity | Sequence[Quantity] | None = None
    seed: int = 0
