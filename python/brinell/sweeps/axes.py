# SPDX-License-Identifier: BSD-3-Clause
"""Axes of a sweep: one per varied key of the case, a range or a list of choices.

A range keeps the unit in which it is given; only the reader of cases converts units.
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any, TypeAlias

import numpy as np

from brinell import _core
from brinell._toml import tomllib
from brinell._values import plain
from brinell.errors import InputError

__all__ = ["Axis", "Choices", "Range", "axis_of"]

Value: TypeAlias = Any
"""A value of the case file: a number, a word, a quantity such as "200 GPa", a list, a table."""

_QUANTITY = re.compile(r"\s*(?P<number>[-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?)\s*(?P<unit>[^\d\s].*?)?\s*")
_DIGITS = 12
"""Significant digits of the values of a range, so that 0.1:0.3:3 gives 0.3 and not 0.30000000000000004."""


@dataclass(frozen=True)
class Range:
    """Numbers from start to stop, both included.

    Attributes:
        start: first value, in `unit`.
        stop: last value, in `unit`.
        count: number of values; None if the design chooses the values (Latin hypercube).
        unit: unit of both ends, as in a case file; empty for SI and dimensionless numbers.
        logarithmic: whether the values have equal ratios instead of equal distances.

    Raises:
        InputError: the count is below 1, an end is not finite, or an end of a logarithmic range is not above 0.
    """

    start: float
    stop: float
    count: int | None = None
    unit: str = ""
    logarithmic: bool = False

    def __post_init__(self) -> None:
        if self.count is not None and self.count < 1:
            raise InputError(f"the range has a count of {self.count}; allowed: 1 or more")
        if not (np.isfinite(self.start) and np.isfinite(self.stop)):
            raise InputError(f"the range {self.start}:{self.stop} is not finite")
        if self.logarithmic and not (self.start > 0 and self.stop > 0):
            raise InputError(f"the range {self.start}:{self.stop} is logarithmic; allowed: both ends > 0")

    def values(self) -> list[Value]:
        """All values in order."""
        if self.count is None:
            raise InputError(f"the range {self.start}:{self.stop} needs a count, as in {self.start}:{self.stop}:5")
        spaced = np.geomspace if self.logarithmic else np.linspace
        numbers = [_rounded(x) for x in spaced(self.start, self.stop, self.count)]
        if isinstance(self.start, int) and isinstance(self.stop, int) and all(x.is_integer() for x in numbers):
            return [self._quantity(int(x)) for x in numbers]
        return [self._quantity(x) for x in numbers]

    def at(self, fraction: float) -> Value:
        """Value at a fraction, in [0, 1], of the range."""
        if self.logarithmic:
            return self._quantity(_rounded(self.start * (self.stop / self.start) ** fraction))
        return self._quantity(_rounded(self.start + (self.stop - self.start) * fraction))

    def _quantity(self, number: float) -> Value:
        return f"{number!r} {self.unit}" if self.unit else number


@dataclass(frozen=True)
class Choices:
    """A list of arbitrary values."""

    items: tuple[Value, ...]

    def __post_init__(self) -> None:
        if not self.items:
            raise InputError("the list has no values; allowed: one or more")

    def values(self) -> list[Value]:
        """All values in order."""
        return list(self.items)

    def at(self, fraction: float) -> Value:
        """Item at a fraction, in [0, 1), of the list; all items have equal shares."""
        return self.items[min(int(fraction * len(self.items)), len(self.items) - 1)]


Axis: TypeAlias = Range | Choices


def axis_of(given: object) -> Axis:
    """Converts the user's description of an axis.

    Args:
        given: an axis; a sequence of values; or text as for --over: "start:stop:count" with both ends included and an
            optional unit at both, "log:start:stop:count", or values separated by commas.

    Raises:
        InputError: the text is not an axis; the message says what is allowed.
    """
    if isinstance(given, Range | Choices):
        return given
    if isinstance(given, str):
        text = _core.with_plain_signs(given)
        return _range_of(text) or Choices(tuple(_values_of(text)))
    if hasattr(given, "tolist"):
        given = given.tolist()
    if not isinstance(given, Sequence):
        raise InputError(f"{given!r} is neither a list of values nor a range such as '1:15:15'")
    return Choices(tuple(plain(value) for value in given))


def _range_of(text: str) -> Range | None:
    """Parses a range; None if the text is not a range, that is, its first two parts are not numbers or quantities."""
    logarithmic = text.startswith("log:")
    parts = text.removeprefix("log:").split(":")
    ends = [_QUANTITY.fullmatch(part) for part in parts[:2]]
    if len(parts) not in (2, 3) or ends[0] is None or ends[1] is None:
        if logarithmic:
            raise InputError(f"{text!r} is not a range; allowed: log:START:STOP:COUNT, as in log:1:100:5")
        if ends[0] is not None and len(parts) > 1 and not re.search(r"[,\"'\[{]", text):
            raise InputError(
                f"{text!r} is not a range; allowed: START:STOP:COUNT with both ends included, as in 10:50:3 or "
                "'1 um:5 um:3', or values with commas between them"
            )
        return None
    units = [match["unit"] or "" for match in ends if match]
    if units[0] != units[1]:
        raise InputError(f"{text!r} has the units {units[0]!r} and {units[1]!r}; allowed: the same at both ends")
    if len(parts) == 3 and not parts[2].strip().isdecimal():
        raise InputError(f"{text!r} has the count {parts[2]!r}; allowed: a whole number, as in 1:15:15")
    count = int(parts[2]) if len(parts) == 3 else None
    return Range(_number(ends[0]["number"]), _number(ends[1]["number"]), count, units[0], logarithmic)


def _number(text: str) -> float:
    return int(text) if re.fullmatch(r"[-+]?\d+", text) else float(text)


def _rounded(x: float) -> float:
    return float(f"{x:.{_DIGITS}g}")


def _values_of(text: str) -> list[Value]:
    """Parses values as TOML; other items are words or quantities without quotes, as for --set."""
    values = []
    for item in _split_at_commas(text):
        try:
            values.append(tomllib.loads(f"value = {item}")["value"])
        except tomllib.TOMLDecodeError:
            values.append(item)
    return values


def _split_at_commas(text: str) -> list[str]:
    """Splits a text at commas outside brackets and quotes."""
    items = re.findall(r"""(?:\[[^\]]*\]|\{[^}]*\}|"[^"]*"|'[^']*'|[^,])+""", text)
    return [item.strip() for item in items if item.strip()]
