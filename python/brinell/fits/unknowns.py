# SPDX-License-Identifier: BSD-3-Clause
"""Unknown keys: bounds, start, prior, and the variable in [0, 1] in which the least squares are solved."""

from __future__ import annotations

import math
import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any, TypeAlias

import numpy as np

from brinell import _core
from brinell._names import did_you_mean
from brinell.case import Case
from brinell.errors import InputError
from brinell.sweeps.lists import entry_of, table_of, with_whole_lists

__all__ = ["MACHINE", "Parameter", "Unknown", "value_at", "values_of"]

Quantity: TypeAlias = float | str

MACHINE = {"machine.compliance": "m/N", "machine.first_touch": "m", "machine.drift": "m/s"}
"""Unknowns of the measurement, which no case has: the measured depth is the approach + compliance * load + first_touch
+ drift * time."""

_RATIO = 3.0
"""Ratio of positive bounds from which an unknown is varied in its logarithm."""


@dataclass(frozen=True)
class Unknown:
    """A key of the case, or of the machine, that is to be found.

    Attributes:
        key: dotted key of the case, "lower.material.hardening.yield_stress"; an entry of a list has its number, counted
            from 0: "lower.material.yield_profile.factor.1". Several keys that share the value: a list. Keys of the
            measurement: "machine.compliance" [m/N], "machine.first_touch" [m], "machine.drift" [m/s].
        low: lower bound; text has a unit, as in the case file.
        high: upper bound.
        start: where to begin; None: the best of some points between the bounds.
        prior: value that is known beforehand, such as from another test; None: nothing is known.
        prior_deviation: its standard deviation.
        data: names of the data that it belongs to; empty: all.
        name: what messages and figures call it; None: the last word of the key.
        places: places in a file of the fields, for messages.
    """

    key: str | Sequence[str]
    low: Quantity
    high: Quantity
    start: Quantity | None = None
    prior: Quantity | None = None
    prior_deviation: Quantity | None = None
    data: Sequence[str] = ()
    name: str | None = None
    places: Mapping[str, str] = field(default_factory=dict, repr=False)

    @property
    def keys(self) -> tuple[str, ...]:
        """All keys that have the value."""
        return (self.key,) if isinstance(self.key, str) else tuple(self.key)

    def error(self, of: str, text: str) -> InputError:
        """An error about one of the fields."""
        return InputError(f"{self.places.get(of, self.places.get('', ''))}unknown {self.keys[0]}: {text}")


@dataclass(frozen=True)
class Parameter:
    """An unknown in SI units (as the case has it, angles in degrees), and its map to the variable u in [0, 1]."""

    unknown: Unknown
    name: str
    unit: str
    low: float
    high: float
    start: float | None
    prior: float | None
    prior_deviation: float | None

    @property
    def is_logarithmic(self) -> bool:
        """Whether u is linear in the logarithm of the value."""
        return self.low > 0.0 and self.high >= _RATIO * self.low

    def value(self, u: float) -> float:
        """Value at u."""
        if self.is_logarithmic:
            return float(self.low * (self.high / self.low) ** u)
        return float(self.low + (self.high - self.low) * u)

    def place(self, value: float) -> float:
        """The variable u of a value."""
        if self.is_logarithmic:
            return math.log(value / self.low) / math.log(self.high / self.low)
        return (value - self.low) / (self.high - self.low)

    def slope(self, u: float) -> float:
        """Derivative of the value by u."""
        if self.is_logarithmic:
            return self.value(u) * math.log(self.high / self.low)
        return self.high - self.low

    @property
    def step(self) -> float:
        """Step of u for a difference: 1 % of a value that varies in its logarithm, 0.5 % of the bounds' distance."""
        return 0.01 / math.log(self.high / self.low) if self.is_logarithmic else 0.005

    @property
    def first(self) -> float:
        """The variable u at the start, at the prior, or in the middle."""
        known = self.start if self.start is not None else self.prior
        return 0.5 if known is None else min(max(self.place(known), 0.0), 1.0)

    @classmethod
    def of(cls, unknown: Unknown, case: Case, names: Sequence[str], several: bool) -> Parameter:
        """Checks an unknown against the case.

        Args:
            unknown: what the user gives.
            case: a case in which the key is to be replaced.
            names: names of the data.
            several: whether another unknown has the same last word.

        Raises:
            InputError: the key is no number of the case, a bound is not allowed, or the order of the values is wrong.
        """
        if wrong := [one for one in unknown.data if one not in names]:
            raise unknown.error("data", f"data = {wrong[0]!r} is not known; allowed: {', '.join(names)}")
        unit = {_unit(unknown, key) for key in unknown.keys}
        if len(unit) != 1:
            raise unknown.error("key", f"the keys have the units {sorted(unit)}; allowed: keys of one unit")
        values = {
            name: None if (given := getattr(unknown, name)) is None else _value(unknown, name, given, case)
            for name in ("low", "high", "start", "prior")
        }
        low, high, start, prior = values["low"], values["high"], values["start"], values["prior"]
        assert low is not None
        assert high is not None
        if not low < high:
            raise unknown.error("high", f"high = {unknown.high} is not above low = {unknown.low}")
        if start is not None and not low <= start <= high:
            raise unknown.error("start", f"start = {unknown.start}; allowed: from low to high")
        deviation = unknown.prior_deviation
        if (prior is None) != (deviation is None):
            raise unknown.error("prior", "prior and prior_deviation stand together; allowed: both, or neither")
        spread = None if deviation is None else _difference(unknown, deviation, prior or 0.0, next(iter(unit)))
        words = unknown.keys[0].split(".")
        last = " ".join(words[-2:]) if words[-1].isdigit() else words[-1]
        label = unknown.name or (f"{words[0]} {last}" if several else last).replace("_", " ")
        return cls(unknown, label, next(iter(unit)), low, high, start, prior, spread)

    def prior_residual(self, u: float) -> float | None:
        """Distance from the prior in standard deviations."""
        if self.prior is None or self.prior_deviation is None:
            return None
        return (self.value(u) - self.prior) / self.prior_deviation


def _unit(unknown: Unknown, key: str) -> str:
    if key in MACHINE:
        return MACHINE[key]
    plain = re.sub(r"\[\d+\]", "", key)
    if plain.startswith(("grid.", "solver.", "output.")):
        raise unknown.error("key", "belongs to the computation; allowed: keys of bodies, motion and interface")
    entry = entry_of(plain, 0.0)
    found = {one.key: one for one in _core.schema_keys()}
    schema = found.get(entry[0] if entry else plain)
    if schema is None:
        hint = did_you_mean(plain, [*found, *MACHINE])
        raise unknown.error("key", f"no such key; {hint}allowed: a number of the case file, or {', '.join(MACHINE)}")
    if schema.kind not in ("number", "numbers"):
        raise unknown.error("key", f"is {schema.kind}, which cannot be varied; allowed: keys that are numbers")
    return schema.unit


def _value(unknown: Unknown, field_name: str, given: Quantity, case: Case) -> float:
    """A value in the unit of the resolved case, checked by the reader of cases."""
    try:
        if unknown.keys[0] in MACHINE:
            unit = MACHINE[unknown.keys[0]]
            return _core.quantity_like(given, unit) if isinstance(given, str) else float(given)
        changed = case.with_values(with_whole_lists({unknown.keys[0]: given}, table_of(case)))
        return value_at(table_of(changed), unknown.keys[0])
    except (InputError, TypeError, ValueError) as error:
        raise unknown.error(field_name, f"{field_name} = {given!r}: {error}") from None


def _difference(unknown: Unknown, given: Quantity, prior: float, unit: str) -> float:
    """A standard deviation: a share of the prior, or a quantity."""
    try:
        if isinstance(given, str) and given.strip().endswith("%"):
            number = _core.quantity_like(given, "") * abs(prior)
        else:
            number = _core.quantity_like(given, unit) if isinstance(given, str) else float(given)
    except (InputError, TypeError, ValueError) as error:
        raise unknown.error("prior_deviation", f"prior_deviation = {given!r}: {error}") from None
    if not number > 0.0 or not np.isfinite(number):
        raise unknown.error("prior_deviation", f"prior_deviation = {given!r}; allowed: above 0")
    return number


def value_at(table: Mapping[str, Any], key: str) -> float:
    """Number of a resolved case at a dotted key; numbers, and [numbers], are entries of lists."""
    entry: Any = table
    for word in re.sub(r"\[(\d+)\]", r".\1", key).split("."):
        if isinstance(entry, list):
            if not word.isdigit():
                entry = entry[0][word]
                continue
            entry = entry[int(word)]
        else:
            entry = entry[word]
    while isinstance(entry, list):
        entry = entry[0]
    return float(entry)


def values_of(parameters: Sequence[Parameter], u: Sequence[float], name: str) -> dict[str, float]:
    """Values by key that belong to the data of a name."""
    return {
        key: one.value(x)
        for one, x in zip(parameters, u, strict=True)
        if not one.unknown.data or name in one.unknown.data
        for key in one.unknown.keys
    }
