# SPDX-License-Identifier: BSD-3-Clause
"""Helpers for the reprs of several classes, on a terminal and in a notebook."""

from __future__ import annotations

import html
from collections.abc import Iterable, Mapping, Sequence
from typing import Any

__all__ = ["cells", "column_table", "fact_table"]


def cells(shape: Sequence[int]) -> str:
    """Size of a grid as text, x first: "16 x 8 x 4 cells".

    Args:
        shape: shape (nz, ny, nx) or (ny, nx) of an array on the grid.
    """
    return f"{' x '.join(map(str, reversed(shape)))} cells"


def fact_table(title: str, facts: Iterable[Sequence[str]], remarks: Iterable[str] = ()) -> str:
    """HTML table with one row per fact, and remarks below.

    Args:
        title: heading above the table.
        facts: rows of text: name, value and optionally a further cell.
        remarks: remarks, one line each.
    """
    rows = "".join(f"<tr>{_cells('td', fact, 'left')}</tr>" for fact in facts)
    lines = "".join(f"<div>{html.escape(remark)}</div>" for remark in remarks)
    return f"<div><b>{html.escape(title)}</b><table><tbody>{rows}</tbody></table>{lines}</div>"


def column_table(title: str, columns: Mapping[str, Any], units: Mapping[str, str], most: int = 10) -> str:
    """HTML table of columns with names and units at the head; of a long table only the first and last rows.

    Args:
        title: heading above the table.
        columns: arrays of equal length > 0, by name.
        units: units by name of the column; "1" for a dimensionless column.
        most: largest number of rows that are shown.
    """
    count = len(next(iter(columns.values())))
    shown = [*range(count)] if count <= most else [*range(most // 2), None, *range(count - most // 2, count)]
    head = _cells("th", columns, "right")
    named = _cells("th", (f"[{units[name]}]" if units.get(name, "1") != "1" else "" for name in columns), "right")
    rows = "".join(
        f"<tr>{_cells('td', ('…' if i is None else f'{column[i]:.6g}' for column in columns.values()), 'right')}</tr>"
        for i in shown
    )
    return (
        f"<div><b>{html.escape(title)}</b><table><thead><tr>{head}</tr><tr>{named}</tr></thead>"
        f"<tbody>{rows}</tbody></table></div>"
    )


def _cells(tag: str, texts: Iterable[str], align: str) -> str:
    return "".join(f'<{tag} style="text-align: {align}">{html.escape(text)}</{tag}>' for text in texts)
