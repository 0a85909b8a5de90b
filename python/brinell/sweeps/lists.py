# SPDX-License-Identifier: BSD-3-Clause
"""Axes over entries of lists: ``indentation.load=10:200:12`` varies the first load of the case, not the others.

``indentation.load.2=...`` varies the third load. Values that are lists, ``[10, 0],[20, 0]``, replace the whole list.
"""

from __future__ import annotations

import re
from collections.abc import Mapping
from typing import Any

from brinell import _core
from brinell._toml import tomllib
from brinell.case import Case
from brinell.errors import InputError
from brinell.sweeps.designs import Point

__all__ = ["entry_of", "table_of", "with_whole_lists"]

_LISTS = frozenset(key.key for key in _core.schema_keys() if key.is_list)
_NUMBERED = re.compile(r"(.+)\.(\d+)")


def entry_of(key: str, given: object) -> tuple[str, int] | None:
    """List and index that a value of an axis refers to; None if it is the value of the key itself."""
    if key in _LISTS:
        return None if isinstance(given, list | tuple) else (key, 0)
    numbered = _NUMBERED.fullmatch(key)
    return (numbered[1], int(numbered[2])) if numbered and numbered[1] in _LISTS else None


def with_whole_lists(point: Point, table: Mapping[str, Any]) -> Point:
    """Replaces values for entries of lists by the whole lists of the case with these entries.

    Args:
        point: values of the axes.
        table: the case, as returned by `table_of`.

    Raises:
        InputError: the list of the case has no such entry.
    """
    values: Point = {}
    for key, given in point.items():
        entry = entry_of(key, given)
        if entry is None:
            values[key] = given
            continue
        name, index = entry
        whole = values.get(name, _at(table, name))
        if not isinstance(whole, list):
            whole = [] if index > 0 else [given]
        if index >= len(whole):
            raise InputError(f"{name} has {len(whole)} entries in the case; allowed: {name}.0 to one before its end")
        values[name] = [*whole[:index], given, *whole[index + 1 :]]
    return values


def table_of(case: Case) -> dict[str, Any]:
    """The case as nested tables with all defaults, in SI units."""
    return tomllib.loads(case.to_toml())


def _at(table: Mapping[str, Any], key: str) -> Any:
    entry: Any = table
    for name in key.split("."):
        entry = entry.get(name) if isinstance(entry, Mapping) else None
    return entry
