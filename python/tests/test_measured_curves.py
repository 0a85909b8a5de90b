# SPDX-License-Identifier: BSD-3-Clause
"""Measured stress-strain curves: Python, case file and command line make the same hardening curve of them."""

from __future__ import annotations

from pathlib import Path

import matplotlib
import matplotlib.image
import numpy as np
import pytest
from click.testing import CliRunner

import brinell
from brinell._toml import tomllib
from brinell.material_commands import material
from brinell.materials import MeasuredCurve, Table
from brinell.plot import measured_curve

E = 210e9
STRAINS = np.linspace(0.0, 0.1, 201)
STRESSES = 1.5e9 * (0.004 + STRAINS) ** 0.1


def test_curve() -> tuple[np.ndarray, np.ndarray]:
    """Total strains and stresses of a known law, from the origin."""
    elastic = np.linspace(0.0, STRESSES[0], 20, endpoint=False)
    stress = np.concatenate([elastic, STRESSES])
    return np.concatenate([np.zeros(elastic.size), STRAINS]) + stress / E, stress


test_curve.__test__ = False  # type: ignore[attr-defined]


@pytest.fixture
def file(tmp_path: Path) -> Path:
    strain, stress = test_curve()
    path = tmp_path / "curve.csv"
    lines = [f"{100 * e:.15g};{s / 1e6:.15g}" for e, s in zip(strain, stress, strict=True)]
    path.write_text("strain;stress\n%;MPa\n" + "\n".join(lines))
    return path


def test_total_strains_become_the_law(file: Path) -> None:
    curve = MeasuredCurve.from_file(file, unit="MPa", strain="%", young_modulus="210 GPa")
    assert curve.yield_stress == pytest.approx(1.5e9 * 0.006**0.1, rel=1e-4)  # linear between points
    beyond = curve.plastic_strain > 0.002
    expected = 1.5e9 * (0.004 + curve.plastic_strain[beyond]) ** 0.1
    np.testing.assert_allclose(curve.flow_stress[beyond], expected, rtol=1e-9)  # 15 digits in the file
    assert curve.slope == pytest.approx(E, rel=1e-9)
    assert "at 0.2 % plastic strain" in curve.notes[-1]
    assert repr(curve).startswith("MeasuredCurve(221 points, yield stress 8.9")


def test_arrays_file_table_and_case_agree(file: Path) -> None:
    how = {"strain_type": "total", "yield_from": "fit", "yield_offset": "0.1 %"}
    arrays = MeasuredCurve(*test_curve(), young_modulus=E, yield_from="fit", yield_offset=0.001)
    law = Table.from_file(file, unit="MPa", strain="%", young_modulus="210 GPa", **how)
    np.testing.assert_allclose(law.stress, arrays.flow_stress, rtol=1e-6)  # the fit of rounded points
    read = MeasuredCurve.from_file(file, unit="MPa", strain="%", young_modulus="210 GPa", **how)
    assert law == read.table
    table = {"law": "table", "file": str(file), "stress_unit": "MPa", "strain_unit": "%"} | how
    hardening = ", ".join(f'{key} = "{value}"' for key, value in table.items())
    case = brinell.Case(
        'scenario = "indentation"\nlower.shape.type = "flat"\nupper.shape = {type = "sphere", radius = "1 mm"}\n'
        'upper.material.rigid = true\nindentation.load = ["1 N", 0]\n'
        'lower.material = {young_modulus = "210 GPa", poisson_ratio = 0.3}\n',
        overrides=[f"lower.material.hardening={{{hardening}}}"],
    )
    in_case = tomllib.loads(case.to_toml())["lower"]["material"]["hardening"]
    assert tuple(in_case["stress"]) == law.stress
    assert "yield stress" in case.check()
    assert "Swift's law" in case.check()


def test_a_machine_that_gives_way_is_warned_of(file: Path) -> None:
    strain, stress = test_curve()
    with pytest.warns(brinell.CaseWarning, match="75 % below Young's modulus"):
        MeasuredCurve(strain + stress * (1 / 52.5e9 - 1 / E), stress, young_modulus=E)
    with pytest.warns(brinell.CaseWarning, match="48 % below Young's modulus"):
        Table.from_file(file, unit="MPa", strain="%", young_modulus="400 GPa", strain_type="total")


def test_what_is_wrong_is_said(file: Path) -> None:
    strain, stress = test_curve()
    for make, message in (
        (lambda: MeasuredCurve(strain, stress), "^the curve has elastic strains, which need young_modulus"),
        (lambda: MeasuredCurve(strain, stress[:-1], E), "^the curve has 221 strains and 220 stresses"),
        (
            lambda: MeasuredCurve(strain, stress, E, measure="nominal"),
            '^measure = "nominal" is not known; allowed: "tru',
        ),  # type: ignore[arg-type]
        (lambda: MeasuredCurve(strain, stress, "210 mm"), '^young_modulus = "210 mm" is a length; allowed: a pressure'),
        (lambda: MeasuredCurve(strain, stress, E, yield_offset="2 mm"), '^yield_offset = "2 mm" is a length'),
        (lambda: MeasuredCurve([strain], stress, E), "^strain has 2 axes"),  # type: ignore[list-item]
        (lambda: MeasuredCurve.from_file(file, unit="mm"), '^unit = "1 mm" is a length'),
        (lambda: MeasuredCurve.from_file(file), f"^{file} has elastic strains"),
        (lambda: Table.from_file(file, strain_type="total"), "which need young_modulus"),
        (lambda: Table.from_file(file), 'begins with a stress of 0 Pa; .* strain_type = "total"'),
    ):
        with pytest.raises(brinell.InputError, match=message):
            make()


def test_a_repeated_plastic_strain_is_one_point(tmp_path: Path) -> None:
    path = tmp_path / "curve.csv"
    path.write_text("0, 900\n0.01, 980\n0.01, 1000\n0.02, 1100\n")
    assert Table.from_file(path, unit="MPa") == Table([0, 0.01, 0.02], [900e6, 990e6, 1100e6])


def test_the_command_shows_numbers_and_a_figure(file: Path, tmp_path: Path) -> None:
    words = ["show", str(file), "--stress-unit", "MPa", "--strain-unit", "%", "--young-modulus", "210GPa"]
    picture = tmp_path / "curve.png"
    done = CliRunner().invoke(material, [*words, "-o", str(picture)], catch_exceptions=False)
    assert done.exit_code == 0, done.output
    for part in (
        "plastic strain = strain - stress/2.1e+11 Pa",
        "at 0.2 % plastic strain",
        "0.1      ",
        str(picture),
    ):
        assert part in done.output
    assert matplotlib.image.imread(picture).shape[0] > 100
    done = CliRunner().invoke(material, [*words[:2], "--stress-unit", "MPa"])
    assert done.exit_code == 2
    assert "which need young_modulus" in done.output


def test_the_figure_has_both_curves_and_draws_into_given_axes(file: Path) -> None:
    from matplotlib.figure import Figure

    curve = MeasuredCurve.from_file(file, unit="MPa", strain="%", young_modulus="210 GPa")
    mine = Figure()
    left, right = mine.subplots(1, 2)
    assert measured_curve(curve, ax=right) is mine
    assert not left.lines
    drawn = {line.get_gid(): line for line in right.lines}
    np.testing.assert_allclose(drawn["hardening"].get_ydata(), curve.flow_stress / 1e9)
    np.testing.assert_allclose(drawn["measured"].get_xdata(), 100 * curve.strain)
