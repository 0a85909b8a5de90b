# SPDX-License-Identifier: BSD-3-Clause
"""
Indentation with a hardening law of your own
============================================

A steel ball is pressed against a rigid flat and lifted off. The yield stress is a Python function of the equivalent
plastic strain. How much load does hardening add, compared with elastic and perfectly plastic theory?
"""

# %%
# A law as a function
# -------------------
# Any function of the equivalent plastic strain is a hardening law if it is positive, continuous and does not decrease.
# This one rises fast at first and slowly later, as for many steels.

import matplotlib.pyplot as plt
import numpy as np

import brinell
from brinell.reference import jackson_green_load

young_modulus, poisson_ratio, yield_stress = 210e9, 0.3, 600e6


def hardening(e):
    """Yield stress [Pa] at the equivalent plastic strain e."""
    return yield_stress + 400e6 * (1 - np.exp(-200 * e)) + 2e9 * e


# %%
# The engine converts the function to a table, which is refined until it differs from the function by less than one part
# in ten thousand. A steel that does not harden serves for comparison.

hardening_steel = brinell.Material(young_modulus, poisson_ratio, hardening)
perfect_steel = brinell.Material(young_modulus, poisson_ratio, brinell.Perfect(yield_stress))

table = hardening_steel.hardening
strain = np.linspace(0, 0.05, 201)
figure, axes = plt.subplots(figsize=(5, 3), layout="constrained")
axes.plot(strain, hardening(strain) / 1e6, label="function")
axes.plot(
    table.plastic_strain,
    np.divide(table.stress, 1e6),
    ".",
    label=f"table, {len(table.stress)} points",
)
axes.set(
    xlabel="equivalent plastic strain",
    ylabel="yield stress [MPa]",
    xlim=(0, 0.05),
    ylim=(0, 1200),
)
axes.legend()
plt.show()

# %%
# Press and lift off
# ------------------
# The approach is imposed in units of the approach at first yield: up to 25 of them, and back to zero. Load and approach
# at first yield, :math:`P_c` and :math:`\alpha_c`, are the same for both steels.


def indentation(material):
    """A ball of this material against a rigid flat."""
    return brinell.Indentation(
        lower=brinell.Body(brinell.Sphere("1 mm"), material),
        upper=brinell.Body(brinell.Flat(), brinell.RIGID),
        approach=[25, 0],
        normalised=True,
        steps=15,
        grid={"resolution": 8},
    )


runs = {
    "hardening": indentation(hardening_steel).run(),
    "perfectly plastic": indentation(perfect_steel).run(),
}

# %%
# Load over approach
# ------------------
# Hertz' elastic ball would carry :math:`(\alpha/\alpha_c)^{3/2}`. Jackson and Green (2005) fitted the load of a
# perfectly plastic ball, loading only, to finite-element computations. When unloaded, both balls spring back; the
# approach that remains at the end is the depth of the flattened spot.

alpha = np.linspace(0.01, 25, 300)
figure, axes = plt.subplots(figsize=(6.5, 4.2), layout="constrained")
axes.plot(alpha, alpha**1.5, "--", color="0.5", label="elastic (Hertz)")
axes.plot(
    alpha,
    jackson_green_load(alpha, young_modulus, poisson_ratio, yield_stress),
    ":",
    color="k",
    label="perfectly plastic (Jackson & Green)",
)
for name, run in runs.items():
    approach = np.concatenate([[0], run.history["approach"]]) / run.critical.interference
    load = np.concatenate([[0], run.history["F_n"]]) / run.critical.load
    axes.plot(approach, load, "o-", markersize=3, label=name)
axes.set(
    xlabel=r"approach $\alpha/\alpha_c$", ylabel="load $P/P_c$", xlim=(0, 26), ylim=(0, 110)
)
axes.legend()
plt.show()

# %%
# In numbers
# ----------
# The perfectly plastic ball compared with the fit, and the effect of hardening at the largest approach.

perfect, hard = runs["perfectly plastic"], runs["hardening"]
loading = slice(0, 15)
alpha = perfect.history["approach"][loading] / perfect.critical.interference
load = perfect.history["F_n"][loading] / perfect.critical.load
ratio = load / jackson_green_load(alpha, young_modulus, poisson_ratio, yield_stress)
print(f"load over that of the fit: {ratio.min():.3f} to {ratio.max():.3f}")

indents = {name: run.indents[0] for name, run in runs.items()}
for name, indent in indents.items():
    print(
        f"{name}: largest load {indent.max_load:.2f} N, "
        f"mean pressure {indent.hardness / yield_stress:.2f} S_y, "
        f"stays {indent.final_approach / indent.max_approach:.0%} of the approach"
    )

# %%
# The mean pressure of the hardening ball is above that of the other one, and less of the approach remains. Comparisons
# with published fits on finer grids: :doc:`/docs/verification`.
#
# Next steps: ``load=["2 N", "0.5 N", "2 N", 0]`` imposes loads instead, ``cycles`` repeats them, ``places`` makes
# several indents; ``brinell.Vickers("1 um")`` and ``brinell.Cone(70.3, "1 um")`` are other indenters.
