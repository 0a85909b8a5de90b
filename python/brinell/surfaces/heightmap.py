# SPDX-License-Identifier: BSD-3-Clause
"""Heights on a grid of points, and their roughness parameters."""

from __future__ import annotations

import warnings
from dataclasses import InitVar, dataclass, replace
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import NDArray

from brinell import _core
from brinell._arrays import require_unmasked
from brinell._names import level_of_caller
from brinell.errors import InputError
from brinell.surfaces.filling import filled, gap_message
from brinell.surfaces.units import metres, one_unit, pair

FloatArray = NDArray[np.float64]

REMEDY = (
    "fill what was not measured, as surfaces.read(file, fill=True), brinell surface convert --fill or "
    "surfaces.filled(heights) do by a smooth surface, or numpy.nan_to_num(heights, nan=0.0) by zero"
)
"""What to do about gaps; follows the message about them."""
_SPACING = "allowed: (dx, dy), both > 0, in m or with a unit as '1 um'; or one length for both"
_STEEPEST, _HIGHEST = 10.0, 1.0
"""Limits of the rms slope, and of the rms height relative to the map's size, that no measured surface exceeds."""


@dataclass(frozen=True, eq=False)
class PowerSpectrum:
    """Power spectral density of the heights, the mean over all directions: C(q) = |h(q)|^2/area.

    h(q) is the integral of h exp(-i q r) over the area (convention of Jacobs, Junge and Pastewka 2017). The integral of
    C over the plane of wavevectors, divided by 4 pi^2, is the mean square height; that of q^2 C is the mean square
    slope.

    Attributes:
        wavenumber: (rings,) mean wavenumber 2 pi/wavelength of each ring of wavevectors [rad/m], ascending.
        density: (rings,) mean density over each ring [m^4].
        count: (rings,) number of wavevectors in each ring.
    """

    wavenumber: FloatArray
    density: FloatArray
    count: NDArray[np.int64]


@dataclass(frozen=True, eq=False, repr=False)
class HeightMap:
    """Heights on a rectangular grid of points.

    Attributes:
        heights: [ny, nx] heights, positive out of the body [m].
        spacing: distances (dx, dy) of the points [m]; the argument may also be text with a unit, or one value for both.
        x: coordinate along x of the centre of the map on the body's surface [m].
        y: coordinate along y of the centre [m].
        periodic: whether the map is repeated with the periods nx dx and ny dy; otherwise the height is zero outside.
        unit: unit in which the argument `heights` is given, such as "um" (argument only).

    Raises:
        InputError: the heights are not a finite, two-dimensional array, or spacing or unit is invalid.
    """

    heights: FloatArray
    spacing: tuple[float, float]
    x: float = 0.0
    y: float = 0.0
    periodic: bool = False
    unit: InitVar[str] = "m"

    def __post_init__(self, unit: str) -> None:
        require_unmasked(self.heights, "the height map")
        heights = np.array(self.heights, dtype=np.float64) * metres(unit)
        if heights.ndim != 2 or heights.size == 0:
            raise InputError(f"heights have the shape {heights.shape}; allowed: [ny, nx] with one point or more")
        if (gaps := gap_message(heights)) is not None:
            raise InputError(f"{gaps}: {REMEDY}")
        try:
            spacing = pair(self.spacing)
        except (TypeError, ValueError) as error:
            raise InputError(f"the spacing is {self.spacing!r}; {_SPACING}") from error
        if not all(np.isfinite(d) and d > 0 for d in spacing):
            raise InputError(f"the spacing is {self.spacing}; {_SPACING}")
        heights.setflags(write=False)
        object.__setattr__(self, "heights", heights)
        object.__setattr__(self, "spacing", spacing)
        self._warn_of_units()

    def _warn_of_units(self) -> None:
        """Warns of implausibly large heights and slopes, which are a sign of heights in nm or um taken as m."""
        if self.Sq <= _HIGHEST * max(self.size) and self.Sdq <= _STEEPEST:
            return
        from brinell.case import CaseWarning

        warnings.warn(
            f"the height map has a root mean square height of {self.Sq:.3g} m and slope of {self.Sdq:.3g} on "
            f"{self.size[0]:.3g} x {self.size[1]:.3g} m: is a unit missing? Heights and spacing are in m; "
            "surfaces.read(file, unit='um') takes heights in another unit",
            CaseWarning,
            stacklevel=level_of_caller(),
        )

    @classmethod
    def from_topography(cls, topography: Any, *, unit: str | None = None, fill: bool = False) -> HeightMap:
        """Converts a topography of the package SurfaceTopography.

        Args:
            topography: two-dimensional topography on a regular grid.
            unit: unit of heights and coordinates, such as "um", if the topography has none. A periodic topography
                becomes a periodic map.
            fill: replace points that were not measured by a smooth, harmonic surface through their neighbours.

        Raises:
            InputError: the topography is not such a map, or its unit is missing or given twice.
        """
        if getattr(topography, "dim", None) != 2 or not topography.is_uniform:
            raise InputError("is a line scan, or not on a regular grid; allowed: a map of heights")
        to_metre = metres(one_unit(topography.unit, unit))
        # The first index of a topography runs along x, the second along y.
        heights = np.ma.filled(np.ma.asarray(topography.heights(), dtype=np.float64), np.nan).T * to_metre
        dx, dy = topography.pixel_size
        whole = filled(heights) if fill else heights
        return cls(whole, (dx * to_metre, dy * to_metre), periodic=bool(topography.is_periodic))

    @classmethod
    def of_part(cls, part: Any) -> Any:
        """Converts a topography of SurfaceTopography that is used as a texture; other objects are returned unchanged.

        Raises:
            InputError: the topography cannot be converted, see `from_topography`.
        """
        if not (hasattr(part, "pixel_size") and callable(getattr(part, "heights", None))):
            return part
        try:
            return cls.from_topography(part)
        except InputError as error:
            raise InputError(
                f"a {type(part).__name__} of SurfaceTopography as texture: {error}; brinell.HeightMap.from_topography "
                "takes unit and fill"
            ) from error

    def __repr__(self) -> str:
        ny, nx = self.heights.shape
        return f"<HeightMap {nx} x {ny} points every {self.spacing[0]:g} x {self.spacing[1]:g} m, Sz = {self.Sz:g} m>"

    @property
    def x_axis(self) -> FloatArray:
        """[nx] coordinates of the points on the body's surface along x [m]."""
        return self.x + _centred(self.heights.shape[1], self.spacing[0])

    @property
    def y_axis(self) -> FloatArray:
        """[ny] coordinates of the points on the body's surface along y [m]."""
        return self.y + _centred(self.heights.shape[0], self.spacing[1])

    def levelled(self) -> HeightMap:
        """Map without its least-squares plane; the mean height is then 0."""
        ny, nx = self.heights.shape
        x, y = _centred(nx, self.spacing[0]), _centred(ny, self.spacing[1])
        # On a grid centred at 0 the terms 1, x and y are orthogonal.
        plane = np.full((ny, nx), self.heights.mean())
        if nx > 1:
            plane += x * (self.heights.mean(axis=0) @ x / (x @ x))
        if ny > 1:
            plane += (y * (self.heights.mean(axis=1) @ y / (y @ y)))[:, None]
        return replace(self, heights=self.heights - plane)

    def cropped(self, x: tuple[float, float] | None = None, y: tuple[float, float] | None = None) -> HeightMap:
        """Part of the map in a rectangle; it keeps its position on the body.

        Args:
            x: interval (from, to) along x [m]; None: all.
            y: interval along y [m]; None: all.

        Raises:
            InputError: the rectangle contains no point.
        """
        columns, new_x = (slice(None), self.x) if x is None else _inside("x", self.x_axis, x)
        rows, new_y = (slice(None), self.y) if y is None else _inside("y", self.y_axis, y)
        is_all = x is None and y is None
        return HeightMap(self.heights[rows, columns], self.spacing, new_x, new_y, self.periodic and is_all)

    def joined(self, strip: float | str) -> HeightMap:
        """Periodic map whose ends are blended into each other; level the map first.

        Along each axis the map becomes shorter by the width of a strip, in which the two ends are blended. The squares
        of the weights sum to one, so that the rms height of uncorrelated roughness is preserved.

        Args:
            strip: width of the strip [m], or text with a unit such as "10 um"; several times the longest wavelength, up
                to half of the map.

        Raises:
            InputError: the strip is narrower than one point, or wider than half of the map.
        """
        width = pair((strip, strip))[0]
        heights = self.heights - self.heights.mean()
        for axis, (spacing, count) in enumerate(zip(self.spacing[::-1], self.heights.shape, strict=True)):
            points = round(width / spacing)
            if count > 1 and not 1 <= points <= count // 2:
                raise InputError(
                    f"ends joined over {width:g} m, {points} of {count} points; allowed: one point to half of the map"
                )
            if count > 1:
                heights = _faded(heights, points, axis)
        return HeightMap(heights, self.spacing, self.x, self.y, periodic=True)

    @property
    def size(self) -> tuple[float, float]:
        """Size of the map along x and y, number of points times spacing [m]."""
        return self.heights.shape[1] * self.spacing[0], self.heights.shape[0] * self.spacing[1]

    @property
    def Sa(self) -> float:
        """Arithmetic mean height about the plane z = mean [m] (ISO 25178-2); level the map first."""
        return float(np.abs(self.heights - self.heights.mean()).mean())

    @property
    def Sq(self) -> float:
        """Root mean square height [m] (ISO 25178-2); level the map first."""
        return float(self.heights.std())

    @property
    def Sz(self) -> float:
        """Maximum height, from the deepest pit to the highest peak [m] (ISO 25178-2)."""
        return float(np.ptp(self.heights))

    @property
    def Ssk(self) -> float:
        """Skewness: mean cube of the height over Sq^3 (ISO 25178-2); 0 if symmetric, nan if flat."""
        return self._moment(3)

    @property
    def Sku(self) -> float:
        """Kurtosis: mean fourth power of the height over Sq^4 (ISO 25178-2); 3 if Gaussian, nan if flat."""
        return self._moment(4)

    def _moment(self, power: int) -> float:
        heights = self.heights - self.heights.mean()
        return float((heights**power).mean() / self.Sq**power) if self.Sq > 0.0 else np.nan

    @property
    def Sk(self) -> float:
        """Core height: drop of the straight line through the core of the bearing-area curve [m] (ISO 25178-2)."""
        return self._bearing[0]

    @property
    def Spk(self) -> float:
        """Reduced peak height above the core [m] (ISO 25178-2)."""
        return self._bearing[1]

    @property
    def Svk(self) -> float:
        """Reduced valley depth below the core [m] (ISO 25178-2)."""
        return self._bearing[2]

    @property
    def Smr1(self) -> float:
        """Material ratio at which the core begins, 0 to 1 (ISO 25178-2)."""
        return self._bearing[3]

    @property
    def Smr2(self) -> float:
        """Material ratio at which the core ends, 0 to 1 (ISO 25178-2)."""
        return self._bearing[4]

    @cached_property
    def _bearing(self) -> tuple[float, float, float, float, float]:
        """(Sk, Spk, Svk, Smr1, Smr2), by the same engine function as for surfaces in sliding."""
        return _core.bearing(self.heights)

    @property
    def Sdq(self) -> float:
        """Root mean square of the gradient's magnitude [-] (ISO 25178-2), by differences of neighbours."""
        return float(
            np.sqrt(sum((self._difference(axis) ** 2).mean() for axis in (0, 1) if self.heights.shape[axis] > 1))
        )

    @property
    def rms_curvature(self) -> float:
        """Root mean square of the mean curvature, half of the Laplacian [1/m], by differences of neighbours.

        The outermost points of a map that is not periodic are left out; NaN with fewer than 3 points along an axis.
        """
        if min(self.heights.shape) < 3:
            return np.nan
        h, (dx, dy) = self.heights, self.spacing
        laplacian = (np.roll(h, 1, 1) - 2.0 * h + np.roll(h, -1, 1)) / dx**2
        laplacian += (np.roll(h, 1, 0) - 2.0 * h + np.roll(h, -1, 0)) / dy**2
        inner = laplacian if self.periodic else laplacian[1:-1, 1:-1]
        return float(0.5 * np.sqrt((inner**2).mean()))

    def _difference(self, axis: int) -> FloatArray:
        """Slopes between neighbours along y (axis 0) or x (axis 1)."""
        distance = self.spacing[1 - axis]
        if self.periodic:
            return np.asarray((np.roll(self.heights, -1, axis) - self.heights) / distance)
        return np.asarray(np.diff(self.heights, axis=axis) / distance)

    def power_spectrum(self) -> PowerSpectrum:
        """Power spectral density, averaged over rings of wavevectors as wide as the smallest wavenumber.

        A map that is not periodic is multiplied by a Hann window, which distorts the two longest waves; level it first.

        Raises:
            InputError: the map has fewer than 4 points along an axis.
        """
        ny, nx = self.heights.shape
        if min(nx, ny) < 4:
            raise InputError(f"a power spectral density of {nx} x {ny} points; allowed: 4 or more along both axes")
        heights = self.heights - self.heights.mean()
        if not self.periodic:
            window = np.outer(_hann(ny), _hann(nx))
            heights = heights * window / np.sqrt((window**2).mean())
        dx, dy = self.spacing
        density = np.abs(np.fft.fft2(heights)) ** 2 * (dx * dy / (nx * ny))
        q = np.hypot(2 * np.pi * np.fft.fftfreq(nx, dx), 2 * np.pi * np.fft.fftfreq(ny, dy)[:, None])
        step = 2 * np.pi / min(self.size)
        most = np.pi / max(dx, dy)
        ring = np.rint(q / step).astype(np.int64)
        inside = (ring > 0) & (q <= most * (1 + 1e-9))
        count = np.bincount(ring[inside])
        used = count > 0
        sums = [np.bincount(ring[inside], weights=values[inside])[used] / count[used] for values in (q, density)]
        return PowerSpectrum(sums[0], sums[1], count[used])

    def bearing_area(self) -> tuple[FloatArray, FloatArray]:
        """Bearing-area curve (Abbott and Firestone): fraction of the area at or above a height.

        Returns:
            (nx ny,) fraction of the area, 0 to 1, and (nx ny,) height above the mean [m], from the highest point down.
        """
        heights = np.sort(self.heights - self.heights.mean(), axis=None)[::-1]
        return (np.arange(heights.size) + 0.5) / heights.size, heights

    def to_case(self) -> dict[str, Any]:
        """Table `texture` of a case file, including the heights."""
        heights = {"heights": self.heights.ravel().tolist(), "columns": self.heights.shape[1]}
        return self.settings() | heights

    def settings(self) -> dict[str, Any]:
        """Table `texture` of a case file, without the heights."""
        return {
            "type": "height_map",
            "spacing": list(self.spacing),
            "x": self.x,
            "y": self.y,
            "periodic": self.periodic,
        }


def _faded(heights: FloatArray, points: int, axis: int) -> FloatArray:
    """Heights without the last `points` along an axis, which are blended into the first ones."""
    rows = np.moveaxis(heights, axis, 0)
    angle = 0.5 * np.pi * np.arange(points)[:, None] / points
    kept = rows[: len(rows) - points].copy()
    kept[:points] = np.sin(angle) * rows[:points] + np.cos(angle) * rows[len(rows) - points :]
    return np.moveaxis(kept, 0, axis)


def _hann(count: int) -> FloatArray:
    """Periodic Hann window."""
    return np.asarray(np.sin(np.pi * (np.arange(count) + 0.5) / count) ** 2)


def _centred(count: int, distance: float) -> FloatArray:
    return np.asarray((np.arange(count) - 0.5 * (count - 1)) * distance, dtype=np.float64)


def _inside(name: str, axis: FloatArray, interval: tuple[float, float]) -> tuple[slice, float]:
    """Points of an axis in an interval, and their middle. A tolerance includes points on the edge despite rounding."""
    slack = 1e-9 * (axis[1] - axis[0]) if len(axis) > 1 else 0.0
    inside = np.flatnonzero((axis >= interval[0] - slack) & (axis <= interval[1] + slack))
    if len(inside) == 0:
        raise InputError(f"no point has {name} in {interval} m; the map reaches from {axis[0]:.4g} to {axis[-1]:.4g} m")
    return slice(inside[0], inside[-1] + 1), float(0.5 * (axis[inside[0]] + axis[inside[-1]]))
