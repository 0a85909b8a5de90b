# SPDX-License-Identifier: BSD-3-Clause
"""The scenario sliding: results, key numbers and figures."""

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
    from brinell.results import Run, Snapshot

__all__ = ["TRAITS", "SlidingResult", "SlidingStroke"]


@dataclass(frozen=True)
class SlidingStroke:
    """Averages over one stroke, and the state of the surfaces at its end."""

    stroke: int
    """Number of the stroke, from 1."""
    friction: float
    """Mean F_X over mean F_n [-]."""
    friction_ploughing: float
    """Part of `friction` from pressure on the slopes of both surfaces (ploughing) [-]."""
    friction_interfacial: float
    """Part of `friction` from the shear between the surfaces [-]."""
    mean_F_X: float
    """Mean F_X [N]."""
    contact_area: float
    """Mean contact area [m^2]."""
    max_pressure: float
    """Mean over the stroke of the largest pressure [Pa]."""
    dissipation_plastic: float
    """Plastic work in both bodies in this stroke, without pressing and parting [J]."""
    dissipation_friction: float
    """Energy dissipated by friction in this stroke, without pressing and parting [J]."""
    max_equivalent_plastic_strain: float
    """Largest equivalent plastic strain of both bodies at the end of the stroke [-]."""
    rms_height_lower: float
    """Sq of the lower surface (texture and residual displacement, over its grid) at the end of the stroke [m]."""
    rms_height_upper: float
    """Sq of the upper surface at the end of the stroke [m]."""
    mean_height_lower: float
    """Sa of the lower surface at the end of the stroke [m]."""
    mean_height_upper: float
    """Sa of the upper surface at the end of the stroke [m]."""
    contact_fraction: float = math.nan
    """Mean contact area over the area of the period [-]; NaN unless both axes are periodic."""
    mean_gap: float = math.nan
    """Gap averaged over the period and the stroke [m]; NaN unless both axes are periodic."""
    patches: float = math.nan
    """Mean number of contact patches [-]."""
    largest_patch: float = math.nan
    """Mean area of the largest patch [m^2]."""
    core_height_lower: float = math.nan
    """Sk of the lower surface, the core height of the bearing-area curve, at the end of the stroke [m]."""
    core_height_upper: float = math.nan
    """Sk of the upper surface at the end of the stroke [m]."""
    peak_height_lower: float = math.nan
    """Spk of the lower surface, the reduced peak height, at the end of the stroke [m]."""
    peak_height_upper: float = math.nan
    """Spk of the upper surface at the end of the stroke [m]."""
    valley_depth_lower: float = math.nan
    """Svk of the lower surface, the reduced valley depth, at the end of the stroke [m]."""
    valley_depth_upper: float = math.nan
    """Svk of the upper surface at the end of the stroke [m]."""


class SlidingResult(RunSummary):
    """Summary results that are specific to sliding."""

    @cached_property
    def strokes(self) -> list[SlidingStroke]:
        """Results of each complete stroke of a sliding run, in order of time.

        Raises:
            RunError: the run has another scenario, is unfinished, or its summary is damaged.
        """
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
        "Draw friction and its two parts, contact, patches and roughness, over the sliding distance and by stroke.",
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
