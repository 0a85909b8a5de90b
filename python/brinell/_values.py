# SPDX-License-Identifier: BSD-3-Clause
"""Values of a case as TOML: what Python has for them, and the text behind --set."""

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
"""Heights [y, x] in m by the names that a case has for them."""

_MOST_INLINE = 1000
"""Heights that may stand in the text of a case."""


def overrides_of(values: Mapping[str, Any], maps: HeightMaps | None = None) -> list[str]:
    """Dotted keys and their values as behind --set; each entry of a table by itself. `maps` as in `plain`."""
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
    """A value as TOML on one line, where tomli_w would write a table of each entry of a list."""
    if isinstance(value, Mapping):
        return "{" + ", ".join(f"{key} = {_inline(entry)}" for key, entry in value.items()) + "}"
    if isinstance(value, list) and any(isinstance(entry, Mapping) for entry in value):
        return "[" + ", ".join(map(_inline, value)) + "]"
    return tomli_w.dumps({"value": value}).strip().removeprefix("value = ")


def plain(value: Any, maps: HeightMaps | None = None, key: str = "") -> Any:
    """A value as TOML knows it: NumPy's numbers become Python's, arrays and tuples lists, paths text, parts tables.

    Args:
        value: of any kind that a case may have.
        maps: takes height maps of many points, so that no text is made of them; they all become text if None.
        key: its name in messages.
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
