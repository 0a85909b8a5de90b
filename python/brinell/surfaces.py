# SPDX-License-Identifier: BSD-3-Clause
"""Height maps of real surfaces: read, prepare, put onto a body.

    dent = brinell.surfaces.read("dent.xyz").levelled().cropped(x=(-1e-4, 1e-4))
    case = brinell.Case.from_file("case.toml").with_values({"lower.texture": dent.to_case()})

Files of measuring instruments are read by SurfaceTopography (pip install "brinell[surfaces]").
"""

from __future__ import annotations

import zipfile
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from brinell._arrays import require_unmasked
from brinell.errors import InputError, IoError

__all__ = ["HeightMap", "read", "sampled", "write"]

FloatArray = NDArray[np.float64]

_TEXT = (".csv", ".txt", ".dat")
"""Endings of text files of heights as texture.file of a case takes them."""
_LARGEST_TEXT = 100_000_000
"""Bytes, as of all texts that a case names."""


@dataclass(frozen=True, eq=False)
class HeightMap:
    """Heights on a rectangular grid of points.

    Attributes:
        heights: [ny, nx], in m, out of the body positive.
        spacing: distances dx, dy of the points [m].
        x: centre of the map on the body's surface [m].
        y: the same along y [m].
    """

    heights: FloatArray
    spacing: tuple[float, float]
    x: float = 0.0
    y: float = 0.0

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
        return HeightMap(self.heights[rows, columns], self.spacing, new_x, new_y)

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

    def to_case(self) -> dict[str, Any]:
        """The texture table of a case file, with the heights themselves."""
        return {
            "type": "height_map",
            "heights": self.heights.ravel().tolist(),
            "columns": self.heights.shape[1],
            "spacing": list(self.spacing),
            "x": self.x,
            "y": self.y,
        }


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
        spacing: (dx, dy) [m]; needed where the file has none, that is .npy and text.
        unit: of heights and places in an instrument's file that tells none, as "um".
        fill: replace points that the instrument has not measured by a smooth surface (harmonic) through their
            neighbours.

    Returns:
        The heights in m; an instrument's map has its first row at the smallest y.

    Raises:
        InputError: spacing or unit are missing, or the content is no height map.
        ImportError: SurfaceTopography is needed and not installed.
        IoError: the file cannot be read.
    """
    path = Path(path)
    if not path.is_file():
        raise IoError(f"{path}: no such file")
    ending = path.suffix.lower()
    try:
        if ending == ".npz":
            return _from_npz(path)
        if ending == ".npy":
            return HeightMap(_loaded(path), _needed(spacing, path))
        if ending in _TEXT:
            return HeightMap(_numbers(path), _needed(spacing, path))
        return _from_instrument(path, spacing, unit, fill)
    except InputError as error:
        raise InputError(f"{path}: {error}") from error


def write(path: str | Path, heightmap: HeightMap) -> None:
    """Writes a height map.

    Args:
        path: .npz holds all of it; .npy, .csv, .txt and .dat the heights alone, the text as texture.file of a case.
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
            np.savez(path, heights=heightmap.heights, spacing=heightmap.spacing, centre=centre)
        elif ending == ".npy":
            np.save(path, heightmap.heights)
        elif ending in _TEXT:
            lines = [",".join(map(repr, row)) for row in heightmap.heights.tolist()]
            path.write_text("\n".join(lines) + "\n", encoding="utf-8")
        else:
            raise InputError(f"{path}: cannot write {ending!r}; allowed: .npz, .npy, {', '.join(_TEXT)}")
    except OSError as error:
        raise IoError(f"{path}: cannot be written: {error}") from error


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
        return HeightMap(file["heights"], _pair(file["spacing"]), x, y)


def _numbers(path: Path) -> FloatArray:
    """As the case reader does: numbers between commas, semicolons, tabs or blanks; # begins a comment line."""
    if path.stat().st_size > _LARGEST_TEXT:
        raise InputError(f"is too large; allowed: up to {_LARGEST_TEXT / 1e6:.0f} MB of text, or a .npy file")
    text = path.read_text(encoding="utf-8-sig", errors="replace").translate(str.maketrans(",;\t", "   "))
    rows: list[list[float]] = []
    for number, line in enumerate(text.splitlines(), start=1):
        if not line.strip() or line.lstrip().startswith("#"):
            continue
        try:
            rows.append([float(word) for word in line.split()])
        except ValueError as error:
            raise InputError(f"line {number} is {line[:40]!r}; allowed: heights in m") from error
        if len(rows[-1]) != len(rows[0]):
            raise InputError(f"line {number} has {len(rows[-1])} heights; the first row has {len(rows[0])}")
    if not rows:
        raise InputError("has no heights")
    return np.array(rows)


def _from_instrument(path: Path, spacing: Sequence[float] | None, unit: str | None, fill: bool) -> HeightMap:
    try:
        from SurfaceTopography import read_topography
        from SurfaceTopography.Exceptions import ReadFileError
        from SurfaceTopography.Support.UnitConversion import get_unit_conversion_factor
    except ModuleNotFoundError as error:
        raise ImportError(
            f'{path}: is read by SurfaceTopography, which is not installed: pip install "brinell[surfaces]"'
        ) from error
    try:
        topography = read_topography(str(path))
    except ReadFileError as error:
        raise InputError("has no format that SurfaceTopography knows, or is damaged") from error
    if topography.dim != 2 or not topography.is_uniform:
        raise InputError("is a line scan, or not on a regular grid; allowed: a map of heights")
    if topography.unit is not None and unit is not None:
        raise InputError(f"tells its unit, {topography.unit}; leave out unit = {unit!r}")
    if topography.unit is None and unit is None:
        raise InputError("tells no unit; give it, as unit='um'")
    try:
        to_metre = get_unit_conversion_factor(unit or topography.unit, "m")
    except ValueError as error:
        raise InputError(f"unit: {error}") from error
    if fill and topography.has_undefined_data:
        topography = topography.interpolate_undefined_data_with_harmonic_function()
    # Its first index runs along x, its second along y.
    heights = np.ma.filled(np.ma.asarray(topography.heights(), dtype=np.float64), np.nan).T * to_metre
    if spacing is None:
        dx, dy = topography.pixel_size
        spacing = (dx * to_metre, dy * to_metre)
    return HeightMap(heights, _pair(spacing))
