# SPDX-License-Identifier: BSD-3-Clause
"""The scenario indentation: results, key numbers and figures."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING

from brinell.scenarios.traits import Drawing, Drawings, KeyNumber, Traits
from brinell.summary import RunSummary

if TYPE_CHECKING:
    from brinell.plot.history import Panel
    from brinell.results import Run

__all__ = ["TRAITS", "Indent", "IndentationResult"]


@dataclass(frozen=True)
class Indent:
    """Results of one loading and unloading at one place, at the largest load and where the contact opens."""

    place: int
    """Number of the place in the case, from 1."""
    cycle: int
    """Number of the loading cycle at this place, from 1."""
    x: float
    """Coordinate of the indenter's apex on the lower body [m]."""
    max_load: float
    """Largest load [N]."""
    max_approach: float
    """Approach at the largest load, from first touch of the undeformed smooth shapes [m]."""
    contact_area: float
    """Projected contact area at the largest load [m^2]."""
    hardness: float
    """Largest load over the projected contact area [Pa]."""
    loading_stiffness: float
    """Slope of load over approach during loading, at the largest load [N/m]; NaN if no step before it has a load."""
    unloading_stiffness: float
    """Slope of load over approach at the beginning of unloading [N/m]; NaN if no step after it has a load."""
    final_approach: float
    """Approach at which the contact opens [m]; NaN if it does not open."""
    residual_depth: float
    """Largest residual displacement of the lower body after unloading, positive into the body [m]."""
    pile_up: float
    """Largest height of the lower body's residual surface after unloading, positive outwards [m]."""
    work: float
    """Net work of the drive in this indent [J]."""
    contact_fraction: float = math.nan
    """Contact area over the area of the period at the largest load [-]; NaN unless both axes are periodic."""
    mean_gap: float = math.nan
    """Mean gap over the period at the largest load [m]; NaN unless both axes are periodic."""
    contact_stiffness: float = math.nan
    """Elastic stiffness at the largest load, change of nominal pressure over change of mean gap [Pa/m]; NaN unless both
    axes are periodic."""


class IndentationResult(RunSummary):
    """Summary results that are specific to indentation."""

    @cached_property
    def indents(self) -> list[Indent]:
        """Results of each indent of an indentation run, in order of time: place by place, cycle by cycle.

        Raises:
            RunError: the run has another scenario, is unfinished, or its summary is damaged.
        """
        return self._entries_of("indentation", "indents", Indent)


def _key_numbers(run: Run) -> Iterator[KeyNumber]:
    yield KeyNumber("Largest load", float(run.history["F_n"].max()), "N", "load")
    yield KeyNumber("Largest approach", float(run.history["approach"].max()), "m", "interference")
    if run.complete:
        first = run.indents[0]
        yield KeyNumber("Hardness, first indent", first.hardness, "Pa")
        if not math.isnan(first.unloading_stiffness):
            yield KeyNumber("Unloading stiffness, first indent", first.unloading_stiffness, "N/m")
        yield KeyNumber("Pile-up, first indent", first.pile_up, "m", "interference")


def _panels() -> tuple[Panel, Panel]:
    from brinell.plot import history

    return history.normal_force, history.approach


def _drawings() -> Drawings:
    from brinell.plot import indentation, rough

    return Drawings(
        "indentation",
        "Draw load over approach, imprint and contact pressure of indentations, and in a period the contact fraction.",
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
