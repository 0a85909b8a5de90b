# SPDX-License-Identifier: BSD-3-Clause
"""The form of a case, made of the schema: sections with fields, and which of them apply to the values given so far.

Nothing here names a key of a case, so that a new key of the schema has its field at once.
"""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from dataclasses import asdict, dataclass, field
from functools import cache
from typing import Any

from brinell import _core

__all__ = ["Field", "Section", "applying", "field_of", "form", "plain_key", "sections", "table_of", "units_of"]

_UNITS: Mapping[str, tuple[str, ...]] = {
    "m": ("mm", "um", "nm", "m"),
    "Pa": ("MPa", "GPa", "kPa", "Pa"),
    "N": ("N", "mN", "uN", "kN", "MN"),
    "degrees": ("deg", "mrad", "rad"),
    "degC": ("degC", "K"),
    "s": ("s", "ms", "us"),
    "m/N": ("um/N", "m/N"),
    "m/s": ("m/s", "mm/s", "um/s"),
    "Hz": ("Hz", "kHz"),
    "W": ("W", "mW", "kW"),
    "W/m^2": ("W/mm^2", "W/m^2"),
    "W/(m K)": ("W/(m K)",),
    "rad/m": ("rad/mm", "rad/m"),
    "1/Pa": ("mm^3/(N m)", "1/Pa"),
    "A": ("A", "mA", "kA"),
    "V": ("V", "mV"),
    "ohm": ("ohm", "mohm"),
    "ohm m": ("ohm m",),
}
"""Units to choose from by the unit of a bare number, the usual one first; of any other unit only itself."""

_RANGES = {"snapshots": '"none", "aligned", "all", "every N" or numbers of steps as in 0, 12'}
"""What values of some kinds may be, as the reference of the case file has it."""

_INDEX = re.compile(r"\[\d+\]")


@dataclass(frozen=True)
class Field:
    """One key of the case, as a field of the form."""

    key: str
    """Dotted, without the numbers of repeated tables."""
    label: str
    kind: str
    """Of the schema: text, choice, boolean, integer, number, vector3, numbers, snapshots or words."""
    units: tuple[str, ...]
    """Units to choose from; empty for a pure number."""
    bare: str
    """Unit of a number without one."""
    choices: tuple[str, ...]
    range: str
    required: bool
    default: str
    """What holds without a value."""
    help: str
    when: tuple[str, tuple[str, ...]]
    """Key of which the field depends, and its values with which the field applies; no key: it always applies."""
    excludes: str
    """A key that cannot stand beside this one."""
    one_of: str
    """Group of keys of which one is given; empty: none."""
    pure_if: str
    """Boolean key with which the number is a pure one."""
    list: str
    """The table of the key, if it may be repeated; empty: it may not."""
    per_axis: bool
    """Whether a choice may also be a list, along x and along y."""
    is_file: bool
    """Whether the text is the path of a file that the case reads."""


@dataclass(frozen=True)
class Section:
    """A table of the case file with its fields."""

    table: str
    """Dotted; empty for the root of the file."""
    label: str
    repeats: bool
    fields: list[Field] = field(default_factory=list)


@cache
def form() -> Mapping[str, Field]:
    """All fields by their keys, in the order of the schema."""
    return {entry.key: _field(entry) for entry in _core.schema_keys()}


def _field(entry: _core.SchemaKey) -> Field:
    return Field(
        key=entry.key,
        label=_label(entry.key),
        kind=entry.kind,
        units=units_of(entry.unit, entry.has_unit),
        bare="deg" if entry.unit == "degrees" else entry.unit,
        choices=tuple(entry.choices),
        range=_RANGES.get(entry.kind, entry.range),
        required=entry.required,
        default="" if entry.required else entry.default,
        help=entry.text,
        when=(entry.when[0], tuple(entry.when[1])),
        excludes=entry.excludes,
        one_of=entry.one_of,
        pure_if=entry.pure_if,
        list=entry.list,
        per_axis=entry.per_axis,
        is_file=entry.kind == "text" and re.match(r"(Text )?[Ff]ile\b", entry.text) is not None,
    )


def units_of(unit: str, has_unit: bool = True) -> tuple[str, ...]:
    """Units to choose from for numbers whose bare unit is `unit`; a share has none, or per cent."""
    if not has_unit:
        return ()
    return _UNITS.get(unit, (unit,)) if unit else ("", "%")


@cache
def sections() -> Sequence[Section]:
    """The tables of the case file, in the order of the schema."""
    made: dict[str, Section] = {}
    for one in form().values():
        table = table_of(one.key)
        if table not in made:
            made[table] = Section(table, _label(table) if table else "Case", bool(one.list) and one.list == table)
        made[table].fields.append(one)
    return list(made.values())


def as_json() -> dict[str, Any]:
    """The form for the page."""
    return {"sections": [asdict(section) for section in sections()]}


def _label(key: str) -> str:
    words = key.rpartition(".")[2].replace("_", " ")
    return words[:1].upper() + words[1:]


def table_of(key: str) -> str:
    """Table of a key: lower.texture[0] of lower.texture[0].depth; empty for a key of the root."""
    return key.rpartition(".")[0]


def plain_key(key: str) -> str:
    """A key without the numbers of repeated tables: lower.texture.depth of lower.texture[0].depth."""
    return _INDEX.sub("", key)


def field_of(key: str) -> Field | None:
    """Field of a key, which may be one of a repeated table; None if the schema has no such key."""
    return form().get(plain_key(key))


def applying(values: Mapping[str, Any]) -> dict[str, dict[str, bool]]:
    """Which fields apply to given values.

    Args:
        values: values by dotted key.

    Returns:
        By the keys that apply, with the numbers of repeated tables that are given (`[0]` where none is): whether the
        number of the key is a pure one.
    """
    tables = {table_of(key) for key in values}
    found: dict[str, dict[str, bool]] = {}
    for one in form().values():
        for key in _instances(one, tables):
            if _applies(one, key, values):
                pure = bool(one.pure_if) and _effective(values, _beside(key, one.pure_if)) in (True, "true")
                found[key] = {"pure": pure}
    return found


def _instances(one: Field, tables: set[str]) -> list[str]:
    """The keys of a field: itself, or one of each of its repeated tables."""
    if not one.list:
        return [one.key]
    rest = one.key.removeprefix(one.list)
    here = sorted((t for t in tables if plain_key(t) == one.list and t.endswith("]")), key=_number_of)
    return [table + rest for table in here or [f"{one.list}[0]"]]


def _number_of(table: str) -> int:
    return int(table.rpartition("[")[2].rstrip("]"))


def _applies(one: Field, key: str, values: Mapping[str, Any], depth: int = 0) -> bool:
    """Whether the condition of a field holds, and those of the keys that it names."""
    on, allowed = one.when
    if not on or depth > 8:
        return True
    other = _beside(key, on)
    parent = field_of(other)
    if parent is not None and not _applies(parent, other, values, depth + 1):
        return False
    value = _effective(values, other)
    return _as_word(value) in allowed


def _beside(key: str, other: str) -> str:
    """The key `other` in the same instance of a repeated table as `key`."""
    number = _INDEX.search(key)
    found = form().get(other)
    if found is None or not found.list:
        return other
    same = number is not None and plain_key(key[: number.end()]) == found.list
    return found.list + (number.group() if same and number else "[0]") + other.removeprefix(found.list)


def _effective(values: Mapping[str, Any], key: str) -> Any:
    """Value of a key, or its default."""
    if key in values:
        return values[key]
    found = field_of(key)
    return re.split(r"[,:]", found.default)[0].strip('"') if found else None


def _as_word(value: Any) -> str:
    return str(value).lower() if isinstance(value, bool) else str(value)
