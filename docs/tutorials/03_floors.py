# SPDX-License-Identifier: BSD-3-Clause
"""
A scenario of your own, from the floors
=======================================

The scenarios are loops over a few building blocks, which you can use yourself: contact, half space, plasticity, and
the coupled contact. This page introduces the floors of the code one by one, checks the elastic ones against closed
forms, and ends with a scenario made of these blocks: a ball that is pressed in twice, so closely side by side that the
second dent runs into the first.
"""

# %%
# The contact: who presses where
# ------------------------------
# A grid of cells carries the pressure. The ball enters by its distance from the flat. The elastic contact only uses the
# elastic constants of a material.

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
# ``grid.x`` is a row and ``grid.y`` a column, so that an expression of both is a field on the grid. Hertz' pressure
# distribution is half an ellipsoid:

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
# The half space: stress below the surface
# ----------------------------------------
# An operator is planned once for a grid and a material, and applied as often as you like. The first axis of a stress
# field has the components xx, yy, zz, yz, xz, xy. The figure compares the von Mises stress on the axis with Huber's
# closed form; it is largest about half a contact radius below the surface, where the first point yields.

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
# The stress is far beyond yield, so this elastic solution is not the real one.
#
# Coupled contact: press, lift, move, press again
# -----------------------------------------------
# ``CoupledContact`` keeps the history of both bodies. An increment is one call, with the distance of the smooth
# surfaces and a load or an approach. When the call returns, contact, plastic strain and residual displacement agree;
# otherwise it raises an error with the reason.
#
# The scenario is the loop: six steps of loading and three of unloading, at two places 1.5 contact radii apart. The
# steps are equal in load\ :sup:`2/3`, and thus nearly equal in depth.

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
# The result
# ----------
# The second ball meets the rim of the first dent, so its contact begins earlier. At full load the ball has sunk in
# deeper, since the first dent bears no load on one side. The ball pushes material into that dent, which becomes
# shallower.

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
# The residual stress along x below the surface, in the plane of symmetry: ``pair.lower.stress`` is the stress due to
# the pressure and the plastic strain, and the pressure is zero now.

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
# Is the grid large enough? Neither pressure nor plastic strain may reach its edge. The scenarios of brinell check that;
# in a scenario of your own you have to check it.

strain = pair.lower.equivalent_plastic_strain
edge = max(strain[-1].max(), strain[:, [0, -1]].max(), strain[:, :, [0, -1]].max())
print(f"pressure at the edge: {pair.reaches_edge}")
print(f"strain at the edge over the largest: {edge / strain.max():.1e}")

# %%
# Next steps: ``Place`` moves the contact grid over bodies that are longer than the grid, ``twin`` halves the work for
# two equal bodies, and the theory pages describe what each block solves: :doc:`the half space
# </docs/theory/half-space>`, :doc:`the contact </docs/theory/contact>`, :doc:`the coupled increment
# </docs/theory/elastoplastic>`.
