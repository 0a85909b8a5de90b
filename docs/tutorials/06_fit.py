# SPDX-License-Identifier: BSD-3-Clause
"""
From an indent to the material
==============================

A ball is pressed into a steel whose hardening is unknown; load and depth are measured. Which yield stress and which
hardening modulus belong to the curve, and how sure are they?
"""

# %%
# The measurement
# ---------------
# Here a run takes the place of the instrument: a steel that nobody knows, with 1 % of noise on the load.

import matplotlib.pyplot as plt
import numpy as np

import brinell
from brinell.fits import Data, Unknown


def indentation(yield_stress, modulus):
    """A rigid ball on a steel that hardens linearly."""
    steel = brinell.Material("210 GPa", 0.3, brinell.Linear(yield_stress, modulus))
    return brinell.Indentation(
        lower=brinell.Body(brinell.Flat(), steel),
        upper=brinell.Body(brinell.Sphere("1 mm"), brinell.RIGID),
        load=["1 kN", 0],
        steps=12,
        grid={"resolution": 8},
    )


rows = list(indentation("900 MPa", "8 GPa").steps())
depth = np.array([row["approach"] for row in rows])
load = np.array([row["F_n"] for row in rows])
load *= 1 + 0.01 * np.random.default_rng(1).standard_normal(load.size)

# %%
# The fit
# -------
# The case has any values where keys are unknown; what counts are the bounds. The noise is what the maker of the
# instrument says. `method_error=0`, since the curve is that of a run; without it the interval allows for a percent of the
# depth, by which such runs differ from finite elements.

curve = Data(depth, load, name="ball", noise="1 %")
result = brinell.fit(
    indentation("1 GPa", "2 GPa"),
    [
        Unknown("lower.material.hardening.yield_stress", "500 MPa", "2 GPa"),
        Unknown("lower.material.hardening.modulus", "1 GPa", "60 GPa", name="hardening modulus"),
    ],
    curve,
    method_error=0.0,
)
print(result)

# %%
# The first interval is by all errors, the second one by the scatter of the data alone. What the data cannot tell, and
# what else should be known, is in the findings.

print(*result.findings, sep="\n")

# %%
# Curve and residuals
# -------------------
# Residuals without a trend say that the model fits the test.

brinell.plot.fit_curve(result, ax=plt.figure(figsize=(6.0, 4.8), layout="constrained"))
plt.show()

# %%
# How well the unknowns are known
# -------------------------------
# The narrow bands are the intervals by scatter, the wide ones those with the error of the cells. The ellipse is long and thin: a lower
# yield stress with more hardening gives nearly the same curve. A second ball, or a pyramid, would cut it short.

brinell.plot.fit_corner(result, ax=plt.figure(figsize=(5.5, 5.0), layout="constrained"))
plt.show()

# %%
# The fitted case is a case like any other.

print(result.case)
