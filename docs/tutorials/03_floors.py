# SPDX-License-Identifier: BSD-3-Clause
"""
A scenario of your own, from the floors
=======================================

Tugging, indentation and rolling are loops over a few building blocks, and the blocks are there to be used: contact,
half space, plasticity, and both coupled. This page goes up floor by floor, checks each against a closed form, and ends
with a scenario that brinell does not have: a ball that is pressed in twice, side by side, so closely that the second
dent runs into the first.
"""

# %%
# The contact: who presses where
# ------------------------------
# A grid of cells carries the pressure. The ball enters by its distance to the flat; a body without a hardening law is
# elastic, and only its elastic constants count here.

import matplotlib.pyplot as plt
import numpy as np

import brinell
from brinell.contact import ElasticContact
from brinell.elastoplastic import CoupledContact
from brinell.halfspace import HalfSpace, SurfaceGrid, VolumeGrid
from brinell.reference import (
    contact_modulus,
    critical_values,
    point_contact,
    point_contact_stress,
)

steel = brinell.Material("210 GPa", 0.3, brinell.Linear("800 MPa", "4 GPa"))
radius = 1e-3

modulus = contact_modulus(steel)  # the ball is rigid
first_yield = critical_values(radius, modulus, 800e6, poisson_ratio=0.3)
load = 20 * first_yield.load
hertz = point_contact(radius, modulus, load=load)

cell = hertz.contact_radius / 8
grid = SurfaceGrid(nx=49, ny=31, dx=cell, dy=cell)
distance = (grid.x**2 + grid.y**2) / (2 * radius)

elastic = ElasticContact(grid, steel).solve(distance, load=load)
print(f"approach over Hertz': {elastic.approach / hertz.approach:.4f}")
print(f"peak pressure over Hertz': {elastic.pressure.max() / hertz.peak_pressure:.4f}")

# %%
# ``grid.x`` is a row and ``grid.y`` a column, so that an expression of both is a field on the grid. Hertz' pressure is
# half an ellipsoid:

middle = grid.ny // 2
figure, axes = plt.subplots(figsize=(5.5, 3.2), layout="constrained")
x = np.linspace(-1.5, 1.5, 301)
axes.plot(x, np.sqrt(np.clip(1 - x**2, 0, None)), "--", color="0.5", label="Hertz")
axes.plot(
    grid.x / hertz.contact_radius,
    elastic.pressure[middle] / hertz.peak_pressure,
    "o",
    markersize=4,
    label="cells",
)
axes.set(xlabel="$x/a$", ylabel="$p/p_0$", xlim=(-1.5, 1.5))
axes.legend()
plt.show()

# %%
# The half space: what the pressure does below
# --------------------------------------------
# An operator is planned once for a grid and a material, and applied as often as you like. The tensor comes first: xx,
# yy, zz, yz, xz, xy. Below, von Mises' stress on the axis, beside Huber's closed form: largest about half a contact
# radius below the surface, where the first point yields.

volume = VolumeGrid(grid, nz=20, dz=cell)
half_space = HalfSpace(volume, steel)
stress = half_space.pressure_to_stress(elastic.pressure)


def von_mises(s):
    """Equivalent stress of a tensor field with the components first."""
    xx, yy, zz, yz, xz, xy = s
    normal = ((xx - yy) ** 2 + (yy - zz) ** 2 + (zz - xx) ** 2) / 2
    return np.sqrt(normal + 3 * (yz**2 + xz**2 + xy**2))


on_axis = np.s_[:, middle, grid.nx // 2]
depth = volume.z[:, 0, 0]
exact = point_contact_stress(0.0, 0.0, depth, hertz.contact_radius, hertz.peak_pressure, 0.3)

figure, axes = plt.subplots(figsize=(5.5, 3.2), layout="constrained")
axes.plot(
    depth / hertz.contact_radius, von_mises(exact) / 800e6, "--", color="0.5", label="Huber"
)
axes.plot(
    depth / hertz.contact_radius,
    von_mises(stress)[on_axis] / 800e6,
    "o",
    markersize=4,
    label="layers",
)
axes.axhline(1, color="C3", linewidth=0.8, label="yield stress")
axes.set(xlabel="depth $z/a$", ylabel=r"von Mises stress $/\,S_y$", ylim=(0, None))
axes.legend()
plt.show()

# %%
# The stress is far beyond yield, so this elastic answer is not what would happen.
#
# Both together: press, lift, move, press again
# ---------------------------------------------
# ``CoupledContact`` has the history of both bodies. An increment is one call: the distance of the smooth surfaces, and
# a load or an approach. Contact, plastic strain and residual displacement agree when it returns, or it says why not.
#
# The scenario is the loop: six steps up, three down, at two places 1.5 contact radii apart. The steps are even in
# load\ :sup:`2/3`, so nearly even in depth.

pair = CoupledContact(
    grid, volume, volume, steel, brinell.RIGID, scale=first_yield.interference
)
spots = (-0.75 * hertz.contact_radius, 0.75 * hertz.contact_radius)
loads = [load * s**1.5 for s in (*np.linspace(0, 1, 7)[1:], *np.linspace(1, 0, 4)[1:])]

dents, curves, dissipated = [], [], []
for spot in spots:
    ball = ((grid.x - spot) ** 2 + grid.y**2) / (2 * radius)
    before = pair.lower.dissipation
    reports = [pair.advance(ball, load=force) for force in loads]
    curves.append([(report.approach, report.load) for report in reports])
    dents.append(pair.lower.residual_displacement)
    dissipated.append(pair.lower.dissipation - before)

evaluations = sum(report.evaluations for report in reports)
print(f"{evaluations} evaluations for the {len(loads)} increments of the second dent")
print(f"dissipated: {dissipated[0] * 1e6:.3f} and {dissipated[1] * 1e6:.3f} µJ")

# %%
# What it shows
# -------------
# The second ball meets the rim of the first dent, so its contact begins earlier. At full load it has sunk in deeper, as
# on one side the first dent bears nothing. It pushes material into that dent, which becomes shallower.

figure, (left, right) = plt.subplots(1, 2, figsize=(9, 3.4), layout="constrained")
for dent, name in zip(dents, ("after the first", "after the second"), strict=True):
    left.plot(grid.x / hertz.contact_radius, -dent[middle] * 1e9, label=name)
left.axhline(0, color="0.7", linewidth=0.8, zorder=0)
left.set(xlabel="$x/a$", ylabel="height change [nm]")
left.legend()
for curve, name in zip(curves, ("first", "second"), strict=True):
    approach, force = (
        np.transpose([(0.0, 0.0), *curve]) if name == "first" else np.transpose(curve)
    )
    right.plot(approach * 1e9, force, "o-", markersize=3, label=name)
right.set(xlabel="approach [nm]", ylabel="load [N]")
right.legend()
plt.show()

# %%
# And what stays below: the residual stress along x, in the plane of symmetry. ``pair.lower.stress`` is that of the
# pressure and of the plastic strain together, and the pressure is gone.

residual = pair.lower.stress[0, :, middle, :]
limit = np.abs(residual).max() / 1e6
figure, axes = plt.subplots(figsize=(7, 3), layout="constrained")
mesh = axes.pcolormesh(
    grid.x / hertz.contact_radius,
    depth / hertz.contact_radius,
    residual / 1e6,
    cmap="RdBu_r",
    vmin=-limit,
    vmax=limit,
)
axes.set(xlabel="$x/a$", ylabel="$z/a$", aspect="equal")
axes.invert_yaxis()
figure.colorbar(mesh, label=r"residual $\sigma_{xx}$ [MPa]")
plt.show()

# %%
# Is the grid large enough? Pressure must not reach its edge, nor plastic strain. The scenarios watch that for you; in a
# scenario of your own it is yours to watch.

strain = pair.lower.equivalent_plastic_strain
edge = max(strain[-1].max(), strain[:, [0, -1]].max(), strain[:, :, [0, -1]].max())
print(f"pressure at the edge: {pair.reaches_edge}")
print(f"strain at the edge over the largest: {edge / strain.max():.1e}")

# %%
# From here: ``Place`` moves the contact grid over bodies that are longer than it, ``twin`` halves the work of two
# bodies that are alike, and the pages of the theory say what each block solves: :doc:`the half space
# </docs/theory/half-space>`, :doc:`the contact </docs/theory/contact>`, :doc:`the coupled increment
# </docs/theory/elastoplastic>`.
