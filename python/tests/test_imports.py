# SPDX-License-Identifier: BSD-3-Clause
"""Modules import those below them: without a circle, whichever of them comes first."""

import ast
import importlib
import subprocess
import sys
from graphlib import TopologicalSorter
from pathlib import Path

import pytest

import brinell

PACKAGE = Path(brinell.__file__).parent
FILES = {
    ".".join(("brinell", *path.relative_to(PACKAGE).with_suffix("").parts)).removesuffix(".__init__"): path
    for path in PACKAGE.rglob("*.py")
}


def imported(module: str) -> set[str]:
    """Modules of the package that this one needs when it is imported, among them the packages that they are in."""
    found: set[str] = set()
    for node in ast.parse(FILES[module].read_text(encoding="utf-8")).body:
        if isinstance(node, ast.ImportFrom) and node.module is not None and node.module.startswith("brinell"):
            inside = {f"{node.module}.{name.name}" for name in node.names} & FILES.keys()
            for name in inside or {node.module}:
                parts = name.split(".")
                found |= {".".join(parts[:count]) for count in range(2, len(parts) + 1)}
    return {name for name in found if name != module and not module.startswith(f"{name}.")}


def test_no_module_needs_itself() -> None:
    graph = {module: imported(module) for module in FILES if module != "brinell"}
    assert "brinell.summary" in graph["brinell.scenarios.tugging"]
    assert "brinell.scenarios" in graph["brinell.results.columns"]
    TopologicalSorter(graph).prepare()  # raises CycleError, which names them


def test_scenarios_are_below_figures_and_reports() -> None:
    """So that `import brinell` stays fast: what draws is imported by the functions that draw."""
    commands = ("cli", "completion", "python_commands")
    above = tuple(f"brinell.{name}" for name in ("plot", "report", "sweeps", "fits", "asperities", "app", *commands))
    for module in FILES:
        if module != "brinell" and not module.startswith((*above, "brinell.__main__")):
            assert [name for name in imported(module) if name.startswith(above)] == [], module


def test_importing_the_package_imports_nothing_else() -> None:
    code = "import sys; before = set(sys.modules); import brinell; print(sorted(set(sys.modules) - before))"
    found = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True).stdout
    heavy = ("numpy", "h5py", "matplotlib", "pandas", "click", "importlib.metadata", "brinell._core", "brinell.case")
    assert [name for name in heavy if f"'{name}'" in found] == []


def test_editors_see_the_names_that_are_imported_when_they_are_used() -> None:
    """The imports for type checkers, which do not run, and the table with which names are found are the same."""
    tree = ast.parse(FILES["brinell"].read_text(encoding="utf-8"))
    block = next(n for n in tree.body if isinstance(n, ast.If) and ast.unparse(n.test) == "TYPE_CHECKING")
    seen = {}
    for node in block.body:
        if isinstance(node, ast.ImportFrom):
            seen |= {alias.asname or alias.name: (node.module, alias.name) for alias in node.names}
    assert sorted([*seen, "__version__"]) == sorted(brinell.__all__) == dir(brinell)
    for name, (module, original) in seen.items():
        found = getattr(importlib.import_module(str(module)), original)
        assert getattr(brinell, name) is found, name


def test_names_of_modules_and_wrong_names() -> None:
    assert brinell.results.Run is brinell.Run
    with pytest.raises(AttributeError, match="did you mean Sphere"):
        _ = brinell.Spere  # type: ignore[attr-defined]
    assert not hasattr(brinell, "__no_such_name__")
