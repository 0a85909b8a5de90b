# SPDX-License-Identifier: BSD-3-Clause
"""Texts of the user appear as they are written: titles, folders and files with any letters."""

from __future__ import annotations

import html
import json
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest
from click.testing import CliRunner
from matplotlib.text import Text

import brinell
from brinell.export import export_vti
from brinell.plot import style
from brinell.report import inputs, write_report
from brinell.results import Run
from figure_parts import legend_of
from vtk_images import VtkhdfFile, vti_image

PLAIN = r"$NAME_$SIZE $a_1_2$ 5 % _x_ #1 <b> & &amp; 'q' \alpha \$ Größe"
QUOTED = f'{PLAIN} "'
CHINESE = f"{QUOTED} 中文"

CASE = """
scenario = "indentation"
[lower]
shape = {{ type = "flat" }}
material.young_modulus = "210 GPa"
material.poisson_ratio = 0.3
material.hardening = {{ law = "linear", yield_stress = "600 MPa", modulus = "2 GPa" }}
texture = {{ type = "height_map", file = {file}, spacing = ["50 um", "50 um"] }}
[upper]
shape = {{ type = "sphere", radius = "1 mm" }}
material = {{ rigid = true }}
[indentation]
load = ["{load} N", 0]
steps = 2
[grid]
resolution = 4
"""

pytestmark = pytest.mark.filterwarnings(
    "ignore::brinell.ResolutionWarning", "ignore::brinell.CaseWarning", "ignore:no installed font:UserWarning"
)


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A folder with the results of two cases of that title, and their case files."""
    folder = tmp_path_factory.mktemp("texts") / CHINESE
    folder.mkdir()
    np.savetxt(folder / f"{CHINESE}.txt", np.zeros((4, 4)))
    for load in (5, 10):
        file = folder / f"{CHINESE} {load}.toml"
        text = CASE.format(file=json.dumps(f"{CHINESE}.txt", ensure_ascii=False), load=load)
        file.write_text(f"title = {json.dumps(f'{CHINESE} {load}', ensure_ascii=False)}\n{text}", encoding="utf-8")
        brinell.Case.from_file(file).run(folder / f"{CHINESE} {load}")
    return folder


@pytest.fixture(scope="module")
def runs(folder: Path) -> list[Run]:
    return [brinell.open(folder / f"{CHINESE} {load}") for load in (5, 10)]


def test_title_in_python(runs: list[Run]) -> None:
    assert [run.title for run in runs] == [f"{CHINESE} 5", f"{CHINESE} 10"]
    assert runs[0].case("title") == runs[0].title
    assert html.escape(CHINESE) in runs[0]._repr_html_()


def drawn(text: str) -> str:
    """What matplotlib draws of a text without mathematics of its own."""
    shown, is_math = Text(0, 0, text)._preprocess_math(text)  # type: ignore[attr-defined]
    assert is_math is False
    return str(shown)


def test_figures_of_several_runs(runs: list[Run], tmp_path: Path) -> None:
    boxes = [run.title.replace("中文", "□□") for run in runs]
    figure = brinell.plot.load_depth(runs)
    written = [drawn(text) for text in legend_of(figure.axes[0])]
    assert all(one in written or box in written for one, box in zip([run.title for run in runs], boxes, strict=True))
    with_symbols = brinell.plot.contact_pressure(runs)
    for ending in style.FORMATS:
        assert style.save(figure, tmp_path, f"load{CHINESE}", [ending])
        assert style.save(with_symbols, tmp_path, f"pressure{CHINESE}", [ending])


def test_a_letter_that_no_font_has_is_told(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(style, "_is_in_a_font", lambda letter: letter != "中")
    with pytest.warns(UserWarning, match="no installed font has '中' of 'a 中 _b': boxes are drawn; install"):
        assert style.as_written("a 中 _b") == "a □ _b"


@pytest.mark.parametrize("text", [PLAIN, QUOTED, r"\$", "$", "$$", "a$b", r"a\$b$c\\$"])
def test_any_text_is_drawn_as_written(text: str) -> None:
    assert drawn(style.as_written(text)) == text


def test_curves_named_by_their_folders() -> None:
    from brinell.plot import differences

    assert drawn(differences.told("lower.texture.file", "$a_1$.txt")) == "lower file $a_1$.txt"


def test_figure_of_a_surface(folder: Path, tmp_path: Path) -> None:
    rng = np.random.default_rng(1)
    map_file = tmp_path / f"{CHINESE}.txt"
    np.savetxt(map_file, rng.normal(size=(8, 8)))
    figure = tmp_path / f"{CHINESE}.png"
    command = [sys.executable, "-m", "brinell", "surface", "show", str(map_file), "--spacing", "1um", "--unit", "um"]
    done = subprocess.run([*command, "--figure", str(figure)], capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    assert figure.is_file()


def test_report(runs: list[Run], folder: Path, tmp_path: Path) -> None:
    text = write_report(runs[0], tmp_path / f"{CHINESE}.html").read_text(encoding="utf-8")
    shown = html.escape(f"{CHINESE} 5").replace("&#x27;", "&#39;").replace("&quot;", "&#34;")
    assert f"<h1>{shown}</h1>" in text
    assert f"<title>{shown} – brinell</title>" in text
    assert f"<code>{shown}</code>" in text
    (file,) = inputs._flattened({"file": "F_n a_b"}, "lower", "texture.")
    assert (file.value, file.is_text) == ("F_n a_b", True)  # no symbols in names


def test_exports(runs: list[Run], tmp_path: Path) -> None:
    run = runs[0]
    written = export_vti(run, tmp_path / CHINESE)
    image = vti_image(written[0].parent / f"lower_volume_{run.history.steps:06d}.vti")
    np.testing.assert_array_equal(
        image.cell_data["von_mises_stress"][::-1], run.snapshot("final").lower.von_mises_stress
    )
    assert VtkhdfFile(run.file).blocks(float(run.history.steps))
    assert run.to_pyvista("final").n_blocks


def test_commands(folder: Path, tmp_path: Path) -> None:
    from brinell.plot.cli import plot

    results = [str(folder / f"{CHINESE} {load}") for load in (5, 10)]
    for arguments in (["all", results[0]], ["indentation", *results], ["fields", results[0]], ["history", results[0]]):
        result = CliRunner().invoke(plot, [*arguments, "-o", str(tmp_path / CHINESE)])
        assert result.exit_code == 0, result.output
    for command in ("check", "cite"):
        file = folder / f"{CHINESE} 5.toml"
        arguments = [sys.executable, "-m", "brinell", command, str(file)]
        done = subprocess.run(arguments, capture_output=True, text=True, check=False)
        assert done.returncode == 0, done.stderr
        assert command == "cite" or f"# Resolved case of {file}" in done.stdout


def test_citations_of_the_result(runs: list[Run]) -> None:
    assert runs[0].sources == brinell.Case(runs[0].case_text).citations()
