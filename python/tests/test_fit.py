# SPDX-License-Identifier: BSD-3-Clause
"""Identification: curves of known materials give their materials back, within the intervals that are stated."""

from __future__ import annotations

import datetime
import json
import os
import time
from concurrent.futures import Future
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import brinell
import brinell.cli

pytest.importorskip("scipy")

from brinell._toml import tomllib
from brinell.fits import Course, Data, Fit, Unknown, data_from_file
from brinell.fits.checks import turning_points
from brinell.fits.fitting import _pool
from brinell.fits.model import load_at

pytestmark = pytest.mark.filterwarnings("ignore::brinell.ResolutionWarning", "ignore::brinell.CaseWarning")

PARTS = 6
FINE = {"grid.resolution": 6}
FRAME = 5e-9
"""Compliance of the frame [m/N] in curves with three unknowns."""
TRUTH = {"yield_stress": 900e6, "modulus": 5e9}
HARDENING = {"law": "linear", **TRUTH}
YIELD, MODULUS = "lower.material.hardening.yield_stress", "lower.material.hardening.modulus"
YOUNG = "lower.material.young_modulus"


def ball(**changes: Any) -> brinell.Case:
    """A rigid ball of 1 mm on a steel that hardens linearly, with coarse cells."""
    values = {
        "scenario": "indentation",
        "lower": {
            "shape": {"type": "flat"},
            "material": {"young_modulus": 210e9, "poisson_ratio": 0.3, "hardening": dict(HARDENING)},
        },
        "upper": {"shape": {"type": "sphere", "radius": 1e-3}, "material": {"rigid": True}},
        "indentation": {"load": [600.0, 0.0], "steps": 5},
        "grid": {"resolution": 4},
    }
    return brinell.Case.from_values(values).with_values(changes)


def history(case: brinell.Case) -> tuple[np.ndarray, np.ndarray]:
    rows = list(case.steps(threads=1))
    return tuple(np.array([0.0, *(row[name] for row in rows)]) for name in ("approach", "F_n"))  # type: ignore[return-value]


def measured(case: brinell.Case, points: int = 40) -> tuple[np.ndarray, np.ndarray]:
    """Depths and loads of a run between its steps, loading and unloading."""
    depth, load = history(case)
    top = int(np.argmax(load))
    up, down = np.linspace(0.03, 1.0, points) * depth[top], np.linspace(depth[top], depth[-1], points // 2)[1:]
    loads = load_at(depth[: top + 1], load[: top + 1], up), load_at(depth[top:], load[top:], down)
    return np.concatenate([up, down]), np.concatenate(loads)


@pytest.fixture(scope="module")
def curve() -> tuple[np.ndarray, np.ndarray]:
    return measured(ball())


@pytest.fixture(scope="module")
def fine_curve() -> tuple[np.ndarray, np.ndarray]:
    return measured(ball(**FINE))


def unknowns() -> list[Unknown]:
    return [
        Unknown(YIELD, "300 MPa", "3 GPa"),
        Unknown(MODULUS, "0.5 GPa", "50 GPa", name="hardening modulus"),
        Unknown("machine.compliance", 0.0, "20 um/kN"),
    ]


def truths() -> list[float]:
    return [TRUTH["yield_stress"], TRUTH["modulus"], FRAME]


def scattered(curve: tuple[np.ndarray, np.ndarray], seed: int) -> Data:
    scatter = np.random.default_rng(seed).standard_normal(curve[1].size)
    depth, load = curve
    return Data(depth + FRAME * load, load * (1.0 + 0.01 * scatter), name="ball", noise="1 %")


DAY = datetime.datetime.now(datetime.timezone.utc).date().toordinal()
NAMED = os.environ.get("BRINELL_SWEEP", "")


def on_day(part: int) -> pytest.MarkDecorator:
    """Long tests take turns, one each day; with BRINELL_SWEEP=0 ... 5 a certain one, with =all all."""
    today = part if NAMED == "all" else int(NAMED or DAY) % PARTS
    return pytest.mark.skipif(today != part, reason="has another day: BRINELL_SWEEP=all runs all")


@on_day(5)
def test_curves_without_noise_give_the_material_back(fine_curve: tuple[np.ndarray, np.ndarray]) -> None:
    found = brinell.fit(
        ball(**FINE), unknowns(), Data(fine_curve[0] + FRAME * fine_curve[1], fine_curve[1], name="ball")
    )
    assert found.converged
    assert [one.value for one in found.estimates] == pytest.approx(truths(), rel=0.005)
    for one, truth in zip(found.estimates, truths(), strict=True):
        assert one.low < truth < one.high


@on_day(1)
def test_kinematic_hardening_is_found_from_a_cycle() -> None:
    hardening = {"law": "perfect", "yield_stress": 700e6, "back_stresses": [{"modulus": 60e9}]}
    case = ball(**{"indentation.load": [600.0, 60.0, 600.0, 0.0], "indentation.steps": 6})
    case = brinell.Case.from_values(
        tomllib.loads(case.to_toml())
        | {
            "lower": {
                "shape": {"type": "flat"},
                "material": {"young_modulus": 210e9, "poisson_ratio": 0.3, "hardening": hardening},
            }
        }
    )
    depth, load = history(case)
    wanted = [
        Unknown(YIELD, "200 MPa", "2 GPa"),
        Unknown("lower.material.hardening.back_stresses[0].modulus", 1e10, 3e11),
    ]
    found = brinell.fit(case, wanted, Data(depth[1:], load[1:]))
    assert [one.value for one in found.estimates] == pytest.approx([700e6, 60e9], rel=0.005)


def test_an_unknown_that_does_not_matter_is_named(curve: tuple[np.ndarray, np.ndarray]) -> None:
    deep = {"depth": [0.0, 2e-3, 3e-3], "factor": [1.0, 1.0, 1.0]}
    key = "lower.material.yield_profile.factor.2"
    wanted = [*unknowns()[::2], Unknown(key, 0.5, 3.0, name="deep factor")]
    found = brinell.fit(ball(**{"lower.material.yield_profile": deep}), wanted, scattered(curve, 1))
    assert found[YIELD].determined
    assert not found[key].determined
    assert (found[key].low, found[key].high) == (0.5, pytest.approx(3.0))
    assert any("deep factor" in text and "not determined" in text for text in found.findings)


def test_unknowns_that_make_up_for_each_other_are_named() -> None:
    """Loading below yield: only E' counts, of which Young's modulus and the tip's radius are parts."""
    elastic = ball(**{"indentation.load": [1.5], "indentation.steps": 6})
    depth, load = history(elastic)
    wanted = [Unknown(YOUNG, "100 GPa", "400 GPa"), Unknown("upper.shape.radius", "0.3 mm", "3 mm")]
    found = brinell.fit(elastic, wanted, Data(depth[1:], load[1:], noise="1 %"))
    assert any("hardly separable" in text for text in found.findings)
    assert not all(one.determined for one in found.estimates)


def test_compliance_and_first_touch_are_found(curve: tuple[np.ndarray, np.ndarray]) -> None:
    depth, load = curve
    wanted = [
        Unknown(YIELD, "300 MPa", "3 GPa"),
        Unknown("machine.compliance", 0.0, "50 um/kN"),
        Unknown("machine.first_touch", "-2 um", "2 um"),
    ]
    shifted = Data(depth + 1e-8 * load + 0.3e-6, load, name="ball")
    found = brinell.fit(ball(), wanted, shifted)
    assert [one.value for one in found.estimates] == pytest.approx([900e6, 1e-8, 0.3e-6], rel=0.002)
    assert any("first touch" in text and "not determined" in text and "resolution" in text for text in found.findings)


@on_day(3)
def test_other_kinds_of_data() -> None:
    """The imprint and a number of the summary, with a prior on what they do not tell."""
    case = ball()
    run = case.steps(threads=1)
    list(run)
    body = run.fields()["lower"]
    middle = np.argmin(np.abs(body["y"]))
    imprint = Data(body["x"], 1e-7 - body["residual_displacement"][middle], kind="imprint", name="imprint")
    hardness = run.summary()["indents"][0]["hardness_Pa"]
    number = Data(
        np.zeros(1),
        np.array([hardness]),
        kind="number",
        columns=["indents.0.hardness_Pa"],
        noise="1 %",
        name="hardness",
    )
    wanted = [
        Unknown(YIELD, "300 MPa", "3 GPa"),
        Unknown(YOUNG, "150 GPa", "300 GPa", prior=210e9, prior_deviation="1 %"),
    ]
    found = brinell.fit(case, wanted, [imprint, number])
    assert found[YIELD].value == pytest.approx(900e6, rel=0.005)
    forces = Data(*history(case), kind="history", columns=["approach", "F_n"])
    with pytest.raises(brinell.InputError, match="goes to and fro"):
        brinell.fit(case, wanted[:1], forces)


@on_day(4)
def test_outliers_count_less_with_a_robust_loss(curve: tuple[np.ndarray, np.ndarray]) -> None:
    data = scattered(curve, 3)
    data.y[[10, 25]] *= 1.4  # that of the shallow point is within the errors of coarse cells
    wanted = unknowns()[::2]
    plain, robust = (brinell.fit(ball(), wanted, data, loss=loss, method_error=0.0) for loss in ("linear", "soft_l1"))
    assert any("outlier (point 26)" in text for text in plain.findings)
    assert abs(robust[YIELD].value - 900e6) < abs(plain[YIELD].value - 900e6)


BROKEN = {
    "load in mN": (lambda x, y: (x, 1e3 * y), "is the unit right"),
    "depth in nm": (lambda x, y: (1e9 * x, y), "is the unit right"),
    "pull": (lambda x, y: (x, -y), 'reverse = \\["y"\\]'),
    "depth upwards": (lambda x, y: (-x, y), 'reverse = \\["x"\\]'),
    "shuffled": (lambda x, y: (np.tile(x[:40], 2), np.tile(y[:40], 2)), "branches"),
    "not finite": (lambda x, y: (x, np.where(y > 100, np.nan, y)), "finite"),
    "two points": (lambda x, y: (x[:2], y[:2]), "2 points"),
}


@pytest.mark.parametrize("name", BROKEN)
def test_broken_data_are_told(name: str, curve: tuple[np.ndarray, np.ndarray]) -> None:
    damage, text = BROKEN[name]
    with pytest.raises(brinell.InputError, match=text):
        brinell.fit(ball(), unknowns()[:1], Data(*damage(*curve)))


@on_day(0)
def test_holds_and_drift_are_told(curve: tuple[np.ndarray, np.ndarray]) -> None:
    depth, load = curve
    top = int(np.argmax(load))
    held = np.linspace(0.0, 0.4e-6, 12)[1:]
    x = np.concatenate([depth[: top + 1], depth[top] + held, depth[top + 1 :] + held[-1]])
    y = np.concatenate([load[: top + 1], np.full(held.size, load[top]), load[top + 1 :]])
    time = np.arange(x.size, dtype=float)
    wanted = [Unknown(YIELD, "300 MPa", "3 GPa")]
    left = brinell.fit(ball(), wanted, Data(x, y, time=time, name="held"))
    assert any("held at 600 N" in text and "machine.drift" in text for text in left.findings)
    assert left.curves[0].data.x.size == depth.size
    taken_off = brinell.fit(ball(), wanted, Data(x, y, name="held", holds="subtract"))
    assert taken_off[YIELD].value == pytest.approx(900e6, rel=0.005)
    assert taken_off.misfit < left.misfit


def test_turns_are_found_in_scatter() -> None:
    path = np.concatenate([np.linspace(0, 1, 50), np.linspace(1, 0.2, 40), np.linspace(0.2, 1, 40)])
    noisy = path + 0.01 * np.random.default_rng(0).standard_normal(path.size)
    assert np.array(turning_points(noisy, 0.2)[1:-1]) == pytest.approx([50, 90], abs=3)


FILE = """
title = "ball"
case = "case.toml"

[[unknown]]
key = "lower.material.hardening.yield_stress"
low = "300 MPa"
high = "3 GPa"

[[data]]
file = "ball.csv"
noise = "1 %"
"""


@pytest.fixture
def folder(tmp_path: Path, curve: tuple[np.ndarray, np.ndarray]) -> Path:
    ball().to_toml(tmp_path / "case.toml")
    rows = "\n".join(f"{1e6 * x:.6f};{y:.5f}".replace(".", ",") for x, y in zip(*curve, strict=True))
    (tmp_path / "ball.csv").write_text(f"depth;load\n[um];[N]\n{rows}\n", encoding="utf-8")
    (tmp_path / "fit.toml").write_text(FILE, encoding="utf-8")
    return tmp_path


def test_the_command_writes_estimates_case_figures_and_report(folder: Path, capsys: pytest.CaptureFixture[str]) -> None:
    with pytest.raises(SystemExit) as ended:
        brinell.cli.main(["fit", str(folder / "fit.toml"), "-o", str(folder / "out")])
    assert ended.value.code == 0
    assert "95 % interval" in capsys.readouterr().out
    found = json.loads((folder / "out" / "fit.json").read_text(encoding="utf-8"))
    assert found["unknowns"][0]["value"] == pytest.approx(900e6, rel=0.005)
    fitted = brinell.Case.from_file(folder / "out" / "fitted.toml")
    assert "hardening" in fitted.to_toml()
    assert (folder / "out" / "figures" / "curve.png").is_file()
    assert "Fitted case" in (folder / "out" / "report.html").read_text(encoding="utf-8")


WRONG = {
    'high = "3 GPa"': ('high = "3 mm"', "fit.toml:8: unknown lower.material.hardening.yield_stress: high"),
    'low = "300 MPa"': ('low = "5 GPa"', "is not above low"),
    "yield_stress": ("yield_stres", "did you mean"),
    'noise = "1 %"': ('nose = "1 %"', "fit.toml:12: .*nose is not known; did you mean noise"),
    'file = "ball.csv"': ('file = "gone.csv"', "no such file"),
    'case = "case.toml"': ("case = 3", "fit.toml:3: case = 3; allowed: text"),
    "[[data]]": ("[[date]]", "date is not known"),
}


@pytest.mark.parametrize("given", WRONG)
def test_errors_in_the_file_name_line_and_what_is_allowed(folder: Path, given: str) -> None:
    put, text = WRONG[given]
    (folder / "fit.toml").write_text(FILE.replace(given, put, 1), encoding="utf-8")
    with pytest.raises(brinell.InputError, match=text):
        brinell.fit(folder / "fit.toml")


def test_columns_are_found_by_title_and_unit(folder: Path, curve: tuple[np.ndarray, np.ndarray]) -> None:
    read = data_from_file(folder / "ball.csv")
    np.testing.assert_allclose(read.x, curve[0], atol=1e-12)
    np.testing.assert_allclose(read.y, curve[1], atol=1e-5)
    with pytest.raises(brinell.InputError, match="no column 'deep'"):
        data_from_file(folder / "ball.csv", x="deep")
    (folder / "text.csv").write_text("depth,load\n1,2\n2,x\n", encoding="utf-8")
    with pytest.raises(brinell.InputError, match="text.csv:3"):
        data_from_file(folder / "text.csv")


@on_day(2)
def test_figures_show_every_unknown(curve: tuple[np.ndarray, np.ndarray]) -> None:
    found: Fit = brinell.fit(ball(), unknowns()[::2], scattered(curve, 5), profiles=[YIELD])
    figures = found.figures()
    assert set(figures) >= {"curve", "corner", "profiles"}
    assert len(figures["corner"].axes) == 4
    assert found[YIELD].by_profile


def test_the_course_of_a_fit_is_told(curve: tuple[np.ndarray, np.ndarray]) -> None:
    seen: list[Course] = []
    unknown = Unknown(YIELD, "300 MPa", "3 GPa")
    result = brinell.fit(ball(), unknowns=[unknown], data=Data(*curve, noise="1 %"), watch=seen.append)
    runs = [one.runs for one in seen]
    assert runs == sorted(runs)
    assert runs[-1] == result.runs
    stages = list(dict.fromkeys(one.stage for one in seen))
    assert stages[:2] == ["points between the bounds", "first search"]
    assert stages[-1] == "intervals"
    for stage in ("first search", "cells of the case"):
        misfits = [one.misfit for one in seen if one.stage == stage and one.misfit is not None]
        assert misfits == sorted(misfits, reverse=True), stage  # the best of the stage so far
    last = seen[-1]
    ((value, unit),) = last.values.values()
    assert unit == "Pa"
    assert result["yield stress"].low < value < result["yield stress"].high
    assert [one.size for one in last.fitted] == [one.data.y.size for one in result.curves]
    assert all(one is other.data for one, other in zip(last.data, result.curves, strict=True))


def test_runs_that_wait_are_given_up_when_a_fit_is_interrupted() -> None:
    waiting: list[Future[None]] = []

    def interrupted() -> None:
        with _pool(1, None) as pool:
            waiting.extend(pool.submit(time.sleep, 0.1) for _ in range(50))
            raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        interrupted()
    assert sum(one.cancelled() for one in waiting) > 45
