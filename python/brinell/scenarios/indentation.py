# SPDX-License-Identifier: BSD-3-Clause
"""The scenario indentation: results, key numbers and figures."""

from __future__ import annotations

import math
from collections.abc import Iterator
from functools import cached_property
from typing import TYPE_CHECKING

from brinell.scenarios.lists import Indent
from brinell.scenarios.traits import Drawing, Drawings, KeyNumber, Traits
from brinell.summary import RunSummary

if TYPE_CHECKING:
    from brinell.plot.history import Panel
    from brinell.results import Run

__all__ = ["TRAITS", "IndentationResult"]


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
