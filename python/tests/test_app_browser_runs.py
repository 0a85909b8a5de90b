# SPDX-License-Identifier: BSD-3-Clause
"""Runs and results on the page of `brinell app` in headless Chromium, as in test_app_browser.py."""

import json
import shlex
import shutil
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

import brinell
from app_page import CONTROL_A, ENTER, Page
from app_server import SMALL
from brinell.app.case_text import values_of
from brinell.plot import style
from brinell.results import open_run
from test_report_browser import CHROMIUM, DRIVER, NEEDED

pytestmark = pytest.mark.skipif(
    not NEEDED and (CHROMIUM is None or DRIVER is None),
    reason="no chromium with its driver: apt-get install chromium chromium-driver",
)

ROOT = Path(__file__).parents[2]
PAPER = ROOT / "cases" / "tugging-paper" / "case.toml"


def test_runs_are_compared_side_by_side(page: Page) -> None:
    page.click("#run")
    page.finished(1)
    page.type("lower.material.hardening.yield_stress", "600")
    page.wait("page.values['lower.material.hardening.yield_stress'] === '600 MPa' && !page.checked.errors.length")
    page.settled()
    page.click("#run")
    page.finished(2)
    page.wait("document.getElementById('curve').data.length === 2")
    page.wait("document.getElementById('curve').data.every((one) => one.x.length === 40)")  # all steps
    names = page.js("page.shown.map((one) => one.name)")
    for name, (x, y, drawn) in zip(names, page.curves().values(), strict=True):
        history = open_run(page.server.folder / name).history
        assert x * 1e-6 == pytest.approx(history["approach"], rel=1e-9)
        assert y == pytest.approx(history["F_n"], rel=1e-9, abs=1e-12)
        assert drawn["line"]["color"] in style.CATEGORIES
    dashes = {drawn["line"]["dash"] for *_, drawn in page.curves().values()}
    assert len(dashes) == 2
    page.wait("document.getElementById('shown').children.length === 2")

    page.tab("numbers")
    table = page.one("#numbers").text
    assert "lower.material.hardening.yield_stress 900 MPa 600 MPa" in table
    assert "Hardness" in table

    page.tab("fields")
    pictures = {
        "section": "Von Mises stress",
        "map of the contact": "Contact pressure",
        "surface in 3-D": "Residual height",
    }
    for kind, title in pictures.items():
        page.choose("#kind", kind)
        captions = "[...document.querySelectorAll('#pictures figcaption')].map((one) => one.textContent)"
        page.wait(f"{captions}.filter((text) => text.includes('{title}')).length === 2 && picturing === pictured")
        layer = "canvas" if kind == "surface in 3-D" else ".heatmaplayer image"
        page.wait(f"document.querySelectorAll('#pictures figure {layer}').length >= 2")
        labels = page.js(
            "[...document.querySelectorAll('#pictures .plot')].map((one) => one.getAttribute('aria-label'))"
        )
        assert len(labels) == 2
        assert all(" from " in label for label in labels)
        if kind == "section":
            ranges = page.js("[...document.querySelectorAll('#pictures .plot')].map((one) => one.data[0].zmax)")
            assert ranges[0] == ranges[1]  # of one scale
            page.picture("section")


def test_what_is_empty_in_all_that_is_shown_stands_in_no_menu(page: Page) -> None:
    def offered(menu: str) -> set[str]:
        return set(page.js(f"[...document.getElementById('{menu}').options].map((one) => one.value)"))

    def text_of(column: str) -> str:
        entry = f"[...document.getElementById('y').options].find((one) => one.value === '{column}')"
        return str(page.js(f"{entry}.text"))

    columns = page.js("page.live.columns")
    filled = {name for name, values in columns.items() if any(values)}
    assert {"approach", "F_n", "dissipation_lower"} <= filled
    empty = {"current", "contact_temperature", "dissipation_upper"}  # no voltage, no heat, and a rigid body
    assert not empty & filled
    assert offered("x") == offered("y") == filled
    assert empty <= set(page.one("#y").get_attribute("title").rpartition(": ")[2].split(", "))

    page.choose("#y", text_of("dissipation_lower"))
    page.tab("fields")
    page.choose("#kind", "section")
    page.wait("document.getElementById('field').value && picturing === pictured")
    assert "equivalent_plastic_strain" in offered("field")
    page.type("lower.material.hardening.yield_stress", "900000")  # it does not yield
    page.wait("page.live?.done && !page.live.columns.dissipation_lower.some(Boolean) && picturing === pictured")
    page.settled()
    assert "dissipation_lower" in offered("y")  # what is chosen stays
    assert "max_equivalent_plastic_strain" not in offered("y")
    page.tab("curves")
    page.choose("#y", text_of("F_n"))
    assert "dissipation_lower" not in offered("y")
    page.tab("fields")
    page.wait("picturing === pictured")
    page.choose("#field", page.js("start.titles.von_mises_stress"))
    page.wait("picturing === pictured && page.live.picture.name === 'von_mises_stress'")
    assert "equivalent_plastic_strain" not in offered("field")


def test_map_is_that_of_the_result(page: Page) -> None:
    page.click("#run")
    page.finished(1)
    page.tab("fields")
    page.wait("document.querySelector('#pictures .heatmaplayer image')")
    name = page.js("page.shown[0].name")
    snapshot = open_run(page.server.folder / name).snapshot("aligned")
    drawn = page.js("document.querySelector('#pictures .plot').data[0]")
    assert np.max([[value or 0 for value in row] for row in drawn["z"]]) * 1e9 == pytest.approx(
        snapshot.contact.pressure.max(), rel=1e-4
    )


def test_fields_follow_a_run(page: Page) -> None:
    page.unfold()
    for key, value in {"indentation.steps": "300", "grid.resolution": "14", "output.snapshots": "every 2"}.items():
        page.type(key, value)
        page.wait(f"{json.dumps(key)} in page.values && !page.checked.errors.length")
    page.tab("fields")
    page.click("#run")
    caption = "document.querySelector('#pictures figcaption')?.textContent"
    first = page.wait(f"/, step [0-9]+$/.test({caption}) && page.jobs[0].state === 'running' && {caption}")
    page.wait(f"page.jobs[0].state === 'running' && {caption} !== {json.dumps(first)}")
    page.click("#jobs button")
    page.wait("page.jobs[0].state === 'stopped'")


def test_a_run_is_stopped_and_goes_on(page: Page) -> None:
    page.unfold()
    page.type("indentation.steps", "120")
    page.settled()
    page.type("grid.resolution", "14")
    page.wait("page.values['grid.resolution'] === 14 && !page.checked.errors.length")
    page.click("#run")
    page.wait("document.querySelector('#jobs progress')?.value > 1")
    assert page.js("document.querySelector('#jobs progress').getAttribute('aria-label')").startswith("Progress of")
    page.wait("document.getElementById('curve').data[0].x.length > 1")  # the curve follows the run
    assert not page.js("page.shown[0].complete")
    name = page.js("page.shown.at(-1).name")
    page.click("#jobs button")
    page.wait("page.jobs[0].state === 'stopped'")
    assert not (page.server.folder / name / "summary.json").exists()
    page.wait("document.querySelector('#jobs button')?.textContent === 'Go on'")
    page.click("#jobs button")
    page.wait("page.jobs[0].state === 'finished'", 240)
    page.finished(1)
    assert open_run(page.server.folder / name).complete


def test_a_run_that_another_server_left_goes_on(page: Page) -> None:
    def stop(step: int, *_: object) -> None:
        if step == 5:
            raise KeyboardInterrupt

    folder = page.server.folder / "results" / "left"
    with pytest.raises(KeyboardInterrupt):
        brinell.Case(SMALL, overrides=["output.checkpoint_interval=0"]).run(folder, progress=stop)
    page.wait("[...document.getElementById('add-run').options].some((one) => one.value === 'results/left')")
    page.wait("document.getElementById('jobs').textContent.includes('results/left')")  # before it is shown
    page.choose("#add-run", "results/left")
    assert "not finished" in page.one("#jobs").text
    page.click("#jobs .job:last-child button")
    page.finished(1)
    page.wait("/finished: [0-9]+ steps in [0-9.]+ s/.test(document.getElementById('jobs').textContent)")
    assert open_run(folder).complete


def test_a_measured_curve_lies_over_the_computed_one(page: Page, tmp_path: Path) -> None:
    file = tmp_path / "measured.csv"
    file.write_text("depth in um;load in N\n1,5;9\n4;33\n9;97\n")
    page.one("#measured-file").send_keys(str(file))
    page.wait("page.measured")
    unit = '[aria-label="Unit of across in the file"]'
    units = page.js(f"[...document.querySelector('{unit}').options].map((one) => one.text)")
    assert units[:4] == ["m", "mm", "µm", "nm"]
    assert page.js(f"document.querySelector('{unit}').selectedOptions[0].text") == "µm"
    page.choose(unit, "nm")
    page.choose(unit, "µm")
    x, y, drawn = page.curves()["measured.csv"]
    assert list(x) == pytest.approx([1.5, 4, 9])
    assert list(y) == [9, 33, 97]
    assert drawn["mode"] == "markers"
    assert "depth in um" in page.one("#measured-controls").text
    page.picture("measured")
    note = "document.getElementById('measured-note').textContent"
    broken = tmp_path / "broken.csv"
    broken.write_text("no numbers\n")
    page.one("#measured-file").send_keys(str(broken))
    page.wait(f"{note}.includes('no two columns')")
    odd = tmp_path / "odd.csv"
    odd.write_text("approach [mm],F_n [kg]\n0.001,10\n0.002,oops\n0.003,40\n")
    page.one("#measured-file").send_keys(str(odd))
    page.wait(f"{note}.includes('kg is no unit of F_n, which is in N')")
    assert 'line 3, "0.002,oops"' in page.js(note)
    x, y, _ = page.curves()["odd.csv"]
    assert (list(x), list(y)) == (pytest.approx([1, 3]), [10, 40])
    page.choose('[aria-label="Unit of up in the file"]', "kN")
    assert "kg" not in page.js(note)
    page.one("#measured-file").send_keys(str(file))
    page.wait("page.measured.name === 'measured.csv'")
    assert page.js(note) == ""


def test_a_case_is_saved_opened_and_replaced(page: Page, tmp_path: Path) -> None:
    def save(name: str) -> None:
        page.click("#save")
        page.one("#dialog-body input").send_keys(CONTROL_A, name, ENTER)

    page.type("title", "kept <b>as</b> it is")
    page.wait("page.values.title?.startsWith('kept')")
    save("cases/kept.toml")
    page.wait("!document.getElementById('dialog').open && page.name === 'cases/kept.toml'")
    file = page.server.folder / "cases" / "kept.toml"
    assert values_of(file.read_text()) == page.values()
    page.type("title", "another")
    page.wait("page.values.title === 'another'")
    save("cases/kept.toml")
    page.wait("document.getElementById('dialog-error').textContent.includes('OK replaces it')")
    page.click("#dialog-ok")
    page.wait("!document.getElementById('dialog').open")
    assert values_of(file.read_text())["title"] == "another"
    page.choose("#new", "fretting")
    page.wait("page.values.scenario === 'fretting'")
    page.wait("[...document.getElementById('open').options].some((one) => one.value === 'cases/kept.toml')")
    page.choose("#open", "cases/kept.toml")
    page.wait("page.values.title === 'another'")
    save("../outside.toml")
    page.wait("document.getElementById('dialog-error').textContent.includes('outside')")
    page.click("#dialog-cancel")
    other = tmp_path / "elsewhere.toml"
    other.write_text(PAPER.read_text())
    page.one("#file").send_keys(str(other))
    page.wait("page.values.scenario === 'tugging' && page.values['tugging.interference'] === 9")
    assert page.one("#case-name").text == "from elsewhere.toml"
    page.settled()
    page.driver.get_log("browser")  # the two refusals


def test_command_and_python_do_the_same(page: Page, tmp_path: Path) -> None:
    page.choose("#open", "paper.toml")
    page.wait("page.name === 'paper.toml' && !page.checked.errors.length && page.checked.text.includes('tugging')")
    page.tab("text")
    page.wait("document.getElementById('toml').textContent")
    work = tmp_path / "work"
    work.mkdir()
    shutil.copy(page.server.folder / "paper.toml", work)
    command = page.one("#command").text
    assert command == "brinell run paper.toml -o results/paper"
    subprocess.run([sys.executable, "-m", *shlex.split(command), "-q"], cwd=work, check=True)
    by_command = open_run(work / "results" / "paper").history
    done = subprocess.run(
        [sys.executable, "-W", "ignore", "-c", page.one("#python").text],
        cwd=work,
        capture_output=True,
        text=True,
        check=True,
    )
    assert str(by_command["F_X"]).split("\n")[0] in done.stdout
    page.tab("curves")
    page.click("#run")
    page.finished(1)
    by_page = open_run(page.server.folder / page.js("page.shown[0].name")).history
    for column, values in by_command.items():
        assert np.array_equal(values, by_page[column], equal_nan=True), column
    page.type("title", "x")
    page.wait("document.getElementById('command').textContent.startsWith('# after the case is saved')")


def test_a_sweep_has_its_plot(page: Page) -> None:
    page.tab("sweep")
    page.choose("#sweep-key", "lower.material.hardening.yield_stress")
    assert page.one("#sweep-unit").text == "MPa"
    page.one("#sweep-from").send_keys(CONTROL_A, "a lot")
    page.click("#sweep-run")
    assert page.one("#sweep-note").get_attribute("class") == "complaint"
    assert page.js("document.activeElement.id") == "sweep-from"
    assert page.one("#sweep-from").get_attribute("aria-invalid") == "true"
    page.one("#sweep-from").send_keys(CONTROL_A, "450")
    page.one("#sweep-count").send_keys(CONTROL_A, "3")
    page.click("#sweep-run")
    page.wait("document.querySelector('#sweep-figure img')?.naturalWidth > 300", 120)
    assert page.js("document.querySelector('#sweep-figure img').alt") == "Key numbers of the runs over what varies."
    page.picture("sweep")


@pytest.mark.filterwarnings("ignore::brinell.ResolutionWarning")
def test_figures_of_a_result(page: Page) -> None:
    folder = page.server.folder / "results" / "fatigue"
    if not folder.exists():
        brinell.Case.from_file(ROOT / "cases" / "rolling-fatigue" / "case.toml", ["grid.resolution=3"]).run(folder)
    page.wait("[...document.getElementById('figures-of').options].some((one) => one.value === 'results/fatigue')")
    page.choose("#add-run", "results/fatigue")
    page.finished(1)
    page.tab("figures")
    assert page.js("document.getElementById('figures-of').value") == "results/fatigue"  # as it is shown
    page.wait(
        "[...document.querySelectorAll('#gallery img')].some((one) => one.alt.startsWith('Fatigue of the lower body'))",
        120,
    )
    page.wait("[...document.querySelectorAll('#gallery img')].every((one) => one.naturalWidth > 100)")
    assert page.js("document.documentElement.scrollWidth <= window.innerWidth")


@pytest.mark.filterwarnings("ignore::brinell.ResolutionWarning")
def test_results_of_several_kinds_and_steps_are_shown(page: Page) -> None:
    results = page.server.folder / "results"
    if not (results / "kind-a").exists():
        brinell.Case(SMALL, overrides=["output.snapshots=[2]"]).run(results / "kind-a")
        brinell.Case(SMALL, overrides=["output.snapshots=[3]", "indentation.load=[200, 0]"]).run(results / "kind-b")
        brinell.Case.from_file(PAPER).run(results / "kind-c")
    for count, name in enumerate(("kind-a", "kind-b"), 1):
        page.wait(f"[...document.getElementById('add-run').options].some((one) => one.value === 'results/{name}')")
        page.choose("#add-run", f"results/{name}")
        page.finished(count)
        states = page.js("[...document.getElementById('state').options].map((one) => one.text)")
        if count == 1:
            assert any(text.startswith("step 2, approach ") and text.endswith(" N") for text in states)
    assert {"step 2 of kind-a", "step 3 of kind-b"} <= set(states)

    page.tab("fields")
    page.choose("#state", "step 3 of kind-b")
    captions = "[...document.querySelectorAll('#pictures figcaption')].map((one) => one.textContent)"
    page.wait(f"{captions}.some((text) => text.endsWith('step 3')) && picturing === pictured")
    assert "results/kind-a: step 3 is not stored" in " ".join(page.js(captions))
    page.choose("#state", "the last state")
    page.choose("#kind", "surface in 3-D")
    page.wait(f"{captions}.filter((text) => text.includes('Residual height')).length === 3 && picturing === pictured")
    drawn = page.js(
        "[...document.querySelectorAll('#pictures .plot')].map((one) => [one.data[0].cmax, one.data[0].cmin])"
    )
    assert len(drawn) == 3
    assert drawn[0] == drawn[1] == drawn[2]  # of one scale
    assert (
        len(
            set(
                page.js(
                    "[...document.querySelectorAll('#pictures .plot')].map((one) => one.layout.scene.zaxis.title.text)"
                )
            )
        )
        == 1
    )

    page.tab("curves")
    page.choose("#add-run", "results/kind-c")
    page.finished(3)
    page.wait("document.getElementById('left-out').textContent === 'kind-c has no approach and is not drawn.'")
    assert "kind-c" not in page.curves()
    page.tab("numbers")
    assert "tugging.interference – – 9" in page.one("#numbers").text.split("\n")
    page.tab("curves")
    page.driver.execute_script(
        "drawCurves(document.getElementById('fit-plot'), [{name: 'a', x: [1, 2, 3], y: [1, null, 2]}],"
        " {name: 'x', unit: 'm', text: 'x'}, {name: 'R', unit: 'ohm', text: 'R'})"
    )
    assert page.js("document.getElementById('fit-plot').data[0].y") == [1, None, 2]  # infinite: no point, and not 0
