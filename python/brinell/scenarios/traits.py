# SPDX-License-Identifier: BSD-3-Clause
"""Properties of a scenario that figures and reports need; each scenario's module defines its own."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Literal

if TYPE_CHECKING:  # plotting is imported only by the functions that draw, and these modules import the scenarios
    from matplotlib.figure import Figure

    from brinell.plot.history import Panel
    from brinell.results import Run, Snapshot
    from brinell.scenarios import Scenario

__all__ = ["Drawing", "Drawings", "KeyNumber", "Traits"]


@dataclass(frozen=True)
class KeyNumber:
    """One of the most important results of a run."""

    name: str
    value: float
    """Value in SI units; an integer is shown with all digits."""
    unit: str = ""
    """SI unit; "%" for a fraction that is shown in per cent."""
    over: Literal["load", "interference", "energy", "peak_pressure"] | None = None
    """Value at first yield with which the result is compared; None: none."""
    digits: int = 3


@dataclass(frozen=True)
class Drawing:
    """A figure of one run of a scenario, or of several."""

    draw: Callable[[Sequence[Run]], Figure | None]
    """Function that draws the figure; it returns None if the runs lack the data."""
    caption: str = ""
    """One or two sentences, also used as alternative text; empty if the figure does not suit a single run."""


@dataclass(frozen=True)
class Drawings:
    """Figures that are specific to one scenario: a command of ``brinell plot``, and the first figures of a report."""

    command: str
    help: str
    figures: Mapping[str, Drawing]
    """Figures by file name."""


@dataclass(frozen=True, kw_only=True)
class Traits:
    """Properties of a scenario besides its keys, columns and lists, which the engine provides."""

    name: Scenario
    motion: str | None
    """Column with the position of the contact, 0 in the middle; None: the contact does not move."""
    largest: str = "F_n"
    """For a contact that does not move: column whose largest value selects the state that is shown first."""
    continuous: bool = False
    """Whether a pass continues where the previous one ended, so that the figure of the history draws one line."""
    abscissa: str | None = None
    """Column with a length that changes in every step, for the abscissa of the history; None: step numbers."""
    key_numbers: Callable[[Run], Iterator[KeyNumber]]
    """Function that returns the key numbers of a run, also of an unfinished one."""
    panels: Callable[[], tuple[Panel, Panel]]
    """Function that returns the first two panels of the figure of the history."""
    drawings: Callable[[], Drawings] | None = None
    """Function that returns the figures of the scenario; None: there are none."""
    state_text: Callable[[Run, Snapshot], list[str]] | None = None
    """Function that describes a state in titles; None: pass, place and load."""

    def distance_from_middle(self, row: Mapping[str, float]) -> float:
        """Measure by which the stored step for "aligned" is chosen; the step with the smallest value is taken.

        Args:
            row: the step's row of the history. If the contact does not move, the step with the largest value of
                `largest` is chosen: stored steps are ends of the load list or turning points, and the unloaded ones
                show little.
        """
        return -row[self.largest] if self.motion is None else abs(row[self.motion])
