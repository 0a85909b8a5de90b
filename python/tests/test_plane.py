# SPDX-License-Identifier: BSD-3-Clause
"""Plane strain and periodic surfaces from Python: one row of cells, and flats with roughness."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from matplotlib.legend import Legend

import brinell
from brinell.contact import ElasticContact
from brinell.halfspace import SurfaceGrid

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


def test_no_profile_across_the_track_of_a_cylinder() -> None:
    run = brinell.Rolling(
        brinell.Body(brinell.Flat(), SOFT),
        brinell.Body(brinell.Cylinder("10 mm"), STEEL),
        load="0.5 MN",
        distance="0.2 mm",
        grid=brinell.Grid(boundary=["open", "periodic"], resolution=6),
    ).run(in_memory=True)
    assert run.snapshot("final").lower.residual_displacement.max() > 0
    assert brinell.plot.track_profile([run]) is None


def rough_flat(**drive: Any) -> brinell.Indentation:
    rough = brinell.RandomSurface(hurst=0.8, rms_slope=0.02, rolloff="50 um", cutoff="20 um", seed=3)
    return brinell.Indentation(
        brinell.Body(brinell.Flat(), STEEL, rough),
        brinell.Body(brinell.Flat(), STEEL),
        steps=2,
        grid={"boundary": "periodic", "size": ["100 um", "100 um"], "cells": [48, 48]},
        **drive,
    )


def test_a_rough_flat_is_pressed_by_a_mean_pressure() -> None:
    run = rough_flat(pressure=["20 MPa"]).run(in_memory=True)
    assert run.history["F_n"][-1] == pytest.approx(20e6 * 1e-8, rel=1e-9)
    share = run.history["contact_area"][-1] / 1e-8
    # In proportion to the pressure over E' and slope, by sqrt(8/pi) (Persson) to sqrt(2 pi) (Bush, Gibson, Thomas) with
    # many waves; these are few.
    modulus = 200e9 / (2 * (1 - 0.3**2))
    assert 1.2 < share / (20e6 / (modulus * 0.02)) < 4.0
    assert run.history["contact_fraction"][-1] == pytest.approx(share, rel=1e-12)
    assert run.history["nominal_pressure"][-1] == pytest.approx(20e6, rel=1e-9)
    assert run.summary is not None
    geometry = run.summary["geometry"]
    assert geometry["rms_slope"] == pytest.approx(0.02, rel=1e-6)
    (indent,) = run.indents
    assert indent.mean_gap == run.history["mean_gap"][-1] < geometry["touching_gap_m"]
    assert indent.contact_stiffness == run.history["contact_stiffness"][-1] > 0
    figure = brinell.plot.contact_fraction([run])
    assert figure is not None
    drawn = {line.get_label(): line for line in figure.axes[0].lines}
    assert {"Persson, elastic", "Bush, Gibson, Thomas, elastic"} <= drawn.keys()
    np.testing.assert_array_equal(figure.axes[0].lines[0].get_ydata(), run.history["contact_fraction"])
    np.testing.assert_allclose(figure.axes[0].lines[0].get_xdata()[-1], 20e6 / (modulus * 0.02), rtol=1e-6)
    assert "contact-fraction" in [named.name for named in brinell.plot.standard_figures(run)]


def test_the_figure_of_contact_tells_unloading_and_a_gap_of_less_than_a_decade() -> None:
    run = rough_flat(pressure=["20 MPa", "1 MPa"]).run(in_memory=True)
    figure = brinell.plot.contact_fraction([run])
    assert figure is not None
    share, gap = figure.axes[:2]
    loading, unloading = share.lines[:2]
    np.testing.assert_array_equal(np.isfinite(loading.get_ydata()), [True, True, False, False])
    np.testing.assert_array_equal(np.isfinite(unloading.get_ydata()), [False, True, True, True])
    assert loading.get_linestyle() != unloading.get_linestyle()
    assert gap.get_yscale() == "linear"  # a mean gap falls by less than a half here
    shown = [text.get_text() for legend in figure.findobj(Legend) for text in legend.get_texts()]
    assert "unloading" in shown


def test_a_rough_flat_is_pressed_to_a_mean_gap() -> None:
    by_pressure = rough_flat(pressure=["50 MPa"]).run(in_memory=True)
    gap = float(by_pressure.history["mean_gap"][-1])
    run = rough_flat(mean_gap=[gap, "1 mm"]).run(in_memory=True)
    assert run.history["mean_gap"][1] == pytest.approx(gap, rel=1e-9)
    assert run.history["nominal_pressure"][1] == pytest.approx(50e6, rel=1e-4)
    assert run.history["contact_cells"][-1] == 0
    with pytest.raises(brinell.InputError, match="mean_gap"):
        rough_flat(mean_gap=["1 mm"])
    with pytest.raises(brinell.InputError, match="mean_gap"):
        rough_flat(mean_gap=[-gap])


def test_a_mean_gap_and_the_stiffness_of_a_wave() -> None:
    """Westergaard: gap h (1 - s + s ln s), stiffness pi E' / (L ln(1/s)) at the share s of the full pressure."""
    grid = SurfaceGrid(256, 4, 1e-6 / 256, 1e-6 / 4, boundary="periodic")
    contact = ElasticContact(grid, STEEL)
    modulus = contact.compliance.contact_modulus
    wave = 1e-9 * (1 - np.cos(2 * np.pi * grid.x / 1e-6)) * np.ones(grid.shape)
    s = 0.3
    result = contact.solve(wave, mean_gap=1e-9 * (1 - s + s * np.log(s)))
    pressure = result.pressure.mean()
    assert pressure == pytest.approx(s * np.pi * modulus * 1e-9 / 1e-6, rel=5e-3)
    stiffness = contact.stiffness(result.pressure) / (grid.cell_area * wave.size)
    assert stiffness == pytest.approx(np.pi * modulus / (1e-6 * np.log(1 / s)), rel=2e-2)  # whole cells at the edge
    with pytest.raises(brinell.InputError, match="mean_gap"):
        contact.solve(wave, mean_gap=-1e-9)
    with pytest.raises(brinell.InputError, match="mean_gap"):
        ElasticContact(SurfaceGrid(8, 8, 1e-6, 1e-6), STEEL).solve(np.zeros((8, 8)), mean_gap=1e-9)
    with pytest.raises(brinell.InputError, match="either load or approach"):
        contact.solve(wave, mean_gap=1e-10, load=1.0)
