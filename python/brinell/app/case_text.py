# SPDX-License-Identifier: BSD-3-Clause
"""Values of a case by dotted key, and the text of a case file: each made from the other.

A key of a repeated table has its number: lower.texture[0].depth. Values are those of TOML, so that a quantity keeps the
unit in which it was given.
"""

from __future__ import annotations

import json
import math
import re
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any, TypeAlias

from brinell._toml import tomllib
from brinell.app.forms import form, plain_key, sections, table_of
from brinell.errors import InputError

__all__ = ["CaseText", "Values", "inline", "text_of", "values_of"]

Values: TypeAlias = Mapping[str, Any]

_BARE = re.compile(r"[A-Za-z0-9_-]+\Z")
_PART = re.compile(r"([^\[\]]+)((?:\[\d+\])?)\Z")


@dataclass(frozen=True)
class CaseText:
    """The text of a case, and where its keys are."""

    text: str
    lines: Mapping[int, str]
    """Key, or table, of each line that has one; the first line is 1."""


def values_of(text: str) -> dict[str, Any]:
    """Values of the text of a case file by dotted key.

    Raises:
        InputError: the text is not TOML; the message says where.
    """
    try:
        content = tomllib.loads(text)
    except (tomllib.TOMLDecodeError, RecursionError) as error:
        raise InputError(f"this is not a case file: {error}") from error
    values: dict[str, Any] = {}
    _flatten(content, "", values)
    return values


def _flatten(table: Mapping[str, Any], within: str, values: dict[str, Any]) -> None:
    repeated = {section.table for section in sections() if section.repeats}
    for name, value in table.items():
        key = f"{within}{name}"
        plain = plain_key(key)
        if isinstance(value, dict):
            _flatten(value, f"{key}[0]." if plain in repeated else f"{key}.", values)
        elif plain in repeated and isinstance(value, list) and all(isinstance(one, dict) for one in value):
            for i, one in enumerate(value):
                _flatten(one, f"{key}[{i}].", values)
        else:
            values[key] = _plain(value)


def _plain(value: Any) -> Any:
    """A value that JSON has, too: dates, which no case has, and numbers that are not finite become text."""
    if isinstance(value, list):
        return [_plain(one) for one in value]
    if isinstance(value, dict):
        return {name: _plain(one) for name, one in value.items()}
    if isinstance(value, float):
        return value if math.isfinite(value) else str(value)
    return value if isinstance(value, bool | int | str) else str(value)


def text_of(values: Values) -> CaseText:
    """The text of a case file with one key a line.

    Args:
        values: values by dotted key.

    Raises:
        InputError: a key is not one that a file can have.
    """
    tables: dict[str, list[str]] = {}
    for key in sorted(values, key=_place):
        if not all(_PART.match(part) for part in key.split(".")):
            raise InputError(f"{key!r} is no key of a case")
        tables.setdefault(table_of(key), []).append(key)
    written: list[str] = []
    lines: dict[int, str] = {}
    seen: set[str] = set()
    for table, keys in tables.items():
        if table:
            if written:
                written.append("")
            for heading in _headings(table, seen, tables):
                written.append(heading)
                lines[len(written)] = table
        for key in keys:
            written.append(f"{_name(key.rpartition('.')[2])} = {inline(values[key])}")
            lines[len(written)] = key
    return CaseText("\n".join(written) + "\n" if written else "", lines)


def _place(key: str) -> tuple[int, list[Any]]:
    """Order of the keys: by tables of the schema, keys as in the schema, unknown ones last.

    All tables within one of several repeated tables follow it, before the next one of these.
    """
    order = list(form())
    numbers = [int(number) for number in re.findall(r"\[(\d+)\]", key)]
    plain = plain_key(key)
    names = {section.table: i for i, section in enumerate(sections())}
    table = plain_key(table_of(key))
    repeated = key.partition("[")[0] if numbers else table
    # Keys of the root stand before the first table.
    rank = -1 if not table else names.get(repeated, _near(repeated, names))
    within = names.get(table, _near(table, names))
    return rank, [repeated, numbers, within, table, order.index(plain) if plain in order else len(order), plain]


def _near(table: str, names: Mapping[str, int]) -> int:
    """Rank of a table that the schema does not have: after all others."""
    return len(names)


def _headings(table: str, seen: set[str], tables: Mapping[str, Any]) -> list[str]:
    """Heading of a table, before it those of repeated tables above it that have no keys of their own.

    A repeated table that stands there once is written as a plain one.
    """
    headings: list[str] = []
    several = {plain_key(one) for one in tables if re.search(r"\[[1-9]\d*\]", one)}
    parts = table.split(".")
    for i in range(len(parts)):
        above = ".".join(parts[: i + 1])
        repeated = above.endswith("]")
        if above in seen or not (repeated or i == len(parts) - 1):
            continue
        seen.add(above)
        name = ".".join(_name(plain_key(part)) for part in parts[: i + 1])
        headings.append(f"[[{name}]]" if repeated and plain_key(above) in several else f"[{name}]")
    return headings


def _name(name: str) -> str:
    return name if _BARE.match(name) else inline(name)


def inline(value: Any) -> str:
    """A value as TOML on one line."""
    if isinstance(value, Mapping):
        return "{" + ", ".join(f"{_name(key)} = {inline(one)}" for key, one in value.items()) + "}"
    if isinstance(value, list):
        return "[" + ", ".join(map(inline, value)) + "]"
    if isinstance(value, bool | str):  # TOML escapes as JSON does, and DEL besides
        return json.dumps(value, ensure_ascii=False).replace("\x7f", "\\u007f")
    if isinstance(value, int) and not -(2**63) <= value < 2**63:  # TOML has no such number; the engine refuses the text
        return inline(str(value))
    if isinstance(value, int | float):
        return repr(value)
    raise InputError(f"{value!r} is no value of a case")
