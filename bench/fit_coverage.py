# SPDX-License-Identifier: BSD-3-Clause
"""How often the intervals of `brinell fit` hold: curves of a known steel with 1 % of noise, drawn anew and fitted.

    bench/fit_coverage.py                       # 20 draws, on two cores
    bench/fit_coverage.py --resolution 6 --noise top --method 0.01

Three questions are answered apart. Is each unknown within its own interval (95 of 100)? Are all three at once (with
intervals of 95 %, in 86 to 95 of 100, depending on how the estimates are correlated)? Is the search at the minimum?
The sum of squares at the truth, less that at the estimate, is then chi-squared with three degrees of freedom, of mean
3, as long as cells make no difference. They do at light loads, which rest on few of them.

With --finer the curves come from another discretisation than that of the fit: cells of two thirds of the size, twice
the steps, and depths that are imposed instead of loads.
"""

from __future__ import annotations

import argparse
import json
import time
import warnings
from concurrent.futures import ProcessPoolExecutor
from typing import Any

import numpy as np

import brinell
from brinell.fits import Data, Unknown
from brinell.fits.model import load_at

NOISE = 0.01
YIELD, MODULUS = "lower.material.hardening.yield_stress", "lower.material.hardening.modulus"
FRAME = 5e-9
"""Compliance of the frame [m/N]."""
TRUTH = {YIELD: 900e6, MODULUS: 5e9, "machine.compliance": FRAME}


def ball(resolution: float, steps: int, **how: Any) -> brinell.Case:
    """A rigid ball of 1 mm on a steel that hardens linearly; loading and unloading."""
    steel = brinell.Material("210 GPa", 0.3, brinell.Linear(TRUTH[YIELD], TRUTH[MODULUS]))
    return brinell.Indentation(
        lower=brinell.Body(brinell.Flat(), steel),
        upper=brinell.Body(brinell.Sphere("1 mm"), brinell.RIGID),
        steps=steps,
        grid={"resolution": resolution},
        **(how or {"load": ["600 N", 0]}),
    )


def finer(resolution: float, steps: int) -> brinell.Case:
    """The ball with other cells and steps, pressed to the same depths."""
    depth = [row["approach"] for row in ball(resolution, steps).steps(threads=1)]
    return ball(1.5 * resolution, 2 * steps, approach=[max(depth), depth[-1]])


def unknowns() -> list[Unknown]:
    """Three of them, with bounds that are wide."""
    return [
        Unknown(YIELD, "300 MPa", "3 GPa"),
        Unknown(MODULUS, "0.5 GPa", "50 GPa", name="hardening modulus"),
        Unknown("machine.compliance", 0.0, "20 um/kN"),
    ]


def exact_curve(case: brinell.Case, points: int = 40) -> tuple[np.ndarray, np.ndarray]:
    """Depths of the instrument and loads, without noise, of loading and unloading."""
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        rows = list(case.steps(threads=1))
    depth, load = (np.array([0.0, *(row[name] for row in rows)]) for name in ("approach", "F_n"))
    top = int(np.argmax(load))
    up, down = np.linspace(0.03, 1.0, points) * depth[top], np.linspace(depth[top], depth[-1], points // 2)[1:]
    loads = np.concatenate([load_at(depth[: top + 1], load[: top + 1], up), load_at(depth[top:], load[top:], down)])
    return np.concatenate([up, down]) + FRAME * loads, loads


def deviations(load: np.ndarray, of: str) -> np.ndarray:
    """Standard deviations of the noise: a share of each value, or of the largest one."""
    return NOISE * load if of == "value" else np.full(load.size, NOISE * load.max())


def draw(job: dict[str, Any]) -> dict[str, Any]:
    """Fits one noisy curve."""
    depth, load = np.array(job["depth"]), np.array(job["load"])
    noise = deviations(load, job["noise"])
    scatter = noise * np.random.default_rng(job["seed"]).standard_normal(load.size)
    words = {"value": "1 %", "top": float(noise[0])}[job["noise"]]
    told = words if job["told"] else None
    assumed, _ = Data(depth, load + scatter, noise=words).deviations()
    data = Data(depth, load + scatter, name="ball", noise=told)
    begin = time.perf_counter()
    found = brinell.fit(
        ball(job["resolution"], job["steps"]),
        unknowns(),
        data,
        method_error=job["method"],
        workers=job["workers"],
        profiles=job["profiles"],
    )
    return {
        "seed": job["seed"],
        "seconds": time.perf_counter() - begin,
        "runs": found.runs,
        "squares_at_truth": float(np.sum((scatter / assumed) ** 2)),
        "squares": float(np.sum(((found.curves[0].fitted - data.y) / assumed) ** 2)),
        "misfit": found.misfit,
        "inflation": found.settings["variance_factor"],
        "unknowns": [
            {
                "value": one.value,
                "all": (one.low, one.high),
                "scatter": (one.data_low, one.data_high),
                "cells": one.cells,
                "method": one.method,
                "determined": one.determined,
                "by_profile": one.by_profile,
            }
            for one in found.estimates
        ],
    }


def table(draws: list[dict[str, Any]]) -> str:
    """Counts and widths of the intervals, scatter of the estimates, and the gain in squares."""
    truths = np.array(list(TRUTH.values()))
    rows = [[f"of {len(draws)}", "yield stress", "modulus", "compliance", "all three"]]
    for which, words in (("scatter", "scatter of the data alone"), ("all", "all errors")):
        ends = np.array([[one[which] for one in draw["unknowns"]] for draw in draws])
        hits = (ends[:, :, 0] <= truths) & (truths <= ends[:, :, 1])
        width = 0.5 * np.median((ends[:, :, 1] - ends[:, :, 0]) / truths, axis=0)
        rows.append([f"within: {words}", *map(str, hits.sum(axis=0)), str(hits.all(axis=1).sum())])
        rows.append([f"half width: {words}", *(f"{100 * one:.1f} %" for one in width), ""])
    off = np.array([[one["value"] for one in draw["unknowns"]] for draw in draws]) / truths - 1.0
    rows.append(["scatter of the estimates", *(f"{100 * one:.1f} %" for one in off.std(axis=0, ddof=1)), ""])
    rows.append(["mean error of the estimates", *(f"{100 * one:+.1f} %" for one in off.mean(axis=0)), ""])
    lines = ["| " + " | ".join(row) + " |" for row in rows]
    lines.insert(1, "| --- " * len(rows[0]) + "|")
    gained = np.array([draw["squares_at_truth"] - draw["squares"] for draw in draws])
    lines.append(
        f"\nsquares at the truth, less those at the estimate: mean {gained.mean():.2f}, least {gained.min():.2f}"
    )
    seconds, runs = (float(np.median([draw[name] for draw in draws])) for name in ("seconds", "runs"))
    lines.append(f"median of {runs:.0f} runs and {seconds:.0f} s per fit")
    return "\n".join(lines)


def main() -> None:
    """Draws, fits, and prints the table."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--draws", type=int, default=20)
    parser.add_argument("--first", type=int, default=0, help="seed of the first draw")
    parser.add_argument("--resolution", type=float, default=4.0)
    parser.add_argument("--steps", type=int, default=8)
    parser.add_argument(
        "--method", type=float, default=0.0, help="relative error of the method, of which these curves have none"
    )
    parser.add_argument("--finer", action="store_true", help="curves from finer cells, by imposed depths")
    parser.add_argument("--noise", choices=("value", "top"), default="value")
    parser.add_argument("--untold", action="store_true", help="the fit is not told the noise")
    parser.add_argument("--profiles", action="store_true")
    parser.add_argument("--processes", type=int, default=2)
    parser.add_argument("--json", help="file for the draws")
    given = parser.parse_args()
    depth, load = exact_curve((finer if given.finer else ball)(given.resolution, given.steps))
    jobs = [
        {
            "seed": seed,
            "depth": depth.tolist(),
            "load": load.tolist(),
            "noise": given.noise,
            "told": not given.untold,
            "resolution": given.resolution,
            "steps": given.steps,
            "method": given.method,
            "workers": 1,
            "profiles": given.profiles,
        }
        for seed in range(given.first, given.first + given.draws)
    ]
    with ProcessPoolExecutor(given.processes) as pool:
        draws = list(pool.map(draw, jobs))
    if given.json:
        with open(given.json, "w", encoding="utf-8") as file:
            json.dump(draws, file, indent=1)
    print(table(draws))


if __name__ == "__main__":
    main()
