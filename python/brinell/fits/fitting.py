# SPDX-License-Identifier: BSD-3-Clause
"""The function `fit`: checks, search, intervals, and what is to be told."""

from __future__ import annotations

import contextlib
import os
import time
import warnings
from collections.abc import Callable, Iterator, Sequence
from concurrent.futures import Executor, ThreadPoolExecutor
from pathlib import Path
from typing import Any

import numpy as np

from brinell.case import Case, CaseWarning, ResolutionWarning
from brinell.errors import InputError, MissingExtraError
from brinell.fits.checks import checked_sign, without_holds
from brinell.fits.data import Data
from brinell.fits.file import read_fit
from brinell.fits.intervals import Judged, cells_error, is_determined, judged, profiled, separable
from brinell.fits.model import Observed
from brinell.fits.problem import Course, Problem, experiments_of
from brinell.fits.result import Curve, Estimate, Fit
from brinell.fits.solve import LOSSES, Loss, Solution, searched, solved
from brinell.fits.text import as_text
from brinell.fits.unknowns import Parameter, Unknown

__all__ = ["check_request", "fit"]

METHOD_ERROR = 0.01
"""Relative error of depths and other values by the method itself: half spaces, small strains, paraboloids."""

_MISFIT = 1.5
_FOLLOWING = 3.0
_OUTLIER = 5.0
_AT_BOUND = 1e-3
_MOST_MINIMA = 4
"""Minima from which the search goes on where a profile finds a better one."""


def fit(
    case: Case | str | Path | None = None,
    unknowns: Sequence[Unknown] = (),
    data: Data | Sequence[Data] = (),
    *,
    loss: Loss = "linear",
    confidence: float = 0.95,
    method_error: float = METHOD_ERROR,
    profiles: bool | Sequence[str] = False,
    title: str = "",
    workers: int | None = None,
    cluster: Any = None,
    progress: bool | Callable[[str], None] = False,
    watch: Callable[[Course], None] | None = None,
) -> Fit:
    """Finds unknown keys of a case from measured curves.

        result = brinell.fit("fit.toml")
        print(result)
        result.write("results/steel")

    Args:
        case: the case, its file, or the file of a fit, which has all that follows.
        unknowns: what is to be found.
        data: measured data, of one test or of several.
        loss: "linear": least squares; "soft_l1", "huber", "cauchy": points that are far off count less.
        confidence: probability of the intervals.
        method_error: relative error of depths, and of other values, by the method: a standard deviation, smooth along
            each curve. 0 for curves that brinell itself has computed.
        profiles: unknowns, by key or name, whose interval is found by fits with the unknown held; True: all. They are
            found in any case where the covariance misleads.
        title: title; empty: that of the case.
        workers: number of runs at a time; None: number of cores.
        cluster: address or scheduler file of a Dask cluster, or a client of Dask, that computes the runs.
        progress: True prints a line per stage; a function gets these lines.
        watch: a function that gets where the fit is: stage, runs, and the best point so far with its curves.

    Returns:
        Estimates, intervals, correlation, curves, and what the data cannot tell.

    Raises:
        InputError: an unknown, the data, or the case is wrong: the text says where and what is allowed.
        BrinellError: no run could be computed.
    """
    begin = time.perf_counter()
    if case is not None and not isinstance(case, Case) and not unknowns:
        settings = read_fit(Path(case))
        return fit(**settings, workers=workers, cluster=cluster, progress=progress, watch=watch)
    tell = progress if callable(progress) else print if progress else lambda text: None
    given = [data] if isinstance(data, Data) else list(data)
    check_request(given, unknowns, loss, confidence, method_error)
    base = None if case is None else case if isinstance(case, Case) else Case.from_file(case)
    notes: list[str] = []
    for i, one in enumerate(given):
        checked_sign(one)
        given[i], told = without_holds(one)
        notes += told
    parameters = _parameters(base, unknowns, given)
    asked = _asked(parameters, profiles)
    experiments = experiments_of(base, given, parameters)
    with _pool(workers, cluster) as pool, warnings.catch_warnings():
        warnings.simplefilter("ignore", ResolutionWarning)
        warnings.simplefilter("ignore", CaseWarning)
        problem = Problem(given, parameters, experiments, pool, watch)
        solution = solved(problem, loss, tell)
        for _ in range(_MOST_MINIMA):
            tell("error of the cells")
            problem.enter("error of the cells")
            finer = cells_error(problem, solution.u)
            found = judged(problem, solution, loss, confidence, method_error, finer)
            tell("intervals")
            problem.enter("intervals")
            found, better = profiled(problem, solution, found, loss, asked)
            if better is None:
                break
            solution = searched(problem, better, loss, tell, solution.notes)
        curves = _curves(problem, solution)
        cases = [problem.fitted_case(i, solution.u) for i in range(len(experiments))]
    estimates = _estimates(problem, solution, found)
    findings = [*notes, *solution.notes, *_findings(problem, solution, found, estimates, finer is None)]
    return Fit(
        title=title or cases[0].title or cases[0].name,
        estimates=estimates,
        correlation=found.correlation,
        covariance=found.covariance,
        misfit=found.misfit,
        curves=curves,
        cases=cases,
        findings=findings,
        converged=solution.converged,
        runs=problem.runs,
        seconds=time.perf_counter() - begin,
        confidence=confidence,
        settings={"loss": loss, "method_error": method_error, "variance_factor": found.inflation},
    )


def check_request(
    data: Sequence[Data], unknowns: Sequence[Unknown], loss: str, confidence: float, method: float
) -> None:
    """Checks what needs no run.

    Raises:
        InputError: data and unknowns do not go together, or a setting is not allowed.
    """
    if not data or not unknowns:
        raise InputError("a fit needs unknowns and data; allowed: one or more of each")
    if loss not in LOSSES:
        raise InputError(f"loss = {loss!r}; allowed: {', '.join(LOSSES)}")
    if not 0.5 <= confidence < 1.0:
        raise InputError(f"confidence = {confidence}; allowed: in [0.5, 1)")
    if not 0.0 <= method <= 0.5:
        raise InputError(f"method_error = {method}; allowed: in [0, 0.5], as 0.01 or '1 %'")
    names = [one.name for one in data]
    if twice := {name for name in names if names.count(name) > 1}:
        raise InputError(f"data {sorted(twice)[0]!r} are there twice; allowed: a name each")
    keys = [key for one in unknowns for key in one.keys if not one.data]
    if twice := {key for key in keys if keys.count(key) > 1}:
        raise InputError(f"unknown {sorted(twice)[0]}: is there twice; allowed: once, or each for other data")
    points = sum(one.y.size for one in data) + sum(one.prior is not None for one in unknowns)
    if points < len(unknowns):
        raise InputError(f"{points} points for {len(unknowns)} unknowns; allowed: as many points as unknowns, or more")
    for one in unknowns:
        if "machine.drift" in one.keys and any(d.time is None for d in data if not one.data or d.name in one.data):
            raise one.error("key", "the data have no time; allowed: a column time")


def _parameters(base: Case | None, unknowns: Sequence[Unknown], data: Sequence[Data]) -> list[Parameter]:
    names = [one.name for one in data]
    last = [one.keys[0].split(".")[-1] for one in unknowns]
    found = []
    for one in unknowns:
        own = next((d.case for d in data if d.case is not None and (not one.data or d.name in one.data)), None)
        case = base if own is None else own if isinstance(own, Case) else Case.from_file(own)
        if case is None:
            raise InputError("there is no case; allowed: case = a file")
        with warnings.catch_warnings():
            warnings.simplefilter("ignore", CaseWarning)
            found.append(Parameter.of(one, case, names, last.count(one.keys[0].split(".")[-1]) > 1))
    return found


def _asked(parameters: Sequence[Parameter], profiles: bool | Sequence[str]) -> list[int]:
    if isinstance(profiles, bool):
        return list(range(len(parameters))) if profiles else []
    known = {name: i for i, one in enumerate(parameters) for name in (one.unknown.keys[0], one.name)}
    if wrong := [name for name in profiles if name not in known]:
        raise InputError(f"profiles: {wrong[0]!r} is no unknown; allowed: {', '.join(known)}")
    return sorted(known[name] for name in profiles)


@contextlib.contextmanager
def _pool(workers: int | None, cluster: Any) -> Iterator[Executor]:
    """Threads of this process, each of which computes a run on one core, or the workers of a cluster."""
    if cluster is None:
        if workers is not None and workers < 1:
            raise InputError(f"workers = {workers}; allowed: 1 or more")
        with ThreadPoolExecutor(workers or len(os.sched_getaffinity(0))) as pool:
            try:
                yield pool
            except BaseException:  # as Ctrl-C: runs that wait would be computed for nothing
                pool.shutdown(wait=False, cancel_futures=True)
                raise
        return
    try:
        from distributed import Client
    except ModuleNotFoundError as error:
        raise MissingExtraError("a cluster", "distributed", "sweep") from error
    if isinstance(cluster, Client):
        yield cluster.get_executor(pure=False)
        return
    client = Client(scheduler_file=cluster) if Path(str(cluster)).is_file() else Client(cluster)
    with client:
        yield client.get_executor(pure=False)


def _curves(problem: Problem, solution: Solution) -> list[Curve]:
    """Data and fitted values, and the run at more places for a figure."""
    (runs,) = problem.observed([solution.u])
    curves = {}
    for experiment, run in zip(problem.experiments, runs, strict=True):
        assert isinstance(run, Observed)
        for i in experiment.members:
            one, part = problem.data[i], problem.parts[i]
            branch = problem.branch(i)
            groups = np.zeros(one.x.size) if branch is None else branch
            line = []
            for number in np.unique(groups) if one.kind != "number" else ():
                here = np.flatnonzero(groups == number)
                here = here[np.argsort(one.x[here], kind="stable")]
                line.append((one.x[here], solution.curve[part][here]))
            curves[i] = Curve(one, solution.curve[part], problem.sigma[part], line)
    return [curves[i] for i in range(len(problem.data))]


def _estimates(problem: Problem, solution: Solution, found: Judged) -> list[Estimate]:
    (low, high), (own_low, own_high) = found.interval(solution.u), found.interval_of_scatter(solution.u)
    result = []
    for j, one in enumerate(problem.parameters):
        u = float(solution.u[j])
        fixed = j in solution.insensitive
        ends = (0.0, 1.0) if fixed else (max(float(low[j]), 0.0), min(float(high[j]), 1.0))
        own = (0.0, 1.0) if fixed else (max(float(own_low[j]), 0.0), min(float(own_high[j]), 1.0))
        points, roots = found.profiles.get(j, (np.empty(0), np.empty(0)))
        slope = abs(one.slope(u))
        result.append(
            Estimate(
                key=one.unknown.keys[0],
                name=one.name,
                unit=one.unit,
                value=one.value(u),
                low=one.value(ends[0]),
                high=one.value(ends[1]),
                data_low=one.value(own[0]),
                data_high=one.value(own[1]),
                method=slope * float(found.of_method[j]),
                cells=slope * float(found.of_cells[j]),
                bounds=(one.low, one.high),
                determined=not fixed and (one.prior is not None or is_determined(float(low[j]), float(high[j]))),
                by_profile=j in found.profiles,
                profile=(tuple(one.value(float(x)) for x in points), tuple(roots.tolist())),
            )
        )
    return result


def _findings(
    problem: Problem, solution: Solution, found: Judged, estimates: Sequence[Estimate], no_cells: bool
) -> Iterator[str]:
    names = [one.name for one in estimates]
    for j in solution.insensitive:
        yield (
            f"{names[j]} ({estimates[j].key}) is not determined: the data hardly depend on it, even if all else were "
            f"known; it stayed at {as_text(estimates[j].value, estimates[j].unit)}, which means nothing"
        )
    for j, one in enumerate(estimates):
        if not one.determined and j not in solution.insensitive:
            needed = "other data, or a prior, are needed"
            if _is_of_cells(one):
                shift = as_text(one.cells, one.unit)
                needed = f"finer cells would shift it by about {shift}; use a larger grid.resolution"
            yield f"{names[j]} ({one.key}) is not determined: its interval covers most of its bounds; {needed}"
    spread = np.sqrt(np.diag(found.covariance))
    for i, j, ratio in separable(found.correlation, spread):
        yield _not_separable(problem, solution, estimates, i, j, ratio, float(found.correlation[i, j]))
    for j, one in enumerate(estimates):
        at = min(solution.u[j], 1.0 - solution.u[j])
        if at < _AT_BOUND and j not in solution.insensitive:
            yield f"{names[j]} has reached a bound ({one.key}): the bounds are too narrow, or the model is wrong"
    if found.misfit > _MISFIT and any(problem.has_noise):
        yield (
            f"the misfit is {found.misfit:.2g} times the noise: the noise is larger than stated, or the case is not "
            "that of the test; the intervals are wider accordingly"
        )
    scatter = max(found.misfit, 1e-300) ** 2 if not all(problem.has_noise) else max(1.0, found.misfit**2)
    if found.inflation > _FOLLOWING * scatter and not _is_exact(problem, solution):
        yield (
            "the residuals are no scatter, they follow each other along the curve: drift, compliance of the machine, "
            "the place of first touch or the hardening law may be others; the intervals are wider accordingly"
        )
    yield from _outliers(problem, solution)
    if not solution.converged:
        yield "the search has not converged: the estimates are those of its last step"
    if no_cells:
        yield "no run with finer cells could be computed: the error of the cells is not known"
    for j, one in enumerate(estimates):
        if one.determined and _is_of_cells(one) and one.cells > 0.02 * abs(one.value):
            yield (
                f"the cells are coarse for {names[j]}: finer ones would shift it by about "
                f"{as_text(one.cells, one.unit)}; the interval includes that; use a larger grid.resolution"
            )


def _is_of_cells(one: Estimate) -> bool:
    """Whether the error of the cells makes up much of an interval."""
    return one.cells > 0.25 * max(one.high - one.low, 1e-300)


def _is_exact(problem: Problem, solution: Solution) -> bool:
    """Whether the curve meets the data to the digits of a run, as for curves of brinell without noise."""
    return bool(np.median(np.abs(solution.curve - problem.y) / problem.least) < 20.0)


def _not_separable(
    problem: Problem,
    solution: Solution,
    estimates: Sequence[Estimate],
    i: int,
    j: int,
    ratio: float,
    correlation: float,
) -> str:
    """A sentence about two unknowns of which one makes up for the other."""
    step = 0.1 * estimates[i].value / problem.parameters[i].slope(float(solution.u[i])) if estimates[i].value else 0.02
    made_up = step * ratio * problem.parameters[j].slope(float(solution.u[j]))
    change = f"{100 * made_up / estimates[j].value:+.2g} %" if estimates[j].value else f"{made_up:+.2g}"
    return (
        f"{estimates[i].name} and {estimates[j].name} are hardly separable by these data (correlation "
        f"{correlation:+.3f}): +10 % of {estimates[i].name} is made up for by {change} of {estimates[j].name}"
    )


def _outliers(problem: Problem, solution: Solution) -> Iterator[str]:
    for one, part in zip(problem.data, problem.parts, strict=True):
        if one.y.size < 8:
            continue
        residuals = (solution.curve[part] - problem.y[part]) / problem.sigma[part]
        scale = max(1.4826 * float(np.median(np.abs(residuals))), 1.0)
        far = np.flatnonzero(np.abs(residuals) > _OUTLIER * scale)
        if 0 < far.size <= 0.1 * one.y.size:
            points = ", ".join(str(i + 1) for i in far[:5]) + (", ..." if far.size > 5 else "")
            several = "s" * (far.size > 1)
            yield (
                f"data {one.name!r}: {far.size} outlier{several} (point{several} {points}), more than "
                f'{_OUTLIER:g} times the scatter off; loss = "soft_l1" lets them count less'
            )
