# SPDX-License-Identifier: BSD-3-Clause
"""The parts of docs/verification.md and its pages that are rendered from what the tests measured."""

import importlib.util
import json
import subprocess
import sys
from pathlib import Path
from types import ModuleType

import pytest

ROOT = Path(__file__).resolve().parents[2]
TOOL = ROOT / "tools" / "render_verification.py"


@pytest.fixture(scope="module")
def tool() -> ModuleType:
    spec = importlib.util.spec_from_file_location("render_verification", TOOL)
    assert spec is not None
    assert spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


SOURCE = """
TEST(PlaneStrain, ElasticCylinder)
{
  test::expect_close("pressure", 1.0, 1.0, 0.1, "exact");
}

TEST(PlaneStrain, LeavesNoNumber)
{
  EXPECT_TRUE(true);
}

TEST_P(Accuracy,
       OfTheInterval)
{
  test::expect_within("load", 1.0, 0.0, 2.0, "interval");
}
"""
CLOSE = {"expected": 1.0, "measured": 1.02, "tolerance": 0.1, "origin": "exact"}
WITHIN = {"low": 0.0, "high": 2.0, "measured": 1.0, "origin": "interval"}
RECORD = {
    "PlaneStrain": {"ElasticCylinder": {"pressure": CLOSE}},
    "Cases/Accuracy": {"OfTheInterval/0": {"load": WITHIN}, "OfTheInterval/1": {"approach": WITHIN}},
}


def test_each_suite_has_a_section_and_parameters_share_a_table(tool: ModuleType) -> None:
    lines = tool.rendered(RECORD, {}).splitlines()
    assert [line for line in lines if line.startswith("#")] == ["### Accuracy", "### Plane strain"]
    assert lines.count("**Of the interval**") == 1
    assert "| pressure | 1.02 | 1 | ± 0.1 | exact |" in lines


def test_tests_stand_in_the_order_of_their_source_whichever_ended_first(tool: ModuleType, tmp_path: Path) -> None:
    (tmp_path / "plane_test.cpp").write_text(SOURCE)
    record = {
        "PlaneStrain": {"LeavesNoNumber": {"b": CLOSE}, "ElasticCylinder": {"a": CLOSE}},
        "Cases/Accuracy": {f"OfTheInterval/{i}": {f"x{i}": WITHIN} for i in (10, 2, 0)},
    }
    lines = tool.rendered(record, tool.tests_of(tmp_path)).splitlines()
    assert [line for line in lines if line.startswith("**")] == [
        "**Of the interval**",
        "**Elastic cylinder**",
        "**Leaves no number**",
    ]
    assert [line.split()[1] for line in lines if line.startswith("| x")] == ["x0", "x2", "x10"]


def test_what_differs_from_the_tests_is_told(tool: ModuleType, tmp_path: Path) -> None:
    (tmp_path / "plane_test.cpp").write_text(SOURCE)
    tests = tool.tests_of(tmp_path)
    assert tests == {
        ("PlaneStrain", "ElasticCylinder"): True,
        ("PlaneStrain", "LeavesNoNumber"): False,
        ("Accuracy", "OfTheInterval"): True,
    }
    assert tool.differences(RECORD, tests) == []
    gone = {**RECORD, "OldSuite": {"OldTest": {"x": CLOSE}}}
    del gone["Cases/Accuracy"]
    assert tool.differences(gone, tests) == [
        "Accuracy.OfTheInterval has left no number: run it",
        "OldSuite.OldTest is in the record, but is no test: delete the record and run the tests again",
    ]


def test_no_page_is_written_from_a_part_of_the_tests(tmp_path: Path) -> None:
    record, page = tmp_path / "verification.json", tmp_path / "verification.md"
    record.write_text(json.dumps(RECORD))
    page.write_text("the page as it was")
    result = subprocess.run([sys.executable, str(TOOL), str(record), str(tmp_path)], capture_output=True, text=True)
    assert result.returncode == 1
    assert "RoughInAPeriod.AreaOverPressureLiesBetweenPerssonAndGreenwood has left no number" in result.stderr
    assert page.read_text() == "the page as it was"


PAGE = """# Contact

<!-- measured: begin (tools/render_verification.py): PlaneStrain,
Accuracy -->

as it was

<!-- measured: end -->

after
"""


def test_a_page_has_the_tables_of_the_suites_in_its_mark(tool: ModuleType) -> None:
    other = PAGE.replace("PlaneStrain,\nAccuracy", "PlaneStrain")
    assert tool.suites_of(PAGE) == ["PlaneStrain", "Accuracy"]
    page = tool.with_tables(other, RECORD, {})
    assert "### Plane strain" in page
    assert "as it was" not in page
    assert "### Accuracy" not in page
    assert page.endswith("\nafter\n")
    assert tool.with_tables(page, RECORD, {}) == page


def test_suites_on_two_pages_are_told(tool: ModuleType) -> None:
    places, wrong = tool.places_of({Path("contact.md"): PAGE, Path("heat.md"): PAGE})
    assert places == {"PlaneStrain": "verification/heat.md", "Accuracy": "verification/heat.md"}
    assert len(wrong) == 2
    assert wrong[0] == "PlaneStrain is on two pages: verification/contact.md and heat.md"


def test_each_suite_that_records_is_on_one_page(tool: ModuleType) -> None:
    pages = {path: path.read_text() for path in sorted((ROOT / "docs" / "verification").glob("*.md"))}
    places, wrong = tool.places_of(pages)
    assert wrong == []
    tests = tool.tests_of(tool.TESTS)
    assert {suite for (suite, _), records in tests.items() if records} <= places.keys()
    assert places.keys() <= {suite for suite, _ in tests}


def record_of(tool: ModuleType, page: str) -> dict[str, dict[str, dict[str, dict[str, object]]]]:
    """The record as the tables of a page show it, of tests with the bounds that the front page needs."""
    names = {(tool.words(suite), tool.words(test)): (suite, test) for suite, test in tool.tests_of(tool.TESTS)}
    record: dict[str, dict[str, dict[str, dict[str, object]]]] = {}
    section = table = ""
    for line in page.splitlines():
        if line.startswith("### "):
            section = line[4:]
        elif line.startswith("**"):
            table = line.strip("*")
        elif line.startswith("| ") and not line.startswith(("| what |", "| --- |")) and (section, table) in names:
            name, measured, expected, tolerance, origin = (cell.strip() for cell in line[1:-1].split(" | "))
            entry: dict[str, object] = {"origin": origin}
            if tolerance:
                entry |= {"measured": float(measured), "expected": float(expected), "tolerance": float(tolerance[2:])}
            elif "…" in expected:
                low, high = map(float, expected.split(" … "))
                entry |= {"measured": float(measured), "low": low, "high": high}
            suite, test = names[section, table]
            record.setdefault(suite, {}).setdefault(test, {})[name] = entry
    return record


def test_the_front_page_has_the_numbers_of_the_pages(tool: ModuleType) -> None:
    pages = {path: path.read_text() for path in sorted((ROOT / "docs" / "verification").glob("*.md"))}
    record = {}
    for text in pages.values():
        for mark in tool.BEGIN.finditer(text):
            record |= record_of(tool, text[mark.end() :])
    front = (ROOT / "docs" / "verification.md").read_text()
    places, _ = tool.places_of(pages)
    assert tool.with_headlines(front, record, places) == front, "tools/render_verification.py writes it"


def test_sections_of_the_tests_have_different_names(tool: ModuleType) -> None:
    suites = {suite for suite, _ in tool.tests_of(tool.TESTS)}
    assert {"PlaneStrain", "OnePeriodicAxis", "PeriodicSurfaces", "RoughInAPeriod", "WavesInAPeriod"} <= suites
    assert len({tool.words(suite) for suite in suites}) == len(suites)
