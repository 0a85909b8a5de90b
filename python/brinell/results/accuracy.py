# SPDX-License-Identifier: BSD-3-Clause
"""What a result tells of its own quality: warnings, and the accuracy of its numbers from a series of runs."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

from brinell.results.errors import RunError

__all__ = ["Accuracy", "RunWarning", "accuracy_of", "warnings_of"]


@dataclass(frozen=True)
class RunWarning:
    """Something to look at before the numbers of a run are used."""

    key: str
    """Stable, for programs: "coarse_contact"."""
    text: str
    """For people."""

    def __str__(self) -> str:
        return self.text


@dataclass(frozen=True)
class Accuracy:
    """How well one number of a result is known, by the Grid Convergence Index."""

    value: float
    """With the finest cells."""
    low: float
    """Lower end of the interval in which the limit of fine cells is to be expected."""
    high: float
    """Its upper end."""
    relative_error: float
    """Half of it over the value; of a number near zero, over what is large for such a number."""
    order: float | None
    """By which the differences fall with the size of the cells; None if they show none."""
    extrapolated: float | None
    """Limit by Richardson's extrapolation; None without an order."""


def warnings_of(summary: Mapping[str, Any] | None, place: str) -> list[RunWarning]:
    """Those of a summary; none of an older one, which was not judged.

    Raises:
        RunError: they are damaged.
    """
    entries = (summary or {}).get("warnings", [])
    try:
        return [RunWarning(str(entry["key"]), str(entry["text"])) for entry in entries]
    except (TypeError, KeyError) as error:
        raise RunError(f"{place}: warnings is no list of keys and texts") from error


def accuracy_of(summary: Mapping[str, Any] | None, place: str) -> dict[str, Accuracy]:
    """By the names of the numbers; empty without a series.

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
