# SPDX-License-Identifier: BSD-3-Clause
"""Sliding: all that Python knows of it alone."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING, Any

from brinell.bodies import Body, Quantity
from brinell.scenarios._case import ScenarioCase
from brinell.scenarios.traits import Drawing, Drawings, KeyNumber, Traits
from brinell.settings import Grid, Heating, Interface, Output, Solver
from brinell.summary import RunSummary

if TYPE_CHECKING:
    from brinell.plot.history import Panel
    from brinell.results import Run, Snapshot

__all__ = ["TRAITS", "Sliding", "SlidingResult", "SlidingStroke"]


class Sliding(ScenarioCase):
    """The upper body, pressed on the lower one, slides over it along x: once, on and on, or to and fro."""

    _table = "sliding"

    def __init__(
        self,
        lower: Body,
        upper: Body,
        distance: Quantity,
        *,
        load: Quantity | None = None,
        pressure: Quantity | None = None,
        mean_gap: Quantity | None = None,
        approach: Quantity | None = None,
        strokes: int | None = None,
        to_and_fro: bool | None = None,
        shift: Quantity | None = None,
        press_steps: int | None = None,
        speed: Quantity | None = None,
        interface: Interface | Mapping[str, Any] | None = None,
        thermal: Heating | Mapping[str, Any] | None = None,
        title: str | None = None,
        grid: Grid | Mapping[str, Any] | None = None,
        solver: Solver | Mapping[str, Any] | None = None,
        output: Output | Mapping[str, Any] | None = None,
    ):
        """Describes a sliding; one of load, pressure, mean_gap and approach is given.

        Args:
            lower: the body at rest: a `Flat`, with a texture or without.
            upper: the body that slides: a `Flat` too, on a grid that is periodic along both axes; or a ball, a roller.
            distance: by which it slides in each stroke.
            load: reached first, and kept while sliding.
            pressure: the load by its mean over the period.
            mean_gap: instead, the mean over the period of the gap between the deformed surfaces.
            approach: instead of a load; peaks that stand out and meet on the way do so below 0, too.
            strokes: how often it slides by the distance.
            to_and_fro: whether every other stroke goes back; otherwise each goes on where the one before has ended.
            shift: by which it slides in a step.
            press_steps: in which the bodies are pressed together before, and parted after it.
            speed: of the upper body over the lower one, such as "1 m/s"; needed where friction heats.
            interface: friction, `brinell.Interface` or a dictionary.
            thermal: what its heat does, `brinell.Heating` or a dictionary.
            title: copied into the results.
            grid: its cells, `brinell.Grid` or a dictionary.
            solver: `brinell.Solver` or a dictionary.
            output: what is stored, `brinell.Output` or a dictionary.

        Raises:
            InputError: with all problems found.
        """
        table = {
            "load": load,
            "pressure": pressure,
            "mean_gap": mean_gap,
            "approach": approach,
            "distance": distance,
            "strokes": strokes,
            "to_and_fro": to_and_fro,
            "shift": shift,
            "press_steps": press_steps,
            "speed": speed,
        }
        super().__init__(
            lower,
            upper,
            table,
            title=title,
            grid=grid,
            solver=solver,
            output=output,
            interface=interface,
            thermal=thermal,
        )


@dataclass(frozen=True)
class SlidingStroke:
    """Means over the way of one stroke, and what it leaves."""

    stroke: int
    """Which one; counts from 1."""
    friction: float
    """Mean F_X over mean F_n [-]."""
    friction_ploughing: float
    """Of it, by the slopes of both surfaces [-]."""
    friction_interfacial: float
    """Of it, by the shear between them [-]."""
    mean_F_X: float
    """[N]."""
    contact_area: float
    """Mean [m^2]."""
    max_pressure: float
    """Mean of the largest pressure [Pa]."""
    dissipation_plastic: float
    """Plastic work in both bodies in this stroke [J]."""
    dissipation_friction: float
    """Heat of friction in this stroke [J]."""
    max_equivalent_plastic_strain: float
    """Largest over both bodies, at its end [-]."""
    rms_height_lower: float
    """Sq of the lower surface at its end: texture and residual displacement, over its grid [m]."""
    rms_height_upper: float
    """Of the upper surface [m]."""
    mean_height_lower: float
    """Sa of the lower surface [m]."""
    mean_height_upper: float
    """Of the upper surface [m]."""
    contact_fraction: float = math.nan
    """Mean contact area over that of the period; NaN unless both axes are periodic [-]."""
    mean_gap: float = math.nan
    """Mean over the period and the stroke [m]; NaN unless both axes are periodic."""
    patches: float = math.nan
    """Mean number of patches of the contact [-]."""
    largest_patch: float = math.nan
    """Mean area of the largest patch [m^2]."""
    core_height_lower: float = math.nan
    """Sk of the lower surface at its end, of the core of the bearing-area curve [m]."""
    core_height_upper: float = math.nan
    """Of the upper surface [m]."""
    peak_height_lower: float = math.nan
    """Spk of the lower surface: reduced height of the peaks above the core [m]."""
    peak_height_upper: float = math.nan
    """Of the upper surface [m]."""
    valley_depth_lower: float = math.nan
    """Svk of the lower surface: reduced depth of the valleys below the core [m]."""
    valley_depth_upper: float = math.nan
    """Of the upper surface [m]."""


class SlidingResult(RunSummary):
    """What only a sliding has in its summary."""

    @cached_property
    def strokes(self) -> list[SlidingStroke]:
        """Of a sliding, those that are complete, in the order of time."""
        return self._entries_of("sliding", "strokes", SlidingStroke)


def _key_numbers(run: Run) -> Iterator[KeyNumber]:
    yield KeyNumber("Largest load", float(run.history["F_n"].max()), "N", "load")
    yield KeyNumber("Way slid", float(run.history["way"].max()), "m")
    if run.complete and run.strokes:
        last = run.strokes[-1]
        yield KeyNumber("Strokes", len(run.strokes))
        yield KeyNumber("Friction F_X / F_n, last stroke", last.friction)
        yield KeyNumber("Of it by ploughing", last.friction_ploughing)
        if math.isnan(last.contact_fraction):
            yield KeyNumber("Area of contact, last stroke", last.contact_area, "m²")
        else:
            yield KeyNumber("Share of the period in contact, last stroke", last.contact_fraction, "%")
        yield KeyNumber("Plastic work of the last stroke", last.dissipation_plastic, "J", "energy")
        yield KeyNumber("Rms height of the lower surface", last.rms_height_lower, "m")
        yield KeyNumber("Rms height of the upper surface", last.rms_height_upper, "m")


def _state_text(_: Run, snapshot: Snapshot) -> list[str]:
    from brinell.plot import style

    row = snapshot.row
    if not row["way"]:
        return ["pressing", f"$F_n$ = {style.quantity(row['F_n'], 'N')}"]
    return [f"stroke {int(row['pass'])}", f"$s$ = {style.length(row['slid'])}"]


def _panels() -> tuple[Panel, Panel]:
    from brinell.plot import history

    return history.resistance_to_sliding, history.approach


def _drawings() -> Drawings:
    from brinell.plot import patches, run_in, sliding

    return Drawings(
        "sliding",
        "Friction and its two parts, contact, patches and roughness, over the way slid and stroke by stroke.",
        {
            "along-way": Drawing(
                sliding.along_way,
                "Over the way slid: friction with its two parts, contact, gap or approach, and plastic work.",
            ),
            "strokes": Drawing(
                sliding.stroke_by_stroke,
                "Stroke by stroke: friction and its two parts, contact, plastic work, roughness of both surfaces.",
            ),
            "patches": Drawing(
                patches.contact_patches,
                "The patches of the contact: how many over the way slid, how large, and where.",
            ),
            "surfaces": Drawing(
                run_in.surfaces_before_and_after,
                "Both surfaces before and after, and the bearing-area curves of both.",
            ),
        },
    )


TRAITS = Traits(
    name="sliding",
    motion=None,
    largest="way",
    continuous=True,
    key_numbers=_key_numbers,
    panels=_panels,
    drawings=_drawings,
    state_text=_state_text,
)
