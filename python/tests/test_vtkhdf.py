# SPDX-License-Identifier: BSD-3-Clause
"""ParaView's reader finds in result.vtkhdf what our own reader does."""

import os
import shutil
from pathlib import Path

import numpy as np
import pytest

import brinell
from brinell.results import BodyFields, Run
from vtk_images import Image, VtkhdfFile, vtk

VTK_COMPONENTS = ("xx", "yy", "zz", "xy", "yz", "xz")


def assert_volume(image: Image, body: BodyFields, up: float) -> None:
    nz, ny, nx = body.equivalent_plastic_strain.shape
    assert image.dimensions == (nx + 1, ny + 1, nz + 1)
    spacing = np.array([axis[1] - axis[0] for axis in (body.x, body.y, body.z)])
    first = np.array([body.x[0], body.y[0], body.z[0]])
    assert image.up == up
    np.testing.assert_allclose(image.spacing, spacing, rtol=1e-9)  # ours is a difference of coordinates
    np.testing.assert_allclose(image.origin, first - 0.5 * spacing, rtol=1e-9, atol=1e-9 * spacing[0])
    assert set(image.cell_data) == {"equivalent_plastic_strain", "plastic_strain", "stress", "von_mises_stress"}
    np.testing.assert_array_equal(image.cell_data["von_mises_stress"], body.von_mises_stress)
    np.testing.assert_array_equal(image.cell_data["equivalent_plastic_strain"], body.equivalent_plastic_strain)
    for index, component in enumerate(VTK_COMPONENTS):
        np.testing.assert_array_equal(image.cell_data["stress"][..., index], body.stress[component])
        np.testing.assert_array_equal(image.cell_data["plastic_strain"][..., index], body.plastic_strain[component])


def assert_surface(image: Image, body: BodyFields) -> None:
    assert image.dimensions == (len(body.x), len(body.y), 1)
    np.testing.assert_array_equal(image.origin, (body.x[0], body.y[0], 0.0))
    np.testing.assert_array_equal(image.point_data["residual_displacement"][0], body.residual_displacement)


def assert_contact(image: Image, run: Run, which: int | str) -> None:
    """The extreme values are where the contact is on the lower body."""
    snapshot = run.snapshot(which)  # type: ignore[arg-type]
    contact, lower = snapshot.contact, snapshot.lower
    pressure, gap = image.point_data["pressure"][0], image.point_data["gap"][0]
    assert pressure.max() == contact.pressure.max()
    assert pressure.sum() == pytest.approx(contact.pressure.sum())
    j, i = np.unravel_index(np.argmax(contact.pressure), contact.pressure.shape)
    cell = lower.x[1] - lower.x[0]
    column = np.argmin(np.abs(lower.x - (contact.x[i] + lower.contact_x)))
    row = np.argmin(np.abs(lower.y - contact.y[j]))
    assert lower.x[column] == pytest.approx(contact.x[i] + lower.contact_x, abs=1e-6 * cell)
    assert pressure[row, column] == pressure.max() or snapshot.is_final
    assert gap[row, column] == contact.gap[j, i]
    known = ~np.isnan(gap)
    assert np.all(pressure[~known] == 0.0)
    assert np.nanmax(gap) <= contact.gap.max()


def assert_same_as_ours(blocks: dict[str, Image], run: Run, which: int | str) -> None:
    snapshot = run.snapshot(which, tensors=True)  # type: ignore[arg-type]
    assert list(blocks) == ["lower_volume", "upper_volume", "lower_surface", "upper_surface"]
    for name, body, up in (("lower", snapshot.lower, -1.0), ("upper", snapshot.upper, 1.0)):
        assert_volume(blocks[f"{name}_volume"], body, up)
        assert_surface(blocks[f"{name}_surface"], body)
    assert_contact(blocks["lower_surface"], run, which)


def test_complete_run(real_folder: Path) -> None:
    run = brinell.open(real_folder)
    file = VtkhdfFile(run.file)
    assert file.times == (*run.steps, run.history.steps)
    for which in (run.steps[1], run.steps[2], "final"):
        time = run.history.steps if which == "final" else which
        assert_same_as_ours(file.blocks(float(time)), run, which)


def pieces_of(data: "vtk.vtkImageData") -> dict[str, "vtk.vtkDataSet"]:
    """What the filters behind ParaView's Clip, Threshold and Extract Surface make of a volume."""
    half = vtk.vtkPlane()
    half.SetOrigin(data.GetCenter())
    half.SetNormal(0.0, 1.0, 0.0)
    clip = vtk.vtkTableBasedClipDataSet()
    clip.SetClipFunction(half)
    threshold = vtk.vtkThreshold()
    threshold.SetInputArrayToProcess(0, 0, 0, vtk.vtkDataObject.FIELD_ASSOCIATION_CELLS, "von_mises_stress")
    threshold.SetLowerThreshold(0.5 * data.GetCellData().GetArray("von_mises_stress").GetRange()[1])
    found = {}
    for name, of in (("clip", clip), ("threshold", threshold), ("surface", vtk.vtkGeometryFilter())):
        of.SetInputData(data)
        of.Update()
        found[name] = of.GetOutput()
    return found


def test_the_bodies_stand_upright_in_the_contact(real_folder: Path) -> None:
    run = brinell.open(real_folder)
    step = run.steps[1]
    snapshot = run.snapshot(step)
    datasets = VtkhdfFile(run.file).datasets(float(step))
    for name, body, up in (("lower", snapshot.lower, -1.0), ("upper", snapshot.upper, 1.0)):
        volume = datasets[f"{name}_volume"]
        depth = 2.0 * body.z[0] * len(body.z)
        bottom, top = sorted((0.0, up * depth))
        assert volume.GetBounds()[4:] == pytest.approx((bottom, top))
        pieces = pieces_of(volume)
        for piece in pieces.values():
            assert piece.GetBounds()[4] >= bottom - 1e-9 * depth
            assert piece.GetBounds()[5] <= top + 1e-9 * depth
        # A filter that did not know of the turned axis would find the stress of the layers somewhere else.
        k, j, i = (2, body.von_mises_stress.shape[1] // 2, 4)
        cell = volume.FindCell(
            (body.x[i], body.y[j], up * body.z[k]), None, 0, 0.0, vtk.mutable(0), [0.0] * 3, [0.0] * 8
        )
        assert volume.GetCellData().GetArray("von_mises_stress").GetValue(cell) == body.von_mises_stress[k, j, i]
        high = body.von_mises_stress >= 0.5 * np.nanmax(body.von_mises_stress)
        layers = body.z[high.any(axis=(1, 2))]
        reach = np.sort([up * (layers[0] - body.z[0]), up * (layers[-1] + body.z[0])])
        np.testing.assert_allclose(pieces["threshold"].GetBounds()[4:], reach, rtol=1e-6, atol=1e-9 * depth)


def test_interrupted_run(interrupted_folder: Path) -> None:
    run = brinell.open(interrupted_folder, allow_unfinished=True)
    assert not run.complete
    file = VtkhdfFile(run.file)
    assert file.times == tuple(run.steps) == (0, 4, 8)
    for step in run.steps[1:]:
        assert_same_as_ours(file.blocks(float(step)), run, step)


def test_unfinished_run_from_another_folder(
    interrupted_folder: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    moved = shutil.copytree(interrupted_folder, tmp_path / "moved")
    monkeypatch.chdir(tmp_path)
    for path in (moved / "result.vtkhdf", Path("moved/result.vtkhdf")):
        pressure = VtkhdfFile(path).blocks(4.0)["lower_surface"].point_data["pressure"]
        assert pressure.max() == brinell.open(moved, allow_unfinished=True).history["max_pressure"][4]


def test_complete_file_alone(real_folder: Path, tmp_path: Path) -> None:
    alone = Path(shutil.copy(real_folder / "result.vtkhdf", tmp_path / "renamed.vtkhdf"))
    assert os.listdir(tmp_path) == ["renamed.vtkhdf"]
    run = brinell.open(alone)
    assert_same_as_ours(VtkhdfFile(alone).blocks(float(run.steps[-1])), brinell.open(real_folder), run.steps[-1])


def test_resumed_run(interrupted_folder: Path, real_folder: Path, tmp_path: Path, real_case: str) -> None:
    folder = shutil.copytree(interrupted_folder, tmp_path / "resumed")
    resumed = brinell.Case(real_case).run(folder, resume=True)
    whole = brinell.open(real_folder)
    file = VtkhdfFile(resumed.file)
    assert file.times == VtkhdfFile(whole.file).times
    for step in whole.steps[1:]:  # from before and after
        assert_same_as_ours(file.blocks(float(step)), whole, step)
    np.testing.assert_array_equal(brinell.open(resumed.file).history["F_X"], whole.history["F_X"])


def test_single_state_has_no_times(tmp_path: Path, real_case: str) -> None:
    run = brinell.Case(real_case, overrides=["output.snapshots=none"]).run(tmp_path / "run")
    file = VtkhdfFile(run.file)
    assert file.times is None
    assert_same_as_ours(file.blocks(), run, "final")


def test_rigid_body_is_no_block(tmp_path: Path) -> None:
    text = """scenario = "indentation"
lower = {shape = {type = "flat"}, material = {young_modulus = "200 GPa", poisson_ratio = 0.3}}
upper = {shape = {type = "sphere", radius = "1 mm"}, material = {rigid = true}}
indentation = {load = ["5 N"], steps = 3}
grid = {resolution = 3}
output = {fields = "all"}
"""
    run = brinell.Case(text).run(tmp_path / "run")
    assert run.field_names("upper") == []
    blocks = VtkhdfFile(run.file).blocks(float(run.steps[0]))
    assert list(blocks) == ["lower_volume", "lower_surface"]
    assert blocks["lower_surface"].point_data["pressure"].max() == run.history["max_pressure"][run.steps[0]]
