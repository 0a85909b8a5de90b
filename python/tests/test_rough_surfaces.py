# SPDX-License-Identifier: BSD-3-Clause
"""Roughness: made, measured, drawn, on the command line and in cases."""

from __future__ import annotations

import sys
import warnings
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from click.testing import CliRunner

import brinell
from brinell import Case, InputError, plot, surfaces
from brinell._toml import tomllib
from brinell.surface_commands import surface as command
from brinell.surfaces import HeightMap
from figure_parts import texts

STEEL = brinell.Material("200 GPa", 0.3)
ROUGH = brinell.RandomSurface(cutoff="16 um", rms_height="10 nm", rolloff="40 um")
DENT = brinell.Dent("0.1 um", edge_radius="10 um")


def rough(points: int = 128, **changes: Any) -> HeightMap:
    given: dict[str, Any] = {"cutoff": "20 um", "rms_height": "0.2 um", "rolloff": "100 um", "hurst": 0.7, "seed": 3}
    return surfaces.random("0.4 mm", points, **(given | changes))


def press(texture: Any) -> brinell.Indentation:
    lower = brinell.Body(brinell.Flat(), STEEL, texture=texture)
    return brinell.Indentation(
        lower=lower,
        upper=brinell.Body(brinell.Sphere("2 mm"), brinell.RIGID),
        load=["0.5 N"],
        normalised=False,
        steps=2,
    )


def test_heights_are_those_of_the_engine() -> None:
    # Its height at the origin, by tools/oracles/random_surface.py.
    one = surfaces.random((240e-6, 180e-6), 1, cutoff=7e-6, rms_height=2e-7, hurst=0.7, rolloff="60 um", seed=5)
    assert one.heights[0, 0] == pytest.approx(-2.8595662810424704e-07, rel=1e-12)
    assert one.periodic
    assert one.size == (240e-6, 180e-6)


def test_more_points_show_the_same_surface() -> None:
    # Of 3 times as many points each third lies where one of the fewer is.
    coarse, fine = rough(40), rough(120)
    np.testing.assert_allclose(fine.heights[1::3, 1::3], coarse.heights, rtol=0, atol=1e-12 * coarse.Sq)
    np.testing.assert_allclose(fine.x_axis[1::3], coarse.x_axis, rtol=1e-12)


def test_rms_are_those_that_were_asked() -> None:
    assert rough().Sq == pytest.approx(2e-7, rel=1e-12)
    steep = rough(512, rms_height=None, rms_slope=0.03)
    # Differences of neighbours miss (q dx)^2/24 of the slope, most of the shortest wave: 0.06^2/6.
    assert steep.Sdq == pytest.approx(0.03, rel=1e-3)
    assert steep.Sdq < 0.03


def test_the_spectrum_holds_the_mean_square_height() -> None:
    made = rough()
    spectrum = made.power_spectrum()
    cell = (2 * np.pi / made.size[0]) * (2 * np.pi / made.size[1])
    assert (spectrum.density * spectrum.count).sum() * cell / (4 * np.pi**2) == pytest.approx(made.Sq**2, rel=1e-12)
    cutoff = 2 * np.pi / 20e-6
    assert spectrum.density[spectrum.wavenumber > 1.1 * cutoff].max() < 1e-20 * spectrum.density.max()
    falls = (spectrum.wavenumber > 1.5 * 2 * np.pi / 100e-6) & (spectrum.wavenumber < 0.9 * cutoff)
    slope = np.polyfit(np.log(spectrum.wavenumber[falls]), np.log(spectrum.density[falls]), 1)[0]
    # A ring of n waves scatters by sqrt(2/n), n some 20 to 120: the line through 11 of them by about 0.15.
    assert slope == pytest.approx(-2 * 1.7, abs=0.5)


def test_a_map_without_a_period_has_the_same_spectrum() -> None:
    made = rough(256)
    periodic, windowed = made.power_spectrum(), replace(made, periodic=False).power_spectrum()
    inside = (periodic.wavenumber > 2 * np.pi / 150e-6) & (periodic.wavenumber < 2 * np.pi / 25e-6)
    # Hann's window leaves fewer independent waves; over all of these rings some hundred.
    assert np.log(windowed.density[inside] / periodic.density[inside]).mean() == pytest.approx(0.0, abs=0.2)


@pytest.mark.parametrize("periodic", [True, False])
def test_slope_and_curvature_are_those_of_SurfaceTopography(periodic: bool) -> None:
    topography = pytest.importorskip("SurfaceTopography")
    made = replace(rough(64), periodic=periodic)
    theirs = topography.Topography(made.heights.T, made.size, periodic=periodic)
    if periodic:  # without a period their differences are of another order at the edge
        assert made.Sdq == pytest.approx(theirs.rms_gradient(), rel=1e-12)
        assert made.rms_curvature == pytest.approx(theirs.rms_curvature_from_area(), rel=1e-12)
    assert made.Sq == pytest.approx(theirs.rms_height_from_area(), rel=1e-12)


def test_curvature_without_a_period() -> None:
    x = np.arange(9.0) * 1e-6
    bowl = HeightMap(0.5 * (x**2 / 1e-3 + x[:, None] ** 2 / 2e-3), (1e-6, 1e-6))
    assert bowl.rms_curvature == pytest.approx(0.5 * (1 / 1e-3 + 1 / 2e-3), rel=1e-9)
    ramp = HeightMap(np.broadcast_to(3e-3 * x, (4, 9)) + 4e-3 * x[:4, None], (1e-6, 1e-6))
    assert ramp.Sdq == pytest.approx(5e-3, rel=1e-12)


def test_moments_and_bearing_area() -> None:
    steps = HeightMap(np.array([[0.0, 0.0, 0.0, 4.0]]), (1.0, 1.0))
    # Two heights, -1 and 3 about the mean, with shares 3/4 and 1/4.
    assert steps.Sq == pytest.approx(np.sqrt(3.0))
    assert steps.Ssk == pytest.approx(6.0 / 3.0**1.5)
    assert steps.Sku == pytest.approx(21.0 / 9.0)
    share, height = steps.bearing_area()
    np.testing.assert_allclose(share, [0.125, 0.375, 0.625, 0.875])
    np.testing.assert_allclose(height, [3.0, -1.0, -1.0, -1.0])


def test_bearing_curve_of_known_shape() -> None:
    even = HeightMap(np.linspace(0.0, 2e-6, 400).reshape(20, 20), (1e-6, 1e-6))
    assert even.Sk == pytest.approx(2e-6 * 400 / 399)  # straight: all core
    assert even.Spk == even.Svk == pytest.approx(0.0, abs=1e-12)
    plateau = np.zeros((10, 10))
    plateau[0] = 3e-6  # a tenth stands out
    stands_out = HeightMap(plateau, (1e-6, 1e-6))
    assert (stands_out.Sk, stands_out.Svk) == (0.0, 0.0)
    assert stands_out.Spk == pytest.approx(6e-6)
    assert (stands_out.Smr1, stands_out.Smr2) == (pytest.approx(0.1), 1.0)
    gaussian = HeightMap(np.random.default_rng(4).normal(0.0, 1e-7, (300, 300)), (1e-6, 1e-6))
    assert gaussian.Sk / gaussian.Sq == pytest.approx(2.574, rel=0.02)
    assert gaussian.Spk / gaussian.Sq == pytest.approx(0.945, rel=0.04)  # of some thousand peaks
    assert gaussian.Svk / gaussian.Sq == pytest.approx(0.945, rel=0.04)


def test_ends_that_are_joined_go_over_into_each_other() -> None:
    whole = rough(256)
    cut = replace(whole, heights=whole.heights[:201, :181], periodic=False).levelled()
    joined = cut.joined(24 * whole.spacing[0])
    assert joined.periodic
    assert joined.heights.shape == (201 - 24, 181 - 24)
    inside = slice(24, None)
    assert joined.heights[inside, inside] == pytest.approx(cut.heights[24:177, 24:157], abs=1e-15)
    # Over the ends it rises no more than anywhere.
    rise = np.abs(np.diff(joined.heights, axis=1)).max()
    assert np.abs(joined.heights[:, 0] - joined.heights[:, -1]).max() <= 1.01 * rise
    assert joined.Sq == pytest.approx(cut.Sq, rel=0.1)
    for strip in (1e-12, 1.0):
        with pytest.raises(InputError, match="one point to half of the map"):
            cut.joined(strip)


@pytest.mark.parametrize(
    ("changes", "message"),
    [
        ({"hurst": 1.5}, "hurst = 1.5"),
        ({"rms_slope": 0.1}, "rms_height or rms_slope, one of them"),
        ({"cutoff": "1 mm"}, "not longer than the size"),
        ({"cutoff": "1 MPa"}, '"1 MPa" is a pressure; allowed: a length'),
        ({"cutoff": "7"}, '"7" has no unit'),
        ({"seed": -1}, "seed = -1"),
        ({"points": 0}, "0 x 0 points"),
        ({"points": (1, 2, 3)}, "one for both axes, or two"),
    ],
)
def test_refusals(changes: dict[str, Any], message: str) -> None:
    with pytest.raises(InputError, match=message.replace('"', ".")):
        rough(**changes)


def test_the_figure_shows_all_four() -> None:
    made = rough()
    fig = plot.surface(made, title="mine.npz")
    shown, spectrum, distribution, bearing = fig.axes[:4]
    assert shown.images[0].get_array() is not None
    assert (spectrum.get_xscale(), spectrum.get_yscale()) == ("log", "log")
    line = next(line for line in bearing.lines if line.get_gid() == "bearing")
    height = np.asarray(line.get_ydata())
    assert height[0] - height[-1] == pytest.approx(1e6 * made.Sz, rel=1e-9) or height[0] - height[-1] == pytest.approx(
        1e9 * made.Sz, rel=1e-9
    )
    assert "kurtosis" in distribution.get_title(loc="left")
    assert "mine.npz" in texts(fig)
    with pytest.raises(InputError, match="flat"):
        plot.surface(HeightMap(np.zeros((8, 8)), (1.0, 1.0)))


def call(*arguments: str) -> Any:
    return CliRunner().invoke(command, [str(argument) for argument in arguments])


def test_make_show_convert(tmp_path: Path) -> None:
    made = tmp_path / "made.csv"
    options = ["--size", "0.4mm", "--cells", "64", "--cutoff", "20um", "--rms-height", "0.2 um", "--rolloff", "100um"]
    done = call("make", made, *options, "--hurst", "0.7", "--seed", "3")
    assert done.exit_code == 0, done.output
    np.testing.assert_array_equal(surfaces.read(made).heights, rough(64).heights)
    again = call("convert", made, tmp_path / "other.npz")
    assert again.exit_code == 0, again.output
    assert surfaces.read(tmp_path / "other.npz").periodic
    told = call("show", tmp_path / "other.npz", "--figure", tmp_path / "other.png")
    assert told.exit_code == 0, told.output
    assert "Sq         2e-07 m" in told.output
    assert "64 x 64" in told.output
    assert (tmp_path / "other.png").stat().st_size > 10_000


def test_warnings_are_told_as_by_other_commands(tmp_path: Path) -> None:
    file = tmp_path / "in_nm.csv"
    np.savetxt(file, 50.0 * np.random.default_rng(1).standard_normal((8, 8)), delimiter=",")
    told = call("show", file, "--spacing", "1um")
    assert told.exit_code == 0
    assert told.stderr.startswith(f"brinell: warning: {file}: the height map has a root mean square height of")
    assert told.stderr.count("\n") == 1
    assert "are in m; --unit um takes heights in another unit" in told.stderr
    assert call("convert", file, tmp_path / "out.npy", "--spacing", "1um", "--unit", "nm").stderr == ""


def test_points_that_lose_waves_are_told() -> None:
    with pytest.warns(
        brinell.CaseWarning, match=r"points at 1.56e-05 m do not show waves down to the cutoff of 4e-06 m"
    ):
        surfaces.random("1 mm", 64, cutoff="4 um", rms_height="0.2 um")
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        surfaces.random("1 mm", 64, cutoff="40 um", rms_height="0.2 um")


def test_a_missing_file_is_a_wrong_request(tmp_path: Path) -> None:
    assert call("show", tmp_path / "none.txt").exit_code == 2


def test_holes_of_any_file_are_filled(tmp_path: Path) -> None:
    file, out = tmp_path / "holed.npy", tmp_path / "whole.npy"
    np.save(file, np.array([[1e-7, 2e-7, 3e-7], [2e-7, np.nan, 4e-7], [3e-7, 4e-7, 5e-7]]))
    refused = call("convert", file, out, "--spacing", "1um")
    assert refused.exit_code == 2
    assert refused.stderr.endswith("fill what was not measured, as --fill does by a smooth surface\n")
    assert call("convert", file, out, "--spacing", "1um", "--fill").exit_code == 0
    assert np.load(out)[1, 1] == pytest.approx(3e-7)


def test_heights_alone_need_no_spacing(tmp_path: Path) -> None:
    """As the remedy runs that a case names for a map with gaps."""
    file, out = tmp_path / "holed.csv", tmp_path / "whole.npy"
    file.write_text("0,1;0,2;0,3\n0,2;NaN;0,4\n0,3;0,4;0,5\n", encoding="utf-8")
    done = call("convert", file, out, "--fill", "--unit", "um")
    assert done.exit_code == 0, done.stderr
    np.testing.assert_allclose(np.load(out), 1e-7 * (np.arange(3) + np.arange(1, 4)[:, None]))


@pytest.mark.parametrize(
    ("options", "text"),
    [
        ([], "a .npy file has no spacing; give --spacing, as 1um or 1um,2um"),
        (["--spacing", "1um", "--unit", "furlong"], "--unit furlong is no unit of length; allowed: m, cm,"),
    ],
)
def test_errors_name_options_and_not_arguments(tmp_path: Path, options: list[str], text: str) -> None:
    np.save(tmp_path / "flat.npy", np.zeros((3, 3)))
    refused = call("show", tmp_path / "flat.npy", *options)
    assert refused.exit_code == 2
    assert text in refused.stderr


def test_show_needs_what_a_file_does_not_tell(tmp_path: Path) -> None:
    np.save(tmp_path / "tilted.npy", np.arange(5.0) * 1e-6 + np.arange(4.0)[:, None] * 2e-6)
    refused = call("show", tmp_path / "tilted.npy")
    assert refused.exit_code == 2
    assert refused.output.count("\n") == 1
    assert "has no spacing" in refused.output
    told = call("show", tmp_path / "tilted.npy", "--spacing", "2um,3um")
    assert "spacing    2e-06 m x 3e-06 m" in told.output
    level = call("show", tmp_path / "tilted.npy", "--spacing", "2um", "--level")
    assert float(level.output.split("Sq")[1].split()[0]) < 1e-20


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (["show", "none.npz"], "no such file"),
        (["show", "none.npz", "--figure", "x.gif"], "cannot draw '.gif'"),
        (["make", "x.npz", "--size", "1mm", "--cells", "8", "--cutoff", "0.1mm"], "rms_height or rms_slope"),
        (["make", "x.foo", "--size", "1mm", "--cells", "8", "--cutoff", "0.1mm", "--rms-slope", "0.1"], "cannot write"),
        (["make", "x.npz", "--size", "1 N", "--cells", "8", "--cutoff", "0.1mm"], "is a force; allowed: a length"),
        (["make", "x.npz", "--size", "1mm,2mm,3mm", "--cells", "8", "--cutoff", "0.1mm"], "has 3 parts"),
    ],
)
def test_what_the_commands_refuse(arguments: list[str], message: str, tmp_path: Path) -> None:
    in_folder = [str(tmp_path / word) if word.startswith(("x.", "none.")) else word for word in arguments]
    refused = call(*in_folder)
    assert refused.exit_code in (1, 2) if message == "no such file" else refused.exit_code == 2
    assert message in refused.output
    assert list(tmp_path.iterdir()) == []


def test_an_instrument_without_its_reader(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "SurfaceTopography", None)
    (tmp_path / "map.opd").write_bytes(b"OPD")
    refused = call("show", tmp_path / "map.opd")
    assert (refused.exit_code, refused.output.count("\n")) == (2, 1)
    assert 'pip install "brinell[surfaces]"' in refused.output


def test_textures_of_a_body() -> None:
    one = press(ROUGH)
    assert tomllib.loads(one.to_toml())["lower"]["texture"]["cutoff"] == 16e-6
    several = tomllib.loads(press([ROUGH, DENT, brinell.Sinusoid(1e-8, wavelength_x="30 um")]).to_toml())
    assert [texture["type"] for texture in several["lower"]["texture"]] == ["random", "dent", "sinusoid"]
    assert "wavelength_y" not in several["lower"]["texture"][2]
    for wrong in ([ROUGH, 3], brinell.RandomSurface, ["rough"]):
        with pytest.raises(InputError, match="texture = .* of a body"):
            press(wrong)


def test_a_list_of_textures_runs_and_is_stored() -> None:
    both = press([ROUGH, DENT]).run()
    assert [texture["type"] for texture in both.case("lower", "texture")] == ["random", "dent"]
    assert plot.load_depth([both]).axes
    again = Case(press(DENT).to_toml()).with_values({"lower.texture": [ROUGH, DENT]}).run()
    np.testing.assert_array_equal(again.history["approach"], both.history["approach"])
    deeper = Case(press([ROUGH, DENT]).to_toml()).with_values({"lower.texture[1].depth": "0.2 um"})
    assert tomllib.loads(deeper.to_toml())["lower"]["texture"][1]["depth"] == 2e-7


def test_a_map_of_the_surface_is_the_texture() -> None:
    as_texture = press(brinell.RandomSurface("40 um", "10 nm", size=["0.4 mm", "0.4 mm"]))
    grid = {"spacing": [2e-6, 2e-6, 2e-6]}
    surface = surfaces.random("0.4 mm", 200, cutoff="40 um", rms_height="10 nm")
    first = Case(as_texture.to_toml()).with_values({"grid": grid}).run()
    second = Case(press(surface).to_toml()).with_values({"grid": grid}).run()
    # Linear between its points the map misses up to (q dx)^2/8 of a wave, 1.2 % of the shortest; heights reach 3 rms.
    np.testing.assert_allclose(first.history["approach"], second.history["approach"], rtol=0, atol=0.012 * 3 * 1e-8)


@pytest.mark.parametrize("kind", [brinell.Dent, brinell.Bump])
def test_the_earlier_radius_of_a_dent_is_converted(kind: Any) -> None:
    for given, named in [(("1 um", "200 um"), {}), (("1 um",), {"radius": "200 um"})]:
        with pytest.raises(brinell.InputError, match="edge_radius = 0.25 x radius"):
            kind(*given, **named)
    assert kind("1 um", edge_radius="50 um").to_case()["edge_radius"] == "50 um"
