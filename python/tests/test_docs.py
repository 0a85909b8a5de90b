# SPDX-License-Identifier: BSD-3-Clause
"""Links between the Markdown pages, and the pages and equations that comments name."""

import dataclasses
import re
import shutil
import subprocess
from collections.abc import Iterator
from pathlib import Path

import pytest

import brinell
from brinell import _core
from brinell._toml import tomllib
from brinell.results import FrettingCycle, Indent, RollingPass, SlidingStroke
from brinell.scenarios import SCENARIOS

ROOT = Path(__file__).resolve().parents[2]
# docs/_*: what the build of the site writes.
PAGES = [
    page
    for pattern in ("*.md", "bench/**/*.md", "cases/*/*.md", "fits/*/*.md", "docs/**/*.md")
    for page in sorted(ROOT.glob(pattern))
    if not any(part.startswith("_") for part in page.relative_to(ROOT).parts)
]
FENCED = re.compile(r"^(```|~~~).*?^\1", re.MULTILINE | re.DOTALL)
LINK = re.compile(r"\[[^\]]*\]\(([^)\s]+)\)")
HEADING = re.compile(r"^#{1,6} +(.+?) *$", re.MULTILINE)
TAG = re.compile(r"\\tag\{([^}]*)\}")
PAGE_NAMED = re.compile(r"\b(?:docs|bench)/[\w/-]+\.md\b")
EQUATIONS_NAMED = re.compile(r"\b(docs/theory/[\w-]+\.md)((?:[\s/#]*,?[\s/#]*\([a-z-]+\))+)")


def prose(page: Path) -> str:
    """Text of a page without its code blocks, in which a bracket is no link and # no heading."""
    return FENCED.sub("", page.read_text(encoding="utf-8"))


def anchors(page: Path) -> set[str]:
    """Anchors of a page's headings, as code hosts and MyST make them."""
    names = (re.sub(r"[^\w\- ]", "", heading.lower()).replace(" ", "-") for heading in HEADING.findall(prose(page)))
    return set(names)


def sources() -> Iterator[Path]:
    """Files whose comments name pages."""
    for folder in ("include", "src", "apps", "python", "tests", "tools", "bench"):
        for path in (ROOT / folder).rglob("*"):
            if path.suffix in {".hpp", ".cpp", ".py", ".pyi"}:
                yield path


@pytest.mark.parametrize("page", PAGES, ids=lambda page: str(page.relative_to(ROOT)))
def test_relative_links_lead_somewhere(page: Path) -> None:
    broken = []
    for link in LINK.findall(prose(page)):
        if re.match(r"[a-z]+:", link):
            continue
        name, _, anchor = link.partition("#")
        target = (page.parent / name).resolve() if name else page
        if not target.exists():
            broken.append(f"{link}: no such file")
        elif anchor and target.suffix == ".md" and anchor not in anchors(target):
            broken.append(f"{link}: no such heading; there are {sorted(anchors(target))}")
    assert not broken


def test_pages_named_in_comments_exist() -> None:
    missing = {
        f"{path.relative_to(ROOT)}: {name}"
        for path in sources()
        for name in PAGE_NAMED.findall(path.read_text(encoding="utf-8"))
        if not (ROOT / name).exists()
    }
    assert not missing


def test_equations_named_in_comments_exist() -> None:
    named = [
        (path, page, label)
        for path in sources()
        for page, labels in EQUATIONS_NAMED.findall(path.read_text(encoding="utf-8"))
        for label in re.findall(r"\(([a-z-]+)\)", labels)
    ]
    assert len(named) >= 8, "the pattern no longer finds the equations that the headers name"
    missing = [
        f"{path.relative_to(ROOT)}: {page} ({label})"
        for path, page, label in named
        if label not in TAG.findall((ROOT / page).read_text(encoding="utf-8"))
    ]
    assert not missing


def test_labels_of_equations_are_unique() -> None:
    labels = [label for page in sorted((ROOT / "docs/theory").glob("*.md")) for label in TAG.findall(page.read_text())]
    assert sorted(labels) == sorted(set(labels))


def columns_on_the_page() -> dict[str, list[tuple[str, str]]]:
    """Names and units of the tables of history.csv, by the line before each table."""
    page = (ROOT / "docs" / "reference" / "results-format.md").read_text(encoding="utf-8")
    section = page.split("\n## `history.csv`\n")[1].split("\n## ")[0]
    tables = re.findall(r"^([^|\n]+):\n\n((?:\|.*\n)+)", section, re.MULTILINE)
    rows = {title: [row.split(" | ", 2) for row in table.splitlines()[2:]] for title, table in tables}
    return {
        title: [(name, unit.replace("-", "1")) for names, unit, _ in table for name in re.findall(r"`(\w+)`", names)]
        for title, table in rows.items()
    }


@pytest.mark.parametrize("scenario", SCENARIOS)
def test_the_page_of_the_results_has_the_columns_of_the_history(scenario: str) -> None:
    tables = columns_on_the_page()
    shown = tables[scenario.capitalize()] + tables["All scenarios, after these"]
    assert shown == [(column.name, column.unit) for column in _core.columns()[scenario]]


@pytest.mark.parametrize(
    ("part", "kind"),
    [("indents", Indent), ("passes", RollingPass), ("cycles", FrettingCycle), ("strokes", SlidingStroke)],
)
def test_the_lists_of_the_summary_are_on_the_page_and_in_python(part: str, kind: type) -> None:
    columns = {column.name: column.unit for column in _core.columns()[part]}
    derived = {"steady", "creep_steady"} if part == "passes" else set()
    assert {field.name.rstrip("_") for field in dataclasses.fields(kind)} == columns.keys() | derived  # pass_
    endings = {name: "" if unit == "1" else "_" + unit for name, unit in columns.items()}
    keys = {name + ending.replace("^", "").replace(" ", "").replace("/", "_per_") for name, ending in endings.items()}
    page = (ROOT / "docs" / "reference" / "results-format.md").read_text(encoding="utf-8")
    assert set(re.findall(rf"`{part}\[\]\.(\w+)`", page)) == keys | derived


@pytest.mark.parametrize(
    "page",
    [
        *(
            "boundaries",
            "creepage",
            "curves",
            "fit",
            "fretting",
            "notebooks",
            "rough-sliding",
            "rough-surfaces",
            "sliding",
        ),
        "../developer/wear-laws",
    ],
)
@pytest.mark.filterwarnings("ignore::brinell.ResolutionWarning")
def test_the_code_of_a_page_runs(page: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    pytest.importorskip("pandas")
    monkeypatch.chdir(tmp_path)
    text = (ROOT / "docs" / "howto" / f"{page}.md").read_text(encoding="utf-8")
    blocks = re.findall(r"^```python\n(.*?)^```", text, re.MULTILINE | re.DOTALL)
    assert blocks
    names: dict[str, object] = {}
    for block in blocks:
        exec(compile(block, f"{page}.md", "exec"), names)


def test_the_curve_of_the_page_is_that_of_its_case_file(tmp_path: Path) -> None:
    text = (ROOT / "docs" / "howto" / "curves.md").read_text(encoding="utf-8")
    (curve,) = re.findall(r"^```text\n(.*?)^```", text, re.MULTILINE | re.DOTALL)
    (table,) = re.findall(r"^```toml\n(.*?)^```", text, re.MULTILINE | re.DOTALL)
    (tmp_path / "100Cr6.csv").write_text(curve, encoding="utf-8")
    shape = 'scenario = "indentation"\nlower.shape.type = "flat"\nupper.shape = {type = "sphere", radius = "1 mm"}\n'
    drive = 'upper.material.rigid = true\nindentation.load = ["1 N", 0]\n'
    case = brinell.Case(shape + drive + table, file=tmp_path / "case.toml")
    law = brinell.Table.from_file(tmp_path / "100Cr6.csv", unit="MPa", strain="%")
    hardening = tomllib.loads(case.to_toml())["lower"]["material"]["hardening"]
    assert (tuple(hardening["plastic_strain"]), tuple(hardening["stress"])) == (law.plastic_strain, law.stress)


@pytest.mark.parametrize("page", ["README.md", "docs/install.md", "Dockerfile"])
def test_all_pages_install_the_packages_that_the_setup_does(page: str) -> None:
    """One line: what a newcomer reads in two places should not differ."""
    setup = subprocess.run([ROOT / "tools" / "setup.sh", "list"], check=True, capture_output=True, text=True).stdout
    text = (ROOT / page).read_text(encoding="utf-8").replace("\\\n", " ")
    lines = re.findall(r"apt(?:-get)? install((?: +[\w.-]+)+)", text)
    packages = [word for word in lines[0].split() if not word.startswith("-")]
    assert packages == setup.split()
    others = [line for line in lines[1:] if "-dev" in line]  # none but this one compiles anything
    assert others == []


def test_what_compiles_is_there_where_the_engine_asks_for_it() -> None:
    """Each library of CMakeLists.txt has its package."""
    text = (ROOT / "CMakeLists.txt").read_text(encoding="utf-8")
    packages = (ROOT / "tools" / "setup.sh").read_text(encoding="utf-8").lower()
    wanted = set(re.findall(r"^find_package\((\w+)", text, flags=re.MULTILINE)) - {"PkgConfig", "OpenMP"}
    assert wanted == {"Eigen3", "fmt", "tomlplusplus", "nlohmann_json", "CLI11", "HDF5", "ZLIB"}
    for library in wanted:
        name = library.lower().replace("_", "-")
        assert any(package in packages for package in (f"lib{library.lower()}-dev", f"{name}3-dev", f"{name}1g-dev"))


def test_the_container_has_the_libraries_that_the_extension_needs() -> None:
    """The second stage of the Dockerfile has no -dev packages, which would bring them along."""
    if not all(map(shutil.which, ("objdump", "dpkg"))):
        pytest.skip("no objdump or dpkg")
    needed = subprocess.run(["objdump", "-p", _core.__file__], check=True, capture_output=True, text=True).stdout
    stage = (ROOT / "Dockerfile").read_text(encoding="utf-8").rpartition("FROM ")[2]
    of_debian = ("libc.so", "libm.so", "libgcc_s.so", "libstdc++.so", "ld-linux")  # what python3 itself needs
    for library in re.findall(r"NEEDED +(\S+)", needed):
        if not library.startswith(of_debian):
            owner = subprocess.run(["dpkg", "-S", f"*/{library}"], capture_output=True, text=True).stdout
            packages = {line.partition(":")[0] for line in owner.splitlines() if "-dev" not in line}
            assert any(package in stage.split() for package in packages), (library, packages)


def test_pages_call_the_command_by_one_name() -> None:
    texts = [*PAGES, *ROOT.glob("cases/*/case.toml")]
    assert [path.name for path in texts if "-m brinell" in path.read_text(encoding="utf-8")] == []


NAMED = re.compile(r"`(\w+)` \(([\w/.]+)\)")


def is_named_in(name: str, file: str) -> bool:
    paths = (ROOT / top / file for top in ("include/brinell", "src"))
    return any(path.is_file() and re.search(rf"\b{name}\b", path.read_text("utf-8")) for path in paths)


def missing_names(text: str) -> list[str]:
    """Rows of a glossary whose file does not exist or has no such name, and rows that name none."""
    missing = []
    for row in re.findall(r"^\| (?!word |---)(.*) \|$", text, re.MULTILINE):
        names = NAMED.findall(row)
        if not names or not all(map(is_named_in, *zip(*names, strict=True))):
            missing.append(row)
    return missing


def test_the_words_of_the_glossary_are_in_their_files() -> None:
    text = (ROOT / "docs/developer/glossary.md").read_text("utf-8")
    assert missing_names(text) == []
    *tables, _ = re.findall(r"^\| ---.*\n((?:\|.*\n)+)", text, re.MULTILINE)
    words = [[row.split(" | ")[0] for row in table.splitlines()] for table in tables]
    assert words == [sorted(rows) for rows in words]
    assert sum(map(len, words)) > 50


def test_a_word_that_has_left_its_file_is_missed() -> None:
    head = "| word | meaning | name and file |\n| --- | --- | --- |\n"
    kept = "| place | offset | `Place` (elastoplastic/placement.hpp) |\n"
    assert missing_names(head + kept) == []
    for row in (
        "gone | | `Gone` (elastoplastic/placement.hpp)",
        "moved | | `Place` (elastoplastic/place.hpp)",
        "no | name",
    ):
        assert missing_names(f"{head}| {row} |\n{kept}") == [row]
