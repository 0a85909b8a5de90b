# SPDX-License-Identifier: BSD-3-Clause
"""Heights on a grid of points, and what they amount to."""

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
from brinell.surfaces.filling import filled, told_gaps
from brinell.surfaces.units import metres, one_unit, pair

FloatArray = NDArray[np.float64]

_SPACING = "allowed: (dx, dy), both > 0, in m or with a unit as '1 um'; or one length for both"
_STEEPEST, _HIGHEST = 10.0, 1.0
"""Root mean square slope, and height over the map's extent, that no measured surface has."""


@dataclass(frozen=True, eq=False)
class PowerSpectrum:
    """Power spectral density of the heights, the mean over all directions: C(q) = |h(q)|^2/area.

    h(q) is the integral of h exp(-i q r) over the area (convention of Jacobs, Junge and Pastewka 2017). The mean square
    height is the integral of C over the plane of wavevectors, over 4 pi^2; with a factor q^2, that of the slope.

    Attributes:
        wavenumber: mean of those in each ring [rad/m], ascending, 2 pi over the wavelength.
        density: mean over each ring [m^4].
        count: wavevectors in each ring.
    """

    wavenumber: FloatArray
    density: FloatArray
    count: NDArray[np.int64]


@dataclass(frozen=True, eq=False, repr=False)
class HeightMap:
    """Heights on a rectangular grid of points.

    Attributes:
        heights: [ny, nx], in m, out of the body positive.
        spacing: distances dx, dy of the points [m]; given as such, as text with a unit, or one for both.
        x: centre of the map on the body's surface [m].
        y: the same along y [m].
        periodic: whether the map covers the surface, again and again, with the periods nx dx and ny dy, instead of
            being zero outside.
        unit: in which the heights are given here, as "um".
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
        if (gaps := told_gaps(heights)) is not None:
            raise InputError(
                f"{gaps}: fill what was not measured, as surfaces.read(file, fill=True), brinell surface convert --fill"
                " or surfaces.filled(heights) do by a smooth surface, or numpy.nan_to_num(heights, nan=0.0) by zero"
            )
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
        """Heights in nm or um that are taken for m make walls and towers."""
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
        """A map of SurfaceTopography.

        Args:
            topography: two-dimensional, on a regular grid.
            unit: of heights and places, as "um", if it tells none.
            fill: replace points that were not measured by a smooth surface (harmonic) through their neighbours.

        Raises:
            InputError: it is no such map, or its unit is missing or told twice.
        """
        if getattr(topography, "dim", None) != 2 or not topography.is_uniform:
            raise InputError("is a line scan, or not on a regular grid; allowed: a map of heights")
        to_metre = metres(one_unit(topography.unit, unit))
        # Its first index runs along x, its second along y.
        heights = np.ma.filled(np.ma.asarray(topography.heights(), dtype=np.float64), np.nan).T * to_metre
        dx, dy = topography.pixel_size
        return cls(filled(heights) if fill else heights, (dx * to_metre, dy * to_metre))

    @classmethod
    def of_part(cls, part: Any) -> Any:
        """What can be a texture: a map of SurfaceTopography as one of ours, all else as it is.

        Raises:
            InputError: as `from_topography`.
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
        """Places of the points on the body's surface along x, [nx] in m."""
        return self.x + _centred(self.heights.shape[1], self.spacing[0])

    @property
    def y_axis(self) -> FloatArray:
        """Places of the points on the body's surface along y, [ny] in m."""
        return self.y + _centred(self.heights.shape[0], self.spacing[1])

    def levelled(self) -> HeightMap:
        """Without the plane that fits best (least squares); the mean height is then 0."""
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
        """The part whose points lie in an interval; it stays where it is on the body.

        Args:
            x: from, to [m]; None: all.
            y: the same along y.

        Raises:
            InputError: no point lies there.
        """
        columns, new_x = (slice(None), self.x) if x is None else _inside("x", self.x_axis, x)
        rows, new_y = (slice(None), self.y) if y is None else _inside("y", self.y_axis, y)
        is_all = x is None and y is None
        return HeightMap(self.heights[rows, columns], self.spacing, new_x, new_y, self.periodic and is_all)

    def joined(self, strip: float | str) -> HeightMap:
        """A periodic map whose ends go over into each other; level the map before.

        Along each axis the map gets shorter by a strip: there its two ends, which then lie on each other, fade over,
        with weights whose squares add up to one, so that the height of what is not correlated is kept.

        Args:
            strip: its width [m], or with a unit as "10 um"; several of the longest waves, up to half of the map.

        Raises:
            InputError: less than one point, or more than half of the map.
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
        """Along x and y, a spacing for each point [m]."""
        return self.heights.shape[1] * self.spacing[0], self.heights.shape[0] * self.spacing[1]

    @property
    def Sa(self) -> float:
        """Arithmetic mean height about the mean plane z = mean [m] (ISO 25178-2); level the map before."""
        return float(np.abs(self.heights - self.heights.mean()).mean())

    @property
    def Sq(self) -> float:
        """Root mean square height [m] (ISO 25178-2); level the map before."""
        return float(self.heights.std())

    @property
    def Sz(self) -> float:
        """Maximum height: highest peak to deepest pit [m] (ISO 25178-2)."""
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
        """Core height: by how much the line through the core of the bearing-area curve falls [m] (ISO 25178-2)."""
        return self._bearing[0]

    @property
    def Spk(self) -> float:
        """Reduced height of the peaks that stand out of the core [m] (ISO 25178-2)."""
        return self._bearing[1]

    @property
    def Svk(self) -> float:
        """Reduced depth of the valleys below the core [m] (ISO 25178-2)."""
        return self._bearing[2]

    @property
    def Smr1(self) -> float:
        """Share of the area at which the core begins, 0 to 1 (ISO 25178-2)."""
        return self._bearing[3]

    @property
    def Smr2(self) -> float:
        """Share of the area at which the core ends, 0 to 1 (ISO 25178-2)."""
        return self._bearing[4]

    @cached_property
    def _bearing(self) -> tuple[float, float, float, float, float]:
        """What the core computes of the bearing-area curve, the same as of surfaces that slide."""
        return _core.bearing(self.heights)

    @property
    def Sdq(self) -> float:
        """Root mean square slope, of the length of the gradient (ISO 25178-2), by differences of neighbours."""
        return float(
            np.sqrt(sum((self._difference(axis) ** 2).mean() for axis in (0, 1) if self.heights.shape[axis] > 1))
        )

    @property
    def rms_curvature(self) -> float:
        """Root mean square of the mean curvature, half of the Laplacian [1/m], by differences of neighbours.

        Without a period the outermost points have no curvature and are left out.
        """
        if min(self.heights.shape) < 3:
            return np.nan
        h, (dx, dy) = self.heights, self.spacing
        laplacian = (np.roll(h, 1, 1) - 2.0 * h + np.roll(h, -1, 1)) / dx**2
        laplacian += (np.roll(h, 1, 0) - 2.0 * h + np.roll(h, -1, 0)) / dy**2
        inner = laplacian if self.periodic else laplacian[1:-1, 1:-1]
        return float(0.5 * np.sqrt((inner**2).mean()))

    def _difference(self, axis: int) -> FloatArray:
        """Slopes between neighbours along y (0) or x (1)."""
        distance = self.spacing[1 - axis]
        if self.periodic:
            return np.asarray((np.roll(self.heights, -1, axis) - self.heights) / distance)
        return np.asarray(np.diff(self.heights, axis=axis) / distance)

    def power_spectrum(self) -> PowerSpectrum:
        """Power spectral density over rings of wavevectors, each as wide as the smallest wavenumber.

        A map without a period is multiplied by Hann's window, which costs the two longest waves: level it before.
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
        """Curve of Abbott and Firestone: which share of the area lies at that height or above.

        Returns:
            The share, 0 to 1, and the height above the mean [m], from the highest point down.
        """
        heights = np.sort(self.heights - self.heights.mean(), axis=None)[::-1]
        return (np.arange(heights.size) + 0.5) / heights.size, heights

    def to_case(self) -> dict[str, Any]:
        """The texture table of a case file, with the heights themselves."""
        heights = {"heights": self.heights.ravel().tolist(), "columns": self.heights.shape[1]}
        return self.settings() | heights

    def settings(self) -> dict[str, Any]:
        """The texture table of a case file, without the heights."""
        return {
            "type": "height_map",
            "spacing": list(self.spacing),
            "x": self.x,
            "y": self.y,
            "periodic": self.periodic,
        }


def _faded(heights: FloatArray, points: int, axis: int) -> FloatArray:
    """Without as many points at the end, which fade out over those at the beginning."""
    rows = np.moveaxis(heights, axis, 0)
    angle = 0.5 * np.pi * np.arange(points)[:, None] / points
    kept = rows[: len(rows) - points].copy()
    kept[:points] = np.sin(angle) * rows[:points] + np.cos(angle) * rows[len(rows) - points :]
    return np.moveaxis(kept, 0, axis)


def _hann(count: int) -> FloatArray:
    """Hann's window of a period."""
    return np.asarray(np.sin(np.pi * (np.arange(count) + 0.5) / count) ** 2)


def _centred(count: int, distance: float) -> FloatArray:
    return np.asarray((np.arange(count) - 0.5 * (count - 1)) * distance, dtype=np.float64)


def _inside(name: str, axis: FloatArray, interval: tuple[float, float]) -> tuple[slice, float]:
    """Points of an axis in the interval, and their middle. A point on the edge counts in spite of round-off."""
    slack = 1e-9 * (axis[1] - axis[0]) if len(axis) > 1 else 0.0
    inside = np.flatnonzero((axis >= interval[0] - slack) & (axis <= interval[1] + slack))
    if len(inside) == 0:
        raise InputError(f"no point has {name} in {interval} m; the map reaches from {axis[0]:.4g} to {axis[-1]:.4g} m")
    return slice(inside[0], inside[-1] + 1), float(0.5 * (axis[inside[0]] + axis[inside[-1]]))
