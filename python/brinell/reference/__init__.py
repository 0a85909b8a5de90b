# SPDX-License-Identifier: BSD-3-Clause
"""Reference solutions without cells: Hertz, coated bodies, first yield, indented spheres, elastic tugging.

Cylinders are in plane strain. Their approach depends logarithmically on a reference distance l, at which the
displacement is set to zero; the default 2 R/e gives the approach of Green (2005).

z points into the body, pressure is positive in compression, stress in tension; tensor components come first, in the
order xx, yy, zz, yz, xz, xy. R is the equivalent radius, 1/R = 1/R1 + 1/R2; E' the contact modulus,
1/E' = (1 - nu1^2)/E1 + (1 - nu2^2)/E2.
"""

from __future__ import annotations

import sys

from brinell._arguments import explain_argument_errors
from brinell.reference.coated import CoatedContact
from brinell.reference.critical import (
    CriticalValues,
    FirstYield,
    critical_line_values,
    critical_pressure_ratio,
    critical_values,
    first_yield,
    line_contact_first_yield,
)
from brinell.reference.elastic_tugging import (
    ElasticTugging,
    TuggingForces,
    elastic_tugging_forces,
    elastic_tugging_reach,
)
from brinell.reference.hertz import (
    EllipticalContact,
    LineContact,
    PointContact,
    contact_modulus,
    elliptical_contact,
    line_contact,
    line_contact_stress,
    point_contact,
    point_contact_stress,
)
from brinell.reference.spherical_indentation import (
    jackson_green_area,
    jackson_green_load,
    jackson_green_pressure_ratio,
    kogut_etsion_load,
)

__all__ = [
    "CoatedContact",
    "CriticalValues",
    "ElasticTugging",
    "EllipticalContact",
    "FirstYield",
    "LineContact",
    "PointContact",
    "TuggingForces",
    "contact_modulus",
    "critical_line_values",
    "critical_pressure_ratio",
    "critical_values",
    "elastic_tugging_forces",
    "elastic_tugging_reach",
    "elliptical_contact",
    "first_yield",
    "jackson_green_area",
    "jackson_green_load",
    "jackson_green_pressure_ratio",
    "kogut_etsion_load",
    "line_contact",
    "line_contact_first_yield",
    "line_contact_stress",
    "point_contact",
    "point_contact_stress",
]

explain_argument_errors(sys.modules[__name__])
