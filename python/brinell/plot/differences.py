# SPDX-License-Identifier: BSD-3-Clause
"""Names of runs in a figure by what differs between their cases."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

from brinell._toml import tomllib
from brinell.plot import style
from brinell.results import Run, RunError
from brinell.results.key_units import WITHOUT_PREFIX, key_unit

__all__ = ["case_of", "differences", "flat_case", "labels_by_difference", "told"]

_MOST_TOLD = 3

_NO_MATTER = ("title", "output.")
"""Keys that change no result."""


def flat_case(case: Mapping[str, Any], before: str = "") -> list[tuple[str, Any]]:
    """Keys of a case, dotted, with values that can be compared."""
    found: list[tuple[str, Any]] = []
    for key, value in case.items():
        if isinstance(value, Mapping):
            found += flat_case(value, f"{before}{key}.")
        elif isinstance(value, list) and any(isinstance(one, Mapping) for one in value):
            for i, one in enumerate(value):
                found += flat_case(one, f"{before}{key}[{i}].")
        else:
            found.append((f"{before}{key}", tuple(value) if isinstance(value, list) else value))
    return found


def told(key: str, value: Any, case: Mapping[str, Any] | None = None) -> str:
    """A key of a case with its value, as the name of a curve.

    Args:
        key: the dotted key.
        value: its value.
        case: the case by dotted keys, which says whether the value is relative to first yield; None: as by default.

    >>> told("interface.friction", 0.3), told("rolling.load", 1000.0), told("indentation.load", (10.0, 0.0))
    ('friction 0.3', 'load 1 kN', 'load 10 N, 0')
    """
    name = key.rpartition(".")[2]
    body = f"{key.partition('.')[0]} " if key.startswith(("lower.", "upper.")) else ""
    values = value if isinstance(value, tuple) else (value,)
    unit = key_unit(key, case)
    text = ", ".join(_value(one, unit) for one in values[:_MOST_TOLD])
    return f"{body}{name.replace('_', ' ')} {text}{', ...' if len(values) > _MOST_TOLD else ''}"


def _value(value: Any, unit: str) -> str:
    if isinstance(value, bool) or not isinstance(value, (int, float)):
        return str(value).lower() if isinstance(value, bool) else style.as_written(str(value))
    if unit in WITHOUT_PREFIX:
        return f"{style.number(value)} {unit}"
    return style.quantity(value, unit) if unit and value else style.number(value)


def case_of(run: Run) -> dict[str, Any]:
    """The case of a run by dotted keys; empty if the run has not written it yet."""
    if isinstance(case := (run.summary or {}).get("case"), Mapping):
        return dict(flat_case(case))
    try:
        return dict(flat_case(tomllib.loads(run.case_text)))
    except (RunError, tomllib.TOMLDecodeError):
        return {}


def differences(runs: Sequence[Run]) -> dict[str, list[Any]]:
    """Values of the keys that differ between the cases of the runs, one per run; None where a case has no such key."""
    cases = [case_of(run) for run in runs]
    keys = [key for key in dict.fromkeys(key for case in cases for key in case) if not key.startswith(_NO_MATTER)]
    return {
        key: [case.get(key) for case in cases]
        for key in keys
        if any(case.get(key) != cases[0].get(key) for case in cases)
    }


def labels_by_difference(runs: Sequence[Run]) -> list[str] | None:
    """What differs between the cases of the runs, one label each; None if that does not tell each from the others."""
    different = differences(runs)
    if not different or len(different) > _MOST_TOLD:
        return None
    labels = [
        ",  ".join(told(key, values[i], case_of(run)) for key, values in different.items() if values[i] is not None)
        for i, run in enumerate(runs)
    ]
    return labels if all(labels) and len(set(labels)) == len(labels) else None
