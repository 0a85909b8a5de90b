# SPDX-License-Identifier: BSD-3-Clause
import warnings
from collections.abc import Callable
from pathlib import Path

import h5py
import numpy as np
import pytest
from matplotlib.figure import Figure

import brinell
from brinell.plot import indentation
from brinell.plot.cells import contact_edge
from brinell.plot.rough import contact_fraction
from brinell.results import RunError, open_run
from brinell.scenarios.indentation import TRAITS
from figure_parts import curve, legend_of, texts

MakeRun = Callable[..., Path]
ALPHA_C, P_C = 2.214290e-4, 3.460928e5


def test_load_over_depth(make_indentation: MakeRun) -> None:
    """Loading, unloading and the second cycle in one line that begins at the touch."""
    run = open_run(make_indentation(cycles=2))
    fig = indentation.load_depth([run])
    ax = fig.axes[0]
    line = curve(ax, "indentation")
    np.testing.assert_allclose(line.get_xdata(), 1e3 * np.concatenate([[0.0], run.history["approach"]]))
    np.testing.assert_allclose(line.get_ydata(), 1e-6 * np.concatenate([[0.0], run.history["F_n"]]))
    elastic = curve(ax, "elastic (Hertz)")
    assert np.max(elastic.get_ydata()) == pytest.approx(3.0)
    assert np.max(elastic.get_xdata()) == pytest.approx(1e3 * ALPHA_C * (3e6 / P_C) ** (2.0 / 3.0))
    assert legend_of(ax) == ["indentation", "elastic (Hertz)"]
    written = texts(fig)
    assert any(t.endswith("[mm]") for t in written)
    assert any(t.endswith("[MN]") for t in written)


def test_several_results_lie_over_each_other(make_indentation: MakeRun) -> None:
    runs = [open_run(make_indentation(load, name=name)) for load, name in ((3e6, "soft"), (2e6, "hard"))]
    ax = indentation.load_depth(runs).axes[0]
    assert legend_of(ax) == ["soft", "hard", "elastic (Hertz)"]
    one, other = curve(ax, "soft"), curve(ax, "hard")
    assert one.get_color() != other.get_color()
    assert one.get_linestyle() == other.get_linestyle() == "-"


def test_places_of_one_result_are_told_apart(make_indentation: MakeRun) -> None:
    run = open_run(make_indentation(places=(-0.1, 0.1)))
    ax = indentation.load_depth([run]).axes[0]
    assert legend_of(ax) == ["$x$ = −100 mm", "$x$ = 100 mm", "elastic (Hertz)"]
    assert len({line.get_linestyle() for line in ax.lines[:2]}) == 2  # they lie on each other
    # Only the first place is known to be touched at depth 0.
    assert np.asarray(curve(ax, "$x$ = 100 mm").get_ydata())[0] > 0.0


@pytest.mark.parametrize("options", [{"texture": "dent"}, {"upper": "vickers"}])
def test_no_hertz_for_other_surfaces(make_indentation: MakeRun, options: dict) -> None:
    run = open_run(make_indentation(**options))
    ax = indentation.load_depth([run]).axes[0]
    assert [line.get_label() for line in ax.lines] == ["indentation"]
    assert ax.get_legend() is None
    assert (np.asarray(ax.lines[0].get_ydata())[0] > 0.0) == ("texture" in options)


def test_imprint(make_indentation: MakeRun) -> None:
    run = open_run(make_indentation())
    body = run.snapshot("final").lower
    fig = indentation.imprint([run])
    assert fig is not None
    along_x, along_y, *pile_up = fig.axes
    heights = -1e3 * body.residual_displacement
    np.testing.assert_allclose(curve(along_x, "indentation").get_ydata(), heights[7])
    np.testing.assert_allclose(curve(along_x, "indentation").get_xdata(), 1e3 * body.x)
    np.testing.assert_allclose(curve(along_y, "indentation").get_ydata(), heights[:, 30])
    low, high = pile_up[0].get_ylim()
    assert high == pytest.approx(1.15 * heights.max())
    assert low > along_x.get_ylim()[0]
    assert "pile-up" in pile_up[0].get_ylabel()
    assert any("through $x$ = 0" in t for t in texts(fig))


def test_nothing_is_left_of_an_elastic_indentation(make_indentation: MakeRun) -> None:
    assert indentation.imprint([open_run(make_indentation(yields=False))]) is None


def test_contact_pressure(make_indentation: MakeRun) -> None:
    run = open_run(make_indentation())
    contact = run.snapshot("aligned").contact
    fig = indentation.contact_pressure([run])
    assert fig is not None
    label = "indentation,  $F_n$ = 3 MN"
    np.testing.assert_allclose(curve(fig.axes[0], label).get_ydata(), 1e-9 * contact.pressure[10])
    np.testing.assert_allclose(curve(fig.axes[1], label).get_ydata(), 1e-9 * contact.pressure[:, 20])
    texts(fig)


def test_no_pressure_without_a_loaded_state(make_indentation: MakeRun) -> None:
    run = open_run(make_indentation())
    _drop_steps(run.path / "result.vtkhdf")
    assert indentation.contact_pressure([run]) is None


def _drop_steps(path: Path) -> None:
    with h5py.File(path, "a") as file:
        del file["steps"]


def test_no_contact_fraction_without_a_period(make_indentation: MakeRun) -> None:
    assert contact_fraction([open_run(make_indentation())]) is None


@pytest.mark.parametrize("draw", [one.draw for one in TRAITS.drawings().figures.values()])
def test_other_scenarios_are_refused(make_rolling: MakeRun, draw: Callable) -> None:
    with pytest.raises(RunError, match="is of scenario 'rolling', this figure needs 'indentation'"):
        draw([open_run(make_rolling())])


def test_at_default_settings_contact_is_round_and_the_load_curve_smooth() -> None:
    """The case of `brinell new indentation`, at its own resolution, pressed on.

    A contact counted in cells looked like an octagon, which is up to 1 - cos(pi/8) = 7.6 % off its circle, and its load
    went up in steps. Between the cells, 2 % is a sixth of a cell here.
    """
    soft = brinell.Material("210 GPa", 0.3, brinell.Linear("900 MPa", "2 GPa"))
    ball = brinell.Body(brinell.Sphere("1 mm"), brinell.Material("210 GPa", 0.3))
    case = brinell.Indentation(brinell.Body(brinell.Flat(), soft), ball, load=["200 N"], steps=10)
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # of strain
        run = case.run(in_memory=True)
    contact = run.snapshot(run.steps[-1]).contact
    axes = Figure().subplots()
    (outline,) = axes.contour(contact.x, contact.y, contact_edge(contact), levels=[0.0]).get_paths()
    radius = np.hypot(*outline.vertices.T)
    np.testing.assert_allclose(radius, radius.mean(), rtol=0.02)
    assert radius.mean() == pytest.approx(run.history["contact_radius"][-1], rel=0.02)
    depth, load = np.log(run.history["approach"][2:]), np.log(run.history["F_n"][2:])
    smooth = np.polyval(np.polyfit(depth, load, 2), depth)  # close to a power law
    np.testing.assert_allclose(np.exp(load - smooth), 1.0, rtol=0.02)


@pytest.mark.parametrize(
    "name",
    ["interference", "normalised_interference", "lower_radius", "upper_radius", "offset", "closest_interference"],
)
def test_what_only_a_tugging_has_is_told(make_indentation: MakeRun, name: str) -> None:
    run = open_run(make_indentation())
    with pytest.raises(RunError, match=f"is of scenario 'indentation'; only results of 'tugging' have {name}"):
        getattr(run, name)
