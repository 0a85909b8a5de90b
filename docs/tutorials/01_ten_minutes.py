# SPDX-License-Identifier: BSD-3-Clause
"""
Ten minutes: from nothing to a figure
=====================================

Two steel asperities slide past each other. They push each other aside, yield, and part with a dent in each of them.
This page computes the forces, looks at the dent, and shows where the work has gone.

You need the package: in the source tree, ``pip install .`` in a virtual environment (:doc:`/docs/install`). Then save
this page as a script, with the button at its end, or type along.
"""

# %%
# Two bodies
# ----------
# A body is a shape and a material. A number is in SI; text carries its unit. The steel yields at 600 MPa and hardens
# by 2 GPa per unit of plastic strain.

import matplotlib.pyplot as plt
import numpy as np

import brinell
from brinell.reference import elastic_tugging_forces

steel = brinell.Material("210 GPa", 0.3, hardening=brinell.Linear("600 MPa", "2 GPa"))
asperity = brinell.Body(brinell.Sphere("10 um"), steel)

# %%
# A case
# ------
# The upper asperity is carried along x past the lower one, at a constant height. When the centres are aligned, the
# undeformed spheres overlap by nine times the interference at which the first point yields.

case = brinell.Tugging(
    lower=asperity,
    upper=asperity,
    interference=9,
    title="Two steel asperities",
    grid={"resolution": 6},
)

# %%
# Nothing has been computed yet. ``check`` shows the case with every default filled in and, as comments below it, the
# values at first yield, the grids, and the cost of the run.

report = case.check()
print(report[report.index("# Contact") :])

# %%
# Run it
# ------
# ``run`` computes the case, writes the results into a folder, and opens them. Without a folder the results are
# temporary; ``progress=True`` shows a progress bar.

run = case.run()
print(f"{run.history.steps} steps")

# %%
# The forces
# ----------
# The history has a column per quantity and a row per step. The figure shows forces in units of the load at first yield,
# :math:`P_c`. :math:`F_X` resists the motion: it is positive before the centres are aligned, where the drive must push.
# Two elastic spheres would return on the way out, mirrored, the work that they took on the way in (dashed). These
# spheres have yielded, and push forwards with less force and for a shorter time.

history = run.history
radius = run.equivalent_radius
load = run.critical.load

X = np.linspace(-1, 1, 201) * history["X"][-1]
elastic_F_X, elastic_F_Z = elastic_tugging_forces(
    X, run.lower_radius, run.upper_radius, run.interference, run.critical.interference
)

figure, (left, right) = plt.subplots(1, 2, figsize=(9, 3.6), layout="constrained")
for axes, name, elastic in ((left, "F_X", elastic_F_X), (right, "F_Z", elastic_F_Z)):
    axes.plot(X / radius, elastic, "--", color="0.5", label="elastic (Hertz)")
    axes.plot(
        history["X"] / radius,
        history[name] / load,
        "o-",
        markersize=3,
        label="elastic-plastic",
    )
    axes.axhline(0, color="0.8", linewidth=0.8, zorder=0)
    axes.set(xlabel="sliding coordinate $X/R$", ylabel=f"${name}/P_c$")
left.legend()
plt.show()

# %%
# The dent
# --------
# The fields of some steps are stored, and always those of the final, unloaded state. The residual displacement of a
# surface is positive into the body, so a dent is a positive number. There is a pile-up in front of the dent, since the
# upper asperity has moved to the right.

final = run.snapshot("final").lower
middle = np.argmin(np.abs(final.y))
depth = final.residual_displacement[middle]

figure, axes = plt.subplots(figsize=(6, 3), layout="constrained")
axes.fill_between(final.x * 1e9, -depth * 1e9, -3, color="C0", alpha=0.25)
axes.plot(final.x * 1e9, -depth * 1e9)
axes.axhline(0, color="0.6", linestyle="--", linewidth=0.8)
axes.set(
    xlabel="x along the lower asperity [nm]",
    ylabel="height change [nm]",
    ylim=(-3, 1),
    title="What one pass has left",
)
plt.show()

share = depth.max() / run.interference
print(f"deepest: {depth.max() * 1e9:.2f} nm, {share:.0%} of the interference")

# %%
# Where the work has gone
# -----------------------
# The net work of the drive has been dissipated by plastic flow in both bodies, or is locked in as elastic energy of
# their residual stresses. The rest is the error of mesh and step, which falls as the resolution grows.

work = history["work"][-1]
dissipated = history["dissipation_lower"][-1] + history["dissipation_upper"][-1]
locked_in = history["energy_residual"][-1]
print(f"net work     {work:.3e} J")
print(f"dissipated   {dissipated / work:7.1%}")
print(f"locked in    {locked_in / work:7.1%}")
print(f"left over    {(work - dissipated - locked_in) / work:7.1%}")

# %%
# The same as a case file
# -----------------------
# ``case.to_toml("steel.toml")`` writes the case above as a file, which the command line computes::
#
#     brinell run steel.toml -o results/steel
#
# ``brinell.open("results/steel")`` reads its results. The meaning of each key: :doc:`/docs/reference/case-file`.
#
# Next steps: the same asperities pass after pass, ``brinell.Tugging(..., passes=3)``; or
# :doc:`indentation with a hardening law of your own </docs/_tutorials/02_indentation>`.
