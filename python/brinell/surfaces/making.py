# SPDX-License-Identifier: BSD-3-Clause
"""Generated surfaces: random self-affine ones, and those of a function."""

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
    """Generates a Gaussian, isotropic, self-affine surface, the same as a texture of type "random".

    The heights are those of `brinell.RandomSurface` at the points; more points resolve the same surface more finely.
    Lengths are in m, or text with a unit such as "10 um".

    Args:
        size: period, which is the longest wavelength; a pair if it differs along x and y.
        points: number of points per period; a pair if it differs along x and y.
        cutoff: shortest wavelength.
        rms_height: root mean square of the height over a period. Exactly one of `rms_height` and `rms_slope` is given.
        rms_slope: root mean square of the magnitude of the gradient [-].
        hurst: Hurst exponent, 0 to 1 [-].
        rolloff: wavelength above which the spectrum is constant; None: self-affine up to `size`.
        seed: seed of the random numbers, 0 to 2^63 - 1; other seeds give other surfaces.

    Returns:
        A periodic map centred at x = y = 0.

    Raises:
        InputError: an argument is out of range.
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
    """Warns if the points are too far apart for the shortest wave (aliasing), which cannot be detected later."""
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
    """Samples a function of x and y as a height map.

    A map is used because the function itself could not be stored with a result or sent to another process.

    Args:
        height: function of the coordinates x and y on the body [m] that returns the height, positive out of the body
            [m].
        spacing: distances (dx, dy) of the points [m], not larger than the cells; they are reduced slightly to divide
            the intervals.
        x: interval (from, to) along x [m]. The height is zero outside, so the function should decay to zero towards
            the ends.
        y: interval along y [m].

    Raises:
        InputError: an interval is empty, or the function returns something else than a finite number.
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
