# SPDX-License-Identifier: BSD-3-Clause
"""Results for the tests: made-up ones, that look as wished, and real ones, which the engine computes."""

from __future__ import annotations

import functools
import shutil
import signal
from collections.abc import Callable
from pathlib import Path
from typing import Any

import matplotlib
import pytest

import brinell
from app_page import driver, page, server  # noqa: F401  # the page of `brinell app`, for several files
from brinell.plot import style
from synthetic_files import WRITERS

matplotlib.use("Agg")

# Started in the background of a script, as a CI may do, this process and those that it starts would ignore Ctrl-C.
signal.signal(signal.SIGINT, signal.default_int_handler)


@pytest.fixture(autouse=True)
def coarse_pixels(monkeypatch: pytest.MonkeyPatch) -> None:
    """Nobody looks at the pictures of a test: write few pixels."""
    monkeypatch.setitem(style._RC, "savefig.dpi", 40)


@pytest.fixture(scope="session")
def written_runs(tmp_path_factory: pytest.TempPathFactory) -> Callable[..., Path]:
    """Writes each kind of result folder once."""

    @functools.cache
    def written(scenario: str, drive: float, **options: Any) -> Path:
        return WRITERS[scenario](tmp_path_factory.mktemp("runs") / "run", drive, **options)

    return written


@pytest.fixture
def make_run(tmp_path: Path, written_runs: Callable[..., Path]) -> Callable[..., Path]:
    """Puts the result folder of a tugging under the test's own folder and returns its path."""

    def make(alpha: float = 9.0, name: str | None = None, **options: Any) -> Path:
        return shutil.copytree(written_runs("tugging", alpha, **options), tmp_path / (name or f"alpha{alpha:g}"))

    return make


def _maker(scenario: str, tmp_path: Path, written_runs: Callable[..., Path]) -> Callable[..., Path]:
    def make(load: float = 3e6, name: str = scenario, **options: Any) -> Path:
        return shutil.copytree(written_runs(scenario, load, **options), tmp_path / name)

    return make


@pytest.fixture
def make_indentation(tmp_path: Path, written_runs: Callable[..., Path]) -> Callable[..., Path]:
    """The same of an indentation."""
    return _maker("indentation", tmp_path, written_runs)


@pytest.fixture
def make_rolling(tmp_path: Path, written_runs: Callable[..., Path]) -> Callable[..., Path]:
    """The same of a rolling."""
    return _maker("rolling", tmp_path, written_runs)


REAL_CASE = """scenario = "tugging"
title = "two spheres"
[lower]
shape = {type = "sphere", radius = "1 mm"}
[lower.material]
young_modulus = "200 GPa"
poisson_ratio = 0.3
hardening = {law = "linear", yield_stress = "1 GPa", modulus = "20 GPa"}
[upper]
shape = {type = "sphere", radius = "2 mm"}
material = {young_modulus = "200 GPa", poisson_ratio = 0.3}
[tugging]
interference = 4
[grid]
resolution = 3
[output]
snapshots = "every 4"
checkpoint_interval = 0
"""


@pytest.fixture
def real_case() -> str:
    """The case of the real results."""
    return REAL_CASE


@pytest.fixture(scope="session")
def real_folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The result of a tugging that the engine has computed, in a moment, with several stored steps."""
    folder = tmp_path_factory.mktemp("real") / "complete"
    brinell.Case(REAL_CASE).run(folder)
    return folder


@pytest.fixture(scope="session")
def interrupted_folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """What is left of the same run when it is stopped after some steps."""
    folder = tmp_path_factory.mktemp("real") / "interrupted"

    def stop(step: int, *_: object) -> None:
        if step == 9:
            raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        brinell.Case(REAL_CASE).run(folder, progress=stop)
    return folder
