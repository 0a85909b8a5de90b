# SPDX-License-Identifier: BSD-3-Clause
"""The file of a fit: case, unknowns and data as TOML; docs/reference/fit-file.md."""

from __future__ import annotations

import re
from collections.abc import Mapping
from pathlib import Path
from typing import Any

from brinell import _core
from brinell._names import did_you_mean
from brinell._toml import tomllib
from brinell.errors import InputError
from brinell.fits.data import Data, data_from_file
from brinell.fits.unknowns import Unknown

__all__ = ["read_fit"]

_NUMBER, _TEXT, _LIST, _FLAG = "a number, or text with a unit", "text", "a list", "true or false"
_TOP = {
    "title": _TEXT,
    "case": _TEXT,
    "loss": _TEXT,
    "confidence": "a number",
    "method_error": _NUMBER,
    "profiles": "true, false or a list of unknowns",
    "unknown": "tables [[unknown]]",
    "data": "tables [[data]]",
}
_UNKNOWN = {
    "key": "text, or a list of keys",
    "low": _NUMBER,
    "high": _NUMBER,
    "start": _NUMBER,
    "prior": _NUMBER,
    "prior_deviation": _NUMBER,
    "data": _LIST,
    "name": _TEXT,
}
_DATA = {
    "file": _TEXT,
    "kind": _TEXT,
    "name": _TEXT,
    "case": _TEXT,
    "set": "a table of keys",
    "x": "title or number of a column",
    "y": "title or number of a column",
    "time": "title or number of a column",
    "units": "a table of units",
    "reverse": _LIST,
    "columns": _LIST,
    "value": _NUMBER,
    "noise": _NUMBER,
    "noise_x": _NUMBER,
    "place": "an integer",
    "pass": "an integer",
    "holds": _TEXT,
    "level": _FLAG,
}
_TYPES: Mapping[str, tuple[type, ...]] = {
    _TEXT: (str,),
    _NUMBER: (int, float, str),
    "a number": (int, float),
    "an integer": (int,),
    _LIST: (list,),
    _FLAG: (bool,),
    "text, or a list of keys": (str, list),
    "true, false or a list of unknowns": (bool, list),
    "a table of keys": (dict,),
    "a table of units": (dict,),
    "title or number of a column": (str, int),
    "tables [[unknown]]": (list,),
    "tables [[data]]": (list,),
}


def read_fit(path: Path) -> dict[str, Any]:
    """Reads the file of a fit as arguments of `brinell.fit`; paths in it are relative to its folder.

    Raises:
        InputError: a key or value is not allowed; the text names file, line and what is allowed.
    """
    text = _core.case_file_text(path)
    try:
        tables = tomllib.loads(text)
    except tomllib.TOMLDecodeError as error:
        raise InputError(f"{path}: {error}") from None
    if "scenario" in tables:
        raise InputError(f"{path}: is a case; allowed: the file of a fit, with case, [[unknown]] and [[data]]")
    lines = text.splitlines()
    _check(tables, _TOP, path, lines, None, 0)
    for name in ("unknown", "data"):
        if not tables.get(name):
            raise InputError(f"{path}: no [[{name}]]; allowed: one or more")
    folder = path.parent
    found: dict[str, Any] = {key: tables[key] for key in ("title", "loss", "confidence", "profiles") if key in tables}
    if "case" in tables:
        found["case"] = folder / tables["case"]
    if "method_error" in tables:
        given = tables["method_error"]
        try:
            found["method_error"] = _core.quantity_like(given, "") if isinstance(given, str) else given
        except InputError as error:
            raise InputError(f"{path}:{_line(lines, None, 0, 'method_error')}: method_error = {error}") from None
    found["unknowns"] = [_unknown(one, path, lines, i) for i, one in enumerate(tables["unknown"])]
    found["data"] = [_data(one, path, lines, i) for i, one in enumerate(tables["data"])]
    return found


def _unknown(table: dict[str, Any], path: Path, lines: list[str], index: int) -> Unknown:
    _check(table, _UNKNOWN, path, lines, "unknown", index)
    for key in ("key", "low", "high"):
        if key not in table:
            line = _line(lines, "unknown", index, "")
            raise InputError(f"{path}:{line}: [[unknown]] has no {key}; allowed: key, low and high, at least")
    places = {key: f"{path}:{_line(lines, 'unknown', index, key)}: " for key in ("", *table)}
    return Unknown(**table, places=places)


def _data(table: dict[str, Any], path: Path, lines: list[str], index: int) -> Data:
    _check(table, _DATA, path, lines, "data", index)
    given = dict(table)
    folder = path.parent
    if "case" in given:
        given["case"] = folder / given["case"]
    if "pass" in given:
        given["passed"] = given.pop("pass")
    try:
        if given.get("kind") == "number":
            if "value" not in given or "file" in given:
                raise InputError("kind = 'number' needs value, the key in columns and noise, and no file")
            value = given.pop("value")
            number = _core.quantity_like(value, value.split(maxsplit=1)[1]) if isinstance(value, str) else value
            return Data(x=[0.0], y=[number], name=given.pop("name", given["columns"][0]), **given)  # type: ignore[arg-type]
        if "file" not in given or "value" in given:
            raise InputError('data need a file; allowed: file = "curve.csv", or kind = "number" with a value')
        return data_from_file(folder / given.pop("file"), **given)
    except (TypeError, InputError, KeyError, IndexError) as error:
        raise InputError(f"{path}:{_line(lines, 'data', index, '')}: [[data]]: {error}") from None


def _check(
    table: Mapping[str, Any], allowed: Mapping[str, str], path: Path, lines: list[str], name: str | None, index: int
) -> None:
    within = f"[[{name}]]: " if name else ""
    for key, value in table.items():
        place = f"{path}:{_line(lines, name, index, key)}: {within}"
        if key not in allowed:
            raise InputError(f"{place}{key} is not known; {did_you_mean(key, allowed)}allowed: {', '.join(allowed)}")
        kinds = _TYPES[allowed[key]]
        if not isinstance(value, kinds) or (isinstance(value, bool) and bool not in kinds):
            raise InputError(f"{place}{key} = {value!r}; allowed: {allowed[key]}")


def _line(lines: list[str], name: str | None, index: int, key: str) -> int:
    """Number of the line of a key in the table of a name that has an index; that of the table if it is not found."""
    header = -1 if name is not None else 0
    place = 1
    for number, line in enumerate(lines, start=1):
        if match := re.match(r"\s*\[\[?\s*([\w.]+)", line):
            if name is None:
                header = -1
            elif match[1] == name:
                header += 1
            if name is not None and header == index and match[1] == name:
                place = number
        if (
            (header == index or (name is None and header == 0))
            and key
            and re.match(rf"\s*{re.escape(key)}\s*[=.]", line)
        ):
            return number
    return place
