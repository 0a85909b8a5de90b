# SPDX-License-Identifier: BSD-3-Clause
"""What the reprs of several classes have in common."""

from __future__ import annotations

from collections.abc import Sequence

__all__ = ["cells"]


def cells(shape: Sequence[int]) -> str:
    """Size of a grid, x first: "16 x 8 x 4 cells".

    Args:
        shape: (nz, ny, nx) or (ny, nx), of an array on it.
    """
    return f"{' x '.join(map(str, reversed(shape)))} cells"
