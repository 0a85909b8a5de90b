# SPDX-License-Identifier: BSD-3-Clause
"""Files of instruments and of other programs, as the package SurfaceTopography reads them."""

from __future__ import annotations

import contextlib
import functools
import re
import warnings
import zipfile
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from brinell.errors import BrinellError, InputError, MissingExtraError
from brinell.surfaces.units import metres, one_unit, pair

FloatArray = NDArray[np.float64]
Channel = str | int
_WITHOUT_MARK = ("hgt", "nms")
"""Formats of SurfaceTopography without a mark: any file of a fitting length is taken for one of them."""
_LARGEST = 500_000_000
"""Largest number of points; more are a damaged header."""


@dataclass(frozen=True)
class _Map:
    """A map in a file: its name, size and units, and how to get its heights.

    Attributes:
        points: numbers of points along x and y.
        size: size along x and y in `unit`; None: the file does not tell it.
        unit: unit of heights and size; None: the file does not tell it.
        is_height: whether the values are heights.
        topography: returns the map; the argument is the size of a map without one.
    """

    name: str
    points: tuple[int, ...]
    size: tuple[float, ...] | None
    unit: str | None
    is_height: bool
    topography: Callable[[tuple[int, ...] | None], Any]

    def described(self, number: int) -> str:
        """The map in a list of maps."""
        kind = "" if self.is_height else f" in {self.unit or 'another unit'}, no heights"
        return f"{number} {self.name!r} ({' x '.join(map(str, self.points))}{kind})"


def read_instrument(
    path: Path, spacing: Any, unit: str | None, channel: Channel | None, refusal: str
) -> tuple[FloatArray, tuple[float, float], bool]:
    """Reads a map of heights.

    Args:
        path: path of the file.
        spacing: distances of the points, or None.
        unit: unit of the heights and the size, or None.
        channel: name or number of the map, if there are several.
        refusal: why the file is no text of heights.

    Returns:
        Heights [ny, nx] in m, with NaN where nothing was measured; distances of the points in m; whether the map is
        periodic.

    Raises:
        InputError: no format is recognised, the file is damaged, or something it does not tell is missing.
        MissingExtraError: SurfaceTopography is not installed.
    """
    try:
        from SurfaceTopography import open_topography
        from SurfaceTopography.Exceptions import ReadFileError
    except ModuleNotFoundError as error:
        what = f"{path}: {refusal}; a map of an instrument's format"
        raise MissingExtraError(what, "SurfaceTopography", "surfaces") from error
    try:
        with _quiet(), _opened(path, open_topography) as maps:
            return _map_of(_chosen(maps, channel), spacing, unit)
    except BrinellError:
        raise
    except ReadFileError as error:
        raise InputError(
            f"{refusal}; as a file of an instrument it has no format that SurfaceTopography knows, or is damaged: "
            "export it anew, or as text with a row of heights or with x, y and z of a point per line"
        ) from error
    except Exception as error:  # the libraries raise what they please on a damaged file
        raise InputError(
            f"cannot be read by SurfaceTopography, is damaged or holds no map ({_one_line(error)}); export it anew, or "
            "as text"
        ) from error


@contextlib.contextmanager
def _quiet() -> Iterator[None]:
    """Without the warnings of the libraries, which are about their own affairs."""
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        yield


def _one_line(error: Exception) -> str:
    text = re.sub(r"\s+", " ", str(error)).strip()[:120]
    return f"{type(error).__name__}: {text}" if text else type(error).__name__


@contextlib.contextmanager
def _opened(path: Path, open_topography: Callable[[str], Any]) -> Iterator[list[_Map]]:
    from SurfaceTopography.Exceptions import CannotDetectFileFormat

    if _is_container(path):
        yield _maps_of_container(path)
        return
    reader = open_topography(str(path))
    with contextlib.closing(reader):
        form = reader.format()
        if form in _WITHOUT_MARK and path.suffix.lower() != f".{form}":
            raise CannotDetectFileFormat(path)
        if form == "asc":
            _require_whole_text(path)
        yield [_map_of_channel(channel) for channel in reader.channels]


def _map_of_channel(channel: Any) -> _Map:
    def topography(size: tuple[int, ...] | None) -> Any:
        return channel.topography() if size is None else channel.topography(physical_sizes=size)

    is_height = bool(getattr(channel, "is_height_channel", True))
    unit = channel.unit if is_height else channel.data_unit
    return _Map(channel.name, tuple(channel.nb_grid_pts), channel.physical_sizes, unit, is_height, topography)


def _is_container(path: Path) -> bool:
    """Whether the file is a container of contact.engineering."""
    if not zipfile.is_zipfile(path):
        return False
    with zipfile.ZipFile(path) as archive:
        return not {"index.json", "meta.yml"}.isdisjoint(archive.namelist())


def _maps_of_container(path: Path) -> list[_Map]:
    from SurfaceTopography.Container.IO import open_container

    reader = open_container(str(path))
    maps = []
    for index in range(reader.nb_containers):
        surface = reader.container(index)
        for number, member in enumerate(reader.members(index)):
            topography = surface[number]
            name = (
                member.name if reader.nb_containers == 1 else f"{(surface.info or {}).get('name', index)}/{member.name}"
            )
            size, unit = topography.physical_sizes, topography.unit
            take = functools.partial(_itself, topography)
            maps.append(_Map(name, tuple(topography.nb_grid_pts), size, unit, True, take))
    return maps


def _itself(topography: Any, _size: tuple[int, ...] | None) -> Any:
    return topography


def _chosen(maps: Sequence[_Map], channel: Channel | None) -> _Map:
    """The map with a name or number, or the only one."""
    listed = ", ".join(one.described(number) for number, one in enumerate(maps)) or "nothing"
    if channel is not None:
        named = [one for one in maps if one.name == channel]
        number = int(channel) if str(channel).isdecimal() else -1
        if not named and not 0 <= number < len(maps):
            raise InputError(f"has no map channel = {channel!r}; it holds {listed}")
        if len(named) > 1:
            raise InputError(f"has {len(named)} maps channel = {channel!r}; choose one by its number: {listed}")
        return named[0] if named else maps[number]
    heights = [one for one in maps if one.is_height and len(one.points) == 2]
    if not heights:
        raise InputError(f"is a line scan or holds no map of heights, but {listed}; allowed: a map of heights")
    if len(heights) > 1:
        raise InputError(
            f"holds {len(heights)} maps of heights: {listed}; choose one by name or number, as "
            f"channel={heights[0].name!r}"
        )
    return heights[0]


def _map_of(chosen: _Map, spacing: Any, unit: str | None) -> tuple[FloatArray, tuple[float, float], bool]:
    if len(chosen.points) != 2:
        raise InputError(f"channel {chosen.name!r} is a line scan, or not on a regular grid; allowed: a map of heights")
    if not chosen.is_height:
        raise InputError(
            f"channel {chosen.name!r} is in {chosen.unit or 'another unit'}, which is no unit of length; allowed: "
            "a map of heights"
        )
    nx, ny = chosen.points
    if not 0 < nx * ny <= _LARGEST:
        raise InputError(f"channel {chosen.name!r} has {nx} x {ny} points; the file is damaged")
    if chosen.size is None and spacing is None:
        raise InputError("tells no size of its map; give spacing=(dx, dy) in m, or as '1 um'")
    to_metre = metres(one_unit(chosen.unit, unit))
    topography = chosen.topography((nx, ny) if chosen.size is None else None)
    if topography.dim != 2 or not topography.is_uniform:
        raise InputError("is a line scan, or not on a regular grid; allowed: a map of heights")
    # The first index of a topography runs along x, the second along y.
    heights = np.ma.filled(np.ma.asarray(topography.heights(), dtype=np.float64), np.nan).T * to_metre
    if heights.shape != (ny, nx):
        raise InputError(
            f"announces {nx} x {ny} points and has {heights.shape[1]} x {heights.shape[0]}: is it cut off?"
        )
    dx, dy = pair(spacing) if spacing is not None else (d * to_metre for d in topography.pixel_size)
    return heights, (float(dx), float(dy)), bool(topography.is_periodic)


def _require_whole_text(path: Path) -> None:
    """Refuses text that the library would read without an error, but not as it is meant.

    It takes a row with a word that is no number for a header and leaves it out, and ignores the scale of SDF in the
    version BCR.
    """
    text = path.read_text(encoding="utf-8", errors="replace")
    if text.startswith("aBCR"):
        raise InputError(
            f"is SDF {text[:8].strip()}, which SurfaceTopography does not read; export it as aISO-1.0 or .x3p"
        )
    lines = [line.split() for line in text.splitlines()]
    numbers = [sum(map(_is_number, words)) for words in lines]
    rows = [len(words) for words, count in zip(lines, numbers, strict=True) if words and count == len(words)]
    columns = max(set(rows), key=rows.count, default=0)
    announces = text.startswith("Wyko ASCII")  # its header has numbers, and the library counts the rows
    for number, (words, count) in enumerate(zip(lines, numbers, strict=True), start=1):
        is_row = bool(words) and count == len(words)
        is_broken_row = not is_row and not announces and count >= max(2, columns // 2)
        begins_as_row = not is_row and bool(words) and _is_number(words[0])
        if is_broken_row or begins_as_row or (is_row and count != columns):
            raise InputError(f"has in line {number} {' '.join(words)[:40]!r}; allowed: a header, or {columns} heights")


def _is_number(word: str) -> bool:
    if word.lower() in {"bad", "nan", "inf", "infinite"}:
        return True
    try:
        float(word)
    except ValueError:
        return False
    return True
