# SPDX-License-Identifier: BSD-3-Clause
"""Identification: unknown keys of a case from measured curves.

    result = brinell.fit(
        case,
        [Unknown("lower.material.hardening.yield_stress", "300 MPa", "2 GPa"),
         Unknown("lower.material.hardening.modulus", "1 GPa", "20 GPa")],
        data_from_file("sphere.csv", noise="1 %"),
    )
    print(result["yield stress"].low, result.findings)

Modules: `columns` (text files of instruments), `data` (measured data), `checks` (holds, signs, units, branches),
`unknowns` (bounds, priors), `model` (a run as the data see it), `problem` (runs in parallel, residuals), `solve` (the
search), `intervals` (covariance, profiles, error of cells and method), `fitting` (the function `fit`), `result`, `file`
(fit.toml), `cli` (the command).
"""

import sys

from brinell._arguments import explain_argument_errors
from brinell.errors import MissingExtraError

try:
    import scipy as _scipy  # noqa: F401 (asked for at the door)
except ModuleNotFoundError as error:
    raise MissingExtraError("a fit", str(error.name), "sweep") from error

from brinell.fits.data import Data, data_from_file
from brinell.fits.fitting import fit
from brinell.fits.problem import Course
from brinell.fits.result import Curve, Estimate, Fit
from brinell.fits.unknowns import Unknown

__all__ = ["Course", "Curve", "Data", "Estimate", "Fit", "Unknown", "data_from_file", "fit"]

explain_argument_errors(sys.modules[__name__])
