# SPDX-License-Identifier: BSD-3-Clause
import inspect
import json
from collections.abc import Callable
from pathlib import Path

import matplotlib
import matplotlib.image
import numpy as np
import pytest
from matplotlib.figure import Figure

import brinell.plot
from brinell.plot import cells, fields, paper, style
from brinell.plot.energy import energy_balance
from brinell.plot.history import run_history
from brinell.results import History, Run, RunError, open_run
from figure_parts import curve, legend_of, texts

MakeRun = Callable[..., Path]
ALPHAS = (1.0, 2.0, 4.0, 9.0)
P_C, U_C, ALPHA_C, A_C, R = 3.460928e5, 30.65398, 2.214290e-4, 1.052209e-2, 0.5


@pytest.fixture
def runs(make_run: MakeRun) -> list[Run]:
    """In no order: the figures sort."""
    return [open_run(make_run(alpha)) for alpha in (4.0, 1.0, 9.0, 2.0)]


@pytest.mark.parametrize(("draw", "column"), [(paper.fig11, "F_X"), (paper.fig12, "F_Z")])
def test_forces(runs: list[Run], draw: Callable[[list[Run]], Figure], column: str) -> None:
    ax = draw(runs).axes[0]
    for run in runs:
        label = f"{run.normalised_interference:g}"
        line = curve(ax, label)
        np.testing.assert_allclose(line.get_xdata(), run.history["X"] / R)
        np.testing.assert_allclose(line.get_ydata(), run.history[column] / P_C)
        elastic = curve(ax, f"elastic {label}")
        assert np.max(elastic.get_ydata()) > 0.0
        assert np.all(np.isfinite(elastic.get_ydata()))
        assert elastic.get_color() == line.get_color()
    assert legend_of(ax) == ["9", "4", "2", "1", "elastic (Hertz)"]
    assert "$X/R$" in ax.get_xlabel()
    assert "$R$ = 500 mm" in ax.get_xlabel()
    assert f"${column[0]}_{column[-1]}/P_c$" in ax.get_ylabel()
    assert "$P_c$ = 346 kN" in ax.get_ylabel()


def test_resistance_is_positive_before_alignment(runs: list[Run]) -> None:
    line = curve(paper.fig11(runs).axes[0], "elastic 9")
    x, force = np.asarray(line.get_xdata()), np.asarray(line.get_ydata())
    assert np.all(force[x < 0.0] >= 0.0)
    assert np.all(force[x > 0.0] <= 0.0)


def test_net_energy(runs: list[Run]) -> None:
    ax = paper.fig13(runs).axes[0]
    work = curve(ax, "net work of $F_X$")
    np.testing.assert_allclose(work.get_xdata(), ALPHAS)
    ordered = sorted(runs, key=lambda run: run.interference)
    np.testing.assert_allclose(work.get_ydata(), [run.history["work"][-1] / U_C for run in ordered])
    np.testing.assert_allclose(work.get_ydata(), [run.summary["normalised"]["net_energy"] for run in ordered])  # type: ignore[index]
    # The synthetic bodies dissipate and store exactly what is put in.
    np.testing.assert_allclose(curve(ax, "dissipated + locked in").get_ydata(), work.get_ydata())
    assert legend_of(ax) == ["net work of $F_X$", "dissipated + locked in", "elastic (Hertz)"]
    assert "$U/U_c$" in ax.get_ylabel()
    assert r"\alpha^*" in ax.get_xlabel()


def test_load_ratio_only_where_the_bodies_touch(runs: list[Run]) -> None:
    ax = paper.fig14(runs).axes[0]
    for run in runs:
        ratio = np.asarray(curve(ax, f"{run.normalised_interference:g}").get_ydata())
        touching = run.history["F_n"] > 0.0
        assert not touching.all()
        np.testing.assert_array_equal(np.isfinite(ratio), touching)
        np.testing.assert_allclose(
            ratio[touching], (run.history["F_X"] / np.maximum(run.history["F_Z"], 1.0))[touching]
        )
    x, elastic = (np.asarray(v) for v in curve(ax, "elastic").get_data())
    omega = 2.0 - 9.0 * ALPHA_C
    np.testing.assert_allclose(elastic, -x * R / omega, atol=1e-12)
    np.testing.assert_allclose(curve(ax, "paper").get_ydata(), -0.045)
    assert ax.get_ylabel() == "load ratio  $F_X/F_Z$"


def test_residual_displacement(runs: list[Run]) -> None:
    value, fraction = paper.fig15(runs).axes
    last = np.array([run.history["max_residual_lower"][-1] for run in sorted(runs, key=lambda r: r.interference)])
    np.testing.assert_allclose(curve(value, "each body").get_ydata(), last / ALPHA_C)
    np.testing.assert_allclose(curve(fraction, "each body").get_ydata(), last / (np.array(ALPHAS) * ALPHA_C))
    assert r"u^r_{\max}/\alpha_c" in value.get_ylabel()
    assert r"u^r_{\max}/\alpha$" in fraction.get_ylabel()
    assert "paper: up to 25 %" in legend_of(fraction)


def test_unequal_bodies_get_a_curve_each(make_run: MakeRun) -> None:
    run = open_run(make_run(4.0))
    columns = dict(run.history)
    columns["max_residual_upper"] = 0.5 * columns["max_residual_upper"]
    other = Run(run.path, History(columns), run.summary)
    ax = paper.fig15([other]).axes[0]
    ratio = curve(ax, "upper body").get_ydata()[0] / curve(ax, "lower body").get_ydata()[0]  # type: ignore[index]
    assert ratio == pytest.approx(0.5)


def test_only_the_first_pass_is_drawn(make_run: MakeRun) -> None:
    run = open_run(make_run(4.0, passes=2, steps=15))
    assert len(np.asarray(curve(paper.fig11([run]).axes[0], "4").get_xdata())) == 15
    net = np.asarray(curve(paper.fig13([run]).axes[0], "net work of $F_X$").get_ydata())
    assert net[0] == pytest.approx(run.history["work"][14] / U_C)


def test_equal_interferences_are_told_apart(make_run: MakeRun) -> None:
    twins = [open_run(make_run(4.0, name=name)) for name in ("coarse", "fine")]
    assert legend_of(paper.fig11(twins).axes[0])[:2] == ["4 (fine)", "4 (coarse)"]


def test_overview_has_all_panels(runs: list[Run]) -> None:
    fig = paper.overview(runs)
    *panels, legend = fig.axes
    assert [ax.get_title(loc="left")[:3] for ax in panels] == ["(a)", "(b)", "(c)", "(d)", "(e)", "(f)"]
    assert legend_of(legend)[1:] == ["1", "2", "4", "9", "elastic (Hertz)"]
    texts(fig)


def test_only_tugging_can_be_drawn_like_the_paper(make_rolling: MakeRun) -> None:
    with pytest.raises(RunError, match="is of scenario 'rolling', this figure needs 'tugging'"):
        paper.fig11([open_run(make_rolling())])


def test_nothing_to_draw() -> None:
    with pytest.raises(ValueError, match="no run"):
        paper.fig11([])


def test_elastic_pair_cannot_be_drawn_like_the_paper(make_run: MakeRun) -> None:
    with pytest.raises(RunError, match="both bodies are elastic"):
        paper.fig11([open_run(_without_yield(make_run()))])


def _without_yield(folder: Path) -> Path:
    path = folder / "summary.json"
    summary = json.loads(path.read_text())
    summary["critical"] = dict.fromkeys(summary["critical"])
    path.write_text(json.dumps(summary))
    return folder


# --- Fields -----------------------------------------------------------------------------------------------------------


def test_pressure_map(make_run: MakeRun) -> None:
    run = open_run(make_run(9.0))
    snapshot = run.snapshot("aligned")
    fig = fields.pressure_map(run, snapshot, cells=True)
    ax = fig.axes[0]
    shown = ax.images[0].get_array()
    assert shown is not None
    expected = snapshot.contact.pressure / run.critical.peak_pressure
    np.testing.assert_allclose(shown.filled(0.0), expected)  # type: ignore[union-attr]
    dx = snapshot.contact.x[1] - snapshot.contact.x[0]
    assert ax.images[0].get_extent()[0] == pytest.approx((snapshot.contact.x[0] - 0.5 * dx) / A_C)
    assert ax.get_aspect() == 1.0
    written = texts(fig)
    assert any("$a_c$ = 10.5 mm" in t for t in written)
    assert any("$p_{0,c}$ = 1.49 GPa" in t for t in written)
    assert any("step 12" in t and r"$\alpha^*$ = 9" in t for t in written)


def test_interpolated_pressure_keeps_its_peak(make_run: MakeRun) -> None:
    run = open_run(make_run(9.0))
    snapshot = run.snapshot("aligned")
    shown = np.asarray(fields.pressure_map(run, snapshot).axes[0].images[0].get_array())
    assert shown.max() == pytest.approx(snapshot.contact.pressure.max() / run.critical.peak_pressure, rel=0.01)


def test_edge_of_contact_is_found_within_a_fraction_of_a_cell(make_run: MakeRun) -> None:
    """The synthetic contact is a circle of radius a_c sqrt(alpha*), about 7 cells along x and 3 along y."""
    snapshot = open_run(make_run(9.0)).snapshot("aligned")
    start, end = cells.contact_span(snapshot.contact)
    radius = 3.0 * A_C
    dx = snapshot.contact.x[1] - snapshot.contact.x[0]
    assert start == pytest.approx(-radius, abs=0.15 * dx)
    assert end == pytest.approx(radius, abs=0.15 * dx)
    edge = cells.contact_edge(snapshot.contact)
    np.testing.assert_array_equal(edge > 0.0, snapshot.contact.pressure > 0.0)


def test_pressure_map_needs_contact(make_run: MakeRun) -> None:
    run = open_run(make_run())
    with pytest.raises(RunError, match="no contact"):
        fields.pressure_map(run, run.snapshot("final"))


@pytest.mark.parametrize("which", ["aligned", "final"])
def test_residual_surfaces(make_run: MakeRun, which: str) -> None:
    run = open_run(make_run(9.0))
    snapshot = run.snapshot(which)  # type: ignore[arg-type]
    fig = fields.residual_surfaces(run, snapshot)
    profile, lower, upper, _ = fig.axes
    for name, body, ax in (("lower body", snapshot.lower, lower), ("upper body", snapshot.upper, upper)):
        middle = len(body.y) // 2
        np.testing.assert_allclose(curve(profile, name).get_xdata(), body.x / A_C)
        np.testing.assert_allclose(curve(profile, name).get_ydata(), -body.residual_displacement[middle] / ALPHA_C)
        np.testing.assert_allclose(ax.images[0].get_array(), -body.residual_displacement / ALPHA_C)  # type: ignore[arg-type]
    assert any(r"$\alpha_c$ = 221 µm" in t for t in texts(fig))


def test_section(make_run: MakeRun) -> None:
    run = open_run(make_run(9.0))
    snapshot = run.snapshot(6)
    fig = fields.section(run, snapshot)
    stress, strain = fig.axes[:2]
    middle = len(snapshot.lower.y) // 2
    for image, body, side in zip(stress.images, (snapshot.lower, snapshot.upper), (-1, 1), strict=True):
        assert body.von_mises_stress is not None
        np.testing.assert_allclose(image.get_array(), body.von_mises_stress[:, middle] / 0.9115e9)  # type: ignore[arg-type]
        left, _, surface, deep = image.get_extent()
        assert left * A_C == pytest.approx(body.x[0] - 0.5 * (body.x[1] - body.x[0]) - body.contact_x)
        assert surface == pytest.approx(0.0, abs=1e-12)  # both bodies end on the line of contact
        assert deep * A_C == pytest.approx(side * (body.z[-1] + body.z[0]))
    for image, body in zip(strain.images, (snapshot.lower, snapshot.upper), strict=True):
        np.testing.assert_allclose(image.get_array(), 100.0 * body.equivalent_plastic_strain[:, middle])  # type: ignore[arg-type]
    contact = curve(stress, "contact")
    np.testing.assert_allclose(np.asarray(contact.get_xdata()) * A_C, cells.contact_span(snapshot.contact))
    assert stress.get_aspect() == 1.0
    written = texts(fig)
    assert any("$S_y$ = 912 MPa" in t for t in written)
    assert {"lower body", "upper body"} <= set(written)


def test_section_between_two_rows_is_their_mean() -> None:
    y = np.array([-1.5, -0.5, 0.5, 1.5])
    values = np.arange(8.0).reshape(1, 4, 2)
    np.testing.assert_allclose(cells.at_centre(y, values), [[3.0, 4.0]])
    np.testing.assert_allclose(cells.at_centre(y[:3] + 0.5, values[:, :3]), [[2.0, 3.0]])


@pytest.mark.parametrize("draw", [fields.pressure_map, fields.residual_surfaces, fields.section])
@pytest.mark.parametrize("options", [{"finished": False}, {"elastic_upper": True}, {}])
def test_states_without_scales_or_plasticity(make_run: MakeRun, draw: Callable[..., Figure], options: dict) -> None:
    """Unfinished: SI axes. Elastic body: zeros. Elastic pair: SI axes."""
    folder = make_run(9.0, **options)
    if not options:
        _without_yield(folder)
    run = open_run(folder, allow_unfinished=True)
    written = texts(draw(run, run.snapshot("aligned"), cells=True))
    assert any("[mm]" in t for t in written) == ("elastic_upper" not in options)


# --- History and style ------------------------------------------------------------------------------------------------


def test_history_of_two_passes(make_run: MakeRun) -> None:
    run = open_run(make_run(4.0, passes=2, steps=15))
    fig = run_history(run)
    ax = fig.axes[0]
    drawn = [line for line in ax.lines if len(np.asarray(line.get_xdata())) == 15]
    assert len(drawn) == 4  # F_X and F_X_macro, twice
    np.testing.assert_allclose(drawn[0].get_ydata(), run.history["F_X"][:15] / P_C)
    np.testing.assert_allclose(drawn[1].get_ydata(), run.history["F_X"][15:] / P_C)
    x = np.concatenate([np.asarray(line.get_xdata()) for line in drawn[:2]])
    assert np.all(np.diff(x) >= 0.0)
    assert "distance slid" in fig.axes[3].get_xlabel()
    texts(fig)


def test_history_of_an_unfinished_run_is_in_si(make_run: MakeRun) -> None:
    run = open_run(make_run(4.0, finished=False), allow_unfinished=True)
    written = texts(run_history(run))
    assert any(t == "$F_X$  [kN]" for t in written)
    assert any("[J]" in t or "[kJ]" in t for t in written)


def test_section_of_a_flat_body_under_a_rigid_one(make_indentation: MakeRun) -> None:
    """Only the lower body has fields; above it a strip while it is touched."""
    run = open_run(make_indentation())
    loaded = fields.section(run, run.snapshot("aligned"))
    stress = loaded.axes[0]
    assert len(stress.images) == 1
    low, high = stress.get_ylim()
    assert 0.0 < high < -0.2 * low
    assert {"lower body", "upper body, rigid"} <= set(texts(loaded))
    unloaded = fields.section(run, run.snapshot("final"))
    assert unloaded.axes[0].get_ylim()[1] == 0.0
    assert not any("rigid" in t for t in texts(unloaded))


@pytest.mark.parametrize("draw", [fields.pressure_map, fields.residual_surfaces, fields.section])
@pytest.mark.parametrize("options", [{}, {"yields": False}])
def test_states_of_rolling(make_rolling: MakeRun, draw: Callable[..., Figure], options: dict) -> None:
    run = open_run(make_rolling(**options))
    written = texts(draw(run, run.snapshot("aligned")))
    assert any("pass 1" in t and "$F_n$ = 3 MN" in t for t in written)


@pytest.mark.parametrize("draw", [fields.residual_surfaces, fields.section])
def test_only_bodies_that_have_changed_are_drawn(make_rolling: MakeRun, draw: Callable[..., Figure]) -> None:
    run = open_run(make_rolling())
    written = texts(draw(run, run.snapshot("final")))
    assert "lower body" in written
    assert "upper body" not in written


@pytest.mark.parametrize(
    ("scenario", "first", "second"),
    [
        ("indentation", "F_n", "approach"),
        ("rolling", "F_X", "approach"),
    ],
)
def test_history_of_the_other_scenarios(
    make_indentation: MakeRun, make_rolling: MakeRun, scenario: str, first: str, second: str
) -> None:
    run = open_run({"indentation": make_indentation, "rolling": make_rolling}[scenario]())
    fig = run_history(run)
    for ax, column, scale in zip(fig.axes, (first, second), (P_C, ALPHA_C), strict=False):
        drawn = [np.asarray(line.get_ydata()) for line in ax.lines if len(np.asarray(line.get_xdata())) > 2]
        np.testing.assert_allclose(np.concatenate(drawn), run.history[column] / scale)
    assert fig.axes[3].get_xlabel() == "step"
    assert "dissipated, upper" not in legend_of(fig.axes[2])  # it is zero
    assert [ax.get_title(loc="left")[:3] for ax in fig.axes] == ["(a)", "(b)", "(c)", "(d)", "(e)", "(f)"]
    texts(fig)


def test_figures_leave_the_callers_settings_alone(runs: list[Run]) -> None:
    assert paper.fig11(runs).axes[0].xaxis.label.get_size() == 10
    with matplotlib.rc_context({"font.size": 18.0}):
        before = dict(matplotlib.rcParams)
        fig = paper.fig11(runs)
        assert dict(matplotlib.rcParams) == before
    assert fig.axes[0].xaxis.label.get_size() == 20  # in proportion, as 10 to 9


def test_settings_that_the_caller_has_changed_are_respected(runs: list[Run], tmp_path: Path) -> None:
    own = {
        "axes.grid": True,
        "axes.labelsize": 7.0,
        "figure.figsize": (3.3, 2.4),
        "savefig.dpi": 50,
        "axes.spines.top": True,
    }
    with matplotlib.rc_context({**own, "font.family": "DejaVu Serif"}):
        fig = paper.fig11(runs)
        (written,) = style.save(fig, tmp_path, "figure")
    ax = fig.axes[0]
    assert ax.xaxis.label.get_size() == 7
    assert ax.xaxis.label.get_fontfamily() == ["DejaVu Serif"]
    assert fig.get_size_inches().tolist() == [3.3, 2.4]
    assert ax.xaxis.get_gridlines()[0].get_visible()
    # 50 dots per inch, and the margin of a sheet that is cut to what is drawn.
    assert matplotlib.image.imread(written).shape[:2] == pytest.approx((120, 165), abs=8)


@pytest.mark.parametrize("name", sorted(set(brinell.plot.__all__) - {"animate", "standard_figures"}))
def test_every_figure_draws_into_given_axes(name: str) -> None:
    function = getattr(brinell.plot, name)
    if (
        isinstance(function, type)
        or not callable(function)
        or "Figure" not in str(inspect.signature(function).return_annotation)
    ):
        pytest.skip("makes no figure")
    assert "ax" in inspect.signature(function).parameters


def test_figures_in_axes_of_the_caller(runs: list[Run]) -> None:
    mine = Figure()
    left, right = mine.subplots(1, 2)
    right.set_title("mine")
    assert paper.fig11(runs, ax=left) is mine
    assert left.lines
    assert not right.lines
    assert right.get_title() == "mine"
    plain = paper.fig11(runs).axes[0]
    assert [line.get_xydata().tolist() for line in left.lines] == [line.get_xydata().tolist() for line in plain.lines]

    panels = Figure().subplots(2, 1)
    energy_balance(runs[-1], ax=panels)
    assert all(ax.lines or ax.collections for ax in panels)
    with pytest.raises(brinell.InputError, match="ax has 1 axes, but the figure has 2 x 1 panels; allowed: .*subplots"):
        energy_balance(runs[-1], ax=left)
    with pytest.raises(brinell.InputError, match="ax = 'left'; allowed: matplotlib's axes"):
        energy_balance(runs[-1], ax="left")
    with pytest.raises(brinell.InputError, match="panels of different sizes"):
        paper.overview(runs, ax=panels)

    whole = Figure(figsize=(12, 5))
    above, below = whole.subfigures(2, 1)
    assert paper.overview(runs, ax=below) is below
    assert below.axes
    assert not above.axes


def test_runs_of_a_sweep_are_named_by_what_differs(make_rolling: MakeRun, tmp_path: Path) -> None:
    folders = [make_rolling(passes=3, title="", name=name) for name in ("000000", "000001")]
    for folder, load in zip(folders, (10.0, 25.0), strict=True):
        path = folder / "summary.json"
        summary = json.loads(path.read_text())
        summary["case"] = {"scenario": "rolling", "rolling": {"load": load}, "output": {"snapshots": str(folder)}}
        path.write_text(json.dumps(summary))
    runs = {7: open_run(folders[0]), 9: open_run(folders[1])}  # as the runs of a sweep
    fig = brinell.plot.pass_by_pass(runs)
    assert fig is not None
    texts = {text.get_text() for text in fig.findobj(matplotlib.text.Text)}
    assert {"load 10 N", "load 25 N"} <= texts


def test_equal_results_give_equal_files(runs: list[Run], tmp_path: Path) -> None:
    first, second = (
        style.save(paper.fig11(runs), tmp_path / name, "figure", ("png", "svg", "pdf")) for name in ("a", "b")
    )
    assert [path.suffix for path in first] == [".png", ".svg", ".pdf"]
    for one, other in zip(first, second, strict=True):
        assert one.read_bytes() == other.read_bytes()


@pytest.mark.parametrize(
    ("value", "text"),
    [(0.0, "0"), (9.0000001, "9"), (-0.0223, "−0.0223"), (1234.5, "1230"), (4.5e-7, r"4.5$\times 10^{−7}$")],
)
def test_numbers(value: float, text: str) -> None:
    assert style.number(value) == text


@pytest.mark.parametrize(
    ("value", "unit", "text"),
    [
        (1.4925e9, "Pa", "1.49 GPa"),
        (2.214e-4, "m", "221 µm"),
        (0.0105, "m", "10.5 mm"),
        (0.99996, "m", "1 m"),
        (30.654, "J", "30.7 J"),
        (-5e-7, "m", "−500 nm"),
    ],
)
def test_quantities(value: float, unit: str, text: str) -> None:
    assert style.quantity(value, unit) == text
