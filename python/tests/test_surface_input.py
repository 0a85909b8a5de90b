# SPDX-License-Identifier: BSD-3-Clause
"""What surfaces may be given as: lengths with units, texts of other countries, heights in the wrong unit."""

from __future__ import annotations

import re
import warnings
from pathlib import Path

import numpy as np
import pytest

import brinell
from brinell import InputError, IoError, _core, surfaces
from brinell.surfaces import HeightMap


def test_lengths_are_numbers_or_text_and_one_stands_for_both(tmp_path: Path) -> None:
    heights = np.zeros((3, 4))
    expected = (1e-6, 1e-6)
    for spacing in (1e-6, "1 um", ("1 um", "1 um"), [1e-6, "1 um"], np.array(expected)):
        assert HeightMap(heights, spacing).spacing == pytest.approx(expected, rel=1e-15)  # type: ignore[arg-type]
    file = tmp_path / "heights.npy"
    np.save(file, heights)
    assert surfaces.read(file, spacing=("1 um", "3 um")).spacing == pytest.approx((1e-6, 3e-6), rel=1e-15)
    assert surfaces.read(file, spacing="1 um").spacing == pytest.approx(expected, rel=1e-15)
    for bad in ("1 Pa", "one", (1e-6, 1e-6, 1e-6), -1e-6, (0.0, 1e-6), None):
        with pytest.raises(InputError, match=re.escape("allowed: (dx, dy), both > 0, in m or with a unit as '1 um'")):
            HeightMap(heights, bad)  # type: ignore[arg-type]


def test_refusals_of_gaps_name_what_fills_them() -> None:
    heights = np.zeros((2, 2))
    with pytest.raises(InputError, match=re.escape("numpy.ma.filled(values, 0.0)")):
        HeightMap(np.ma.masked_array(heights, mask=np.eye(2)), 1e-6)  # type: ignore[arg-type]
    heights[0, 0] = np.nan
    for remedy in ("surfaces.read(file, fill=True)", "brinell surface convert --fill", "surfaces.filled(heights)"):
        with pytest.raises(InputError, match=re.escape(remedy)):
            HeightMap(heights, 1e-6)  # type: ignore[arg-type]


def test_holes_are_filled_by_a_harmonic_surface() -> None:
    """x^2 - y^2 and x y obey the difference equation exactly; across the edge of a map the slope is 0."""
    y, x = np.mgrid[0:40, 0:60].astype(float)
    heights = 1e6 + x**2 - y**2 + 3.0 * x * y
    holed = heights.copy()
    holed[5:20, 10:30] = np.nan
    holed[30, 50] = np.inf
    np.testing.assert_allclose(surfaces.filled(holed), heights, rtol=0.0, atol=1e-6 * np.ptp(heights))
    masked = np.ma.masked_array(heights, mask=~np.isfinite(holed))
    np.testing.assert_array_equal(surfaces.filled(masked), surfaces.filled(holed))
    flat = np.full((6, 8), 2.0)
    flat[:3, :5] = np.nan
    np.testing.assert_allclose(surfaces.filled(flat), 2.0, rtol=1e-12)
    np.testing.assert_array_equal(surfaces.filled(heights), heights)
    with pytest.raises(InputError, match="nothing to fill the map from"):
        surfaces.filled(np.full((3, 3), np.nan))


@pytest.mark.parametrize("ending", ["npy", "csv", "txt", "npz"])
def test_every_kind_of_file_can_be_filled(tmp_path: Path, ending: str) -> None:
    plane = 1e-7 * (1.0 + np.arange(6.0) + 2.0 * np.arange(5.0)[:, None])
    holed = plane.copy()
    holed[2, 3] = np.nan
    file = tmp_path / f"map.{ending}"
    if ending == "npy":
        np.save(file, holed)
    elif ending == "npz":
        np.savez(file, heights=holed, spacing=(1e-6, 1e-6))
    else:
        np.savetxt(file, holed, delimiter="," if ending == "csv" else " ")
    spacing = None if ending == "npz" else "1 um"
    with pytest.raises(InputError, match=r"heights\[2, 3\], in row 3 and column 4"):
        surfaces.read(file, spacing=spacing)
    np.testing.assert_allclose(surfaces.read(file, spacing=spacing, fill=True).heights, plane, rtol=1e-12)


def test_heights_in_another_unit_than_spacing_are_told(tmp_path: Path) -> None:
    file = tmp_path / "plain_nm.csv"
    heights = 50.0 * np.random.default_rng(1).standard_normal((8, 8))
    np.savetxt(file, heights, delimiter=",")
    with pytest.warns(brinell.CaseWarning, match="is a unit missing") as told:
        surfaces.read(file, spacing=(1e-6, 1e-6))
    assert told[0].filename == __file__
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        assert surfaces.read(file, spacing=(1e-6, 1e-6), unit="nm").Sq == pytest.approx(heights.std() * 1e-9)


def test_a_german_text_of_gwyddion(tmp_path: Path) -> None:
    file = tmp_path / "messung.txt"
    head = "# Kanal: Höhe\n# Breite: 4,0 µm\n# Höhe: 2,0 µm\n"
    rows = "1,5e-7\t2,5e-7\n3\t-4,25e-7\n"
    file.write_text(f"{head}# Werteinheiten: m\n{rows}", encoding="utf-8")
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", brinell.CaseWarning)  # of the 3 m, which have no comma
        read = surfaces.read(file)
    assert read.spacing == pytest.approx((2e-6, 1e-6), rel=1e-12)
    np.testing.assert_array_equal(read.heights, [[1.5e-7, 2.5e-7], [3.0, -4.25e-7]])
    file.write_text(head + rows, encoding="utf-8")
    with pytest.raises(InputError, match="no line '# Value units: m'.*# Werteinheiten:"):
        surfaces.read(file)
    assert surfaces.read(file, unit="nm").heights[0, 0] == pytest.approx(1.5e-16)


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("1,2\n3,4\n", [[1, 2], [3, 4]]),
        ("1,2;3,4\n", [[1.2, 3.4]]),
        ("1;2,5\n", [[1, 2.5]]),
        ("1,5 2\n3 4,5\n", [[1.5, 2], [3, 4.5]]),
        ("0,5;\n1,5;\n", [[0.5], [1.5]]),
        ("1,2,3\n", [[1, 2, 3]]),
    ],
)
def test_commas_between_numbers_stay(tmp_path: Path, text: str, expected: list[list[float]]) -> None:
    file = tmp_path / "heights.csv"
    file.write_text(text, encoding="utf-8")
    np.testing.assert_array_equal(surfaces.read(file, spacing=(1.0, 1.0)).heights, expected)


@pytest.mark.skipif(not Path("/proc/self/mem").exists(), reason="needs a file of Linux that cannot be read")
@pytest.mark.parametrize("ending", ["txt", "npy", "npz"])
def test_a_file_that_cannot_be_read_is_named(tmp_path: Path, ending: str) -> None:
    file = tmp_path / f"heights.{ending}"
    file.symlink_to("/proc/self/mem")  # a regular file whose first bytes are never readable
    with pytest.raises(IoError, match=rf"heights\.{ending}: cannot be read: Input/output error"):
        surfaces.read(file, spacing="1 um")


def test_units_of_case_files_are_units_of_surfaces() -> None:
    for unit in ("m", "cm", "mm", "um", "nm", "pm", "angstrom", "Å", "in", "inch"):
        surface = brinell.HeightMap([[0.0, 1.0], [2.0, 0.0]], (1e3, 1e3), unit=unit)
        assert surface.heights[1, 0] - surface.heights[0, 0] == pytest.approx(2 * _core.length(f"1 {unit}"), rel=1e-15)
