# SPDX-License-Identifier: BSD-3-Clause
"""Plane strain and periodic surfaces from Python: one row of cells, and flats with roughness."""

from __future__ import annotations

import numpy as np
import pytest

import brinell

STEEL = brinell.Material("200 GPa", 0.3)
SOFT = brinell.Material("200 GPa", 0.3, brinell.Linear("300 MPa", "2 GPa"))


@pytest.fixture(scope="module")
def cylinder() -> brinell.Run:
    return brinell.Indentation(
        brinell.Body(brinell.Flat(), SOFT),
        brinell.Body(brinell.Cylinder("10 mm"), STEEL),
        load=["0.5 MN", 0],
        steps=4,
        grid=brinell.Grid(boundary=["open", "periodic"], resolution=8),
    ).run(in_memory=True)


def test_a_cylinder_in_plane_strain_has_one_row(cylinder: brinell.Run) -> None:
    final = cylinder.snapshot("final")
    assert final.lower.residual_displacement.shape[0] == 1
    assert final.lower.residual_displacement.max() > 0
    # The load is that of the period, 1 m.
    loaded = cylinder.snapshot(3)
    dx = np.diff(loaded.contact.x)[0]
    assert loaded.contact.pressure.sum() * dx * 1.0 == pytest.approx(0.5e6, rel=1e-6)


def test_figures_of_one_row_are_profiles(cylinder: brinell.Run) -> None:
    names = [named.name for named in brinell.plot.standard_figures(cylinder)]
    assert "residual-surfaces" in names
    assert {"loaded-section", "loaded-pressure", "loaded-gap"} <= set(names)
    contact = cylinder.snapshot(3).contact
    for draw, field in ((brinell.plot.pressure_map, contact.pressure), (brinell.plot.gap_map, contact.gap)):
        (ax,) = draw(cylinder, cylinder.snapshot(3), cells=True).axes
        (line,) = ax.lines
        drawn = np.asarray(line.get_ydata(), dtype=float)
        middle = (field.size - drawn.size) // 2
        shown = field[0, middle : middle + drawn.size]
        np.testing.assert_allclose(drawn / drawn.max(), shown / shown.max(), atol=1e-12)
    assert len(brinell.plot.residual_surfaces(cylinder, cylinder.snapshot("final")).axes) == 1


def test_a_rough_flat_is_pressed_by_a_mean_pressure() -> None:
    rough = brinell.RandomSurface(
        hurst=0.8, rms_slope=0.02, rolloff="50 um", cutoff="20 um", size=("100 um", "100 um"), seed=3
    )
    run = brinell.Indentation(
        brinell.Body(brinell.Flat(), STEEL, rough),
        brinell.Body(brinell.Flat(), STEEL),
        pressure=["20 MPa"],
        steps=2,
        grid={"boundary": "periodic", "size": ["100 um", "100 um"], "cells": [48, 48]},
    ).run(in_memory=True)
    assert run.history["F_n"][-1] == pytest.approx(20e6 * 1e-8, rel=1e-9)
    share = run.history["contact_area"][-1] / 1e-8
    # In proportion to the pressure over E' and slope, by sqrt(8/pi) (Persson) to sqrt(2 pi) (Bush, Gibson, Thomas) with
    # many waves; these are few.
    modulus = 200e9 / (2 * (1 - 0.3**2))
    assert 1.2 < share / (20e6 / (modulus * 0.02)) < 4.0
