# SPDX-License-Identifier: BSD-3-Clause
"""A run as data see it: columns of the history, imprint, numbers of the summary; and curves between its steps."""

from __future__ import annotations

import itertools
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np
from scipy.interpolate import Akima1DInterpolator

from brinell.case import Case
from brinell.errors import ConvergenceError, InputError
from brinell.fits.checks import turning_points
from brinell.fits.data import Data, FloatArray

__all__ = ["Observed", "Wanted", "history_of", "load_at", "observe", "predicted"]

_POWER = 2.0 / 3.0
"""The depth of a ball is nearly linear in the load to this power, loading and unloading (Hertz)."""

_PARTS = 16
"""Parts of a step in which the compliance of the frame is added."""

_MOST_EVALUATIONS, _GRACE = 60, 4
"""Evaluations per step beyond which a run is given up, as those of very soft bodies; a usual run needs ten."""


@dataclass(frozen=True)
class Wanted:
    """What the data need of a run."""

    columns: tuple[str, ...]
    imprint: bool
    deepest: float = float("inf")
    """Approach [m] beyond which a run is of no use: far from the data, and slow."""


@dataclass(frozen=True, eq=False)
class Observed:
    """What a run gives; it can be sent from process to process."""

    columns: dict[str, FloatArray]
    summary: dict[str, Any]
    imprint: tuple[FloatArray, FloatArray] | None
    is_load_driven: bool

    @property
    def spacing(self) -> tuple[float, float, float]:
        """Sizes of the cells [m]."""
        x, y, z = self.summary["grid"]["spacing_m"]
        return float(x), float(y), float(z)

    @property
    def cells_per_radius(self) -> float | None:
        """Cells per radius of the contact; None if the run does not tell."""
        found = self.summary.get("resolution", {}).get("cells_per_contact_radius")
        return None if found is None else float(found)


def observe(case: Case, wanted: Wanted, threads: int) -> Observed:
    """Computes a case, writes nothing, and may be called in several threads at once.

    Raises:
        BrinellError: the run cannot be computed.
    """
    run = case.steps(threads=threads)
    rows, evaluations = [], 0.0
    for row in run:
        rows.append(row)
        evaluations += row["evaluations"]
        if row.get("approach", 0.0) > wanted.deepest and case.scenario == "indentation":
            raise ConvergenceError(f"the approach exceeds {wanted.deepest:.3g} m")
        if evaluations > _MOST_EVALUATIONS * (len(rows) + _GRACE):
            raise ConvergenceError(f"{evaluations:.0f} evaluations in {len(rows)} steps: the run is given up")
    names = {"pass", "place", *wanted.columns} & rows[0].keys()
    if missing := [name for name in wanted.columns if name not in rows[0]]:
        raise InputError(f"the history has no column {missing[0]!r}; allowed: {', '.join(rows[0])}")
    columns = {name: np.array([row[name] for row in rows], dtype=np.float64) for name in names}
    summary = run.summary()
    imprint = _imprint(run.fields()) if wanted.imprint else None
    return Observed(columns, summary, imprint, "load" in summary["case"].get("indentation", {}))


def _imprint(fields: Mapping[str, Any]) -> tuple[FloatArray, FloatArray]:
    """Places along x, and heights of the residual surface of the lower body on the row, or both rows, at y = 0."""
    body = fields["lower"]
    if "residual_displacement" not in body:
        raise InputError("the lower body is rigid: it has no imprint")
    y = np.abs(body["y"])
    rows = np.flatnonzero(y <= y.min() * (1.0 + 1e-9) + 1e-15)
    return np.asarray(body["x"]), -np.asarray(body["residual_displacement"])[rows].mean(axis=0)


def history_of(data: Data, observed: Observed) -> tuple[FloatArray, FloatArray]:
    """Approach [m] and load [N] of an indentation at the place of the data, from the first touch on."""
    here = observed.columns["place"] == data.place
    if not here.any():
        raise data.error(f"place = {data.place}; allowed: 1 to {int(observed.columns['place'].max())}")
    approach, load = observed.columns["approach"][here], observed.columns["F_n"][here]
    return np.concatenate([[0.0], approach]), np.concatenate([[0.0], load])


def predicted(data: Data, branch: FloatArray | None, observed: Observed, machine: Mapping[str, float]) -> FloatArray:
    """Values of y of a run at the places x of the data.

    Args:
        data: where to look.
        branch: of a load-depth curve the branch of each point.
        observed: the run.
        machine: values of the keys of the machine.

    Raises:
        InputError: the run has nothing there.
    """
    if data.kind == "number":
        return np.array([_summary_number(data, observed)])
    if data.kind == "imprint":
        assert observed.imprint is not None
        return _between(*observed.imprint, data.x)
    if data.kind == "history":
        return _history(data, observed)
    assert branch is not None
    approach, load = history_of(data, observed)
    compliance = machine.get("machine.compliance", 0.0)
    x = data.x if data.time is None else data.x - machine.get("machine.drift", 0.0) * (data.time - data.time[0])
    turns = turning_points(load if observed.is_load_driven else approach, 0.0)
    x = x - machine.get("machine.first_touch", 0.0)
    result = np.empty(x.size)
    for i, (first, last) in enumerate(itertools.pairwise(turns)):
        here = branch == i
        if here.any():
            depth, force = approach[first : last + 1], load[first : last + 1]
            if compliance:
                depth, force = _on_frame(depth, force, compliance)
            result[here] = load_at(depth, force, x[here])
    return result


def _on_frame(approach: FloatArray, load: FloatArray, compliance: float) -> tuple[FloatArray, FloatArray]:
    """Depth that an instrument shows, and load, at more places: between its steps the run knows no frame."""
    places = np.interp(
        np.linspace(0.0, approach.size - 1.0, _PARTS * (approach.size - 1) + 1), np.arange(approach.size), approach
    )
    between = load_at(approach, load, places)
    return places + compliance * between, between


def load_at(depth: FloatArray, load: FloatArray, x: FloatArray) -> FloatArray:
    """Load at depths, between the steps of one branch: interpolated as load^(2/3), which is nearly linear."""
    rising = depth[-1] >= depth[0]
    h, q = (depth, load**_POWER) if rising else (depth[::-1], load[::-1] ** _POWER)
    found = _between(h, q, x)
    return np.asarray(np.maximum(found, 0.0) ** (1.0 / _POWER))


def _between(x: FloatArray, y: FloatArray, at: FloatArray) -> FloatArray:
    """Values between points, by pieces of third degree (Akima 1970), and on the last line beyond them."""
    order = np.argsort(x, kind="stable")
    x, y = x[order], y[order]
    apart = np.concatenate([[True], np.diff(x) > 1e-9 * max(np.ptp(x), 1e-300)])
    x, y = x[apart], y[apart]
    if x.size < 2:
        return np.full(at.size, y[0])
    inside = np.clip(at, x[0], x[-1])
    values = np.interp(inside, x, y) if x.size < 4 else Akima1DInterpolator(x, y)(inside)
    low, high = (y[1] - y[0]) / (x[1] - x[0]), (y[-1] - y[-2]) / (x[-1] - x[-2])
    return np.asarray(
        values + np.where(at < x[0], low * (at - x[0]), 0.0) + np.where(at > x[-1], high * (at - x[-1]), 0.0)
    )


def _history(data: Data, observed: Observed) -> FloatArray:
    x, y = (observed.columns[name] for name in data.columns)
    if data.passed is not None:
        here = observed.columns["pass"] == data.passed
        if not here.any():
            raise data.error(f"pass = {data.passed}; allowed: 1 to {int(observed.columns['pass'].max())}")
        x, y = x[here], y[here]
    steps = np.diff(x)
    if not (np.all(steps >= 0.0) or np.all(steps <= 0.0)):
        raise data.error(
            f"{data.columns[0]} goes to and fro in the run; allowed: a column that only rises, or one pass"
        )
    if not (x.min() - 0.1 * np.ptp(x) <= data.x.min() and data.x.max() <= x.max() + 0.1 * np.ptp(x)):
        raise data.error(
            f"{data.columns[0]} from {data.x.min():.4g} to {data.x.max():.4g}, in the run from {x.min():.4g} to "
            f"{x.max():.4g} {data.units[0]}; allowed: points within the run (is the unit right?)"
        )
    return _between(x, y, data.x)


def _summary_number(data: Data, observed: Observed) -> float:
    entry: Any = observed.summary
    for word in data.columns[0].split("."):
        if isinstance(entry, list) and word.isdigit() and int(word) < len(entry):
            entry = entry[int(word)]
        elif isinstance(entry, Mapping) and word in entry:
            entry = entry[word]
        else:
            entry = None
    if isinstance(entry, bool) or not isinstance(entry, int | float):
        raise data.error(f"the summary has no number {data.columns[0]!r}; allowed: keys of summary.json")
    return float(entry)
