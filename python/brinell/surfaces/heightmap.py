# SPDX-License-Identifier: BSD-3-Clause
"""Height maps of surfaces: make, read, prepare, look at, put onto a body.

    dent = brinell.surfaces.read("dent.xyz").levelled().cropped(x=(-1e-4, 1e-4))
    case = brinell.Case.from_file("case.toml").with_values({"lower.texture": dent.to_case()})

    rough = brinell.surfaces.random("1 mm", 512, rms_height="0.5 um", rolloff="200 um", cutoff="16 um")
    print(rough.Sq, rough.Sdq, rough.Sku)

Files of measuring instruments are read by SurfaceTopography (pip install "brinell[surfaces]").
"""

from __future__ import annotations

import re
import tomllib
import zipfile
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from brinell import _core
from brinell._arrays import require_unmasked
from brinell.errors import InputError, IoError, MissingExtraError

__all__ = ["HeightMap", "PowerSpectrum", "random", "read", "sampled", "write"]

FloatArray = NDArray[np.float64]

_TEXT = (".csv", ".txt", ".dat")
"""Endings of text files of heights as texture.file of a case takes them."""
_LARGEST_TEXT = 100_000_000
"""Bytes, as of all texts that a case names."""


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
        spacing: distances dx, dy of the points [m].
        x: centre of the map on the body's surface [m].
        y: the same along y [m].
        periodic: whether the map covers the surface, again and again, with the periods nx dx and ny dy, instead of
            being zero outside.
    """

    heights: FloatArray
    spacing: tuple[float, float]
    x: float = 0.0
    y: float = 0.0
    periodic: bool = False

    def __post_init__(self) -> None:
        require_unmasked(self.heights, "the height map")
        heights = np.array(self.heights, dtype=np.float64)
        if heights.ndim != 2 or heights.size == 0:
            raise InputError(f"heights have the shape {heights.shape}; allowed: [ny, nx] with one point or more")
        bad = int(np.count_nonzero(~np.isfinite(heights)))
        if bad > 0:
            raise InputError(f"{bad} of {heights.size} heights are not finite: fill what was not measured")
        spacing = tuple(float(d) for d in np.atleast_1d(self.spacing))
        if len(spacing) != 2 or not all(np.isfinite(d) and d > 0 for d in spacing):
            raise InputError(f"the spacing is {self.spacing}; allowed: (dx, dy), both > 0, in m")
        heights.setflags(write=False)
        object.__setattr__(self, "heights", heights)
        object.__setattr__(self, "spacing", spacing)

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
        to_metre = _metres(_one_unit(topography.unit, unit))
        if fill and topography.has_undefined_data:
            topography = topography.interpolate_undefined_data_with_harmonic_function()
        # Its first index runs along x, its second along y.
        heights = np.ma.filled(np.ma.asarray(topography.heights(), dtype=np.float64), np.nan).T * to_metre
        dx, dy = topography.pixel_size
        return cls(heights, (dx * to_metre, dy * to_metre))

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
        return {
            "type": "height_map",
            "heights": self.heights.ravel().tolist(),
            "columns": self.heights.shape[1],
            "spacing": list(self.spacing),
            "x": self.x,
            "y": self.y,
            "periodic": self.periodic,
        }


def random(
    size: float | str | Sequence[float | str],
    points: int | Sequence[int],
    *,
    cutoff: float | str,
    rms_height: float | str | None = None,
    rms_slope: float | None = None,
    hurst: float = 0.8,
    rolloff: float | str | None = None,
    seed: int = 0,
) -> HeightMap:
    """A Gaussian, isotropic, self-affine surface, by the code that a texture of type "random" is made by.

    Heights are those of `brinell.RandomSurface` at the points: more points show the same surface. Lengths in m, or text
    with a unit such as "10 um".

    Args:
        size: period and longest wavelength, along x and y if they differ.
        points: how many, along x and y if they differ; their distances divide the size.
        cutoff: shortest wavelength.
        rms_height: root mean square of the height over a period; or
        rms_slope: that of the gradient's length. One of the two.
        hurst: exponent of Hurst, 0 to 1.
        rolloff: wavelength above which waves are not higher any more; None: self-affine up to the size.
        seed: other numbers give other surfaces.

    Returns:
        A periodic map around x = y = 0.

    Raises:
        InputError: something is out of range.
    """
    sizes = [_length(s) for s in ([size] if isinstance(size, str | int | float) else size)]
    counts = [int(n) for n in ([points] if isinstance(points, int) else points)]
    if len(sizes) not in (1, 2) or len(counts) not in (1, 2):
        raise InputError(f"size = {size!r}, points = {points!r}; allowed: one for both axes, or two")
    if not 0 <= seed < 2**63:
        raise InputError(f"seed = {seed}; allowed: 0 to 2^63 - 1")
    (size_x, size_y), (nx, ny) = (sizes[0], sizes[-1]), (counts[0], counts[-1])
    heights = _core.random_heights(
        (size_x, size_y),
        (nx, ny),
        _length(cutoff),
        None if rms_height is None else _length(rms_height),
        rms_slope,
        hurst,
        None if rolloff is None else _length(rolloff),
        seed,
    )
    return HeightMap(heights, (size_x / nx, size_y / ny), periodic=True)


def _length(value: float | str) -> float:
    return _core.length(value) if isinstance(value, str) else float(value)


def sampled(
    height: Callable[[float, float], float],
    spacing: Sequence[float],
    *,
    x: tuple[float, float],
    y: tuple[float, float],
) -> HeightMap:
    """A texture from a function of x and y.

    The function itself could not be stored with a result or taken up by another process; its heights can.

    Args:
        height: of the surface at a place (x, y) on the body, out of it positive; all in m.
        spacing: (dx, dy), distances of the points [m]: as fine as the cells or finer; made a little smaller to fit into
            the intervals.
        x: from, to [m]; outside, the surface is smooth, so the heights should fade to zero towards the ends.
        y: the same along y.

    Raises:
        InputError: the intervals are empty, or the function gives something that is no finite number.
    """
    distances = _pair(spacing)
    axes, steps = [], []
    for name, (start, end), distance in (("x", x, distances[0]), ("y", y, distances[1])):
        if not (np.isfinite([start, end]).all() and start < end and distance > 0):
            raise InputError(
                f"{name} = ({start}, {end}) with points every {distance} m; allowed: from < to, spacing > 0"
            )
        axes.append(np.linspace(start, end, 1 + int(np.ceil((end - start) / distance - 1e-9))))
        steps.append(float(axes[-1][1] - axes[-1][0]))
    heights = np.empty((len(axes[1]), len(axes[0])))
    for j, at_y in enumerate(axes[1].tolist()):
        for i, at_x in enumerate(axes[0].tolist()):
            value = height(at_x, at_y)
            try:
                heights[j, i] = value
            except (TypeError, ValueError) as error:
                raise InputError(f"the height at x = {at_x} m, y = {at_y} m is {value!r}; allowed: a number") from error
            if not np.isfinite(heights[j, i]):
                raise InputError(f"the height at x = {at_x} m, y = {at_y} m is {value!r}; allowed: finite numbers")
    return HeightMap(heights, (steps[0], steps[1]), 0.5 * (x[0] + x[1]), 0.5 * (y[0] + y[1]))


def read(
    path: str | Path, *, spacing: Sequence[float] | None = None, unit: str | None = None, fill: bool = False
) -> HeightMap:
    """Reads a height map.

    Args:
        path: .npz as `write` makes it; .npy with heights [ny, nx]; .csv, .txt, .dat with a line per row, as
            texture.file of a case; of any other ending what SurfaceTopography reads.
        spacing: (dx, dy) [m]; needed where the file has none: .npy, and text that neither `write` has made nor has
            the header of Gwyddion.
        unit: of the heights, as "um", where the file tells none: text is in m otherwise, .npy and .npz always; in an
            instrument's file of the places as well.
        fill: replace points that the instrument has not measured by a smooth surface (harmonic) through their
            neighbours.

    Returns:
        The heights in m; an instrument's map has its first row at the smallest y.

    Raises:
        InputError: spacing or unit are missing, or the content is no height map.
        MissingExtraError: SurfaceTopography is needed and not installed.
        IoError: the file cannot be read.
    """
    path = Path(path)
    if not path.is_file():
        raise IoError(f"{path}: no such file")
    ending = path.suffix.lower()
    try:
        if ending in (".npz", ".npy") and unit is not None:
            raise InputError(f"holds heights in m; leave out unit = {unit!r}")
        if ending == ".npz":
            return _from_npz(path)
        if ending == ".npy":
            return HeightMap(_loaded(path), _needed(spacing, path))
        if ending in _TEXT:
            return _from_text(path, spacing, unit)
        return _from_instrument(path, spacing, unit, fill)
    except InputError as error:
        raise InputError(f"{path}: {error}") from error


def write(path: str | Path, heightmap: HeightMap) -> None:
    """Writes a height map.

    Args:
        path: .npz, .csv, .txt and .dat hold all of it, the text as texture.file of a case, which takes the heights
            alone and not the first lines; .npy the heights alone.
        heightmap: what to write.

    Raises:
        InputError: the ending is another one.
        IoError: the file cannot be written.
    """
    path = Path(path)
    ending = path.suffix.lower()
    try:
        if ending == ".npz":
            centre = (heightmap.x, heightmap.y)
            np.savez(
                path,
                heights=heightmap.heights,
                spacing=heightmap.spacing,
                centre=centre,
                periodic=heightmap.periodic,
            )
        elif ending == ".npy":
            np.save(path, heightmap.heights)
        elif ending in _TEXT:
            lines = [f"# {name} = {value}" for name, value in _head(heightmap).items()]
            lines += [",".join(map(repr, row)) for row in heightmap.heights.tolist()]
            path.write_text("\n".join(lines) + "\n", encoding="utf-8")
        else:
            raise InputError(f"{path}: cannot write {ending!r}; allowed: .npz, .npy, {', '.join(_TEXT)}")
    except OSError as error:
        raise IoError(f"{path}: cannot be written: {error}") from error


def _hann(count: int) -> FloatArray:
    """Hann's window of a period."""
    return np.asarray(np.sin(np.pi * (np.arange(count) + 0.5) / count) ** 2)


def _head(heightmap: HeightMap) -> dict[str, str]:
    """What a text has before its heights, as TOML."""
    dx, dy = heightmap.spacing
    periodic = "true" if heightmap.periodic else "false"
    return {"spacing": f"[{dx!r}, {dy!r}]", "x": repr(heightmap.x), "y": repr(heightmap.y), "periodic": periodic}


def _centred(count: int, distance: float) -> FloatArray:
    return np.asarray((np.arange(count) - 0.5 * (count - 1)) * distance, dtype=np.float64)


def _inside(name: str, axis: FloatArray, interval: tuple[float, float]) -> tuple[slice, float]:
    """Points of an axis in the interval, and their middle. A point on the edge counts in spite of round-off."""
    slack = 1e-9 * (axis[1] - axis[0]) if len(axis) > 1 else 0.0
    inside = np.flatnonzero((axis >= interval[0] - slack) & (axis <= interval[1] + slack))
    if len(inside) == 0:
        raise InputError(f"no point has {name} in {interval} m; the map reaches from {axis[0]:.4g} to {axis[-1]:.4g} m")
    return slice(inside[0], inside[-1] + 1), float(0.5 * (axis[inside[0]] + axis[inside[-1]]))


def _needed(spacing: Sequence[float] | None, path: Path) -> tuple[float, float]:
    if spacing is None:
        raise InputError(f"a {path.suffix} file has no spacing; give spacing=(dx, dy) in m")
    return _pair(spacing)


def _pair(values: ArrayLike) -> tuple[float, float]:
    pair = np.asarray(values, dtype=np.float64)
    if pair.shape != (2,):
        raise InputError(f"{values!r}; allowed: two numbers, for x and y")
    return float(pair[0]), float(pair[1])


def _loaded(path: Path) -> Any:
    try:
        return np.load(path)
    except (EOFError, OSError, ValueError, zipfile.BadZipFile) as error:
        raise InputError(f"is no file of NumPy arrays of numbers, or damaged ({error})") from error


def _from_npz(path: Path) -> HeightMap:
    with _loaded(path) as file:
        missing = [name for name in ("heights", "spacing") if name not in file]
        if missing:
            raise InputError(f"holds no {' and no '.join(missing)}, only {', '.join(file) or 'nothing'}")
        x, y = _pair(file["centre"]) if "centre" in file else (0.0, 0.0)
        periodic = bool(file["periodic"]) if "periodic" in file else False
        return HeightMap(file["heights"], _pair(file["spacing"]), x, y, periodic)


_METRES = {"m": 1.0, "cm": 1e-2, "mm": 1e-3, "um": 1e-6, "µm": 1e-6, "μm": 1e-6, "nm": 1e-9, "pm": 1e-12, "Å": 1e-10}


def _metres(unit: str) -> float:
    """What a unit of length is in m."""
    if unit not in _METRES:
        raise InputError(f"unit = {unit!r} is no unit of length; allowed: {', '.join(_METRES)}")
    return _METRES[unit]


def _one_unit(told: str | None, given: str | None) -> str:
    """That of a file or object, or the one given because it tells none."""
    if told is not None and given is not None:
        raise InputError(f"tells its unit, {told}; leave out unit = {given!r}")
    unit = told or given
    if unit is None:
        raise InputError("tells no unit; give it, as unit='um'")
    return unit


def _from_text(path: Path, spacing: Sequence[float] | None, unit: str | None) -> HeightMap:
    """Heights in m or in `unit`, after the lines of `write` or the header of Gwyddion, if there are some."""
    if path.stat().st_size > _LARGEST_TEXT:
        raise InputError(f"is too large; allowed: up to {_LARGEST_TEXT / 1e6:.0f} MB of text, or a .npy file")
    text = path.read_text(encoding="utf-8-sig", errors="replace")
    header = dict(_GWYDDION.findall(text))
    heights = _numbers(text) * _metres(_one_unit(header.get("Value units"), unit) if header or unit else "m")
    if spacing is None and {"Width", "Height"} <= header.keys():
        width, height = (_size_of_header(header[name]) for name in ("Width", "Height"))
        return HeightMap(heights, (width / heights.shape[1], height / heights.shape[0]))
    told = _told(text)
    x, y = (float(told[name]) if isinstance(told.get(name), int | float) else 0.0 for name in ("x", "y"))
    given = spacing if spacing is not None else told.get("spacing")
    return HeightMap(heights, _needed(given, path), x, y, told.get("periodic") is True)


def _told(text: str) -> dict[str, Any]:
    """What the lines of `write` before the heights tell; what is given wins over it."""
    head = re.findall(r"^#\s*((?:spacing|x|y|periodic)\s*=.*)$", text[:1000], flags=re.MULTILINE)
    try:
        return tomllib.loads("\n".join(head))
    except tomllib.TOMLDecodeError:  # somebody's own remark
        return {}


_GWYDDION = re.compile(r"^#\s*(Width|Height|Value units):\s*(.*?)\s*$", re.MULTILINE)
"""Lines of its header: "# Width: 100 µm"."""


def _size_of_header(text: str) -> float:
    """In m, of "100 µm"."""
    number, _, unit = text.replace("\N{NO-BREAK SPACE}", " ").partition(" ")
    try:
        return float(number) * _metres(unit.strip())
    except ValueError as error:
        raise InputError(f"has the size {text!r} in its header; allowed: a length, as '100 um'") from error


def _numbers(text: str) -> FloatArray:
    """As the case reader does: numbers between commas, semicolons, tabs or blanks; # begins a comment line."""
    text = text.translate(str.maketrans(",;\t", "   "))
    rows: list[list[float]] = []
    for number, line in enumerate(text.splitlines(), start=1):
        if not line.strip() or line.lstrip().startswith("#"):
            continue
        try:
            rows.append([float(word) for word in line.split()])
        except ValueError as error:
            raise InputError(f"line {number} is {line[:40]!r}; allowed: heights") from error
        if len(rows[-1]) != len(rows[0]):
            raise InputError(f"line {number} has {len(rows[-1])} heights; the first row has {len(rows[0])}")
    if not rows:
        raise InputError("has no heights")
    return np.array(rows)


def _from_instrument(path: Path, spacing: Sequence[float] | None, unit: str | None, fill: bool) -> HeightMap:
    try:
        from SurfaceTopography import read_topography
        from SurfaceTopography.Exceptions import ReadFileError
    except ModuleNotFoundError as error:
        raise MissingExtraError(f"{path}: a map of this format", "SurfaceTopography", "surfaces") from error
    try:
        topography = read_topography(str(path))
    except ReadFileError as error:
        raise InputError("has no format that SurfaceTopography knows, or is damaged") from error
    heightmap = HeightMap.from_topography(topography, unit=unit, fill=fill)
    return heightmap if spacing is None else HeightMap(heightmap.heights, _pair(spacing))
