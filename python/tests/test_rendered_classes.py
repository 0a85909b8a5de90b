# SPDX-License-Identifier: BSD-3-Clause
"""Classes that are written from the schema: they are up to date, and say what the schema says."""

from __future__ import annotations

import importlib
import inspect
import sys
from dataclasses import fields
from pathlib import Path
from types import ModuleType
from typing import Any

import pytest

import brinell
import brinell.results
from brinell import _core
from brinell.scenarios import SCENARIOS

TOOLS = Path(__file__).parents[2] / "tools"


@pytest.fixture(scope="module")
def tool() -> ModuleType:
    """The tool that writes them, where the sources are; an installed package has none."""
    if not (TOOLS / "render_python.py").is_file():
        pytest.skip("without the sources")
    sys.path.insert(0, str(TOOLS))
    try:
        return importlib.import_module("render_python")
    finally:
        sys.path.remove(str(TOOLS))


def key_of(name: str) -> _core.SchemaKey:
    return next(key for key in _core.schema_keys() if key.key == name)


def test_the_files_are_those_of_the_schema(tool: ModuleType) -> None:
    written = {path: tool.rendered(path) for path in tool.FILES}
    outdated = [path for path, text in written.items() if (tool.PACKAGE / path).read_text(encoding="utf-8") != text]
    assert outdated == [], "run tools/render_python.py"


def test_every_scenario_and_choice_has_its_class(tool: ModuleType) -> None:
    kinds = [kind for file in tool.FILES.values() for kind in file.kinds]
    choices = {(kind.table, kind.choice) for kind in kinds if isinstance(kind, tool.Kind) and kind.choice}
    by_hand = {("lower.texture", "smooth"), ("lower.texture", "height_map"), ("lower.material.hardening", "none")}
    by_hand |= {("lower.material.hardening", "table"), ("lower.material.softening", "table")}
    for key in ("shape.type", "texture.type", "material.hardening.law", "material.softening.law"):
        table = f"lower.{key.rpartition('.')[0]}"
        wanted = {(table, choice) for choice in key_of(f"lower.{key}").choices} - by_hand
        assert wanted == {one for one in choices if one[0] == table}
    assert [kind.name.lower() for kind in kinds if isinstance(kind, tool.Scenario)] == key_of("scenario").choices
    assert {kind.key for kind in kinds if isinstance(kind, tool.Listed)} == {*_core.columns()} - {*SCENARIOS}


def test_every_number_of_a_list_says_what_it_is() -> None:
    lists = {name: columns for name, columns in _core.columns().items() if name not in SCENARIOS}
    assert [f"{name}[].{one.name}" for name, columns in lists.items() for one in columns if not one.text] == []


@pytest.mark.parametrize(
    ("kind", "texts"),
    [
        (brinell.Grid, ["resolution: Cells per contact radius", "in [1, 1000]", "in tugging", "In m, > 0"]),
        (brinell.Solver, ["Default: True", "False: solve both", 'Default: "path"']),
        (brinell.Interface, ["In Pa, > 0; default: the current shear yield stress", "`brinell.Wear` or a dictionary"]),
        (brinell.Cone, ["Angle between axis and flank of the cone, in degrees. Allowed: in (0, 90)."]),
        (brinell.Swift, ["sigma_y(e) = coefficient (offset + e)^exponent (Swift 1952)"]),
        (brinell.JohnsonCook, ["^exponent (Johnson and Cook 1983)", "In degC"]),
        (brinell.Tugging.__init__, ["In m (a pure number if normalised), > 0"]),
        (
            brinell.Rolling.__init__,
            ["exactly one of load, hertz_pressure and approach is given", "load: Load kept while rolling. In N"],
        ),
        (brinell.results.RollingPass, ["pass_: Number of the pass, from 1.", "positive into the body [m].", "[N m]"]),
        (brinell.results.Indent, ["hardness: Largest load over the projected contact area [Pa]."]),
        (brinell.Fretting.__init__, ["one of load, approach and pressure, and one of displacement and force"]),
    ],
)
def test_help_says_units_ranges_and_defaults(kind: Any, texts: list[str]) -> None:
    said = " ".join(str(inspect.getdoc(kind)).split())
    assert [text for text in texts if text not in said] == []


def test_types_are_those_of_the_keys() -> None:
    kinds = (brinell.Grid, brinell.Solver, brinell.Output)
    types = {field.name: field.type for kind in kinds for field in fields(kind)}
    assert types["spacing"] == "Sequence[Quantity] | None"
    assert types["size"] == "Quantity | Sequence[Quantity] | None"
    assert types["max_evaluations"] == "int | None"
    assert types["integration"] == "Literal['path', 'backward_euler'] | None"
    assert types["snapshots"] == "str | Sequence[int] | None"
    assert types["precision"] == "Literal['double', 'single'] | None"


def test_a_key_of_another_choice_is_no_argument() -> None:
    """A cylinder knows no half angle, and an indentation, in which nothing slides, no heat of friction."""
    assert [field.name for field in fields(brinell.Cylinder)] == ["radius", "length"]
    with pytest.raises(brinell.ArgumentError, match="unknown argument thermal"):
        brinell.Indentation(None, None, thermal=None)  # type: ignore[call-arg, arg-type]


def test_a_choice_that_the_schema_does_not_explain_is_an_error(tool: ModuleType) -> None:
    class Key:
        key, choices, text = "lower.shape.type", ["sphere", "torus"], "Shape. sphere: the paraboloid; ellipse: none."

    assert tool.text_of_choice(Key, "sphere") == "the paraboloid; ellipse: none"
    with pytest.raises(ValueError, match=r"the text of lower\.shape\.type does not say what torus is"):
        tool.text_of_choice(Key, "torus")
