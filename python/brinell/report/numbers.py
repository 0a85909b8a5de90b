# SPDX-License-Identifier: BSD-3-Clause
"""What one looks for first: key results of each scenario, the energies, and what the run has cost."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from brinell.plot.energy import balance_error, sinks_of
from brinell.report import text
from brinell.results import Run

__all__ = ["Interval", "Number", "accuracies_of", "cost_of", "energies_of", "key_numbers"]


@dataclass(frozen=True)
class Number:
    """A result."""

    name: str
    value: str
    """With its unit."""
    normalised: str = ""
    """Over its value at first yield, if there is one: "7.32 P_c"."""


def _critical(run: Run, name: str) -> float | None:
    """A value at first yield, where it exists."""
    return float(getattr(run.critical, name)) if run.complete and run.has_critical_values else None


def _number(run: Run, name: str, value: float, unit: str, scale: str, symbol: str) -> Number:
    size = _critical(run, scale)
    over = f"{text.number(value / size)} {symbol}" if size else ""
    return Number(name, text.quantity(value, unit), over)


def _force(run: Run, name: str, value: float) -> Number:
    return _number(run, name, value, "N", "load", "P_c")


def _depth(run: Run, name: str, value: float) -> Number:
    return _number(run, name, value, "m", "interference", "α_c")


def key_numbers(run: Run) -> list[Number]:
    """The results that tell most, those of the scenario first; also of a run that has not finished."""
    of_scenario = {"tugging": _of_tugging, "indentation": _of_indentation, "rolling": _of_rolling}[run.scenario]
    history = run.history
    strain = float(history["max_equivalent_plastic_strain"].max())
    return [
        *of_scenario(run),
        _number(run, "Largest pressure", float(history["max_pressure"].max()), "Pa", "peak_pressure", "p0_c"),
        Number("Largest equivalent plastic strain", text.percent(strain, 3)),
        *(
            _depth(run, f"Residual depth, {body} body", float(history[f"max_residual_{body}"][-1]))
            for body in ("lower", "upper")
            if history[f"max_residual_{body}"].any()
        ),
        Number("Energy unaccounted for, at the end", text.percent(float(balance_error(history)[-1]))),
    ]


def _of_tugging(run: Run) -> Iterator[Number]:
    history = run.history
    if run.complete and run.case("tugging", "load") is None:
        yield _depth(run, "Interference", run.interference)
    yield _force(run, "Largest resistance F_X", float(history["F_X"].max()))
    yield _force(run, "Smallest F_X", float(history["F_X"].min()))
    yield _force(run, "Largest normal force F_Z", float(history["F_Z"].max()))
    yield _number(run, "Net work", float(history["work"][-1]), "J", "energy", "U_c")


def _of_indentation(run: Run) -> Iterator[Number]:
    history = run.history
    yield _force(run, "Largest load", float(history["F_n"].max()))
    yield _depth(run, "Largest approach", float(history["approach"].max()))
    if run.complete:
        first = run.indents[0]
        yield Number("Hardness, first indent", text.quantity(first.hardness, "Pa"))
        if first.unloading_stiffness:
            yield Number("Unloading stiffness, first indent", text.quantity(first.unloading_stiffness, "N/m"))
        yield _depth(run, "Pile-up, first indent", first.pile_up)


def _of_rolling(run: Run) -> Iterator[Number]:
    yield _force(run, "Largest load", float(run.history["F_n"].max()))
    if run.complete:
        last = run.passes[-1]
        yield Number("Passes", str(len(run.passes)))
        yield _depth(run, "Rut depth after the last pass", last.rut_depth)
        yield _depth(run, "Height of its shoulders", last.shoulder_height)
        steady = "" if last.steady else ", not steady"
        yield _force(run, f"Resistance, last pass{steady}", last.resistance)
        yield Number("Growth of strain in the last pass", text.percent(last.track_plastic_increment, 3))
        if run.case("rolling", "slide_to_roll") and not math.isnan(last.friction):
            yield Number("Friction F_X / F_n, last pass", text.number(last.friction))
            yield Number("Area of contact, last pass", text.quantity(last.contact_area, "m²"))


def energies_of(run: Run) -> list[Number]:
    """What the work of the drive has turned into at the end, and what is missing."""
    last = {name: float(column[-1]) for name, column in run.history.items()}
    missing = last["work"] - sum(last[sink.column] for sink in sinks_of(run.history))
    values = [
        ("work of the drive", last["work"]),
        *((sink.name, last[sink.column]) for sink in sinks_of(run.history)),
        ("unaccounted for", missing),
    ]
    return [_number(run, name, value, "J", "energy", "U_c") for name, value in values]


def cost_of(run: Run) -> list[Number]:
    """Steps, evaluations, and from the summary, as far as it has them, cells and time."""
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
    return found


@dataclass(frozen=True)
class Interval:
    """A result and how well it is known."""

    name: str
    value: str
    error: str
    order: str
    extrapolated: str
    low: str
    high: str


_UNITS = (("_N_per_m", "N/m"), ("_m2", "m²"), ("_Pa", "Pa"), ("_N", "N"), ("_J", "J"), ("_m", "m"))


def accuracies_of(run: Run) -> list[Interval]:
    """Of a run for which an accuracy was asked: its key numbers, with their intervals."""
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
        found.append(Interval(name, shown[0], text.percent(one.relative_error), order, *shown[1:]))
    return found
