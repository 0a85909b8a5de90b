# SPDX-License-Identifier: BSD-3-Clause
"""Quality of a result: warnings, and the accuracy of its numbers from a series of runs."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

from brinell.results.errors import RunError

__all__ = ["Accuracy", "RunWarning", "accuracy_of", "warnings_of"]


@dataclass(frozen=True)
class RunWarning:
    """A warning that should be checked before the numbers of a run are used."""

    key: str
    """Stable identifier for programs, such as "coarse_contact"."""
    text: str
    """Message for the user."""

    def __str__(self) -> str:
        return self.text


@dataclass(frozen=True)
class Accuracy:
    """Discretisation error of one number of a result, by the Grid Convergence Index; values in the number's SI unit."""

    value: float
    """Value with the finest cells."""
    low: float
    """Lower end of the interval in which the limit of fine cells is expected."""
    high: float
    """Upper end of this interval."""
    relative_error: float
    """Half the width of the interval over the value; for a number near zero, over a typical large value of it [-]."""
    order: float | None
    """Observed order of convergence with the cell size [-]; None if the differences show none."""
    extrapolated: float | None
    """Limit by Richardson extrapolation; None without an order."""


def warnings_of(summary: Mapping[str, Any] | None, place: str) -> list[RunWarning]:
    """Warnings of a summary; an empty list for older results, which were not checked.

    Raises:
        RunError: the warnings are damaged.
    """
    entries = (summary or {}).get("warnings", [])
    try:
        return [RunWarning(str(entry["key"]), str(entry["text"])) for entry in entries]
    except (TypeError, KeyError) as error:
        raise RunError(f"{place}: warnings is no list of keys and texts") from error


def accuracy_of(summary: Mapping[str, Any] | None, place: str) -> dict[str, Accuracy]:
    """Accuracy by name of the number; empty if no series of runs was computed.

    Raises:
        RunError: an entry is damaged.
    """
    try:
        numbers = (summary or {}).get("accuracy", {}).get("numbers", {})
        return {
            name: Accuracy(
                value=float(entry["value"]),
                low=float(entry["low"]),
                high=float(entry["high"]),
                relative_error=float(entry["relative_error"]),
                order=None if entry["order"] is None else float(entry["order"]),
                extrapolated=None if entry["extrapolated"] is None else float(entry["extrapolated"]),
            )
            for name, entry in numbers.items()
        }
    except (TypeError, KeyError, ValueError, AttributeError) as error:
        raise RunError(f"{place}: accuracy is damaged ({error!r})") from error
