# SPDX-License-Identifier: BSD-3-Clause
"""The function `sweep`: checks, computation of the runs, and the table of results."""

from __future__ import annotations

import contextlib
import itertools
import os
import sys
import warnings
from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import asdict
from pathlib import Path
from typing import Any, Literal

from tqdm.auto import tqdm

from brinell import _core
from brinell.case import Case, CaseWarning, ResolutionWarning
from brinell.errors import InputError, IoError
from brinell.sweeps.arrays import array_script, chunks_of, refuse_running
from brinell.sweeps.axes import Axis, Choices, axis_of
from brinell.sweeps.clusters import Cluster, DaskPool
from brinell.sweeps.designs import Design, Point, points_of
from brinell.sweeps.folder import FORMAT_VERSION, locked, run_folder, start_folder, write_table
from brinell.sweeps.journal import Journal, journal_folder
from brinell.sweeps.kept import kept_of
from brinell.sweeps.ledger import Ledger
from brinell.sweeps.lists import table_of, with_whole_lists
from brinell.sweeps.loop import compute_all
from brinell.sweeps.numbers import Numbers, functions_of, packed, with_numbers
from brinell.sweeps.point import Outcome, Task
from brinell.sweeps.pools import LocalPool, Pool
from brinell.sweeps.result import Sweep
from brinell.sweeps.slurm import Slurm, largest_array
from brinell.sweeps.submission import SlurmRuns

__all__ = ["case_texts", "dry_run", "sweep"]


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
    submit: Slurm | Literal["slurm"] | None = None,
    chunk: int | None = None,
    keep: str | Iterable[int] | None = None,
    progress: bool = True,
    resume: bool = True,
    retry_failed: bool = False,
    numbers: Numbers | str | Iterable[Numbers | str] | None = None,
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
        cluster: Dask cluster that computes the runs instead: its address, scheduler file, cluster object or client, or
            a `Cluster` or the name of its class, which is then started: "SLURMCluster" of dask_jobqueue.
        submit: "slurm" or a `Slurm`: compute the runs by a job array of Slurm, and wait for it. Ctrl-C leaves the array
            in peace; the next call finds it.
        chunk: number of runs that a worker of the Dask cluster gets together; None: by the number of runs and workers.
        keep: which runs write folders: "all", "none", or indices, also as text "0,10-19". Other runs are computed in
            memory and leave their row of the table. None: all, with `submit` none.
        progress: show a progress bar.
        resume: resume the same sweep in the folder; False: an existing sweep in the folder is an error.
        retry_failed: compute failed runs again. The keys of grid and solver may then differ from before; they become
            columns of the table.
        numbers: function of a finished run that returns numbers by the names of their columns, or several; they are
            called when all runs have ended, those of a run without a folder right after it, in its process.
            `brinell.sweeps.residual_stress` is one; text stands for a function as on the command line.

    Returns:
        The table, with access to the runs.

    Raises:
        InputError: an axis, the design or the case at some point is invalid (checked before the first run), or the
            folder holds another sweep.
        IoError: the folder cannot be written, another sweep is using it, or the cluster is lost; or tasks of a job
            array were cancelled, or cannot compute: the text names them and their runs.

    Warns:
        ResolutionWarning: runs have warnings: how many have which, see `Sweep.warnings`.
    """
    base = case if isinstance(case, Case) else Case.from_file(case)
    functions = functions_of(numbers)
    axes = _axes(over)
    points = points_of(axes, design, samples, seed)
    texts = case_texts(base, points)
    wanted = _wanted(cluster, submit, workers, chunk)
    kept = kept_of(keep, len(points), otherwise="all" if wanted is None else "none")
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
        ledger = Ledger(path, points, texts, changed, kept=kept)
        of_workers = packed(functions) if len(kept) < len(points) else ()

        def task_of(index: int, threads: int) -> Task:
            own = () if index in kept else of_workers
            return Task(index, texts[index], str(run_folder(path, index)), threads, index in kept, own)

        problems: list[str] = []
        try:
            with _bar(ledger, len(points), shown=progress) as bar:
                if wanted is not None:
                    problems = _submit(wanted, path, ledger, bar, lambda i: task_of(i, threads or 0), retry_failed)
                else:
                    refuse_running(path)
                    if missing := ledger.missing(retry_failed=retry_failed):
                        ledger.tidy_journals()
                        bar.n = len(ledger)
                        pool = _pool(cluster, path, workers, threads, len(missing), chunk)
                        if isinstance(pool, LocalPool):
                            ledger.journal = Journal(journal_folder(path) / "runs.jsonl")
                        notes = _Shown(ledger, bar)
                        with contextlib.closing(pool):
                            compute_all([task_of(i, pool.threads) for i in missing], pool, notes, _teller(bar))
        except KeyboardInterrupt as interrupt:
            done = f"{len(ledger)} of {len(points)} runs are done, those begun have a checkpoint"
            how = str(interrupt) or f"interrupted; {done}, in {path}: the same call goes on"
            raise KeyboardInterrupt(how) from None
        finally:
            if len(ledger) > 0:
                ledger.write()
        if not ledger.is_awaited:
            ledger.tidy_journals()
        awaited = len(points) - len(ledger) if ledger.is_awaited else 0
        result = Sweep(path, ledger.table(), awaited)
        if functions and len(result.table) > 0 and not awaited:
            table = with_numbers(result.table, result.runs, functions, ledger.numbers)
            result = Sweep(path, table, awaited)
            write_table(path, result.table)
    _tell_warnings(result)
    if problems:
        raise IoError(f"{path}: {'; '.join(problems)}. The same sweep computes them")
    return result


def dry_run(
    case: Case,
    over: Mapping[str, Any],
    *,
    output: str | Path,
    submit: Slurm | None,
    design: Design = "grid",
    samples: int | None = None,
    seed: int = 0,
) -> str:
    """What a sweep would do: number of runs, and the script of its first job array. All cases are checked.

    Raises:
        InputError: as of `sweep`.
        IoError: there is no Slurm, or it does not answer.
    """
    points = points_of(_axes(over), design, samples, seed)
    texts = case_texts(case, points)
    path = Path(output).absolute()
    if submit is None:
        return f"{len(points)} runs; all cases are valid"
    tasks = [Task(i, texts[i], str(run_folder(path, i)), 0) for i in range(len(points))]
    chunks = chunks_of(tasks, submit, largest_array())
    return f"# {len(points)} runs in {len(chunks)} tasks of {len(chunks[0])}\n{array_script(path, submit, len(chunks))}"


def _tell_warnings(result: Sweep) -> None:
    """Issues one warning for all runs that have warnings."""
    told = result.warnings
    if not told:
        return
    runs = len(set(itertools.chain.from_iterable(told.values())))
    each = ", ".join(f"{key} ({len(indices)})" for key, indices in told.items())
    text = f"{runs} of {result.done} runs have warnings: {each}; their texts are in the table, columns warnings.*"
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


def case_texts(base: Case, points: list[Point]) -> list[str]:
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


def _wanted(cluster: Any, submit: object, workers: int | None, chunk: int | None) -> Slurm | None:
    """How runs are submitted to a batch system, if they are."""
    wanted = Slurm() if submit == "slurm" else submit
    if wanted is not None and not isinstance(wanted, Slurm):
        raise InputError(f"submit = {submit!r}; allowed: 'slurm', or a brinell.sweeps.Slurm")
    if wanted is not None and cluster is not None:
        raise InputError("submit and cluster stand for two ways to compute; allowed: one of both")
    if workers is not None and (cluster is not None or wanted is not None):
        what = "a cluster" if wanted is None else "a job array"
        raise InputError(f"workers = {workers} has no meaning with {what}, which has its own")
    if chunk is not None and (cluster is None or chunk < 1):
        raise InputError(f"chunk = {chunk}; allowed: 1 or more, with a Dask cluster; a `Slurm` has its own")
    return wanted


def _submit(
    wanted: Slurm, path: Path, ledger: Ledger, bar: Any, task_of: Callable[[int], Task], retry_failed: bool
) -> list[str]:
    """Computes runs by job arrays; returns what the user must do something about."""
    arrays = SlurmRuns(path, wanted, ledger, bar, _teller(bar))
    ledger.is_awaited = bool(arrays.arrays)
    if retry_failed and arrays.arrays:
        raise IoError(f"{path}: job {arrays.arrays[0].job} still computes; failed runs are retried when it has ended")
    missing = ledger.missing(retry_failed=retry_failed)
    bar.n = len(ledger)
    if not arrays.arrays:
        ledger.tidy_journals()
    try:
        arrays.compute([task_of(index) for index in missing])
    except KeyboardInterrupt:
        if not arrays.arrays:
            raise
        job = arrays.arrays[0].job
        raise KeyboardInterrupt(
            f"interrupted; job {job} of Slurm goes on: the same call collects what it does, 'scancel {job}' ends it"
        ) from None
    finally:
        ledger.is_awaited = bool(arrays.arrays)
    return arrays.problems


def _pool(cluster: Any, path: Path, workers: int | None, threads: int | None, runs: int, chunk: int | None) -> Pool:
    for name, value in (("workers", workers), ("threads", threads)):
        if value is not None and value < 1:
            raise InputError(f"{name} = {value}; allowed: 1 or more")
    if cluster is not None:
        if isinstance(cluster, str) and Cluster.is_name(cluster) and not Path(cluster).exists():
            cluster = Cluster(cluster)
        return DaskPool(cluster, path, threads or 0, chunk=chunk)
    cores = len(os.sched_getaffinity(0))
    if workers is None:
        workers = max(1, cores // (threads or 1))
    workers = min(workers, runs)
    return LocalPool(workers, threads or max(1, cores // workers))


class _Shown:
    """A ledger whose outcomes move a progress bar."""

    def __init__(self, ledger: Ledger, bar: Any):
        self._ledger = ledger
        self._bar = bar
        self.begun, self.stopped, self.lost = ledger.begun, ledger.stopped, ledger.lost

    def add(self, outcome: Outcome, text: str) -> None:
        """Adds an outcome to both."""
        self._ledger.add(outcome, text)
        self._bar.set_postfix(failed=self._ledger.failed, refresh=False)
        self._bar.update()


def _teller(bar: Any) -> Callable[[str], None]:
    """Function that tells the user something beside the progress bar, if that is shown."""

    def tell(message: str) -> None:
        if not bar.disable:
            bar.write(message, file=sys.stderr)

    return tell


@contextlib.contextmanager
def _bar(ledger: Ledger, runs: int, *, shown: bool) -> Iterator[Any]:
    with tqdm(total=runs, initial=len(ledger), unit="run", disable=not shown) as bar:
        yield bar
