# SPDX-License-Identifier: BSD-3-Clause
# ruff: noqa: E402 (the extra is asked for first)
"""Numbers of a user's own in the table of a sweep, and the report of a sweep."""

from __future__ import annotations

import re
from pathlib import Path
from typing import Any

import matplotlib
import numpy as np
import pytest

import brinell
from brinell import Case, InputError
from brinell.cli import main

pd = pytest.importorskip("pandas")
pytest.importorskip("pyarrow")
pytest.importorskip("scipy")

from brinell.plot import load_depth, sweep_numbers
from brinell.report import write_sweep_report
from brinell.sweeps import open_sweep, residual_stress

CASE = """scenario = "indentation"
[lower]
shape = {type = "flat"}
material = {young_modulus = "210 GPa", poisson_ratio = 0.3, hardening = {law = "perfect", yield_stress = "900 MPa"}}
[upper]
shape = {type = "sphere", radius = "5 mm"}
material = {rigid = true}
[indentation]
load = ["100 N", 0]
steps = 2
[grid]
resolution = 4
"""
OVER = {"indentation.load": [100.0, 200.0], "lower.material.poisson_ratio": [0.25, 0.3]}

pytestmark = pytest.mark.filterwarnings("ignore::brinell.ResolutionWarning")


def depth(run: brinell.Run) -> dict[str, Any]:
    """A number of a user's own."""
    return {"depth_um": np.float64(1e6 * run.indents[0].residual_depth), "word": "deep"}


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    path = tmp_path_factory.mktemp("sweep") / "loads"
    brinell.sweep(Case(CASE), OVER, output=path, workers=1, progress=False, numbers=[depth, residual_stress])
    return path


def test_own_numbers_are_columns(folder: Path) -> None:
    result = open_sweep(folder)
    table = result.table.set_index("index")
    for index, run in result.runs.items():
        assert table.loc[index, "depth_um"] == 1e6 * run.indents[0].residual_depth
        stress = run.snapshot("final").lower.stress["xx"]
        assert table.loc[index, "residual.lower.min_xx_Pa"] == stress.min()
        assert table.loc[index, "residual.lower.max_xx_Pa"] == stress.max()
        z = run.snapshot("final").lower.z
        assert table.loc[index, "residual.lower.min_xx_depth_m"] == z[stress.min(axis=(1, 2)).argmin()]
    assert set(table["word"]) == {"deep"}
    assert "depth_um" in (folder / "table.csv").read_text().splitlines()[0]
    more = result.with_numbers(lambda run: {"passes": len(run.indents)})
    assert more.table["passes"].tolist() == [1] * 4
    assert "passes" not in result.table


@pytest.mark.parametrize(
    ("function", "message"),
    [
        (lambda run: 1 / 0, "numbers: <lambda> of run 0: ZeroDivisionError: division by zero"),
        (lambda run: 3.0, r"<lambda> of run 0 returns 3\.0; allowed: numbers by their names"),
        (lambda run: {"a": [1, 2]}, r"returns 'a': \[1, 2\]; allowed: a name, and a number or a word"),
        (lambda run: {"status": 1}, "the table has a column status already"),
        (3, "numbers = 3; allowed: a function of a run"),
    ],
)
def test_a_function_that_gives_no_numbers_is_told(folder: Path, function: Any, message: str) -> None:
    with pytest.raises(InputError, match=message):
        open_sweep(folder).with_numbers(function)


def test_the_command_line_takes_functions_of_files(
    folder: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    (tmp_path / "case.toml").write_text(CASE)
    (tmp_path / "mine.py").write_text("def twice(run):\n    return {'twice': 2 * run.indents[0].residual_depth}\n")
    words = [
        "sweep",
        str(tmp_path / "case.toml"),
        "--over",
        "indentation.load=100",
        "-o",
        str(tmp_path / "out"),
        "--quiet",
    ]
    with pytest.raises(SystemExit) as end:
        main(
            [
                *words,
                "--quiet",
                "--workers",
                "1",
                "--numbers",
                f"{tmp_path / 'mine.py'}:twice",
                "--numbers",
                "residual_stress",
            ]
        )
    assert end.value.code == 0
    table = open_sweep(tmp_path / "out").table
    assert table["twice"][0] == 2 * table["indents.0.residual_depth_m"][0]
    assert table["residual.lower.min_yy_Pa"][0] < 0.0
    for text, message in (
        ("nothing", "allowed: residual_stress, or FILE.py:FUNCTION"),
        ("mine.py:no", "a file that exists"),
    ):
        with pytest.raises(SystemExit) as end:
            main([*words, "--numbers", text])
        assert end.value.code == 2
        assert message in capsys.readouterr().err


def test_figures_take_the_runs_of_a_sweep_and_name_them(folder: Path) -> None:
    result = open_sweep(folder)
    for given in (result, result.runs, list(result.runs.values())):
        fig = load_depth(given)
        texts = {text.get_text() for text in fig.findobj(matplotlib.text.Text)}
        assert "lower poisson ratio 0.25,  load 100 N, 0" in texts


def test_key_numbers_over_what_varies(folder: Path) -> None:
    result = open_sweep(folder)
    fig = sweep_numbers(result)
    assert fig is not None
    panel = next(
        ax for ax in fig.axes if ax.get_title(loc="left") == "Largest load" or ax.get_title() == "Largest load"
    )
    assert panel.get_xlabel() == "indentation.load  [N]"
    assert [line.get_xdata().tolist() for line in panel.lines] == [[100, 200], [100, 200]]
    assert {line.get_label() for line in panel.lines} == {"lower poisson ratio 0.25", "lower poisson ratio 0.3"}
    other = sweep_numbers(result, "lower.material.poisson_ratio")
    assert other is not None
    assert other.axes[0].get_xlabel() == "lower.material.poisson_ratio"
    with pytest.raises(InputError, match="over = 'grid.resolution'; allowed: .*indentation.load"):
        sweep_numbers(result, "grid.resolution")
    assert sweep_numbers([result.runs[0]]) is None


def test_the_report_of_a_sweep(folder: Path, capsys: pytest.CaptureFixture[str]) -> None:
    with pytest.raises(SystemExit) as end:
        main(["report", str(folder)])
    assert end.value.code == 0
    assert capsys.readouterr().out.strip() == str(folder / "report.html")
    page = (folder / "report.html").read_text(encoding="utf-8")
    rows = re.findall(r"<tr><th scope=\"row\">(.*?)</tr>", page)
    assert len(rows) == 4
    assert "100, 0" in rows[0]
    assert "depth_um" in page
    assert "residual.lower.min_xx_Pa" in page
    assert "lower.material.poisson_ratio" in page
    assert page.count('<img src="data:image/svg+xml') >= 2
    assert "http" not in re.sub(r"data:[^\"]*", "", page).replace("http-equiv", "")
    (folder / "runs" / "000000" / "report.html").write_text("page of a run")
    again = write_sweep_report(open_sweep(folder), folder / "report.html").read_text(encoding="utf-8")
    assert '<a href="runs/000000/report.html">0</a>' in again
