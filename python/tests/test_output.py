# SPDX-License-Identifier: BSD-3-Clause
"""What a run stores: fields, bodies, depth, region, stride, precision, and results that stay small by themselves."""

from __future__ import annotations

import warnings
from pathlib import Path
from typing import Any

import h5py
import numpy as np
import pytest

import brinell
from brinell.export import export_vti
from brinell.report import write_report
from brinell.results import Labelled, Run
from kinds_of_runs import Kind
from vtk_images import VtkhdfFile

pytestmark = pytest.mark.filterwarnings("ignore::brinell.ResolutionWarning", "ignore::brinell.CaseWarning")

BODIES = ("lower", "upper")
OPEN = Kind("rolling", "plastic", "elastic", "open", "heat")
PERIODIC = Kind("sliding", "plastic", "elastic", "periodic", "wear")
PLANE = Kind("fretting", "plastic", "rigid", "plane", "friction")
KINDS = (OPEN, PERIODIC, PLANE)

PARTS: dict[str, dict[str, Any]] = {
    "surface": {"fields": "surface"},
    "one field": {"fields": ["von_mises_stress"]},
    "some fields": {"fields": ["residual_displacement", "stress", "shear", "equivalent_plastic_strain"]},
    "lower": {"bodies": "lower"},
    "upper": {"bodies": "upper"},
    "depth": {"depth": "20 um"},
    "plane": {"region_y": [0, 0]},
    "region": {"region_x": ["-25 um", "25 um"], "region_y": ["-15 um", "1 mm"]},
    "layer": {"region_z": ["21 um", "21 um"]},
    "layers": {"region_z": ["8 um", "50 um"], "stride_z": 2},
    "stride": {"stride": 2, "stride_z": 3},
    "single": {"precision": "single"},
    "all of it": {
        "fields": ["surface", "von_mises_stress"],
        "bodies": "lower",
        "depth": "30 um",
        "region_y": ["-20 um", "20 um"],
        "stride": 2,
        "precision": "single",
    },
}


def run_of(kind: Kind, folder: Path | None, **output: Any) -> Run:
    case = kind.case(output={"snapshots": "every 6", **output})
    return case.run(in_memory=True) if folder is None else case.run(folder)


@pytest.fixture(scope="module")
def whole(tmp_path_factory: pytest.TempPathFactory) -> dict[Kind, Run]:
    return {kind: run_of(kind, tmp_path_factory.mktemp("whole") / "run") for kind in KINDS}


def same_places(part: Labelled, whole: Labelled) -> np.ndarray:
    """The values of a whole field at the places of a part."""
    found = whole
    for axis in set("xyz") & set(part.dims):
        cell = np.ptp(whole.coords["x"][:2])
        places = [int(np.argmin(np.abs(whole.coords[axis] - place))) for place in part.coords[axis]]
        np.testing.assert_allclose(whole.coords[axis][places], part.coords[axis], rtol=0.0, atol=1e-6 * cell)
        steps = np.diff(places)
        assert len(set(steps.tolist())) <= 1
        step = int(steps[0]) if steps.size else 1
        found = found.isel(**{axis: slice(places[0], places[-1] + 1, step)})
    return found.values


@pytest.mark.parametrize("name", PARTS)
@pytest.mark.parametrize("kind", KINDS, ids=" ".join)
def test_what_is_stored_is_that_of_the_whole_result(
    kind: Kind, name: str, whole: dict[Kind, Run], tmp_path: Path
) -> None:
    output = PARTS[name]
    run = run_of(kind, tmp_path / "run", **output)
    compared = 0
    for body in BODIES:
        for field in run.field_names(body):  # type: ignore[arg-type]
            part = run.field(body, field)  # type: ignore[arg-type]
            expected = same_places(part, whole[kind].field(body, field))  # type: ignore[arg-type]
            stored = expected.astype(np.float32) if "precision" in output else expected
            np.testing.assert_array_equal(part.values, stored, err_msg=field)
            compared += 1
    assert compared >= 2
    file = VtkhdfFile(run.file)
    for step in (*run.steps, run.history.steps):
        blocks = file.blocks(float(step))
        shown = blocks["lower_surface"].point_data["pressure"][0]
        np.testing.assert_array_equal(shown, run.field("lower", "pressure").sel(step=step).values)
        for block in (one for one in blocks if one.endswith("volume")):
            for field, values in blocks[block].cell_data.items():
                ours = run.field(block[:5], field).sel(step=step).values  # type: ignore[arg-type]
                if field in ("stress", "plastic_strain"):
                    ours = np.moveaxis(ours, 0, -1)[..., [0, 1, 2, 5, 3, 4]]
                np.testing.assert_array_equal(values, ours)


def test_a_plane_at_a_depth(tmp_path: Path) -> None:
    run = run_of(OPEN, tmp_path / "run", **PARTS["layer"])
    body = run.snapshot("final").lower
    assert body.z.shape == (1,)
    assert abs(body.z[0] - 21e-6) <= 0.5 * body.z[0]
    assert body.equivalent_plastic_strain.shape == (1, len(body.y), len(body.x))
    figure = brinell.plot.section(run, "final", field="equivalent_plastic_strain", bodies="lower")
    np.testing.assert_allclose(
        np.asarray(figure.axes[0].images[0].get_array()), 100.0 * body.equivalent_plastic_strain[0]
    )
    volume = run.to_pyvista("final")["lower_volume"]
    low, high = volume.bounds[-2:]
    assert low < -body.z[0] < high < 0.0


def test_layers_that_are_left_out_stay_at_their_depth(tmp_path: Path) -> None:
    run = run_of(OPEN, tmp_path / "run", **PARTS["stride"])
    whole = run_of(OPEN, None)
    z, all_z = run.snapshot("final").lower.z, whole.snapshot("final").lower.z
    np.testing.assert_allclose(z, all_z[::3])
    centres = run.to_pyvista("final")["lower_volume"].cell_centers().points[:, 2]
    np.testing.assert_allclose(np.unique(np.round(centres, 9)), np.round(-z[::-1], 9), rtol=1e-5)


@pytest.mark.parametrize("name", ["surface", "one field", "lower", "layer", "all of it"])
def test_figures_and_exports_of_a_part(name: str, tmp_path: Path) -> None:
    run = run_of(OPEN, tmp_path / "run", **PARTS[name])
    assert export_vti(run, tmp_path / "vti")
    assert run.to_pyvista("final").n_blocks
    write_report(run, tmp_path / "report.html")
    memory = run_of(OPEN, None, **PARTS[name])
    for field in run.field_names("lower"):
        np.testing.assert_array_equal(memory.field("lower", field).values, run.field("lower", field).values)


def test_what_is_not_stored_is_unknown_and_not_zero(tmp_path: Path) -> None:
    run = run_of(OPEN, tmp_path / "run", fields=["von_mises_stress"], bodies="lower")
    final = run.snapshot("final")
    for body in (final.lower, final.upper):
        assert not body.is_rigid
        assert not body.has("residual_displacement")
        assert np.isnan(body.residual_displacement).all()
        assert np.isnan(body.equivalent_plastic_strain).all()
        with pytest.raises(KeyError, match="nothing is stored of residual_displacement"):
            body["residual_displacement"]
    assert final.lower.von_mises_stress is not None
    assert final.upper.von_mises_stress is None
    with pytest.raises(brinell.RunError, match="no field 'stress'"):
        run.field("lower", "stress")
    with pytest.raises(brinell.RunError, match="residual_displacement is not stored"):
        brinell.plot.residual_surfaces(run, final)


def test_sizes(tmp_path: Path) -> None:
    sizes = {}
    for name in ("surface", "depth", "layer", "stride", "single"):
        case = OPEN.case(output={"snapshots": "every 6", **PARTS[name]})
        sizes[name] = case.result_size
        assert "before compression" in case.check()
    full = OPEN.case(output={"snapshots": "every 6"}).result_size
    assert sizes["single"] == pytest.approx(0.5 * full)
    assert sizes["surface"] < 0.2 * full
    assert sizes["depth"] < 0.8 * full
    assert sizes["stride"] == pytest.approx(0.25 / 3 * full, rel=0.3)
    assert sizes["layer"] < 0.3 * full


def test_the_size_that_is_foretold_is_that_of_the_datasets(tmp_path: Path) -> None:
    for kind in KINDS:
        case = kind.case(output={"snapshots": "every 6"})
        run = case.run(tmp_path / kind.domain)
        with h5py.File(run.file) as file:
            stored = sum(bytes_in(file[name]) for name in ("steps", "final"))
        assert case.result_size == pytest.approx(stored, rel=0.35)  # the number of steps is an estimate


def bytes_in(group: h5py.Group) -> int:
    return sum(
        bytes_in(one) if isinstance(one, h5py.Group) else one.size * one.dtype.itemsize for one in group.values()
    )


def many_steps(count: int, **output: Any) -> brinell.Case:
    kind = Kind("indentation", "plastic", "elastic", "open", "smooth")
    case = kind.case(output={"snapshots": "all", **output})
    # It could yield, so that all its fields are stored, but does not. Few large states: time goes with their number.
    more = {"lower.material.hardening.yield_stress": "100 GPa", "grid.resolution": 12}
    return case.with_values({"indentation.steps": count, **more})


def test_a_result_stays_small_by_itself(tmp_path: Path) -> None:
    full = many_steps(2, fields="all", precision="double").result_size / 5
    # Twice 200 MB is too much in single precision: no more is written than what shows it.
    single, scalars = (many_steps(round(size / full / 2)) for size in (300e6, 420e6))
    assert single.result_size <= 200e6
    assert not any(warning.key == "reduced_result" for warning in single.warnings)
    (told,) = [warning for warning in scalars.warnings if warning.key == "reduced_result"]
    assert "without output.fields it is kept small" in told.text
    assert scalars.result_size <= 200e6
    run = scalars.run(tmp_path / "run")
    assert "reduced_result" in [warning.key for warning in run.warnings]
    step, final = run.snapshot(0).lower, run.snapshot("final").lower
    assert (step.has("von_mises_stress"), step.has("stress")) == (True, False)
    assert final.has("stress")
    assert np.isnan(run.field("lower", "stress").isel(step=0).values).all()
    assert not np.isnan(run.field("lower", "stress").isel(step=-1).values).any()
    blocks = VtkhdfFile(run.file).blocks(0.0)
    assert np.isnan(blocks["lower_volume"].cell_data["stress"]).all()
    np.testing.assert_array_equal(blocks["lower_volume"].cell_data["von_mises_stress"], step.von_mises_stress)
    with h5py.File(run.file) as file:
        stored = sum(bytes_in(file[name]) for name in ("steps", "final"))
    assert scalars.result_size == pytest.approx(stored, rel=0.05)


def test_a_field_that_some_states_lack_is_exported(tmp_path: Path) -> None:
    run = many_steps(2, fields="all", precision="double").run(tmp_path / "run")
    with h5py.File(run.file, "r+") as file:
        del file["steps/000000/lower/stress"]
    assert np.isnan(run.field("lower", "stress").isel(step=0).values).all()
    assert export_vti(run, tmp_path / "vti", fields=["stress"])


def test_a_large_result_is_told_before_it_is_written() -> None:
    case = many_steps(20000, fields="all")
    (told,) = [warning for warning in case.warnings if warning.key == "large_result"]
    assert "GB before compression; output.snapshots, fields, bodies" in told.text
    with pytest.warns(brinell.ResolutionWarning, match="the result takes about"), pytest.raises(KeyboardInterrupt):
        case.run(in_memory=True, progress=interrupt)


def interrupt(*_: object) -> None:
    raise KeyboardInterrupt


@pytest.mark.parametrize(
    ("output", "message"),
    [
        ({"fields": "stres"}, r'output.fields = "stres" is not known; allowed: one or a list of "all", "surface",'),
        ({"fields": ["stress", "pressur"]}, r'output.fields .* has the element "pressur", which is not known; allowed'),
        ({"fields": []}, "output.fields .* has no elements; allowed"),
        ({"bodies": "middle"}, r'output.bodies = "middle" is not known; allowed: "both", "lower" or "upper"'),
        ({"depth": 0.0}, "output.depth = 0.* is out of range; allowed: length > 0"),
        ({"depth": "3 N"}, 'output.depth = "3 N" is a force; allowed: length > 0'),
        ({"region_x": ["1 mm"]}, "output.region_x .* is no region; allowed: the first and the last coordinate"),
        ({"region_y": ["1 mm", "-1 mm"]}, "output.region_y .* is no region"),
        ({"region_z": ["2 um", "1 um"]}, "output.region_z .* is no region"),
        ({"region_z": ["-1 um", "1 um"]}, "output.region_z .* is out of range; allowed: .* >= 0"),
        ({"region_z": [0, "1 um"], "depth": "1 um"}, "cannot stand together with output"),
        ({"stride": 0}, "output.stride = 0 is out of range"),
        ({"stride_z": 0}, "output.stride_z = 0 is out of range"),
        ({"precision": "half"}, r'output.precision = "half" is not known; allowed: "double" or "single"'),
    ],
)
def test_wrong_choices(output: dict[str, Any], message: str) -> None:
    with pytest.raises(brinell.InputError, match=message):
        OPEN.case(output=output)


def test_a_stride_divides_a_period() -> None:
    with pytest.raises(brinell.InputError, match="output.stride = 3 does not divide the 8 cells of a period; allowed"):
        PERIODIC.case(output={"stride": 3})


def test_a_stopped_run_and_its_resume(tmp_path: Path) -> None:
    case = OPEN.case(output={"snapshots": "every 3", "checkpoint_interval": 0, **PARTS["all of it"]})

    def stop(step: int, *_: object) -> None:
        if step == 8:
            raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        case.run(tmp_path / "stopped", progress=stop)
    assert VtkhdfFile(tmp_path / "stopped" / "result.vtkhdf").blocks(3.0)
    resumed, at_once = case.run(tmp_path / "stopped", resume=True), case.run(tmp_path / "whole")
    for field in at_once.field_names("lower"):
        np.testing.assert_array_equal(resumed.field("lower", field).values, at_once.field("lower", field).values)


def test_output_in_python() -> None:
    output = brinell.Output(
        fields=["surface", "stress"],
        bodies="lower",
        depth="1 mm",
        region_x=("-1 mm", "1 mm"),
        stride=2,
        stride_z=3,
        precision="single",
    )
    ball, flat = (
        brinell.Body(brinell.Sphere("1 mm"), brinell.RIGID),
        brinell.Body(brinell.Flat(), brinell.Material("210 GPa", 0.3)),
    )
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        text = brinell.Indentation(flat, ball, load="10 N", output=output).to_toml()
    for line in (
        'fields = ["surface", "stress"]',
        'bodies = "lower"',
        "depth = 0.001",
        "region_x = [-0.001, 0.001]",
        "stride = 2",
        "stride_z = 3",
        'precision = "single"',
    ):
        assert line in text
