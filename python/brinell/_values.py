# SPDX-License-Identifier: BSD-3-Clause
"""Conversion of Python values to TOML, for the text of a case and for overrides as after --set."""

from __future__ import annotations

import hashlib
from collections.abc import Mapping
from pathlib import Path
from typing import Any, TypeAlias

import numpy as np
import tomli_w
from numpy.typing import NDArray

from brinell.errors import InputError
from brinell.surfaces.heightmap import HeightMap

HeightMaps: TypeAlias = dict[str, NDArray[np.float64]]
"""Heights [y, x] in m by the names under which a case refers to them."""

_MOST_INLINE = 1000
"""Largest number of heights that are written into the text of a case."""


def overrides_of(values: Mapping[str, Any], maps: HeightMaps | None = None) -> list[str]:
    """Converts values by dotted keys to overrides "key=value", one for each entry of a table; `maps` as in `plain`."""
    return _overrides(plain(values, maps), "")


def _overrides(values: Mapping[str, Any], table: str) -> list[str]:
    overrides = []
    for key, value in values.items():
        if isinstance(value, Mapping):
            overrides += _overrides(value, f"{table}{key}.")
        else:
            overrides.append(f"{table}{key}={_inline(value)}")
    return overrides


def _inline(value: Any) -> str:
    """Formats a value as TOML on one line; tomli_w would write a list of dictionaries as an array of tables."""
    if isinstance(value, Mapping):
        return "{" + ", ".join(f"{key} = {_inline(entry)}" for key, entry in value.items()) + "}"
    if isinstance(value, list) and any(isinstance(entry, Mapping) for entry in value):
        return "[" + ", ".join(map(_inline, value)) + "]"
    return tomli_w.dumps({"value": value}).strip().removeprefix("value = ")


def plain(value: Any, maps: HeightMaps | None = None, key: str = "") -> Any:
    """Converts a value to types of TOML: NumPy scalars, arrays, tuples, paths, and objects with `to_case`.

    Args:
        value: any value that a case may have.
        maps: dictionary to which large height maps are added instead of being converted to text; None: all height maps
            become text.
        key: name of the value in messages.

    Raises:
        InputError: the value has a type that a case cannot have.
    """
    value = HeightMap.of_part(value)
    if isinstance(value, HeightMap) and maps is not None and value.heights.size > _MOST_INLINE:
        name = f"memory:{hashlib.sha256(value.heights.tobytes()).hexdigest()[:16]}-{value.heights.shape[1]}"
        maps[name] = value.heights
        value = value.settings() | {"file": name}
    if hasattr(value, "to_case"):
        value = value.to_case()
    if isinstance(value, Mapping):
        within = f"{key}." if key else ""
        return {str(name): plain(entry, maps, f"{within}{name}") for name, entry in value.items() if entry is not None}
    if isinstance(value, list | tuple):
        return [plain(entry, maps, f"{key}[{i}]") for i, entry in enumerate(value)]
    if isinstance(value, Path):
        return str(value)
    value = value.tolist() if hasattr(value, "tolist") else value
    if not isinstance(value, bool | int | float | str | list):
        named = f"{key} = {value!r}" if key else repr(value)
        raise InputError(f"{named} is no value of a case; allowed: numbers, text, lists, parts of bodies")
    return value
