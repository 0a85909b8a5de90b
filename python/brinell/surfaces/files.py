# SPDX-License-Identifier: BSD-3-Clause
"""Reading and writing of height maps."""

from __future__ import annotations

import contextlib
import struct
import warnings
import zipfile
from collections.abc import Sequence
from pathlib import Path
from typing import Any, Literal, TypeAlias

import numpy as np

from brinell import _core
from brinell._names import level_of_caller
from brinell.errors import InputError, IoError
from brinell.surfaces.filling import filled, gap_message
from brinell.surfaces.heightmap import REMEDY, HeightMap
from brinell.surfaces.instruments import Channel, read_instrument
from brinell.surfaces.units import metres, pair

Spacing: TypeAlias = float | str | Sequence[float | str]
"""Point distances along x and y, in m or as text with a unit; one value stands for both."""
Layout: TypeAlias = Literal["rows", "points"]
TEXT = (".csv", ".txt", ".dat")
"""Endings of the text files that `write` makes."""


def read(
    path: str | Path,
    *,
    spacing: Spacing | None = None,
    unit: str | None = None,
    fill: bool = False,
    layout: Layout | None = None,
    channel: Channel | None = None,
) -> HeightMap:
    """Reads a height map.

    Args:
        path: path of the file. Its content decides the format, whatever the ending: .npz as written by `write`; .npy
            with heights [ny, nx]; text with one line per row of heights or with x, y and height of one point per line,
            read as texture.file of a case is; anything else is read by SurfaceTopography.
        spacing: distances (dx, dy) of the points [m], as numbers or text such as "1 um", or one value for both. It is
            required for files that do not store it, such as .npy and rows of heights without a header. Where a file
            stores other distances, these are used and a warning is given.
        unit: unit of the heights, such as "um", if the file does not state it; for points and for instrument files it
            also applies to the coordinates. Rows of text and .npy files are in m by default.
        fill: replace points that were not measured (NaN, an empty cell, or a point that a list leaves out) by a smooth,
            harmonic surface through their neighbours, as `filled` does.
        layout: whether the lines of a text are "rows" of heights or "points" x, y, z; None: points if the first two of
            three columns are the coordinates of a grid.
        channel: name or number, counted from 0, of the map, if the file holds several; of a .npz file the name of the
            array.

    Returns:
        The height map in m. The first row of a map of an instrument or of points is at the smallest y.

    Raises:
        InputError: spacing or unit is missing, or the content is not a height map.
        MissingExtraError: SurfaceTopography is needed but not installed.
        IoError: there is no such file, or it cannot be read.
    """
    path = Path(path)
    if not path.is_file():
        raise IoError(f"{path}: no such file")
    try:
        start, ending = _start(path), path.suffix.lower()
        if start.startswith(b"PK") and (ending == ".npz" or _is_npz(path)):
            return _from_npz(path, spacing, unit, fill, channel)
        if start.startswith(b"\x93NUMPY") or ending == ".npy":
            _refuse("channel", channel)
            heights = _whole(_from_npy(path), fill)
            return HeightMap(heights if unit is None else heights * metres(unit), _needed(spacing, path))
        refusal = "is no text of heights"
        if not _is_binary(start):
            text = _core.height_text(path, unit, layout)
            if text.refusal is None:
                _refuse("channel", channel)
                return _from_text(path, text, spacing, fill)
            refusal = text.refusal
        if ending == ".npz":
            _loaded(path)  # which says what is wrong
        _refuse("layout", layout, refusal)
        heights, distances, periodic = read_instrument(path, spacing, unit, channel, refusal)
        return HeightMap(_whole(heights, fill), distances, periodic=periodic)
    except InputError as error:
        raise InputError(f"{path}: {error}") from error
    except OSError as error:
        raise IoError(f"{path}: cannot be read: {error.strerror or error}") from error
    except MemoryError as error:
        raise InputError(
            f"{path}: needs more memory than there is; a damaged file may announce too large a map"
        ) from error


def write(path: str | Path, heightmap: HeightMap) -> None:
    """Writes a height map.

    Args:
        path: path of the file. The ending decides the format: .npz, .csv, .txt and .dat store the whole map, .npy only
            the heights. A text file can also be used as texture.file of a case, which reads the heights and ignores the
            first lines.
        heightmap: the map to write.

    Raises:
        InputError: the ending is not supported.
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
        elif ending in TEXT:
            lines = [f"# {name} = {value}" for name, value in _head(heightmap).items()]
            lines += [",".join(map(repr, row)) for row in heightmap.heights.tolist()]
            path.write_text("\n".join(lines) + "\n", encoding="utf-8")
        else:
            raise InputError(f"{path}: cannot write {ending!r}; allowed: .npz, .npy, {', '.join(TEXT)}")
    except OSError as error:
        raise IoError(f"{path}: cannot be written: {error}") from error


def _head(heightmap: HeightMap) -> dict[str, str]:
    """Values in the comment lines before the heights of a text file, formatted as TOML."""
    dx, dy = heightmap.spacing
    periodic = "true" if heightmap.periodic else "false"
    return {"spacing": f"[{dx!r}, {dy!r}]", "x": repr(heightmap.x), "y": repr(heightmap.y), "periodic": periodic}


def _needed(spacing: Spacing | None, path: Path) -> tuple[float, float]:
    if spacing is None:
        raise InputError(f"a {path.suffix} file has no spacing; give spacing=(dx, dy) in m, or as '1 um'")
    return pair(spacing)


def _refuse(name: str, value: object, why: str = "has one map") -> None:
    """Refuses an argument that does not belong to the kind of file."""
    if value is not None:
        raise InputError(f"{why}; leave out {name} = {value!r}")


def _start(path: Path) -> bytes:
    with path.open("rb") as file:
        return file.read(4096)


def _is_binary(start: bytes) -> bool:
    """Whether the first bytes contain what text does not; text in UTF-16 begins with its mark."""
    controls = set(range(32)) - set(b"\t\n\v\f\r\x1a")
    return not start.startswith((b"\xff\xfe", b"\xfe\xff")) and not controls.isdisjoint(start)


def _is_npz(path: Path) -> bool:
    with contextlib.suppress(zipfile.BadZipFile, ValueError, NotImplementedError), zipfile.ZipFile(path) as archive:
        return "heights.npy" in archive.namelist()
    return False


def _loaded(path: Path) -> Any:
    try:
        return np.load(path)
    except Exception as error:  # NumPy raises what its parsers raise on a damaged header
        if isinstance(error, OSError) and error.errno is not None:
            raise  # the operating system could not read the file
        raise InputError(f"is no file of NumPy arrays of numbers, or damaged ({_first_line(error)})") from error


def _from_npy(path: Path) -> Any:
    """The array of a .npy file, which must fill it: a damaged header could announce a smaller one."""
    heights = _numbers(_loaded(path), "the array")
    with path.open("rb") as file:
        version = np.lib.format.read_magic(file)
        length = struct.unpack("<H", file.read(2))[0] if version == (1, 0) else struct.unpack("<L", file.read(4))[0]
        announced = file.tell() + length + heights.nbytes
    if announced != path.stat().st_size:
        raise InputError(f"is damaged: it has {path.stat().st_size} bytes and announces {announced}")
    return heights


def _first_line(error: Exception) -> str:
    return (str(error).splitlines() or [type(error).__name__])[0]


def _numbers(values: Any, what: str) -> Any:
    """An array of real numbers: others would lose a part or be no heights."""
    if getattr(values, "dtype", np.dtype(object)).kind not in "fiu":
        raise InputError(
            f"has in {what} values of the type {getattr(values, 'dtype', 'of many arrays')}; allowed: numbers"
        )
    return values


def _whole(heights: Any, fill: bool) -> Any:
    return filled(heights) if fill else heights


def _from_npz(path: Path, spacing: Spacing | None, unit: str | None, fill: bool, channel: Channel | None) -> HeightMap:
    with _loaded(path) as file:
        name = "heights" if channel is None else str(channel)
        missing = [
            one for one in (name, "spacing") if one not in file and not (one == "spacing" and spacing is not None)
        ]
        if missing:
            raise InputError(
                f"holds no {' and no '.join(missing)}, only {', '.join(file) or 'nothing'}; name the array and the "
                "distances of its points, as channel='z', spacing='1 um'"
            )
        if unit is not None and "spacing" in file:
            raise InputError(f"holds heights in m; leave out unit = {unit!r}")
        try:
            heights = _numbers(file[name], f"the array {name!r}")
            distances = pair(_numbers(file["spacing"], "the array 'spacing'") if spacing is None else spacing)
            x, y = pair(_numbers(file["centre"], "the array 'centre'")) if "centre" in file else (0.0, 0.0)
            periodic = bool(file["periodic"]) if "periodic" in file else False
        except InputError:
            raise
        except Exception as error:  # as above
            raise InputError(f"is damaged, or no file of brinell.surfaces.write ({_first_line(error)})") from error
    whole = _whole(heights, fill) * (1.0 if unit is None else metres(unit))
    return HeightMap(whole, distances, x, y, periodic)


def _from_text(path: Path, text: Any, spacing: Spacing | None, fill: bool) -> HeightMap:
    """Makes the map of what the engine has read from a text."""
    heights = text.heights
    if text.gaps and not fill:
        raise InputError(f"has {text.first_gap}: {gap_message(heights)}: {REMEDY}")
    distances = _needed(spacing, path) if text.spacing is None or spacing is not None else text.spacing
    if text.spacing is not None and not np.allclose(distances, text.spacing, rtol=1e-3, atol=0.0):
        from brinell.case import CaseWarning

        warnings.warn(
            f"{path}: spacing = {distances} m is used, although the file has points every {text.spacing[0]:.6g} x "
            f"{text.spacing[1]:.6g} m",
            CaseWarning,
            stacklevel=level_of_caller(),
        )
    return HeightMap(_whole(heights, fill), distances, text.x or 0.0, text.y or 0.0, text.periodic is True)
