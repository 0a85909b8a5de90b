# SPDX-License-Identifier: BSD-3-Clause
"""Where figures cut bodies that have yielded beside the middle, and how they draw the surfaces of a period."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from matplotlib.axes import Axes
from matplotlib.figure import Figure

import brinell
from brinell import plot
from brinell.plot import standard_figures
from brinell.plot.cli import plot as command
from brinell.plot.cuts import Cut, round_contact
from brinell.plot.states import Side
from brinell.plot.where import cutting_of
from figure_parts import curve, overlaps, texts

STEEL = brinell.Material("210 GPa", 0.3, brinell.Linear("900 MPa", "5 GPa"))
STIFF = brinell.Material("210 GPa", 0.3)

pytestmark = pytest.mark.filterwarnings("ignore::brinell.ResolutionWarning", "ignore::brinell.CaseWarning")


@pytest.fixture(scope="module")
def rim(tmp_path_factory: pytest.TempPathFactory) -> brinell.Run:
    """A track that has yielded beside its middle only, at a bump."""
    bump = brinell.Bump(x=0.0, y="16 um", height="0.3 um", edge_radius="4 um")
    case = brinell.Rolling(
        brinell.Body(brinell.Flat(), STEEL, bump),
        brinell.Body(brinell.Sphere("1 mm"), STIFF),
        load="0.4 N",
        distance="0.1 mm",
        grid={"resolution": 6},
        output={"snapshots": "all"},
    )
    return case.run(tmp_path_factory.mktemp("rim") / "run")


@pytest.fixture(scope="module")
def rough() -> brinell.Run:
    """Rough flats over a square period."""
    texture = brinell.RandomSurface(hurst=0.8, rms_slope=0.03, rolloff="100 um", cutoff="25 um", size=("200 um",) * 2)
    flat, other = brinell.Body(brinell.Flat(), STEEL, texture), brinell.Body(brinell.Flat(), brinell.RIGID)
    grid = {"boundary": "periodic", "size": ["200 um"] * 2, "cells": [32, 32]}
    return brinell.Indentation(flat, other, pressure=["60 MPa", 0], steps=2, grid=grid).run(in_memory=True)


def lengths(ax: Axes, fig: Figure) -> float:
    """Length of a unit of y on the sheet over that of x."""
    fig.draw_without_rendering()
    (x0, y0), (x1, y1) = ax.transData.transform([(0.0, 0.0), (1.0, 1.0)])
    return float((y1 - y0) / (x1 - x0))


def test_a_section_passes_through_the_largest_plastic_strain(rim: brinell.Run) -> None:
    body = rim.snapshot("final").lower
    strain = body.equivalent_plastic_strain
    row = np.unravel_index(np.argmax(strain), strain.shape)[1]
    assert strain[:, np.argmin(np.abs(body.y))].max() < 0.5 * strain.max()
    fig = plot.section(rim, "final", field="equivalent_plastic_strain")
    shown = np.asarray(fig.axes[0].images[0].get_array())
    np.testing.assert_allclose(shown, 100.0 * strain[:, row], rtol=1e-12)
    assert any("$y$ = 1" in t and "through the largest plastic strain" in t for t in texts(fig))
    asked = plot.section(rim, "final", field="equivalent_plastic_strain", plane="y=0")
    assert np.asarray(asked.axes[0].images[0].get_array()).max() < 0.5 * shown.max()
    assert not any("through" in t for t in texts(asked))


def test_the_profile_of_the_residual_surface_does_too(rim: brinell.Run) -> None:
    final = rim.snapshot("final")
    y = cutting_of(final).plane.value
    assert y > 10e-6
    fig = plot.residual_surfaces(rim, "final")
    row = int(np.argmin(np.abs(final.lower.y - y)))
    drawn = np.asarray(curve(fig.axes[0], "lower body").get_ydata())
    heights = -final.lower.residual_displacement[row]
    assert np.corrcoef(drawn, heights)[0, 1] == pytest.approx(1.0)
    assert any("profile on y = 1" in t and "through the largest plastic strain" in t for t in texts(fig))
    assert overlaps(fig) == []


def test_a_body_that_yields_in_the_middle_is_cut_there() -> None:
    ball = brinell.Body(brinell.Sphere("1 mm"), brinell.RIGID)
    run = brinell.Indentation(
        brinell.Body(brinell.Flat(), STEEL), ball, load=["5 N", 0], steps=2, grid={"resolution": 5}
    ).run(in_memory=True)
    for which in ("aligned", "final"):
        cutting = cutting_of(run.snapshot(which))  # type: ignore[arg-type]
        assert (cutting.plane.value, cutting.reason) == (0.0, "")
        assert cutting.text() == "y = 0"


def test_an_elastic_rough_contact_is_cut_through_the_largest_pressure() -> None:
    bump = brinell.Bump(x=0.0, y="30 um", height="1 um", edge_radius="8 um")
    flat = brinell.Body(brinell.Flat(), STIFF, bump)
    ball = brinell.Body(brinell.Sphere("2 mm"), STIFF)
    run = brinell.Indentation(flat, ball, load="0.2 N", steps=1, grid={"resolution": 6}).run(in_memory=True)
    snapshot = run.snapshot("aligned")
    cutting = cutting_of(snapshot)
    row = np.unravel_index(np.argmax(snapshot.contact.pressure), snapshot.contact.pressure.shape)[0]
    assert cutting.plane.value == snapshot.contact.y[row]
    assert cutting.reason == "through the largest pressure"


def test_captions_and_the_command_say_where(rim: brinell.Run, tmp_path: Path) -> None:
    captions = {named.name: named.caption for named in standard_figures(rim)}
    for name in ("residual-surfaces", "residual-section"):
        assert "(through the largest plastic strain)" in captions[name]
    command(["section", str(rim.path), "--step", "final", "-o", str(tmp_path)], standalone_mode=False)
    (file,) = tmp_path.iterdir()
    assert file.name.startswith("final-section-y-1")


def test_an_animation_shows_the_same_plane(rim: brinell.Run) -> None:
    animation = plot.animate(rim, field="equivalent_plastic_strain", bodies="lower")
    animation._init_draw()  # type: ignore[attr-defined]  # one that is not drawn warns
    assert "$y$ = 1" in animation._fig.get_suptitle()  # type: ignore[attr-defined]


def test_surfaces_of_a_period_are_drawn_whole_and_to_scale(rough: brinell.Run) -> None:
    fig = plot.residual_surfaces(rough, "final")
    profile, chart, _ = fig.axes
    body = rough.snapshot("final").lower
    edges = 1e6 * np.array([body.x[0], body.x[-1]]) + [-3.125, 3.125]  # of the cells
    np.testing.assert_allclose(chart.get_xlim(), edges)
    np.testing.assert_allclose(np.ptp([*chart.get_ylim()]), 200.0)
    assert lengths(chart, fig) == pytest.approx(1.0, rel=1e-6)
    assert not any("reduced" in t or "enlarged" in t for t in texts(fig) if t.startswith("$y$"))
    assert max(fig.get_size_inches()) < 10.0
    assert overlaps(fig) == []
    section = plot.section(rough, "final")
    np.testing.assert_allclose(section.axes[0].get_xlim(), edges)
    assert profile.get_xlim() == chart.get_xlim()


def test_a_section_shows_each_piece_of_a_rough_contact(rough: brinell.Run) -> None:
    contact = rough.snapshot("aligned").contact
    beginnings = np.count_nonzero(np.diff((contact.pressure > 0.0).astype(int), axis=1) > 0, axis=1)
    row = int(np.argmax(beginnings))
    fig = plot.section(rough, "aligned", plane=("y", float(contact.y[row])))
    ends = 1e-6 * np.asarray(curve(fig.axes[0], "contact").get_xdata())
    touching = contact.pressure[row] > 0.0
    pieces = np.count_nonzero(np.diff(touching.astype(int), prepend=0) > 0)
    assert pieces > 1
    assert np.count_nonzero(np.isnan(ends)) == pieces - 1
    for x in contact.x[touching]:
        assert any(start <= x <= end for start, end in zip(ends[::3], ends[1::3], strict=True))
    for x in contact.x[~touching]:
        assert not any(start < x < end for start, end in zip(ends[::3], ends[1::3], strict=True))


def test_a_period_is_turned_round_to_the_contact() -> None:
    across = np.array([-0.5, 0.5, 1.5, 2.5]) + 1.2
    values = np.arange(8.0).reshape(2, 4)
    side = both_sides_of_nothing()
    turned = round_contact(Cut(side, across, np.array([-0.5, -1.5]), values))
    np.testing.assert_allclose(turned.across, [-1.3, -0.3, 0.7, 1.7])
    np.testing.assert_array_equal(turned.values, np.roll(values, 2, axis=1))


def both_sides_of_nothing() -> Side:
    return Side("lower body", None, "", "-", -1.0)  # type: ignore[arg-type]
