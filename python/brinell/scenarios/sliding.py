# SPDX-License-Identifier: BSD-3-Clause
"""The scenario sliding: results, key numbers and figures."""

from __future__ import annotations

import math
from collections.abc import Iterator
from functools import cached_property
from typing import TYPE_CHECKING

from brinell.scenarios.lists import SlidingStroke
from brinell.scenarios.traits import Drawing, Drawings, KeyNumber, Traits
from brinell.summary import RunSummary

if TYPE_CHECKING:
    from brinell.plot.history import Panel
    from brinell.results import Run, Snapshot

__all__ = ["TRAITS", "SlidingResult"]


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
