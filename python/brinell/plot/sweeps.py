# SPDX-License-Identifier: BSD-3-Clause
"""Key numbers of the runs of a sweep over what varies."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from brinell.errors import InputError
from brinell.plot import style
from brinell.plot.differences import case_of, differences, told
from brinell.plot.overlay import legend_beside, looks, of_runs
from brinell.plot.scales import Scale, si
from brinell.results import Run
from brinell.results.key_units import WITHOUT_PREFIX, key_unit
from brinell.scenarios import SCENARIOS

__all__ = ["KeyNumbers", "key_numbers_of", "sweep_numbers"]

_MOST_PANELS, _MOST_CURVES = 12, 8


@dataclass(frozen=True, eq=False)
class KeyNumbers:
    """What varies between runs, and their key numbers."""

    index: list[int]
    """Numbers of the runs."""
    varied: dict[str, list[Any]]
    """Values of each key that differs between the runs."""
    numbers: dict[str, tuple[str, list[float]]]
    """Unit, and a value per run, of each key number; NaN where a run does not have it."""


def key_numbers_of(runs: Mapping[int, Run]) -> KeyNumbers:
    """Key numbers of runs of one scenario, as in their reports."""
    varied = differences(list(runs.values()))
    numbers: dict[str, tuple[str, list[float]]] = {}
    for i, run in enumerate(runs.values()):
        for one in SCENARIOS[run.scenario].key_numbers(run):
            _, values = numbers.setdefault(one.name, (one.unit, [float("nan")] * len(runs)))
            values[i] = float(one.value)
    return KeyNumbers(list(runs), varied, numbers)


@style.figure
@of_runs
def sweep_numbers(runs: Sequence[Run], over: str | None = None, *, ax: style.Target | None = None) -> Figure | None:
    """Key numbers over a key that varies, a panel per number that differs, a curve per combination of other keys.

    Returns None if no number differs.

    Args:
        runs: runs, or a sweep.
        over: key of the case on the abscissa; None: the one with most values.

    Raises:
        InputError: the key does not differ between the runs, or is no number.
    """
    table = key_numbers_of(dict(enumerate(runs)))
    numeric = [key for key, values in table.varied.items() if all(_is_number(_first(value)) for value in values)]
    if over is not None and over not in numeric:
        raise InputError(f"over = {over!r}; allowed: a number that differs between the runs: {', '.join(numeric)}")
    shown = {name: one for name, one in table.numbers.items() if np.ptp(np.nan_to_num(one[1])) > 0.0}
    if not shown or not numeric:
        return None
    over = over or min(numeric, key=lambda key: _rank(key, table.varied[key]))
    place = np.array([float(_first(value)) for value in table.varied[over]])
    case = case_of(runs[0])
    families = _families(table, over, case)
    names = list(shown)[:_MOST_PANELS]
    columns = min(3, len(names))
    rows = -(-len(names) // columns)
    fig = style.new_figure(3.6 * columns + 1.2 * (len(families) > 1), 2.7 * rows)
    axes = np.atleast_1d(fig.subplots(rows, columns, squeeze=False)).ravel()
    scale = None
    if unit := key_unit(over, case):
        scale = Scale(1.0, "", unit) if unit in WITHOUT_PREFIX else si(float(np.abs(place).max()), unit)
    entries = looks(list(families))
    for panel, name in zip(axes, names, strict=False):
        _draw(panel, name, *shown[name], place / (scale.size if scale else 1.0), families, entries)
        panel.set_xlabel(f"{over}" + (f"  [{scale.unit}]" if scale else ""))
    for panel in axes[len(names) :]:
        panel.set_visible(False)
    legend_beside(axes[columns - 1], entries)
    return fig


def _rank(key: str, values: Sequence[Any]) -> tuple[int, bool]:
    """Order of the keys as abscissae: those with many values first, then those that are no property of a body."""
    return -len(set(values)), key.startswith(("lower.", "upper."))


def _first(value: Any) -> Any:
    return value[0] if isinstance(value, tuple) and value else value


def _is_number(value: Any) -> bool:
    return isinstance(value, (int, float)) and not isinstance(value, bool)


def _families(table: KeyNumbers, over: str, case: Mapping[str, Any]) -> dict[str, list[int]]:
    """Rows of the runs of each curve, by its name."""
    found: dict[str, list[int]] = {}
    others = [key for key in table.varied if key != over]
    for i in range(len(table.index)):
        name = ",  ".join(told(key, table.varied[key][i], case) for key in others) or "runs"
        found.setdefault(name, []).append(i)
    if len(found) > _MOST_CURVES:  # as of random points: no curves to tell apart
        return {"runs": list(range(len(table.index)))}
    return found


def _draw(
    ax: Axes,
    name: str,
    unit: str,
    values: Sequence[float],
    place: np.ndarray,
    families: Mapping[str, Sequence[int]],
    entries: Sequence[dict[str, Any]],
) -> None:
    height = np.array(values)
    scale = None
    if unit == "%":
        height = 100.0 * height
    elif unit:
        scale = si(float(np.nanmax(np.abs(height))), unit)
        height = height / scale.size
    is_scattered = len({round(float(x), 12) for x in place}) < len(place) and len(families) == 1
    for rows, look in zip(families.values(), entries, strict=True):
        order = sorted(rows, key=lambda i: place[i])
        line = {"linestyle": ""} if is_scattered else {}
        ax.plot(place[order], height[order], **(look | line), marker="o")
    ax.set_title(name)
    ax.set_ylabel(f"[{scale.unit if scale else unit}]" if unit else "")
