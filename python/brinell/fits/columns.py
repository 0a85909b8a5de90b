# SPDX-License-Identifier: BSD-3-Clause
"""Columns of numbers in a text file of an instrument, by their name or number, with their units."""

from __future__ import annotations

import re
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from brinell import _core
from brinell._names import did_you_mean
from brinell.errors import InputError

__all__ = ["TextTable"]

_UNIT = re.compile(r"[\[(]\s*([^\])]*?)\s*[\])]")
_NUMBER = re.compile(r"[-+−]?(\d+\.?\d*|\.\d+)([eE][-+]?\d+)?|nan", re.IGNORECASE)


@dataclass(frozen=True)
class TextTable:
    """A text file with one point per line, after lines of titles.

    Attributes:
        path: the file.
        titles: words of the last line before the numbers that has as many as there are columns; otherwise empty.
        units: units in the titles, as in "depth [um]", or in a line of their own; empty where there are none.
        rows: numbers.
        lines: numbers of the lines of the rows in the file.
    """

    path: Path
    titles: list[str]
    units: list[str]
    rows: NDArray[np.float64]
    lines: list[int]

    @classmethod
    def read(cls, path: Path) -> TextTable:
        """Reads columns that are separated by semicolons, tabs, commas or blanks; decimal commas if no other are.

        Raises:
            InputError: the file is missing, or a line is no point; the text names the line.
        """
        if not path.is_file():
            raise InputError(f"{path}: no such file")
        lines = _text(path.read_bytes()).splitlines()
        first = next((i for i, line in enumerate(lines) if _is_row(line)), None)
        if first is None:
            raise InputError(f"{path}: no line with two numbers or more; allowed: text with one point per line")
        separator = next((one for one in (";", "\t", ",") if one in lines[first]), None)
        if separator == "," and _is_decimal_comma(lines[first]):
            separator = None
        rows, places = [], []
        for number, line in enumerate(lines[first:], start=first + 1):
            if line.strip() and not line.lstrip().startswith("#"):
                rows.append(_row(line, separator, f"{path}:{number}"))
                places.append(number)
        widths = {len(row) for row in rows}
        if len(widths) > 1:
            odd = next(i for i, row in enumerate(rows) if len(row) != len(rows[0]))
            raise InputError(f"{path}:{places[odd]}: {len(rows[odd])} numbers, expected {len(rows[0])}")
        titles, units = _titles(lines[:first], separator, len(rows[0]))
        return cls(path, titles, units, np.array(rows), places)

    def column(self, name: str | int, unit: str | None, si: str) -> NDArray[np.float64]:
        """A column in SI units.

        Args:
            name: title without its unit, or number from 1.
            unit: unit in the file; None: that of the title, otherwise SI.
            si: what is to be measured, as "m".

        Raises:
            InputError: there is no such column, its unit is of something else, or a value is missing.
        """
        index = self._index(name)
        found = unit if unit is not None else self.units[index] if self.units else ""
        try:
            scale = _core.quantity_like(f"1 {found}", si) if found and si else 1.0
        except InputError as error:
            raise InputError(f"{self.path}: unit of {name!r}: {error}") from None
        values = self.rows[:, index] * scale
        if bad := [line for line, value in zip(self.lines, values, strict=True) if not np.isfinite(value)]:
            raise InputError(f"{self.path}:{bad[0]}: column {name!r} has no number; allowed: finite numbers")
        return np.ascontiguousarray(values)

    def has(self, *words: str) -> int | None:
        """Number, from 1, of the first column whose title has one of the words."""
        for index, title in enumerate(self.titles):
            if any(word in title.lower() for word in words):
                return index + 1
        return None

    def _index(self, name: str | int) -> int:
        width = self.rows.shape[1]
        if isinstance(name, int):
            if not 1 <= name <= width:
                raise InputError(f"{self.path}: column {name}; allowed: 1 to {width}")
            return name - 1
        if name not in self.titles:
            known = ", ".join(map(repr, self.titles)) or "none has a title"
            hint = did_you_mean(name, self.titles)
            raise InputError(f"{self.path}: no column {name!r}; {hint}allowed: 1 to {width}, or {known}")
        return self.titles.index(name)


def _text(content: bytes) -> str:
    if content[:2] in (b"\xff\xfe", b"\xfe\xff"):
        return content.decode("utf-16", errors="replace")
    try:
        return content.decode("utf-8-sig")
    except UnicodeDecodeError:
        return content.decode("latin-1")


def _is_row(line: str) -> bool:
    words = [word for word in re.split(r"[;\t, ]+", line.strip()) if word]
    return len(words) > 1 and all(_NUMBER.fullmatch(word) for word in words)


def _is_decimal_comma(line: str) -> bool:
    """Whether blanks separate numbers with decimal commas: "0,1 2,5"."""
    return all(re.fullmatch(r"[-+]?\d+(,\d+)?([eE][-+]?\d+)?", word) for word in line.split()) and " " in line.strip()


def _row(line: str, separator: str | None, place: str) -> list[float]:
    cells = [cell.strip() for cell in line.strip().split(separator)]
    while cells and not cells[-1]:
        cells.pop()
    plain = [(cell if separator == "," else cell.replace(",", ".")).replace("−", "-") for cell in cells]
    try:
        return [float(cell) if cell else float("nan") for cell in plain]
    except ValueError:
        raise InputError(f"{place}: {line.strip()[:60]!r} is no line of numbers") from None


def _titles(lines: list[str], separator: str | None, width: int) -> tuple[list[str], list[str]]:
    split = [re.split(r"\t|\s{2,}", s) if separator is None else s.split(separator) for s in lines]
    tables = [[c.strip().lstrip("# ") for c in cells] for cells in split]
    tables += [[c.lstrip("# ") for c in line.split()] for line in lines] if separator is None else []
    rows = [cells for cells in tables if len(cells) == width and all(cells)]
    if not rows:
        return [], []
    units_row = rows[-1] if len(rows) > 1 and all(_is_unit(cell) for cell in rows[-1]) else None
    titles = rows[-2] if units_row else rows[-1]
    units = units_row or [match[1] if (match := _UNIT.search(title)) else "" for title in titles]
    units = [unit.strip("[]() ") for unit in units]
    return [_UNIT.sub("", title).strip() for title in titles], units


def _is_unit(cell: str) -> bool:
    try:
        _core.quantity_like("1 " + cell.strip("[]() "), cell.strip("[]() "))
    except InputError:
        return cell.strip("[]() ") in ("", "-", "1")
    return True
