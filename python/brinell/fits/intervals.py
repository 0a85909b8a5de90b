# SPDX-License-Identifier: BSD-3-Clause
"""How well the data determine the unknowns: covariance, profiles, correlation, error of cells and of the method."""

from __future__ import annotations

import warnings
from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
from scipy.stats import norm
from scipy.stats import t as student

from brinell.errors import BrinellError
from brinell.fits.data import FloatArray
from brinell.fits.problem import Problem
from brinell.fits.solve import Loss, Solution, robust_squares, robust_weights

__all__ = ["Judged", "cells_error", "is_determined", "judged", "profiled", "separable"]

_FINER = 1.5
"""Refinement by which the error of the cells is found."""
_LENGTH = 0.3
"""Distance, in parts of a branch, over which the error of the method changes."""
_NODES = 21
_MISLED = 0.25
"""Relative difference of the distance in standard deviations, by runs and by the covariance, above which the covariance
misleads."""
_MOST_CORRECTIONS, _IMPROVED = 6, 0.05
"""Corrections of a fit with one unknown held, and the gain in squares below which they end: a fit that ends early is
too far away, and its interval too narrow."""
_BETTER = 0.5
"""Gain in squares by which a point meets the data better than the end of the search, which was another minimum then."""
_TIGHT = 1e-4
"""Standard deviation of u below which runs have too few digits to check a covariance."""
_SEPARABLE = 0.95
_USEFUL = 0.5
"""Part of the bounds' distance that an interval may cover for an unknown to count as determined."""


@dataclass(frozen=True, eq=False)
class Judged:
    """Uncertainty of the variables u.

    Attributes:
        covariance: by the scatter of the data.
        misfit: root mean square of the residuals in standard deviations.
        inflation: factor on the variance: from the misfit, and from residuals that follow each other.
        of_method: standard deviations by the error of the method.
        of_cells: shift of u that finer cells and steps would make, an estimate.
        z: number of standard deviations of the interval, of the data and of the method.
        low: lower ends of the interval by scatter of the data and, as if that were scatter, by the error of the cells.
        high: upper ends.
        of_scatter: part of that interval that is by the scatter of the data alone.
        profiles: values of u, and distances in standard deviations there, of unknowns whose profile was computed.
    """

    covariance: FloatArray
    misfit: float
    inflation: float
    of_method: FloatArray
    of_cells: FloatArray
    z: tuple[float, float]
    low: FloatArray
    high: FloatArray
    of_scatter: FloatArray
    profiles: dict[int, tuple[FloatArray, FloatArray]]

    @property
    def correlation(self) -> FloatArray:
        """Correlation of the estimates; 0 for an unknown that was not varied."""
        spread = np.sqrt(np.diag(self.covariance))
        both = np.outer(spread, spread)
        return np.asarray(np.divide(self.covariance, both, out=np.eye(spread.size), where=both > 0.0))

    def interval_of_scatter(self, u: FloatArray) -> tuple[FloatArray, FloatArray]:
        """Ends of the interval by the scatter of the data alone."""
        return u - self.of_scatter * (u - self.low), u + self.of_scatter * (self.high - u)

    def interval(self, u: FloatArray) -> tuple[FloatArray, FloatArray]:
        """Ends of the interval by data, method and cells together."""
        more = (self.z[1] * self.of_method) ** 2 + self.of_cells**2
        return u - np.sqrt((u - self.low) ** 2 + more), u + np.sqrt((self.high - u) ** 2 + more)


def judged(
    problem: Problem, solution: Solution, loss: Loss, confidence: float, method: float, finer: FloatArray | None
) -> Judged:
    """Covariance and intervals at a solution.

    Args:
        problem: the problem.
        solution: its solution.
        loss: loss of the search.
        confidence: probability of the intervals, as 0.95.
        method: relative error of the method, smooth along a curve.
        finer: values of finer cells; None: not known.
    """
    u, sigma = solution.u, problem.sigma
    free = [j for j in range(u.size) if j not in solution.insensitive]
    residuals = (solution.curve - problem.y) / sigma
    weights = robust_weights(residuals, loss)
    count = residuals.size + problem.prior_jacobian(u).shape[0]
    freedom = max(1, count - len(free))
    square = float(np.sum(weights * residuals**2) / max(1.0, float(weights.mean())) / freedom)
    known = all(problem.has_noise)
    inflation = (max(1.0, square) if known else square) * _following(problem, residuals)
    rows = (solution.jacobian / sigma[:, None] * np.sqrt(weights)[:, None])[:, free]
    priors = problem.prior_jacobian(u)[:, free]
    normal = rows.T @ rows / inflation if inflation > 0.0 else rows.T @ rows * 1e12
    part = np.linalg.pinv(normal + priors.T @ priors, rcond=1e-12)
    covariance = np.zeros((u.size, u.size))
    covariance[np.ix_(free, free)] = part
    gain = np.zeros((u.size, residuals.size))
    gain[free] = part @ (rows * np.sqrt(weights)[:, None] / sigma[:, None]).T / max(inflation, 1e-12)
    spread = np.sqrt(np.diag(covariance))
    parts = max(inflation, 1.0) * (sigma**2 - problem.of_cells**2)
    scattered = np.sum(gain**2 * parts, axis=1)
    scattered[free] += np.sum((part @ priors.T) ** 2, axis=1)
    z = float(student.ppf(0.5 + 0.5 * confidence, freedom))
    shift = np.zeros(u.size) if finer is None else np.abs(gain @ _remaining(finer - solution.curve))
    return Judged(
        covariance,
        float(np.sqrt(square)),
        inflation,
        _of_method(problem, u, gain, method),
        shift,
        (z, float(norm.ppf(0.5 + 0.5 * confidence))),
        u - z * spread,
        u + z * spread,
        np.minimum(np.sqrt(np.divide(scattered, spread**2, out=np.ones(u.size), where=spread > 0.0)), 1.0),
        {},
    )


def _remaining(difference: FloatArray) -> FloatArray:
    """Error of the cells, of second order: docs/verification/simulation.md."""
    return np.asarray(difference / (1.0 - _FINER**-2.0))


def _following(problem: Problem, residuals: FloatArray) -> float:
    """Factor on the variance because residuals follow each other (of first order, by curve); 1 for scatter."""
    products = squares = 0.0
    pairs = 0
    for part in problem.parts:
        own = residuals[part]
        products += float(np.sum(own[1:] * own[:-1]))
        squares += float(np.sum(own**2))
        pairs += own.size - 1
    if pairs < 5 or squares == 0.0:
        return 1.0
    correlation = min(products / squares, 0.95)
    return (1.0 + correlation) / (1.0 - correlation) if correlation > 2.0 / np.sqrt(pairs) else 1.0


def _of_method(problem: Problem, u: FloatArray, gain: FloatArray, method: float) -> FloatArray:
    """Standard deviations of u by an error that is smooth along each curve; half of its variance is common to all."""
    if method == 0.0:
        return np.zeros(u.size)
    size = method * problem.slopes(u)
    nodes = np.linspace(0.0, 1.0, _NODES)
    kernel = np.exp(-0.5 * ((nodes[:, None] - nodes[None, :]) / _LENGTH) ** 2)
    root = np.linalg.cholesky(kernel + 1e-9 * np.eye(_NODES))
    square = 0.5 * (gain @ size) ** 2
    for index, part in enumerate(problem.parts):
        branch = problem.branch(index)
        groups = np.zeros(problem.data[index].x.size) if branch is None else branch
        for one in np.unique(groups):
            here = np.flatnonzero(groups == one)
            place = np.linspace(0.0, 1.0, here.size) if here.size > 1 else np.zeros(1)
            basis = np.stack([np.interp(place, nodes, column) for column in root.T], axis=1)
            square += 0.5 * np.sum((gain[:, part][:, here] * size[part][here] @ basis) ** 2, axis=1)
    return np.asarray(np.sqrt(square))


def cells_error(problem: Problem, u: FloatArray) -> FloatArray | None:
    """Values at the data with finer cells and twice the steps; None if they cannot be computed."""
    try:
        return problem.curve_with(u, 1.0 / _FINER, 2)
    except (BrinellError, MemoryError):
        return None


def profiled(
    problem: Problem, solution: Solution, found: Judged, loss: Loss, asked: Sequence[int]
) -> tuple[Judged, FloatArray | None]:
    """Adds profiles: of unknowns that are asked for, and of those of which the covariance misleads.

    An end of the interval is where the best fit with the unknown held there is as many standard deviations away as the
    interval is wide (Bates and Watts 1988). On the way there the other unknowns follow the covariance, and are
    corrected by the slopes until that gains nothing.

    Returns:
        The intervals; and a point that meets the data better than the solution does, if there is one on the way.
    """
    z, spread = found.z[0], np.sqrt(np.diag(found.covariance))
    free = [j for j in range(spread.size) if spread[j] > _TIGHT]
    low, high, profiles = found.low.copy(), found.high.copy(), {}
    for j in free:
        ends = [min(max(solution.u[j] + side * z * spread[j], 0.0), 1.0) for side in (-1.0, 1.0)]
        points, roots, better = _distances(problem, solution, found, loss, j, ends)
        if better is not None:
            return found, better
        due = (points - solution.u[j]) / spread[j]
        off = np.abs(roots - due)[np.isfinite(roots)] / z
        if j in asked or off.size < 2 or off.max() > _MISLED:
            inner = [solution.u[j] + 0.5 * (end - solution.u[j]) for end in ends]
            outer = [min(max(solution.u[j] + 1.5 * (end - solution.u[j]), 0.0), 1.0) for end in ends]
            more, more_roots, better = _distances(problem, solution, found, loss, j, [*inner, *outer])
            if better is not None:
                return found, better
            points, roots = np.r_[points, more, solution.u[j]], np.r_[roots, more_roots, 0.0]
            keep = np.argsort(points)[np.isfinite(roots[np.argsort(points)])]
            points, roots = points[keep], np.maximum.accumulate(roots[keep])
            profiles[j] = (points, roots)
            low[j] = _crossing(points, roots, -z, low[j])
            high[j] = _crossing(points, roots, z, high[j])
    return replace(found, low=low, high=high, profiles=profiles), None


def _crossing(points: FloatArray, roots: FloatArray, z: float, otherwise: float) -> float:
    """Where the distance is z; the bound that it stays below, or the covariance where no run tells."""
    if points.size < 3:
        return otherwise
    if roots[0] <= z <= roots[-1]:
        return float(np.interp(z, roots, points))
    inner, outer = (0, 1) if z < 0.0 else (-1, -2)
    if points[inner] in (0.0, 1.0) or roots[inner] == roots[outer]:
        return float(points[inner])
    slope = (points[inner] - points[outer]) / (roots[inner] - roots[outer])
    return float(min(max(points[inner] + slope * (z - roots[inner]), 0.0), 1.0))


def _distances(
    problem: Problem, solution: Solution, found: Judged, loss: Loss, index: int, ends: Sequence[float]
) -> tuple[FloatArray, FloatArray, FloatArray | None]:
    """Signed distances, in standard deviations, of the best fits with one unknown held at several values.

    Last a point that meets the data better than the solution, if there is one.
    """
    u, sigma = solution.u, problem.sigma
    column = found.covariance[:, index] / found.covariance[index, index]
    others = [j for j in range(u.size) if j != index and found.covariance[j, j] > 0.0]
    rows = np.vstack([solution.jacobian / sigma[:, None], problem.prior_jacobian(u)])[:, others]
    back = np.linalg.pinv(rows) if others else np.zeros((0, rows.shape[0]))
    points = [np.clip(u + column * (end - u[index]), 0.0, 1.0) for end in ends]
    best, going = np.full(len(points), np.inf), list(range(len(points)))
    where = list(points)
    for _ in range(_MOST_CORRECTIONS if others else 1):
        improved = []
        for k, curve in zip(going, problem.curves([points[k] for k in going]), strict=True):
            if isinstance(curve, BrinellError):
                continue
            residuals = problem.residuals(curve, points[k])
            cost = _cost(residuals, loss, found.inflation)
            if cost < best[k] - _IMPROVED:
                improved.append(k)
            if cost < best[k]:
                best[k], where[k] = cost, points[k]
            points[k] = points[k].copy()
            points[k][others] = np.clip(points[k][others] - back @ residuals, 0.0, 1.0)
        going = improved
    base = _cost(problem.residuals(solution.curve, u), loss, found.inflation)
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", RuntimeWarning)
        roots = np.sqrt(np.maximum(best - base, 0.0)) * np.sign(np.array(ends) - u[index])
    lowest = int(np.argmin(best))
    better = where[lowest] if best[lowest] < base - _BETTER else None
    return np.array(ends), np.where(np.isfinite(best), roots, np.nan), better


def _cost(residuals: FloatArray, loss: Loss, inflation: float) -> float:
    return robust_squares(residuals, loss) / max(inflation, 1e-12)


def separable(correlation: FloatArray, spread: FloatArray) -> list[tuple[int, int, float]]:
    """Pairs of unknowns that the data hardly tell apart, and change of the second that makes up for 1 of the first."""
    pairs = []
    for i in range(spread.size):
        for j in range(i + 1, spread.size):
            if abs(correlation[i, j]) > _SEPARABLE and spread[i] > _TIGHT:
                pairs.append((i, j, float(correlation[i, j] * spread[j] / spread[i])))
    return pairs


def is_determined(low: float, high: float) -> bool:
    """Whether an interval of u says more than the bounds do."""
    return min(high, 1.0) - max(low, 0.0) < _USEFUL
