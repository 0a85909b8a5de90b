# SPDX-License-Identifier: BSD-3-Clause
"""Fits on the page of `brinell app` in headless Chromium, as in test_app_browser.py."""

import json
import shlex
import subprocess
import sys
from pathlib import Path

import pytest

from app_page import CONTROL_A, TAB, Page
from test_app_fits import CASE, TRUTH, YIELD, measured_curve
from test_report_browser import CHROMIUM, DRIVER, NEEDED

pytest.importorskip("scipy")

pytestmark = pytest.mark.skipif(
    not NEEDED and (CHROMIUM is None or DRIVER is None),
    reason="no chromium with its driver: apt-get install chromium chromium-driver",
)


def opened(page: Page) -> None:
    """The case, and the view of fits."""
    (page.server.folder / "ball.toml").write_text(CASE)
    page.wait("[...document.getElementById('open').options].some((one) => one.value === 'ball.toml')")
    page.choose("#open", "ball.toml")
    page.wait("page.name === 'ball.toml' && page.live?.done && !page.checked.errors.length")
    page.tab("fit")


def give(page: Page, field: str, text: str) -> None:
    """Types into a field of the fit."""
    page.act(f'[id="fit-{field}"]', lambda one: one.send_keys(CONTROL_A, text, TAB))


def test_a_fit_is_begun_followed_and_taken_into_the_case(page: Page, tmp_path: Path) -> None:
    curve = tmp_path / "ball.csv"
    curve.write_text(measured_curve())
    opened(page)
    page.one("#measured-file").send_keys(str(curve))
    page.wait("page.measured")
    assert not page.one("#fit-run").is_enabled()
    page.choose("#fit-add", YIELD)
    assert page.js("[...document.querySelectorAll('#fit-unknowns input')].map((one) => one.value)") == ["0.4", "3.6"]
    page.wait("!document.getElementById('fit-run').disabled")
    assert page.js("fit.checked.x.length") == page.js("page.measured.columns[0].length")
    assert page.js("fit.checked.x.at(-1)") == pytest.approx(page.js("page.measured.columns[0].at(-1)") * 1e-6)

    give(page, "unknowns[0].low", "4")
    page.wait("document.querySelector('[data-fit=\"unknowns[0]\"] .error')?.textContent.includes('is not above')")
    assert not page.one("#fit-run").is_enabled()
    give(page, "noise", "-1 %")
    page.wait("document.querySelector('[data-fit=noise] .error')?.textContent.includes('allowed: above 0')")
    assert page.one("#fit-noise").get_attribute("aria-invalid") == "true"
    give(page, "noise", "1 %")
    give(page, "unknowns[0].low", "0.3")
    page.wait("!document.getElementById('fit-run').disabled && !document.querySelector('#fit .error')")

    page.click("#fit-run")
    page.wait(
        "/: [0-9]+ runs, misfit .* best so far: yield stress/.test(document.getElementById('fit-note').textContent)"
    )
    page.wait("document.getElementById('fit-plot').data.some((one) => one.name.endsWith('fitted'))")
    page.wait("document.querySelector('#fit-table td')")
    name = page.js("fit.name")
    result = json.loads((page.server.folder / name / "fit.json").read_text())
    (found,) = result["unknowns"]
    assert found["low"] < TRUTH < found["high"]
    table = page.one("#fit-table").text
    assert "95 % interval" in table
    for finding in result["findings"]:
        assert finding in table
    drawn = {one["name"]: one for one in page.js("document.getElementById('fit-plot').data")}
    assert len(drawn["ball, fitted"]["x"]) == len(result["data"][0]["x"])
    page.js("document.getElementById('fit-unknowns').scrollIntoView()")
    page.picture("fit")

    page.click("#fit-take")
    page.wait("document.getElementById('fit-taken').textContent.startsWith('Taken')")
    assert page.values()[YIELD] == f"{found['value'] / 1e9:.6g} GPa"
    page.settled()

    command = page.one("#fit-command").text
    assert command == f"brinell fit {name}/fit.toml -o {name}"
    assert page.one("#fit-text").text.strip() == (page.server.folder / name / "fit.toml").read_text().strip()
    words = [*shlex.split(command)[:-1], str(tmp_path / "again"), "--no-figures", "-q"]
    subprocess.run([sys.executable, "-m", *words], cwd=page.server.folder, check=True, capture_output=True)
    assert json.loads((tmp_path / "again" / "fit.json").read_text())["unknowns"] == result["unknowns"]


def test_a_fit_survives_a_closed_tab_and_is_stopped(page: Page, tmp_path: Path) -> None:
    (page.server.folder / "curve.csv").write_text(measured_curve())
    opened(page)
    page.wait("[...document.getElementById('fit-file').options].some((one) => one.value === 'f curve.csv')")
    page.choose("#fit-file", "curve.csv")
    page.wait("page.measured?.file === 'curve.csv'")
    page.unfold()
    page.type("grid.resolution", "12")
    page.wait("page.values['grid.resolution'] === 12 && !page.checked.errors.length")
    page.choose("#fit-add", YIELD)
    page.choose("#fit-add", "machine.compliance (compliance of the frame)")
    page.wait("!document.getElementById('fit-run').disabled")
    page.click("#fit-run")
    page.wait("fit.told?.runs > 0")
    name = page.js("fit.name")
    page.driver.get("about:blank")  # the tab is closed
    page.open()
    page.tab("fit")
    page.wait(f"fit.name === {json.dumps(name)} && fit.told?.runs > 0 && fit.told.running && isActiveJob(fit.name)")
    page.click("#jobs button")
    page.wait(f"page.jobs.find((one) => one.name === {json.dumps(name)}).state === 'stopped'")
    page.wait("!document.getElementById('fit-again').hidden")
    assert page.one("#fit-note").text.startswith("Not finished. ")
    page.click("#fit-again")
    page.wait("fit.told.running && isActiveJob(fit.name) && document.getElementById('fit-again').hidden")
    page.click("#jobs button")
    page.wait(f"page.jobs.find((one) => one.name === {json.dumps(name)}).state === 'stopped'")
