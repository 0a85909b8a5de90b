# SPDX-License-Identifier: BSD-3-Clause
"""Numbers and symbols as text of a page, without mathematical notation."""

from __future__ import annotations

import re

from brinell.plot import style

__all__ = ["number", "percent", "quantity"]

_POWER = re.compile(r"\$\\times 10\^\{([^}]*)\}\$")
_RAISED = str.maketrans("0123456789" + style.MINUS, "⁰¹²³⁴⁵⁶⁷⁸⁹⁻")


def _plain(label: str) -> str:
    return _POWER.sub(lambda found: " × 10" + found[1].translate(_RAISED), label)


def number(value: float, digits: int = 3) -> str:
    """A pure number.

    >>> number(0.0223), number(4.5e-7)
    ('0.0223', '4.5 × 10⁻⁷')
    """
    return _plain(style.number(value, digits))


def quantity(value: float, unit: str, digits: int = 3) -> str:
    """A number with its unit and prefix; areas have no prefix, because it would apply to the length.

    >>> quantity(1.4925e9, "Pa"), quantity(0.0, "m"), quantity(2.5e-9, "m²")
    ('1.49 GPa', '0 m', '2500 µm²')
    """
    if value == 0.0 or not unit:
        return f"{number(value, digits)} {unit}".rstrip()
    if unit == "m²":
        size, name = (1e-12, "µm²") if abs(value) < 1e-7 else (1e-6, "mm²")
        return f"{number(value / size, digits)} {name}"
    return _plain(style.quantity(value, unit, digits))


def percent(share: float, digits: int = 2) -> str:
    """A share as a percentage.

    >>> percent(-0.00193)
    '−0.19 %'
    """
    return f"{number(100.0 * share, digits)} %"
