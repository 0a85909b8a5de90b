# SPDX-License-Identifier: BSD-3-Clause
"""The page of `brinell app` in headless Chromium: its tasks, done as a user does them.

Needs Debian's packages chromium and chromium-driver. BRINELL_NEED_BROWSER=1 makes a missing browser an error instead of
a reason to skip. BRINELL_SCREENSHOTS names a folder for the pictures of docs/howto/app.md: docs/images.
"""

import json
import shlex
import shutil
import subprocess
import sys
import time
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import brinell
from app_page import CONTROL_A, ENTER, LEFT, RIGHT, TAB, Page
from app_server import Server
from brinell.app.case_text import values_of
from brinell.plot import style
from brinell.results import open_run
from test_report_browser import CHROMIUM, DRIVER, NEEDED, OPTIONS

pytestmark = pytest.mark.skipif(
    not NEEDED and (CHROMIUM is None or DRIVER is None),
    reason="no chromium with its driver: apt-get install chromium chromium-driver",
)

ROOT = Path(__file__).parents[2]
PAPER = ROOT / "cases" / "tugging-paper" / "case.toml"


@pytest.fixture(scope="module")
def driver(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Any]:
    from selenium import webdriver

    options = webdriver.ChromeOptions()
    assert CHROMIUM is not None
    options.binary_location = CHROMIUM
    sized = [option for option in OPTIONS if not option.startswith("--window-size")]
    nowhere = "--host-resolver-rules=MAP * ~NOTFOUND, EXCLUDE 127.0.0.1"
    for option in (*(one for one in sized if "resolver" not in one), nowhere, "--window-size=1500,950"):
        options.add_argument(option)
    options.add_argument(f"--user-data-dir={tmp_path_factory.mktemp('chromium')}")
    options.set_capability("goog:loggingPrefs", {"browser": "ALL", "performance": "ALL"})
    driver = webdriver.Chrome(options=options, service=webdriver.ChromeService(DRIVER))
    yield driver
    driver.quit()


@pytest.fixture(scope="module")
def server(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Server]:
    folder = tmp_path_factory.mktemp("work")
    shutil.copy(PAPER, folder / "paper.toml")
    server = Server(folder, tmp_path_factory.mktemp("settings"))
    yield server
    server.close()


@pytest.fixture
def page(driver: Any, server: Server) -> Iterator[Page]:
    driver.get_log("browser")
    page = Page(driver, server)
    page.open()
    yield page
    assert page.complaints() == []


def test_first_curve_is_there_at_once(driver: Any, server: Server) -> None:
    driver.get_log("performance")
    begun = time.monotonic()
    page = Page(driver, server)
    page.open()
    print(f"first curve {time.monotonic() - begun:.2f} s after the page was opened")
    x, y, _ = page.curves()["this case"]
    assert len(x) == len(y) > 10
    assert "expected errors" in page.one("#notes").text  # what is known of its quality is said beside it
    assert page.js("document.getElementById('curve').getAttribute('aria-label')").startswith(
        "Force normal to the plane"
    )
    page.picture("first")

    events = [json.loads(entry["message"])["message"] for entry in driver.get_log("performance")]
    requests = [e["params"]["request"]["url"] for e in events if e["method"] == "Network.requestWillBeSent"]
    here = f"http://127.0.0.1:{server.port}/"
    assert [url for url in requests if not url.startswith((here, "data:", "blob:", "chrome:"))] == []
    assert page.complaints() == []


def test_an_error_stands_at_its_field(page: Page) -> None:
    page.type("lower.material.poisson_ratio", "0.7")
    page.wait("page.checked.errors.length === 1")
    box = page.one('[data-key="lower.material.poisson_ratio"]')
    assert "0.7 is out of range; allowed: number in (-1, 0.5)" in box.text
    field = page.one('[id="f-lower.material.poisson_ratio"]')
    assert field.get_attribute("aria-invalid") == "true"
    assert "out of range" in page.js(
        "document.getElementById(arguments[0]).textContent", field.get_attribute("aria-describedby")
    )
    assert not page.one("#run").is_enabled()
    page.type("upper.shape.radius", "")
    page.wait("page.checked.errors.length === 2")
    assert len(page.curves()["this case"][0]) > 10  # the curve stays
    page.picture("problems")
    page.click("#problems li:last-child button")
    assert page.js("document.activeElement.id") == "f-upper.shape.radius"
    page.type("upper.shape.radius", "1")
    page.type("lower.material.poisson_ratio", "0.3")
    page.wait("page.checked.errors.length === 0")
    assert page.one("#run").is_enabled()


def test_every_error_is_seen_where_it_belongs(page: Page) -> None:
    """Bad values of all kinds at once: the list above leads from each error to the place that says it."""
    bad = {
        "lower.material.young_modulus": "3 kg",
        "lower.shape.type": "ball",
        "lower.material.hardening.law": 3,
        "lower.texture[0].type": "dent",
        "lower.texture[1].type": "dent",
        "lower.texture[1].depth": "-1 um",
        "indentation.load": [],
        "indentation.steps": 1.5,
        "grid.boundary": "closed",
        "output.fields": ["everything"],
        "output.snapshots": "never",
        "rolling.distance": "1 mm",
        "no.such": 1,
        "lower.radus": 2,
    }
    for key, value in bad.items():
        page.driver.execute_script("change({[arguments[0]]: arguments[1]}, false)", key, value)
        page.wait(
            "page.checked.errors.length > 0 && Object.keys(page.values).includes(arguments[0])".replace(
                "arguments[0]", json.dumps(key)
            )
        )
    page.settled()
    errors = page.js("page.checked.errors.map((one) => one.key)")
    assert len(errors) > 12
    for i, key in enumerate(errors):
        page.driver.execute_script("document.querySelectorAll('#problems li button')[arguments[0]].click()", i)
        place = f"document.getElementById('f-' + {json.dumps(key)})"
        assert page.js(f"{place} !== null"), key
        assert page.js(
            f"({place}.closest('.field') ?? {place}).querySelectorAll('.error').length || {place}.matches('.error')"
        ), key
        assert page.js(f"{place}.offsetParent !== null"), key  # it can be seen


def test_fields_follow_what_is_chosen(page: Page) -> None:
    radius = page.values()["upper.shape.radius"]
    page.choose('[id="f-upper.shape.type"]', "cone")
    page.wait("document.getElementById('f-upper.shape.half_angle')")
    assert page.values().keys() & {"upper.shape.radius", "upper.shape.half_angle"} == set()
    page.choose('[id="f-upper.shape.type"]', "sphere")
    page.wait("page.values['upper.shape.radius']")  # what was put aside comes back
    assert page.values()["upper.shape.radius"] == radius
    page.choose('[id="f-scenario"]', "rolling")
    page.wait("page.values['rolling.distance']")
    page.settled()


def test_every_key_that_applies_has_its_field(page: Page) -> None:
    for scenario in page.js("form.fields.get('scenario').choices"):
        page.choose("#new", scenario)
        page.wait(f"page.values.scenario === '{scenario}' && page.checked.text.includes('{scenario}')")
        page.unfold()
        shown = set(page.js("[...document.querySelectorAll('[data-key]')].map((one) => one.dataset.key)"))
        assert set(page.js("Object.keys(page.checked.applies)")) <= shown


def test_a_text_that_is_being_typed_is_kept(page: Page) -> None:
    field = page.one('[id="f-title"]')
    field.send_keys(CONTROL_A, "half a ti")
    page.js("drawCase()")  # as when a check answers
    assert page.js("document.activeElement.value") == "half a ti"
    page.driver.switch_to.active_element.send_keys("tle", TAB)
    page.wait("page.values.title === 'half a title'")


def test_materials_have_their_sources_and_own_ones_are_kept(page: Page) -> None:
    menu = '[id="material-lower.material"]'
    page.choose(menu, "S355")
    page.wait("page.values['lower.material.hardening.yield_stress'] === '355 MPa'")
    page.wait("document.getElementById('left').textContent.includes('EN 1993-1-1:2005, table 3.1')")
    page.type("lower.material.hardening.yield_stress", "400")
    page.wait("page.values['lower.material.hardening.yield_stress'] === '400 MPa'")
    page.settled()
    page.click('[title="Keep these constants among the own materials"]')
    inputs = page.driver.find_elements("css selector", "#dialog-body input")
    inputs[0].send_keys("our batch")
    inputs[1].send_keys("tension test")
    page.click("#dialog-ok")
    page.wait("!document.getElementById('dialog').open")
    page.wait("document.getElementById('left').textContent.includes('tension test')")
    page.driver.refresh()
    page.wait("document.body.dataset.ready && start.materials.some((one) => one.own)")
    page.choose(menu, "our batch")
    page.wait("page.values['lower.material.hardening.yield_stress'] === '400 MPa'")
    page.settled()


def test_a_slider_runs_the_case_of_the_paper_again(page: Page) -> None:
    page.choose("#open", "paper.toml")
    page.wait("page.name === 'paper.toml' && page.live?.done && page.live.scenario === 'tugging'")
    page.settled()
    before = page.curves()["this case"][1]
    page.click('[data-key="tugging.interference"] [aria-pressed]')
    took = []
    for key in (RIGHT, LEFT, RIGHT, LEFT, RIGHT, RIGHT):
        page.js("document.body.dataset.took = ''")
        page.act('[id="s-tugging.interference"]', lambda slider, key=key: slider.send_keys(key))
        page.wait("document.body.dataset.took && !preview.abort")
        took.append(float(page.js("document.body.dataset.took")))
        page.settled()
    print(f"runs of the paper's case after a slider's release [s]: {took}")
    page.js("document.getElementById('s-tugging.interference').scrollIntoView()")
    page.picture("slider", scrolls=False)
    given = page.values()["tugging.interference"]
    assert 9 < given < 10
    shown = page.curves()
    assert "before the change" in shown
    x, y, _ = shown["this case"]
    assert y.max() > before.max()
    run = brinell.Case.from_file(PAPER, [f"tugging.interference={given}"]).run()
    assert x * 1e-3 == pytest.approx(run.history["X"], rel=1e-9)  # mm, kN: those of the axes
    assert y * 1e3 == pytest.approx(run.history["F_X"], rel=1e-9, abs=1e-6)


def finished(page: Page, count: int) -> None:
    page.wait(f"page.shown.length === {count} && page.shown.every((one) => one.complete && one.outline)")


def test_runs_are_compared_side_by_side(page: Page) -> None:
    page.click("#run")
    finished(page, 1)
    page.type("lower.material.hardening.yield_stress", "600")
    page.wait("page.values['lower.material.hardening.yield_stress'] === '600 MPa' && !page.checked.errors.length")
    page.settled()
    page.click("#run")
    finished(page, 2)
    page.wait("document.getElementById('curve').data.length === 2")
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
    for kind, layer in (
        ("section", ".heatmaplayer image"),
        ("map of the contact", ".heatmaplayer image"),
        ("surface in 3-D", "canvas"),
    ):
        page.choose("#kind", kind)
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


def test_map_is_that_of_the_result(page: Page) -> None:
    page.click("#run")
    finished(page, 1)
    page.tab("fields")
    page.wait("document.querySelector('#pictures .heatmaplayer image')")
    name = page.js("page.shown[0].name")
    snapshot = open_run(page.server.folder / name).snapshot("aligned")
    drawn = page.js("document.querySelector('#pictures .plot').data[0]")
    assert np.max([[value or 0 for value in row] for row in drawn["z"]]) * 1e9 == pytest.approx(
        snapshot.contact.pressure.max(), rel=1e-4
    )


def test_a_run_is_stopped_and_goes_on(page: Page) -> None:
    page.unfold()
    page.type("indentation.steps", "60")
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
    page.wait("page.jobs[0].state === 'finished'", 120)
    finished(page, 1)
    assert open_run(page.server.folder / name).complete


def test_a_measured_curve_lies_over_the_computed_one(page: Page, tmp_path: Path) -> None:
    file = tmp_path / "measured.csv"
    file.write_text("depth in um;load in N\n1,5;9\n4;33\n9;97\n")
    page.one("#measured-file").send_keys(str(file))
    page.wait("page.measured")
    page.choose('[aria-label="Unit of across in the file"]', "micro (µm)")
    x, y, drawn = page.curves()["measured.csv"]
    assert list(x) == pytest.approx([1.5, 4, 9])
    assert list(y) == [9, 33, 97]
    assert drawn["mode"] == "markers"
    assert "depth in um" in page.one("#measured-controls").text
    page.picture("measured")
    broken = tmp_path / "broken.csv"
    broken.write_text("no numbers\n")
    page.one("#measured-file").send_keys(str(broken))
    page.wait("document.getElementById('curve-note').textContent.includes('no two columns')")


def test_a_case_is_saved_opened_and_replaced(page: Page, tmp_path: Path) -> None:
    def save(name: str) -> None:
        page.click("#save")
        page.one("#dialog-body input").send_keys(CONTROL_A, name)
        page.click("#dialog-ok")

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
    page.click("#dialog [value=cancel]")
    other = tmp_path / "elsewhere.toml"
    other.write_text(PAPER.read_text())
    page.one("#file").send_keys(str(other))
    page.wait("page.values.scenario === 'tugging' && page.values['tugging.interference'] === 9")
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
    finished(page, 1)
    by_page = open_run(page.server.folder / page.js("page.shown[0].name")).history
    for column, values in by_command.items():
        assert np.array_equal(values, by_page[column], equal_nan=True), column
    page.type("title", "x")
    page.wait("document.getElementById('command').textContent.startsWith('# after the case is saved')")


def test_a_sweep_has_its_plot(page: Page) -> None:
    page.tab("sweep")
    page.choose("#sweep-key", "lower.material.hardening.yield_stress")
    assert page.one("#sweep-unit").text == "MPa"
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
    page.tab("figures")
    page.choose("#figures-of", "results/fatigue")
    page.wait(
        "[...document.querySelectorAll('#gallery img')].some((one) => one.alt.startsWith('Fatigue of the lower body'))",
        120,
    )
    page.wait("[...document.querySelectorAll('#gallery img')].every((one) => one.naturalWidth > 100)")
    assert page.js("document.documentElement.scrollWidth <= window.innerWidth")


def test_all_has_names_and_works_by_the_keyboard(page: Page) -> None:
    page.unfold()
    nameless = """[...document.querySelectorAll('input:not([hidden]), select, button, textarea')].filter((one) =>
        !(one.getAttribute('aria-label') || one.getAttribute('aria-labelledby')
          || one.labels?.length || one.textContent.trim())).map((one) => one.outerHTML)"""
    assert page.js(nameless) == []
    ids = page.js("[...document.querySelectorAll('[id]')].map((one) => one.id)")
    assert len(ids) == len(set(ids))
    assert page.js("[...document.images].every((one) => one.alt)")
    described = page.js(
        "[...document.querySelectorAll('[aria-describedby]')].map((one) => one.getAttribute('aria-describedby'))"
    )
    assert set(described) <= set(ids)

    page.driver.get(page.server.address)
    page.wait("document.body.dataset.took")
    active = page.driver.switch_to
    active.active_element.send_keys(TAB)
    assert page.js("document.activeElement.textContent") == "To the form"
    page.js("document.getElementById('tab-curves').focus()")
    active.active_element.send_keys(RIGHT)
    assert page.js("document.activeElement.id") == "tab-fields"
    assert page.js("document.getElementById('fields').hidden === false")
    page.js("document.getElementById('run').focus()")
    active.active_element.send_keys(ENTER)
    finished(page, 1)


def test_narrow_window_shows_all(page: Page) -> None:
    try:
        page.driver.set_window_size(620, 900)
        page.wait("window.innerWidth < 700")
        time.sleep(0.5)
        assert page.js("document.documentElement.scrollWidth <= window.innerWidth")
        assert page.js("document.getElementById('f-title').clientWidth > 100")
    finally:
        page.driver.set_window_size(1500, 950)


def test_texts_of_a_case_stay_texts(page: Page) -> None:
    evil = '<img src=x onerror="window.harmed = 1"><script>window.harmed = 1</script>'
    (page.server.folder / "evil.toml").write_text(
        f"scenario = 'indentation'\ntitle = '{evil}'\n'<b>' = 1\n[lower.shape]\ntype = '{evil}'\n"
    )
    page.wait("[...document.getElementById('open').options].some((one) => one.value === 'evil.toml')")
    page.choose("#open", "evil.toml")
    page.wait("page.name === 'evil.toml' && page.checked.errors.length > 0")
    assert not page.js("window.harmed")
    assert page.js("document.querySelectorAll('#left img, #problems img').length") == 0


def test_colours_are_those_of_the_figures(page: Page) -> None:
    assert page.js("COLOURS") == list(style.CATEGORIES)


def test_a_server_that_has_ended_is_noticed(driver: Any, tmp_path: Path) -> None:
    server = Server(tmp_path, tmp_path / "settings")
    page = Page(driver, server)
    page.open()
    assert server.close() == 0
    page.wait("document.getElementById('curve-note').textContent.startsWith('The server has ended')")
