# SPDX-License-Identifier: BSD-3-Clause
"""Fields over all stored states, and a file alone."""

import builtins
import gc
import shutil
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import brinell
from brinell.errors import InputError
from brinell.results import COMPONENTS, Run, RunError


@pytest.fixture(scope="module")
def run(real_folder: Path) -> Run:
    return brinell.open(real_folder)


def test_volume_is_that_of_the_snapshots(run: Run) -> None:
    field = run.field("lower", "von_mises_stress")
    snapshots = [run.snapshot(which) for which in (*run.steps, "final")]  # type: ignore[arg-type]
    lower = snapshots[0].lower
    assert field.dims == ("step", "z", "y", "x")
    assert field.shape == (len(run.steps) + 1, len(lower.z), len(lower.y), len(lower.x))
    assert (field.units, field.long_name) == ("Pa", "von Mises stress")
    np.testing.assert_array_equal(field.coords["step"], [*run.steps, run.history.steps])
    for axis in "xyz":
        np.testing.assert_array_equal(field.coords[axis], getattr(lower, axis))
    np.testing.assert_array_equal(field.values, [snapshot.lower.von_mises_stress for snapshot in snapshots])
    np.testing.assert_array_equal(np.asarray(field), field.values)


def test_tensor_has_an_axis_of_components(run: Run) -> None:
    field = run.field("upper", "stress")
    step = run.steps[1]
    stress = run.snapshot(step, tensors=True).upper.stress  # type: ignore[arg-type]
    assert field.dims == ("step", "component", "z", "y", "x")
    assert list(field.coords["component"]) == list(COMPONENTS)
    for component in COMPONENTS:
        np.testing.assert_array_equal(field.sel(step=step, component=component).values, stress[component])
    one = field.sel(step=step).isel(component=slice(3, 5), z=0, x=slice(None, None, -2))
    assert one.dims == ("component", "y", "x")
    np.testing.assert_array_equal(one.values, [stress[c][0, :, ::-2] for c in ("yz", "xz")])


@pytest.mark.parametrize("name", ["stress_xz", "plastic_strain_yy"])
def test_a_component_has_the_name_that_figures_have_for_it(run: Run, name: str) -> None:
    tensor, _, component = name.rpartition("_")
    field = run.field("lower", name)
    assert field.name == name
    assert field.dims == ("step", "z", "y", "x")
    assert field.long_name.endswith(f", {component}")
    np.testing.assert_array_equal(field.values, run.field("lower", tensor).sel(component=component).values)
    last = run.snapshot("final").lower
    np.testing.assert_array_equal(last[name], field.isel(step=-1).values)
    np.testing.assert_array_equal(getattr(last, tensor)[component], last[name])
    assert name in brinell.plot.QUANTITIES


def test_a_name_that_is_nearly_one(run: Run) -> None:
    with pytest.raises(RunError, match=r"no field 'stres_xx'; did you mean stress_xx\? stored are .*components as"):
        run.field("lower", "stres_xx")
    lower = run.snapshot("final").lower
    with pytest.raises(KeyError, match=r"no field 'mises_stress'; did you mean von_mises_stress\?"):
        lower["mises_stress"]
    with pytest.raises(KeyError, match="stress has no component 'rr'; allowed: xx, yy"):
        lower.stress["rr"]


def test_contact_lies_on_the_lower_body(run: Run) -> None:
    step = run.steps[2]
    snapshot = run.snapshot(step)
    pressure = run.field("lower", "pressure").sel(step=step)
    assert pressure.dims == ("y", "x")
    assert pressure.values.sum() == pytest.approx(snapshot.contact.pressure.sum())
    peak = snapshot.contact.x[np.argmax(snapshot.contact.pressure.max(axis=0))] + snapshot.lower.contact_x
    under = pressure.sel(x=peak, method="nearest").values
    assert under.max() == snapshot.contact.pressure.max()
    gap = run.field("lower", "gap").sel(step=step).values
    np.testing.assert_array_equal(gap[~np.isnan(gap)], snapshot.contact.gap.ravel())


def test_labels(run: Run) -> None:
    field = run.field("lower", "residual_displacement")
    x = field.coords["x"]
    near = field.sel(x=x[3] + 0.3 * (x[1] - x[0]), method="nearest")
    assert near.dims == ("step", "y")
    assert near.coords["x"] == x[3]
    np.testing.assert_array_equal(near.values, field.values[:, :, 3])
    np.testing.assert_array_equal(field.sel(x=slice(x[2], x[5])).values, field.values[:, :, 2:6])
    assert field.isel(step=-1).coords["step"] == run.history.steps
    assert field.sel(x=slice(1e3, 2e3)).shape == (*field.shape[:2], 0)
    assert field.sel(x=slice(1e3, 2e3)).values.size == 0


SELECTIONS: list[tuple[str, dict[str, Any]]] = [
    ("isel", {"step": [0]}),
    ("isel", {"step": [-1, 0], "x": [5, 2, 2, -1]}),
    ("isel", {"step": np.array([True, False, True, False]), "y": np.arange(3), "x": 4}),
    ("isel", {"x": []}),
    ("isel", {"x": slice(None, None, -3), "y": [1, 0], "z": [2, 0]}),
    ("isel", {"component": [5, 0], "x": np.int64(3)}),
    ("sel", {"x": [1e-4, -1e-4, 0.0], "method": "nearest"}),
    ("sel", {"step": [4, 0], "component": ["xx", "xz"]}),
    ("sel", {"component": slice("yy", "yz"), "z": [0.0], "method": "nearest"}),
]


@pytest.mark.parametrize(("method", "wanted"), SELECTIONS)
def test_selections_are_those_of_xarray(run: Run, method: str, wanted: dict[str, Any]) -> None:
    pytest.importorskip("xarray")
    field = run.field("lower", "stress")
    if method == "isel" and "step" in wanted and isinstance(wanted["step"], np.ndarray):
        wanted = wanted | {"step": np.arange(field.shape[0]) % 2 == 0}
    whole = field.to_xarray()
    options = dict(wanted)
    if "component" in wanted and options.pop("method", None):  # xarray finds no nearest word
        expected = whole.sel(component=options.pop("component")).sel(options, method="nearest")
    else:
        expected = getattr(whole, method)(**wanted)
    found = getattr(field, method)(**wanted)
    assert found.dims == expected.dims
    assert found.shape == expected.shape
    np.testing.assert_array_equal(found.values, expected.values)
    for dim in found.coords:
        np.testing.assert_array_equal(found.coords[dim], expected.coords[dim].values)
    np.testing.assert_array_equal(found.to_xarray().values, expected.values)


def test_a_selection_is_selected_further(run: Run) -> None:
    field = run.field("lower", "residual_displacement")
    few = field.isel({"x": [8, 2, 5]})
    np.testing.assert_array_equal(few.isel(x=slice(None, None, -1)).values, field.values[:, :, [5, 2, 8]])
    np.testing.assert_array_equal(few.isel(x=[True, False, True]).values, field.values[:, :, [8, 5]])
    np.testing.assert_array_equal(few.sel(x=few.coords["x"][1]).values, field.values[:, :, 2])


@pytest.mark.parametrize(
    ("select", "message"),
    [
        (lambda f: f.sel(step=1), r"step = 1 is not there; allowed: 0, 4, 8"),
        (lambda f: f.sel(x=0.1), r"x = 0\.1 is not there; allowed: .* or method='nearest'"),
        (lambda f: f.sel(z=0.1, method="nearest"), "no axis 'z'; allowed: step, y, x"),
        (lambda f: f.sel(x=0.1, method="linear"), "'linear' is not known"),
        (lambda f: f.isel(x=1000), "there is no index 1000"),
        (lambda f: f.isel(x=1).isel(x=1), "no axis 'x'; allowed: step, y"),
        (lambda f: f.isel(z=[0]), "no axis 'z'; allowed: step, y, x"),
        (lambda f: f.isel(x=[0, 1000]), "x has 21 entries, there is no index 1000"),
        (lambda f: f.isel(x=1.5), r"x = 1\.5 is no index; allowed: an integer, a slice or a list of integers"),
        (lambda f: f.isel(x=["a"]), "x = 'a' is no index"),
        (lambda f: f.isel(x=[[0, 1]]), "the indices of x have 2 axes; allowed: a list with one axis"),
        (lambda f: f.isel(step=[True]), "step has .* entries, but 1 booleans"),
        (lambda f: f.sel(step=[0, 3]), "step = 3 is not there; allowed: 0, 4, 8"),
        (lambda f: f.sel(x=[float("nan")], method="nearest"), "x = nan is not there"),
        (lambda f: f.sel(x=[object()], method="nearest"), "x = <object .* is not there"),
        (lambda f: f.sel(x=slice("a", None)), r"x = slice\('a', None, None\) is not there"),
    ],
)
def test_wrong_selections(run: Run, select: Any, message: str) -> None:
    with pytest.raises(InputError, match=message):
        select(run.field("lower", "residual_displacement"))


def test_fields_that_are_not_stored(run: Run) -> None:
    with pytest.raises(RunError, match="upper body has no field 'pressure'; stored are equivalent_plastic_strain, "):
        run.field("upper", "pressure")
    for ask in (lambda: run.field("middle", "stress"), lambda: run.field_names("middle")):  # type: ignore[arg-type]
        with pytest.raises(RunError, match="no body 'middle'; allowed: lower, upper"):
            ask()


def test_temporary_folder_stays_as_long_as_a_field(real_case: str) -> None:
    run = brinell.Case(real_case).run()
    folder = run.path
    part = run.field("lower", "stress").sel(step=4, component="xx")
    del run
    gc.collect()
    assert np.any(part.values)
    del part
    gc.collect()
    assert not folder.exists()


def test_xarray(run: Run) -> None:
    xarray = pytest.importorskip("xarray")
    field = run.field("lower", "stress").sel(step=run.steps[1])
    array = field.to_xarray()
    assert isinstance(array, xarray.DataArray)
    assert array.attrs["units"] == "Pa"
    assert array.coords["x"].attrs["units"] == "m"
    assert int(array.coords["step"]) == run.steps[1]
    np.testing.assert_array_equal(array.sel(component="xz").values, field.sel(component="xz").values)


def test_without_xarray(run: Run, monkeypatch: pytest.MonkeyPatch) -> None:
    original = builtins.__import__

    def refuse(name: str, *rest: Any) -> Any:
        if name == "xarray":
            raise ImportError(name)
        return original(name, *rest)

    monkeypatch.setattr(builtins, "__import__", refuse)
    with pytest.raises(ImportError, match=r'pip install "brinell\[xarray\]"'):
        run.field("lower", "residual_displacement").to_xarray()


# --- A file alone -----------------------------------------------------------------------------------------------------


def test_complete_file_knows_all(real_folder: Path, run: Run, tmp_path: Path) -> None:
    alone = brinell.open(shutil.copy(real_folder / "result.vtkhdf", tmp_path / "alone.vtkhdf"))
    assert alone.summary == run.summary
    assert list(alone.history) == list(run.history)
    for name, column in run.history.items():
        np.testing.assert_array_equal(alone.history[name], column)
    assert alone.case_text == (real_folder / "resolved.toml").read_text()
    assert alone.steps == run.steps
    np.testing.assert_array_equal(
        alone.snapshot("final").lower.residual_displacement, run.snapshot("final").lower.residual_displacement
    )


def test_file_of_an_unfinished_run_knows_the_stored_steps(interrupted_folder: Path) -> None:
    with pytest.raises(RunError, match=r"no /summary, the run has not finished \(9 steps\)"):
        brinell.open(interrupted_folder / "result.vtkhdf")
    alone = brinell.open(interrupted_folder / "result.vtkhdf", allow_unfinished=True)
    folder = brinell.open(interrupted_folder, allow_unfinished=True)
    assert alone.steps == folder.steps == [0, 4, 8]
    np.testing.assert_array_equal(alone.history["F_X"], folder.history["F_X"][:9])
    assert list(alone.field("lower", "stress").coords["step"]) == [0, 4, 8]
