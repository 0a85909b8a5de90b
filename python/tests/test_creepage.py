# SPDX-License-Identifier: BSD-3-Clause
"""Rolling with creepage in Python: the arguments, forces from rest to steady rolling, maps of the contact, figures."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from pathlib import Path

import numpy as np
import pytest
from matplotlib.quiver import Quiver

import brinell
from brinell._toml import tomllib
from brinell.plot import rolling
from brinell.plot.cli import plot
from brinell.plot.creepage import creep_curve
from brinell.results import Run, RunError, open_run
from brinell.scenarios.rolling import TRAITS
from figure_parts import curve, legend_of, texts

CASE = Path(__file__).parents[2] / "cases" / "rolling-creepage" / "case.toml"
STEEL = brinell.Material("210 GPa", 0.3)
FLAT, BALL = brinell.Body(brinell.Flat(), STEEL), brinell.Body(brinell.Sphere("10 mm"), STEEL)
FRICTION, LOAD = 0.3, 100.0


def crept(**arguments: object) -> brinell.Rolling:
    given: dict = {"load": LOAD, "distance": "1.6 mm", "creepage": [0.001, 0.0005], "load_steps": 2}
    parts: dict = {"interface": brinell.Interface(friction=FRICTION), "grid": {"resolution": 6}}
    return brinell.Rolling(FLAT, BALL, **(given | parts | arguments))


@pytest.fixture(scope="module")
def run() -> Run:
    return crept(title="creeps").run(in_memory=True)


@pytest.fixture(scope="module")
def run_spun() -> Run:
    return crept(creepage=None, spin="2 rad/m", passes=2, title="spins").run(in_memory=True)


def test_it_is_that_of_the_case_file() -> None:
    steel = brinell.Material("210 GPa", 0.3, brinell.Linear("1.6 GPa", "20 GPa"))
    case = brinell.Rolling(
        brinell.Body(brinell.Flat(), steel),
        brinell.Body(brinell.Sphere("10 mm"), steel),
        "4 mm",
        hertz_pressure="3.6 GPa",
        creepage=(0.003, 0.001),
        spin="2 rad/m",
        interface={"friction": 0.3},
        grid={"resolution": 8},
        title="A ball that brakes and steers",
    )
    assert tomllib.loads(case.to_toml()) == tomllib.loads(brinell.Case.from_file(CASE).to_toml())


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        ({"creepage": [0.001, 0.0, 0.0]}, "has more than two numbers"),
        ({"creepage": [0.5, 0.0]}, "creepage"),
        ({"creepage": [float("nan"), 0.0]}, "creepage"),
        ({"interface": None}, "interface.friction = 0: without friction the surfaces cannot stick"),
        ({"slide_to_roll": 0.1}, "slide_to_roll = 0.1"),
        ({"spin": "1e6 rad/m"}, "half-length of the contact"),
        ({"spin": "1 mm"}, "spin"),
        ({"shift": "70 um", "grid": {"spacing": ["50 um", "50 um", "25 um"]}}, "whole multiples of the cell"),
    ],
)
def test_errors_name_the_argument(arguments: dict, message: str) -> None:
    with pytest.raises(brinell.InputError, match=message):
        crept(**arguments).run(in_memory=True)


def test_forces_grow_to_those_of_steady_rolling(run: Run) -> None:
    rows, last = run.history, run.passes[-1]
    moving = np.flatnonzero(np.diff(rows["x"])) + 1
    force = rows["F_x"][moving]
    assert rows["F_x"][moving[0] - 1] == 0.0
    assert np.all(np.diff(force) > -1e-3 * force[-1])
    assert last.creep_steady
    assert last.creep_unsteadiness < 0.01
    quarter = moving[rows["x"][moving] > 0.25 * 1.6e-3]
    for name in ("F_x", "F_y", "M_z", "stick_share"):
        assert getattr(last, name) == pytest.approx(rows[name][quarter].mean(), rel=1e-12)
    assert 0.0 < np.hypot(last.F_x, last.F_y) < FRICTION * LOAD
    assert 0.0 < last.stick_share < 1.0
    np.testing.assert_allclose(rows["F_friction"], np.hypot(rows["F_x"], rows["F_y"]), atol=1e-12)


def test_balls_that_hardly_creep_have_kalkers_forces() -> None:
    """C11 and C22 of a circle are 4.32 and 3.73 for nu = 0.3, between the rows of the table (Kalker 1967).

    With 8 cells per radius forces are right to 3 % (docs/verification/accuracy.md).
    """
    small = 2e-6
    last = crept(creepage=[small, small], grid={"resolution": 8}).run(in_memory=True).passes[-1]
    radius = (0.75 * LOAD * 0.01 / (0.5 * 210e9 / (1.0 - 0.09))) ** (1.0 / 3.0)
    linear = 210e9 / 2.6 * radius**2 * small
    assert last.F_x / linear == pytest.approx(4.32, rel=0.03)
    assert last.F_y / linear == pytest.approx(3.73, rel=0.03)


def test_fields_of_the_contact(run: Run) -> None:
    snapshot = run.snapshot("aligned")
    contact = snapshot.contact
    assert contact.shear_x is not None
    assert contact.slip_x is not None
    assert contact.slip_path is not None
    area = (contact.x[1] - contact.x[0]) * (contact.y[1] - contact.y[0])
    assert contact.shear_x.sum() * area == pytest.approx(snapshot.row["F_x"], rel=1e-6)
    assert contact.slip_path.max() == pytest.approx(snapshot.row["slip_path"], rel=1e-6)
    # What has slipped lies behind: the contact moves to larger x.
    behind = contact.slip_path[:, contact.x < 0.0].sum()
    assert behind > 10.0 * contact.slip_path[:, contact.x > 0.0].sum()


def test_creep_forces(run: Run, run_spun: Run) -> None:
    fig = rolling.creep_forces([run])
    assert fig is not None
    assert [ax.get_ylabel().split("  ")[0] for ax in fig.axes] == [
        "longitudinal force",
        "lateral force",
        "moment",
        "share that sticks",
    ]
    force = fig.axes[0].get_lines()
    assert max(np.max(line.get_ydata()) for line in force) == pytest.approx(
        np.max(run.history["F_x"]) / (FRICTION * LOAD), rel=1e-6
    )
    texts(fig)
    both = rolling.creep_forces([run, run_spun])
    assert both is not None
    assert len(legend_of(both.axes[0])) == 3  # one pass, and the first and the last of two
    texts(both)


def test_maps_and_profiles(run: Run, run_spun: Run) -> None:
    maps = rolling.creep_maps([run])
    assert maps is not None
    assert any("slip since these places touched" in ax.get_title(loc="left") for ax in maps.axes)
    assert rolling.creep_maps([run, run_spun]) is None
    assert rolling.creep_profiles([run, run_spun]) is not None


def test_the_moment_names_its_radius(run: Run) -> None:
    """That of a circle of the area of the contact."""
    ax = rolling.creep_forces([run]).axes[2]
    assert ax.get_ylabel() == "moment  $M_z/(fPa)$\ncontact area $\\pi a^2$"
    row = run.history
    most = np.argmax(np.abs(row["M_z"]))
    radius = np.sqrt(row["contact_area"][most] / np.pi)
    drawn = max(ax.get_lines(), key=lambda line: len(line.get_ydata())).get_ydata()
    assert np.abs(drawn).max() == pytest.approx(np.abs(row["M_z"][most]) / (FRICTION * LOAD * radius), rel=1e-3)


def test_heat_of_friction(run: Run, run_spun: Run) -> None:
    fig = rolling.creep_heat([run], cells=True)
    contact = run.snapshot("aligned").contact
    touching = contact.pressure > 0.0
    np.testing.assert_allclose(fig.axes[0].images[0].get_array()[touching], contact.friction_heat[touching])
    written = texts(fig)
    assert "$w^f$  [J/m²]" in written
    assert any("since these places touched" in text for text in written)
    assert rolling.creep_heat([run, run_spun]) is None


@pytest.mark.parametrize("radii", [("10 mm", "60 mm"), ("60 mm", "10 mm")])
def test_maps_of_a_narrow_contact(radii: tuple[str, str]) -> None:
    """Arrows as far from each other along both axes, though cells are not square; titles beside each other."""
    ellipsoid = brinell.Body(brinell.Ellipsoid(*radii), STEEL)
    friction = brinell.Interface(friction=FRICTION)
    grid = {"resolution": 6}
    run = brinell.Rolling(
        FLAT, ellipsoid, "0.4 mm", load=LOAD, creepage=0.001, load_steps=1, interface=friction, grid=grid
    ).run(in_memory=True)
    fig = rolling.creep_maps([run])
    assert fig is not None
    (arrows,) = fig.findobj(Quiver)
    apart = [np.diff(np.unique(np.round(place, 9))).min() for place in (arrows.X, arrows.Y)]
    assert max(apart) < 2.0 * min(apart)
    assert 0.5 * max(apart) < np.hypot(arrows.U, arrows.V).max() <= max(apart) * (1.0 + 1e-6)
    fig.draw_without_rendering()
    first, second = (ax._left_title.get_window_extent() for ax in fig.axes[:2])
    assert first.x1 < second.x0
    texts(rolling.creep_heat([run]))


# --- Creep curve ------------------------------------------------------------------------------------------------------


@pytest.fixture(scope="module")
def runs() -> list[Run]:
    """In no order: the curve sorts."""
    return [crept(creepage=[xi, 0.0], title=f"{xi:g}").run(in_memory=True) for xi in (4e-3, 2e-4, 1e-3)]


def test_creep_curve_has_the_forces_of_steady_rolling(runs: list[Run]) -> None:
    (ax,) = creep_curve(runs).axes
    line = curve(ax, "computed")
    np.testing.assert_allclose(line.get_xdata(), [0.02, 0.1, 0.4])
    forces = [runs[i].passes[-1].F_x / (FRICTION * LOAD) for i in (1, 2, 0)]
    np.testing.assert_allclose(line.get_ydata(), forces, rtol=1e-6)
    assert ax.get_xlabel() == r"longitudinal creepage  $\xi$  [%]"
    assert ax.get_ylabel() == "longitudinal force  $F_x/(fP)$"
    assert legend_of(ax) == ["computed", "linear theory (Kalker)", r"friction $\times$ load"]
    assert [line.get_ydata()[0] for line in ax.lines if line.get_linewidth() == 0.8][-1] == 1.0
    texts(ax.figure)


def test_the_linear_theory_is_that_of_kalker(runs: list[Run]) -> None:
    """C11 of a circle is 4.32 for nu = 0.3; drawn from the origin to friction times load."""
    (ax,) = creep_curve(runs).axes
    (linear,) = [line for line in ax.lines if line.get_linestyle() == "--"]
    x, force = linear.get_data()
    assert (x[0], force[0], force[1]) == pytest.approx((0.0, 0.0, 1.0), abs=1e-12)
    radius = (0.75 * LOAD * 0.01 / (0.5 * 210e9 / (1.0 - 0.09))) ** (1.0 / 3.0)
    slope = 210e9 / 2.6 * radius**2 / (FRICTION * LOAD)
    # Between the rows of the table it is a straight line, to 0.5 %.
    assert force[1] / (0.01 * x[1]) == pytest.approx(4.32 * slope, rel=5e-3)


def test_creep_curves_of_different_friction_and_spin(runs: list[Run], run_spun: Run) -> None:
    less = [crept(creepage=[xi, 0.0], interface=brinell.Interface(friction=0.2)) for xi in (1e-3, 4e-3)]
    (ax,) = creep_curve([*runs, *(case.run(in_memory=True) for case in less)]).axes
    assert legend_of(ax)[:2] == ["friction 0.3", "friction 0.2"]
    spun = [crept(creepage=[xi, 0.0], spin="20 rad/m").run(in_memory=True) for xi in (2e-4, 4e-3)]
    along, across = creep_curve([*runs, *spun]).axes
    assert legend_of(across)[:2] == ["spin 0", "spin 20 rad/m"]
    # Of the spin, towards the same side as in the linear theory.
    lateral = [line for line in across.lines if line.get_linestyle() == "--"][-1].get_ydata()
    assert np.all(lateral > 0.0)
    assert spun[0].passes[-1].F_y > 0.0
    assert along.get_title(loc="left") == "(a)  along the motion"


def test_creep_curve_over_lateral_creepage_and_spin(run_spun: Run) -> None:
    sideways = [crept(creepage=[0.0, eta]).run(in_memory=True) for eta in (-2e-3, 2e-3)]
    (ax,) = creep_curve(sideways).axes
    assert ax.get_xlabel() == r"lateral creepage  $\eta$  [%]"
    assert sorted(line.get_ydata()[0] for line in ax.lines if line.get_linewidth() == 0.8)[0] == -1.0
    other = crept(creepage=None, spin="20 rad/m").run(in_memory=True)
    (ax,) = creep_curve([run_spun, other]).axes
    assert ax.get_xlabel() == r"spin  $\varphi$  [rad/m]"


def test_bodies_of_different_materials_have_no_linear_theory() -> None:
    ball = brinell.Body(brinell.Sphere("10 mm"), brinell.Material("70 GPa", 0.3))
    arguments: dict = {"load": LOAD, "load_steps": 2, "grid": {"resolution": 5}}
    arguments["interface"] = brinell.Interface(friction=FRICTION)
    runs = [
        brinell.Rolling(FLAT, ball, "1.6 mm", creepage=[xi, 0.0], **arguments).run(in_memory=True)
        for xi in (1e-3, 8e-3)
    ]
    assert legend_of(creep_curve(runs).axes[0]) == ["computed", r"friction $\times$ load"]


@pytest.mark.filterwarnings("ignore::brinell.ResolutionWarning")
def test_open_points_are_not_yet_steady(runs: list[Run]) -> None:
    short = crept(creepage=[5e-4, 0.0], distance="0.1 mm").run(in_memory=True)
    assert not short.passes[-1].creep_steady
    ax = creep_curve([*runs, short]).axes[0]
    assert "not yet steady" in legend_of(ax)
    (hollow,) = [line for line in ax.lines if line.get_markerfacecolor() == "white" and len(line.get_xdata())]
    assert list(hollow.get_xdata()) == pytest.approx([0.05])


def test_creep_curve_of_a_sweep(runs: list[Run]) -> None:
    class Sweep:
        runs: Mapping[int, Run]

    sweep = Sweep()
    sweep.runs = dict(enumerate(runs))
    assert len(curve(creep_curve(sweep).axes[0], "computed").get_xdata()) == 3


def test_one_creepage_makes_no_curve(runs: list[Run], make_rolling: Callable[..., Path]) -> None:
    assert creep_curve(runs[0]) is None
    assert creep_curve([runs[0], runs[0]]) is None
    assert creep_curve([runs[0], open_run(make_rolling())]) is None  # rolls without creepage


def test_the_command_draws_the_creep_curve(tmp_path: Path) -> None:
    for xi in (1e-3, 4e-3):  # as a sweep writes it: the lateral creepage is left out
        crept(creepage=xi, grid={"resolution": 4}).run(tmp_path / f"{xi:g}")
    with pytest.raises(SystemExit) as end:
        plot(["rolling", str(tmp_path / "0.001"), str(tmp_path / "0.004"), "-o", str(tmp_path / "drawn")])
    assert not end.value.code
    assert (tmp_path / "drawn" / "creep-curve.png").stat().st_size > 0


def test_without_creepage_there_is_nothing_to_draw(
    make_rolling: Callable[..., Path], make_indentation: Callable[..., Path]
) -> None:
    old, other = open_run(make_rolling()), open_run(make_indentation())
    for draw in (rolling.creep_forces, rolling.creep_maps, rolling.creep_heat, rolling.creep_profiles, creep_curve):
        assert draw([old]) is None
        with pytest.raises(RunError):
            draw([other])


def test_key_numbers(run: Run) -> None:
    assert TRAITS.key_numbers is not None
    names = [number.name for number in TRAITS.key_numbers(run)]
    assert "Force along the motion, last pass" in names
    assert "Share that sticks, last pass" in names
