# SPDX-License-Identifier: BSD-3-Clause
"""Profiles over the depth, given as points or as columns, and terms of kinematic hardening."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from typing import Any, TypeAlias

from brinell import _core
from brinell._tables import Quantity
from brinell._values import plain
from brinell.errors import InputError

__all__ = ["Columns", "Profile", "columns_of", "terms_of"]

Columns: TypeAlias = tuple[tuple[Quantity, ...], tuple[Quantity, ...]]
"""Depths, and values at these depths."""

Profile: TypeAlias = Sequence[Any] | Mapping[str, Sequence[Quantity]]
"""Points (depth, value), columns (depths, values), or the columns by their names."""

_DEEPEST = 0.1
"""Depth [m] beyond which no layer reaches."""

_SENSIBLE = {"factor": (1e-2, 1e2), "value": (1e3, 1e11)}
"""Range of the magnitude of a value other than 0: factors [-] and stresses [Pa]."""


def columns_of(profile: Profile, name: str, value: str) -> Columns:
    """Depths and values of a profile.

    Args:
        profile: what the user gives.
        name: its argument, for messages.
        value: name of the values in a case file, "factor" or "value".

    Raises:
        InputError: it is no profile, or two points could be read in two ways.
    """
    form = f"{name}={{'depth': [...], '{value}': [...]}}, points [(depth, {value}), ...] or columns (depths, {value}s)"
    if isinstance(profile, Mapping):
        if set(profile) != {"depth", value}:
            raise InputError(f"{name} has the keys {', '.join(map(repr, profile)) or 'none'}; allowed: {form}")
        return _tuple(profile["depth"]), _tuple(profile[value])
    try:
        rows = [_tuple(row) for row in profile]
    except TypeError:
        rows = []
    is_points = bool(rows) and all(len(row) == 2 for row in rows)
    if is_points and len(rows) == 2:
        return _of_two(rows, name, value)
    if is_points:
        return tuple(row[0] for row in rows), tuple(row[1] for row in rows)
    if len(rows) == 2:
        return rows[0], rows[1]
    raise InputError(f"{name} = {profile!r}; allowed: {form}")


def _of_two(rows: Sequence[tuple[Quantity, ...]], name: str, value: str) -> Columns:
    """Two points or two columns, whichever makes sense; they look alike."""
    by_columns: Columns = (rows[0], rows[1])
    by_points: Columns = ((rows[0][0], rows[1][0]), (rows[0][1], rows[1][1]))
    if by_columns == by_points:
        return by_columns
    sensible = [one for one in (by_columns, by_points) if _is_sensible(one, value)]
    if len(sensible) == 1:
        return sensible[0]
    raise InputError(
        f"{name} = {list(rows)!r} can be two points or two columns; allowed: "
        f"{name}={{'depth': [...], '{value}': [...]}}, which says what is what, or depths with a unit, as '3 um'"
    )


def _is_sensible(columns: Columns, value: str) -> bool:
    depths: list[Any] = [_number(one, "m") for one in columns[0]]
    values: list[Any] = [_number(one, "" if value == "factor" else "Pa") for one in columns[1]]
    if None in depths or None in values:
        return False
    least, most = _SENSIBLE[value]
    return 0.0 <= depths[0] < depths[1] <= _DEEPEST and all(
        least <= abs(one) <= most or (one == 0.0 and value != "factor") for one in values
    )


def _number(quantity: Any, unit: str) -> float | None:
    """The number in SI; None if its unit is another one."""
    try:
        return _core.quantity_like(quantity, unit) if isinstance(quantity, str) else float(quantity)
    except (InputError, TypeError, ValueError):
        return None


def _tuple(values: Iterable[Any]) -> tuple[Any, ...]:
    if isinstance(values, (str, bytes)):
        raise TypeError
    return tuple(plain(values))


def terms_of(back_stresses: Iterable[Any]) -> tuple[tuple[Quantity, Quantity], ...]:
    """Pairs (modulus, recall) of kinematic hardening, given as pairs or as in the case file by their names.

    Raises:
        InputError: an entry is none of these, or has a recall that no material has, as if columns were given.
    """
    form = "allowed: pairs (modulus, recall), as [('90 GPa', 600), ('10 GPa', 50)]"
    terms = []
    for i, term in enumerate(back_stresses):
        if isinstance(term, Mapping):
            if not {"modulus"} <= set(term) <= {"modulus", "recall"}:
                raise InputError(f"back_stresses[{i}] has the keys {', '.join(map(repr, term))}; {form}")
            pair: tuple[Any, ...] = (plain(term["modulus"]), plain(term.get("recall", 0.0)))
        else:
            try:
                pair = _tuple(term)
            except TypeError:
                pair = ()
        if len(pair) != 2:
            raise InputError(f"back_stresses[{i}] = {term!r}; {form}")
        if not isinstance(pair[1], str) and pair[1] > _MOST_RECALL:
            raise InputError(f"back_stresses[{i}] has the recall {pair[1]:g}, which no material has; {form}")
        terms.append(pair)
    return tuple(terms)


_MOST_RECALL = 1e6
"""Above it a back stress saturates at strains of millionths."""
