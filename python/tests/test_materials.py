# SPDX-License-Identifier: BSD-3-Clause
"""Materials: what they write into a case, which values they allow, functions as hardening laws."""

from __future__ import annotations

import copy
import pickle
import re
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import brinell
from brinell._toml import tomllib
from brinell.constitutive import yield_stress
from brinell.materials import (
    RIGID,
    Hardening,
    Hollomon,
    Linear,
    Ludwik,
    Material,
    Perfect,
    Swift,
    SwiftMicrostrain,
    Table,
    Thermal,
    Voce,
)

LAWS: list[tuple[Hardening, Callable[[Any], Any]]] = [
    (Perfect("600 MPa"), lambda e: 600e6 + 0 * e),
    (Linear("600 MPa", "2 GPa"), lambda e: 600e6 + 2e9 * e),
    (Swift("1.2 GPa", 4e-3, 0.1), lambda e: 1.2e9 * (4e-3 + e) ** 0.1),
    (SwiftMicrostrain("600 MPa", 20.0, 0.095), lambda e: 6e8 * (20.0 + 1e6 * e) ** 0.095),
    (Hollomon(6e8, 1.2e9, 0.2), lambda e: 1.2e9 * ((6e8 / 1.2e9) ** 5 + e) ** 0.2),
    (Ludwik(6e8, "500 MPa", 0.5), lambda e: 6e8 + 5e8 * np.sqrt(e)),
    (Voce(6e8, 2e8, 40), lambda e: 6e8 + 2e8 * (1 - np.exp(-40 * e))),
    (Table([0, 0.1, 0.4], ["600 MPa", 700e6, 7.5e8]), lambda e: np.interp(e, [0, 0.1, 0.4], [6e8, 7e8, 7.5e8])),
]
STRAINS = np.concatenate([[0.0], np.geomspace(1e-9, 1.0, 1001)])


@pytest.mark.parametrize(("law", "formula"), LAWS)
def test_a_law_has_the_yield_curve_of_its_formula(law: Hardening, formula: Callable[[Any], Any]) -> None:
    np.testing.assert_allclose(yield_stress(law, STRAINS), formula(STRAINS), rtol=1e-14)


@pytest.mark.parametrize(("law", "formula"), LAWS)
def test_a_function_is_the_same_law_to_what_is_promised(law: Hardening, formula: Callable[[Any], Any]) -> None:
    np.testing.assert_allclose(yield_stress(formula, STRAINS), yield_stress(law, STRAINS), rtol=1e-4)


def test_the_table_of_a_function_is_not_finer_than_it_need_be() -> None:
    straight = Table.of(lambda e: 6e8 + 2e9 * e)
    assert len(straight.stress) == 33
    # An interval of the width w has the error w^2 f''/8: 1e-4 of f = 1 + e^2 needs 36 intervals; halving takes up to
    # four times as many, and half of the tolerance is kept for what the three points do not see.
    assert len(Table.of(lambda e: 1e9 * (1 + e**2)).stress) < 200


def test_a_function_is_constant_beyond_the_last_strain() -> None:
    law = Table.of(lambda e: 1e9 * (1 + e), max_strain=0.25)
    assert law.plastic_strain[-1] == 0.25
    np.testing.assert_array_equal(yield_stress(law, [0.25, 0.5]), 1.25e9)


@pytest.mark.parametrize(
    ("law", "message"),
    [
        (lambda e: 1e9 - 1e8 * e, "falls from .* softening is not modelled"),
        (lambda e: 1e9 * (1 + np.sin(20 * e)), "falls from"),
        (lambda e: 1e9 * (1 + (e > 0.3)), "jumps from 1e\\+09 Pa to 2e\\+09 Pa at a plastic strain of 0.3"),
        (lambda e: 1e9 / e, "gives inf at a plastic strain of 0"),
        (lambda e: 1e9 * np.log(e - 0.5), "gives nan"),
        (lambda e: -1e9, "gives -1000000000.0 at a plastic strain of 0; allowed: a stress in Pa"),
        (lambda e: [1e9, 2e9], "gives"),
        (lambda e: "600 MPa", "gives '600 MPa' at a plastic strain of 0; allowed: a stress in Pa"),
    ],
)
def test_a_function_that_is_no_law_is_told_where(law: Callable[[Any], Any], message: str) -> None:
    with pytest.raises(brinell.InputError, match=message):
        Material(2e11, 0.3, hardening=law)


def test_what_a_function_raises_comes_through() -> None:
    def law(e: float) -> float:
        raise LookupError("no data")

    with pytest.raises(LookupError, match="no data"):
        Material(2e11, 0.3, hardening=law)


@pytest.mark.parametrize("max_strain", [0.0, -1.0, float("inf"), float("nan")])
def test_a_table_needs_an_end(max_strain: float) -> None:
    with pytest.raises(brinell.InputError, match="max_strain"):
        Table.of(lambda e: 1e9, max_strain)


def test_a_case_has_the_values_of_its_material() -> None:
    material = Material(
        "210 GPa",
        np.float64(0.3),
        Voce("600 MPa", 2e8, 40),
        back_stresses=[("20 GPa", 100), (1e9, 0)],
        yield_profile=(["0 mm", "1 mm"], [1.2, 1]),
        initial_stress=([0.0], ["-100 MPa"]),
    )
    ball = brinell.Sphere("1 mm")
    case = brinell.Indentation(brinell.Body(ball, material), brinell.Body(ball, RIGID), load=["1 N"], steps=1)
    lower = tomllib.loads(case.to_toml())["lower"]["material"]
    assert lower["young_modulus"] == 210e9
    assert lower["hardening"] == {
        "law": "voce",
        "yield_stress": 600e6,
        "saturation": 200e6,
        "rate": 40.0,
        "back_stresses": [{"modulus": 20e9, "recall": 100.0}, {"modulus": 1e9, "recall": 0.0}],
    }
    assert lower["yield_profile"] == {"depth": [0.0, 1e-3], "factor": [1.2, 1.0]}
    assert lower["initial_stress"] == {"depth": [0.0], "value": [-100e6]}
    assert tomllib.loads(case.to_toml())["upper"]["material"]["rigid"]


@pytest.mark.parametrize(
    ("material", "message"),
    [
        (Material(-1.0, 0.3), r"^material.young_modulus = -1.0 is out of range; allowed: pressure > 0"),
        (Material("210 mm", 0.3), r'^material.young_modulus = "210 mm" is a length'),
        (Material("210 GPA", 0.3), "unknown unit"),
        (Material(2e11, 0.5), r"^material.poisson_ratio = 0.5 is out of range"),
        (Material(2e11, 0.3, Perfect(0.0)), r"^material.hardening.yield_stress = 0.0 is out of range"),
        (Material(2e11, 0.3, Table([0, 1], [2, 1])), "must not fall"),
        (Material(2e11, 0.3, Table([0, 1], [2])), "as many stresses as plastic strains"),
        (Material(2e11, 0.3, back_stresses=[(1e9, 0)]), "applies only with"),
        (Material(2e11, 0.3, Perfect(1e9), initial_stress=([0.0], [2e9])), "where the material yields"),
    ],
)
def test_a_material_is_checked_as_in_a_case_file(material: Material, message: str) -> None:
    with pytest.raises(brinell.InputError, match=message):
        brinell.reference.contact_modulus(material)


def test_materials_can_be_sent_to_another_process() -> None:
    material = Material("210 GPa", 0.3, lambda e: 1e9 * (1 + e), back_stresses=[(1e9, 0)])
    brinell.reference.contact_modulus(material)  # the engine has seen it
    again = pickle.loads(pickle.dumps(material))
    assert again == material
    assert copy.deepcopy(material) == material
    assert brinell.reference.contact_modulus(again) == brinell.reference.contact_modulus(material)
    assert pickle.loads(pickle.dumps(RIGID)).is_rigid


def test_each_law_of_the_case_file_is_here() -> None:
    page = (Path(__file__).parents[2] / "docs/reference/case-file.md").read_text(encoding="utf-8")
    (row,) = re.findall(r"^\| `material.hardening.law` \| ([^|]*) \|", page, flags=re.MULTILINE)
    names = set(re.findall(r'"(\w+)"', row))
    assert {law.law for law in Hardening.__subclasses__()} == names - {"none"}


@pytest.mark.parametrize(
    "text",
    [
        "0, 930\n0.2, 1010.5\n1, 1200\n",
        "strain;stress\n%;MPa\n0;930\n0,2;1010,5\n1,0;1200,0\n",
        "\ufeff0;930;\n0,2;1010,5;\n1;1200;\n",  # as Excel saves it: a mark of the encoding, no titles
        '"plastic strain"\t"stress"\r\n0\t930\r\n0,2\t1010,5\r\n1\t1200\r\n',
        "# measured\n0 930\n0,2 1010,5\n1 1,2e3\n",
        "0,\t930\n0.2,\t1010.5\n1,\t1200\n",
    ],
)
def test_a_table_of_a_measured_curve(tmp_path: Path, text: str) -> None:
    path = tmp_path / "100Cr6.csv"
    path.write_text(text, encoding="utf-8")
    law = Table.from_file(path, unit="MPa", strain="%")
    assert law == Table([0, 0.002, 0.01], [930e6, 1010.5e6, 1200e6])  # to the last digit
    assert Table.from_file(str(path)).stress == (930.0, 1010.5, 1200.0)  # Pa
    assert Table(file=path, stress_unit="MPa", strain_unit="%") == law
    with pytest.raises(brinell.InputError, match="cannot stand together with plastic_strain and stress"):
        Table([0], [930e6], file=path)
    with pytest.raises(brinell.InputError, match=r"needs plastic_strain and stress, or a file; Table\.from_file"):
        Table()


def test_a_measured_curve_that_scatters(tmp_path: Path) -> None:
    path = tmp_path / "scatter.csv"
    path.write_text("0, 2000\n0.01, 2743.4\n0.02, 2739.4\n0.03, 2760\n")
    with pytest.raises(brinell.InputError, match=r"point 3, 2\.7394e\+09 Pa, follows .* monotone = true"):
        Table.from_file(path, unit="MPa")
    law = Table.from_file(path, unit="MPa", monotone=True)
    assert law.stress == (2000e6, 2743.4e6, 2743.4e6, 2760e6)
    same = Table([0, 0.01, 0.02, 0.03], ["2 GPa", "2743.4 MPa", "2739.4 MPa", "2.76 GPa"], monotone=True)
    strain = np.linspace(0, 0.05, 11)
    np.testing.assert_array_equal(yield_stress(law, strain), yield_stress(same, strain))


@pytest.mark.parametrize(
    ("text", "keywords", "message"),
    [
        (
            "0, 930\n0.01, many\n",
            {},
            r'^file = ".*curve\.csv" has in line 2 "0\.01, many", where many is not a num',
        ),
        ("0,002,930,5\n", {}, 'has in line 1 "0,002,930,5"'),
        ("0, 930\n", {"unit": "mm"}, '^unit = "mm" is a unit of length; allowed: a unit of stress, such as "MPa"'),
        ("0, 930\n", {"unit": "Mpa"}, r"unknown unit .*did you mean MPa or mPa\?"),
        ("0, 930\n", {"strain": "percent"}, '^strain = "percent" is not known; allowed: "1" or "%"'),
        ("strain, stress\n", {}, "has no line of numbers; allowed: text, plastic strain and stress in Pa"),
    ],
)
def test_what_is_wrong_with_a_curve(tmp_path: Path, text: str, keywords: Any, message: str) -> None:
    path = tmp_path / "curve.csv"
    path.write_text(text)
    with pytest.raises(brinell.InputError, match=message):
        Table.from_file(path, **keywords)


def test_a_curve_whose_unit_was_forgotten_is_warned_of(tmp_path: Path) -> None:
    path = tmp_path / "curve.csv"
    path.write_text("0, 930\n2, 1200\n")
    body = brinell.Body(brinell.Sphere("5 mm"), Material("210 GPa", 0.3, Table.from_file(path)))
    rigid = brinell.Body(brinell.Flat(), RIGID)
    yields = "lower than that of any metal; is a unit missing"
    strains = "goes up to 2, which is 200 %; is it in percent?"
    with pytest.warns(brinell.CaseWarning) as told:
        brinell.Indentation(body, rigid, load=["1e-12 N", 0])
    assert [one in str(warning.message) for warning, one in zip(told, (yields, strains), strict=True)] == [True] * 2
    with pytest.raises(
        brinell.InputError, match="more than the radius of curvature there, 0.005 m"
    ) as error:  # and not a word of why?
        brinell.Indentation(body, rigid, load=["1 N", 0])
    assert yields in str(error.value)
    assert strains in str(error.value)


def test_materials_can_be_compared() -> None:
    def steel(factor: float) -> Material:
        return Material(2e11, 0.3, Table(np.array([0.0, 1.0]), np.array([1e9, 2e9])), yield_profile=([0], [factor]))

    assert steel(1) == steel(1.0)
    assert len({steel(1), steel(1.0), steel(2)}) == 2


def test_constants_of_heat_stand_in_the_case() -> None:
    heat = Thermal("50 W/(m K)", "7.85 g/cm^3", "0.46 kJ/(kg K)", "12 um/m/K", "373.15 K")
    ball = brinell.Sphere("1 mm")
    lower = brinell.Body(ball, Material("210 GPa", 0.3, thermal=heat))
    upper = brinell.Body(ball, Material(float("inf"), 0.0, thermal=Thermal(30, 3200, 700, temperature=50)))
    with pytest.warns(brinell.CaseWarning, match="has no effect on the contact: no heat is computed"):
        case = brinell.Indentation(lower, upper, load=["1 N"], steps=1)
    table = tomllib.loads(case.to_toml())
    constants = {"conductivity": 50.0, "density": 7850.0, "specific_heat": 460.0, "expansion": 12e-6}
    assert table["lower"]["material"]["thermal"] == constants | {"temperature": 100.0}
    assert "expansion" not in table["upper"]["material"]["thermal"]
    assert heat.diffusivity == pytest.approx(50 / (7850 * 460), rel=1e-15)
    assert pickle.loads(pickle.dumps(lower)) == lower


def test_constants_of_steels_are_those_of_the_standards() -> None:
    """EN 1993-1-2:2005, 3.4.1.1 (derivative of its strain), 3.4.1.2, 3.4.1.3, at 20 deg C, to the digits given."""
    t = 20.0
    steel = Thermal.carbon_steel()
    assert steel.conductivity == pytest.approx(54 - 3.33e-2 * t, abs=0.05)
    assert steel.specific_heat == pytest.approx(425 + 0.773 * t - 1.69e-3 * t**2 + 2.22e-6 * t**3, abs=0.5)
    assert steel.expansion == pytest.approx(1.2e-5 + 0.8e-8 * t, abs=0.05e-6)
    assert Thermal.stainless_steel("350 K").temperature == "350 K"


@pytest.mark.parametrize(
    ("call", "message"),
    [
        (lambda: Thermal(0.0, 7850, 460), r"^conductivity = 0.0 is out of range; allowed: thermal conductivity > 0"),
        (lambda: Thermal("50 W", 7850, 460), r'^conductivity = "50 W" is a power'),
        (lambda: Thermal(50, 7850, 460, 12), r"^expansion = 12 is out of range; .*a steel has about 12e-6 1/K"),
        (
            lambda: Thermal(50, 7850, 460, temperature=-300),
            r"^temperature = -300 is out of range; .*temperature > -273.15, in degC",
        ),
        (lambda: Thermal(50, 7850, None), "^specific_heat is missing"),  # type: ignore[arg-type]
        (lambda: Material(2e11, 0.3, thermal=50.0), r"^thermal = 50.0; allowed: brinell.Thermal"),  # type: ignore[arg-type]
    ],
)
def test_constants_of_heat_are_checked_when_they_are_given(call: Callable[[], Any], message: str) -> None:
    with pytest.raises(brinell.InputError, match=message):
        call()


@pytest.mark.parametrize(
    ("given", "columns"),
    [
        ([(0, 1.5), (3e-6, 1)], ((0, 3e-6), (1.5, 1))),
        (([0, 3e-6], [1.5, 1]), ((0, 3e-6), (1.5, 1))),
        ([("0 um", 1.5), ("3 um", 1)], (("0 um", "3 um"), (1.5, 1))),
        ((["0 um", "3 um"], [1.5, 1]), (("0 um", "3 um"), (1.5, 1))),
        ({"depth": [0, 3e-6], "factor": [1.5, 1]}, ((0, 3e-6), (1.5, 1))),
        ([(0, 1.5), (1e-6, 1.2), (3e-6, 1)], ((0, 1e-6, 3e-6), (1.5, 1.2, 1))),
        (([0, 1e-6, 3e-6], [1.5, 1.2, 1]), ((0, 1e-6, 3e-6), (1.5, 1.2, 1))),
        (np.array([[0, 1.5], [1e-6, 1.2], [3e-6, 1]]), ((0, 1e-6, 3e-6), (1.5, 1.2, 1))),
        (([0], [1.5]), ((0,), (1.5,))),
        ([(0, 1.5)], ((0,), (1.5,))),
    ],
)
def test_a_profile_is_given_by_points_or_columns(given: Any, columns: Any) -> None:
    material = Material(2e11, 0.3, Perfect(1e9), yield_profile=given)
    assert material.yield_profile == columns
    assert material.to_case()["yield_profile"] == {"depth": list(columns[0]), "factor": list(columns[1])}
    brinell.reference.contact_modulus(material)  # the engine reads it


def test_a_profile_of_stress_is_given_by_points_or_columns() -> None:
    for given in ([(0, -2e8), (1e-4, 0)], ([0, 1e-4], [-2e8, 0]), {"depth": [0, 1e-4], "value": [-2e8, 0]}):
        assert Material(2e11, 0.3, Perfect(1e9), initial_stress=given).initial_stress == ((0, 1e-4), (-2e8, 0))
    assert Material(2e11, 0.3, Perfect(1e9), initial_stress=[("0 um", "-200 MPa"), ("9 um", 0)]).initial_stress == (
        ("0 um", "9 um"),
        ("-200 MPa", 0),
    )


@pytest.mark.parametrize(
    ("keywords", "message"),
    [
        (
            {"yield_profile": [(0, 0.05), (0.02, 0.1)]},
            "can be two points or two columns; allowed: yield_profile={'depth'",
        ),
        ({"yield_profile": [(0, 7), (9, 8)]}, "can be two points or two columns"),
        ({"yield_profile": [(0, 1, 2)]}, r"allowed: yield_profile=\{'depth': \[...\], 'factor': \[...\]\}, points"),
        ({"yield_profile": 3}, "yield_profile = 3; allowed"),
        ({"yield_profile": "3 um"}, "yield_profile = '3 um'; allowed"),
        ({"yield_profile": {"depths": [0], "factor": [1]}}, "yield_profile has the keys 'depths', 'factor'; allowed"),
        (
            {"back_stresses": ([90e9, 10e9], [600, 50])},
            r"back_stresses\[0\] has the recall 1e\+10, which no material has",
        ),
        ({"back_stresses": [("90 GPa",)]}, r"back_stresses\[0\] = \('90 GPa',\); allowed: pairs"),
        ({"back_stresses": [{"module": 1}]}, r"back_stresses\[0\] has the keys 'module'; allowed: pairs"),
        ({"back_stresses": ["90 GPa"]}, r"back_stresses\[0\] = '90 GPa'; allowed: pairs"),
    ],
)
def test_what_can_be_read_in_two_ways_is_refused(keywords: Any, message: str) -> None:
    with pytest.raises(brinell.InputError, match=message):
        Material(2e11, 0.3, Perfect(1e9), **keywords)


def test_back_stresses_are_named_as_in_a_case_file() -> None:
    terms = [{"modulus": "90 GPa", "recall": 600}, {"modulus": 10e9}]
    assert Material(2e11, 0.3, Perfect(1e9), back_stresses=terms).back_stresses == (("90 GPa", 600), (10e9, 0.0))
