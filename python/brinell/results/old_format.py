# SPDX-License-Identifier: BSD-3-Clause
"""Conversion of results of format version 2, which had other names and counted from 0, to the present format.

Version 2 called the evaluations of a step `iterations`, and counted passes, places and cycles from 0.
"""

from __future__ import annotations

from collections.abc import Collection, Mapping
from typing import Any

from brinell import _core

__all__ = [
    "OLD_COLUMNS",
    "OLD_VERSION",
    "case_of_today",
    "columns_of_today",
    "has_old_columns",
    "summary_of_today",
    "table_of_today",
]

OLD_VERSION = 2
"""Older format version that is converted when a result is read."""

OLD_COLUMNS: Mapping[str, str] = {"iterations": "evaluations"}
"""Present names of columns by the old ones."""

_FROM_0 = ("pass", "place", "cycle")
"""Columns that counted from 0 and now count from 1."""


def has_old_columns(names: Collection[str]) -> bool:
    """Whether a history.csv, which has no version number, has the old format."""
    return any(old in names and new not in names for old, new in OLD_COLUMNS.items())


def columns_of_today(columns: Mapping[str, Any]) -> dict[str, Any]:
    """Converts the columns of a history, one of its rows, or an indent."""
    return {OLD_COLUMNS.get(name, name): value + 1 if name in _FROM_0 else value for name, value in columns.items()}


def summary_of_today(summary: Mapping[str, Any], version: int) -> dict[str, Any]:
    """Converts a summary; damaged entries are left unchanged.

    Args:
        summary: summary in the old format.
        version: number of the present format version.
    """
    converted = {**summary, "format_version": version}
    if isinstance(run := summary.get("run"), Mapping):
        converted["run"] = columns_of_today(run)
    if isinstance(indents := summary.get("indents"), list):
        converted["indents"] = [columns_of_today(one) if _is_counted(one) else one for one in indents]
    if isinstance(passes := summary.get("passes"), list):
        converted["passes"] = [
            {"pass": number, **one} if isinstance(one, Mapping) else one for number, one in enumerate(passes, start=1)
        ]
    if isinstance(case := summary.get("case"), Mapping):
        converted["case"] = case_of_today(case)
    return converted


def table_of_today(columns: Mapping[str, Any]) -> dict[str, Any]:
    """Converts the columns of the table of a sweep; a table in the present format is unchanged."""
    if "run.iterations" not in columns:
        return dict(columns)
    found = {}
    for name, column in columns.items():
        counts = name.startswith("indents.") and name.rpartition(".")[2] in _FROM_0
        found[_KEYS.get(name, name)] = column + 1 if counts else column
    return found


_KEYS: Mapping[str, str] = {
    "run.iterations": "run.evaluations",
    **{name.old_key: name.key for name in _core.old_names() if "[]" not in name.key},
}
"""Present dotted keys by the old ones."""


def _is_counted(indent: object) -> bool:
    return isinstance(indent, Mapping) and all(isinstance(indent.get(name, 0), int) for name in _FROM_0)


def case_of_today(case: Mapping[str, Any]) -> dict[str, Any]:
    """Converts a case, given as nested tables, to the present keys."""
    converted = dict(case)
    if isinstance(solver := case.get("solver"), Mapping):
        converted["solver"] = {_KEYS.get(f"solver.{key}", key).removeprefix("solver."): solver[key] for key in solver}
    for name in ("lower", "upper"):
        if isinstance(body := case.get(name), Mapping) and isinstance(material := body.get("material"), Mapping):
            hardening = material.get("hardening")
            if isinstance(hardening, Mapping):
                converted[name] = {**body, "material": {**material, "hardening": _hardening_of_today(hardening)}}
    return converted


def _hardening_of_today(hardening: Mapping[str, Any]) -> dict[str, Any]:
    kept = {key: value for key, value in hardening.items() if key not in ("kinematic_moduli", "kinematic_recall")}
    moduli, recall = hardening.get("kinematic_moduli"), hardening.get("kinematic_recall")
    if not isinstance(moduli, list):
        return kept
    back_stresses: list[dict[str, Any]] = [{"modulus": modulus} for modulus in moduli]
    for one, value in zip(back_stresses, recall or (), strict=False):
        one["recall"] = value
    return {**kept, "back_stresses": back_stresses}
