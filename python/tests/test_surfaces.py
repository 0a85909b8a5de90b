# SPDX-License-Identifier: BSD-3-Clause
import math
import re
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from brinell import Body, Case, Dent, Flat, Indentation, InputError, IoError, Material, Sphere, surfaces
from brinell.surfaces import HeightMap

CASE = """
scenario = "rolling"
[lower]
shape = { type = "flat" }
[lower.material]
young_modulus = "210 GPa"
poisson_ratio = 0.3
hardening = { law = "linear", yield_stress = "0.9 GPa", modulus = "2 GPa" }
[upper]
shape = { type = "sphere", radius = "10 mm" }
material = { young_modulus = "310 GPa", poisson_ratio = 0.26 }
[rolling]
hertz_pressure = "1.4 GPa"
distance = "0.2 mm"
[grid]
resolution = 3
"""


def wavy(ny: int = 5, nx: int = 7) -> HeightMap:
    """A map without any symmetry."""
    heights = np.random.default_rng(1).normal(scale=2e-7, size=(ny, nx))
    return HeightMap(heights, (2e-5, 3e-5), x=1e-5, y=-2e-5)


def assert_equal(a: HeightMap, b: HeightMap) -> None:
    np.testing.assert_array_equal(a.heights, b.heights)
    assert (a.spacing, a.x, a.y, a.periodic) == (b.spacing, b.x, b.y, b.periodic)


@pytest.mark.parametrize("ending", [".npz", ".csv", ".txt", ".dat"])
@pytest.mark.parametrize("periodic", [False, True])
def test_files_that_hold_all_of_it(tmp_path: Path, ending: str, periodic: bool) -> None:
    written = replace(wavy(), periodic=periodic)
    surfaces.write(tmp_path / f"map{ending}", written)
    assert_equal(surfaces.read(tmp_path / f"map{ending}"), written)


def test_npy_holds_the_heights(tmp_path: Path) -> None:
    path = tmp_path / "map.npy"
    surfaces.write(path, wavy())
    again = surfaces.read(path, spacing=(2e-5, 3e-5))
    np.testing.assert_array_equal(again.heights, wavy().heights)
    assert (again.spacing, again.x, again.y) == ((2e-5, 3e-5), 0.0, 0.0)
    with pytest.raises(InputError, match="give spacing"):
        surfaces.read(path)


def test_text_as_the_case_reads_it(tmp_path: Path) -> None:
    (tmp_path / "map.csv").write_text("# nm\n1e-9, 2e-9, 3e-9\r\n\n4e-9; 5e-9\t6e-9\n")
    heights = surfaces.read(tmp_path / "map.csv", spacing=(1, 1)).heights
    np.testing.assert_array_equal(heights, [[1e-9, 2e-9, 3e-9], [4e-9, 5e-9, 6e-9]])
    with pytest.raises(InputError, match="give spacing"):
        surfaces.read(tmp_path / "map.csv")
    (tmp_path / "map.csv").write_text("# spacing = as in the lab\n1e-9, 2e-9\n")
    with pytest.raises(InputError, match="give spacing"):
        surfaces.read(tmp_path / "map.csv")


@pytest.mark.parametrize(
    ("text", "what"),
    [
        ("1 2\n3\n", 'line 2 "3"; allowed: 2 heights in m or the given unit, as in line 1, not 1'),
        ("1 2\n3 x\n", 'line 2 "3 x"; allowed: 2 heights .*; "x" is no number'),
        ("# none\n", "no heights"),
        (
            "1 nan\n",
            r"1 of 2 heights are not finite, the first one heights\[0, 1\], in row 1 and column 2: fill .* --fill",
        ),
    ],
)
def test_bad_text(tmp_path: Path, text: str, what: str) -> None:
    (tmp_path / "map.csv").write_text(text)
    with pytest.raises(InputError, match=what):
        surfaces.read(tmp_path / "map.csv", spacing=(1, 1))


def test_heights_in_a_unit() -> None:
    np.testing.assert_allclose(HeightMap(np.array([[0.0, 2.0]]), "1 um", unit="nm").heights, [[0.0, 2e-9]])
    with pytest.raises(InputError, match="furlong"):
        HeightMap(np.zeros((2, 2)), "1 um", unit="furlong")


def test_bad_maps(tmp_path: Path) -> None:
    with pytest.raises(InputError, match=r"shape \(3,\)"):
        HeightMap(np.zeros(3), (1.0, 1.0))
    for spacing in ((1.0, 0.0), (1.0,), (1.0, np.nan)):
        with pytest.raises(InputError, match="spacing"):
            HeightMap(np.zeros((2, 2)), spacing)  # type: ignore[arg-type]
    with pytest.raises(IoError, match="no such file"):
        surfaces.read(tmp_path / "none.npz")
    with pytest.raises(InputError, match="cannot write '.xyz'"):
        surfaces.write(tmp_path / "map.xyz", wavy())
    np.savez(tmp_path / "other.npz", z=np.zeros(3))
    with pytest.raises(InputError, match="holds no heights and no spacing, only z"):
        surfaces.read(tmp_path / "other.npz")


def test_levelling_takes_away_a_plane_and_nothing_else() -> None:
    rough = wavy().levelled()
    tilted = HeightMap(
        rough.heights + 3e-6 + 0.01 * rough.x_axis + 0.02 * rough.y_axis[:, None], rough.spacing, rough.x, rough.y
    )
    # Round-off of the plane, 1e-5 m high.
    np.testing.assert_allclose(tilted.levelled().heights, rough.heights, atol=1e-5 * 1e-14, rtol=0)
    terms = np.stack(
        [np.ones((5, 7)), np.broadcast_to(rough.x_axis, (5, 7)), np.broadcast_to(rough.y_axis[:, None], (5, 7))]
    )
    plane = np.linalg.lstsq(terms.reshape(3, -1).T, tilted.heights.ravel(), rcond=None)[0]
    np.testing.assert_allclose(tilted.levelled().heights, tilted.heights - np.tensordot(plane, terms, 1), atol=1e-18)
    line = HeightMap(np.array([[1.0, 2.0, 3.0]]), (1.0, 1.0))
    np.testing.assert_allclose(line.levelled().heights, 0.0, atol=1e-15)


def test_cropping_keeps_each_height_in_its_place() -> None:
    whole = wavy()
    part = whole.cropped(x=(whole.x_axis[2], whole.x_axis[5]), y=(-1.0, whole.y_axis[3]))
    np.testing.assert_array_equal(part.heights, whole.heights[:4, 2:6])
    np.testing.assert_allclose(part.x_axis, whole.x_axis[2:6], rtol=1e-14)
    np.testing.assert_allclose(part.y_axis, whole.y_axis[:4], rtol=1e-14)
    assert_equal(whole.cropped(), whole)
    with pytest.raises(InputError, match="no point has y"):
        whole.cropped(y=(1.0, 2.0))


def test_roughness_of_a_sine() -> None:
    # One period, sampled evenly: Sq = A / sqrt(2) exactly, Sa = 2 A / pi up to (pi / n)^2 / 3.
    n = 1000
    sine = HeightMap(1e-6 * np.sin(2 * np.pi * (np.arange(n) + 0.5) / n) * np.ones((3, 1)) + 5e-6, (1e-6, 1e-6))
    assert sine.Sq == pytest.approx(1e-6 / np.sqrt(2), rel=1e-12)
    assert sine.Sa == pytest.approx(2e-6 / np.pi, rel=(np.pi / n) ** 2)
    assert sine.Sz == pytest.approx(2e-6, rel=(np.pi / n) ** 2)


def history(texture: dict[str, Any], folder: Path) -> Any:
    return Case(CASE, file=folder / "case.toml").with_values({"lower.texture": texture}).run(threads=1).history


def test_a_map_in_the_case_and_in_a_file_are_the_same(tmp_path: Path) -> None:
    surfaces.write(tmp_path / "map.csv", wavy())
    by_file = {key: value for key, value in wavy().to_case().items() if key not in ("heights", "columns")}
    here = history(wavy().to_case(), tmp_path)
    there = history(by_file | {"file": "map.csv"}, tmp_path)
    smooth = history({"type": "smooth"}, tmp_path)
    for name in ("F_n", "dissipation_lower", "contact_area"):
        np.testing.assert_array_equal(here[name], there[name])
    assert not np.array_equal(here["contact_area"], smooth["contact_area"])


def test_the_resolved_case_holds_the_heights(tmp_path: Path) -> None:
    case = Case(CASE).with_values({"lower.texture": wavy().to_case()})
    again = Case(case.to_toml())
    assert again.to_toml() == case.to_toml()
    assert f"columns = {wavy().heights.shape[1]}" in case.to_toml()


scipy_closes_late = pytest.mark.filterwarnings("ignore:Cannot close a netcdf_file:RuntimeWarning")
"""SurfaceTopography closes a NetCDF file while it still holds its heights."""


def instrument_map(unit: str | None, heights: np.ndarray[Any, Any]) -> Any:
    topography = pytest.importorskip("SurfaceTopography")
    ny, nx = heights.shape
    return topography.Topography(heights.T, (nx * 20.0, ny * 30.0), unit=unit)


@scipy_closes_late
def test_a_file_of_an_instrument(tmp_path: Path) -> None:
    heights = wavy().heights * 1e6
    instrument_map("um", heights).to_netcdf(str(tmp_path / "map.nc"))
    read = surfaces.read(tmp_path / "map.nc")
    np.testing.assert_allclose(read.heights, heights * 1e-6, rtol=1e-15)
    assert read.spacing == pytest.approx((20e-6, 30e-6), rel=1e-14)
    with pytest.raises(InputError, match="tells its unit, µm"):
        surfaces.read(tmp_path / "map.nc", unit="nm")


def test_a_file_without_a_unit(tmp_path: Path) -> None:
    pytest.importorskip("SurfaceTopography")
    lines = [f"{20 * i} {30 * j} {10 * i + j}" for i in range(4) for j in range(3)]
    (tmp_path / "map.xyz").write_text("\n".join(lines) + "\n")
    with pytest.raises(InputError, match="tells no unit"):
        surfaces.read(tmp_path / "map.xyz")
    with pytest.raises(InputError, match="unit = 'parsnip' is no unit of length; allowed: m, "):
        surfaces.read(tmp_path / "map.xyz", unit="parsnip")
    read = surfaces.read(tmp_path / "map.xyz", unit="um")
    expected = 1e-6 * (10 * np.arange(4) + np.arange(3)[:, None])  # [y, x]
    np.testing.assert_allclose(read.heights, expected, rtol=1e-14)
    assert read.spacing == pytest.approx((20e-6, 30e-6), rel=1e-14)


@scipy_closes_late
def test_points_that_were_not_measured(tmp_path: Path) -> None:
    plane = 1.0 + np.arange(6.0) + 2 * np.arange(5.0)[:, None]
    holed = np.ma.masked_array(plane, mask=np.zeros_like(plane, dtype=bool))
    holed[2, 3] = np.ma.masked
    instrument_map("um", holed).to_netcdf(str(tmp_path / "map.nc"))
    with pytest.raises(InputError, match="1 of 30 heights are not finite"):
        surfaces.read(tmp_path / "map.nc")
    # A plane is harmonic, so it is what fills the hole.
    filled = surfaces.read(tmp_path / "map.nc", fill=True)
    np.testing.assert_allclose(filled.heights, plane * 1e-6, rtol=1e-12)


def test_the_unit_of_a_text_is_honoured(tmp_path: Path) -> None:
    path = tmp_path / "map.csv"
    path.write_text("0,10,0\n0,20,0\n")
    read = surfaces.read(path, spacing=(1e-6, 1e-6), unit="nm")
    np.testing.assert_allclose(read.heights, [[0, 10e-9, 0], [0, 20e-9, 0]], rtol=1e-15)
    np.testing.assert_array_equal(surfaces.read(path, spacing=(1, 1)).heights, [[0, 10, 0], [0, 20, 0]])  # m
    with pytest.raises(InputError, match="no unit of length"):
        surfaces.read(path, spacing=(1, 1), unit="GPa")
    np.save(tmp_path / "map.npy", np.array([[0, 10, 0], [0, 20, 0]]))
    again = surfaces.read(tmp_path / "map.npy", spacing=(1e-6, 1e-6), unit="nm")
    np.testing.assert_array_equal(again.heights, read.heights)
    surfaces.write(tmp_path / "map.npz", read)
    with pytest.raises(InputError, match="holds heights in m; leave out unit = 'nm'"):
        surfaces.read(tmp_path / "map.npz", unit="nm")


def test_text_of_gwyddion(tmp_path: Path) -> None:
    path = tmp_path / "map.txt"
    header = "# Channel: Topography\n# Width: 90.00\N{NO-BREAK SPACE}µm\n# Height: 40 um\n# Value units: nm\n"
    path.write_text(header + "0 10 0\n0 20 0\n", encoding="utf-8")
    read = surfaces.read(path)
    np.testing.assert_allclose(read.heights, [[0, 10e-9, 0], [0, 20e-9, 0]], rtol=1e-15)
    assert read.spacing == pytest.approx((30e-6, 20e-6))
    assert surfaces.read(path, spacing=(1e-6, 1e-6)).spacing == (1e-6, 1e-6)
    with pytest.raises(InputError, match="tells its unit, nm; leave out unit = 'um'"):
        surfaces.read(path, unit="um")
    path.write_text(header.replace("90.00", "wide") + "0 10 0\n", encoding="utf-8")
    with pytest.raises(InputError, match="in its header; allowed: a length"):
        surfaces.read(path)


def test_an_object_of_surface_topography() -> None:
    topography = pytest.importorskip("SurfaceTopography")
    heights = np.arange(12.0).reshape(3, 4)
    object_ = topography.Topography(heights.T, (80.0, 90.0), unit="um")
    read = surfaces.HeightMap.from_topography(object_)
    np.testing.assert_allclose(read.heights, heights * 1e-6)
    assert read.spacing == pytest.approx((20e-6, 30e-6))
    assert repr(read) == "<HeightMap 4 x 3 points every 2e-05 x 3e-05 m, Sz = 1.1e-05 m>"
    with pytest.raises(InputError, match="tells no unit"):
        surfaces.HeightMap.from_topography(topography.Topography(heights.T, (80.0, 90.0)))
    with pytest.raises(InputError, match="line scan"):
        surfaces.HeightMap.from_topography(topography.UniformLineScan(heights[0], 80.0, unit="um"))


def test_a_map_of_surface_topography_is_a_texture() -> None:
    topography = pytest.importorskip("SurfaceTopography")
    heights = wavy().heights
    ny, nx = heights.shape
    measured = topography.Topography(1e6 * heights.T, (nx * 20.0, ny * 30.0), unit="um")
    steel = Material("210 GPa", 0.3)
    ours = surfaces.HeightMap.from_topography(measured).to_case()
    assert Body(Flat(), steel, measured).to_case()["texture"] == ours
    several = Body(Flat(), steel, texture=[Dent("1 um", edge_radius="12.5 um"), measured]).to_case()
    assert several["texture"][1] == ours
    ball = Body(Sphere("1 mm"), steel)
    case = Indentation(Body(Flat(), steel), ball, load=["1 N"])
    with_map = case.with_values({"lower.texture": measured})
    assert with_map.to_toml() == case.with_values({"lower.texture": ours}).to_toml()
    with pytest.raises(InputError, match="tells no unit; .*HeightMap.from_topography takes unit and fill"):
        Body(Flat(), steel, topography.Topography(heights.T, (80.0, 90.0)))
    gaps = topography.Topography(np.ma.masked_greater(heights.T, heights.mean()), (80.0, 90.0), unit="um")
    with pytest.raises(InputError, match="not finite, .*: fill what was not measured, .* unit and fill"):
        Body(Flat(), steel, gaps)


def test_no_map_at_all(tmp_path: Path) -> None:
    pytest.importorskip("SurfaceTopography")
    (tmp_path / "map.foo").write_text("hello world\n")
    with pytest.raises(InputError, match="no format that SurfaceTopography knows"):
        surfaces.read(tmp_path / "map.foo")


def test_without_the_extra_the_error_tells_what_to_install(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(__import__("sys").modules, "SurfaceTopography", None)
    (tmp_path / "map.asc").write_text("Wyko ASCII Data File Format\t0\t1\n")
    with pytest.raises(ImportError, match=r'pip install "brinell\[surfaces\]"'):
        surfaces.read(tmp_path / "map.asc", unit="um")
    (tmp_path / "map.xyz").write_text("0 0 1\n0 1 2\n1 0 3\n1 1 4\n")  # points need no other package
    assert surfaces.read(tmp_path / "map.xyz", unit="um").heights.shape == (2, 2)


def test_sampled_function() -> None:
    def height(x: float, y: float) -> float:
        return 1e-6 * math.cos(x / 1e-4) + 0.01 * y

    texture = surfaces.sampled(height, (1e-5, 3e-5), x=(-1e-4, 3e-4), y=(0.0, 1e-4))
    assert texture.heights.shape == (5, 41)  # dy is made smaller to fit
    assert texture.spacing == pytest.approx((1e-5, 2.5e-5))
    assert (texture.x_axis[0], texture.x_axis[-1]) == pytest.approx((-1e-4, 3e-4))
    assert texture.heights[3, 7] == pytest.approx(height(texture.x_axis[7], texture.y_axis[3]))
    case = Case(CASE).with_values({"lower.texture": texture.to_case()})
    assert case.to_toml() == Case(case.to_toml()).to_toml()


@pytest.mark.parametrize(
    ("function", "intervals", "message"),
    [
        (lambda x, y: "high", {"x": (0, 1), "y": (0, 1)}, "'high'; allowed: a number"),
        (lambda x, y: math.inf, {"x": (0, 1), "y": (0, 1)}, "x = 0.0 m, y = 0.0 m is inf; allowed: finite"),
        (lambda x, y: x, {"x": (1, 0), "y": (0, 1)}, "from < to"),
    ],
)
def test_sampled_refuses(function: Any, intervals: Any, message: str) -> None:
    with pytest.raises(InputError, match=re.escape(message)):
        surfaces.sampled(function, (0.5, 0.5), **intervals)
