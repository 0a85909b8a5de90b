# SPDX-License-Identifier: BSD-3-Clause
"""Sliding of two rough surfaces as a statistical sum over pairs of passing asperities.

    passes = brinell.asperities.AsperityMap.compute(steel, output="results/passes")
    rough = brinell.asperities.Population.from_surface(brinell.surfaces.read("surface.xyz").levelled())
    there = brinell.asperities.statistical_sum(passes, rough, rough, separation=2e-6)
    print(there.pressure, there.friction_coefficient)

Modules: `moments` and `population` (asperities of a surface), `pairs` (geometry and units of a pair), `nodes` and
`tugging_map` (results of a pass), `crossings` (integrals over the offset), `sums` (statistical sums), `encounters`
(individual passes), `resting` (asperities under a flat).
"""

import sys

from brinell._arguments import explain_argument_errors
from brinell.errors import MissingExtraError

try:
    import scipy as _scipy  # noqa: F401 (asked for at the door)
except ModuleNotFoundError as error:
    raise MissingExtraError("a map of asperities", str(error.name), "sweep") from error

from brinell.asperities.encounters import Encounters, encounters
from brinell.asperities.moments import SpectralMoments
from brinell.asperities.pairs import QUANTITIES, Quantity, UnitRadius
from brinell.asperities.population import Population
from brinell.asperities.resting import RestingSum, resting_sum
from brinell.asperities.sums import AsperitySum, Estimate, friction_curve, statistical_sum
from brinell.asperities.tugging_map import AsperityMap, Interpolated

__all__ = [
    "QUANTITIES",
    "AsperityMap",
    "AsperitySum",
    "Encounters",
    "Estimate",
    "Interpolated",
    "Population",
    "Quantity",
    "RestingSum",
    "SpectralMoments",
    "UnitRadius",
    "encounters",
    "friction_curve",
    "resting_sum",
    "statistical_sum",
]
explain_argument_errors(sys.modules[__name__])
