# SPDX-License-Identifier: BSD-3-Clause
"""Image files of VTK, read back by VTK."""

import xml.etree.ElementTree as ElementTree
from pathlib import Path

import numpy as np
import pytest
from click.testing import CliRunner

import brinell
from brinell.cli import main
from brinell.errors import InputError
from brinell.export import export, export_vti
from brinell.results import COMPONENTS
from vtk_images import vti_image


def collection(path: Path) -> dict[float, Path]:
    """Files by time."""
    entries = ElementTree.parse(path).getroot().iter("DataSet")
    return {float(entry.attrib["timestep"]): path.parent / entry.attrib["file"] for entry in entries}


def test_all_states(real_folder: Path, tmp_path: Path) -> None:
    run = brinell.open(real_folder)
    written = export_vti(run, tmp_path / "new" / "folder")
    assert [path.name for path in written] == [
        "lower_volume.pvd",
        "lower_surface.pvd",
        "upper_volume.pvd",
        "upper_surface.pvd",
    ]
    for path in written:
        assert list(collection(path)) == [*run.steps, run.history.steps]
    step = run.steps[1]
    lower = run.snapshot(step, tensors=True).lower
    volume = vti_image(collection(written[0])[step])
    spacing = np.array([axis[1] - axis[0] for axis in (lower.x, lower.y, lower.z)])
    assert volume.dimensions == (len(lower.x) + 1, len(lower.y) + 1, len(lower.z) + 1)
    np.testing.assert_allclose(volume.spacing, spacing)
    bottom = np.array([lower.x[0], lower.y[0], -lower.z[-1]]) - 0.5 * spacing
    np.testing.assert_allclose(volume.origin, bottom, atol=1e-9 * spacing[0])
    np.testing.assert_array_equal(volume.cell_data["von_mises_stress"], lower.von_mises_stress[::-1])
    np.testing.assert_array_equal(volume.cell_data["stress_xz"], lower.stress["xz"][::-1])
    upper = run.snapshot(step).upper
    volume_above = vti_image(collection(written[2])[step])
    assert volume_above.origin[2] == pytest.approx(0.0, abs=1e-9 * spacing[2])
    np.testing.assert_array_equal(volume_above.cell_data["von_mises_stress"], upper.von_mises_stress)
    surface = vti_image(collection(written[1])[step])
    assert surface.dimensions == (len(lower.x), len(lower.y), 1)
    np.testing.assert_array_equal(surface.origin, (lower.x[0], lower.y[0], 0.0))
    np.testing.assert_array_equal(surface.point_data["residual_displacement"][0], lower.residual_displacement)
    assert surface.point_data["pressure"].max() == run.history["max_pressure"][step]


def test_some_fields(real_folder: Path, tmp_path: Path) -> None:
    run = brinell.open(real_folder)
    (written,) = export_vti(run, tmp_path, fields=["pressure"])
    image = vti_image(collection(written)[run.steps[0]])
    assert set(image.point_data) == {"pressure"}
    with pytest.raises(InputError, match="no field 'presure' to export; allowed: .*pressure"):
        export_vti(run, tmp_path, fields=["presure"])


def test_cells_of_some_nanometres(tmp_path: Path) -> None:
    case = brinell.Case.from_file(Path(__file__).parents[2] / "cases" / "tugging" / "case.toml")
    coarse = {"tugging.interference": 1.5, "grid.resolution": 6, "output.snapshots": "none"}
    run = case.with_values(coarse).run()
    lower = run.snapshot("final").lower
    spacing = [axis[1] - axis[0] for axis in (lower.x, lower.y, lower.z)]
    assert spacing[2] < 1e-8
    volumes, surfaces = export_vti(run, tmp_path, fields=["von_mises_stress", "residual_displacement"])[:2]
    volume = vti_image(collection(volumes)[run.history.steps])
    np.testing.assert_allclose(volume.spacing, spacing)
    np.testing.assert_array_equal(volume.cell_data["von_mises_stress"], lower.von_mises_stress[::-1])
    surface = vti_image(collection(surfaces)[run.history.steps])
    np.testing.assert_array_equal(surface.point_data["residual_displacement"][0], lower.residual_displacement)


def test_a_component_alone(real_folder: Path, tmp_path: Path) -> None:
    run = brinell.open(real_folder)
    (volumes, *_) = export_vti(run, tmp_path, fields=["stress_xz", "plastic_strain", "plastic_strain_xx"])
    arrays = vti_image(collection(volumes)[run.history.steps]).cell_data
    assert sorted(arrays) == sorted(["stress_xz", *(f"plastic_strain_{c}" for c in COMPONENTS)])
    np.testing.assert_array_equal(arrays["stress_xz"], run.snapshot("final").lower.stress["xz"][::-1])
    with pytest.raises(brinell.InputError, match="no field 'stress_zx' to export"):
        export_vti(run, tmp_path, fields=["stress_zx"])


def test_command(interrupted_folder: Path, tmp_path: Path) -> None:
    result = CliRunner().invoke(export, [str(interrupted_folder), "-o", str(tmp_path / "out"), "--field", "gap"])
    assert result.exit_code == 0, result.output
    assert result.output.split() == [str(tmp_path / "out" / "lower_surface.pvd")]
    assert list(collection(tmp_path / "out" / "lower_surface.pvd")) == [0, 4, 8]


def test_command_of_the_package(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    with pytest.raises(SystemExit) as end:
        main(["export", str(tmp_path / "nowhere")])
    assert end.value.code == 2
    assert capsys.readouterr().err == f"brinell: error: {tmp_path / 'nowhere'}: no such folder\n"
