# SPDX-License-Identifier: BSD-3-Clause
"""The scenarios as Python classes; each of them is a `Case`.

    steel = brinell.Material("210 GPa", 0.3, brinell.Linear("600 MPa", "2 GPa"))
    ball = brinell.Body(brinell.Sphere("10 um"), steel)
    run = brinell.Tugging(lower=ball, upper=ball, interference=4).run(progress=True)

Arguments that are None take the defaults of the case file (docs/reference/case-file.md).
"""

# Each scenario has a module with everything specific to it. Only this module lists the scenarios.

from collections.abc import Mapping
from typing import Literal

from brinell.scenarios import fretting, indentation, rolling, sliding, tugging
from brinell.scenarios.cases import Fretting, Indentation, Rolling, Sliding, Tugging
from brinell.scenarios.traits import Traits

__all__ = ["Fretting", "Indentation", "Rolling", "Sliding", "Tugging"]

Scenario = Literal["tugging", "indentation", "rolling", "fretting", "sliding"]
"""Names of the scenarios, as in the case file."""

SCENARIOS: Mapping[Scenario, Traits] = {
    one.name: one for one in (tugging.TRAITS, indentation.TRAITS, rolling.TRAITS, fretting.TRAITS, sliding.TRAITS)
}
"""Traits of each scenario, in the order of the case file."""


class OfScenarios(
    tugging.TuggingResult,
    indentation.IndentationResult,
    rolling.RollingResult,
    fretting.FrettingResult,
    sliding.SlidingResult,
):
    """Results that are specific to one scenario; base class of `Run`."""
