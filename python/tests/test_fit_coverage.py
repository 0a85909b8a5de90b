# SPDX-License-Identifier: BSD-3-Clause
"""Statistics of fits without the errors of cells: a formula takes the place of the runs."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

import brinell

pytest.importorskip("scipy")

from brinell._toml import tomllib
from brinell.fits import Data, Unknown, problem
from brinell.fits.checks import without_holds
from brinell.fits.model import Observed, Wanted, load_at

pytestmark = pytest.mark.filterwarnings("ignore::brinell.ResolutionWarning", "ignore::brinell.CaseWarning")

LOAD, RADIUS, CONTACT_MODULUS, FRAME, NOISE = 600.0, 1e-3, 230e9, 5e-9, 0.01
KEYS = ("lower.material.hardening.yield_stress", "lower.material.hardening.modulus", "machine.compliance")
TRUTH = (900e6, 5e9, FRAME)
DRAWS = 40


def indentation() -> brinell.Case:
    steel = brinell.Material("210 GPa", 0.3, brinell.Linear(TRUTH[0], TRUTH[1]))
    return brinell.Indentation(
        lower=brinell.Body(brinell.Flat(), steel),
        upper=brinell.Body(brinell.Sphere(RADIUS), brinell.RIGID),
        load=[LOAD, 0],
        grid={"resolution": 4},
    )


def formula(case: brinell.Case, wanted: Wanted, threads: int) -> Observed:
    """A ball on a plastic half space, after Tabor (1951): mean pressure 2.8 times the stress at a strain of 0.2 a/R."""
    hardening = tomllib.loads(case.to_toml())["lower"]["material"]["hardening"]
    count = 20
    radius = np.linspace(0.0, 6e-4, 4000)
    carried = np.pi * radius**2 * 2.8 * (hardening["yield_stress"] + hardening["modulus"] * 0.2 * radius / RADIUS)
    up = LOAD * np.linspace(0.0, 1.0, count + 1)[1:] ** 2
    down = LOAD * np.linspace(1.0, 0.0, count + 1)[1:]
    contact = np.interp(up, carried, radius)
    depth = contact**2 / (2.0 * RADIUS) + np.cbrt(9.0 * up**2 / (16.0 * CONTACT_MODULUS**2 * RADIUS))
    recovered = 0.75 * LOAD / (CONTACT_MODULUS * contact[-1]) * (1.0 - (down / LOAD) ** (2.0 / 3.0))
    columns = {
        "approach": np.concatenate([depth, depth[-1] - recovered]),
        "F_n": np.concatenate([up, down]),
        "place": np.ones(2 * count),
    }
    summary: dict[str, Any] = {"grid": {"spacing_m": [2e-5] * 3}}
    return Observed(columns, summary, None, is_load_driven=True)


def curve(points: int) -> tuple[np.ndarray, np.ndarray]:
    """Depths of an instrument and loads, of loading and unloading."""
    run = formula(indentation(), Wanted((), False), 1)
    depth, load = (np.concatenate([[0.0], run.columns[name]]) for name in ("approach", "F_n"))
    top = int(np.argmax(load))
    up, down = np.linspace(0.03, 1.0, points) * depth[top], np.linspace(depth[top], depth[-1], points // 2)[1:]
    loads = np.concatenate([load_at(depth[: top + 1], load[: top + 1], up), load_at(depth[top:], load[top:], down)])
    return np.concatenate([up, down]) + FRAME * loads, loads


@pytest.mark.parametrize("of", ["value", "top"])
def test_intervals_hold_as_often_as_they_say(of: str, monkeypatch: pytest.MonkeyPatch) -> None:
    """Draws of noise: each interval of 95 % has the truth in 95 of 100, and the search ends at the minimum.

    The sum of squares at the truth, less that at the estimate, is chi-squared with as many degrees of freedom as there
    are unknowns: mean 3, variance 6. The bounds are four standard deviations of the mean, and those of the binomial
    distribution.
    """
    monkeypatch.setattr(problem, "observe", formula)
    depth, load = curve(40)
    unknowns = [
        Unknown(KEYS[0], "300 MPa", "3 GPa"),
        Unknown(KEYS[1], "0.5 GPa", "50 GPa", name="hardening modulus"),
        Unknown(KEYS[2], 0.0, "20 um/kN"),
    ]
    deviation = NOISE * (load if of == "value" else np.full(load.size, LOAD))
    told = "1 %" if of == "value" else float(deviation[0])
    inside, gained = np.zeros(3), []
    for seed in range(DRAWS):
        noise = deviation * np.random.default_rng(seed).standard_normal(load.size)
        data = Data(depth, load + noise, noise=told)
        found = brinell.fit(indentation(), unknowns, data, method_error=0.0, workers=1)
        assumed, _ = data.deviations()
        assert assumed is not None
        gained.append(np.sum((noise / assumed) ** 2 - ((found.curves[0].fitted - data.y) / assumed) ** 2))
        inside += [one.data_low < truth < one.data_high for one, truth in zip(found.estimates, TRUTH, strict=True)]
    print(f"inside {inside}, gained {np.mean(gained):.2f}")
    assert np.all(inside >= DRAWS * 0.95 - 3.0 * np.sqrt(DRAWS * 0.95 * 0.05))
    assert np.mean(gained) == pytest.approx(3.0, abs=4.0 * np.sqrt(6.0 / DRAWS))


@pytest.mark.parametrize("of", ["value", "top"])
@pytest.mark.parametrize("points", [40, 200, 1000])
def test_scatter_is_no_hold(points: int, of: str) -> None:
    """Many points with noise have some neighbours of nearly the same load; they stay."""
    depth, load = curve(points)
    for seed in range(10):
        scatter = NOISE * np.random.default_rng(seed).standard_normal(load.size)
        left, notes = without_holds(Data(depth, load + scatter * (load if of == "value" else LOAD)))
        assert not notes
        assert left.x.size == depth.size


@pytest.mark.parametrize("noise", [0.0, 1e-3])
@pytest.mark.parametrize("points", [40, 1000])
@pytest.mark.parametrize("where", [1.0, 0.1])
def test_holds_are_found_in_scatter(noise: float, points: int, where: float) -> None:
    """At the peak, and where most of the load is off; 2 % of the depth are added."""
    depth, load = curve(points)
    top = int(np.argmax(load))
    at = top if where == 1.0 else top + int(np.flatnonzero(load[top:] < where * LOAD)[0])
    held = np.linspace(0.0, 0.02 * depth[top], points // 4 + 1)[1:]
    x = np.concatenate([depth[: at + 1], depth[at] + held, depth[at + 1 :] + held[-1]])
    y = np.concatenate([load[: at + 1], np.full(held.size, load[at]), load[at + 1 :]])
    y += noise * LOAD * np.random.default_rng(0).standard_normal(y.size)
    left, notes = without_holds(Data(x, y))
    assert len(notes) == 1
    assert x.size - left.x.size == pytest.approx(held.size, rel=0.1, abs=2)
