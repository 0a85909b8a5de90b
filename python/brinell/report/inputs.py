# SPDX-License-Identifier: BSD-3-Clause
"""The case as computed, as a readable table: keys of the case file, values with their units."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from typing import Any

from brinell.report import text
from brinell.results import Run
from brinell.results.key_units import WITHOUT_PREFIX, key_unit

__all__ = ["Input", "inputs_of"]

_NORMALISED = {"load": "P_c", "interference": "α_c", "approach": "α_c", "offset": "a_c"}
"""What these keys count where `normalised` is true."""


@dataclass(frozen=True)
class Input:
    """One key of the case."""

    key: str
    """Within its section: "shape.radius"."""
    value: str
    is_text: bool = False
    """Whether the user wrote the value as text, such as the name of a file, in which there are no symbols."""


def inputs_of(run: Run) -> dict[str, list[Input]]:
    """The keys by section of the case file: lower, upper, the scenario, grid, solver, output.

    Raises:
        RunError: the run has not finished.
    """
    case = run.case()
    return {
        section: list(_flattened(content, section, ""))
        for section, content in case.items()
        if isinstance(content, Mapping)
    }


def _flattened(content: Mapping[str, Any], section: str, prefix: str) -> Iterator[Input]:
    normalised = content.get("normalised") is True
    for key, value in content.items():
        if isinstance(value, Mapping):
            yield from _flattened(value, section, f"{prefix}{key}.")
        elif isinstance(value, list) and value and all(isinstance(one, Mapping) for one in value):
            for index, one in enumerate(value):
                yield from _flattened(one, section, f"{prefix}{key}[{index}].")
        else:
            unit = _NORMALISED.get(key) if normalised else None
            unit = unit or key_unit(f"{section}.{prefix}{key}", {f"{section}.normalised": normalised})
            yield Input(f"{prefix}{key}", _written(value, unit), isinstance(value, str))


def _written(value: Any, unit: str) -> str:
    most = 12
    if isinstance(value, list) and len(value) > most:
        return f"{len(value)} values from {_written(min(value), unit)} to {_written(max(value), unit)}"
    if isinstance(value, list):
        return ", ".join(_written(one, unit) for one in value) or "none"
    if isinstance(value, bool):
        return "yes" if value else "no"
    if isinstance(value, int | float):
        return _of_number(float(value), unit)
    return "none" if value is None else str(value)


def _of_number(value: float, unit: str) -> str:
    if unit in WITHOUT_PREFIX or unit in _NORMALISED.values():
        return f"{text.number(value, 4)} {unit}"
    return text.quantity(value, unit, 4)
