# SPDX-License-Identifier: BSD-3-Clause
"""
From a measured surface to its friction
=======================================

An instrument has measured the heights of a bronze surface. A hard, smooth-ground counter body slides over it under a given
pressure. Which friction do the peaks add by ploughing, how fast do they run in, and how far can that number be trusted?
"""

# %%
# The measurement
# ---------------
# So that this page needs no file of an instrument, it makes one: a rough surface that lies askew, as a table of heights in
# micrometres with points that the instrument did not see. With a map of your own begin below, with `read`.

import matplotlib.pyplot as plt
import numpy as np

import brinell

truth = brinell.surfaces.random("96 um", 96, rms_height="80 nm", rolloff="12 um", cutoff="6 um", seed=3)
x = np.arange(96) * 1e-6
askew = truth.heights + 2e-3 * x + 1e-3 * x[:, None]
askew[np.random.default_rng(0).random(askew.shape) < 0.01] = np.nan
np.savetxt("measured.txt", 1e6 * askew)

# %%
# Read with its unit and its spacing, filled by a smooth surface where nothing was measured, and levelled.

measured = brinell.surfaces.read("measured.txt", spacing="1 um", unit="um", fill=True).levelled()
for name in ("Sq", "Sk", "Spk", "Svk"):
    print(f"{name:4} {1e9 * getattr(measured, name):6.1f} nm")
print(f"Sdq  {measured.Sdq:.3f}")

# %%
# Four samples
# ------------
# Sliding computes one period of surfaces that go on without end. A measured map does not repeat: its ends are made to
# fade into each other over a strip. Four parts of the map make four samples of the surface, and their scatter says how well
# they stand for it.

half = 47e-6
parts = [
    measured.cropped((a, a + half), (b, b + half)).joined("15 um")
    for a in (measured.x_axis[0], measured.x_axis[48])
    for b in (measured.y_axis[0], measured.y_axis[48])
]
print([f"{1e9 * part.Sq:.0f} nm" for part in parts], parts[0].heights.shape)

# %%
# Slide
# -----
# The counter body is steel, rough on a longer scale and harder. One cell per point of the map; strokes to and fro, each over a third
# of the period.

steel = brinell.Material("210 GPa", 0.3)  # no hardening law: stays elastic
bronze = brinell.Material("110 GPa", 0.34, brinell.Linear("350 MPa", "2 GPa"))


def sliding(part, number):
    """One part of the map under the ground steel."""
    size = part.size
    ground = brinell.RandomSurface(rms_height="40 nm", cutoff=size[0] / 3, size=size, seed=10 + number)
    cells = part.heights.shape[::-1]
    return brinell.Sliding(
        lower=brinell.Body(brinell.Flat(), bronze, brinell.HeightMap(part.heights, part.spacing, periodic=True)),
        upper=brinell.Body(brinell.Flat(), steel, ground),
        distance=size[0] / 3,
        pressure="60 MPa",
        strokes=2,
        to_and_fro=True,
        press_steps=4,
        interface={"friction": 0.1},
        grid={"boundary": "periodic", "size": list(size), "cells": list(cells)},
        title=f"part {number}",
    )


runs = [sliding(part, number).run() for number, part in enumerate(parts)]

# %%
# The friction by ploughing of each sample, in the first stroke and in the second, when the peaks have run in:

ploughing = np.array([[stroke.friction_ploughing for stroke in run.strokes] for run in runs])
print(np.round(ploughing, 5))

# %%
# How far to trust it
# -------------------
# Two errors remain beside that of the model. *Sampling*: the standard error of the mean over the samples. *Cells*: what the run itself
# expects from its cells, by the tables of the verification. They have nothing to do with each other.

mean = ploughing.mean(axis=0)
sampling = ploughing.std(axis=0, ddof=1) / np.sqrt(len(runs))
expected = runs[0].resolution["expected_errors"]
cells = abs(mean) * expected["friction by ploughing"]
error = np.hypot(sampling, cells)
for stroke, (value, by_sampling, by_cells, both) in enumerate(zip(mean, sampling, cells, error), 1):
    print(f"stroke {stroke}: {value:.5f} +- {both:.5f} (samples {by_sampling:.5f}, cells {by_cells:.5f})")
print(f"friction of the pair: {0.1 + mean[0]:.4f} at first, {0.1 + mean[1]:.4f} run in")

# %%
# Halve the spacing, or take a larger map, whichever of the two is the larger share. What the samples do in the course of
# the way:

figure = brinell.plot.along_way(runs)
plt.show()

# %%
# Running in
# ----------
# Both surfaces before and after, and their bearing-area curves: peaks are lower, valleys are as they were.

figure = brinell.plot.surfaces_before_and_after(runs[:1])
plt.show()

# %%
# And the contact in patches: how many, how large, and where.

figure = brinell.plot.contact_patches(runs[:1])
plt.show()
