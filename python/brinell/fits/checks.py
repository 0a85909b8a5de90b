# SPDX-License-Identifier: BSD-3-Clause
"""What is wrong with measured curves: signs, units, drift, holds, turns that the case does not have."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from brinell.fits.data import Data, FloatArray
from brinell.fits.text import as_text

__all__ = ["branches_of", "checked_against", "checked_sign", "turning_points", "without_holds"]

_HELD = 0.01
"""Part of the largest load within which a load is held."""
_FEWEST_HELD = 5
_FLAT, _SURE = 0.5, 3.0
"""Slope of a hold, as a part of the slope that is due, below which it has to lie with so many standard deviations."""
_CLEAR = 8.0
"""Depth that a hold has to add, in standard deviations of the depths."""
_MOST_POINTS = 1500
"""Points among which holds are looked for; of more only some."""
_NEARBY = 21
"""Points from which a scatter is found."""
_CREEP = 0.005
"""Part of the largest depth that a hold has to add before it is told."""
_OTHER_LOAD = (0.5, 1.15)
"""Largest measured load over that of the case: beyond, one of them is wrong."""
_OTHER_DEPTH = 20.0
"""Factor between measured and computed depths at which a unit is wrong."""
_TURN = 0.25
"""Part of the smallest branch of the case by which a curve has to come back to have turned."""


def turning_points(values: FloatArray, least: float) -> list[int]:
    """Indices of first point, turns and last point of a sequence that rises first.

    Args:
        values: the sequence.
        least: distance that it has to come back from a turn; smaller ones are scatter.
    """
    points, direction, extreme = [0], 1.0, 0
    for i, value in enumerate(values):
        if direction * (value - values[extreme]) >= 0.0:
            extreme = i
        elif direction * (values[extreme] - value) > least:
            points.append(extreme)
            direction, extreme = -direction, i
    return [*points, len(values) - 1]


def branches_of(data: Data, driven: FloatArray, model: FloatArray) -> FloatArray:
    """Number, from 0, of the branch (loading, unloading, reloading) of each measured point.

    Args:
        data: the curve.
        driven: its values of what the case imposes, load or depth.
        model: those of the run, from 0, in order.

    Raises:
        InputError: the curve turns more often than the case.
    """
    turns = model[turning_points(model, 0.0)]
    smallest = float(np.abs(np.diff(turns)).min(initial=math.inf))
    found = turning_points(driven, _TURN * min(smallest, float(np.ptp(driven))))
    allowed = len(turns) - 1
    if len(found) - 1 > allowed:
        raise data.error(
            f"the curve has {len(found) - 1} branches (loading, unloading, ...), the case {allowed}; allowed: points "
            "in the order of the test, and the loads of the test in indentation.load (or approach) and cycles"
        )
    return np.asarray(np.searchsorted(np.array(found[1:-1]), np.arange(driven.size), side="left"))


def checked_sign(data: Data) -> None:
    """Refuses a load-depth curve with a wrong sign.

    Raises:
        InputError: loads or depths are negative.
    """
    if data.kind != "load-depth":
        return
    for values, what, axis in ((data.y, "load", "y"), (data.x, "depth", "x")):
        size = float(np.abs(values).max())
        if size == 0.0:
            raise data.error(f"all {what}s are 0")
        if values.max() < 0.5 * size:
            raise data.error(
                f"{what}s are negative, down to {as_text(float(values.min()), data.units[axis == 'y'])}; allowed: "
                f'positive in compression and into the body; reverse = ["{axis}"] turns the sign'
            )
    peak = int(np.argmax(data.y))
    if peak > 1 and np.corrcoef(data.x[: peak + 1], data.y[: peak + 1])[0, 1] < 0.0:
        raise data.error('the depth falls while the load rises; allowed: depth into the body; reverse = ["x"] turns it')


def without_holds(data: Data) -> tuple[Data, list[str]]:
    """The curve without the points at held loads, and what is to be told of them."""
    if data.kind != "load-depth" or data.holds == "keep":
        return data, []
    notes = []
    keep = np.ones(data.x.size, dtype=bool)
    shift = np.zeros(data.x.size)
    top, deep = float(data.y.max()), float(data.x.max())
    for first, last in _holds(data):
        added = float(data.x[last] - data.x[first])
        level = float(np.mean(data.y[first : last + 1]))
        keep[first + 1 : last + 1] = False
        if data.holds == "subtract":
            shift[first + 1 :] += added
        rate = ""
        if data.time is not None and (lasted := float(data.time[last] - data.time[first])) > 0.0:
            whole = abs(added / lasted) * float(np.ptp(data.time))
            rate = (
                f" in {as_text(lasted, '')} s; as a drift that would be {as_text(whole, 'm')} or "
                f"{as_text(100 * whole / deep, '')} % of the depth over the whole test, see machine.drift"
            )
        kind = "creep or drift" if level > 0.5 * top else "drift"
        done = (
            "subtracted" if data.holds == "subtract" else 'left in the later points (holds = "subtract" takes it off)'
        )
        notes.append(
            f"data {data.name!r}: the load is held at {as_text(level, 'N')} (points {first + 1} to {last + 1}) while "
            f"the depth changes by {as_text(added, 'm')}, {kind}{rate}; its points are left out, the depth is {done}"
        )
    return replace(data, x=data.x - shift).at(keep), notes


def _holds(data: Data) -> list[tuple[int, int]]:
    """First and last points of the holds: the depth goes on, and the load surely rises less than it does elsewhere."""
    every = -(-data.y.size // _MOST_POINTS)
    load, depth = data.y[::every], data.x[::every]
    top, deep = float(load.max()), float(np.abs(depth).max())
    slopes, noise = _FLAT * _usual_slopes(load, depth), _scatter(load)
    least = max(_CREEP * deep, _CLEAR * float(np.median(_scatter(depth))))
    sums = [np.concatenate([[0.0], np.cumsum(one)]) for one in (depth, load, depth**2, depth * load, load**2)]
    found, first = [], 0
    while first + _FEWEST_HELD <= load.size:
        last = _held_until(first, sums, depth, slopes, noise, top, least) if load[first] > 2.0 * _HELD * top else first
        if last > first:
            level = float(np.median(load[first : last + 1]))
            near = np.abs(load[first : last + 1] - level) <= np.maximum(
                3.0 * noise[first : last + 1], 0.5 * _HELD * top
            )
            inside = first + np.flatnonzero(near)
            if inside.size >= _FEWEST_HELD and abs(depth[inside[-1]] - depth[inside[0]]) > least:
                found.append((every * int(inside[0]), every * int(inside[-1])))
        first = last + 1
    return found


def _held_until(
    first: int,
    sums: Sequence[FloatArray],
    depth: FloatArray,
    slopes: FloatArray,
    noise: FloatArray,
    top: float,
    least: float,
) -> int:
    """Last point of the longest line from a point on whose slope is surely flat; the point itself if there is none."""
    ends = np.arange(first + _FEWEST_HELD - 1, depth.size)
    ends = ends[np.abs(depth[ends] - depth[first]) > least]
    if not ends.size:
        return first
    count = ends - first + 1.0
    x, y, xx, xy, yy = (one[ends + 1] - one[first] for one in sums)
    spread = np.maximum(xx - x * x / count, 1e-300)
    both = xy - x * y / count
    is_flat = np.abs(both) / spread + _SURE * noise[first] / np.sqrt(spread) < slopes[first]
    off = yy - y * y / count - both * both / spread
    held = is_flat & (off / count < (1.0 + 2.0 * _SURE / np.sqrt(count)) * noise[first] ** 2 + (0.1 * _HELD * top) ** 2)
    return int(ends[held].max(initial=first))


def _usual_slopes(load: FloatArray, depth: FloatArray) -> FloatArray:
    """Least slope of load over depth at each point: load by depth while it rises, the elastic slope after the peak."""
    result = np.maximum(load, 0.0) / np.maximum(np.abs(depth), 1e-300)
    peak, top = int(np.argmax(load)), float(load.max())
    below = [np.flatnonzero(load[peak:] < part * top) for part in (0.8, 0.4)]
    if all(one.size for one in below):
        high, low = (float(depth[peak + one[0]]) for one in below)
        if high > low:
            stiffness = 0.4 * top / (high - low)
            elastic = stiffness * np.cbrt(np.maximum(load[peak:], 0.0) / top)
            result[peak:] = np.maximum(result[peak:], 0.5 * elastic)
    return result


def _scatter(values: FloatArray) -> FloatArray:
    """Standard deviation about a line at each point, from the second differences nearby."""
    if values.size < _NEARBY:
        return np.full(values.size, float(np.sqrt(np.mean(np.diff(values, 2) ** 2) / 6.0)) if values.size > 2 else 0.0)
    seconds = np.abs(np.diff(values, 2))
    own = np.median(np.lib.stride_tricks.sliding_window_view(np.pad(seconds, _NEARBY // 2, mode="reflect"), _NEARBY), 1)
    return np.asarray(np.pad(1.4826 / np.sqrt(6.0) * own, 1, mode="edge"))


def checked_against(data: Data, loads: FloatArray, depths: Sequence[float], is_load_driven: bool) -> list[str]:
    """Compares the size of a load-depth curve with runs, and says what should be looked at.

    Args:
        data: the curve.
        loads: loads of a run.
        depths: largest depths of runs at several values of the unknowns.
        is_load_driven: whether the case imposes the load.

    Raises:
        InputError: loads or depths are of another size.
    """
    top, deep = float(data.y.max()), float(data.x.max())
    notes = []
    if is_load_driven:
        ratio = top / float(loads.max())
        if not _OTHER_LOAD[0] <= ratio <= _OTHER_LOAD[1]:
            raise data.error(
                f"the loads reach {as_text(top, 'N')}, those of the case {as_text(float(loads.max()), 'N')}; "
                f"allowed: the loads of the test in indentation.load{_unit_hint(ratio)}"
            )
        if not 0.95 <= ratio <= 1.05:
            notes.append(
                f"data {data.name!r}: the loads reach {as_text(top, 'N')}, those of the case "
                f"{as_text(float(loads.max()), 'N')}: the unloading of the run does not begin "
                "where that of the test does"
            )
    lowest, highest = min(depths), max(depths)
    if not lowest / _OTHER_DEPTH <= deep <= highest * _OTHER_DEPTH:
        ratio = deep / (highest if deep > highest else lowest)
        raise data.error(
            f"the depths reach {as_text(deep, 'm')}, those of runs within the bounds {as_text(lowest, 'm')} to "
            f"{as_text(highest, 'm')}; allowed: depths of that size{_unit_hint(ratio)}"
        )
    return notes


def _unit_hint(ratio: float) -> str:
    for factor in (1e-9, 1e-6, 1e-3, 1e3, 1e6, 1e9):
        if factor / 4.0 < ratio < factor * 4.0:
            return f" (a factor of about {factor:g}: is the unit right? units = {{x = ..., y = ...}})"
    return ""
