# SPDX-License-Identifier: BSD-3-Clause
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest

import brinell
from brinell.plot import rolling
from brinell.plot.overlay import entries
from brinell.results import RunError, open_run
from brinell.scenarios.rolling import TRAITS
from figure_parts import curve, legend_of, texts

MakeRun = Callable[..., Path]


def test_pass_by_pass(make_rolling: MakeRun) -> None:
    run = open_run(make_rolling(passes=4))
    fig = rolling.pass_by_pass([run])
    assert fig is not None
    names = ("rut_depth", "shoulder_height", "resistance", "track_plastic_strain", "track_plastic_increment")
    for ax, name, scale in zip(fig.axes, (*names, "dissipation"), (1e-6, 1e-6, 1.0, 0.01, 0.01, 1.0), strict=True):
        line = curve(ax, "rolling")
        np.testing.assert_array_equal(line.get_xdata(), [1, 2, 3, 4])
        np.testing.assert_allclose(line.get_ydata(), [getattr(one, name) / scale for one in run.passes])
        assert (ax.get_yscale() == "log") == (name in ("track_plastic_increment", "dissipation"))
    assert "[µm]" in fig.axes[0].get_ylabel()
    texts(fig)


def test_single_pass_has_nothing_to_compare(make_rolling: MakeRun) -> None:
    assert rolling.pass_by_pass([open_run(make_rolling(passes=1))]) is None


def test_few_passes_are_drawn_without_decades(make_rolling: MakeRun) -> None:
    runs = [open_run(make_rolling(passes=1, name="one")), open_run(make_rolling(passes=2, name="two"))]
    fig = rolling.pass_by_pass(runs)
    assert fig is not None
    assert {ax.get_yscale() for ax in fig.axes} == {"linear"}
    for ax in fig.axes:
        ticks = ax.get_xticks()
        np.testing.assert_array_equal(ticks, np.round(ticks))
    texts(fig)


def test_elastic_runs_have_no_depth_profiles_and_names_without_folders() -> None:
    steel, flat = brinell.Material("210 GPa", 0.3), brinell.Flat()
    bodies = brinell.Body(flat, steel), brinell.Body(brinell.Sphere("1 mm"), steel)
    with pytest.warns(brinell.ResolutionWarning):
        runs = [
            brinell.Rolling(*bodies, "0.02 mm", load="1 N", grid={"resolution": 3}).run(in_memory=True)
            for _ in range(2)
        ]
    assert rolling.depth_profiles(runs) is None
    assert [entry.label for entry in entries(runs, "rolling")] == ["rolling (1)", "rolling (2)"]


def test_depth_profiles(make_rolling: MakeRun) -> None:
    runs = [open_run(make_rolling(name=name)) for name in ("one", "two")]
    fig = rolling.depth_profiles(runs)
    assert fig is not None
    profile = runs[0].profile
    for ax, values in zip(
        fig.axes,
        (1e-6 * profile.residual_xx, 1e-6 * profile.residual_yy, 100.0 * profile.equivalent_plastic_strain),
        strict=True,
    ):
        np.testing.assert_allclose(curve(ax, "one").get_xdata(), 1e3 * profile.depth)
        np.testing.assert_allclose(curve(ax, "two").get_ydata(), values)
    assert legend_of(fig.axes[2]) == ["one", "two"]
    assert "[MPa]" in fig.axes[0].get_ylabel()
    texts(fig)


def test_track_profile(make_rolling: MakeRun) -> None:
    run = open_run(make_rolling())
    body = run.snapshot("final").lower
    fig = rolling.track_profile([run])
    assert fig is not None
    line = curve(fig.axes[0], "rolling, 3 passes")
    np.testing.assert_allclose(line.get_xdata(), 1e3 * body.y)
    np.testing.assert_allclose(line.get_ydata(), -1e6 * body.residual_displacement[:, 30])
    texts(fig)


def test_elastic_rolling_leaves_no_track(make_rolling: MakeRun) -> None:
    assert rolling.track_profile([open_run(make_rolling(yields=False))]) is None


def test_all_passes_of_one_run_along_the_track(make_rolling: MakeRun) -> None:
    run = open_run(make_rolling(passes=3))
    fig = rolling.along_track([run])
    resistance, approach = fig.axes
    for number, one in enumerate(run.history.passes(), start=1):
        x = np.asarray(curve(resistance, str(number)).get_xdata())
        assert len(x) == 11  # from the last step of pressing on to the first of lifting off
        assert np.all(np.diff(x) > 0.0)
        np.testing.assert_allclose(curve(resistance, str(number)).get_ydata(), 1e-3 * one["F_X"][2:13])
        np.testing.assert_allclose(curve(approach, str(number)).get_ydata(), 1e6 * one["approach"][2:13])
    assert legend_of(resistance) == ["1", "2", "3"]
    texts(fig)


def test_first_and_last_pass_of_several_runs(make_rolling: MakeRun) -> None:
    runs = [open_run(make_rolling(name="long", passes=3)), open_run(make_rolling(name="short", passes=1))]
    assert legend_of(rolling.along_track(runs).axes[0]) == ["long, pass 1", "long, pass 3", "short, pass 1"]


def test_load_is_drawn_where_the_approach_is_imposed(make_rolling: MakeRun) -> None:
    fig = rolling.along_track([open_run(make_rolling(approach=1e-4))])
    assert "$F_n$" in fig.axes[1].get_ylabel()


def test_legend_of_many_passes_is_thinned(make_rolling: MakeRun) -> None:
    labels = legend_of(rolling.along_track([open_run(make_rolling(passes=20))]).axes[0])
    assert len(labels) == 8
    assert (labels[0], labels[-1]) == ("1", "20")


@pytest.mark.parametrize("draw", [one.draw for one in TRAITS.drawings().figures.values()])
def test_other_scenarios_are_refused(make_run: MakeRun, draw: Callable) -> None:
    with pytest.raises(RunError, match="is of scenario 'tugging', this figure needs 'rolling'"):
        draw([open_run(make_run())])
