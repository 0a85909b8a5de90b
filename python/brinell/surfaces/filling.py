# SPDX-License-Identifier: BSD-3-Clause
"""Points of a map that were not measured: error message, and replacement by a smooth surface."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike, NDArray

from brinell import _core
from brinell.errors import InputError

FloatArray = NDArray[np.float64]


def filled(heights: ArrayLike) -> FloatArray:
    """Replaces points that are not finite by a smooth surface through their neighbours.

    The surface is harmonic: each filled point is the mean of its four neighbours, or of those within the map.

    Args:
        heights: [ny, nx] heights, NaN or masked where nothing was measured.

    Returns:
        [ny, nx] finite heights, in the unit of the argument.

    Raises:
        InputError: the array is not a two-dimensional map, or no point was measured.
    """
    values = np.ma.filled(np.ma.asarray(heights, dtype=np.float64), np.nan)
    if values.ndim != 2 or values.size == 0:
        raise InputError(f"heights have the shape {values.shape}; allowed: [ny, nx] with one point or more")
    return np.asarray(_core.filled(np.ascontiguousarray(values)))


def gap_message(heights: FloatArray) -> str | None:
    """Message about heights that are not finite; None if all are finite."""
    bad = np.argwhere(~np.isfinite(heights))
    if len(bad) == 0:
        return None
    row, column = bad[0].tolist()
    return (
        f"{len(bad)} of {heights.size} heights are not finite, the first one heights[{row}, {column}], "
        f"in row {row + 1} and column {column + 1}"
    )
