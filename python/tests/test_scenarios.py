# SPDX-License-Identifier: BSD-3-Clause
"""Scenarios as Python classes: they say what a case file says, with the same errors and results."""

from __future__ import annotations

import inspect
import math
import re
from dataclasses import fields
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import brinell
from brinell import bodies, reference, scenarios
from brinell._toml import tomllib
from brinell.plot.scales import Scales

CASES = Path(__file__).parents[2] / "cases"
PAGE = (Path(__file__).parents[2] / "docs" / "reference" / "case-file.md").read_text(encoding="utf-8")

STEEL = brinell.Material("200 GPa", 0.3, brinell.Linear(yield_stress="600 MPa", modulus="2 GPa"))
HARDER = brinell.Material("210 GPa", 0.28, brinell.Linear("750 MPa", 2e9))


def body_of_radius(radius: float | str, material: brinell.Material = STEEL) -> brinell.Body:
    return brinell.Body(brinell.Sphere(radius), material)


def keys_of(table: str) -> set[str]:
    """Keys of a table of the case file, as its reference page lists them: that is made from the schema."""
    section = PAGE.split(f"## `[{table}]`")[1].split("\n## ")[0]
    return set(re.findall(r"^\| `([\w.]+)` \|", section, flags=re.MULTILINE))


def test_a_tugging_is_that_of_the_case_file() -> None:
    tugging = brinell.Tugging(
        lower=body_of_radius("10 um"),
        upper=body_of_radius(15e-6, HARDER),
        interference=4,
        title="Dissimilar hardening asperities",
        grid={"resolution": 14},
        output={"snapshots": "every 8"},
    )
    of_file = brinell.Case.from_file(CASES / "tugging" / "case.toml")
    assert tomllib.loads(tugging.to_toml()) == tomllib.loads(of_file.to_toml())


def test_an_indentation_runs() -> None:
    run = brinell.Indentation(
        lower=brinell.Body(brinell.Flat(), STEEL),
        upper=body_of_radius("50 um", brinell.RIGID),
        approach=[np.float64(5.0), 0],
        normalised=True,
        steps=4,
        grid={"resolution": 5},
    ).run()
    assert run.scenario == "indentation"
    assert run.indents[0].max_approach == pytest.approx(5.0 * run.critical.interference)
    assert run.indents[0].residual_depth > 0.0


def test_a_rolling_over_a_dent_runs() -> None:
    run = brinell.Rolling(
        lower=brinell.Body(brinell.Flat(), STEEL, brinell.Dent(depth="0.2 um", edge_radius="2.5 um")),
        upper=body_of_radius("100 um", brinell.Material("300 GPa", 0.25)),
        distance="30 um",
        hertz_pressure="2.5 GPa",
        grid={"resolution": 5, "extent": 1.5},
    ).run()
    assert len(run.passes) == 1
    assert run.case("lower", "texture", "depth") == pytest.approx(0.2e-6)


@pytest.mark.parametrize("yields", [True, False])
def test_a_rough_ball_slides_over_a_rough_flat(yields: bool) -> None:
    def waves(phase: float) -> brinell.HeightMap:
        return brinell.surfaces.sampled(
            lambda x, y: 4e-9 * math.cos(x / 3.2e-7 + phase) * math.exp(-((x / 4e-6) ** 2) - (y / 4e-6) ** 2),
            (4e-7, 4e-7),
            x=(-8e-6, 8e-6),
            y=(-8e-6, 8e-6),
        )

    copper = brinell.Material("120 GPa", 0.34, brinell.Linear("300 MPa", "1 GPa") if yields else None)
    run = brinell.Rolling(
        brinell.Body(brinell.Flat(), copper, waves(0.0)),
        brinell.Body(brinell.Sphere("100 um"), brinell.Material("210 GPa", 0.3), waves(1.0)),
        "8 um",
        load="3 mN",
        slide_to_roll=2,
        grid=brinell.Grid(resolution=5),
        output=brinell.Output(snapshots="none"),
    ).run(in_memory=True)
    history, middle = run.history, np.abs(run.history["x"]) <= 2e-6 * (1 + 1e-9)
    touching = history.in_contact
    np.testing.assert_allclose(history["friction"][touching], history["F_X"][touching] / history["F_n"][touching])
    assert not history["friction"][~touching].any()
    track = run.passes[0]
    assert track.friction == pytest.approx(history["F_X"][middle].sum() / history["F_n"][middle].sum())
    assert track.contact_area == pytest.approx(history["contact_area"][middle].mean())
    swing = np.ptp(history["friction"][middle])
    mean = history["friction"][np.abs(history["x"]) < 4e-6].mean()
    assert swing > 1e-4  # the slopes of the peaks are in F_X
    if yields:
        assert mean > 5e-4
        assert "Friction F_X / F_n" in run._repr_html_()
        assert len(brinell.plot.along_track([run]).axes) == 3
    else:  # what is pushed up a slope comes down it again
        assert abs(mean) < 0.1 * swing
        assert abs(run.history["work"][-1]) < 0.02 * run.history["work"].max()


def test_a_tugging_of_rough_ellipsoids_runs() -> None:
    waves = brinell.surfaces.sampled(
        lambda x, y: 2e-10 * math.cos(x / 4e-8) * math.exp(-((x / 2e-7) ** 2) - (y / 2e-7) ** 2),
        (2e-8, 4e-8),
        x=(-4e-7, 4e-7),
        y=(-4e-7, 4e-7),
    )
    lower = brinell.Body(brinell.Ellipsoid("10 um", "20 um"), STEEL, waves)
    upper = brinell.Body(brinell.Cylinder("10 um", "10 um"), STEEL)
    keys: dict[str, Any] = {"normalised": False, "grid": {"resolution": 4}, "output": {"snapshots": "none"}}
    run = brinell.Tugging(lower, upper, "4 nm", **keys).run()
    smooth = brinell.Tugging(brinell.Body(brinell.Ellipsoid("10 um", "20 um"), STEEL), upper, "4 nm", **keys).run()
    assert run.summary is not None
    assert smooth.summary is not None
    ratio = run.summary["forces"]["peak_F_Z_N"] / smooth.summary["forces"]["peak_F_Z_N"]
    assert abs(ratio - 1) < 0.2
    assert ratio != 1
    assert run.equivalent_radius == pytest.approx(5e-6)  # in the plane of motion
    assert not run.has_critical_values
    with pytest.raises(brinell.InputError, match="neither round where they touch, nor cylinders in plane strain"):
        brinell.Tugging(lower, upper, 4)
    with pytest.raises(brinell.InputError, match="cannot pass another body"):
        brinell.Tugging(lower, brinell.Body(brinell.Vickers(), STEEL), "4 nm", normalised=False)


def cylinders(radius: str, length: str | None = None, **keys: Any) -> brinell.Tugging:
    body = brinell.Body(brinell.Cylinder(radius, length), STEEL)
    return brinell.Tugging(body, body, output={"snapshots": "aligned"}, **keys)


def test_cylinders_are_tugged_in_units_of_their_first_yield() -> None:
    plane = {"boundary": ["open", "periodic"], "resolution": 6}
    run = cylinders("10 um", interference=1.5, grid=plane).run()
    critical = run.critical
    assert run.summary is not None
    of_pair = reference.critical_line_values(
        run.equivalent_radius,
        run.summary["geometry"]["contact_modulus_Pa"],
        critical.yield_stress,
        C=critical.C,
        reference=run.line_reference,
    )
    for name in ("interference", "load", "energy", "contact_radius", "contact_area", "peak_pressure"):
        assert getattr(critical, name) == pytest.approx(getattr(of_pair, name), rel=1e-12)
    assert run.normalised_interference == pytest.approx(1.5, rel=1e-12)
    assert run.history["max_equivalent_plastic_strain"][-1] > 0.0
    F_Z = run.history["F_Z"] / critical.load
    assert run.summary["normalised"]["peak_F_Z"] == pytest.approx(F_Z.max(), rel=1e-12)
    # Little has yielded: the forces of elastic cylinders are near. The dashed lines of the figures are those.
    elastic = reference.elastic_tugging_forces(
        run.history["X"], 1e-5, 1e-5, run.interference, critical.interference, reference=run.line_reference
    )[1]
    np.testing.assert_allclose(F_Z, elastic, atol=0.02 * elastic.max())
    figure = brinell.plot.fig14([run])
    assert "paper" not in [line.get_label() for line in figure.axes[0].lines]
    assert Scales(run).area(0.0).size == critical.contact_area
    assert "P_c" in run._repr_html_()
    # Cylinders that have ends have no such units.
    with pytest.raises(brinell.InputError, match=r"^interference = 1\.5 .* nor cylinders in plane strain"):
        cylinders("10 um", "10 um", interference=1.5)
    with pytest.raises(brinell.InputError, match=r"grid\.reference = 1e-09 m is too short"):
        cylinders("10 um", interference=1.5, grid=plane | {"reference": "1 nm"})


def test_a_pressed_cylinder_is_drawn_beside_the_elastic_one() -> None:
    run = brinell.Indentation(
        brinell.Body(brinell.Flat(), STEEL),
        brinell.Body(brinell.Cylinder("50 um"), brinell.RIGID),
        load=[0.9, 0],
        normalised=True,
        steps=3,
        grid={"boundary": ["open", "periodic"], "resolution": 12},
    ).run()
    axes = brinell.plot.load_depth([run]).axes[0]
    curves = {str(line.get_label()): line for line in axes.lines}
    depth, load = (np.asarray(values, float) for values in curves["elastic (Hertz)"].get_data())
    ours = next(line for label, line in curves.items() if label != "elastic (Hertz)")
    x, y = (np.asarray(values, float) for values in ours.get_data())
    np.testing.assert_allclose(x, np.interp(y, load, depth), atol=0.01 * depth.max())
    assert run.history["F_n"].max() == pytest.approx(0.9 * run.critical.load, rel=1e-9)


def test_a_grid_that_turns_out_too_small_grows() -> None:
    rolling = brinell.Rolling(
        lower=brinell.Body(brinell.Flat(), STEEL, brinell.Dent(depth="0.2 um", edge_radius="2.5 um")),
        upper=body_of_radius("100 um", brinell.Material("300 GPa", 0.25)),
        distance="30 um",
        hertz_pressure="4 GPa",
        grid={"resolution": 4, "extent": 0.6},
        output={"snapshots": "all"},
    )
    run = rolling.run()
    assert run.summary is not None
    changes = run.summary["grid"]["changes"]
    assert changes
    stress = run.field("lower", "von_mises_stress")
    before, after = stress.isel(step=0).values, stress.isel(step=-1).values
    assert np.isnan(before).any()  # not computed beyond the first grid
    assert not np.isnan(after).any()
    strain = run.field("lower", "equivalent_plastic_strain").values
    assert strain.shape[1:] == tuple(reversed(run.summary["grid"]["lower_cells"]))
    assert np.isfinite(strain).all()


def test_with_values_keeps_the_class() -> None:
    tugging = brinell.Tugging(body_of_radius(1.0), body_of_radius(1.0), 4)
    other = tugging.with_values({"tugging.interference": 2})
    assert isinstance(other, brinell.Tugging)
    assert tomllib.loads(other.to_toml())["tugging"]["interference"] == 2


@pytest.mark.parametrize("scenario", [getattr(brinell, name) for name in scenarios.__all__])
def test_a_scenario_has_all_keys_of_its_table(scenario: type) -> None:
    arguments = set(inspect.signature(scenario.__init__).parameters)
    shared = {"self", "lower", "upper", "title", "interface", "thermal", "grid", "solver", "output"}
    assert arguments - shared == keys_of(scenario.__name__.lower())


def test_shapes_and_textures_have_all_keys_of_their_tables() -> None:
    def keys(*classes: Any) -> set[str]:
        return {field.name for each in classes for field in fields(each)} | {"type"}

    def of_page(table: str) -> set[str]:
        return {key.split(".")[1] for key in keys_of("lower") if key.startswith(table)}

    shapes = [getattr(bodies, s.__name__) for s in bodies.Shape.__subclasses__()]
    assert keys(*shapes) == of_page("shape.")
    assert {s.type for s in shapes} == set(re.findall(r'"(\w+)"', PAGE.split("`shape.type` |")[1].split("|")[0]))
    of_a_map = {"file", "unit", "layout", "fill", "spacing", "heights", "columns", "periodic"}
    textures = (bodies.Dent, bodies.Bump, bodies.Sinusoid, bodies.RandomSurface)
    assert keys(*textures) == of_page("texture.") - of_a_map


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        ({"interference": -1}, "interference = -1 is out of range"),
        ({"interference": None}, "interference is missing"),
        ({"load": 3}, "cannot stand together"),
        ({"grid": brinell.Grid(resolution=0)}, "grid.resolution = 0 is out of range"),
        ({"grid": 8}, "grid = 8; allowed: a brinell.Grid, a dictionary, or None"),
        ({"solver": brinell.Grid(resolution=5)}, "allowed: a brinell.Solver, a dictionary, or None"),
        ({"output": brinell.Output(snapshots="some")}, 'output.snapshots = "some"'),
        ({"grid": {"resolutin": 3}}, "did you mean grid.resolution?"),
        ({"upper": brinell.Body(brinell.Flat(), STEEL)}, "upper.shape.type"),
        ({"upper": body_of_radius("3 kg")}, "upper.shape.radius"),
    ],
)
def test_errors_are_those_of_the_case_file(arguments: dict[str, Any], message: str) -> None:
    good = {"lower": body_of_radius(1.0), "upper": body_of_radius(1.0), "interference": 4}
    with pytest.raises(brinell.InputError) as error:
        brinell.Tugging(**good | arguments)
    assert message in str(error.value)
    assert "toml" not in str(error.value)
    assert "tugging." not in str(error.value)


def test_errors_name_arguments_and_no_line_of_a_file_that_is_not_there() -> None:
    falling = brinell.Table([0, 0.01], ["2743.4 MPa", "2739.4 MPa"])
    soft = brinell.Body(brinell.Flat(), brinell.Material("210 GPa", 0.3, falling))
    ball = body_of_radius("5 mm", brinell.RIGID)
    with pytest.raises(brinell.InputError) as error:
        brinell.Indentation(soft, ball, load=["3 kN", 0])
    assert str(error.value) == (
        "lower.material.hardening.law: the stresses of a hardening table must not fall; point 2, 2.7394e+09 Pa, "
        "follows 2.7434e+09 Pa (softening is not modelled); for a measurement that scatters, monotone = true uses the "
        "largest stress so far"
    )
    assert len(error.traceback) <= 4  # this test, the scenario, its arguments, its base: not the writer of TOML
    bend = brinell.Material("210 GPa", 0.3, brinell.Perfect("1 GPa"), back_stresses=[("1 mm", 0)])
    with pytest.raises(brinell.InputError, match=r'^lower\.material\.back_stresses\[0\]\.modulus = "1 mm" is a length'):
        brinell.Indentation(brinell.Body(brinell.Flat(), bend), ball, load=["3 kN", 0])
    with pytest.raises(brinell.InputError, match=r"^load = \[\] has 0 elements"):
        brinell.Indentation(soft, ball, load=[])
    tugging = brinell.Tugging(body_of_radius(1.0), body_of_radius(1.0), 4)
    with pytest.raises(brinell.InputError, match=r"^tugging\.interference = -4 is out of range"):
        tugging.with_values({"tugging.interference": -4})
    huge = {"grid.spacing": [1e-7, 1e-7, 1e-7]}
    with pytest.raises(brinell.InputError, match=r"^grid\.spacing = \[1e-07, 1e-07, 1e-07\]") as error:
        tugging.with_values(huge).run()
    assert "toml" not in str(error.value)


def test_warnings_of_a_scenario_name_no_file() -> None:
    soft = body_of_radius(1.0, brinell.Material(210, 0.3, brinell.Perfect(900)))
    with pytest.warns(brinell.CaseWarning, match=r"^lower\.material\.young_modulus is 210 Pa"):
        brinell.Tugging(soft, body_of_radius(1.0), "1 mm", normalised=False)


@pytest.mark.parametrize("kind", [brinell.Interface, brinell.Grid, brinell.Solver, brinell.Output])
def test_settings_have_all_keys_of_their_tables(kind: Any) -> None:
    tables = {key.split(".")[0] for key in keys_of(kind.__name__.lower())}
    assert {field.name for field in fields(kind)} == tables


def test_wear_has_all_keys_of_its_table() -> None:
    keys = {key.removeprefix("wear.") for key in keys_of("interface") if key.startswith("wear.")}
    assert {field.name for field in fields(brinell.Wear)} == keys


def test_settings_are_the_same_as_dictionaries() -> None:
    pair = (body_of_radius(1.0), body_of_radius(1.0), 4)
    of_classes = brinell.Tugging(
        *pair,
        grid=brinell.Grid(resolution=7, extent=1.2),
        solver=brinell.Solver(max_evaluations=50, mirror=False),
        output=brinell.Output(snapshots=[0, 3]),
        interface=brinell.Interface(friction=0.2, coupling=False),
    )
    of_tables = brinell.Tugging(
        *pair,
        grid={"resolution": 7, "extent": 1.2},
        solver={"max_evaluations": 50, "mirror": False},
        output={"snapshots": [0, 3]},
        interface={"friction": 0.2, "coupling": False},
    )
    assert of_classes.to_toml() == of_tables.to_toml()


def test_a_law_of_ones_own_gives_what_the_same_law_of_the_engine_gives() -> None:
    def linear(e: float) -> float:
        return 600e6 + 2e9 * e

    def peak(law: Any) -> float:
        ball = body_of_radius("10 um", brinell.Material("200 GPa", 0.3, law))
        run = brinell.Tugging(ball, ball, 6, grid={"resolution": 5}).run()
        return float(run.history["F_X"].max())

    of_engine = peak(brinell.Linear("600 MPa", "2 GPa"))
    assert peak(linear) == pytest.approx(of_engine, rel=1e-9)  # both are linear: rounding, through a few iterations


@pytest.mark.parametrize("hardening", ["600 MPa", 600e6, {"law": "perfect"}, brinell.Linear])
def test_a_material_never_stays_elastic_by_mistake(hardening: Any) -> None:
    with pytest.raises(brinell.InputError, match="hardening"):
        brinell.Material("210 GPa", 0.3, hardening)


@pytest.mark.parametrize(
    ("shape", "material"), [("flat", STEEL), (brinell.Flat, STEEL), (brinell.Flat(), "steel"), (brinell.Flat(), None)]
)
def test_a_body_is_made_of_parts(shape: Any, material: Any) -> None:
    with pytest.raises(brinell.InputError, match="of a body; allowed"):
        brinell.Body(shape, material)


def test_a_scenario_has_bodies() -> None:
    with pytest.raises(brinell.InputError, match=r"lower = 'a'; allowed: a brinell.Body"):
        brinell.Tugging("a", "b", 3)  # type: ignore[arg-type]


def test_shape_and_material_in_the_wrong_order_are_told() -> None:
    for swapped in (lambda: brinell.Body(STEEL, brinell.Sphere("1 mm")), lambda: brinell.Body(brinell.RIGID, STEEL)):
        with pytest.raises(brinell.InputError, match="the shape comes first, as in brinell.Body"):
            swapped()


@pytest.mark.filterwarnings("ignore::brinell.ResolutionWarning", "ignore::brinell.CaseWarning")
def test_a_distance_that_given_cells_do_not_fit_is_told() -> None:
    flat = brinell.Body(brinell.Flat(), brinell.Material("210 GPa", 0.3, brinell.Linear("900 MPa", "5 GPa")))
    ball = brinell.Body(brinell.Sphere("1 mm"), brinell.RIGID)

    def told(scenario: type, distance: str, **grid: Any) -> list[str]:
        case = scenario(flat, ball, load="2 N", distance=distance, grid=grid)
        return [warning.text for warning in case.warnings if warning.key == "rounded_distance"]

    given = {"spacing": ["4 um", "4 um", "2 um"]}
    (text,) = told(brinell.Rolling, "0.404 mm", **given)
    assert "no even number of steps of 4e-06 m, so that 0.000408 m are computed" in text
    (text,) = told(brinell.Sliding, "0.0415 mm", **given)
    assert "no whole number of steps of 4e-06 m, so that 4e-05 m are computed" in text
    for scenario, distance in ((brinell.Rolling, "0.4 mm"), (brinell.Sliding, "0.404 mm")):
        assert told(scenario, distance, **given) == []
    for scenario in (brinell.Rolling, brinell.Sliding):
        assert told(scenario, "0.123 mm", resolution=6) == []
