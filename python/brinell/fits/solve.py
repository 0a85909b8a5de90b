# SPDX-License-Identifier: BSD-3-Clause
"""The search: points between the bounds and a first solution with coarse cells, then the cells of the case."""

from __future__ import annotations

import contextlib
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any, Literal, TypeAlias

import numpy as np
from scipy.optimize import least_squares
from scipy.stats import qmc

from brinell.errors import BrinellError, ConvergenceError, InputError
from brinell.fits.checks import checked_against
from brinell.fits.data import FloatArray
from brinell.fits.model import Observed, history_of
from brinell.fits.problem import LEAST_NOISE, Problem

__all__ = ["LOSSES", "Loss", "Solution", "robust_squares", "robust_weights", "searched", "solved"]

Loss: TypeAlias = Literal["linear", "soft_l1", "huber", "cauchy"]
LOSSES = ("linear", "soft_l1", "huber", "cauchy")

_SCALE = 1.5
"""Residual, in standard deviations, beyond which a robust loss counts less."""
_COARSE_CELLS = 4.5
"""Cells per contact radius of the first search."""
_LEAST_COARSENING = 1.5
"""Factor between the cells from which the coarse ones are worth a search of their own."""
_COARSER = 1.4
"""Factor on the cells of the case by which their error is estimated, which falls with the square of their size."""
_FIRST_ERROR = 0.01
"""Error of the cells in the first search, as a part of the largest value: light loads rest on few of them."""
_DEAREST = 4.0
"""Foretold time over the median of all points beyond which a point is not tried: a body that is far too soft."""
_DEEPEST = 3.0
"""Approach over the largest measured depth beyond which a run is given up."""
_MOST_SEARCHES, _SAME_SIGMA = 4, 0.05
"""Searches with the cells of the case, which end when the weights of the points change by less."""
_NO_NOISE = 0.1
"""Misfit, in standard deviations, below which data have no noise and the search goes on to the digits of the runs."""
_MOST_STEPS = 15
_NOWHERE = 1e3
"""Residual of all points where a run fails, in standard deviations: the step is refused, and a shorter one tried."""
_INSENSITIVE = 0.25
"""Standard deviation with all else known, as a part of the bounds' distance, from which an unknown does not matter."""

_LEAST_STEP = 2e-4
"""Least step of u for a difference."""

_SHORTER = (0.5, 0.2, 0.1)
"""Factors on the steps for differences in the last searches, which end where they gain nothing."""
_GAIN = 0.05
"""Gain in squares below which a search has gained nothing: a distance of 0.2 standard deviations."""
_ENOUGH = 0.5
"""Misfit, in standard deviations, at which the first search ends: its cells are no better."""


class _Enough(Exception):  # noqa: N818 (no error)
    """Raised within a search that is near enough."""

    def __init__(self, u: FloatArray):
        self.u = u


Progress: TypeAlias = Callable[[str], None]


@dataclass(frozen=True, eq=False)
class Solution:
    """Where the search ended.

    Attributes:
        u: variables of the unknowns.
        curve: values at the data.
        jacobian: their derivatives by u.
        insensitive: indices of unknowns on which the data do not depend; they stayed where they were.
        converged: whether the search ended because nothing changed any more.
        notes: what is to be told.
    """

    u: FloatArray
    curve: FloatArray
    jacobian: FloatArray
    insensitive: list[int]
    converged: bool
    notes: list[str]


def solved(problem: Problem, loss: Loss, progress: Progress) -> Solution:
    """Solves the problem: coarse cells first, those of the case last.

    Raises:
        InputError: the data do not fit the case, in size or in branches.
        BrinellError: no run could be computed.
    """
    own = [dict(cells) for cells in problem.cells]
    problem.cells = [_coarse_plan(one.table) for one in problem.experiments]
    u, notes = _start(problem, np.array([one.first for one in problem.parameters]), progress)
    problem.of_cells = _FIRST_ERROR * problem.least / LEAST_NOISE
    problem.set_sigma(u)
    u, _ = _search(problem, u, range(u.size), loss, progress, "first search", 1e-2, _ENOUGH)
    problem.cells = own
    return searched(problem, u, loss, progress, notes)


def searched(problem: Problem, u: FloatArray, loss: Loss, progress: Progress, notes: list[str]) -> Solution:
    """Searches with the cells of the case, from a point that is near.

    Raises:
        BrinellError: no run could be computed.
    """
    curve = problem.curve(u)
    _learn_noise(problem, curve)
    with contextlib.suppress(BrinellError):  # cells that a period does not allow: the first error stays
        problem.of_cells = _smooth(curve - problem.curve_with(u, _COARSER)) / (_COARSER**2 - 1.0)
    problem.set_sigma(u)
    free = _sensitive(problem, u)
    for _ in range(_MOST_SEARCHES):
        problem.steps = _steps(problem, u, free)
        u, converged = _search(problem, u, free, loss, progress, "cells of the case")
        sigma = problem.sigma
        _learn_noise(problem, problem.curve(u))
        problem.set_sigma(u)
        if np.abs(problem.sigma / sigma - 1.0).max() < _SAME_SIGMA:
            break
    if np.linalg.norm(problem.residuals(problem.curve(u), u)) < _NO_NOISE * np.sqrt(problem.y.size):
        u, converged = _search(problem, u, free, loss, progress, "to the digits of the runs", 1e-6)
        _learn_noise(problem, problem.curve(u))
        problem.set_sigma(u)
    u, converged = _polished(problem, u, free, loss, progress, converged)
    jacobian = problem.jacobian(u, range(u.size))
    insensitive = [j for j in range(u.size) if j not in free]
    return Solution(u, problem.curve(u), jacobian, insensitive, converged, notes)


def _polished(
    problem: Problem, u: FloatArray, free: list[int], loss: Loss, progress: Progress, converged: bool
) -> tuple[FloatArray, bool]:
    """Searches again with shorter steps for differences, until that gains nothing.

    Along a curved valley the slopes of wide steps are not those at the estimate, and a search ends beside the minimum.
    """
    squares = robust_squares(problem.residuals(problem.curve(u), u), loss)
    problem.steps = widest = _steps(problem, u, free)
    for factor in _SHORTER:
        problem.steps = factor * widest
        other, ended = _search(problem, u, free, loss, progress, "shorter steps")
        before, now = squares, robust_squares(problem.residuals(problem.curve(other), other), loss)
        if now < squares:
            u, squares, converged = other, now, ended
        if now > before - _GAIN:
            break
    problem.steps = widest
    return u, converged


def _start(problem: Problem, u: FloatArray, progress: Progress) -> tuple[FloatArray, list[str]]:
    """The best of some points between the bounds, and what the sizes of data and runs tell."""
    count = 2 * u.size if any(one.unknown.start is None for one in problem.parameters) else 0
    spread = qmc.Sobol(u.size, seed=0).random(max(4, 1 << (count - 1).bit_length())) if count else np.empty((0, u.size))
    for j, one in enumerate(problem.parameters):
        if one.unknown.start is not None:
            spread[:, j] = u[j]
    points = [u, *(0.05 + 0.9 * spread)]
    costs_of_runs = [problem.forecast(one) for one in points]
    most = _DEAREST * float(np.median(costs_of_runs))
    points = [u, *(one for one, cost in zip(points[1:], costs_of_runs[1:], strict=True) if cost <= most)]
    progress(f"{len(points)} points between the bounds")
    problem.enter("points between the bounds")
    outcomes = problem.observed(points[:1])
    problem.limit_depths(_DEEPEST)
    outcomes += problem.observed(points[1:])
    good = [i for i, row in enumerate(outcomes) if all(isinstance(one, Observed) for one in row)]
    if not good:
        raise next(one for row in outcomes for one in row if isinstance(one, BrinellError))
    notes = _checked_sizes(problem, [outcomes[i] for i in good])
    costs = {}
    for i, found in zip(good, problem.curves([points[i] for i in good]), strict=True):
        if not isinstance(found, BrinellError):
            residuals = problem.residuals(found, points[i])
            costs[i] = float(np.sum(np.arcsinh(residuals) ** 2))  # far away only the order matters
            problem.follow("points between the bounds", points[i], found)
    return points[min(costs, key=lambda i: costs[i])], notes


def _checked_sizes(problem: Problem, rows: Sequence[Sequence[Any]]) -> list[str]:
    notes = []
    for k, experiment in enumerate(problem.experiments):
        for i in experiment.members:
            one = problem.data[i]
            if one.kind == "load-depth":
                histories = [history_of(one, row[k]) for row in rows]
                depths = [float(approach.max()) for approach, _ in histories]
                notes += checked_against(one, histories[0][1], depths, rows[0][k].is_load_driven)
    return notes


def _search(
    problem: Problem,
    u: FloatArray,
    free: Sequence[int],
    loss: Loss,
    progress: Progress,
    what: str,
    least: float = 1e-3,
    enough: float = 0.0,
) -> tuple[FloatArray, bool]:
    """Trust region search (Branch, Coleman, Li 1999) over the free unknowns, to a relative change of the cost."""
    if not free:
        return u, True
    index = list(free)

    def whole(part: FloatArray) -> FloatArray:
        result = u.copy()
        result[index] = part
        return result

    def residuals(part: FloatArray) -> FloatArray:
        point = whole(part)
        (found,) = problem.curves([point])
        if isinstance(found, InputError) and not problem.runs:
            raise found
        if isinstance(found, BrinellError):
            return np.full(problem.residuals(problem.y, point).size, _NOWHERE)
        result = problem.residuals(found, point)
        misfit = problem.follow(what, point, found)
        progress(f"{what}: {problem.runs} runs, misfit {misfit:.3g} standard deviations")
        if misfit < enough:
            raise _Enough(point)
        return result

    def jacobian(part: FloatArray) -> FloatArray:
        point = whole(part)
        rows = problem.jacobian(point, index) / problem.sigma[:, None]
        return np.asarray(np.vstack([rows, problem.prior_jacobian(point)])[:, index])

    start = np.clip(u[index], 1e-3, 1.0 - 1e-3)
    try:
        found = _least_squares(residuals, start, jacobian, loss, least)
    except _Enough as done:
        return done.u, True
    if not np.isfinite(found.cost) or np.all(found.fun == _NOWHERE):
        raise ConvergenceError(f"{what}: no run near the start could be computed")
    return whole(found.x), bool(found.status > 0)


def _least_squares(residuals: Any, start: FloatArray, jacobian: Any, loss: Loss, least: float) -> Any:
    return least_squares(
        residuals,
        start,
        jac=jacobian,
        bounds=(0.0, 1.0),
        loss=loss,
        f_scale=_SCALE,
        x_scale=1.0,
        xtol=0.01 * least,
        ftol=least,
        gtol=1e-10,
        max_nfev=_MOST_STEPS,
    )


def _coarse_plan(table: Mapping[str, Any]) -> dict[str, Any]:
    """Keys for the coarse cells of the first search; empty if those of the case are as coarse."""
    cells = table["grid"].get("resolution", 0.0)
    return {"grid.resolution": _COARSE_CELLS} if cells >= _LEAST_COARSENING * _COARSE_CELLS else {}


def _smooth(difference: FloatArray) -> FloatArray:
    """Root mean squares over nine neighbours."""
    padded = np.pad(difference**2, 4, mode="reflect") if difference.size > 8 else np.pad(difference**2, 4, mode="mean")
    return np.asarray(np.sqrt(np.convolve(padded, np.full(9, 1.0 / 9.0), mode="valid")))


def _learn_noise(problem: Problem, curve: FloatArray) -> None:
    """Takes the scatter of the residuals as noise where the user gives none."""
    for part, known in zip(problem.parts, problem.has_noise, strict=True):
        if not known:
            residual = curve[part] - problem.y[part]
            scatter = 1.4826 * float(np.median(np.abs(residual)))
            problem.noise[part] = np.maximum(scatter, problem.least[part])


def _sensitive(problem: Problem, u: FloatArray) -> list[int]:
    """Unknowns that the data depend on, with all others known."""
    problem.set_sigma(u)
    rows = problem.jacobian(u, range(u.size)) / problem.sigma[:, None]
    rows = np.vstack([rows, problem.prior_jacobian(u)])
    return [j for j in range(u.size) if _INSENSITIVE * float(np.linalg.norm(rows[:, j])) > 1.0]


def _steps(problem: Problem, u: FloatArray, free: Sequence[int]) -> FloatArray:
    """Steps for differences: a standard deviation of each unknown.

    Over that distance a curve has to be described by its slope. A smaller step shows cells that come into contact one
    after the other; with this one, errors of values of about a standard deviation stay that small over the interval.
    """
    usual = np.array([one.step for one in problem.parameters])
    rows = problem.jacobian(u, range(u.size)) / problem.sigma[:, None]
    rows = np.vstack([rows, problem.prior_jacobian(u)])[:, list(free)]
    result = usual.copy()
    result[list(free)] = np.sqrt(np.diag(np.linalg.pinv(rows.T @ rows, rcond=1e-12)))
    return np.asarray(np.clip(result, _LEAST_STEP, usual))


def robust_weights(residuals: FloatArray, loss: Loss) -> FloatArray:
    """Weights of the squares with which a robust loss has the same gradient."""
    z = (residuals / _SCALE) ** 2
    if loss == "soft_l1":
        return np.asarray(1.0 / np.sqrt(1.0 + z))
    if loss == "huber":
        return np.asarray(np.where(z <= 1.0, 1.0, 1.0 / np.sqrt(np.maximum(z, 1.0))))
    return np.asarray(1.0 / (1.0 + z)) if loss == "cauchy" else np.ones(residuals.size)


def robust_squares(residuals: FloatArray, loss: Loss) -> float:
    """Twice the cost that the search minimises: squares, which count less far away."""
    z = (residuals / _SCALE) ** 2
    if loss == "soft_l1":
        z = 2.0 * (np.sqrt(1.0 + z) - 1.0)
    elif loss == "huber":
        z = np.where(z <= 1.0, z, 2.0 * np.sqrt(z) - 1.0)
    elif loss == "cauchy":
        z = np.log1p(z)
    return float(_SCALE**2 * np.sum(z))
