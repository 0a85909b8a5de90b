# SPDX-License-Identifier: BSD-3-Clause
"""Fretting in Python: the class, loops of elastic balls against Mindlin, maps of the contact, and figures."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import Any

import matplotlib.pyplot as plt
import numpy as np
import pytest
from matplotlib.colors import to_hex
from matplotlib.figure import Figure
from matplotlib.quiver import Quiver, QuiverKey

import brinell
from brinell import InputError
from brinell._toml import tomllib
from brinell.plot import slip, style, tangential
from brinell.report.volumes import pictures_of
from brinell.results import Run, RunError
from brinell.scenarios.fretting import TRAITS
from figure_parts import curve, legend_of, texts

CASE = Path(__file__).parents[2] / "cases" / "fretting-sphere" / "case.toml"
STEEL = brinell.Material("210 GPa", 0.3)
FLAT, BALL = brinell.Body(brinell.Flat(), STEEL), brinell.Body(brinell.Sphere("10 mm"), STEEL)
FRICTION, LOAD = 0.6, 50.0


def fretting(lower: brinell.Body = FLAT, upper: brinell.Body = BALL, **arguments: object) -> brinell.Fretting:
    given: dict = {"load": LOAD, "displacement": "0.6 um", "steps_per_cycle": 16, "press_steps": 2}
    parts: dict = {"interface": brinell.Interface(friction=FRICTION), "grid": {"resolution": 6}}
    return brinell.Fretting(lower, upper, **(given | parts | arguments))


@pytest.fixture(scope="module")
def run() -> Run:
    return fretting(cycles=2, title="by displacement").run(in_memory=True)


@pytest.fixture(scope="module")
def run_across() -> Run:
    """By force, along y."""
    return fretting(displacement=None, force="15 N", direction="90 deg", title="by force").run(in_memory=True)


@pytest.fixture(scope="module")
def run_soft() -> Run:
    """The flat yields."""
    soft = brinell.Body(brinell.Flat(), brinell.Material("210 GPa", 0.3, brinell.Linear("900 MPa", "2 GPa")))
    ball = brinell.Body(brinell.Sphere("1 mm"), STEEL)
    motion: dict = {"displacement": "0.5 um", "steps_per_cycle": 8, "press_steps": 4}
    friction = brinell.Interface(friction=0.6)
    return brinell.Fretting(soft, ball, load="10 N", interface=friction, grid={"resolution": 5}, **motion).run()


def test_it_is_that_of_the_case_file() -> None:
    case = brinell.Fretting(
        FLAT,
        BALL,
        load="50 N",
        displacement="0.6 um",
        cycles=2,
        interface={"friction": 0.6},
        grid={"resolution": 12},
        title="A steel ball frets on steel",
    )
    assert tomllib.loads(case.to_toml()) == tomllib.loads(brinell.Case.from_file(CASE).to_toml())


def test_the_direction_is_an_angle() -> None:
    tables = [tomllib.loads(fretting(direction=one).to_toml()) for one in (30, "30 deg", f"{np.pi / 6} rad")]
    assert [table["fretting"]["direction"] for table in tables] == pytest.approx([30.0] * 3)


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        ({"load": None}, "none of load, approach and pressure is given"),
        ({"approach": "1 um"}, "load = 50.0 cannot stand together with approach"),
        ({"displacement": None}, "none of displacement and force is given"),
        ({"force": "1 N"}, "cannot stand together with force"),
        ({"steps_per_cycle": 10}, "multiples of 4"),
        ({"displacement": None, "force": "31 N"}, "force = 31"),  # friction holds 30 N
    ],
)
def test_errors_name_the_argument(arguments: dict, message: str) -> None:
    with pytest.raises(brinell.InputError, match=message) as error:
        fretting(**arguments).run(in_memory=True)
    assert "fretting." not in str(error.value)


def test_the_loop_is_that_of_mindlin(run: Run) -> None:
    """Bodies of one material: Mindlin (1949), Mindlin and Deresiewicz (1953).

    Six cells leave the force an error of half of 6^-1.5, as in the verification (Fretting).
    """
    history, limit = run.history, FRICTION * LOAD
    radius = (0.75 * LOAD * 10e-3 / (210e9 / (2.0 * (1.0 - 0.3**2)))) ** (1.0 / 3.0)
    slides = 3.0 * limit / (16.0 * radius) * 2.0 * (2.0 - 0.3) / (210e9 / 2.6)
    assert run.summary["geometry"]["estimated_sliding_displacement_m"] == pytest.approx(slides, rel=1e-6)
    assert np.all(np.abs(history["force"]) < limit)
    assert np.all(history["F_friction"] <= limit * (1.0 + 1e-9))

    def virgin(share: np.ndarray) -> np.ndarray:
        return 1.0 - (1.0 - share) ** 1.5

    x, top = history["displacement"] / slides, 0.6e-6 / slides
    back, forth = virgin(top) - 2.0 * virgin((top - x) / 2.0), -virgin(top) + 2.0 * virgin((top + x) / 2.0)
    phase = np.arange(x.size) - 1  # since the end of pressing
    exact = np.where(phase <= 4, virgin(np.maximum(x, 0.0)), np.where((phase - 4) % 16 <= 8, back, forth))
    np.testing.assert_allclose(history["force"] / limit, np.where(phase > 0, exact, 0.0), atol=0.5 * 6.0**-1.5)


def test_cycles_are_those_of_the_history(run: Run) -> None:
    history, cycles = run.history, run.cycles
    assert [one.cycle for one in cycles] == [1, 2]
    for one in cycles:
        rows = np.flatnonzero(history["cycle"] == one.cycle)
        x, force = (history[name][rows[0] - 1 : rows[-1] + 1] for name in ("displacement", "force"))
        # The curve of the loop bulges beyond the straight lines between the 16 steps, by 2 to 3 % of its area.
        polygon = np.sum(0.5 * (force[1:] + force[:-1]) * np.diff(x))
        assert polygon < one.work < 1.04 * polygon
        assert one.max_force == np.abs(force).max()
        assert one.max_displacement == pytest.approx(0.6e-6)
        assert one.stick_share == history["stick_share"][rows].min()
        assert 0.0 < one.stick_share < 1.0
        assert one.dissipation_plastic == one.max_equivalent_plastic_strain == 0.0
        assert 0.0 < one.slip_amplitude < 0.6e-6
    # The loop of the second is closed: its work is heat.
    assert cycles[1].work == pytest.approx(cycles[1].dissipation_friction, rel=1e-5)
    assert sum(one.dissipation_friction for one in cycles) == pytest.approx(history["dissipation_friction"][-1])


def test_only_a_fretting_has_cycles(run: Run) -> None:
    press = brinell.Indentation(FLAT, BALL, load=["1 N"], steps=1, grid={"resolution": 3}).run(in_memory=True)
    with pytest.raises(RunError, match="is of scenario 'indentation'; only results of 'fretting' have cycles"):
        _ = press.cycles
    contact = press.snapshot("final").contact
    assert contact.shear_x is contact.slip_path is contact.friction_heat is None
    assert "shear_x" not in press.field_names("lower")


def test_aligned_is_the_first_turn(run: Run) -> None:
    snapshot = run.snapshot("aligned")
    assert (snapshot.step, snapshot.row["cycle"]) == (5, 1)
    assert snapshot.row["displacement"] == pytest.approx(0.6e-6)


def test_maps_of_the_contact_belong_to_the_history(run: Run) -> None:
    snapshot = run.snapshot("aligned")
    contact, row = snapshot.contact, snapshot.row
    assert contact.shear_x is not None
    area = (contact.x[1] - contact.x[0]) * (contact.y[1] - contact.y[0])
    assert contact.shear_x.sum() * area == pytest.approx(row["F_x"], rel=1e-9)
    assert contact.friction_heat.sum() * area == pytest.approx(row["dissipation_friction"], rel=1e-9)
    assert contact.slip_path.max() == pytest.approx(row["slip_path"])
    sticking = tangential.sticks(contact, FRICTION * contact.pressure)
    assert sticking.sum() / (contact.pressure > 0.0).sum() == pytest.approx(row["stick_share"])
    assert not contact.slip_x[sticking].any()
    assert np.all(contact.slip_x[(contact.pressure > 0.0) & ~sticking] > 0.0)


def test_fields_of_the_contact_by_name(run: Run) -> None:
    assert {"shear_x", "shear_y", "slip_x", "slip_y", "slip_path", "friction_heat"} <= set(run.field_names("lower"))
    heat = run.field("lower", "friction_heat")
    totals = heat.values.sum(axis=(1, 2))
    assert np.all(np.diff(totals) >= 0.0)
    assert totals[-1] > 0.0


def test_by_force_along_y(run_across: Run) -> None:
    turn = run_across.snapshot("aligned")
    assert turn.row["force"] == pytest.approx(15.0, rel=1e-6)
    assert turn.row["F_y"] == pytest.approx(15.0, rel=1e-6)
    assert abs(turn.row["F_x"]) < 1e-6
    # Half of what friction holds: the radius of what sticks is (1/2)^(1/3) of the contact's. Half a cell of six.
    assert np.sqrt(turn.row["stick_share"]) == pytest.approx(0.5 ** (1.0 / 3.0), abs=0.5 / 6.0)


def test_loops(run: Run) -> None:
    fig = brinell.plot.force_loops([run])
    ax = fig.axes[0]
    rows = np.flatnonzero(run.history["cycle"] == 2)
    line = curve(ax, "2")
    np.testing.assert_allclose(line.get_ydata()[1:], run.history["force"][rows])
    np.testing.assert_allclose(line.get_xdata()[1:], 1e9 * run.history["displacement"][rows])
    assert line.get_ydata()[0] == curve(ax, "1").get_ydata()[-1]
    limits = sorted(line.get_ydata()[0] for line in ax.lines if line.get_linestyle() == "--")
    assert limits == pytest.approx([-FRICTION * LOAD, FRICTION * LOAD])
    assert legend_of(ax) == ["1", "2", r"friction $\times$ load"]
    assert any(t.endswith("[nm]") for t in texts(fig))


def test_loops_of_several_runs(run: Run, run_across: Run) -> None:
    assert legend_of(brinell.plot.force_loops([run, run_across]).axes[0])[:2] == ["by displacement", "by force"]
    assert brinell.plot.contact_maps([run, run_across]) is None
    texts(brinell.plot.contact_profiles([run, run_across]))
    texts(brinell.plot.cycle_by_cycle([run, run_across]))
    texts(brinell.plot.fretting_course([run, run_across]))


def test_limits_have_the_colours_of_their_loops(run: Run, run_across: Run) -> None:
    """Grey where runs share them."""
    rough = fretting(interface=brinell.Interface(friction=0.4), title="less friction").run(in_memory=True)
    ax = brinell.plot.force_loops([run, rough, run_across]).axes[0]
    limits = {
        round(float(line.get_ydata()[0]), 6): to_hex(line.get_color())
        for line in ax.lines
        if line.get_linewidth() == 0.9
    }
    assert limits.keys() == {-30.0, -20.0, 20.0, 30.0}
    assert limits[20.0] == limits[-20.0] == to_hex(curve(ax, "less friction").get_color())
    assert limits[30.0] == limits[-30.0] == style.REFERENCE


def test_profiles(run: Run, run_across: Run) -> None:
    for one, along in ((run, "x"), (run_across, "y")):
        contact = one.snapshot("aligned").contact
        fig = brinell.plot.contact_profiles([one])
        shear = curve(fig.axes[0], "shear")
        bound = curve(fig.axes[0], r"friction $\times$ pressure")
        assert np.all(np.asarray(shear.get_ydata()) <= np.asarray(bound.get_ydata()) * (1.0 + 1e-9))
        middle = np.argmin(np.abs(contact.y))
        field = contact.shear_x if along == "x" else contact.shear_y.T
        near = np.abs(shear.get_xdata()) < 1e-9
        assert np.asarray(shear.get_ydata())[near][0] == pytest.approx(1e-6 * field[middle, middle], rel=0.05)
        texts(fig)


@pytest.mark.parametrize("cells", [False, True])
def test_maps(run: Run, cells: bool) -> None:
    fig = brinell.plot.contact_maps([run], cells=cells)
    share = run.snapshot("aligned").row["stick_share"]
    written = texts(fig)
    assert {f"sticks\n{100 * share:.0f} %", f"slips\n{100 * (1 - share):.0f} %"} <= set(written)
    assert any("cycle 1" in text for text in written)


def test_a_key_tells_how_long_the_arrows_of_the_shear_are(run: Run) -> None:
    fig = brinell.plot.contact_maps([run])
    (arrows,), (key,) = fig.findobj(Quiver), fig.findobj(QuiverKey)
    contact = run.snapshot("aligned").contact
    value, unit = key.text.get_text().split()
    assert unit == "MPa"
    largest_drawn = np.hypot(arrows.U, arrows.V).max()
    middle = [np.argmin(np.abs(axis)) for axis in (contact.y, contact.x)]
    at_middle = np.hypot(arrows.U, arrows.V)[np.argmin(np.hypot(arrows.X, arrows.Y))]
    assert key.U / at_middle == pytest.approx(1e6 * float(value) / contact.shear_x[tuple(middle)], rel=0.02)
    assert 0.5 * largest_drawn < key.U


@pytest.mark.parametrize("size", [0.02, 1.0, 4.18e8, 9.99e8, 1e9])
def test_the_key_is_a_round_number(size: float) -> None:
    told = slip._round_below(size)
    assert 0.5 * size < told <= size * (1.0 + 1e-12)
    assert float(f"{told:.0e}") == pytest.approx(told)


def test_the_coordinate_along_the_motion_is_no_creepage(run: Run) -> None:
    assert brinell.plot.contact_profiles([run]).axes[1].get_xlabel() == r"along the motion  $x_\parallel$  [µm]"


def test_heat_of_friction_is_that_of_the_cells(run: Run) -> None:
    fig = brinell.plot.contact_heat([run], cells=True)
    last_turn = run.snapshot(29)  # two steps press, of 16 per cycle the twelfth is the second turn
    heat, touching = last_turn.contact.friction_heat, last_turn.contact.pressure > 0.0
    shown = fig.axes[0].images[0].get_array()
    np.testing.assert_array_equal(shown.mask, ~touching)
    np.testing.assert_allclose(shown[touching], heat[touching])
    written = texts(fig)
    assert "$w^f$  [J/m²]" in written
    assert any("since the start" in text and "step 29,  cycle 2" in text for text in written)


def test_edges_in_the_heat_of_friction_are_named(run: Run, run_across: Run) -> None:
    (legend,) = brinell.plot.contact_heat([run]).legends
    assert [text.get_text() for text in legend.get_texts()] == ["edge of the contact", "edge of the sticking area"]
    assert brinell.plot.contact_heat([run, run_across]) is None
    # By force: its turns are those of the force.
    assert any("step 13,  cycle 1" in text for text in texts(brinell.plot.contact_heat([run_across])))


def test_heat_of_friction_in_plane_strain_is_a_line() -> None:
    roller = brinell.Body(brinell.Cylinder("10 mm"), STEEL)
    flat = brinell.Fretting(
        FLAT,
        roller,
        load="0.1 MN",
        displacement="0.5 um",
        steps_per_cycle=8,
        press_steps=2,
        interface=brinell.Interface(friction=FRICTION),
        grid={"resolution": 8, "boundary": ["open", "periodic"]},
    ).run(in_memory=True)
    fig = brinell.plot.contact_heat([flat])
    assert set(legend_of(fig.axes[0])) == {"sticks", "edge of the contact"}
    heat = flat.snapshot(7).contact.friction_heat
    unit = {"kJ/m²": 1e3, "J/m²": 1.0, "mJ/m²": 1e-3}[fig.axes[0].get_ylabel().partition("[")[2].rstrip("]")]
    line = max(fig.axes[0].lines, key=lambda one: len(one.get_xdata()))
    assert np.max(line.get_ydata()) == pytest.approx(heat.max() / unit)
    texts(fig)


def test_states_in_which_all_sticks_or_all_slips(run: Run) -> None:
    """The end of pressing, where nothing has moved, and a turn beyond what friction holds."""
    pressed = run.snapshot(1)
    assert not pressed.row["slip_path"]
    if tangential.has_slip(pressed):
        texts(brinell.plot.stick_slip_maps(run, pressed))
    far = fretting(displacement="2 um").run(in_memory=True)
    turn = far.snapshot("aligned")
    assert turn.row["stick_share"] == 0.0
    # Less by the angle by which displacements across the motion turn the slip: docs/theory/elastoplastic.md has 2e-3.
    assert turn.row["force"] == pytest.approx(FRICTION * LOAD, rel=2e-3)
    texts(brinell.plot.contact_maps([far]))
    texts(brinell.plot.contact_profiles([far]))


def test_a_surface_that_yields_slips_below_friction_times_pressure(run_soft: Run) -> None:
    """As much sticks in the figure as the history tells."""
    turn = run_soft.snapshot("aligned")
    row = turn.row
    assert row["share_at_shear_limit"] > 0.1
    below = (
        tangential.sticks(turn.contact, FRICTION * turn.contact.pressure).sum() / (turn.contact.pressure > 0.0).sum()
    )
    assert below == pytest.approx(row["stick_share"] + row["share_at_shear_limit"])
    assert f"sticks\n{100 * row['stick_share']:.0f} %" in texts(brinell.plot.contact_maps([run_soft]))


def test_a_state_without_contact_maps_is_named() -> None:
    press = brinell.Indentation(FLAT, BALL, load=["1 N"], steps=1, grid={"resolution": 3}).run(in_memory=True)
    with pytest.raises(RunError, match="no shear and slip in the state at step 0"):
        brinell.plot.stick_slip_maps(press, press.snapshot("aligned"))


def test_one_cycle_has_nothing_to_compare(run_across: Run) -> None:
    assert brinell.plot.cycle_by_cycle([run_across]) is None


def test_course(run: Run) -> None:
    fig = brinell.plot.fretting_course([run])
    np.testing.assert_allclose(fig.axes[0].lines[0].get_ydata(), 1e9 * run.history["displacement"])
    texts(fig)


def test_the_end_is_headed_by_what_it_is(run_soft: Run) -> None:
    """Fretting does not unload."""
    groups = {one.name: one.group for one in brinell.plot.standard_figures(run_soft)}
    assert groups["residual-section"] == groups["residual-surfaces"] == "end"
    assert "residual" not in groups.values()
    final = run_soft.snapshot("final", tensors=True)
    assert final.in_contact
    pictures = pictures_of(run_soft.snapshot("aligned"), final)
    assert {one["state"] for one in pictures.volumes} == {"under load", "at the end, under load"}


def test_all_figures_of_a_run(run: Run) -> None:
    named = {one.name: one.figure for one in brinell.plot.standard_figures(run)}
    assert set(TRAITS.drawings().figures) <= named.keys()
    assert all(isinstance(fig, Figure) for fig in named.values())


@pytest.mark.parametrize("draw", [one.draw for one in TRAITS.drawings().figures.values()])
def test_other_scenarios_are_refused(make_rolling: Callable[..., Path], draw: Callable[..., Figure]) -> None:
    with pytest.raises(RunError, match="is of scenario 'rolling', this figure needs 'fretting'"):
        draw([brinell.open(make_rolling())])


def warm(body: brinell.Body) -> brinell.Body:
    return replace(body, material=replace(body.material, thermal=brinell.Thermal.carbon_steel()))


def test_slip_heats_both_bodies() -> None:
    run = fretting(
        lower=warm(FLAT), upper=warm(BALL), displacement="4 um", frequency="1 kHz", cycles=2, thermal={"partition": 0.3}
    ).run(in_memory=True)
    history = run.history
    assert history["max_temperature_lower"].max() > 23.0  # from 20 degC
    heat = history["dissipation_friction"][-1]
    assert history["heat_lower"][-1] == pytest.approx(0.3 * heat)
    assert history["heat_upper"][-1] == pytest.approx(0.7 * heat)
    figure = brinell.plot.surface_temperatures(run)
    assert figure is not None
    axes = figure.axes[0]
    assert axes.get_xlabel() == "cycles done"
    line = axes.lines[0]
    assert line.get_xdata()[[0, 1, -1]] == pytest.approx([-1 / 16, 0.0, 2.0])
    assert line.get_ydata() == pytest.approx(history["max_temperature_lower"])
    plt.close("all")


def test_heat_of_slip_needs_a_frequency() -> None:
    with pytest.raises(InputError, match="frequency is missing: .* allowed: a frequency > 0"):
        fretting(lower=warm(FLAT), upper=warm(BALL)).run(in_memory=True)


def test_rough_flats_are_pressed_by_a_mean_pressure() -> None:
    """The same run as by the load of the period."""
    rough = brinell.RandomSurface(hurst=0.8, rms_slope=0.03, rolloff="10 um", cutoff="5 um", size=("20 um", "20 um"))
    steel = brinell.Material("210 GPa", 0.3)
    bodies = brinell.Body(brinell.Flat(), steel, rough), brinell.Body(brinell.Flat(), brinell.RIGID)
    rest: dict[str, Any] = {
        "displacement": "1 nm",
        "cycles": 1,
        "steps_per_cycle": 4,
        "press_steps": 2,
        "interface": {"friction": 0.3},
        "grid": {"boundary": "periodic", "size": ["20 um", "20 um"], "cells": [16, 16]},
    }
    by_pressure = brinell.Fretting(*bodies, pressure="50 MPa", **rest).run(in_memory=True)
    by_load = brinell.Fretting(*bodies, load=50e6 * (20e-6) ** 2, **rest).run(in_memory=True)
    np.testing.assert_allclose(by_pressure.history["F_n"], by_load.history["F_n"], rtol=1e-12)
    np.testing.assert_allclose(by_pressure.history["force"], by_load.history["force"], rtol=1e-12, atol=1e-12)
    with pytest.raises(
        brinell.InputError, match=r"pressure = .* is the mean over a period; allowed with grid.boundary"
    ):
        brinell.Fretting(FLAT, BALL, pressure="50 MPa", displacement="1 nm", interface={"friction": 0.3})
    with pytest.raises(brinell.InputError, match="cannot stand together with"):
        brinell.Fretting(*bodies, pressure="50 MPa", load=1.0, **rest)
