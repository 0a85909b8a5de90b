# SPDX-License-Identifier: BSD-3-Clause
"""
Rolling passes and shakedown
============================

A ball rolls repeatedly over the same track. The first pass leaves a rut and residual stresses. Do later passes still
cause plastic strain? If not, the track has *shaken down*: residual stresses, a rut that makes the contact conform, and
hardening together keep every later pass elastic. If they do, the strain goes to and fro in a closed cycle, or the rut
deepens with every pass.
"""

# %%
# Two materials, two loads
# ------------------------
# Both flats begin to yield at the same stress. One does not harden at all. The other has a back stress (Prager): its
# yield surface moves with the plastic strain and so depends on the direction of earlier flow.
#
# The load is given by the peak pressure :math:`p_0` of the elastic contact. The track of a ball yields at :math:`p_0 =
# 1.6\,S_y`, and the published limit of elastic shakedown is :math:`p_0 = 4.7\,k` with the shear yield stress :math:`k =
# S_y/\sqrt{3}` (Johnson 1985): 2.6 and 4.3 GPa here. One load is below that limit, the other well above it.

import matplotlib.pyplot as plt
import numpy as np

import brinell

ball = brinell.Body(
    brinell.Sphere("10 mm"), brinell.Material("210 GPa", 0.3)
)  # no hardening law: stays elastic
laws = {"perfectly plastic": (), "kinematic hardening": [("20 GPa", 0)]}
loads = {
    "4 GPa": "3.3 mm",
    "6 GPa": "4.9 mm",
}  # with the length of the track, six half-widths of the contact

# %%
# Five passes of each case. With six cells per half-width the rut is right to some two per cent; the default has eight.


def rolling(name, pressure):
    """Passes of the ball over a flat with one of the laws."""
    flat = brinell.Material("210 GPa", 0.3, brinell.Perfect("1.6 GPa"), back_stresses=laws[name])
    return brinell.Rolling(
        lower=brinell.Body(brinell.Flat(), flat),
        upper=ball,
        hertz_pressure=pressure,
        distance=loads[pressure],
        passes=5,
        title=f"{pressure}, {name}",
        grid={"resolution": 6},
    )


runs = {
    (name, pressure): rolling(name, pressure).run() for pressure in loads for name in laws
}

# %%
# Pass by pass
# ------------
# ``run.passes`` has the state after each pass in the middle of the track: the depth of the rut, and the equivalent
# plastic strain that the pass has added there.
#
# At 4 GPa the added strain falls by an order of magnitude per pass with either law: elastic shakedown. At 6 GPa every
# pass adds as much as the previous one. The rut distinguishes two cases: with kinematic hardening it no longer deepens
# and the strain goes to and fro (plastic shakedown); without hardening it continues to deepen (ratchetting).

styles = dict(zip(runs, ("C0o-", "C0s--", "C1o-", "C1s--"), strict=True))
number = np.arange(1, 6)
figure, (left, right) = plt.subplots(1, 2, figsize=(9, 3.8), layout="constrained")
for key, run in runs.items():
    rut = np.array([p.rut_depth for p in run.passes])
    left.plot(number[1:], np.diff(rut) * 1e9, styles[key], label=run.title)
    right.plot(number, [p.track_plastic_increment for p in run.passes], styles[key])
left.set(xlabel="pass", ylabel="deepening of the rut [nm]", yscale="log", xticks=number)
right.set(xlabel="pass", ylabel="plastic strain added", yscale="log", xticks=number)
left.legend(fontsize="small")
plt.show()

# %%
# Residual stress over the depth
# ------------------------------
# After the last pass the track is unloaded. ``run.profile`` is the residual stress under its middle. Compression below
# the surface is welcome, since it closes cracks.

figure, axes = plt.subplots(figsize=(5, 4), layout="constrained")
for (name, pressure), run in runs.items():
    if pressure == "4 GPa":
        depth = run.profile.depth * 1e6
        (along,) = axes.plot(run.profile.residual_xx / 1e6, depth, label=f"{name}, along")
        axes.plot(
            run.profile.residual_yy / 1e6,
            depth,
            "--",
            color=along.get_color(),
            label=f"{name}, across",
        )
axes.axvline(0, color="0.7", linewidth=0.8, zorder=0)
axes.set(
    xlabel="residual stress [MPa]",
    ylabel="depth [µm]",
    ylim=(1200, 0),
    title="after five passes at 4 GPa",
)
axes.legend(fontsize="small")
plt.show()

# %%
# The price of a pass
# -------------------
# Plastic flow in the track takes work. Once the track has shaken down nothing is dissipated any more, since this
# contact has no friction.

for run in runs.values():
    losses = ", ".join(f"{p.dissipation * 1e3:.3g}" for p in run.passes)
    print(f"{run.title}: {losses} mJ")

# %%
# Next steps: with ``slide_to_roll`` the ball slides as well; with ``texture=brinell.Dent("1 um", edge_radius="50 um")`` on a body
# it rolls over a dent; in ``cases/rolling-passes`` both bodies are of the same steel. The computed shakedown limit
# compared with the published one: :doc:`/docs/verification`.
