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
    """First and last points of the holds: a load that stays while the depth goes on."""
    load = _median(data.y)
    top, deep = float(load.max()), float(np.abs(data.x).max())
    found, first = [], 0
    while first < load.size:
        last = first
        low = high = load[first]
        while last + 1 < load.size:
            low, high = min(low, load[last + 1]), max(high, load[last + 1])
            if high - low > _HELD * top:
                break
            last += 1
        moved = abs(float(data.x[last] - data.x[first]))
        due = float(abs(load[last] - load[first])) / top * deep
        if (
            last - first + 1 >= _FEWEST_HELD
            and load[first] > 2.0 * _HELD * top
            and moved > max(_CREEP * deep, 3.0 * due, 4.0 * _scatter(data.x[first : last + 1]))
        ):
            found.append((first, last))
            first = last + 1
        else:
            first += 1
    return found


def _median(values: FloatArray) -> FloatArray:
    """Medians over five neighbours."""
    padded = np.concatenate([values[:1].repeat(2), values, values[-1:].repeat(2)])
    return np.asarray(np.median(np.lib.stride_tricks.sliding_window_view(padded, 5), axis=1))


def _scatter(values: FloatArray) -> float:
    """Standard deviation about a line, from second differences."""
    if values.size < 3:
        return 0.0
    return float(np.sqrt(np.mean(np.diff(values, 2) ** 2) / 6.0))


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
