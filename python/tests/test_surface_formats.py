# SPDX-License-Identifier: BSD-3-Clause
"""Files of surfaces as instruments, spreadsheets and other programs write them: the same map by all ways to read it."""

from __future__ import annotations

import os
import warnings
import zipfile
from pathlib import Path
from typing import Any

import h5py
import numpy as np
import pytest
import scipy.io
from click.testing import CliRunner, Result

import brinell
from brinell import InputError, surfaces
from brinell._toml import tomllib
from brinell.surface_commands import surface
from brinell.surfaces import HeightMap

WYKO = (
    "Wyko ASCII Data File Format\t0\t1\nX Size\t4\nY Size\t3\nBlock Name\tType\tLength\tAttribute\nRAW_DATA\t3\t48\t0\n"
    "Pixel_size\t7\t4\t0.002\nWavelength\t7\t4\t600\nRAW_DATA\t3\t48\n"
    "0.1\t0.2\t0.3\n0.1\tBad\t0.3\n0.1\t0.2\t0.3\n0.1\t0.2\t0.3\n"
)
POINTS = "".join(f"{2 * i},{3 * j},{0.1 * j + 0.02 * i}\n" for j in range(4) for i in range(5))


def call(*arguments: object) -> Result:
    return CliRunner().invoke(surface, [str(argument) for argument in arguments])


def refusal(*arguments: object) -> str:
    """The one line of an error."""
    done = call(*arguments)
    assert done.exit_code == 2, done.output
    assert isinstance(done.exception, SystemExit)
    assert done.output.startswith("brinell: error: ")
    assert done.output.count("\n") == 1
    return done.output


def case_with(file: Path, keys: str) -> brinell.Case:
    text = f"""scenario = "indentation"
[lower]
shape = {{ type = "flat" }}
material = {{ young_modulus = "210 GPa", poisson_ratio = 0.3 }}
texture = {{ type = "height_map", file = "{file.name}", {keys} }}
[upper]
shape = {{ type = "sphere", radius = "1 mm" }}
material = {{ rigid = true }}
[indentation]
load = ["1 N"]
"""
    return brinell.Case(text, file=file.parent / "case.toml")


def heights_of(case: brinell.Case) -> Any:
    texture = tomllib.loads(case.to_toml())["lower"]["texture"]
    return np.reshape(texture["heights"], (-1, texture["columns"]))


@pytest.mark.parametrize("text", ["1,,3,4\n,2,3,4\n1,2,,4\n1,2,3,\n", "1;;3;4\n;2;3;4\n1;2;;4\n1;2;3;\n"])
def test_empty_cells_are_gaps(text: str, tmp_path: Path) -> None:
    file = tmp_path / "map.csv"
    file.write_text(text)
    place = "has in line 1, column 2 a height that is not finite"
    with pytest.raises(InputError, match=f"{place}: 4 of 16 heights"):
        surfaces.read(file, spacing="5 um", unit="nm")
    assert place in refusal("show", file, "--spacing", "5um", "--unit", "nm")
    with pytest.raises(InputError, match=f"case.toml:5: .*{place}, the first of 4"):
        case_with(file, 'unit = "nm", spacing = ["5 um", "5 um"]')
    filled = surfaces.read(file, spacing="5 um", unit="nm", fill=True).heights
    assert filled.shape == (4, 4)
    np.testing.assert_array_equal(filled[:, 3][:3], 4e-9)
    by_case = heights_of(case_with(file, 'unit = "nm", spacing = ["5 um", "5 um"], fill = true'))
    np.testing.assert_array_equal(by_case, filled)


@pytest.mark.parametrize("ending", ["csv", "txt", "dat", "xyz", "asc"])
def test_lists_of_points_are_read_by_all_names(ending: str, tmp_path: Path) -> None:
    file = tmp_path / f"points.{ending}"
    file.write_text(POINTS)
    shown = call("show", file, "--spacing", "2um,3um", "--unit", "um").output
    assert "5 x 4" in shown
    slope = np.hypot(0.02 / 2, 0.1 / 3)
    assert f"{slope:.6g}" in shown
    read = surfaces.read(file, unit="um")
    assert read.spacing == pytest.approx((2e-6, 3e-6), rel=1e-12)
    np.testing.assert_allclose(read.heights, 1e-6 * (0.1 * np.arange(4)[:, None] + 0.02 * np.arange(5)), atol=1e-18)
    np.testing.assert_array_equal(heights_of(case_with(file, 'unit = "um"')), read.heights)
    assert "tells no unit; give --unit, as um" in refusal("show", file)
    with pytest.warns(brinell.CaseWarning, match="the file has points every 2e-06 x 3e-06 m"):
        assert surfaces.read(file, unit="um", spacing="1 um").spacing == (1e-6, 1e-6)
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        assert surfaces.read(file, unit="nm", spacing="1 um", layout="rows").heights.shape == (20, 3)
    with pytest.raises(InputError, match="layout = 'columns'; allowed: 'rows', 'points'"):
        surfaces.read(file, unit="um", layout="columns")  # type: ignore[arg-type]


def test_a_point_that_is_left_out_is_named_or_filled(tmp_path: Path) -> None:
    file = tmp_path / "gap.xyz"
    lines = [f"{i} {j} {0.01 * (i + j)}" for j in range(3) for i in range(4) if (j, i) != (1, 2)]
    file.write_text("\n".join(lines) + "\n")
    assert "has at x = 2, y = 1 no point: 1 of 12 heights" in refusal("show", file, "--unit", "um")
    filled = surfaces.read(file, unit="um", fill=True).heights
    np.testing.assert_allclose(filled, 1e-8 * (np.arange(4) + np.arange(3)[:, None]), atol=1e-16)  # a plane is harmonic


def arrays(folder: Path) -> dict[str, Path]:
    """Files of [16, 12] numbers without size and unit."""
    numbers = np.random.default_rng(0).normal(size=(16, 12))
    with h5py.File(folder / "heights.h5", "w") as file:
        file["surface"] = numbers
    scipy.io.savemat(folder / "heights.mat", {"heights": numbers})
    np.savetxt(folder / "heights.asc", numbers)
    return {ending: folder / f"heights.{ending}" for ending in ("h5", "mat", "asc")}


@pytest.mark.parametrize("ending", ["h5", "mat", "asc"])
def test_spacing_and_unit_reach_all_formats(ending: str, tmp_path: Path) -> None:
    pytest.importorskip("SurfaceTopography")
    file = arrays(tmp_path)[ending]
    numbers = np.random.default_rng(0).normal(size=(16, 12))
    read = surfaces.read(file, spacing=("1 um", "2 um"), unit="um")
    # SurfaceTopography takes the first index of an array as x; lines of text are rows along x.
    np.testing.assert_allclose(read.heights, 1e-6 * (numbers if ending == "asc" else numbers.T), rtol=1e-12)
    assert read.spacing == (1e-6, 2e-6)
    assert call("show", file, "--spacing", "1um", "--unit", "um").exit_code == 0
    assert "give --spacing, as 1um or 1um,2um" in refusal("show", file, "--unit", "um")
    if ending != "asc":
        assert "tells no unit; give --unit, as um" in refusal("show", file, "--spacing", "1um")


@pytest.mark.parametrize("ending", ["asc", "dat", "txt", "CSV", "xyz"])
def test_formats_of_instruments_are_known_by_their_content(ending: str, tmp_path: Path) -> None:
    pytest.importorskip("SurfaceTopography")
    file = tmp_path / f"scan.{ending}"
    file.write_text(WYKO)
    read = surfaces.read(file, fill=True)
    assert (read.heights.shape, read.spacing) == ((4, 3), pytest.approx((2e-6, 2e-6)))
    assert "1 of 12 heights are not finite" in refusal("show", file)
    with pytest.raises(InputError, match="begins in line 1 with .*surface convert FILE OUT.npy"):
        case_with(file, "spacing = [1e-6, 1e-6]")


def test_a_row_that_is_no_row_is_not_left_out(tmp_path: Path) -> None:
    pytest.importorskip("SurfaceTopography")
    file = tmp_path / "map.txt"
    file.write_text("Measured today\n1 2 3 4\n5 6x 7 8\n1 2 3 4\n1 2 3 4\n1 2 3 4\n")
    assert "has in line 3 '5 6x 7 8'; allowed: a header, or 4 heights" in refusal("show", file, "--spacing", "1um")
    file.write_text("aBCR-0.0\nNumPoints = 4\n*\n1 2 3 4\n")
    assert "is SDF aBCR-0.0, which SurfaceTopography does not read" in refusal("show", file, "--spacing", "1um")


def test_bytes_that_are_no_text_are_named_everywhere(tmp_path: Path) -> None:
    file = tmp_path / "map.csv"
    file.write_bytes("1;2 µ;3\n4;5;6\n".encode("latin-1"))
    told = r'has in line 1 "1;2 \\xb5;3".*surface convert'
    with pytest.raises(InputError, match=told):
        surfaces.read(file, spacing="1 um")
    with pytest.raises(InputError, match=f"case.toml:5: lower.texture.file = .*{told}"):
        case_with(file, "spacing = [1e-6, 1e-6]")
    curve = tmp_path / "curve.csv"
    curve.write_bytes("0;900\n0,01;1000 µ\n".encode("latin-1"))
    with pytest.raises(InputError, match=r"where 1000 \\xb5 is not a number"):
        brinell.Table.from_file(curve, unit="MPa")
    file.write_bytes(bytes([0x88, 0x1B, 3, 0x6F, 0, 1, 0, 0]) + b"1 2 3\n" + bytes(range(256)))
    with pytest.raises(InputError, match="is no text: its byte 2 is 0x1b; .*surface convert FILE OUT.npy"):
        case_with(file, "spacing = [1e-6, 1e-6]")
    assert "as a file of an instrument it has no format" in refusal("show", file, "--spacing", "1um")


def test_a_case_whose_name_is_no_text(tmp_path: Path) -> None:
    file = tmp_path / os.fsdecode(b"c\xb5.toml")
    text = '{ type = "flat" }\nmaterial = { young_modulus = "210 GPa", poisson_ratio = 0.3 }\n'
    file.write_bytes(b'scenario = "indentation"\n[lower]\nshape = ' + text.encode())
    with pytest.raises(InputError, match=r"c\\xb5\.toml:.* is missing"):
        brinell.Case.from_file(file)
    file.write_bytes(b"# 1 \xb5m\n")
    with pytest.raises(InputError, match=r"has in line 1, after .*, the byte 0xb5, which is not UTF-8"):
        brinell.Case.from_file(file)


def test_blanks_and_minus_signs_of_texts(tmp_path: Path) -> None:
    file = tmp_path / "map.csv"
    file.write_text("1\u00a02\n\u22123\u202f4\n", encoding="utf-8")
    read = surfaces.read(file, spacing="2\u2009um", unit="nm")
    np.testing.assert_allclose(read.heights, [[1e-9, 2e-9], [-3e-9, 4e-9]], rtol=1e-15)
    assert read.spacing == (2e-6, 2e-6)
    assert call("show", file, "--spacing", "2\u00a0um", "--unit", "nm").exit_code == 0
    case = case_with(file, 'unit = "nm", spacing = ["2\u202fum", "2\u00a0um"], x = "\u22125\u00a0um"')
    assert "x = -5e-06" in case.to_toml()
    assert "radius = 0.002" in case.with_values({"upper.shape.radius": "2\u00a0mm"}).to_toml()
    moved = brinell.Case(case.to_toml()).with_values(["lower.texture.x=\u22121\u00a0um", "lower.texture.y=\u22121e-6"])
    assert "x = -1e-06" in moved.to_toml()
    assert "y = -1e-06" in moved.to_toml()


def test_a_unit_of_no_length_is_that_of_the_header(tmp_path: Path) -> None:
    file = tmp_path / "volts.txt"
    file.write_text(
        "# Channel: Z\n# Width: 15 µm\n# Height: 10 µm\n# Value units: V\n10 20 30\n40 50 60\n", encoding="utf-8"
    )
    for options in ((), ("--unit", "um")):
        told = refusal("show", file, *options)
        assert 'has in line 4 "# Value units: V": V is no unit of length' in told
        assert "--unit V" not in told
    with pytest.raises(InputError, match=r"has in line 4 "):
        case_with(file, 'unit = "um"')


def test_one_of_several_maps_is_chosen(tmp_path: Path) -> None:
    pytest.importorskip("SurfaceTopography")
    with h5py.File(tmp_path / "two.dat", "w") as file:
        file["fine"], file["coarse"] = np.zeros((4, 6)), np.ones((3, 5))
    two = ("--spacing", "1um", "--unit", "um")
    told = refusal("show", tmp_path / "two.dat", *two)
    assert "holds 2 maps of heights: 0 'coarse' (3 x 5), 1 'fine' (4 x 6); choose one" in told
    assert "--channel 'coarse'" in told
    for name, size in (("fine", "4 x 6"), ("0", "3 x 5")):
        assert size in call("show", tmp_path / "two.dat", "--channel", name, *two).output
    assert "has no map --channel 'rough'; it holds 0 'coarse'" in refusal(
        "show", tmp_path / "two.dat", "--channel", "rough"
    )
    gwyddion = "# Channel: Left\n# Width: 6 µm\n# Height: 4 µm\n# Value units: nm\n1 2 3 4\n5 6 7 8\n"
    several = tmp_path / "several.txt"
    several.write_text(gwyddion + gwyddion.replace("Left", "Right").replace("5 6 7 8", "9 9 9 9"), encoding="utf-8")
    assert "holds 2 maps of heights: 0 'Left' (4 x 2), 1 'Right' (4 x 2)" in refusal("show", several)
    assert surfaces.read(several, channel="Right").heights[1, 3] == pytest.approx(9e-9)
    with pytest.raises(InputError, match="holds several maps, the second from line 7 on"):
        case_with(several, "spacing = [1e-6, 1e-6]")
    np.savez(tmp_path / "arrays.npz", a=np.zeros((2, 3)), b=np.ones((3, 4)))
    assert surfaces.read(tmp_path / "arrays.npz", channel="b", spacing="1 um", unit="nm").heights[0, 0] == 1e-9
    assert "only a, b; name the array" in refusal("show", tmp_path / "arrays.npz")
    surfaces.write(tmp_path / "one.csv", HeightMap(np.zeros((2, 2)), "1 um"))
    assert "has one map; leave out --channel 'x'" in refusal("show", tmp_path / "one.csv", "--channel", "x")


def test_a_container_of_surfaces(tmp_path: Path) -> None:
    topography = pytest.importorskip("SurfaceTopography")
    from SurfaceTopography.Container.IO.CE import write_containers

    maps = [
        topography.Topography(np.full((4, 3), value), (4.0, 3.0), unit="um", info={"name": name})
        for name, value in (("left", 1.0), ("right", 2.0))
    ]
    write_containers([maps], str(tmp_path / "both.zip"))
    assert "holds 2 maps of heights: 0 'left' (4 x 3), 1 'right' (4 x 3)" in refusal("show", tmp_path / "both.zip")
    assert surfaces.read(tmp_path / "both.zip", channel="right").heights[0, 0] == pytest.approx(2e-6)


@pytest.mark.filterwarnings("ignore:Cannot close a netcdf_file:RuntimeWarning")
def test_periods_come_from_the_file(tmp_path: Path) -> None:
    topography = pytest.importorskip("SurfaceTopography")
    heights = np.random.default_rng(1).normal(size=(4, 6))
    for periodic in (True, False):
        map_ = topography.Topography(heights, (4.0, 6.0), unit="um", periodic=periodic)
        map_.to_netcdf(str(tmp_path / "map.nc"))
        assert surfaces.read(tmp_path / "map.nc").periodic is periodic
        assert HeightMap.from_topography(map_).periodic is periodic
    surfaces.write(tmp_path / "map.csv", HeightMap(1e-8 * heights, "1 um", 2e-6, 0.0, periodic=True))
    by_case = case_with(tmp_path / "map.csv", "fill = false").to_toml()
    assert "periodic = true" in by_case
    assert "x = 2e-06" in by_case
    assert "spacing = [1e-06, 1e-06]" in by_case


def test_damaged_archives_and_arrays_are_refused_in_one_line(tmp_path: Path) -> None:
    with zipfile.ZipFile(tmp_path / "map.npz", "w") as archive:
        archive.writestr("heights.npy", b"\x93NUMPY\x01\x00\x10\x00{'descr': ")
        archive.writestr("spacing.npy", b"")
    assert "is damaged, or no file of" in refusal("show", tmp_path / "map.npz")
    np.save(tmp_path / "map.npy", np.zeros((4, 6)))
    content = (tmp_path / "map.npy").read_bytes()
    (tmp_path / "map.npy").write_bytes(content.replace(b"(4, 6)", b"(2, 6)"))
    assert "is damaged: it has" in refusal("show", tmp_path / "map.npy", "--spacing", "1um")
    np.save(tmp_path / "map.npy", np.zeros((4, 6), dtype=complex))
    assert "values of the type complex128; allowed: numbers" in refusal(
        "show", tmp_path / "map.npy", "--spacing", "1um"
    )
    (tmp_path / "map.h5").write_bytes(b"\x89HDF\r\n\x1a\n" + bytes(200))
    refusal("show", tmp_path / "map.h5", "--spacing", "1um")
