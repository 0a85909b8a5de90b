# SPDX-License-Identifier: BSD-3-Clause
"""The function `sweep`: checks, computation of the runs, and the table of results."""

from __future__ import annotations

import contextlib
import itertools
import os
import sys
import warnings
from collections import Counter, deque
from collections.abc import Iterable, Iterator, Mapping
from concurrent.futures import FIRST_COMPLETED, Future, as_completed, wait
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import Any

import pandas as pd
from tqdm.auto import tqdm

from brinell import _core
from brinell.case import Case, CaseWarning, ResolutionWarning
from brinell.errors import InputError
from brinell.results import Run, open_run
from brinell.sweeps.axes import Axis, Choices, axis_of
from brinell.sweeps.designs import Design, Point, points_of
from brinell.sweeps.folder import FORMAT_VERSION, Ledger, locked, read_record, run_folder, start_folder, write_table
from brinell.sweeps.lists import table_of, with_whole_lists
from brinell.sweeps.numbers import Numbers, functions_of, with_numbers
from brinell.sweeps.point import Outcome, Task
from brinell.sweeps.pools import DaskPool, LocalPool, Lost, Pool

__all__ = ["Sweep", "open_sweep", "sweep"]

_MOST_LOSSES = 3
"""Number of times that the process of a run may die before the run counts as failed."""


@dataclass(frozen=True, eq=False)
class Sweep:
    """The results of a sweep.

    Attributes:
        path: folder of the sweep.
        table: one row per finished or failed run: index, values of the axes (SI, as in the case), status, reason of a
            failure, wall_time_s [s], folder, and all scalar values of the summary by dotted key, such as "energy.net_J"
            or "indents.0.hardness_Pa".
    """

    path: Path
    table: pd.DataFrame

    @property
    def runs(self) -> Mapping[int, Run]:
        """Finished runs by index; each is opened when it is accessed."""
        return _Runs(self.path, self.table["index"][self.table["status"] == "done"].tolist())

    @property
    def failures(self) -> pd.DataFrame:
        """Rows of the table for the failed runs."""
        return self.table[self.table["status"] == "failed"]

    @property
    def warnings(self) -> Mapping[str, list[int]]:
        """Indices of the runs that have a warning, by its key; its text is in `Run.warnings` and in the table."""
        found: dict[str, list[int]] = {}
        for name in self.table.columns[self.table.columns.str.fullmatch(r"warnings\.\d+\.key")]:
            for index, key in self.table.set_index("index")[name].dropna().items():
                found.setdefault(key, []).append(int(index))
        return {key: sorted(indices) for key, indices in found.items()}

    def with_numbers(self, *functions: Numbers) -> Sweep:
        """This sweep with further columns in its table.

        `sweep.with_numbers(brinell.sweeps.residual_stress, lambda run: {"loads": len(run.indents)}).table`

        Args:
            functions: functions of a finished run that return numbers by the names of their columns.

        Raises:
            InputError: a function fails or returns something else; the text names it and the run.
        """
        return Sweep(self.path, with_numbers(self.table, self.runs, functions_of(functions)))

    def __repr__(self) -> str:
        return f"<brinell.Sweep {str(self.path)!r}: {len(self.runs)} runs done, {len(self.failures)} failed>"


class _Runs(Mapping[int, Run]):
    def __init__(self, path: Path, indices: list[int]):
        self._path = path
        self._indices = dict.fromkeys(indices)

    def __getitem__(self, index: int) -> Run:
        if index not in self._indices:
            raise KeyError(index)
        return open_run(run_folder(self._path, index))

    def __iter__(self) -> Iterator[int]:
        return iter(self._indices)

    def __len__(self) -> int:
        return len(self._indices)


def open_sweep(path: str | Path) -> Sweep:
    """Opens the folder of a sweep, also of one that is still running.

    Raises:
        InputError: the folder holds no sweep, or no run of it has ended.
    """
    path = Path(path)
    if read_record(path) is None or not (path / "table.parquet").is_file():
        raise InputError(f"{path}: no sweep, or none of which a run has ended")
    return Sweep(path, pd.read_parquet(path / "table.parquet"))


def sweep(
    case: Case | str | Path,
    over: Mapping[str, Any],
    *,
    output: str | Path,
    design: Design = "grid",
    samples: int | None = None,
    seed: int = 0,
    workers: int | None = None,
    threads: int | None = None,
    cluster: Any = None,
    progress: bool = True,
    resume: bool = True,
    retry_failed: bool = False,
    numbers: Numbers | Iterable[Numbers] | None = None,
) -> Sweep:
    """Computes a case for many values of some of its keys.

    Finished runs of the same sweep in the folder are not computed again. A failed run is recorded with its reason. A
    run whose process is killed is repeated, from its checkpoint if there is one. Ctrl-C stops all runs; the next call
    resumes the sweep.

    A script needs ``if __name__ == "__main__":`` before the call, because each process imports the script.

    Args:
        case: the case that is varied, or its file.
        over: values by dotted key of the case: a sequence; or text, "1:15:15" for a range with both ends, "200 GPa:220
            GPa:3" with a unit, "log:1:100:5" for equal ratios, "swift,voce" for choices; or a `Range` or `Choices`.
            For a key that is a list, such as "indentation.load", numbers replace its first entry, and the other entries
            are unchanged; "indentation.load.2" is the third entry.
        output: folder of the sweep.
        design: "grid": all combinations; "list": the i-th values of all axes together; "latin_hypercube": random points
            from ranges without a count.
        samples: number of points of a Latin hypercube.
        seed: seed of a Latin hypercube.
        workers: number of processes on this machine; None: number of cores, divided by `threads` if given. Not allowed
            with `cluster`.
        threads: number of threads of each run; None: chosen to use all cores, on a cluster those of its worker.
        cluster: Dask cluster that computes the runs instead: its address, scheduler file, cluster object or client.
        progress: show a progress bar.
        resume: resume the same sweep in the folder; False: an existing sweep in the folder is an error.
        retry_failed: compute failed runs again. The keys of grid and solver may then differ from before; they become
            columns of the table.
        numbers: function of a finished run that returns numbers by the names of their columns, or several; they are
            called when all runs have ended. `brinell.sweeps.residual_stress` is one.

    Returns:
        The table, with access to the runs.

    Raises:
        InputError: an axis, the design or the case at some point is invalid (checked before the first run), or the
            folder holds another sweep.
        IoError: the folder cannot be written, another sweep is using it, or the cluster is lost.

    Warns:
        ResolutionWarning: runs have warnings: how many have which, see `Sweep.warnings`.
    """
    base = case if isinstance(case, Case) else Case.from_file(case)
    functions = functions_of(numbers)
    axes = _axes(over)
    points = points_of(axes, design, samples, seed)
    texts = _case_texts(base, points)
    if cluster is not None and workers is not None:
        raise InputError(f"workers = {workers} has no meaning with a cluster, which has its own")
    path = Path(output).absolute()
    record = {
        "format": "brinell-sweep",
        "format_version": FORMAT_VERSION,
        "runs": len(points),
        "design": design,
        "samples": samples,
        "seed": seed if design == "latin_hypercube" else None,
        "axes": {key: _axis_record(axis) for key, axis in axes.items()},
        "versions": _core.library_versions(),
        "case": base.to_toml(),
    }
    with locked(path):
        changed = start_folder(path, record, resume=resume, retry_failed=retry_failed)
        ledger = Ledger(path, points, texts, changed)
        missing = ledger.missing(retry_failed=retry_failed)
        try:
            if missing:
                pool = _pool(cluster, path, workers, threads, len(missing))
                tasks = [Task(i, texts[i], str(run_folder(path, i)), pool.threads) for i in missing]
                with contextlib.closing(pool), _bar(ledger, len(points), shown=progress) as bar:
                    _compute(tasks, pool, ledger, bar)
        except KeyboardInterrupt:
            done = f"{len(ledger)} of {len(points)} runs are done, those begun have a checkpoint"
            raise KeyboardInterrupt(f"interrupted; {done}, in {path}: the same call goes on") from None
        finally:
            if len(ledger) > 0:
                ledger.write()
        result = Sweep(path, ledger.table())
        if functions:
            result = result.with_numbers(*functions)
            write_table(path, result.table)
    _tell_warnings(result)
    return result


def _tell_warnings(result: Sweep) -> None:
    """Issues one warning for all runs that have warnings."""
    told = result.warnings
    if not told:
        return
    runs = len(set(itertools.chain.from_iterable(told.values())))
    each = ", ".join(f"{key} ({len(indices)})" for key, indices in told.items())
    text = f"{runs} of {len(result.runs)} runs have warnings: {each}; their texts are in the table, columns warnings.*"
    warnings.warn(text, ResolutionWarning, stacklevel=3)


def _axes(over: Mapping[str, Any]) -> dict[str, Axis]:
    axes: dict[str, Axis] = {}
    for name, given in over.items():
        try:
            axes[name] = axis_of(given)
        except InputError as error:
            raise InputError(f"{name}: {error}") from error
    return axes


def _axis_record(axis: Axis) -> dict[str, Any]:
    return {"values": list(axis.items)} if isinstance(axis, Choices) else asdict(axis)


def _case_texts(base: Case, points: list[Point]) -> list[str]:
    """Texts of the cases with all defaults; invalid cases raise an error before the first run."""
    texts = []
    table = table_of(base)
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always", CaseWarning)
        for index, point in enumerate(points):
            try:
                texts.append(base.with_values(with_whole_lists(point, table)).to_toml())
            except InputError as error:
                values = ", ".join(f"{key} = {value}" for key, value in point.items())
                raise InputError(f"run {index} ({values}): {error}") from error
    for text, category in dict.fromkeys((str(warning.message), warning.category) for warning in caught):
        warnings.warn(text, category, stacklevel=3)
    return texts


def _pool(cluster: Any, path: Path, workers: int | None, threads: int | None, runs: int) -> Pool:
    for name, value in (("workers", workers), ("threads", threads)):
        if value is not None and value < 1:
            raise InputError(f"{name} = {value}; allowed: 1 or more")
    if cluster is not None:
        return DaskPool(cluster, path / "stop", threads or 0)
    cores = len(os.sched_getaffinity(0))
    if workers is None:
        workers = max(1, cores // (threads or 1))
    workers = min(workers, runs)
    return LocalPool(workers, threads or max(1, cores // workers))


@contextlib.contextmanager
def _bar(ledger: Ledger, runs: int, *, shown: bool) -> Iterator[Any]:
    with tqdm(total=runs, initial=len(ledger), unit="run", disable=not shown) as bar:
        yield bar


def _compute(tasks: list[Task], pool: Pool, ledger: Ledger, bar: Any) -> None:
    waiting = deque(tasks)
    running: dict[Future[Outcome], Task] = {}
    losses: Counter[int] = Counter()

    def add(outcome: Outcome) -> None:
        ledger.add(outcome)
        bar.set_postfix(failed=ledger.failed, refresh=False)
        bar.update()

    try:
        while waiting or running:
            while waiting and pool.has_room:
                task = waiting.popleft()
                running[pool.submit(task)] = task
            done = wait(running, return_when=FIRST_COMPLETED).done
            for future in done:
                task = running.pop(future)
                outcome = _outcome(pool, future)
                if outcome is not None:
                    add(outcome)
                    continue
                losses[task.index] += 1
                if losses[task.index] < _MOST_LOSSES:
                    waiting.appendleft(task)
                else:
                    add(Outcome(task.index, "failed", reason=_lost_reason(_MOST_LOSSES)))
            for loss in pool.losses() if not bar.disable else ():
                bar.write(loss, file=sys.stderr)
    except KeyboardInterrupt:
        pool.stop()
        for future in as_completed(running):
            outcome = _outcome(pool, future)
            if outcome is not None:
                add(outcome)
        raise


def _outcome(pool: Pool, future: Future[Outcome]) -> Outcome | None:
    """Outcome of a run; None if its process died, or it was stopped by something else than this sweep."""
    try:
        outcome = pool.collect(future)
    except Lost:
        return None
    return outcome if outcome.status != "stopped" else None


def _lost_reason(times: int) -> str:
    return f"its process came to a sudden end {times} times: killed, or out of memory?"
