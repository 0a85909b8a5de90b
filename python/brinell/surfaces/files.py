# SPDX-License-Identifier: BSD-3-Clause
"""Reading and writing of height maps."""

from __future__ import annotations

import re
import zipfile
from collections.abc import Sequence
from pathlib import Path
from typing import Any, TypeAlias

import numpy as np

from brinell._toml import tomllib
from brinell.errors import InputError, IoError, MissingExtraError
from brinell.surfaces.filling import filled
from brinell.surfaces.heightmap import FloatArray, HeightMap
from brinell.surfaces.units import metres, one_unit, pair

Spacing: TypeAlias = float | str | Sequence[float | str]
"""Point distances along x and y, in m or as text with a unit; one value stands for both."""
TEXT = (".csv", ".txt", ".dat")
"""Endings of text files of heights that texture.file of a case also accepts."""
_LARGEST_TEXT = 100_000_000
"""Largest size of a text file [B], the same as for all text files that a case refers to."""


def read(path: str | Path, *, spacing: Spacing | None = None, unit: str | None = None, fill: bool = False) -> HeightMap:
    """Reads a height map.

    Args:
        path: path of the file. The ending decides the format: .npz as written by `write`; .npy with heights [ny, nx];
            .csv, .txt or .dat with one line per row of heights, as for texture.file of a case; any other ending is read
            by SurfaceTopography.
        spacing: distances (dx, dy) of the points [m], as numbers or text such as "1 um", or one value for both. It is
            required for formats that do not store it: .npy, and text that was not written by `write` and has no
            Gwyddion header (English or German).
        unit: unit of the heights, such as "um", if the file does not state it; for instrument files it also applies to
            the coordinates. Text and .npy files are in m by default.
        fill: replace points that were not measured (NaN in the file) by a smooth, harmonic surface through their
            neighbours, as `filled` does.

    Returns:
        The height map in m. The first row of an instrument's map is at the smallest y.

    Raises:
        InputError: spacing or unit is missing, or the content is not a height map.
        MissingExtraError: SurfaceTopography is needed but not installed.
        IoError: there is no such file, or it cannot be read.
    """
    path = Path(path)
    if not path.is_file():
        raise IoError(f"{path}: no such file")
    ending = path.suffix.lower()
    try:
        if ending == ".npz" and unit is not None:
            raise InputError(f"holds heights in m; leave out unit = {unit!r}")
        if ending == ".npz":
            return _from_npz(path, fill)
        if ending == ".npy":
            heights = _whole(_loaded(path), fill)
            return HeightMap(heights if unit is None else heights * metres(unit), _needed(spacing, path))
        if ending in TEXT:
            return _from_text(path, spacing, unit, fill)
        return _from_instrument(path, spacing, unit, fill)
    except InputError as error:
        raise InputError(f"{path}: {error}") from error
    except OSError as error:
        raise IoError(f"{path}: cannot be read: {error.strerror or error}") from error


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


def _loaded(path: Path) -> Any:
    try:
        return np.load(path)
    except (EOFError, OSError, ValueError, zipfile.BadZipFile) as error:
        if isinstance(error, OSError) and error.errno is not None:
            raise  # the operating system could not read the file
        raise InputError(f"is no file of NumPy arrays of numbers, or damaged ({error})") from error


def _whole(heights: Any, fill: bool) -> Any:
    return filled(heights) if fill else heights


def _from_npz(path: Path, fill: bool) -> HeightMap:
    with _loaded(path) as file:
        missing = [name for name in ("heights", "spacing") if name not in file]
        if missing:
            raise InputError(f"holds no {' and no '.join(missing)}, only {', '.join(file) or 'nothing'}")
        x, y = pair(file["centre"]) if "centre" in file else (0.0, 0.0)
        periodic = bool(file["periodic"]) if "periodic" in file else False
        return HeightMap(_whole(file["heights"], fill), pair(file["spacing"]), x, y, periodic)


def _from_text(path: Path, spacing: Spacing | None, unit: str | None, fill: bool) -> HeightMap:
    """Reads heights in m or in `unit`, and the optional comment lines of `write` or header of Gwyddion before them."""
    if path.stat().st_size > _LARGEST_TEXT:
        raise InputError(f"is too large; allowed: up to {_LARGEST_TEXT / 1e6:.0f} MB of text, or a .npy file")
    text = path.read_text(encoding="utf-8-sig", errors="replace")
    header = _header_of_gwyddion(text)
    heights = _whole(_numbers(text), fill) * metres(_unit_of_header(header, unit))
    if spacing is None and {"Width", "Height"} <= header.keys():
        width, height = (_size_of_header(header[name]) for name in ("Width", "Height"))
        return HeightMap(heights, (width / heights.shape[1], height / heights.shape[0]))
    header_values = _values_in_comments(text)
    x, y = (
        float(header_values[name]) if isinstance(header_values.get(name), int | float) else 0.0 for name in ("x", "y")
    )
    given = spacing if spacing is not None else header_values.get("spacing")
    return HeightMap(heights, _needed(given, path), x, y, header_values.get("periodic") is True)


def _values_in_comments(text: str) -> dict[str, Any]:
    """Values in the comment lines that `write` puts before the heights; arguments of the caller override them."""
    head = re.findall(r"^#\s*((?:spacing|x|y|periodic)\s*=.*)$", text[:1000], flags=re.MULTILINE)
    try:
        return tomllib.loads("\n".join(head))
    except tomllib.TOMLDecodeError:  # a comment of the user that only looks similar
        return {}


_WORDS = {
    "Width": "Width",
    "Breite": "Width",
    "Height": "Height",
    "Höhe": "Height",
    "Value units": "Value units",
    "Werteinheiten": "Value units",
    "Werteinheit": "Value units",
}
"""Keywords of Gwyddion's header, in English and in German, with the English keyword of each."""
_GWYDDION = re.compile(rf"^#\s*({'|'.join(_WORDS)}):\s*(.*?)\s*$", re.MULTILINE)
"""Lines of Gwyddion's header: "# Width: 100 µm"."""


def _header_of_gwyddion(text: str) -> dict[str, str]:
    """Entries of Gwyddion's header by their English keywords."""
    return {_WORDS[word]: value for word, value in _GWYDDION.findall(text)}


def _unit_of_header(header: dict[str, str], unit: str | None) -> str:
    """Unit of the heights; if a header gives only the size of the map, the user has to give the unit."""
    if header and "Value units" not in header and unit is None:
        raise InputError(
            "has no line '# Value units: m' in the header of Gwyddion; give unit='m'. Lines that are looked for begin "
            f"with {', '.join(f'# {word}:' for word in _WORDS)}"
        )
    return one_unit(header.get("Value units"), unit) if header or unit else "m"


_DECIMAL_COMMA = re.compile(r"[-+]?(?:\d+(?:,\d+)?(?:e[-+]?\d+)?|nan|inf|infinity)", re.IGNORECASE)


def _has_decimal_commas(lines: list[str]) -> bool:
    """Whether commas are decimal commas: in every line something else separates the numbers.

    The case reader uses the same rule for texture.file (src/io/case/measured_files.cpp).
    """
    words = [line.replace(";", " ").split() for line in lines]
    return (
        any("," in line for line in lines)
        and all(len(row) > 1 or ";" in line for row, line in zip(words, lines, strict=True))
        and all(_DECIMAL_COMMA.fullmatch(word) for row in words for word in row)
    )


def _size_of_header(text: str) -> float:
    """Converts a length such as "100 µm" to m."""
    number, _, unit = text.replace("\N{NO-BREAK SPACE}", " ").partition(" ")
    try:
        return float(number.replace(",", ".")) * metres(unit.strip())
    except ValueError as error:
        raise InputError(f"has the size {text!r} in its header; allowed: a length, as '100 um'") from error


def _numbers(text: str) -> FloatArray:
    """Parses heights as the case reader does: separated by commas, semicolons, tabs or blanks; # starts a comment line.

    If something else than a comma separates the numbers, commas between digits are decimal commas.
    """
    lines = [line for line in text.splitlines() if line.strip() and not line.lstrip().startswith("#")]
    text = text.translate(str.maketrans(",;\t", ".  " if _has_decimal_commas(lines) else "   "))
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


def _from_instrument(path: Path, spacing: Spacing | None, unit: str | None, fill: bool) -> HeightMap:
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
    return heightmap if spacing is None else HeightMap(heightmap.heights, pair(spacing))
