# SPDX-License-Identifier: BSD-3-Clause
"""Histories at points within the bodies: the same numbers as those of the stored fields."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest

import brinell
from brinell.plot.cli import plot as command
from brinell.results import COMPONENTS, PointHistory, Run
from figure_parts import overlaps, texts
from kinds_of_runs import Kind

pytestmark = pytest.mark.filterwarnings("ignore::brinell.ResolutionWarning", "ignore::brinell.CaseWarning")

KIND = Kind("rolling", "plastic", "elastic", "open", "heat")
POINTS = [
    {"depth": "12 um"},
    {"depth": "25 um", "x": "20 um", "y": "-5 um"},
    {"depth": "12 um", "body": "upper", "x": "-20 um"},
]


def case(kind: Kind = KIND, points: Any = POINTS, **output: Any) -> brinell.Case:
    return kind.case(output={"snapshots": "all", "points": points, **output})


@pytest.fixture(scope="module")
def run(tmp_path_factory: pytest.TempPathFactory) -> Run:
    return case().run(tmp_path_factory.mktemp("points") / "run")


def assert_as_the_fields(point: PointHistory, run: Run) -> None:
    assert point.step.tolist() == run.steps == list(range(run.history.steps))

    def over_time(name: str) -> np.ndarray:
        field = run.field(point.body, name)
        return field.sel(x=point.x, y=point.y, z=point.depth, method="nearest").values[:-1]

    # Strains are the same numbers. Stress and temperature are sums of as many numbers as in the fields, in another
    # order. The images of heat are removed to 3e-4 of the largest value, in one layer not quite as in all of them.
    rounding = 1e-4 if np.isfinite(point["temperature"]).any() else 1e-11
    largest = float(np.nanmax(point["von_mises_stress"]))
    for name in ("equivalent_plastic_strain", *(f"plastic_strain_{component}" for component in COMPONENTS)):
        np.testing.assert_array_equal(point[name], over_time(name))
    for name in ("von_mises_stress", *(f"stress_{component}" for component in COMPONENTS)):
        np.testing.assert_allclose(point[name], over_time(name), rtol=0.0, atol=rounding * largest)
    if "temperature" in run.field_names(point.body):
        rise = float(np.ptp(point["temperature"]))
        np.testing.assert_allclose(point["temperature"], over_time("temperature"), rtol=0.0, atol=rounding * rise)


def test_they_are_those_of_the_stored_fields(run: Run) -> None:
    assert [point.body for point in run.points] == ["lower", "lower", "upper"]
    for point in run.points:
        assert np.ptp(point["stress_zz"]) > 1e7
        assert_as_the_fields(point, run)
    assert run.points[0]["equivalent_plastic_strain"][-1] > 0.0
    lower = run.snapshot("final").lower
    cell = lower.x[1] - lower.x[0]
    assert abs(run.points[1].x - 20e-6) <= 0.5 * cell
    assert abs(run.points[1].depth - 25e-6) <= lower.z[0]
    with pytest.raises(KeyError, match=r"a point has no 'stres_xx'; did you mean stress_xx\?"):
        run.points[0]["stres_xx"]


@pytest.mark.parametrize(
    "kind",
    [
        Kind("indentation", "rigid", "plastic", "open", "smooth"),
        Kind("sliding", "plastic", "elastic", "periodic", "wear"),
        Kind("fretting", "plastic", "rigid", "plane", "friction"),
        Kind("tugging", "elastic", "plastic", "open", "friction"),
    ],
    ids=" ".join,
)
def test_in_every_scenario(kind: Kind, tmp_path: Path) -> None:
    body = "upper" if kind.lower == "rigid" else "lower"
    run = case(kind, {"depth": "5 um", "body": body}).run(tmp_path / "run")
    (point,) = run.points
    assert np.isfinite(point["stress_xx"]).any()
    grown = np.isnan(point["stress_xx"])
    if not grown.any():
        assert_as_the_fields(point, run)
    assert np.isnan(point["temperature"]).all()  # no heat


def test_without_stored_steps_in_memory_and_in_the_file_alone(run: Run, tmp_path: Path) -> None:
    few = case(snapshots="none", fields="surface").run(tmp_path / "few")
    assert few.steps == []
    others = [few, case(snapshots="none").run(in_memory=True), brinell.open(tmp_path / "few" / "result.vtkhdf")]
    for other in others:
        assert len(other.points) == len(run.points)
        for point, same in zip(other.points, run.points, strict=True):
            assert (point.x, point.y, point.depth, point.body) == (same.x, same.y, same.depth, same.body)
            for name, values in same.columns.items():
                np.testing.assert_array_equal(point[name], values)
    header = (tmp_path / "few" / "points.csv").read_text(encoding="utf-8").splitlines()[0]
    assert header.startswith("step,point,body,x,y,depth,stress_xx,")


def test_a_stopped_run_keeps_them_and_goes_on(run: Run, tmp_path: Path) -> None:
    def stop(step: int, *_: object) -> None:
        if step == 6:
            raise KeyboardInterrupt

    stopped = case(checkpoint_interval=0)
    with pytest.raises(KeyboardInterrupt):
        stopped.run(tmp_path / "run", progress=stop)
    part = brinell.open(tmp_path / "run", allow_unfinished=True)
    assert [len(point.step) for point in part.points] == [7, 7, 7]
    whole = stopped.run(tmp_path / "run", resume=True)
    for point, same in zip(whole.points, run.points, strict=True):
        for name, values in same.columns.items():
            np.testing.assert_array_equal(point[name], values)


def test_a_new_run_removes_them(tmp_path: Path) -> None:
    case(snapshots="none").run(tmp_path / "run")
    run = KIND.case(output={"snapshots": "none"}).run(tmp_path / "run", replace=True)
    assert not (tmp_path / "run" / "points.csv").exists()
    assert run.points == []


def test_a_point_beyond_the_grid_is_unknown() -> None:
    run = case(points=[{"depth": "50 mm"}, {"depth": 0}], snapshots="none").run(in_memory=True)
    beyond, surface = run.points
    assert np.isnan(beyond["von_mises_stress"]).all()
    assert np.isnan(beyond.x)
    assert np.isfinite(surface["stress_zz"]).all()


def test_points_in_python() -> None:
    output = brinell.Output(points=[brinell.Point(depth="10 um"), brinell.Point(depth=2e-5, x="1 um", body="upper")])
    text = KIND.case(output=output).to_toml()
    assert text.count("[[output.points]]") == 2
    assert "depth = 1e-05" in text


@pytest.mark.parametrize(
    ("kind", "points", "message"),
    [
        (KIND, [{"x": "1 um"}], "output.points.* is missing; allowed: a length >= 0, the depth of the point"),
        (KIND, [{"depth": "-1 um"}], "output.points.*depth.* is out of range; allowed: length >= 0"),
        (KIND, [{"depth": "1 um", "z": 0}], "unknown key output.points.*z"),
        (
            Kind("rolling", "rigid", "plastic", "open", "smooth"),
            {"depth": "1 um"},
            "a point of the lower body, which is",
        ),
    ],
)
def test_wrong_points(kind: Kind, points: Any, message: str) -> None:
    with pytest.raises(brinell.InputError, match=message):
        case(kind, points)


def test_their_figure(run: Run, tmp_path: Path) -> None:
    figure = brinell.plot.point_histories(run)
    assert figure is not None
    drawn = [ax for ax in figure.axes if ax.axison]
    assert len(drawn) == 3 + len(POINTS)  # von Mises stress, plastic strain, temperature, and the stress of each
    written = texts(figure)
    assert overlaps(figure) == []
    assert any(text.startswith("upper, $x$ = −") for text in written)
    first = run.points[0]
    values = np.asarray(drawn[3].lines[1].get_ydata())  # after the line of zero
    scale = brinell.plot.scales.Scales(run).stress(first["stress_xx"].max()).size
    largest = max(np.abs(first[f"stress_{component}"]).max() for component in COMPONENTS)
    np.testing.assert_allclose(values * scale, first["stress_xx"], atol=1e-9 * largest)
    assert np.asarray(drawn[0].lines[0].get_xdata()).size == first.step.size  # one pass: over the place of the contact
    assert "place of the contact" in drawn[-1].get_xlabel()
    assert "point-histories" in [named.name for named in brinell.plot.standard_figures(run)]
    command(["points", str(run.path), "-o", str(tmp_path)], standalone_mode=False)
    assert [file.name for file in tmp_path.iterdir()] == ["point-histories.png"]


def test_a_run_without_points_has_no_such_figure(tmp_path: Path) -> None:
    run = KIND.case(output={"snapshots": "none"}).run(tmp_path / "run")
    assert brinell.plot.point_histories(run) is None
    with pytest.raises(SystemExit) as stopped:
        command(["points", str(run.path)])
    assert stopped.value.code == 2
