# SPDX-License-Identifier: BSD-3-Clause
"""Warnings, resolution and accuracy of a run, as Python and the report show them."""

from __future__ import annotations

import warnings
from pathlib import Path

import pytest

import brinell
from brinell.report import write_report
from brinell.report.findings import findings_of

STEEL = brinell.Material("210 GPa", 0.3, brinell.Perfect("1 GPa"))


def press(resolution: float = 7.0, load: str = "5 N") -> brinell.Indentation:
    """A rigid ball on a flat that yields: some tenths of a second."""
    return brinell.Indentation(
        brinell.Body(brinell.Flat(), STEEL),
        brinell.Body(brinell.Sphere("1 mm"), brinell.RIGID),
        load=[load, 0],
        steps=6,
        grid={"resolution": resolution},
        output={"snapshots": "none"},
    )


def test_a_good_run_is_silent() -> None:
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        run = press().run()
    assert run.warnings == []
    assert run.resolution["cells_per_contact_radius"] > 6.0
    assert run.accuracy == {}
    assert findings_of(run) == []


@pytest.mark.parametrize(
    ("case", "key"),
    [(press(resolution=3.0), "coarse_contact"), (press(load="0.01 N"), "no_yield")],
)
def test_warnings_are_told_once_and_kept(case: brinell.Case, key: str, tmp_path: Path) -> None:
    assert [warning.key for warning in case.warnings] == [key]
    with pytest.warns(brinell.ResolutionWarning) as told:
        run = case.run(tmp_path / "run")
    assert [warning.key for warning in run.warnings] == [key]
    assert [str(one.message) for one in told] == [run.warnings[0].text]
    assert run.summary is not None
    assert run.summary["warnings"][0]["key"] == key
    alone = brinell.open(tmp_path / "run" / "result.vtkhdf")  # the file alone knows them, too
    assert alone.warnings == run.warnings
    page = write_report(run, tmp_path / "page.html").read_text(encoding="utf-8")
    assert run.warnings[0].text[1:].split(";")[0] in page
    assert "cells per contact radius" in page


@pytest.mark.filterwarnings("ignore::brinell.ResolutionWarning")
def test_accuracy(tmp_path: Path) -> None:
    run = press(4.0).run(tmp_path / "run", accuracy="40 %")
    number = run.accuracy["indents[0].residual_depth_m"]
    assert number.low < number.value < number.high
    assert number.value == run.indents[0].residual_depth
    assert number.relative_error <= 0.4
    assert brinell.open(tmp_path / "run" / "accuracy" / "1").complete
    page = write_report(run, tmp_path / "page.html").read_text(encoding="utf-8")
    assert "Grid Convergence Index" in page
    assert "indents[0].residual_depth_m" in page


def test_a_bad_accuracy_is_refused() -> None:
    with pytest.raises(brinell.InputError, match=r"solver\.accuracy"):
        press().run(accuracy=2.0)
