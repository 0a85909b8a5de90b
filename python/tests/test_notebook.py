# SPDX-License-Identifier: BSD-3-Clause
"""A notebook shows runs, histories and figures as they are, without %matplotlib, and a bar without ipywidgets."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest

import brinell
from brinell import plot
from brinell.results import Run


@pytest.fixture(scope="module")
def run(real_folder: Path) -> Run:
    return brinell.open(real_folder)


def outputs_of(*cells: str) -> list[list[Any]]:
    """What each cell of a notebook shows."""
    nbformat = pytest.importorskip("nbformat")
    nbclient = pytest.importorskip("nbclient")
    pytest.importorskip("ipykernel")
    notebook = nbformat.v4.new_notebook(cells=[nbformat.v4.new_code_cell(cell) for cell in cells])
    nbclient.NotebookClient(notebook, timeout=120, kernel_name="python3").execute()
    return [cell.outputs for cell in notebook.cells]


def test_a_notebook_shows_figures_and_tables(real_folder: Path) -> None:
    _, figure, table, history = outputs_of(
        f"import brinell; run = brinell.open({str(real_folder)!r})",
        "brinell.plot.run_history(run)",
        "run",
        "run.history",
    )
    assert [sorted(output.data) for output in figure] == [["image/png", "text/plain"]]
    assert "Largest resistance F_X" in table[0].data["text/html"]
    assert "<th" in history[0].data["text/html"]


def test_with_the_inline_backend_a_figure_is_shown_once(real_folder: Path) -> None:
    *_, figure = outputs_of(
        "%matplotlib inline",
        f"import brinell; run = brinell.open({str(real_folder)!r})",
        "brinell.plot.run_history(run)",
    )
    assert [sorted(output.data) for output in figure] == [["image/png", "text/plain"]]


def test_a_bar_needs_no_ipywidgets(real_case: str) -> None:
    *_, outputs = outputs_of(
        "import sys; sys.modules['ipywidgets'] = None",
        "import brinell",
        f"run = brinell.Case({real_case!r}).run(progress=True, in_memory=True)",
    )
    texts = "".join(output.get("text", "") for output in outputs)
    assert "TqdmWarning" not in texts
    assert "IProgress" not in texts
    assert "step/s" in texts


def test_a_figure_is_a_picture(run: Run) -> None:
    figure: Any = plot.run_history(run)
    assert figure._repr_png_().startswith(b"\x89PNG")


def test_the_table_of_a_run_has_key_numbers_and_warnings(run: Run) -> None:
    page = run._repr_html_()
    assert "<b>tugging: two spheres" in page
    assert "P_c" in page
    assert run.warnings  # three cells per contact radius
    assert run.warnings[0].text[1:20] in page


def test_the_table_of_a_history_has_units_and_leaves_out_the_middle(run: Run) -> None:
    page = run.history._repr_html_()
    assert "[N]" in page
    assert page.count("<tr>") == 2 + 11
    assert "…" in page
    short = run.history.part(slice(0, 3))._repr_html_()
    assert short.count("<tr>") == 2 + 3
    assert "…" not in short
