# SPDX-License-Identifier: BSD-3-Clause
"""Numbers in messages; what draws is imported when the first of them is told, so that the command starts fast."""

from __future__ import annotations

__all__ = ["as_text"]


def as_text(value: float, unit: str) -> str:
    """A value with its unit, as plain text."""
    from brinell.report.text import number, quantity

    return f"{number(value)} {unit}" if unit in ("degrees", "degC") else quantity(value, unit)
