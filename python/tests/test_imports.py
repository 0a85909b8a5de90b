# SPDX-License-Identifier: BSD-3-Clause
"""Modules import those below them: without a circle, whichever of them comes first."""

import ast
from graphlib import TopologicalSorter
from pathlib import Path

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
    above = ("brinell.plot", "brinell.report", "brinell.sweeps", "brinell.asperities", "brinell.cli")
    for module in FILES:
        if module != "brinell" and not module.startswith((*above, "brinell.__main__")):
            assert [name for name in imported(module) if name.startswith(above)] == [], module
