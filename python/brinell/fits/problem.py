# SPDX-License-Identifier: BSD-3-Clause
"""The least squares problem: runs at values of the unknowns, computed in parallel, and their distance from the data."""

from __future__ import annotations

import itertools
import warnings
from collections.abc import Callable, Mapping, Sequence
from concurrent.futures import Executor, Future
from dataclasses import dataclass, field, replace
from typing import Any

import numpy as np

from brinell.case import Case, CaseWarning
from brinell.errors import BrinellError, InputError
from brinell.fits.checks import branches_of
from brinell.fits.data import Data, FloatArray
from brinell.fits.model import Observed, Wanted, history_of, observe, predicted
from brinell.fits.unknowns import MACHINE, Parameter, values_of
from brinell.sweeps.lists import table_of, with_whole_lists

__all__ = ["LEAST_NOISE", "Course", "Experiment", "Problem", "experiments_of"]

_UNKNOWN_NOISE = 0.01
"""Noise, as a part of the largest value, with which the search begins where the user gives none."""
LEAST_NOISE = 1e-4
"""Least noise, as a part of the largest value: the digits of a run."""


@dataclass(frozen=True, eq=False)
class Experiment:
    """One run that one or more data are compared with."""

    case: Case
    table: Mapping[str, Any]
    """The case with all defaults."""
    members: tuple[int, ...]
    """Indices of the data."""
    wanted: Wanted


@dataclass(frozen=True, eq=False)
class Course:
    """Where a fit is, for who follows it.

    Attributes:
        stage: what is being done.
        runs: number of runs that have ended.
        misfit: root mean square of the residuals in standard deviations, at the best point of this stage so far; None
            before the first.
        values: the unknowns at that point with their units, by name.
        fitted: values of the runs at that point, of each of the data.
        data: what is compared, without points at holds.
    """

    stage: str = ""
    runs: int = 0
    misfit: float | None = None
    values: Mapping[str, tuple[float, str]] = field(default_factory=dict)
    fitted: Sequence[FloatArray] = ()
    data: Sequence[Data] = ()


def experiments_of(case: Case | None, data: Sequence[Data], parameters: Sequence[Parameter]) -> list[Experiment]:
    """Data that one run serves, because they have the same case and the same unknowns.

    Raises:
        InputError: data without a case, or a case that is wrong.
    """
    groups: dict[Any, list[int]] = {}
    cases: dict[Any, Case] = {}
    for i, one in enumerate(data):
        base = one.case if one.case is not None else case
        if base is None:
            raise one.error("there is no case; allowed: case = a file, of the data or of the fit")
        base = base if isinstance(base, Case) else Case.from_file(base)
        try:
            own = base.with_values(one.set) if one.set else base
        except InputError as error:
            raise one.error(f"set: {error}") from None
        belonging = tuple(p.unknown.keys for p in parameters if not p.unknown.data or one.name in p.unknown.data)
        key = (own.to_toml(), tuple(keys for keys in belonging if keys[0] not in MACHINE))
        groups.setdefault(key, []).append(i)
        cases.setdefault(key, own)
    found = []
    for key, members in groups.items():
        kinds = [data[i] for i in members]
        if cases[key].scenario != "indentation" and any(one.kind == "load-depth" for one in kinds):
            raise kinds[0].error(f'the case is {cases[key].scenario}; kind "load-depth" needs an indentation')
        columns = {name for one in kinds if one.kind == "history" for name in one.columns}
        if any(one.kind == "load-depth" for one in kinds):
            columns |= {"approach", "F_n", "place"}
        wanted = Wanted(tuple(sorted(columns)), any(one.kind == "imprint" for one in kinds))
        found.append(Experiment(_resolved(cases[key]), table_of(cases[key]), tuple(members), wanted))
    return found


def _resolved(case: Case) -> Case:
    """The case with all defaults as a file, of which --set may replace keys that exclude each other."""
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", CaseWarning)
        return Case(case.to_toml(), names_lines=False)


class Problem:
    """Measured data, runs at values of the unknowns, and the weighted differences between both.

    Attributes:
        data: the data, without holds.
        parameters: the unknowns; u is the vector of their variables in [0, 1].
        experiments: the runs.
        cells: keys that are set in each run, for other cells than those that the case plans.
        steps: (unknowns,) steps of u for differences.
        sigma: (points,) standard deviation of each point.
        runs: number of runs so far.
    """

    def __init__(
        self,
        data: Sequence[Data],
        parameters: Sequence[Parameter],
        experiments: Sequence[Experiment],
        pool: Executor,
        watch: Callable[[Course], None] | None = None,
    ):
        """Sets up the problem; no run is computed. `watch` gets the course of the fit, often."""
        self.data, self.parameters, self.experiments = list(data), list(parameters), list(experiments)
        self.cells: list[dict[str, Any]] = [{} for _ in experiments]
        self.steps = np.array([one.step for one in parameters])
        self.runs = 0
        self._pool = pool
        self._watch = watch
        self._course = Course(data=self.data)
        self._cache: dict[Any, Future[Observed]] = {}
        self._branches: list[FloatArray | None] = [None] * len(self.data)
        self.y = np.concatenate([one.y for one in self.data])
        bounds = np.cumsum([0, *(one.y.size for one in self.data)])
        self.parts = [slice(int(a), int(b)) for a, b in itertools.pairwise(bounds)]
        deviations = [one.deviations() for one in self.data]
        largest = [float(np.abs(one.y).max(initial=0.0)) or 1.0 for one in self.data]
        self.has_noise = [spread is not None for spread, _ in deviations]
        self.noise = np.concatenate(
            [
                np.full(one.y.size, _UNKNOWN_NOISE * top) if spread is None else np.maximum(spread, LEAST_NOISE * top)
                for one, (spread, _), top in zip(self.data, deviations, largest, strict=True)
            ]
        )
        self.least = np.concatenate(
            [np.full(one.y.size, LEAST_NOISE * top) for one, top in zip(self.data, largest, strict=True)]
        )
        self._along = [along for _, along in deviations]
        self.of_cells = np.zeros(self.y.size)
        self.sigma = self.noise.copy()

    def limit_depths(self, factor: float) -> None:
        """Gives up runs whose approach exceeds the largest measured depth by a factor."""
        for k, one in enumerate(self.experiments):
            deepest = [float(self.data[i].x.max()) for i in one.members if self.data[i].kind == "load-depth"]
            if deepest:
                self.experiments[k] = replace(one, wanted=replace(one.wanted, deepest=factor * max(deepest)))

    def observed(self, points: Sequence[FloatArray]) -> list[list[Observed | BrinellError]]:
        """Runs of all experiments at several points u, computed in parallel; an error where a run fails."""
        futures = [[self._submitted(i, u) for i in range(len(self.experiments))] for u in points]
        return [[self._outcome(one) for one in row] for row in futures]

    def _outcome(self, future: Future[Observed]) -> Observed | BrinellError:
        try:
            return future.result()
        except BrinellError as error:
            return error
        finally:
            if self._watch is not None:
                ended = sum(one.done() for one in self._cache.values())
                if ended != self._course.runs:
                    self._tell(runs=ended)

    def enter(self, stage: str) -> None:
        """Tells who follows the fit what is done now; values and curves stay until there are better ones."""
        self._tell(stage=stage)

    def follow(self, stage: str, u: FloatArray, curve: FloatArray) -> float:
        """Misfit at a point: root mean square of the residuals, which is told to who follows the fit."""
        misfit = float(np.sqrt(np.mean(self.residuals(curve, u) ** 2)))
        seen = self._course
        if self._watch is not None and (stage != seen.stage or seen.misfit is None or misfit <= seen.misfit):
            known = zip(self.parameters, u.tolist(), strict=True)
            values = {one.name: (one.value(x), one.unit) for one, x in known}
            self._tell(stage=stage, misfit=misfit, values=values, fitted=[curve[part] for part in self.parts])
        return misfit

    def _tell(self, **changes: Any) -> None:
        self._course = replace(self._course, **changes)
        if self._watch is not None:
            self._watch(self._course)

    def forecast(self, u: FloatArray) -> float:
        """Foretold processor time of the runs at u [s]; infinite where a case is not allowed."""
        try:
            return sum(self._case(i, self._values(i, u)).forecast.seconds for i in range(len(self.experiments)))
        except BrinellError:
            return float("inf")

    def _values(self, index: int, u: FloatArray) -> dict[str, float]:
        values = values_of(self.parameters, u.tolist(), self.data[self.experiments[index].members[0]].name)
        return {key: value for key, value in values.items() if key not in MACHINE}

    def _case(self, index: int, values: Mapping[str, float]) -> Case:
        experiment = self.experiments[index]
        with warnings.catch_warnings():
            warnings.simplefilter("ignore", CaseWarning)
            point = {**with_whole_lists(dict(values), experiment.table), **self.cells[index]}
            return experiment.case.with_values(point)

    def fitted_case(self, index: int, u: FloatArray) -> Case:
        """Case of a run with the values at u, and its own cells."""
        kept, self.cells = self.cells, [{} for _ in self.experiments]
        try:
            return self._case(index, self._values(index, u))
        finally:
            self.cells = kept

    def _submitted(self, index: int, u: FloatArray) -> Future[Observed]:
        values = self._values(index, u)
        key = (index, tuple(values.items()), repr(self.cells[index]))
        if key not in self._cache:
            try:
                case = self._case(index, values)
                self._cache[key] = self._pool.submit(observe, case, self.experiments[index].wanted, 1)
                self.runs += 1
            except BrinellError as error:
                self._cache[key] = Future()
                self._cache[key].set_exception(error)
        return self._cache[key]

    def curves(self, points: Sequence[FloatArray]) -> list[FloatArray | BrinellError]:
        """Values at the points of all data; an error where a run fails."""
        return [self._curve(u, runs) for u, runs in zip(points, self.observed(points), strict=True)]

    def curve(self, u: FloatArray) -> FloatArray:
        """Values at the points of all data.

        Raises:
            BrinellError: a run failed.
        """
        (found,) = self.curves([u])
        if isinstance(found, BrinellError):
            raise found
        return found

    def curve_with(self, u: FloatArray, cells: float, steps: int = 1) -> FloatArray:
        """Values at the points of all data with the planned cells larger by a factor, and so many times the steps.

        Raises:
            BrinellError: a run failed.
        """
        (runs,) = self.observed([u])
        kept, self.cells = self.cells, []
        for own, run, experiment in zip(kept, runs, self.experiments, strict=True):
            keys = dict(own)
            if isinstance(run, Observed):
                keys = {"grid.spacing": [cells * size for size in run.spacing]}
            if steps > 1 and "steps" in (table := experiment.table.get("indentation", {})):
                keys["indentation.steps"] = steps * table["steps"]
            self.cells.append(keys)
        try:
            return self.curve(u)
        finally:
            self.cells = kept

    def _curve(self, u: FloatArray, runs: Sequence[Observed | BrinellError]) -> FloatArray | BrinellError:
        result = np.empty(self.y.size)
        for experiment, run in zip(self.experiments, runs, strict=True):
            if isinstance(run, BrinellError):
                return run
            for i in experiment.members:
                result[self.parts[i]] = self.of_data(i, u, run)
        return result

    def of_data(self, index: int, u: FloatArray, run: Observed, shift: FloatArray | float = 0.0) -> FloatArray:
        """Values of one curve at its places, shifted by a distance along x."""
        one = self.data[index]
        values = values_of(self.parameters, u.tolist(), one.name)
        machine = {key: value for key, value in values.items() if key in MACHINE}
        if one.kind == "load-depth" and self._branches[index] is None:
            approach, load = history_of(one, run)
            driven, model = (one.y, load) if run.is_load_driven else (one.x, approach)
            self._branches[index] = branches_of(one, driven, model)
        at = one if np.isscalar(shift) and shift == 0.0 else _shifted(one, shift)
        found = predicted(at, self._branches[index], run, machine)
        if one.kind == "imprint" and one.level:
            weight = self.sigma[self.parts[index]] ** -2.0
            found = found + np.sum(weight * (one.y - found)) / np.sum(weight)
        return found

    def branch(self, index: int) -> FloatArray | None:
        """Branch of each point of a load-depth curve, once a run has been compared."""
        return self._branches[index]

    def set_sigma(self, u: FloatArray) -> None:
        """Combines noise of y, that of x with the slope of the runs at u, and the error of the cells."""
        (runs,) = self.observed([u])
        squares = self.noise**2 + self.of_cells**2
        for experiment, run in zip(self.experiments, runs, strict=True):
            for i in experiment.members:
                if isinstance(run, Observed) and self._along[i].any():
                    up, down = (self.of_data(i, u, run, sign * self._along[i]) for sign in (1.0, -1.0))
                    squares[self.parts[i]] += (0.5 * (up - down)) ** 2
        self.sigma = np.sqrt(squares)

    def slopes(self, u: FloatArray) -> FloatArray:
        """Size of the change of each value when x is stretched by its own size: y' x for depths, y otherwise."""
        (runs,) = self.observed([u])
        result = np.abs(self.curve(u))
        for experiment, run in zip(self.experiments, runs, strict=True):
            for i in experiment.members:
                if self.data[i].kind == "load-depth" and isinstance(run, Observed):
                    step = 0.005 * np.abs(self.data[i].x)
                    up, down = (self.of_data(i, u, run, sign * step) for sign in (1.0, -1.0))
                    result[self.parts[i]] = 100.0 * np.abs(up - down)
        return result

    def residuals(self, curve: FloatArray, u: FloatArray) -> FloatArray:
        """Differences in standard deviations; those from the priors come last."""
        return np.concatenate([(curve - self.y) / self.sigma, self._of_priors(u)])

    def _of_priors(self, u: FloatArray) -> FloatArray:
        found = [one.prior_residual(x) for one, x in zip(self.parameters, u.tolist(), strict=True)]
        return np.array([x for x in found if x is not None])

    def jacobian(self, u: FloatArray, free: Sequence[int]) -> FloatArray:
        """(points, unknowns) derivatives of the values by u; zero for unknowns that are not free or cannot be moved.

        Differences between both sides, by `steps`.
        """
        ends = [
            (min(x + step, 1.0) - x, max(x - step, 0.0) - x)
            for step, x in zip(self.steps.tolist(), u.tolist(), strict=True)
        ]
        points = [_moved(u, j, step) for j in free for step in ends[j]]
        base, *around = self.curves([u, *points])
        if isinstance(base, BrinellError):
            raise base
        result = np.zeros((self.y.size, u.size))
        for j, up, down in zip(free, around[::2], around[1::2], strict=True):
            above, below = (ends[j][0], up), (ends[j][1], down)
            if isinstance(up, BrinellError):
                above = (0.0, base)
            if isinstance(down, BrinellError):
                below = (0.0, base)
            if above[0] > below[0]:
                result[:, j] = (np.asarray(above[1]) - np.asarray(below[1])) / (above[0] - below[0])
        return result

    def prior_jacobian(self, u: FloatArray) -> FloatArray:
        """(priors, unknowns) derivatives of the distances from the priors."""
        rows = []
        for j, (one, x) in enumerate(zip(self.parameters, u.tolist(), strict=True)):
            if one.prior_deviation is not None and one.prior is not None:
                row = np.zeros(u.size)
                row[j] = one.slope(x) / one.prior_deviation
                rows.append(row)
        return np.array(rows).reshape(-1, u.size)


def _moved(u: FloatArray, index: int, step: float) -> FloatArray:
    result = u.copy()
    result[index] += step
    return result


def _shifted(data: Data, shift: FloatArray | float) -> Data:
    """Data at other places; the checks of the original need no repetition."""
    other = object.__new__(Data)
    for name, value in vars(data).items():
        object.__setattr__(other, name, value)
    object.__setattr__(other, "x", data.x + shift)
    return other
