# SPDX-License-Identifier: BSD-3-Clause
"""
From a measured surface to its friction
=======================================

An instrument has measured the heights of a bronze surface. A hard, smooth-ground counter body slides over it under a
given pressure. How much friction do the peaks add by ploughing, how do they run in, and how accurate is the number?
"""

# %%
# The measurement
# ---------------
# This page makes its own measurement: a tilted rough surface, as a table of heights in micrometres with points that
# the instrument did not see. With a map of your own, begin below with `read`.

import tempfile
from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np

import brinell

truth = brinell.surfaces.random("96 um", 96, rms_height="80 nm", rolloff="12 um", cutoff="6 um", seed=3)
x = np.arange(96) * 1e-6
askew = truth.heights + 2e-3 * x + 1e-3 * x[:, None]
askew[np.random.default_rng(0).random(askew.shape) < 0.01] = np.nan
file = Path(tempfile.mkdtemp(), "measured.txt")
np.savetxt(file, 1e6 * askew)

# %%
# The map is read with its unit and its spacing, filled by a smooth surface where nothing was measured, and levelled.

measured = brinell.surfaces.read(file, spacing="1 um", unit="um", fill=True).levelled()
for name in ("Sq", "Sk", "Spk", "Svk"):
    print(f"{name:4} {1e9 * getattr(measured, name):6.1f} nm")
print(f"Sdq  {measured.Sdq:.3f}")

# %%
# Four samples
# ------------
# Sliding computes one period of periodic surfaces. A measured map is not periodic, so its opposite ends are blended
# over a strip. Four parts of the map give four samples of the surface, and their scatter says how representative they
# are.

half = 47e-6
parts = [
    measured.cropped((a, a + half), (b, b + half)).joined("16 um")
    for a in (measured.x_axis[0], measured.x_axis[48])
    for b in (measured.y_axis[0], measured.y_axis[48])
]
print([f"{1e9 * part.Sq:.0f} nm" for part in parts], parts[0].heights.shape)

# %%
# Slide
# -----
# The counter body is steel, harder and rough on a longer scale. The grid has one cell per point of the map. Each stroke
# goes once round the period: the elastic work on the way up a peak is recovered on the way down, and the rest is
# friction. The second stroke meets the same peaks after they have run in.

steel = brinell.Material("210 GPa", 0.3)  # no hardening law: stays elastic
bronze = brinell.Material("110 GPa", 0.34, brinell.Linear("350 MPa", "2 GPa"))


def sliding(number, cells):
    """One part of the map under the ground steel, on so many cells along each axis."""
    part = parts[number]
    size = part.size
    ground = brinell.RandomSurface(rms_height="40 nm", cutoff=size[0] / 3, size=size, seed=10 + number)
    texture = brinell.HeightMap(part.heights, part.spacing, periodic=True)
    return brinell.Sliding(
        lower=brinell.Body(brinell.Flat(), bronze, texture),
        upper=brinell.Body(brinell.Flat(), steel, ground),
        distance=size[0],
        pressure="60 MPa",
        strokes=2,
        press_steps=3,
        interface={"friction": 0.1},
        grid={"boundary": "periodic", "size": list(size), "cells": [cells, cells]},
        title=f"part {number}",
    )


runs = [sliding(number, 32).run() for number in range(len(parts))]

# %%
# Friction by ploughing of each sample, in the first and in the second stroke:


def ploughing_of(run):
    """Friction by ploughing, stroke by stroke."""
    return np.array([stroke.friction_ploughing for stroke in run.strokes])


ploughing = np.array([ploughing_of(run) for run in runs])
print(np.round(ploughing, 5))

# %%
# How accurate it is
# ------------------
# Two errors remain beside that of the model. *Sampling*: the standard error of the mean over the samples. *Cells and
# steps*: one sample is computed again with cells and steps of twice the size; for errors of second order, the remaining
# error is a third of the difference. (The coarse run warns of its few cells.) The two errors are independent.

mean = ploughing.mean(axis=0)
sampling = ploughing.std(axis=0, ddof=1) / np.sqrt(len(runs))
coarse = ploughing_of(sliding(0, 16).run())
cells = abs(ploughing[0] - coarse) / 3
error = np.hypot(sampling, cells)
for stroke, value in enumerate(mean):
    print(
        f"stroke {stroke + 1}: {value:.5f} +- {error[stroke]:.5f}"
        f" (samples {sampling[stroke]:.5f}, cells {cells[stroke]:.5f})"
    )
print(f"friction of the pair: {0.1 + mean[0]:.4f} at first, {0.1 + mean[1]:.4f} run in")

# %%
# To reduce the error, halve the spacing or take a larger map, whichever of the two errors is larger. The samples over
# the sliding distance:

figure = brinell.plot.along_way(runs)
plt.show()

# %%
# Running in
# ----------
# Both surfaces before and after, and their bearing-area curves: peaks are lower, valleys are unchanged.

figure = brinell.plot.surfaces_before_and_after(runs[:1])
plt.show()

# %%
# Number, size and position of the contact patches:

figure = brinell.plot.contact_patches(runs[:1])
plt.show()
