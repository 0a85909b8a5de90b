# SPDX-License-Identifier: BSD-3-Clause
"""What figures and reports ask of a scenario; its own module has the answers."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Literal

if TYPE_CHECKING:  # what draws is imported by the functions that draw, and all of this knows the scenarios
    from matplotlib.figure import Figure

    from brinell.plot.history import Panel
    from brinell.results import Run, Snapshot
    from brinell.scenarios import Scenario

__all__ = ["Drawing", "Drawings", "KeyNumber", "Traits"]


@dataclass(frozen=True)
class KeyNumber:
    """A result that one looks for first."""

    name: str
    value: float
    """SI; an integer is shown with all its digits."""
    unit: str = ""
    """"%" for a share of one."""
    over: Literal["load", "interference", "energy", "peak_pressure"] | None = None
    """The value at first yield that it is compared with."""
    digits: int = 3


@dataclass(frozen=True)
class Drawing:
    """A figure of one run of a scenario, or of several."""

    draw: Callable[[Sequence[Run]], Figure | None]
    """None: the runs have nothing to draw there."""
    caption: str = ""
    """A sentence or two, for readers who see it and for those who cannot; empty: it does not suit a run by itself."""


@dataclass(frozen=True)
class Drawings:
    """The figures that only one scenario has: a command of ``brinell plot``, and the first ones of a report."""

    command: str
    help: str
    figures: Mapping[str, Drawing]
    """By file name."""


@dataclass(frozen=True, kw_only=True)
class Traits:
    """What is known of a scenario besides its keys, its columns and its lists, which the core tells."""

    name: Scenario
    motion: str | None
    """Column with the place of the contact, 0 in the middle; None: it rests, and what is `largest` counts instead."""
    largest: str = "F_n"
    """Where the contact rests, the column whose largest value tells the state that one looks at first."""
    continuous: bool = False
    """Whether a pass goes on where the one before has ended, so that the figure of the history draws one line."""
    abscissa: str | None = None
    """Column, a length in which the contact never rests, that figures of the history have below; None: the steps."""
    key_numbers: Callable[[Run], Iterator[KeyNumber]]
    """Also of a run that has not finished."""
    panels: Callable[[], tuple[Panel, Panel]]
    """The first two of the figure of the history."""
    drawings: Callable[[], Drawings] | None = None
    """None: it has no figures of its own."""
    state_text: Callable[[Run, Snapshot], list[str]] | None = None
    """What tells one state from another in titles; None: pass, place and load."""

    def distance_from_middle(self, row: Mapping[str, float]) -> float:
        """How far a step is from the one that "aligned" stands for: smallest for the nearest.

        Args:
            row: the step's row of the history. Where the contact rests the stored steps are the ends of the list of
                loads, or the turns: unloaded, or in the middle, there is little to show.
        """
        return -row[self.largest] if self.motion is None else abs(row[self.motion])
