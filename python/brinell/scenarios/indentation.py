# SPDX-License-Identifier: BSD-3-Clause
"""Indentation: all that Python knows of it alone."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING, Any

from brinell.bodies import Body, Quantity
from brinell.scenarios._case import ScenarioCase
from brinell.scenarios.traits import Drawing, Drawings, KeyNumber, Traits
from brinell.settings import Grid, Output, Solver
from brinell.summary import RunSummary

if TYPE_CHECKING:
    from brinell.plot.history import Panel
    from brinell.results import Run

__all__ = ["TRAITS", "Indent", "Indentation", "IndentationResult"]


class Indentation(ScenarioCase):
    """The upper body is pressed into the lower one and lifted off again, at one place or at several."""

    _table = "indentation"

    def __init__(
        self,
        lower: Body,
        upper: Body,
        *,
        load: Quantity | Sequence[Quantity] | None = None,
        approach: Quantity | Sequence[Quantity] | None = None,
        pressure: Quantity | Sequence[Quantity] | None = None,
        mean_gap: Quantity | Sequence[Quantity] | None = None,
        normalised: bool = False,
        steps: int | None = None,
        cycles: int | None = None,
        places: Quantity | Sequence[Quantity] | None = None,
        title: str | None = None,
        grid: Grid | Mapping[str, Any] | None = None,
        solver: Solver | Mapping[str, Any] | None = None,
        output: Output | Mapping[str, Any] | None = None,
    ):
        """Describes an indentation.

        Args:
            lower: the body that is indented.
            upper: the indenter.
            load: loads to be reached one after the other, from none: ["10 N", 0] presses and lifts off.
            approach: instead, approaches of the bodies from the touch of the undeformed ones.
            pressure: instead, means over the period of a grid that is periodic along both axes.
            mean_gap: instead, means of the gap over that period: the smaller, the more they are pressed.
            normalised: whether loads or approaches are in their values at first yield, P_c and alpha_c.
            steps: from one entry of the list to the next.
            cycles: how often the list is gone through at each place.
            places: along x, indented one after the other.
            title: copied into the results.
            grid: its cells, `brinell.Grid` or a dictionary.
            solver: `brinell.Solver` or a dictionary.
            output: what is stored, `brinell.Output` or a dictionary.

        Raises:
            InputError: with all problems found.
        """
        table = {
            "load": load,
            "approach": approach,
            "pressure": pressure,
            "mean_gap": mean_gap,
            "normalised": normalised,
            "steps": steps,
            "cycles": cycles,
            "places": places,
        }
        super().__init__(lower, upper, table, title=title, grid=grid, solver=solver, output=output)


@dataclass(frozen=True)
class Indent:
    """One loading and unloading at one place: read at the largest load, and where the contact opens."""

    place: int
    """Which of the places of the case; counts from 1."""
    cycle: int
    """Of the loads at this place; counts from 1."""
    x: float
    """Where the indenter's apex is on the lower body [m]."""
    max_load: float
    """[N]."""
    max_approach: float
    """Approach at that load, from first touch of the undeformed bodies [m]."""
    contact_area: float
    """Projected, at that load [m^2]."""
    hardness: float
    """Largest load over that area [Pa]."""
    loading_stiffness: float
    """Slope of load over approach on the way to the largest load [N/m]."""
    unloading_stiffness: float
    """Slope on the way back from it [N/m]; 0 without unloading."""
    final_approach: float
    """Approach at which the contact opens [m]; NaN if it does not."""
    residual_depth: float
    """Largest residual displacement of the lower body then, into the body positive [m]."""
    pile_up: float
    """Largest height of its residual surface then, outwards positive [m]."""
    work: float
    """Net work of the drive in this indent [J]."""
    contact_fraction: float = math.nan
    """Contact area over that of the period, at the largest load; NaN unless both axes are periodic [-]."""
    mean_gap: float = math.nan
    """Mean gap over the period then [m]; NaN unless both axes are periodic."""
    contact_stiffness: float = math.nan
    """Elastic, nominal pressure over mean gap as they change, then [Pa/m]; NaN unless both axes are periodic."""


class IndentationResult(RunSummary):
    """What only an indentation has in its summary."""

    @cached_property
    def indents(self) -> list[Indent]:
        """Of an indentation, in the order of time: place by place, cycle by cycle."""
        return self._entries_of("indentation", "indents", Indent)


def _key_numbers(run: Run) -> Iterator[KeyNumber]:
    yield KeyNumber("Largest load", float(run.history["F_n"].max()), "N", "load")
    yield KeyNumber("Largest approach", float(run.history["approach"].max()), "m", "interference")
    if run.complete:
        first = run.indents[0]
        yield KeyNumber("Hardness, first indent", first.hardness, "Pa")
        if first.unloading_stiffness:
            yield KeyNumber("Unloading stiffness, first indent", first.unloading_stiffness, "N/m")
        yield KeyNumber("Pile-up, first indent", first.pile_up, "m", "interference")


def _panels() -> tuple[Panel, Panel]:
    from brinell.plot import history

    return history.normal_force, history.approach


def _drawings() -> Drawings:
    from brinell.plot import indentation, rough

    return Drawings(
        "indentation",
        "Load over approach, imprint, contact pressure and, over a period, contact fraction of indentations.",
        {
            "load-depth": Drawing(
                indentation.load_depth,
                "Load over the approach, all cycles; dashed, elastic spheres, if that is what touches.",
            ),
            "imprint": Drawing(
                indentation.imprint,
                "Residual surface of the lower body in two planes through the first place; below, its pile-up "
                "enlarged.",
            ),
            "contact-pressure": Drawing(
                indentation.contact_pressure,
                "Contact pressure in two planes at the largest load whose fields are stored.",
            ),
            "contact-fraction": Drawing(
                rough.contact_fraction,
                "Real contact area over the nominal one, and mean gap, over the mean pressure on the period.",
            ),
        },
    )


TRAITS = Traits(name="indentation", motion=None, key_numbers=_key_numbers, panels=_panels, drawings=_drawings)
