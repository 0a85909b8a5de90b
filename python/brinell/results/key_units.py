# SPDX-License-Identifier: BSD-3-Clause
"""Units of the keys of a case, as the engine's schema tells them."""

from __future__ import annotations

import re
from collections.abc import Mapping
from typing import Any

from brinell import _core

__all__ = ["UNITS", "WITHOUT_PREFIX", "key_unit"]

_KEYS = {key.key: key for key in _core.schema_keys()}
_SIGNS = {"degrees": "°", "degC": "°C", "^2": "²", "^3": "³"}

WITHOUT_PREFIX = frozenset({"°", "°C", "s", "W/(m K)", "kg/m³", "J/(kg K)", "1/K", "1/Pa", "ohm m", "ohm m²"})
"""Units whose numbers are written without a prefix."""


def _signed(unit: str) -> str:
    for word, sign in _SIGNS.items():
        unit = unit.replace(word, sign)
    return unit


UNITS: Mapping[str, str] = {name.rpartition(".")[2]: _signed(key.unit) for name, key in _KEYS.items() if key.unit}
"""Units by the last part of a key, for keys that the schema does not know, as those of results of other versions."""


def key_unit(key: str, case: Mapping[str, Any] | None = None) -> str:
    """Unit of the value of a key; empty for a pure number.

    Args:
        key: a dotted key; an entry of a list has its number, as in "lower.texture[0].depth".
        case: the case by dotted keys, which says whether loads and lengths are relative to those at first yield; None:
            as by default.
    """
    known = _KEYS.get(re.sub(r"\[\d+\]|\.\d+$", "", key))
    if known is None:
        return UNITS.get(key.rpartition(".")[2], "")
    if known.pure_if and (case or {}).get(known.pure_if, _KEYS[known.pure_if].default == "true"):
        return ""
    return _signed(known.unit)
