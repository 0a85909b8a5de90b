# SPDX-License-Identifier: BSD-3-Clause
"""The page of `brinell app` in a browser, by what a user sees and does."""

from __future__ import annotations

import io
import os
import shutil
import time
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from PIL import Image

from app_server import Server

PAPER = Path(__file__).parents[2] / "cases" / "tugging-paper" / "case.toml"
SCREENSHOTS = os.environ.get("BRINELL_SCREENSHOTS")
CONTROL_A, DELETE, TAB, ENTER = "\ue009a\ue000", "\ue017", "\ue004", "\ue007"
LEFT, RIGHT = "\ue012", "\ue014"


class Page:
    """The page, by what a user sees and does."""

    def __init__(self, driver: Any, server: Server):
        self.driver = driver
        self.server = server

    def open(self) -> None:
        """Opens the address that the command has printed, and waits for the first curve."""
        self.driver.execute_script(
            "if (typeof page === 'object') page.changed = false"
        )  # it is left without a question
        self.driver.get(self.server.address)
        self.wait("document.body.dataset.ready")
        self.wait("document.body.dataset.took")

    def wait(self, condition: str, seconds: float = 180.0) -> Any:
        """What a JavaScript expression is worth once it is true."""
        from test_report_browser import wait_for

        return wait_for(self.driver, condition, seconds)

    def js(self, expression: str, *arguments: Any) -> Any:
        """What a JavaScript expression is worth."""
        return self.driver.execute_script(f"return {expression}", *arguments)

    def one(self, selector: str) -> Any:
        """The element of a selector."""
        return self.driver.find_element("css selector", selector)

    def act(self, selector: str, do: Callable[[Any], None]) -> None:
        """Does something with an element, again if the form was drawn anew meanwhile."""
        from selenium.common.exceptions import StaleElementReferenceException

        for _ in range(20):
            try:
                element = self.one(selector)
                self.driver.execute_script("arguments[0].scrollIntoView({block: 'center'})", element)
                do(element)
                return
            except StaleElementReferenceException:
                time.sleep(0.1)
        raise AssertionError(f"{selector} is always drawn anew")

    def click(self, selector: str) -> None:
        """Clicks an element that may lie outside of what is seen."""
        self.act(selector, lambda element: element.click())

    def choose(self, selector: str, text: str) -> None:
        """Chooses an entry of a menu by its text."""
        from selenium.webdriver.support.ui import Select

        self.act(selector, lambda element: Select(element).select_by_visible_text(text))

    def type(self, key: str, text: str) -> None:
        """Types into the field of a key, and leaves it."""
        self.act(f'[id="f-{key}"]', lambda element: element.send_keys(CONTROL_A, DELETE, text, TAB))

    def settled(self) -> None:
        """Waits until the check has answered and the curve has followed."""
        self.wait("!changing && !preview.abort && !preview.next")

    def values(self) -> dict[str, Any]:
        """The case."""
        found: dict[str, Any] = self.js("page.values")
        return found

    def curves(self) -> dict[str, Any]:
        """The curves that are drawn: x and y by name, in the units of the axes."""
        drawn = self.js("document.getElementById('curve').data")
        return {one["name"]: (np.array(one["x"]), np.array(one["y"]), one) for one in drawn}

    def unfold(self) -> None:
        """Opens all that is folded in the form."""
        folded = "document.querySelectorAll('#form details:not([open])')"
        for _ in range(20):
            if not self.js(f"{folded}.length"):
                return
            self.js(f"{folded}.forEach((one) => {{ one.open = true; }})")
            time.sleep(0.1)
        raise AssertionError("the form does not unfold")

    def tab(self, name: str) -> None:
        """Chooses a view."""
        self.click(f"#tab-{name}")

    def picture(self, name: str, *, scrolls: bool = True) -> None:
        """Keeps what the page looks like, for the documentation."""
        if SCREENSHOTS:
            self.frames()
            self.js(f"document.activeElement.blur(), {int(scrolls)} && document.getElementById('left').scrollTo(0, 0)")
            self.frames()
            picture = Image.open(io.BytesIO(self.driver.get_screenshot_as_png()))
            picture.convert("RGB").save(Path(SCREENSHOTS) / f"app-{name}.png", optimize=True)

    def frames(self) -> None:
        """Waits until the browser has drawn what has changed."""
        self.driver.execute_async_script(
            "const done = arguments[0]; document.fonts.ready.then(() => requestAnimationFrame(() => "
            "requestAnimationFrame(() => setTimeout(done))))"
        )

    def complaints(self) -> list[str]:
        """What the browser holds against the page."""
        return [entry["message"] for entry in self.driver.get_log("browser") if entry["level"] == "SEVERE"]

    def finished(self, count: int) -> None:
        """Waits until so many runs are shown that have finished."""
        self.wait(f"page.shown.length === {count} && page.shown.every((one) => one.complete && one.outline)")


@pytest.fixture(scope="module")
def driver(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Any]:
    from selenium import webdriver

    from test_report_browser import CHROMIUM, DRIVER, OPTIONS

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
