# SPDX-License-Identifier: BSD-3-Clause
"""The scripts that say what a change touches, which tests are long and where the time went."""

import csv
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path

import pytest

TOOLS = Path(__file__).resolve().parents[2] / "tools"


@pytest.fixture(autouse=True)
def tools() -> Iterator[None]:
    sys.path.insert(0, str(TOOLS))
    yield
    sys.path.remove(str(TOOLS))


def test_a_floor_is_touched_with_all_that_may_include_it() -> None:
    import changes

    assert changes.floors({"src/contact/patches.cpp", "docs/index.md"}) == [
        "device",
        "contact",
        "elastoplastic",
        "simulation",
        "quality",
        "io",
    ]
    assert changes.floors({"include/brinell/green/elastic.hpp"}) == [f for f in changes.FLOORS if f != "foundation"]
    assert changes.floors({"tests/unit/green/cuboid_test.cpp"}) == ["green"], "others do not see a test"
    assert changes.floors({"docs/index.md", "python/brinell/cli.py"}) == []
    for file in ("tests/support/order.hpp", "CMakeLists.txt", "cmake/tests.cmake"):
        assert changes.floors({file}) == list(changes.FLOORS)
    assert changes.floors(None) == list(changes.FLOORS)


def test_a_header_touches_what_includes_it_however_far() -> None:
    import changes

    assert changes.sources({"src/io/case/schema.md", "tests/unit/green/cuboid_test.cpp"}) == []
    assert changes.sources({"src/contact/gone.cpp"}) == []
    everything = changes.sources(None)
    assert everything == changes.sources({"CMakePresets.json"})
    header = "include/brinell/foundation/grid.hpp"
    touched = set(changes.sources({header}))
    headers = {file for file in changes.includers()[header] if file.endswith(".hpp")}
    assert headers, "so that sources include it over others, too"
    assert len(everything) / 4 < len(touched) < len(everything)
    assert touched >= set(changes.sources(headers))
    source = min(touched)
    assert changes.sources({source}) == [source]


def test_a_unity_file_is_touched_with_one_of_its_sources(tmp_path: Path) -> None:
    import changes

    for target, source in (
        ("brinell_numerics", "src/contact/a.cpp"),
        ("brinell_app", "apps/b.cpp"),
        ("brinell_cli_tests", "c.cpp"),
    ):
        unity = tmp_path / f"CMakeFiles/{target}.dir/Unity/unity_0_cxx.cxx"
        unity.parent.mkdir(parents=True)
        unity.write_text(f'/* */\n#include "{changes.ROOT / source}"\n#include "{changes.ROOT / "src/other.cpp"}"\n')
    assert changes.unity_files(tmp_path, {"src/contact/a.cpp", "c.cpp"}) == [
        str(tmp_path / "CMakeFiles/brinell_numerics.dir/Unity/unity_0_cxx.cxx")
    ]
    assert changes.unity_files(tmp_path, set()) == []


def test_the_base_is_the_last_commit_and_may_be_given(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    import changes

    monkeypatch.setattr(changes, "ROOT", tmp_path)
    monkeypatch.delenv("BRINELL_BASE", raising=False)

    def git(*arguments: str) -> None:
        who = ["-c", "user.name=a", "-c", "user.email=a@b"]
        subprocess.run(["git", "-C", str(tmp_path), *who, *arguments], check=True, capture_output=True)

    git("init", "-b", "main")
    for number in range(3):
        (tmp_path / f"file{number}").write_text("")
        git("add", ".")
        git("commit", "-m", f"{number}")
        if number == 0:
            assert changes.changed_files() is None, "no earlier commit: everything"
    assert changes.changed_files() == {"file2"}
    (tmp_path / "new").write_text("")
    (tmp_path / "file0").unlink()
    assert changes.changed_files() == {"file0", "file2", "new"}
    git("update-ref", "refs/remotes/origin/main", "HEAD~2")
    assert changes.changed_files() == {"file0", "file1", "file2", "new"}, "since the branch has left origin/main"
    monkeypatch.setenv("BRINELL_BASE", "HEAD")
    assert changes.changed_files() == {"file0", "new"}
    monkeypatch.setenv("BRINELL_BASE", "nothing")
    with pytest.raises(SystemExit, match="no commit here"):
        changes.changed_files()


def test_a_long_test_that_is_none_is_found() -> None:
    import check_long_tests

    text = "# why\nverification.A.B 3\ncli.C.D/1 20\nunit.green.E.F 0.5\n"
    tests = {"verification.A.B": {"verification", "long"}, "cli.C.D/1": {"cli", "long"}, "unit.green.E.F": {"long"}}
    assert check_long_tests.unlike(text, tests) == []
    del tests["unit.green.E.F"]
    assert check_long_tests.unlike(text, tests) == ["4: unit.green.E.F is no test"]
    assert check_long_tests.unlike(text, tests | {"brinell_unit_green_tests_NOT_BUILT": set()}) == []
    assert check_long_tests.unlike("verification.A.B\n" + text, tests)[0].startswith("1: not a name and its seconds")
    assert "5: cli.C.D/1 is there twice" in check_long_tests.unlike(text + "cli.C.D/1 2\n", tests)


CTEST = '<testsuite><testcase name="cli.A.B" classname="cli.A.B" time="12.5"/></testsuite>'
PYTEST = '<testsuite><testcase name="test_a" classname="python.tests.test_x" time="2.5"/></testsuite>'


def test_stages_and_slowest_tests_are_told_and_kept(tmp_path: Path) -> None:
    (tmp_path / "stages.tsv").write_text("100\tmake check\n20\tmake test\n")
    (tmp_path / "ctest.xml").write_text(CTEST)
    (tmp_path / "pytest.xml").write_text(PYTEST)
    files = [tmp_path / name for name in ("stages.tsv", "ctest.xml", "pytest.xml", "none.xml")]
    for _ in range(2):
        told = subprocess.run(
            [sys.executable, TOOLS / "ci_times.py", *files, "--csv", tmp_path / "ci.csv", "--machine", "m; 2 cores"],
            capture_output=True,
            text=True,
            check=True,
        ).stdout
    assert "2.0 min in all" in told
    assert told.index("cli.A.B") < told.index("test_x.py::test_a")
    assert "not in tests/long_tests.txt: cli.A.B" in told
    with (tmp_path / "ci.csv").open() as file:
        rows = list(csv.DictReader(file))
    assert [(row["kind"], row["name"], row["seconds"]) for row in rows[:4]] == [
        ("stage", "make check", "100.0"),
        ("stage", "make test", "20.0"),
        ("test", "cli.A.B", "12.5"),
        ("test", "test_x.py::test_a", "2.5"),
    ]
    assert len(rows) == 8
    assert all(row["machine"] == "m; 2 cores" for row in rows)


def test_a_comment_stands_alone() -> None:
    import check_comments

    text = """
/// Depth of the surface,
/// that of the texture included. That is a continuation.
double depth;
/// The same along y.
double depth_y; ///< likewise
int n;   ///< which is even
int m;   ///< number of rows that are read
// What follows is a block.
/// Which body yields first.
bool b; ///< The Same [m]
"""
    assert check_comments.pointing(text) == [
        (5, "The same"),
        (6, "likewise"),
        (7, "which"),
        (9, "What"),
        (11, "The Same"),
    ]


def test_a_page_that_shows_another_output_is_found() -> None:
    import check_tour

    shown = "step 1: 2.70 GPa, 1.1e-03\ncommit\n"
    assert check_tour.differences(shown, shown) == []
    assert check_tour.differences(shown, shown.replace("2.70", "2.71")) == [], "rounded differently"
    assert check_tour.differences(shown, shown.replace("1.1e-03", "1.0e-03")) == []
    for other in ("2.72", "-2.70", "2.70e+01"):
        assert len(check_tour.differences(shown, shown.replace("2.70", other))) == 1
    assert len(check_tour.differences(shown, shown.replace("commit", "restore"))) == 1
    assert check_tour.differences(shown, shown + "more\n") == ["2 lines are shown, 3 are printed"]
