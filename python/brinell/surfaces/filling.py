# SPDX-License-Identifier: BSD-3-Clause
"""Points of a map that were not measured: error message, and replacement by a smooth surface."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike, NDArray

from brinell.errors import InputError

FloatArray = NDArray[np.float64]

_ACCURACY = 1e-9
"""Residual of the filled heights, relative to that of a flat surface."""


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
    missing = ~np.isfinite(values)
    if missing.all():
        raise InputError("none of the heights is finite: there is nothing to fill the map from")
    if not missing.any():
        return values
    # The mean is subtracted because differences of heights far from zero, as from a scanner, would lose digits.
    middle = values[~missing].mean()
    known = np.where(missing, 0.0, values - middle)
    result = values.copy()
    result[missing] = middle + _harmonic(missing, known)
    return result


def _harmonic(missing: NDArray[np.bool_], known: FloatArray) -> FloatArray:
    """Solves Laplace's equation for the missing heights by conjugate gradients.

    Args:
        missing: [ny, nx] true at missing points.
        known: [ny, nx] known heights, zero at missing points.

    Returns:
        [points] missing heights, in the order of `missing`.
    """
    number = np.full(missing.shape, -1)
    number[missing] = np.arange(np.count_nonzero(missing))
    exists, rows, columns = _neighbours(missing)
    among = np.where(exists, number[rows, columns], -1)
    weight = exists.sum(axis=1)
    source = np.where(exists, known[rows, columns], 0.0).sum(axis=1)

    def applied(heights: FloatArray) -> FloatArray:
        extended = np.append(heights, 0.0)  # index -1 refers to this zero
        return np.asarray(weight * heights - extended[among].sum(axis=-1))

    heights = np.zeros(len(weight))
    residual = source
    direction = residual / weight
    product = float(residual @ direction)
    goal = _ACCURACY**2 * product
    for _ in range(10 * len(weight)):
        if product <= goal:
            break
        image = applied(direction)
        step = product / float(direction @ image)
        heights = heights + step * direction
        residual = residual - step * image
        scaled = residual / weight
        before, product = product, float(residual @ scaled)
        direction = scaled + (product / before) * direction
    return heights


def _neighbours(missing: NDArray[np.bool_]) -> tuple[NDArray[np.bool_], NDArray[np.int64], NDArray[np.int64]]:
    """Four neighbours of each missing point, [points, 4]: whether it is on the map, its row, its column.

    Rows and columns of neighbours that are not on the map are clipped to valid indices.
    """
    row, column = np.nonzero(missing)
    rows = row[:, None] + np.array([0, 0, -1, 1])
    columns = column[:, None] + np.array([-1, 1, 0, 0])
    ny, nx = missing.shape
    exists = (rows >= 0) & (rows < ny) & (columns >= 0) & (columns < nx)
    return exists, np.clip(rows, 0, ny - 1), np.clip(columns, 0, nx - 1)


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
