# SPDX-License-Identifier: BSD-3-Clause
"""The page of `brinell app` in headless Chromium: its tasks, done as a user does them.

Needs Debian's packages chromium and chromium-driver. BRINELL_NEED_BROWSER=1 makes a missing browser an error instead of
a reason to skip. BRINELL_SCREENSHOTS names a folder for the pictures of docs/howto/app.md: docs/images.
"""

import json
import time
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import brinell
from app_page import CONTROL_A, ENTER, LEFT, RIGHT, TAB, Page
from app_server import Server
from brinell.plot import style
from test_report_browser import CHROMIUM, DRIVER, NEEDED

pytestmark = pytest.mark.skipif(
    not NEEDED and (CHROMIUM is None or DRIVER is None),
    reason="no chromium with its driver: apt-get install chromium chromium-driver",
)

ROOT = Path(__file__).parents[2]
PAPER = ROOT / "cases" / "tugging-paper" / "case.toml"


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


def test_a_file_leads_to_the_page(driver: Any, server: Server) -> None:
    from brinell.app.cli import _leading_to

    with _leading_to(server.address) as path:
        driver.get(path.as_uri())
        Page(driver, server).wait("document.body.dataset.took")
    assert driver.current_url == server.address


def test_an_error_stands_at_its_field(page: Page) -> None:
    radius = page.values()["upper.shape.radius"]
    assert radius == "1 mm"
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
    assert len(page.curves()["this case before its problems"][0]) > 10  # the curve stays
    page.picture("problems")
    page.click("#problems li:last-child button")
    assert page.js("document.activeElement.id") == "f-upper.shape.radius"
    for wrong in ("5,5", "abc", "3 furlong"):
        page.type("upper.shape.radius", wrong)
        page.wait(f"page.values['upper.shape.radius'] === '{wrong}' && page.checked.text.includes('{wrong}')")
        page.settled()
        assert page.one('[id="f-upper.shape.radius"]').get_attribute("value") == wrong
        page.type("upper.shape.radius", "1")  # in the unit that held before
        page.wait(f"page.values['upper.shape.radius'] === {json.dumps(radius)}")
    page.settled()
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


def test_measured_heights_of_the_folder_are_offered_and_used(page: Page) -> None:
    np.save(page.server.folder / "heights.npy", np.full((8, 8), 1e-7))
    page.wait("[...document.getElementById('data-files').options].some((one) => one.value === 'heights.npy')")
    page.unfold()
    page.choose('[id="f-lower.texture[0].type"]', "height_map")
    page.wait("document.getElementById('f-lower.texture[0].file')?.getAttribute('list') === 'data-files'")
    page.type("lower.texture[0].file", "heights.npy")
    page.type("lower.texture[0].spacing", "10, 10")
    page.wait("page.checked.errors.length === 0 && page.checked.text.includes('heights.npy')")
    assert page.values()["lower.texture[0].spacing"] == ["10 mm", "10 mm"]
    page.type("lower.texture[0].file", "/etc/hostname")
    page.wait("page.checked.errors.length === 1")
    assert "is outside the folder of this page" in page.one('[data-key="lower.texture[0].file"]').text


def test_every_key_that_applies_has_its_field(page: Page) -> None:
    for scenario in page.js("form.fields.get('scenario').choices"):
        page.choose("#new", scenario)
        page.wait(f"page.values.scenario === '{scenario}' && page.checked.text.includes('{scenario}')")
        page.unfold()
        shown = set(page.js("[...document.querySelectorAll('[data-key]')].map((one) => one.dataset.key)"))
        assert set(page.js("Object.keys(page.checked.applies)")) <= shown


def test_a_text_that_is_being_typed_is_kept(page: Page) -> None:
    page.act('[id="f-title"]', lambda field: field.send_keys(CONTROL_A, "half a ti"))
    page.js("drawCase()")  # as when a check answers
    assert page.js("document.activeElement.value") == "half a ti"
    page.act('[id="f-title"]', lambda field: field.send_keys("tle", TAB))  # a check may draw it anew once more
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
    for typed in ("6", "9"):  # a pure number: over its value at first yield
        page.type("tugging.interference", typed)
        page.wait(f"page.values['tugging.interference'] === {typed} && !page.checked.errors.length")
        page.settled()
    before = page.curves()["this case"][1]
    page.click('[data-key="tugging.interference"] [aria-pressed]')
    assert page.one('[id="s-tugging.interference"]').get_attribute("aria-valuetext").split() == ["9"]
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
    active.active_element.send_keys(TAB)
    assert page.js("document.activeElement.textContent") == "To the results"
    active.active_element.send_keys(ENTER)
    assert page.js("document.activeElement.id") == "right"
    within = "document.querySelector('[data-key=\"{}.material.young_modulus\"]').parentElement.closest('[role=group]')"
    for body in ("lower", "upper"):
        group = within.format(body)
        if page.js(f"{group} !== null"):
            assert page.js(f"{group}.parentElement.closest('[role=group]').getAttribute('aria-label')") == (
                f"{body.capitalize()} body"
            )
    page.js("document.getElementById('tab-curves').focus()")
    active.active_element.send_keys(RIGHT)
    assert page.js("document.activeElement.id") == "tab-fields"
    assert page.js("document.getElementById('fields').hidden === false")
    page.js("document.getElementById('run').focus()")
    active.active_element.send_keys(ENTER)
    page.finished(1)


LEAVING = """(() => {
    const event = new Event("beforeunload", { cancelable: true });
    dispatchEvent(event);
    return event.defaultPrevented;
})()"""


def test_folds_help_and_texts_of_the_form(page: Page) -> None:
    summaries = page.js("[...document.querySelectorAll('#form summary')].map((one) => one.textContent)")
    assert not {"Settings", "1 more", "1 setting"} & set(summaries)
    nested = "[...document.querySelectorAll('#form details.more details.more')]"
    page.unfold()
    assert page.js(f"{nested}.every((one) => one.parentElement.closest('details.more').querySelector('h3'))")
    fields = '[data-key="output.fields"]'
    assert "None is chosen; this then holds: all" in page.one(fields).text
    page.click('[data-key="output.snapshots"] [aria-expanded]')
    assert 'Allowed: "none", "aligned", "all", "every N"' in page.one('[data-key="output.snapshots"]').text
    places = page.js("[...document.querySelectorAll('#form input')].map((one) => one.placeholder)")
    assert not [one for one in places if "333333" in one or ";" in one or "in tugging" in one]

    assert page.js(LEAVING) is False
    page.type("title", "kept?")
    page.wait("page.values.title === 'kept?'")
    assert page.js(LEAVING) is True

    page.tab("text")
    page.wait("document.getElementById('report').textContent.startsWith('# Resolved case of case.toml')")
    page.click("#h-toml .copy")
    page.wait("['Copied', 'Selected'].includes(document.querySelector('#h-toml .copy').textContent)")

    page.driver.execute_script(
        "drawCurves(document.getElementById('fit-plot'), [], {name: 'x', unit: 'm', text: 'x'}, {name: 'a', unit: 'm',"
        " text: 'Largest equivalent plastic strain under the middle of the contact'})"
    )
    plot = "document.getElementById('fit-plot').layout"
    assert page.js(f"{plot}.annotations[0].text") == "Nothing to draw so far"
    assert "[" not in page.js(f"{plot}.xaxis.title.text")
    assert "<br>" in page.js(f"{plot}.yaxis.title.text")


def test_narrow_window_shows_all(page: Page) -> None:
    try:
        page.driver.set_window_size(620, 900)
        page.wait("window.innerWidth < 700")
        page.wait("document.documentElement.scrollWidth <= window.innerWidth")
        page.wait("document.getElementById('f-title').clientWidth > 100")
    finally:
        page.driver.set_window_size(1500, 950)


CUT_OFF = """
    window.cut = 0;
    let before = "";
    const look = () => {
        const plot = document.getElementById("curve"), drawn = plot.querySelector(".main-svg").getBoundingClientRect();
        const sizes = [drawn.width, drawn.height, plot.clientWidth, plot.clientHeight].map(Math.round);
        const differs = Math.abs(sizes[0] - sizes[2]) > 1 || Math.abs(sizes[1] - sizes[3]) > 1;
        if (differs && before === String(sizes)) window.cut += 1; // it was so when the last frame was painted
        before = String(sizes);
        requestAnimationFrame(look);
    };
    look();"""


def test_no_axis_is_cut_off_while_the_page_changes(page: Page) -> None:
    page.driver.execute_script(CUT_OFF)
    height = page.js("document.getElementById('curve').clientHeight")
    page.js("document.getElementById('notes').replaceChildren()")
    page.frames()
    assert page.js("document.getElementById('curve').clientHeight") == height  # notes come and go beside it
    for rows in (3, 0, 2):  # as jobs do
        page.driver.execute_script(
            "document.getElementById('jobs').style.height = `${arguments[0]}em`; drawCurve();", rows
        )
        page.frames()
        page.frames()
    page.driver.set_window_size(1300, 950)
    page.wait("window.innerWidth < 1350")
    page.frames()
    page.driver.set_window_size(1500, 950)
    page.wait("window.innerWidth > 1450")
    page.frames()
    assert page.js("document.getElementById('curve').clientHeight") < height
    assert page.js("window.cut") == 0


def test_a_row_of_a_run_keeps_its_button(page: Page) -> None:
    page.unfold()
    page.type("indentation.steps", "3000")  # a browser on a busy machine is slower than a short run
    page.wait("page.values['indentation.steps'] === 3000 && !page.checked.errors.length")
    page.settled()
    page.click("#run")
    page.wait("document.querySelector('#jobs progress')?.value > 0")
    page.js("document.querySelector('#jobs button').focus()")
    done = page.js("document.querySelector('#jobs progress').value")
    page.wait(f"document.querySelector('#jobs progress').value > {done}")
    assert page.js("document.activeElement.textContent") == "Stop"  # the keyboard is still there
    page.click("#run")  # the very same case
    page.wait("document.getElementById('dialog').open")
    assert "computes this very case" in page.one("#dialog-title").text
    page.click("#dialog-cancel")
    page.js("document.querySelector('#jobs button').focus()")
    page.driver.switch_to.active_element.send_keys(ENTER)
    assert page.one("#jobs .quiet").text.startswith(("stops after this step …", "stopped after"))
    page.wait("page.jobs[0].state === 'stopped'")
    page.wait("/stopped after [0-9]+ of [0-9]+ steps/.test(document.getElementById('jobs').textContent)")
    page.click("#jobs .dismiss")
    page.wait("!document.getElementById('jobs').textContent.includes('stopped after')")


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
    page.wait("document.getElementById('server-note').textContent.startsWith('The server has ended')")
    assert page.one("#server-note").is_displayed()
    assert not page.one("#run").is_enabled()
