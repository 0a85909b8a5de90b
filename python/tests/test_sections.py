# SPDX-License-Identifier: BSD-3-Clause
"""Cuts along any plane, profiles over the depth, gap maps, energy balances, animations."""

import re
from collections.abc import Callable
from pathlib import Path
from types import SimpleNamespace
from typing import cast

import h5py
import numpy as np
import pytest
from matplotlib.animation import FFMpegWriter
from matplotlib.figure import Figure

import brinell
from brinell import Case
from brinell.errors import InputError
from brinell.plot import (
    animate,
    energy_balance,
    gap_map,
    in_si,
    load_depth,
    residual_surfaces,
    save_animation,
    section,
    stress_over_depth,
)
from brinell.plot.cuts import Cut
from brinell.plot.energy import balance_error
from brinell.plot.inclusions import draw_inclusions
from brinell.plot.planes import Plane, on_plane, plane_of
from brinell.plot.quantities import QUANTITIES, quantity_of
from brinell.results import History, RunError, open_run
from figure_parts import curve, texts

CASES = Path(__file__).parents[2] / "cases"
MakeRun = Callable[..., Path]
A_C, S_Y, ALPHA_C, P_C, U_C = 1.052209e-2, 0.9115e9, 2.214290e-4, 3.460928e5, 30.65398


# --- Planes -----------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("written", "axis", "value"),
    [
        ("y=0", "y", 0.0),
        ("x = -0.1 mm", "x", -1e-4),
        (" z=2.5e1um ", "z", 2.5e-5),
        ("z = 3 µm", "z", 3e-6),
        ("y = 0.002", "y", 0.002),
        (("x", 0.5), "x", 0.5),
        (Plane("z", 1.0), "z", 1.0),
    ],
)
def test_planes_that_can_be_written(written: str, axis: str, value: float) -> None:
    plane = plane_of(written)
    assert plane.axis == axis
    assert plane.value == pytest.approx(value, rel=1e-15)


@pytest.mark.parametrize("written", ["y", "w = 1", "y = 1 inch", "x = 1.2.3", "z = -1 um", ("r", 1.0), ("x", np.inf)])
def test_what_is_no_plane(written: str) -> None:
    with pytest.raises(ValueError, match=r"plane|could not convert"):
        plane_of(written)


@pytest.mark.parametrize(("axis", "name"), [("x", 2), ("y", 1), ("z", 0)])
def test_a_linear_field_is_exact_on_any_plane(axis: str, name: int) -> None:
    z, y, x = np.meshgrid(np.arange(3.0), np.arange(4.0), np.arange(5.0), indexing="ij")
    field = 1.0 + 2.0 * x - 3.0 * y + 5.0 * z
    coordinates = np.arange(field.shape[name], dtype=float)
    value = on_plane(coordinates, field, plane_of((axis, 1.25)))
    lower, upper = field.take(1, name), field.take(2, name)
    np.testing.assert_allclose(value, lower + 0.25 * (upper - lower), rtol=1e-14)


def test_a_plane_may_lie_in_the_outer_half_of_a_cell_but_not_beyond() -> None:
    field, z = np.arange(3.0)[:, None, None], np.array([1.0, 3.0, 5.0])
    assert on_plane(z, field, Plane("z", 0.0)) == 0.0
    assert on_plane(z, field, Plane("z", 6.0)) == 2.0
    assert on_plane(z, field, Plane("z", 6.1)) is None


# --- Sections ---------------------------------------------------------------------------------------------------------


def test_a_state_may_be_named(make_run: MakeRun) -> None:
    run = open_run(make_run())
    for state in ("aligned", "final", run.steps[0]):
        section(run, state)
    residual_surfaces(run, "final")
    with pytest.raises(RunError, match="1000000"):
        section(run, 10**6)


def test_section_across_the_motion(make_run: MakeRun) -> None:
    run = open_run(make_run(9.0))
    snapshot = run.snapshot(6, tensors=True)
    offset = 0.4 * A_C
    fig = section(run, snapshot, field="stress_yy", plane=("x", offset))
    ax = fig.axes[0]
    for image, body in zip(ax.images, (snapshot.lower, snapshot.upper), strict=True):
        place = body.contact_x + offset
        i = int(np.searchsorted(body.x, place)) - 1
        share = (place - body.x[i]) / (body.x[i + 1] - body.x[i])
        expected = (1.0 - share) * body.stress["yy"][:, :, i] + share * body.stress["yy"][:, :, i + 1]
        np.testing.assert_allclose(image.get_array(), expected / S_Y)  # type: ignore[arg-type]
        left, right, *_ = image.get_extent()
        assert left * A_C == pytest.approx(1.5 * body.y[0] - 0.5 * body.y[1])
        assert right == pytest.approx(-left)
    norm = ax.images[0].norm
    assert norm.vmin == -norm.vmax  # type: ignore[operator]
    written = texts(fig)
    assert any("x'" in t and "= 4.21 mm" in t for t in written)
    assert any(t.startswith("across") for t in written)


def test_section_at_a_depth_has_a_picture_per_body(make_run: MakeRun) -> None:
    run = open_run(make_run(9.0))
    snapshot = run.snapshot("aligned")
    depth = float(snapshot.lower.z[2])
    fig = section(run, snapshot, field=["von_mises_stress", "equivalent_plastic_strain"], plane=("z", depth))
    pictures = [ax for ax in fig.axes if ax.images]
    assert len(pictures) == 4
    assert snapshot.upper.von_mises_stress is not None
    np.testing.assert_allclose(pictures[2].images[0].get_array(), snapshot.upper.von_mises_stress[2] / S_Y)  # type: ignore[arg-type]
    written = texts(fig)
    assert any(t.startswith("Depth $z$") for t in written)
    assert written.count("lower body") == written.count("upper body") == 2


def test_stress_that_is_left_is_called_residual(make_rolling: MakeRun) -> None:
    run = open_run(make_rolling())
    written = texts(section(run, run.snapshot("final", tensors=True), field="stress_xx"))
    assert "Residual stress $xx$" in written
    assert "upper body" not in written


def test_a_single_body_leaves_no_room_for_the_other(make_run: MakeRun) -> None:
    run = open_run(make_run(9.0))
    fig = section(run, run.snapshot("aligned"), bodies="upper")
    low, high = fig.axes[0].get_ylim()
    assert low == 0.0 < high
    assert "lower body" not in texts(fig)


def test_a_plane_beside_the_contact_has_no_line_of_contact(make_run: MakeRun) -> None:
    run = open_run(make_run(9.0))
    snapshot = run.snapshot("aligned")
    fig = section(run, snapshot, plane=("y", float(snapshot.lower.y[-1])))
    assert np.asarray(curve(fig.axes[0], "contact").get_xdata()).size == 0
    texts(fig)


def test_sections_that_cannot_be_drawn(make_run: MakeRun) -> None:
    folder = make_run()
    run = open_run(folder)
    with pytest.raises(RunError, match="the plane y = 5 m lies outside the grids"):
        section(run, run.snapshot("aligned"), plane="y = 5 m")
    with h5py.File(folder / "result.vtkhdf", "a") as file:
        for body in ("lower", "upper"):
            del file[f"steps/000012/{body}/stress"]
    with pytest.raises(RunError, match="stress_xx is not stored at step 12"):
        section(run, run.snapshot("aligned"), field="stress_xx")


def test_components_are_drawn_of_any_snapshot(make_run: MakeRun) -> None:
    run = open_run(make_run())
    whole = section(run, run.snapshot("aligned", tensors=True), field="stress_xx").axes[0].images[0].get_array()
    later = section(run, run.snapshot("aligned"), field="stress_xx").axes[0].images[0].get_array()
    np.testing.assert_array_equal(later, whole)


def test_figures_in_si(make_run: MakeRun) -> None:
    run = open_run(make_run(9.0))
    snapshot = run.snapshot("aligned")
    over = section(run, snapshot, field="von_mises_stress")
    with in_si():
        plain = section(run, snapshot, field="von_mises_stress")
        surfaces = residual_surfaces(run, run.snapshot("final"))
    assert "a_c" in over.axes[0].get_xlabel()
    assert re.search(r"\[(nm|µm|mm|m)\]", plain.axes[0].get_xlabel())
    assert re.search(r"\[[kMG]?Pa\]", plain.axes[-1].get_ylabel())
    assert r"\alpha_c" not in surfaces.axes[-1].get_ylabel()
    assert "a_c" in section(run, snapshot).axes[0].get_ylabel()  # only within
    ratio = over.axes[0].get_xlim()[1] / plain.axes[0].get_xlim()[1]
    power = {"nm": 1e-9, "µm": 1e-6, "mm": 1e-3, "m": 1.0}[plain.axes[0].get_xlabel().split("[")[1].rstrip("]")]
    assert ratio == pytest.approx(power / run.critical.contact_radius)


def test_pile_up_and_groove_have_a_half_of_the_bar_each(make_run: MakeRun) -> None:
    run = open_run(make_run(9.0))
    bar = residual_surfaces(run, run.snapshot("final")).axes[-1]
    low, high = bar.get_ylim()
    assert low < 0 < high
    ticks = bar.get_yticks()
    assert np.count_nonzero(ticks < 0) >= 2
    assert np.count_nonzero(ticks > 0) >= 2
    places = bar.transAxes.inverted().transform(bar.transData.transform([(0.0, t) for t in (low, 0.0, high)]))[:, 1]
    np.testing.assert_allclose(places, [0.0, 0.5, 1.0], atol=1e-9)


def test_an_unknown_field_names_the_known_ones() -> None:
    with pytest.raises(ValueError, match=r"did you mean von_mises_stress.*stress_xz"):
        quantity_of("von_mises")
    assert len(QUANTITIES) == 15


# --- Gap, depth, energy -----------------------------------------------------------------------------------------------


def test_gap_map(make_run: MakeRun) -> None:
    run = open_run(make_run(9.0))
    snapshot = run.snapshot("aligned")
    fig = gap_map(run, snapshot)
    np.testing.assert_allclose(fig.axes[0].images[0].get_array(), snapshot.contact.gap / ALPHA_C)  # type: ignore[arg-type]
    assert len(fig.axes[0].collections) == 1  # the edge of contact
    with pytest.raises(RunError, match="no contact"):
        gap_map(run, run.snapshot("final"))


def test_stress_over_depth_is_that_of_the_cells_under_the_point(make_run: MakeRun) -> None:
    run = open_run(make_run(9.0))
    body = run.snapshot("final", tensors=True).lower
    i = 20
    fig = stress_over_depth(run, x=float(body.x[i]), y=float(body.y[3]))
    line = curve(fig.axes[0], r"$\sigma_{yy}$")
    np.testing.assert_allclose(line.get_xdata(), 1e3 * body.z)
    np.testing.assert_allclose(line.get_ydata(), 1e-6 * body.stress["yy"][:, 3, i], rtol=1e-12)
    strain = curve(fig.axes[2], "lower body")
    np.testing.assert_allclose(strain.get_ydata(), 100.0 * body.equivalent_plastic_strain[:, 3, i], rtol=1e-12)
    written = texts(fig)
    assert any(t.startswith("residual stress") for t in written)
    assert any("$S_y$ = 912 MPa" in t for t in written)  # the second axes
    assert sum("$a_c$ = 10.5 mm" in t for t in written) == 3


def test_no_profile_without_stress(make_rolling: MakeRun, make_run: MakeRun) -> None:
    elastic = open_run(make_rolling(yields=False))
    with pytest.raises(RunError, match="no stress components"):
        stress_over_depth(elastic)
    with pytest.raises(RunError, match="lies outside the grid"):
        stress_over_depth(open_run(make_run()), x=9.0)


def test_energy_balance(make_run: MakeRun) -> None:
    run = open_run(make_run(9.0))
    columns = {name: np.array(values) for name, values in run.history.items()}
    columns["work"][-1] += 0.03 * columns["work"].max()
    broken = History(columns)
    sums = sum(
        columns[name] for name in ("dissipation_lower", "dissipation_upper", "energy_residual", "energy_elastic")
    )
    np.testing.assert_allclose(balance_error(broken), (columns["work"] - sums) / np.abs(columns["work"]).max())
    fig = energy_balance(run)
    work = curve(fig.axes[0], "work of the drive")
    np.testing.assert_allclose(work.get_ydata(), run.history["work"] / 1e3)
    assert any("$U_c$ = 30.7 J" in t for t in texts(fig))


def test_load_over_depth_has_second_axes_over_first_yield(make_indentation: MakeRun) -> None:
    run = open_run(make_indentation())
    fig = load_depth([run])
    written = texts(fig)
    assert any(r"$\alpha/\alpha_c$" in t for t in written)
    assert any("$F_n/P_c$" in t for t in written)
    top, right = fig.axes[0].child_axes
    assert top.get_xlim()[1] == pytest.approx(fig.axes[0].get_xlim()[1] * 1e-3 / ALPHA_C)
    assert right.get_ylim()[1] == pytest.approx(fig.axes[0].get_ylim()[1] * 1e6 / P_C)


# --- Animations -------------------------------------------------------------------------------------------------------


def test_frames_are_the_stored_states(make_run: MakeRun) -> None:
    run = open_run(make_run(9.0))
    animation = animate(run, field="equivalent_plastic_strain", bodies="lower")
    fig = animation._fig  # type: ignore[attr-defined]
    shown = []
    animation._init_draw()  # type: ignore[attr-defined]
    for frame in animation.new_frame_seq():
        animation._draw_frame(frame)  # type: ignore[attr-defined]
        shown.append((np.array(fig.axes[0].images[0].get_array()), fig._suptitle.get_text()))
    for (values, title), step in zip(shown, run.steps, strict=True):
        body = run.snapshot(step).lower
        np.testing.assert_allclose(values, 100.0 * body.equivalent_plastic_strain[:, 7], rtol=1e-12)
        assert f"step {step}," in title
    every = np.stack([values for values, _ in shown])
    assert fig.axes[0].images[0].norm.vmax == pytest.approx(every.max())


def test_the_line_of_contact_moves_over_a_body_and_rests_in_its_own_frame(make_run: MakeRun) -> None:
    run = open_run(make_run(9.0))
    for follow, moves in (("body", True), ("contact", False)):
        animation = animate(run, bodies="lower", follow=follow)  # type: ignore[arg-type]
        ax = animation._fig.axes[0]  # type: ignore[attr-defined]
        middles = []
        animation._init_draw()  # type: ignore[attr-defined]
        for frame in animation.new_frame_seq():
            animation._draw_frame(frame)  # type: ignore[attr-defined]
            middles.append(A_C * float(np.mean(curve(ax, "contact").get_xdata())))
        expected = [run.snapshot(step).lower.contact_x if moves else 0.0 for step in run.steps]
        np.testing.assert_allclose(middles, expected, atol=1e-3 * A_C)


def test_one_state_is_no_animation(make_run: MakeRun) -> None:
    folder = make_run()
    with h5py.File(folder / "result.vtkhdf", "a") as file:
        del file["steps/000006"]
    with pytest.raises(RunError, match="1 stored state in pass 1, an animation needs two or more"):
        animate(open_run(folder))


def test_mp4_needs_ffmpeg(make_run: MakeRun, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    animation = animate(open_run(make_run()))
    assert save_animation(animation, tmp_path / "a.gif").stat().st_size > 0
    monkeypatch.setattr(FFMpegWriter, "isAvailable", classmethod(lambda _: False))
    with pytest.raises(InputError, match=r"ffmpeg, which is not installed; \.gif works without it"):
        save_animation(animation, tmp_path / "a.mp4")


def test_interfaces_of_coated_bodies_are_drawn(tmp_path: Path) -> None:
    case = Case.from_file(CASES / "indentation-coated" / "case.toml", ["grid.resolution=6", "indentation.steps=2"])
    case.run(tmp_path / "coated")
    run = open_run(tmp_path / "coated")
    contact_radius = run.summary["critical"]["contact_radius_m"]
    drawn = [
        line
        for line in section(run, run.snapshot("final"), bodies="lower").axes[0].get_lines()
        if line.get_linestyle() == "--"
    ]
    np.testing.assert_allclose([line.get_ydata() for line in drawn], [[-1e-6 / contact_radius] * 2])
    marked = [line for line in stress_over_depth(run).axes[0].get_lines() if line.get_linestyle() == "--"]
    assert any(np.allclose(np.asarray(line.get_xdata()) * 1e-6, 1e-6) for line in marked)


def test_outlines_of_inclusions_are_drawn(tmp_path: Path) -> None:
    ball = {"type": "ellipsoid", "depth": "40 um", "size": "56 um", "content": "rigid"}
    body = brinell.Body(
        brinell.Flat(), brinell.Material("210 GPa", 0.3, brinell.Linear("1.7 GPa", "10 GPa")), inclusion=ball
    )
    roller = brinell.Body(brinell.Sphere("2 mm"), brinell.Material("210 GPa", 0.3))
    run = brinell.Rolling(
        body, roller, distance="60 um", load="28 N", load_steps=2, grid=brinell.Grid(resolution=6)
    ).run(tmp_path / "run")
    fields = run.snapshot("final").lower
    inside = fields["inclusion"]
    assert set(np.unique(inside)) == {0.0, 1.0}
    cell = np.prod([axis[1] - axis[0] for axis in (fields.x, fields.y, fields.z)])
    assert inside.sum() * cell == pytest.approx(np.pi / 6.0 * 56e-6**3, rel=0.25)
    assert run.snapshot("final").upper.inclusion is None
    figure = section(run, run.snapshot("final"), plane="y=0", bodies="lower")
    outline = np.vstack([line for line in figure.axes[0].collections[0].get_paths()[0].to_polygons()])
    radius = run.summary["critical"]["contact_radius_m"]
    assert outline[:, 0].max() * radius == pytest.approx(28e-6, abs=0.6 * (fields.x[1] - fields.x[0]))
    assert -outline[:, 1].min() * radius == pytest.approx(68e-6, abs=1.1 * (fields.z[1] - fields.z[0]))


def test_outlines_turn_with_a_period() -> None:
    """Outlines are where the cells are: a period is turned round to the contact, and a single row has none."""
    x = (np.arange(16) + 0.5) * 1e-6
    inside = np.zeros((4, 3, 16))
    inside[1:3, :, 2:5] = 1.0
    for rows, turned in ((3, False), (3, True), (1, False)):
        body = SimpleNamespace(
            x=x, y=(np.arange(rows) - rows // 2) * 1e-6, z=(np.arange(4) + 0.5) * 1e-6, inclusion=inside[:, :rows]
        )
        side = SimpleNamespace(body=body, up=-1.0)
        figure = Figure()
        ax = figure.subplots()
        cut = SimpleNamespace(side=side)
        plane = plane_of("y=0" if rows > 1 else ("z", 1.5e-6))
        draw_inclusions(ax, [cast(Cut, cut)], plane, lambda _: 14e-6, 1e-6, turned=turned)
        if rows == 1:
            assert not ax.collections
            continue
        outline = np.vstack(list(ax.collections[0].get_paths()[0].to_polygons()))
        middle = 3.5 - 14.0 + (16.0 if turned else 0.0)
        assert 0.5 * (outline[:, 0].min() + outline[:, 0].max()) == pytest.approx(middle, abs=0.01)
