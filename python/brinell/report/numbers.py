# SPDX-License-Identifier: BSD-3-Clause
"""Key results of each scenario, energies, and cost of a run, as text."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from brinell.plot.energy import balance_error, sinks_of
from brinell.report import text
from brinell.results import History, Run
from brinell.scenarios import SCENARIOS
from brinell.scenarios.traits import KeyNumber

__all__ = ["Interval", "Number", "accuracies_of", "cost_of", "energies_of", "key_numbers"]


@dataclass(frozen=True)
class Number:
    """A result."""

    name: str
    value: str
    """With its unit."""
    normalised: str = ""
    """Over its value at first yield, if there is one: "7.32 P_c"."""


_SYMBOLS = {"load": "P_c", "interference": "α_c", "energy": "U_c", "peak_pressure": "p0_c"}
"""Of the values at first yield."""


def _shown(run: Run, one: KeyNumber) -> Number:
    """A value as text, normalised by its value at first yield if there is one."""
    if isinstance(one.value, int):
        return Number(one.name, str(one.value))
    if one.unit == "%":
        return Number(one.name, text.percent(one.value, one.digits))
    size = getattr(run.critical, one.over) if one.over and run.complete and run.has_critical_values else None
    over = f"{text.number(one.value / size)} {_SYMBOLS[one.over]}" if one.over and size else ""
    return Number(one.name, text.quantity(one.value, one.unit, one.digits), over)


def key_numbers(run: Run) -> list[Number]:
    """The most important results, those of the scenario first; also for an unfinished run."""
    found = [*SCENARIOS[run.scenario].key_numbers(run), *_of_all_scenarios(run.history)]
    return [_shown(run, one) for one in found]


def _of_all_scenarios(history: History) -> Iterator[KeyNumber]:
    yield KeyNumber("Largest pressure", float(history["max_pressure"].max()), "Pa", "peak_pressure")
    yield KeyNumber("Largest equivalent plastic strain", float(history["max_equivalent_plastic_strain"].max()), "%")
    for body in ("lower", "upper"):
        residual = history[f"max_residual_{body}"]
        if residual.any():
            yield KeyNumber(f"Residual depth, {body} body", float(residual[-1]), "m", "interference")
    yield KeyNumber("Energy unaccounted for, at the end", float(balance_error(history)[-1]), "%", digits=2)


def energies_of(run: Run) -> list[Number]:
    """Energies to which the work of the drive was converted by the end of the run, and the error of the balance."""
    last = {name: float(column[-1]) for name, column in run.history.items()}
    missing = last["work"] - sum(last[sink.column] for sink in sinks_of(run.history))
    values = [
        ("work of the drive", last["work"]),
        *((sink.name, last[sink.column]) for sink in sinks_of(run.history)),
        ("unaccounted for", missing),
    ]
    return [_shown(run, KeyNumber(name, value, "J", "energy")) for name, value in values]


def cost_of(run: Run) -> list[Number]:
    """Steps, evaluations and, if the summary has them, cells and time."""
    summary = run.summary or {}
    grid, cost = summary.get("grid", {}), summary.get("run", {})
    found = [
        Number("steps", str(run.history.steps)),
        Number("evaluations", str(int(np.sum(run.history["evaluations"])))),
    ]
    if "wall_time_s" in cost:
        threads = cost.get("threads")
        found.append(Number("time", f"{text.number(cost['wall_time_s'])} s on {threads} threads"))
    if "spacing_m" in grid:
        found.append(Number("cells dx, dy, dz", ", ".join(text.quantity(float(d), "m") for d in grid["spacing_m"])))
    for name in ("contact", "lower", "upper"):
        if grid.get(f"{name}_cells"):
            found.append(Number(f"grid, {name}", " × ".join(str(int(n)) for n in grid[f"{name}_cells"])))
    if grid.get("surfaces_only"):
        found.append(Number("fields within the bodies", "not computed: neither can yield; output.fields asks for them"))
    return found


@dataclass(frozen=True)
class Interval:
    """A result with its interval."""

    name: str
    value: str
    error: str
    order: str
    extrapolated: str
    low: str
    high: str


_UNITS = (("_N_per_m", "N/m"), ("_m2", "m²"), ("_Pa", "Pa"), ("_N", "N"), ("_J", "J"), ("_m", "m"))


def accuracies_of(run: Run) -> list[Interval]:
    """Key numbers with their intervals, for a run with `solver.accuracy`."""
    accuracies = run.accuracy
    keys = (run.summary or {}).get("accuracy", {}).get("key_numbers", [])
    found = []
    for name in keys:
        if name not in accuracies:
            continue
        one = accuracies[name]
        unit = next((unit for ending, unit in _UNITS if name.endswith(ending)), "")
        shown = [
            "–" if value is None else text.quantity(value, unit, 4)
            for value in (one.value, one.extrapolated, one.low, one.high)
        ]
        order = "–" if one.order is None else text.number(one.order, 2)
        is_lost = one.low < 0.0 < one.high and one.relative_error > (run.summary or {})["accuracy"]["asked"]
        error = "> 100 %" if is_lost else text.percent(one.relative_error)
        found.append(Interval(name, shown[0], error, order, *shown[1:]))
    return found
