# SPDX-License-Identifier: BSD-3-Clause
"""Every kind of run can be opened, read, drawn, exported and reported: scenario, bodies, boundary, interface."""

from __future__ import annotations

import itertools
from collections.abc import Iterator
from pathlib import Path

import h5py
import numpy as np
import pytest
from click.testing import CliRunner

import brinell
from brinell.export import export_vti
from brinell.plot.cli import plot
from brinell.report import write_report
from brinell.results import BodyFields, Labelled, Run
from brinell.scenarios import SCENARIOS
from kinds_of_runs import DOMAINS, INTERFACES, MATERIALS, Kind, covering_kinds, pairs
from vtk_images import VtkhdfFile, vti_image

KINDS = covering_kinds()
BODIES = ("lower", "upper")

pytestmark = pytest.mark.filterwarnings("ignore::brinell.ResolutionWarning", "ignore::brinell.CaseWarning")


@pytest.fixture(scope="module", params=KINDS, ids=" ".join)
def run(request: pytest.FixtureRequest, tmp_path_factory: pytest.TempPathFactory) -> Run:
    kind: Kind = request.param
    return kind.case(output={"snapshots": "every 5", "fields": "all"}).run(tmp_path_factory.mktemp("kind") / "run")


def test_each_pair_of_levels_occurs() -> None:
    met = {pair for kind in KINDS for pair in pairs(kind)}
    for scenario, lower, upper in itertools.product(SCENARIOS, MATERIALS, MATERIALS):
        for domain, interface in itertools.product(DOMAINS, INTERFACES):
            kind = Kind(scenario, lower, upper, domain, interface)
            assert not kind.is_possible or set(pairs(kind)) <= met


def states_of(run: Run) -> Iterator[tuple[int, brinell.Snapshot]]:
    """Stored states by the number that they have in `Run.field`."""
    for step in run.steps:
        yield step, run.snapshot(step)
    yield run.history.steps, run.snapshot("final")


def test_each_field_is_that_of_the_snapshots(run: Run) -> None:
    assert run.field_names("lower")
    for body, name in ((one, name) for one in BODIES for name in run.field_names(one)):  # type: ignore[arg-type]
        field = run.field(body, name)
        assert field.values.shape == field.shape
        assert field.dims[0] == "step"
        assert all(np.all(np.diff(field.coords[axis]) > 0.0) for axis in "xyz" if axis in field.dims)
        for step, state in states_of(run):
            if hasattr(state.contact, name):
                largest = np.nanmax(field.sel(step=step).values)
                np.testing.assert_allclose(largest, getattr(state.contact, name).max(), err_msg=name)
            elif name not in ("stress", "plastic_strain"):
                fields = getattr(state, body)
                np.testing.assert_array_equal(on_grid_of(fields, field.sel(step=step)), fields[name])


def on_grid_of(body: BodyFields, field: Labelled) -> np.ndarray:
    """The part of a field that lies on the grid of a state: grids grow during a run."""
    parts = {}
    for axis in (axis for axis in "zyx" if axis in field.dims):
        coords, own = field.coords[axis], getattr(body, axis)
        first = int(np.argmin(np.abs(coords - own[0])))
        assert coords[first] == pytest.approx(own[0], abs=1e-6 * np.ptp(field.coords["x"][:2]))
        parts[axis] = slice(first, first + len(own))
    return field.isel(**parts).values


def test_contact_lies_where_it_is_on_the_lower_body(run: Run) -> None:
    """Also where a period goes round."""
    pressure = run.field("lower", "pressure")
    x, y = pressure.coords["x"], pressure.coords["y"]
    cell = np.ptp(x[:2])
    for step, state in states_of(run):
        columns = np.rint((state.contact.x + state.lower.contact_x - x[0]) / cell).astype(int)
        if run.case("grid", "boundary") == "periodic":
            columns %= len(x)
        rows = np.searchsorted(y, state.contact.y - 1e-6 * cell)
        on_body = (columns >= 0) & (columns < len(x))
        expected = np.zeros((len(y), len(x)))
        expected[np.ix_(rows, columns[on_body])] = state.contact.pressure[:, on_body]
        np.testing.assert_array_equal(pressure.sel(step=step).values, expected)


def test_paraview_reads_it(run: Run) -> None:
    file = VtkhdfFile(run.file)
    for step, state in states_of(run):
        blocks = file.blocks(float(step))
        shown = blocks["lower_surface"].point_data["pressure"][0]
        np.testing.assert_array_equal(shown, run.field("lower", "pressure").sel(step=step).values)
        for body in BODIES:
            fields: brinell.BodyFields = getattr(state, body)
            assert (f"{body}_volume" in blocks) == (not fields.is_rigid)
            if not fields.is_rigid:
                cells = blocks[f"{body}_volume"].cell_data
                assert cells["von_mises_stress"].shape == run.field(body, "von_mises_stress").shape[1:]
                np.testing.assert_array_equal(np.nanmax(cells["von_mises_stress"]), fields.von_mises_stress.max())


def test_exports(run: Run, tmp_path: Path) -> None:
    written = export_vti(run, tmp_path / "vti")
    names = {(path.stem, field) for path in written for field in exported(path, run.history.steps)}
    for body in BODIES:
        for name in run.field_names(body):  # type: ignore[arg-type]
            parts = {name, f"{name}_xx"} & {field for stem, field in names if stem.startswith(body)}
            assert parts, name
    surface = vti_image(tmp_path / "vti" / f"lower_surface_{run.history.steps:06d}.vti")
    np.testing.assert_array_equal(
        surface.point_data["pressure"][0], run.field("lower", "pressure").isel(step=-1).values
    )


def exported(collection: Path, step: int) -> list[str]:
    image = vti_image(collection.parent / f"{collection.stem}_{step:06d}.vti")
    return [*image.cell_data, *image.point_data]


def test_other_libraries(run: Run) -> None:
    for which in (*run.steps[:2], "final"):
        blocks = run.to_pyvista(which)
        assert "contact" in blocks.keys() or not run.snapshot(which).in_contact  # noqa: SIM118
    for body in BODIES:
        for name in run.field_names(body):  # type: ignore[arg-type]
            assert run.field(body, name).isel(step=-1).to_xarray().name == name  # type: ignore[arg-type]
    assert len(run.history.to_pandas()) == run.history.steps
    assert f"{run.scenario}: " in run._repr_html_()


def test_figures(run: Run, tmp_path: Path) -> None:
    commands = [["fields", "--step", "final"], ["history"]]
    own = SCENARIOS[run.scenario].drawings
    if own is not None and run.scenario != "tugging":  # whose figures show several runs
        commands.append([own().command])
    for command in commands:
        result = CliRunner().invoke(plot, [*command, str(run.path), "-o", str(tmp_path)])
        assert result.exit_code == 0, result.output


def test_report(run: Run, tmp_path: Path) -> None:
    assert run.title in write_report(run, tmp_path / "report.html").read_text(encoding="utf-8")


@pytest.mark.parametrize("kind", [kind for kind in KINDS if kind.lower == "rigid"][:4], ids=" ".join)
def test_a_stopped_run_on_a_rigid_body(kind: Kind, tmp_path: Path) -> None:
    def stop(step: int, *_: object) -> None:
        if step == 3:
            raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        kind.case(output={"snapshots": "all", "checkpoint_interval": 0}).run(tmp_path / "run", progress=stop)
    run = brinell.open(tmp_path / "run", allow_unfinished=True)
    assert run.steps == [0, 1, 2, 3]
    for name in run.field_names("lower"):
        assert run.field("lower", name).values.shape[0] == 4
    assert export_vti(run, tmp_path / "vti")
    assert VtkhdfFile(run.file).blocks(2.0)


def test_results_of_older_versions_on_a_rigid_body(tmp_path: Path) -> None:
    """They name the size of the grid in the part for ParaView only."""
    kind = Kind("indentation", "rigid", "elastic", "open", "smooth")
    run = kind.case().run(tmp_path / "run")
    pressure, export = run.field("lower", "pressure").values, export_vti(run, tmp_path / "vti")
    with h5py.File(run.file, "a") as file:
        for state in (*file["steps"].values(), file["final"]):
            del state["lower"].attrs["cells"], state["upper"].attrs["cells"]
    older = brinell.open(tmp_path / "run")
    np.testing.assert_array_equal(older.field("lower", "pressure").values, pressure)
    assert export_vti(older, tmp_path / "vti") == export
