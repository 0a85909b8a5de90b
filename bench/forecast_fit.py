# SPDX-License-Identifier: BSD-3-Clause
"""Fits the constants of the forecast to measured runs, and shows how well it holds: see bench/forecast.py."""

from __future__ import annotations

import argparse
import collections
import json
import math
import pathlib
import warnings
from typing import Any

import numpy as np
from forecast_cases import KINDS
from scipy.optimize import nnls
from texture_cases import text_of

import brinell

ROOT = pathlib.Path(__file__).resolve().parents[1]
HEADER = ROOT / "src/simulation/plan/forecast_constants.hpp"
Table = dict[str, Any]
Array = np.ndarray

CERTAINTIES = ("elastic", "yields", "deep")


def rows_of(files: list[str]) -> list[Table]:
    """Finished runs, each with what decides about its time."""
    warnings.simplefilter("ignore")
    rows = []
    for line in (line for file in files for line in pathlib.Path(file).read_text().splitlines()):
        row = json.loads(line)
        if "error" in row["check"] or "error" in row["run"]:
            continue
        case = brinell.Case(text_of(row["case"]))
        rows.append({**row, "work": case._core.workload(), "told": case._core.forecast})
    return rows


def evaluations_of(row: Table) -> float:
    """Counted ones."""
    return float(sum(row["evaluations"]))


def fitted_factors(rows: list[Table]) -> dict[str, float]:
    """Constants of the logarithm of the evaluations per step: a ridge regression that outliers do not decide."""
    ridge, scatter = 0.5, 0.3
    names = list(rows[0]["work"]["factors"])
    factors = np.array([list(row["work"]["factors"].values()) for row in rows])
    wanted = np.log([evaluations_of(row) / len(row["evaluations"]) for row in rows])
    weight = np.ones(len(rows))
    for _ in range(30):
        system = np.vstack([factors * weight[:, None], ridge * np.eye(len(names))])
        found = np.linalg.lstsq(system, np.concatenate([wanted * weight, np.zeros(len(names))]), rcond=None)[0]
        weight = 1.0 / np.sqrt(1.0 + ((factors @ found - wanted) / scatter) ** 2)
    return dict(zip(names, found.tolist(), strict=True))


def amounts_of(row: Table, evaluations: float) -> list[float]:
    """Amounts of work of a run with these evaluations."""
    of_run, of_evaluation = row["work"]["of_run"], row["work"]["of_evaluation"]
    return [of_run[name] + evaluations * of_evaluation[name] for name in of_run]


def fitted_amounts(rows: list[Table]) -> dict[str, float]:
    """Seconds for one of each amount, none below zero, with the evaluations as counted."""
    scatter = 0.4
    amounts = np.array([amounts_of(row, evaluations_of(row)) for row in rows])
    seconds = np.array([row["run"]["seconds"] for row in rows])
    weight = 1.0 / seconds
    for _ in range(30):
        found, _ = nnls(amounts * weight[:, None], seconds * weight)
        told = amounts @ found
        weight = 1.0 / np.sqrt(seconds * told) / np.sqrt(1.0 + (np.log(told / seconds) / scatter) ** 2)
    return dict(zip(rows[0]["work"]["of_run"], found.tolist(), strict=True))


def told(row: Table, factors: dict[str, float], amounts: dict[str, float]) -> tuple[float, float]:
    """Evaluations and seconds by these constants, as in src/simulation/forecast.cpp."""
    work = row["work"]
    exponent = sum(factors[name] * value for name, value in work["factors"].items())
    evaluations = work["steps"] * max(1.0, math.exp(exponent))
    seconds = sum(c * a for c, a in zip(amounts.values(), amounts_of(row, evaluations), strict=True))
    return evaluations, seconds


def spread_of(rows: list[Table], ratios: Array) -> list[float]:
    """Factor that 95 of 100 ratios stay within, by how well the time can be foretold; at least 1.5."""
    spreads = []
    for certainty in range(len(CERTAINTIES)):
        mine = np.abs(np.log(ratios[[row["work"]["certainty"] == certainty for row in rows]]))
        spreads.append(max(1.5, math.exp(float(np.quantile(mine, 0.95)))) if len(mine) else 2.0)
    return [math.ceil(10 * spread) / 10 for spread in spreads]


def header_text(factors: dict[str, float], amounts: dict[str, float], spread: list[float]) -> str:
    """The source of the constants."""

    def table(values: dict[str, float]) -> str:
        return ",\n".join(f'    {{"{name}", {value:.4g}}}' for name, value in values.items())

    spreads = ", ".join(f"{value:.1f}" for value in spread)
    return f"""// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/simulation/forecast.hpp"

#include <array>

/// Written by bench/forecast.py fit; do not edit.
namespace brinell::simulation::measured
{{

/// Logarithm of the evaluations per step for one of each factor.
inline constexpr std::array<Factor, {len(factors)}> of_factors{{{{
{table(factors)},
}}}};

/// Seconds for one of each amount.
inline constexpr std::array<Factor, {len(amounts)}> of_amounts{{{{
{table(amounts)},
}}}};

/// Factor within which 95 of 100 times are, by `Certainty`.
inline constexpr std::array<double, 3> spread{{{spreads}}};

}} // namespace brinell::simulation::measured
"""


def fit(options: argparse.Namespace) -> None:
    """Writes the constants, and prints how well they hold for cases that they were not fitted to."""
    rows = rows_of(options.files)
    halves = [[row for row in rows if row["number"] // len(KINDS) % 2 == half] for half in (0, 1)]
    checked: list[Table] = []
    ratios: list[float] = []
    for fitted, others in (halves, halves[::-1]):
        factors, amounts = fitted_factors(fitted), fitted_amounts(fitted)
        for row in others:
            checked.append(row)
            ratios.append(told(row, factors, amounts)[1] / row["run"]["seconds"])
    spread = spread_of(checked, np.array(ratios))
    print(f"each half by the other: {shares(np.array(ratios), 2.0)} within a factor of 2")
    HEADER.write_text(header_text(fitted_factors(rows), fitted_amounts(rows), spread))
    print(f"{HEADER.relative_to(ROOT)}: written from {len(rows)} runs; spread {spread}")


def shares(ratios: Array, factor: float) -> str:
    """Share of the ratios within a factor, as text."""
    return f"{100 * np.mean(np.abs(np.log(ratios)) < math.log(factor)):.0f} %"


def show(options: argparse.Namespace) -> None:
    """Prints by kind how well what the program tells holds."""
    rows = rows_of(options.files)
    kinds: dict[str, list[Table]] = collections.defaultdict(list)
    for row in rows:
        kinds[row["kind"]].append(row)
    heads = ("kind", "runs", "processor time", "within a factor of 2", "in the range told", "evaluations", "memory")
    print(f"| {' | '.join(heads)} |")
    print("| --- | --- | --- | --- | --- | --- | --- |")
    for kind, mine in [*sorted(kinds.items()), ("all", rows)]:
        seconds = np.array([row["run"]["seconds"] for row in mine])
        time = np.array([row["told"].seconds for row in mine]) / seconds
        within = np.mean([row["told"].shortest <= row["run"]["seconds"] <= row["told"].longest for row in mine])
        evaluations = np.array([row["told"].evaluations / evaluations_of(row) for row in mine])
        memory = np.array([row["told"].memory / row["run"]["memory"] for row in mine])
        print(
            f"| {kind} | {len(mine)} | {seconds.min():.2g} to {seconds.max():.2g} s | {shares(time, 2)} | "
            f"{100 * within:.0f} % | {shares(evaluations, 2)} | {100 * np.mean(np.abs(memory - 1) < 0.2):.0f} % |"
        )
    worst = sorted(rows, key=lambda row: -abs(math.log(row["told"].seconds / row["run"]["seconds"])))
    for row in worst[: options.worst]:
        ratio = row["told"].seconds / row["run"]["seconds"]
        print(f"  {row['number']} {row['kind']}: {ratio:.2f} of {row['run']['seconds']:.2f} s")
