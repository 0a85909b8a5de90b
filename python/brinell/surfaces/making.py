# SPDX-License-Identifier: BSD-3-Clause
"""Surfaces that are made: self-affine ones, and those of a function."""

from __future__ import annotations

import warnings
from collections.abc import Callable, Sequence

import numpy as np

from brinell import _core
from brinell._names import level_of_caller
from brinell.errors import InputError
from brinell.surfaces.heightmap import HeightMap
from brinell.surfaces.units import pair


def random(
    size: float | str | Sequence[float | str],
    points: int | Sequence[int],
    *,
    cutoff: float | str,
    rms_height: float | str | None = None,
    rms_slope: float | None = None,
    hurst: float = 0.8,
    rolloff: float | str | None = None,
    seed: int = 0,
) -> HeightMap:
    """A Gaussian, isotropic, self-affine surface, by the code that a texture of type "random" is made by.

    Heights are those of `brinell.RandomSurface` at the points: more points show the same surface. Lengths in m, or text
    with a unit such as "10 um".

    Args:
        size: period and longest wavelength, along x and y if they differ.
        points: how many, along x and y if they differ; their distances divide the size.
        cutoff: shortest wavelength.
        rms_height: root mean square of the height over a period; or
        rms_slope: that of the gradient's length. One of the two.
        hurst: exponent of Hurst, 0 to 1.
        rolloff: wavelength above which waves are not higher any more; None: self-affine up to the size.
        seed: other numbers give other surfaces.

    Returns:
        A periodic map around x = y = 0.

    Raises:
        InputError: something is out of range.
    """
    sizes = [_length(s) for s in ([size] if isinstance(size, str | int | float) else size)]
    counts = [int(n) for n in ([points] if isinstance(points, int) else points)]
    if len(sizes) not in (1, 2) or len(counts) not in (1, 2):
        raise InputError(f"size = {size!r}, points = {points!r}; allowed: one for both axes, or two")
    if not 0 <= seed < 2**63:
        raise InputError(f"seed = {seed}; allowed: 0 to 2^63 - 1")
    (size_x, size_y), (nx, ny) = (sizes[0], sizes[-1]), (counts[0], counts[-1])
    heights = _core.random_heights(
        (size_x, size_y),
        (nx, ny),
        _length(cutoff),
        None if rms_height is None else _length(rms_height),
        rms_slope,
        hurst,
        None if rolloff is None else _length(rolloff),
        seed,
    )
    made = HeightMap(heights, (size_x / nx, size_y / ny), periodic=True)
    _warn_of_lost_waves(_length(cutoff), max(made.spacing))
    return made


def _warn_of_lost_waves(cutoff: float, distance: float) -> None:
    """Points that are farther apart than half a wave do not show it, and nothing that reads them can tell."""
    if distance <= 0.5 * cutoff * (1.0 + 1e-9):
        return
    from brinell.case import CaseWarning

    warnings.warn(
        f"points at {distance:.3g} m do not show waves down to the cutoff of {cutoff:.3g} m: what is shorter than "
        f"{2.0 * distance:.3g} m appears as other waves, and the slope is too small; take 8 points per cutoff",
        CaseWarning,
        stacklevel=level_of_caller(),
    )


def _length(value: float | str) -> float:
    return _core.length(value) if isinstance(value, str) else float(value)


def sampled(
    height: Callable[[float, float], float],
    spacing: Sequence[float],
    *,
    x: tuple[float, float],
    y: tuple[float, float],
) -> HeightMap:
    """A texture from a function of x and y.

    The function itself could not be stored with a result or taken up by another process; its heights can.

    Args:
        height: of the surface at a place (x, y) on the body, out of it positive; all in m.
        spacing: (dx, dy), distances of the points [m]: as fine as the cells or finer; made a little smaller to fit into
            the intervals.
        x: from, to [m]; outside, the surface is smooth, so the heights should fade to zero towards the ends.
        y: the same along y.

    Raises:
        InputError: the intervals are empty, or the function gives something that is no finite number.
    """
    distances = pair(spacing)
    axes, steps = [], []
    for name, (start, end), distance in (("x", x, distances[0]), ("y", y, distances[1])):
        if not (np.isfinite([start, end]).all() and start < end and distance > 0):
            raise InputError(
                f"{name} = ({start}, {end}) with points every {distance} m; allowed: from < to, spacing > 0"
            )
        axes.append(np.linspace(start, end, 1 + int(np.ceil((end - start) / distance - 1e-9))))
        steps.append(float(axes[-1][1] - axes[-1][0]))
    heights = np.empty((len(axes[1]), len(axes[0])))
    for j, at_y in enumerate(axes[1].tolist()):
        for i, at_x in enumerate(axes[0].tolist()):
            value = height(at_x, at_y)
            try:
                heights[j, i] = value
            except (TypeError, ValueError) as error:
                raise InputError(f"the height at x = {at_x} m, y = {at_y} m is {value!r}; allowed: a number") from error
            if not np.isfinite(heights[j, i]):
                raise InputError(f"the height at x = {at_x} m, y = {at_y} m is {value!r}; allowed: finite numbers")
    return HeightMap(heights, (steps[0], steps[1]), 0.5 * (x[0] + x[1]), 0.5 * (y[0] + y[1]))
