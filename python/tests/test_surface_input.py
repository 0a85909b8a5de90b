# SPDX-License-Identifier: BSD-3-Clause
"""What surfaces may be given as: lengths with units, texts of other countries, heights in the wrong unit."""

from __future__ import annotations

import re
import warnings
from pathlib import Path

import numpy as np
import pytest

import brinell
from brinell import InputError, surfaces
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
    with pytest.raises(InputError, match=re.escape("surfaces.read(file, fill=True)")):
        HeightMap(heights, 1e-6)  # type: ignore[arg-type]


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
    [("1,2\n3,4\n", [[1, 2], [3, 4]]), ("1,2;3,4\n", [[1.2, 3.4]]), ("1;2,5\n", [[1, 2.5]]), ("1,2,3\n", [[1, 2, 3]])],
)
def test_commas_between_numbers_stay(tmp_path: Path, text: str, expected: list[list[float]]) -> None:
    file = tmp_path / "heights.csv"
    file.write_text(text, encoding="utf-8")
    np.testing.assert_array_equal(surfaces.read(file, spacing=(1.0, 1.0)).heights, expected)
