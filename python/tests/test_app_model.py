# SPDX-License-Identifier: BSD-3-Clause
"""What is behind the page of `brinell app`: forms of the schema, text of a case, errors at their fields."""

import random
import subprocess
import sys
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import pytest

import brinell
from brinell import _core
from brinell.app.case_text import text_of, values_of
from brinell.app.checking import checked, values_that_apply
from brinell.app.forms import Field, applying, field_of, form, sections, units_of

CASES = sorted((Path(__file__).parents[2] / "cases").glob("*/case.toml"))

BAD: Mapping[str, list[Any]] = {
    "number": ["x", "3 parsec", "3 kg m^5", True, [1, "a"], {}, "nan", "1e999 m", ""],
    "numbers": ["x", [], ["a"], True, "3 kg m^5", [1, True]],
    "integer": ["x", 1.5, True, -(10**12), 10**40],
    "choice": ["nonsense", 3, True, ["nonsense"]],
    "boolean": ["yes", 3, [True]],
    "text": [3, True, ["a"]],
    "vector3": ["x", [1, 2], [1, 2, "x"], True],
    "snapshots": ["never", True, -3],
    "words": ["x", [3], [], True],
}
"""Values that no key of a kind may have."""


SCENARIOS = form()["scenario"].choices


@pytest.fixture(scope="session")
def templates() -> dict[str, dict[str, Any]]:
    commands = {one: [sys.executable, "-m", "brinell", "new", one] for one in SCENARIOS}
    return {
        scenario: values_of(subprocess.run(command, check=True, capture_output=True, text=True).stdout)
        for scenario, command in commands.items()
    }


def numbered(one: Field) -> str:
    """A key as it stands in a case; of a repeated table that of the first one."""
    return f"{one.list}[0]{one.key.removeprefix(one.list)}" if one.list else one.key


def case_with(one: Field, templates: Mapping[str, dict[str, Any]]) -> dict[str, Any]:
    """Values of a case in which a field applies."""
    for template in templates.values():
        values = dict(template)
        if _made_to_apply(one, values):
            return values
    raise AssertionError(f"{one.key} cannot be reached")


def _made_to_apply(one: Field, values: dict[str, Any]) -> bool:
    on, allowed = one.when
    if not on:
        return True
    if on == "scenario":
        return values["scenario"] in allowed
    parent = form()[on]
    if not _made_to_apply(parent, values):
        return False
    if str(values.get(numbered(parent))) not in allowed:
        values[numbered(parent)] = allowed[0] == "true" if parent.kind == "boolean" else allowed[0]
    return True


def test_every_key_of_the_schema_has_a_field() -> None:
    assert [one.key for section in sections() for one in section.fields] == sorted(
        (entry.key for entry in _core.schema_keys()),
        key=[one.key for section in sections() for one in section.fields].index,
    )
    assert len(form()) == len(_core.schema_keys())
    for one in form().values():
        assert one.label
        assert one.help or one.key == "title", one.key


@pytest.mark.parametrize("key", [entry.key for entry in _core.schema_keys()])
def test_every_field_is_reached_and_has_its_errors(
    key: str, templates: dict[str, dict[str, Any]], tmp_path: Path
) -> None:
    one = form()[key]
    values = case_with(one, templates)
    given = numbered(one)
    assert given in applying(values)
    for bad in BAD[one.kind]:
        result = checked({**values, given: bad}, tmp_path)
        assert given in [error.key for error in result.errors], (bad, result.errors)
        lines = result.text.split("\n")
        for error in result.errors:
            assert error.key in values or error.key in result.applies or error.key == given, error
            if error.key == given:
                assert lines[error.line - 1].startswith(f"{given.rpartition('.')[2]} = "), error


@pytest.mark.parametrize("scenario", SCENARIOS)
def test_missing_keys_are_missed_at_their_fields(
    scenario: str, templates: dict[str, dict[str, Any]], tmp_path: Path
) -> None:
    values = templates[scenario]
    applies = applying(values)
    missed = 0
    for key in values:
        one = field_of(key)
        if one is None or not one.required or key == "scenario":
            continue
        rest = values_that_apply({name: value for name, value in values.items() if name != key})
        result = checked(rest, tmp_path)
        assert key in [error.key for error in result.errors], (key, result.errors)
        missed += 1
    assert missed > 5
    assert set(values) <= set(applies)


def test_random_mixtures_of_errors_all_land_at_a_field(templates: dict[str, dict[str, Any]], tmp_path: Path) -> None:
    """Three bad values at a time: the engine tells all, and none is left without a field."""
    numbers = random.Random(7)
    keys = list(form().values())
    for _ in range(150):
        chosen = numbers.sample(keys, 3)
        values = case_with(chosen[0], templates)
        for one in chosen:
            values[numbered(one)] = numbers.choice(BAD[one.kind])
        result = checked(values, tmp_path)
        assert result.errors
        for error in result.errors:
            assert error.key, error
            assert error.key in values or error.key in result.applies or error.key in {s.table for s in sections()}, (
                error
            )


def test_errors_of_whole_cases_land_at_a_field(templates: dict[str, dict[str, Any]], tmp_path: Path) -> None:
    tugging = templates["tugging"]
    changes: dict[str, dict[str, Any]] = {
        "grid.resolution": {"grid.resolution": 1000, "grid.extent": 10},
        "lower.shape.type": {"lower.shape.type": "flat"},
        "lower.shape.radus": {"lower.shape.radus": 3},
        "grid.boundary": {"grid.boundary": "periodic"},
        "lower.texture[1].depth": {
            "lower.texture[0].type": "dent",
            "lower.texture[0].depth": "1 nm",
            "lower.texture[0].edge_radius": "0.2 um",
            "lower.texture[1].type": "dent",
            "lower.texture[1].depth": "-1 nm",
            "lower.texture[1].edge_radius": "0.2 um",
        },
        "interface.coupling": {"interface.coupling": "maybe"},
        "foo": {"foo.bar": 1},
    }
    for key, change in changes.items():
        result = checked(values_that_apply({**tugging, **change}), tmp_path)
        assert key in [error.key for error in result.errors], (key, result.errors)


@pytest.mark.parametrize("path", CASES, ids=lambda path: path.parent.name)
def test_a_case_survives_the_form(path: Path) -> None:
    values = values_of(path.read_text(encoding="utf-8"))
    written = text_of(values)
    assert values_of(written.text) == values  # values and units as they were given
    assert set(values) <= set(applying(values))
    before, after = brinell.Case.from_file(path), brinell.Case(written.text, file=path)
    assert values_of(after.to_toml()) == values_of(before.to_toml())
    for line, key in written.lines.items():
        assert key.rpartition(".")[2].split("[")[0] in written.text.split("\n")[line - 1]


def test_repeated_tables_and_odd_names_are_written() -> None:
    values = {
        "scenario": 'a "quoted" \\ text\n',
        "lower.texture[0].type": "bump",
        "lower.texture[1].type": "dent",
        "lower.material.hardening.back_stresses[0].modulus": "3 GPa",
        "unknown.table.key": [1, 2.5, "3 mm", True],
        "a b.x y": 1,
    }
    written = text_of(values).text
    assert values_of(written) == values
    assert written.count("[[lower.texture]]") == 2
    assert "[lower.material.hardening.back_stresses]" in written


def test_units_to_choose_from_are_read_by_the_engine(templates: dict[str, dict[str, Any]], tmp_path: Path) -> None:
    tried = set()
    for one in form().values():
        if one.kind != "number" or not one.units or one.units in tried:
            continue
        tried.add(one.units)
        for unit in one.units:
            as_quantity = {one.pure_if: False} if one.pure_if else {}
            values = {**case_with(one, templates), **as_quantity, numbered(one): f"0.5 {unit}"}
            result = checked(values, tmp_path)
            wrong = [e.text for e in result.errors if e.key == numbered(one)]
            assert not any("unknown unit" in text or '" is a' in text for text in wrong), (
                one.key,
                wrong,
            )
    assert len(tried) > 8
    assert units_of("kg m^5") == ("kg m^5",)


def test_forecast_and_warnings_are_those_of_the_command(templates: dict[str, dict[str, Any]], tmp_path: Path) -> None:
    values = {**templates["tugging"], "tugging.speed": "1 m/s"}
    result = checked(values, tmp_path)
    assert not result.errors
    assert "Cost: about" in result.report
    assert result.seconds > 0
    assert result.forecast in result.report
    assert "tugging.speed" in [one.key for one in result.warnings]


def test_a_reason_stands_behind_what_it_explains(templates: dict[str, dict[str, Any]], tmp_path: Path) -> None:
    values = {**templates["rolling"], "upper.shape.radius": 5, "rolling.creepage": 0.01}
    error, reason = (one.text for one in checked(values, tmp_path).errors)
    assert error.startswith("rolling.creepage = ")
    assert reason.startswith("the reason may be: upper.shape.radius = 5 is in m")


def test_no_text_of_a_case_leads_outside_its_folder(templates: dict[str, dict[str, Any]], tmp_path: Path) -> None:
    (tmp_path / "secret.csv").write_text("0 1\n")
    home = tmp_path / "home"
    home.mkdir()
    (home / "link.csv").symlink_to(tmp_path / "secret.csv")
    (home / "inside.csv").write_text("0 1\n0.1 2\n")
    texts = [one for one in form().values() if one.kind == "text" and one.key != "title"]
    assert len(texts) >= 5
    for one in texts:
        for path in (
            "/etc/passwd",
            "../secret.csv",
            "link.csv",
            "a/../../secret.csv",
            "\0",
            "x" * 5000 + "/../../../..",
        ):
            result = checked({**case_with(one, templates), numbered(one): path}, home)
            assert [error.key for error in result.errors] == [numbered(one)], (one.key, path, result.errors)
            if "\0" not in path:
                assert "outside the folder" in result.errors[0].text
        inside = checked({**case_with(one, templates), numbered(one): "inside.csv"}, home)
        assert not any("outside the folder" in error.text for error in inside.errors)


def test_files_of_a_case_are_known() -> None:
    files = {one.key for one in form().values() if one.is_file}
    tables = ("texture", "film", "material.hardening")
    assert files == {f"{body}.{table}.file" for body in ("lower", "upper") for table in tables}


def test_text_that_is_no_case_is_refused() -> None:
    for text in ("= 3", "[a\n", "a = 1\na = 2\n", "\0", "a = " + "[" * 3000):
        with pytest.raises(brinell.InputError, match="not a case file"):
            values_of(text)
    assert values_of("d = 2020-01-01\ni = inf\n") == {"d": "2020-01-01", "i": "inf"}
