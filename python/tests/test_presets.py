# SPDX-License-Identifier: BSD-3-Clause
"""Materials whose constants a standard gives."""

from __future__ import annotations

import re
from pathlib import Path

import pytest
from click.testing import CliRunner

import brinell
from brinell.material_commands import material


def test_presets_are_materials_with_a_source_that_the_engine_takes() -> None:
    presets = brinell.materials.PRESETS
    assert {"S235", "S355", "1.4301", "EN AW-6082-T6", "bearing steel"} <= set(presets)
    for name, one in presets.items():
        assert name == one.name
        assert re.search(r"\b(EN|ISO)[ /]", one.source), "a standard"
        assert brinell.materials.preset(name.lower(), thermal=True) == one.material
        plain = brinell.materials.preset(name)
        assert plain.thermal is None
        flat = brinell.Body(brinell.Flat(), plain)
        case = brinell.Indentation(flat, brinell.Body(brinell.Sphere("1 mm"), brinell.RIGID), load=["1 N"])
        assert "young_modulus" in case.to_toml()
    steel = brinell.materials.preset("S355")
    assert isinstance(steel.hardening, brinell.Linear)
    # EN 1993-1-1: G = E / (2 (1 + nu)) is about 81 000 N/mm^2.
    assert steel._engine.shear_modulus == pytest.approx(81e9, rel=5e-3)
    with pytest.raises(
        brinell.InputError, match=r"no material 'S335'; did you mean S[23]\d5\? allowed: S235, S275, S355"
    ):
        brinell.materials.preset("S335")


def test_presets_on_the_command_line_are_tables_of_a_case(tmp_path: Path) -> None:
    runner = CliRunner()
    listed = runner.invoke(material, ["presets"])
    assert listed.exit_code == 0
    assert [line.split("  ")[0].strip() for line in listed.output.splitlines()] == list(brinell.materials.PRESETS)
    printed = runner.invoke(material, ["presets", "en aw-6082-t6", "--body", "upper"])
    assert printed.exit_code == 0
    assert printed.output.startswith("# EN 1999-1-1")
    text = (
        'scenario = "indentation"\n[lower]\nshape = { type = "flat" }\nmaterial = { rigid = true }\n' + printed.output
    )
    text += '\n[upper.shape]\ntype = "sphere"\nradius = "1 mm"\n[indentation]\nload = ["1 N"]\n'
    path = tmp_path / "case.toml"
    path.write_text(text, encoding="utf-8")
    assert "yield_stress = 260000000.0" in brinell.Case.from_file(path).to_toml()
    heated = runner.invoke(material, ["presets", "S355", "--thermal"])
    assert "conductivity" in heated.output
    assert "conductivity" not in printed.output
    wrong = runner.invoke(material, ["presets", "steel"])
    assert wrong.exit_code == 2
