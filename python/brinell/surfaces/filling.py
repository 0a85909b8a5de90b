# SPDX-License-Identifier: BSD-3-Clause
"""Points of a map that were not measured: told, or replaced by a smooth surface."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike, NDArray

from brinell.errors import InputError

FloatArray = NDArray[np.float64]

_ACCURACY = 1e-9
"""Residual of the heights that are put in, over that of a flat surface in their place."""


def filled(heights: ArrayLike) -> FloatArray:
    """Heights whose points that are not finite are replaced by a smooth surface through their neighbours.

    The surface is harmonic: each of its points is the mean of its four neighbours, or of those that the map has.

    Args:
        heights: [ny, nx]; NaN, or masked, where nothing was measured.

    Raises:
        InputError: they are not a map, or nothing was measured.
    """
    values = np.ma.filled(np.ma.asarray(heights, dtype=np.float64), np.nan)
    if values.ndim != 2 or values.size == 0:
        raise InputError(f"heights have the shape {values.shape}; allowed: [ny, nx] with one point or more")
    missing = ~np.isfinite(values)
    if missing.all():
        raise InputError("none of the heights is finite: there is nothing to fill the map from")
    if not missing.any():
        return values
    # Heights over their own mean: far from zero, as those of a scanner, the differences would lose digits.
    middle = values[~missing].mean()
    known = np.where(missing, 0.0, values - middle)
    result = values.copy()
    result[missing] = middle + _harmonic(missing, known)
    return result


def _harmonic(missing: NDArray[np.bool_], known: FloatArray) -> FloatArray:
    """The missing heights, by conjugate gradients on them alone.

    Args:
        missing: [ny, nx] where heights are looked for.
        known: [ny, nx], zero there.
    """
    number = np.full(missing.shape, -1)
    number[missing] = np.arange(np.count_nonzero(missing))
    exists, rows, columns = _neighbours(missing)
    among = np.where(exists, number[rows, columns], -1)
    weight = exists.sum(axis=1)
    source = np.where(exists, known[rows, columns], 0.0).sum(axis=1)

    def applied(heights: FloatArray) -> FloatArray:
        extended = np.append(heights, 0.0)  # which the number -1 takes
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
    """Of each missing point four: whether the map has it, and its row and column, or any if it has not; [points, 4]."""
    row, column = np.nonzero(missing)
    rows = row[:, None] + np.array([0, 0, -1, 1])
    columns = column[:, None] + np.array([-1, 1, 0, 0])
    ny, nx = missing.shape
    exists = (rows >= 0) & (rows < ny) & (columns >= 0) & (columns < nx)
    return exists, np.clip(rows, 0, ny - 1), np.clip(columns, 0, nx - 1)


def told_gaps(heights: FloatArray) -> str | None:
    """What to say of heights that are not finite; None if all of them are."""
    bad = np.argwhere(~np.isfinite(heights))
    if len(bad) == 0:
        return None
    row, column = bad[0].tolist()
    return (
        f"{len(bad)} of {heights.size} heights are not finite, the first one heights[{row}, {column}], "
        f"in row {row + 1} and column {column + 1}"
    )
