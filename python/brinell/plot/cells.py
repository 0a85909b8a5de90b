# SPDX-License-Identifier: BSD-3-Clause
"""Cell values on regular grids as images: extent of the cells, the plane y = 0, the edge of contact between cells."""

from __future__ import annotations

from typing import Literal

import numpy as np
from matplotlib.axes import Axes
from matplotlib.colors import Normalize
from matplotlib.image import AxesImage
from numpy.typing import NDArray

from brinell.results import ContactFields

__all__ = [
    "at_centre",
    "contact_edge",
    "contact_patch",
    "contact_pieces",
    "contact_span",
    "draw_cells",
    "extent",
    "middle_rows",
    "refined",
]

FloatArray = NDArray[np.float64]


def contact_edge(contact: ContactFields) -> FloatArray:
    """Level-set function (ny, nx) whose zero line is the edge of contact, positive inside the contact [-].

    Near the edge the pressure grows with the square root of the distance and the gap with its power 3/2, so that p^2
    and gap^(2/3) are linear there and linear interpolation finds the edge within a fraction of a cell.
    """
    touching = contact.pressure > 0.0
    if not np.any(touching):
        return np.full_like(contact.pressure, -1.0)
    inside = np.where(touching, contact.pressure / contact.pressure.max(), 0.0) ** 2
    outside = np.where(touching, 0.0, np.clip(contact.gap, 0.0, None)) ** (2.0 / 3.0)
    # Equal slopes on both sides: compare the first cells beyond the edge with the last ones before it.
    rim = np.zeros_like(touching)
    rim[:, 1:] |= touching[:, 1:] != touching[:, :-1]
    rim[:, :-1] |= touching[:, 1:] != touching[:, :-1]
    rim[1:, :] |= touching[1:, :] != touching[:-1, :]
    rim[:-1, :] |= touching[1:, :] != touching[:-1, :]
    first, last = outside[rim & ~touching], inside[rim & touching]
    slope = float(last.mean() / first.mean()) if first.size and first.mean() > 0.0 else 1.0
    return inside - slope * outside


def contact_span(contact: ContactFields, along: Literal["x", "y"] = "x", at: float = 0.0) -> tuple[float, float]:
    """First and last place of the contact on a line in the plane of contact [m]; (0, 0) if the line misses it.

    Args:
        contact: where.
        along: direction of the line.
        at: the other coordinate of the line [m].
    """
    pieces = contact_pieces(contact, along, at)
    return (pieces[0][0], pieces[-1][1]) if pieces else (0.0, 0.0)


def contact_pieces(
    contact: ContactFields, along: Literal["x", "y"] = "x", at: float = 0.0
) -> list[tuple[float, float]]:
    """First and last place of each piece of the contact on a line [m]; rough surfaces touch in several.

    Args:
        contact: where.
        along: direction of the line.
        at: the other coordinate of the line [m].
    """
    edge = contact_edge(contact)
    x, others, table = (contact.x, contact.y, edge.T) if along == "x" else (contact.y, contact.x, edge)
    line = np.array([np.interp(at, others, values) for values in table])
    inside = np.flatnonzero(line > 0.0)

    def crossing(i: int, j: int) -> float:
        if not 0 <= j < len(line):
            return float(x[i])
        t = line[i] / (line[i] - line[j])
        return float(x[i] + t * (x[j] - x[i]))

    runs = np.split(inside, np.flatnonzero(np.diff(inside) > 1) + 1)
    return [(crossing(run[0], run[0] - 1), crossing(run[-1], run[-1] + 1)) for run in runs if run.size]


def contact_patch(contact: ContactFields, scale: float) -> tuple[tuple[float, float], tuple[float, float]]:
    """Ranges of x and y around the contact, over the scale, within the grid."""
    left, right, bottom, top = extent(contact.x, contact.y, scale)
    columns, rows = np.any(contact.pressure > 0.0, axis=0), np.any(contact.pressure > 0.0, axis=1)
    reach_x = 1.25 * np.abs(contact.x[columns]).max() / scale + (right - left) / contact.x.size
    reach_y = 1.25 * np.abs(contact.y[rows]).max() / scale + (top - bottom) / contact.y.size
    return (max(left, -reach_x), min(right, reach_x)), (max(bottom, -reach_y), min(top, reach_y))


def refined(values: FloatArray, factor: int) -> FloatArray:
    """Cell values [y][x] on cells `factor` times smaller: linear between centres, constant beyond the outer centres."""

    def along(array: FloatArray, count: int) -> FloatArray:  # last axis
        position = np.clip((np.arange(count * factor) + 0.5) / factor - 0.5, 0.0, count - 1.0)
        left = np.minimum(position.astype(int), max(count - 2, 0))
        t = position - left
        right = np.minimum(left + 1, count - 1)
        mixed: FloatArray = array[..., left] * (1.0 - t) + array[..., right] * t
        return mixed

    ny, nx = values.shape
    return np.ascontiguousarray(along(along(values, nx).T, ny).T)


def extent(x: FloatArray, y: FloatArray, scale: float) -> tuple[float, float, float, float]:
    """Outer cell edges for imshow, over the scale."""
    half_x = 0.5 * (x[1] - x[0]) if len(x) > 1 else 0.5
    half_y = 0.5 * (y[1] - y[0]) if len(y) > 1 else 0.5
    return (
        float(x[0] - half_x) / scale,
        float(x[-1] + half_x) / scale,
        float(y[0] - half_y) / scale,
        float(y[-1] + half_y) / scale,
    )


def middle_rows(y: FloatArray) -> NDArray[np.intp]:
    """The rows of cells at y = 0: one, or the two beside it."""
    distance = np.abs(y)
    near = np.isclose(distance, distance.min(), rtol=0.0, atol=1e-6 * (abs(y[-1] - y[0]) + 1e-30))
    return np.flatnonzero(near)


def at_centre(y: FloatArray, values: FloatArray) -> FloatArray:
    """Values on the plane y = 0 of an array [..., y, x]: one row of cells, or the mean of the two beside the plane."""
    return np.asarray(values[..., middle_rows(y), :].mean(axis=-2), dtype=np.float64)


def draw_cells(
    ax: Axes,
    x: FloatArray,
    y: FloatArray,
    values: FloatArray,
    scale: float,
    *,
    cmap: str,
    norm: Normalize,
    interpolation: str,
) -> AxesImage:
    """Draws cell values on a regular grid, to scale; `y` may run downwards (depth)."""
    return ax.imshow(
        values,
        origin="lower",
        extent=extent(x, y, scale),
        aspect="equal",
        cmap=cmap,
        norm=norm,
        interpolation=interpolation,
        interpolation_stage="data",
    )
