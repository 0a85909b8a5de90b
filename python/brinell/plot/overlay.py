# SPDX-License-Identifier: BSD-3-Clause
"""Several results in one figure: a colour, a dash pattern and a label for each, and a legend beside the axes."""

from __future__ import annotations

import functools
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any, Concatenate, ParamSpec, Protocol, TypeVar

import numpy as np
from matplotlib.axes import Axes
from matplotlib.lines import Line2D
from numpy.typing import ArrayLike

from brinell.plot import style
from brinell.plot.differences import labels_by_difference
from brinell.results import Run, RunError
from brinell.scenarios import Scenario

__all__ = [
    "Entry",
    "HasRuns",
    "Look",
    "entries",
    "evenly_chosen",
    "largest",
    "legend_beside",
    "looks",
    "of_runs",
    "require_scenario",
    "zero_line",
]

_P = ParamSpec("_P")
_R = TypeVar("_R")

Look = dict[str, Any]
"""How a curve is drawn and named: keywords of `Axes.plot`."""

# Each curve has a dash of its own beside its colour: equal results, which lie on each other, must both show.
_DASHES: tuple[Any, ...] = ("-", (0, (4, 2)), (0, (1, 1.2)), (0, (5, 1.5, 1, 1.5)))


@dataclass(frozen=True, eq=False)
class Entry:
    """One result and the look of its curves."""

    run: Run
    label: str
    look: Look


class HasRuns(Protocol):
    """A sweep: its runs by the number of their point."""

    @property
    def runs(self) -> Mapping[int, Run]:
        """Runs that have finished."""


def of_runs(
    draw: Callable[Concatenate[Sequence[Run], _P], _R],
) -> Callable[Concatenate[Run | Iterable[Run] | Mapping[int, Run] | HasRuns, _P], _R]:
    """Decorator with which a figure of several runs also accepts a single run, a sweep, or the runs of a sweep."""

    @functools.wraps(draw)
    def drawn(runs: Run | Iterable[Run] | Mapping[int, Run] | HasRuns, /, *args: _P.args, **options: _P.kwargs) -> _R:
        if isinstance(runs, Run):
            runs = [runs]
        elif not isinstance(runs, Iterable):  # a sweep
            runs = runs.runs
        return draw(list(runs.values() if isinstance(runs, Mapping) else runs), *args, **options)

    drawn.takes_one_run = True  # type: ignore[attr-defined]
    return drawn


def require_scenario(runs: Sequence[Run], scenario: Scenario) -> None:
    """Checks that all runs are of one scenario.

    Raises:
        RunError: a run is of another scenario.
        ValueError: there is no run.
    """
    if not runs:
        raise ValueError("no run to draw")
    for run in runs:
        if run.scenario != scenario:
            raise RunError(f"{run.path}: is of scenario {run.scenario!r}, this figure needs {scenario!r}")


def entries(runs: Sequence[Run], scenario: Scenario) -> list[Entry]:
    """The results in the order given; each keeps its look in all figures.

    Raises:
        RunError: a run is of another scenario.
        ValueError: there is no run.
    """
    require_scenario(runs, scenario)
    labels = [style.as_written(label) for label in _labels(runs)]
    return [Entry(*each) for each in zip(runs, labels, looks(labels), strict=True)]


def looks(labels: Sequence[str]) -> list[Look]:
    """Looks that differ in colour and in grey."""
    return [
        {
            "label": label,
            "color": style.CATEGORIES[i % len(style.CATEGORIES)],
            "linestyle": _DASHES[i % len(_DASHES)],
        }
        for i, label in enumerate(labels)
    ]


def _labels(runs: Sequence[Run]) -> list[str]:
    """Titles if they distinguish the runs, else what differs between the cases, else folders, else whole paths."""

    def tell_apart(labels: Sequence[str]) -> bool:
        return all(labels) and len(set(labels)) == len(runs)

    if tell_apart(titles := [run.title for run in runs]):
        return titles
    if by_difference := labels_by_difference(runs):
        return by_difference
    if tell_apart(folders := [run.path.name if run.memory is None else "" for run in runs]):
        return folders
    if any(run.memory is not None for run in runs):  # no folder: by their order
        return [f"{run.title or run.scenario} ({i})" for i, run in enumerate(runs, 1)]
    return [str(run.path) for run in runs]


def legend_beside(ax: Axes, handles: Sequence[Look], title: str | None = None) -> None:
    """A legend to the right of axes, where it covers no data; none for a single curve without a title."""
    if len(handles) < 2 and title is None:
        return
    ax.legend(
        handles=[Line2D([], [], **look) for look in handles],
        title=title,
        alignment="left",
        loc="upper left",
        bbox_to_anchor=(1.02, 1.0),
        borderaxespad=0.0,
    )


def evenly_chosen(handles: Sequence[Look], most: int) -> list[Look]:
    """At most so many entries of a legend, evenly spaced, with the first and the last one."""
    chosen = np.unique(np.linspace(0, len(handles) - 1, min(most, len(handles))).round().astype(int))
    return [handles[i] for i in chosen]


def largest(arrays: Iterable[ArrayLike]) -> float:
    """Largest magnitude of the values; 0 if there are none."""
    return max((float(np.abs(a).max(initial=0.0)) for a in map(np.asarray, arrays)), default=0.0)


def zero_line(ax: Axes) -> None:
    """Draws the level 0 behind the curves."""
    ax.axhline(0.0, color="0.8", linewidth=0.8, zorder=0.5)
