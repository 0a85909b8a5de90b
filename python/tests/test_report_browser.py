# SPDX-License-Identifier: BSD-3-Clause
"""The page of a run in a real browser, headless Chromium, without a network.

Needs Debian's packages chromium and chromium-driver, and selenium. BRINELL_NEED_BROWSER=1 makes a missing browser an
error instead of a reason to skip.
"""

import json
import os
import shutil
import time
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import pytest

from brinell.report import write_report
from brinell.results import open_run

MakeRun = Callable[..., Path]

CHROMIUM, DRIVER = shutil.which("chromium"), shutil.which("chromedriver")
NEEDED = os.environ.get("BRINELL_NEED_BROWSER") == "1"

pytestmark = pytest.mark.skipif(
    not NEEDED and (CHROMIUM is None or DRIVER is None),
    reason="no chromium with its driver: apt-get install chromium chromium-driver",
)

OPTIONS = (
    "--headless=new",
    "--no-sandbox",  # as root in a container there is none
    "--disable-dev-shm-usage",
    "--enable-unsafe-swiftshader",  # WebGL without a graphics card
    "--window-size=1400,1000",
    "--host-resolver-rules=MAP * ~NOTFOUND",
)


@pytest.fixture(scope="module")
def browser(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Any]:
    assert CHROMIUM is not None
    assert DRIVER is not None
    from selenium import webdriver

    options = webdriver.ChromeOptions()
    options.binary_location = CHROMIUM
    for option in (*OPTIONS, f"--user-data-dir={tmp_path_factory.mktemp('chromium')}"):
        options.add_argument(option)
    options.set_capability("goog:loggingPrefs", {"browser": "ALL", "performance": "ALL"})
    driver = webdriver.Chrome(options=options, service=webdriver.ChromeService(DRIVER))
    yield driver
    driver.quit()


def wait_for(browser: Any, condition: str, seconds: float = 60.0) -> Any:
    """What a JavaScript expression is worth once it is true."""
    end = time.monotonic() + seconds
    while time.monotonic() < end:
        value = browser.execute_script(f"return {condition}")
        if value:
            return value
        time.sleep(0.1)
    raise AssertionError(f"not within {seconds} s: {condition}")


def opened(browser: Any, path: Path) -> None:
    browser.get(path.as_uri())
    wait_for(browser, "document.readyState === 'complete'")


def choose(browser: Any, select: str, index: int) -> None:
    script = """
        const [select, index] = arguments;
        document.getElementById(select).value = index;
        document.getElementById(select).dispatchEvent(new Event("change"));"""
    browser.execute_script(script, select, index)


def shown(browser: Any, graph: str) -> Any:
    """Values that a graph shows now, the title of its colours, and its x."""
    script = (
        "const one = document.getElementById(arguments[0]).data[0]; return [one.z, one.colorbar.title.text, one.x];"
    )
    return browser.execute_script(script, graph)


@pytest.fixture(scope="module")
def pages(tmp_path_factory: pytest.TempPathFactory, written_runs: Callable[..., Path]) -> dict[str, Path]:
    folder = tmp_path_factory.mktemp("pages")
    drives = {"tugging": 9.0, "indentation": 3e6, "rolling": 3e6}
    return {
        scenario: write_report(open_run(written_runs(scenario, drive)), folder / f"{scenario}.html")
        for scenario, drive in drives.items()
    }


@pytest.mark.parametrize("scenario", ["tugging", "indentation", "rolling"])
def test_page_is_whole(scenario: str, browser: Any, pages: dict[str, Path]) -> None:
    browser.get_log("browser")
    browser.get_log("performance")
    opened(browser, pages[scenario])

    assert [entry["message"] for entry in browser.get_log("browser") if entry["level"] == "SEVERE"] == []
    events = [json.loads(entry["message"])["message"] for entry in browser.get_log("performance")]
    requests = [e["params"]["request"]["url"] for e in events if e["method"] == "Network.requestWillBeSent"]
    assert pages[scenario].as_uri() in requests
    assert [url for url in requests if not url.startswith(("file:", "data:", "blob:"))] == []

    sizes = browser.execute_script(
        "return [...document.images].map((image) => [image.naturalWidth, image.clientWidth, image.clientHeight])"
    )
    assert len(sizes) >= 8
    assert all(min(size) > 100 for size in sizes)
    assert browser.execute_script("return document.documentElement.scrollWidth <= window.innerWidth")

    wait_for(browser, "document.querySelector('#surface .gl-container canvas')")
    wait_for(browser, "document.querySelector('#slice .main-svg .heatmaplayer image')")
    for graph in ("surface", "slice"):
        width, height = browser.execute_script(
            "const box = document.querySelector(`#${arguments[0]} .svg-container`); "
            "return [box.clientWidth, box.clientHeight]",
            graph,
        )
        assert width > 800
        assert height > 400


def test_body_of_the_surface_can_be_chosen(browser: Any, pages: dict[str, Path]) -> None:
    opened(browser, pages["tugging"])
    names = browser.execute_script("return [...document.getElementById('surface-body').options].map((one) => one.text)")
    assert names == ["lower body", "upper body"]
    lower = shown(browser, "surface")
    browser.execute_script("document.getElementById('surface').data[0].x = []")
    choose(browser, "surface-body", 1)
    upper = shown(browser, "surface")
    assert len(upper[2]) == len(lower[2]) > 0  # drawn anew
    assert int(browser.execute_script("return document.getElementById('surface-factor').textContent")) > 1


def test_slices_follow_what_is_chosen(browser: Any, pages: dict[str, Path], written_runs: Callable[..., Path]) -> None:
    opened(browser, pages["tugging"])
    label = "document.getElementById('slice-label').textContent"
    first, title, _ = shown(browser, "slice")
    assert title == "Von Mises stress  [MPa]"
    assert browser.execute_script(f"return {label}") == "y = 0 mm"

    # The slider, by the keyboard as a user without a mouse moves it.
    slider = browser.find_element("id", "slice-place")
    slider.send_keys("\ue014")  # arrow right
    moved, *_ = shown(browser, "slice")
    assert moved != first
    assert browser.execute_script(f"return {label}") != "y = 0 mm"

    choose(browser, "slice-field", 1)
    assert shown(browser, "slice")[1] == "Equivalent plastic strain  [%]"

    choose(browser, "slice-plane", "z")
    at_depth, *_ = shown(browser, "slice")
    largest = browser.execute_script("return Math.max(...arguments[0].flat())", at_depth)
    run = open_run(written_runs("tugging", 9.0))
    assert largest == pytest.approx(100.0 * run.snapshot("final").lower.equivalent_plastic_strain.max(), rel=1e-6)
    assert browser.execute_script(f"return {label}").startswith("z = ")

    choose(browser, "slice-plane", "x")
    across, *_ = shown(browser, "slice")
    assert (len(across), len(across[0])) != (len(at_depth), len(at_depth[0]))

    choose(browser, "slice-body", 1)
    assert shown(browser, "slice")[1] == "Equivalent plastic strain  [%]"  # the field stays


def test_nothing_can_be_sent_away(browser: Any, pages: dict[str, Path]) -> None:
    opened(browser, pages["tugging"])
    buttons = wait_for(browser, "[...document.querySelectorAll('.modebar-btn')].map((one) => one.dataset.title)")
    assert "Reset axes" in buttons
    assert not any("share" in title.lower() or "cloud" in title.lower() for title in buttons)
