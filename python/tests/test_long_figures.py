# SPDX-License-Identifier: BSD-3-Clause
"""Figures of long contacts, thin plastic layers, and bodies that yield beside the middle: legible, and not empty."""

from __future__ import annotations

import matplotlib
import numpy as np
import pytest

import brinell
from brinell import plot
from brinell.plot import standard_figures
from figure_parts import overlaps

STEEL = brinell.Material("210 GPa", 0.3, brinell.Linear("1 GPa", "5 GPa"))
BALL = brinell.Body(brinell.Sphere("6.35 mm"), brinell.Material("310 GPa", 0.26))

pytestmark = pytest.mark.filterwarnings("ignore::brinell.ResolutionWarning")


def groove(x: str, y: str, load: str = "1200 N") -> brinell.Run:
    """A ball pressed into a groove: a long ellipse."""
    body = brinell.Body(brinell.Ellipsoid(x, y), STEEL)
    return brinell.Indentation(body, BALL, load=[load, 0], steps=2, grid={"resolution": 5}).run(in_memory=True)


@pytest.fixture(scope="module")
def grooves() -> dict[str, brinell.Run]:
    return {
        "long along y": groove("-60 mm", "-6.6 mm"),
        "long along x": groove("-6.6 mm", "-60 mm"),
        "very long along y": groove("-60 mm", "-6.37 mm"),
    }


@pytest.mark.parametrize("name", ["long along y", "long along x", "very long along y"])
@pytest.mark.parametrize("draw", [plot.pressure_map, plot.gap_map])
def test_a_long_contact_lies_on_a_wide_sheet(grooves: dict[str, brinell.Run], name: str, draw: object) -> None:
    run = grooves[name]
    fig = draw(run, "aligned")  # type: ignore[operator]
    assert overlaps(fig) == []
    width, height = fig.get_size_inches()
    assert width > 1.8 * height
    ax, bar = fig.axes
    turned = name.endswith("y")
    assert ("y'" in ax.get_xlabel()) == turned
    box, bar_box = ax.get_position(), bar.get_position()
    assert bar_box.y1 < box.y0  # below
    assert 0.6 < bar_box.width / box.width < 1.1  # as long as the map, which fills the sheet
    assert box.width > 0.75
    # A length is as long on both axes, but for the factor that the label names.
    across, upward = ax.get_xlim(), ax.get_ylim()
    scale = (box.height * height / (upward[1] - upward[0])) / (box.width * width / (across[1] - across[0]))
    text = ax.get_ylabel()
    named = float(text.split("enlarged ")[1].split()[0]) if "enlarged" in text else 1.0
    assert scale == pytest.approx(named, rel=0.06)  # two digits
    assert (named > 1.0) == name.startswith("very")
    pressure = run.snapshot("aligned").contact.pressure
    if draw is plot.pressure_map:
        shown = np.ma.masked_invalid(ax.images[0].get_array())
        assert shown.max() == pytest.approx(pressure.max() / 1e9, rel=1e-2)  # between cells
        assert (shown.shape[1] > shown.shape[0]) == (pressure.shape[0] > pressure.shape[1] or not turned)


def test_residual_surfaces_of_a_long_dent_fit_a_page() -> None:
    run = brinell.Indentation(
        brinell.Body(brinell.Ellipsoid("-60 mm", "-6.6 mm"), STEEL),
        BALL,
        load=["2500 N", 0],
        steps=2,
        grid={"resolution": 5},
    ).run(in_memory=True)
    fig = plot.residual_surfaces(run, "final")
    assert fig.get_size_inches()[1] < 9.0
    assert "reduced" in fig.axes[1].get_ylabel()
    assert overlaps(fig) == []


def test_a_thin_plastic_layer_is_drawn_enlarged() -> None:
    rough = brinell.RandomSurface(hurst=0.8, rms_slope=0.02, rolloff="40 um", cutoff="16 um", size=("400 um", "100 um"))
    flat = brinell.Body(brinell.Flat(), STEEL, rough)
    grid = {"boundary": "periodic", "size": ["400 um", "100 um"], "cells": [64, 16]}
    run = brinell.Indentation(
        flat, brinell.Body(brinell.Flat(), brinell.RIGID), pressure=["150 MPa", 0], steps=2, grid=grid
    ).run(in_memory=True)
    fig = plot.section(run, "final")
    assert "enlarged" in fig.axes[0].get_ylabel()
    assert overlaps(fig) == []
    # Nothing has yielded under x = y = 0: the profile over depth is where the strain is.
    final = run.snapshot("final").lower
    assert final.equivalent_plastic_strain.max() > 0.0
    over_depth = plot.stress_over_depth(run)
    drawn = np.concatenate([np.asarray(line.get_ydata()) for line in over_depth.axes[1].lines])
    assert drawn.max() == pytest.approx(100 * final.equivalent_plastic_strain.max(), rel=1e-6)


@pytest.fixture(scope="module")
def rim() -> brinell.Run:
    """A track that has yielded beside its middle only, at a bump."""
    bump = brinell.Bump(x=0.0, y="16 um", height="0.3 um", edge_radius="4 um")
    flat = brinell.Body(brinell.Flat(), brinell.Material("210 GPa", 0.3, brinell.Linear("900 MPa", "5 GPa")), bump)
    ball = brinell.Body(brinell.Sphere("1 mm"), brinell.Material("210 GPa", 0.3))
    return brinell.Rolling(flat, ball, load="0.4 N", distance="0.1 mm", grid={"resolution": 6}).run(in_memory=True)


def test_depth_profiles_are_where_the_strain_is(rim: brinell.Run) -> None:
    assert rim.profile.equivalent_plastic_strain.max() == 0.0
    fig = plot.depth_profiles(rim)
    assert fig is not None
    final = rim.snapshot("final").lower
    (line,) = [one for one in fig.axes[2].lines if len(one.get_xdata()) > 2]
    assert np.max(line.get_ydata()) == pytest.approx(100 * final.equivalent_plastic_strain.max())
    texts = " ".join(text.get_text() for text in fig.findobj(matplotlib.text.Text))
    assert "Under the largest plastic strain" in texts
    assert "µm" in texts.split("$y$ = ")[1][:12]


def test_the_figures_of_such_a_run_can_be_drawn(rim: brinell.Run) -> None:
    names = [named.name for named in standard_figures(rim)]
    assert "depth-profiles" in names
    assert "residual-depth" in names
