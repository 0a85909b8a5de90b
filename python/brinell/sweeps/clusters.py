# SPDX-License-Identifier: BSD-3-Clause
"""Workers of a Dask cluster, which exists or is started for a sweep by the name of its class."""

from __future__ import annotations

import contextlib
import importlib
import time
import uuid
from collections.abc import Iterable, Mapping, Sequence
from concurrent.futures import CancelledError, Future
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import Any

from brinell.errors import BrinellError, InputError, IoError, MissingExtraError
from brinell.sweeps.jobs import Jobs, is_jobqueue, submit_jobs
from brinell.sweeps.journal import Journal, JournalReader, attempts, journal_folder, outcome_of
from brinell.sweeps.loop import MOST_LOSSES, lost_reason
from brinell.sweeps.point import ONE_AT_A_TIME, Outcome, Task, compute
from brinell.sweeps.pools import Lost

__all__ = ["Cluster", "DaskPool", "compute_chunk"]

_MOST_IN_A_CHUNK = 100
"""So that a progress bar moves, and a lost worker delays little."""
_CHUNKS_PER_WORKER = 20
"""So that all workers end at about the same time, although runs take different times."""
_PATIENCE = 60.0
"""Time [s] without any worker after which the user is told."""


@dataclass(frozen=True)
class Cluster:
    """A Dask cluster that is started for a sweep and ends with it.

    Attributes:
        name: class of dask_jobqueue (SLURMCluster, PBSCluster, SGECluster, LSFCluster, ...) or of distributed
            (LocalCluster, SSHCluster), or MODULE:CLASS.
        options: arguments of the class, such as cores, memory, walltime, queue, job_extra_directives.
        jobs: number of jobs that are submitted; None: as the class decides.
        chunk: number of runs that a worker gets together; None: by the number of runs and workers.
    """

    name: str
    options: Mapping[str, Any] = field(default_factory=dict)
    jobs: int | None = None
    chunk: int | None = None

    @staticmethod
    def is_name(text: str) -> bool:
        """Whether a text is the name of a class and not an address or a file."""
        return text.rpartition(":")[2].isidentifier() and text.endswith("Cluster")

    def started(self) -> Any:
        """The cluster object.

        Raises:
            InputError: the class is not known, or refuses its arguments.
            MissingExtraError: the package of the class is not installed.
            IoError: the cluster cannot be started.
        """
        kind = self._class()
        options = dict(self.options)
        how_many = {"n": self.jobs}
        if is_queued := is_jobqueue(kind):
            # What the class does with it fails unnoticed.
            how_many = {"jobs": self.jobs} if self.jobs else {"n": options.pop("n_workers", None)}
            if not any(how_many.values()):
                raise InputError(f"cluster {self.name}: has no jobs; allowed: a number of them (jobs; --jobs 20)")
        try:
            cluster = kind(**options)
        except (TypeError, ValueError) as error:
            raise InputError(f"cluster {self.name}: its options are refused: {error}") from error
        except (OSError, RuntimeError) as error:
            raise IoError(f"cluster {self.name}: cannot be started: {error}") from error
        try:
            if is_queued:
                submit_jobs(cluster, how_many)
            elif self.jobs is not None:
                cluster.scale(**how_many)
        except (OSError, RuntimeError, ValueError) as error:
            with contextlib.suppress(AssertionError):  # Dask expects that its jobs have begun
                cluster.close()
            said = str(error).rpartition("stderr:")[2]  # of the command with which a job is submitted
            lines = [line.strip() for line in said.splitlines() if line.strip()]
            raise IoError(f"cluster {self.name}: its jobs are refused: {'; '.join(lines)}") from error
        return cluster

    def _class(self) -> Any:
        module, _, name = self.name.rpartition(":")
        if not module:
            module = "distributed" if name in ("LocalCluster", "SSHCluster") else "dask_jobqueue"
        try:
            found = getattr(importlib.import_module(module), name, None)
        except ModuleNotFoundError as error:
            if module in ("distributed", "dask_jobqueue"):
                missing = str(error.name)
                extra = "cluster" if missing.startswith("dask_jobqueue") else "sweep"
                raise MissingExtraError(f"the cluster {name}", missing.replace("_", "-"), extra) from error
            raise InputError(f"cluster {self.name}: there is no module {module}") from error
        if found is None:
            raise InputError(
                f"cluster {self.name}: {module} has no such class; allowed: a class of dask_jobqueue such as "
                "SLURMCluster, LocalCluster, MODULE:CLASS, or the address or scheduler file of a cluster that runs"
            )
        return found


class DaskPool:
    """Workers of a Dask cluster; the folder of the sweep must have the same path on all of them."""

    def __init__(self, cluster: Any, path: Path, threads: int, *, chunk: int | None = None):
        """Connects to the cluster.

        Args:
            cluster: address of a scheduler, path of a scheduler file, a `Cluster`, or a cluster or client object of
                Dask.
            path: folder of the sweep. Runs stop while its file `stop` exists.
            threads: number of threads of each run; 0: as many as its worker has.
            chunk: number of runs that go to a worker together; None: by the number of runs and workers.

        Raises:
            IoError: the cluster does not answer.
            InputError: the cluster cannot be started as it is described.
        """
        try:
            from distributed import Client
        except ModuleNotFoundError as error:
            raise MissingExtraError("a cluster", "distributed", "sweep") from error
        self.threads = threads
        self._chunk = chunk or (cluster.chunk if isinstance(cluster, Cluster) else None)
        self._path = path
        self._stop_file = path / "stop"
        self._stop_file.unlink(missing_ok=True)
        self._is_mine = not isinstance(cluster, Client)
        self._started = cluster.started() if isinstance(cluster, Cluster) else None
        self._jobs = None if self._started is None else Jobs(self._started)
        try:
            if not self._is_mine:
                self._client = cluster
            elif isinstance(cluster, str) and Path(cluster).is_file():
                self._client = Client(scheduler_file=cluster)
            else:
                self._client = Client(cluster if self._started is None else self._started)
        except (OSError, TimeoutError, ValueError) as error:
            raise IoError(f"the Dask cluster {cluster!r} does not answer: {error}") from error
        self._executor = self._client.get_executor(pure=False)
        self._submitted: dict[Future[list[Outcome]], tuple[list[Task], Path]] = {}
        self._workers: dict[str, str] = self._names()
        self._token = uuid.uuid4().hex[:8]
        self._count = 0
        self._messages: list[str] = []
        self._alone_since = time.monotonic()
        self._patience = _PATIENCE

    @property
    def has_room(self) -> bool:
        """Always true: the scheduler queues tasks, and an adaptive cluster grows with them."""
        return True

    def chunks(self, tasks: Sequence[Task]) -> list[list[Task]]:
        """Portions of several runs, if they are many: a scheduler takes milliseconds for each portion."""
        size = self._chunk or min(
            max(1, len(tasks) // (_CHUNKS_PER_WORKER * max(1, len(self._workers)))), _MOST_IN_A_CHUNK
        )
        return [list(tasks[i : i + size]) for i in range(0, len(tasks), size)]

    def submit(self, chunk: Sequence[Task]) -> Future[list[Outcome]]:
        """Gives the tasks to the scheduler, which repeats them on another worker if their own is lost."""
        self._count += 1
        file = journal_folder(self._path) / f"cluster-{self._token}-{self._count:06d}.jsonl"
        future: Future[list[Outcome]] = self._executor.submit(
            compute_chunk, list(chunk), str(file), str(self._stop_file)
        )
        self._submitted[future] = (list(chunk), file)
        return future

    def collect(self, future: Future[list[Outcome]]) -> list[Outcome]:
        """Outcomes of a finished portion.

        Raises:
            Lost: several workers died in the midst; what they have computed is kept.
            IoError: the cluster is lost, or a worker cannot write to the folder.
        """
        from distributed import KilledWorker

        _, file = self._submitted.pop(future)
        try:
            outcomes = future.result()
        except KilledWorker as error:
            entries = list(JournalReader(file.parent).entries_of(file))
            outcomes = [outcome_of(entry) for entry in entries if "index" in entry]
            self._tell_attempts(entries)
            raise Lost(outcomes) from error
        except CancelledError as error:
            raise IoError("the Dask cluster is lost; the same sweep goes on with what is missing") from error
        except IoError as error:
            raise IoError(f"a worker of the cluster: {error}; is the folder the same on all machines?") from error
        except Exception as error:  # not an error of the run, which would be in its outcome
            raise BrinellError(f"a worker of the cluster cannot compute; has it the same brinell? {error}") from error
        return outcomes

    def _tell_attempts(self, entries: Iterable[Mapping[str, Any]]) -> None:
        for index in attempts(entries):
            self._messages.append(f"run {index}: its worker died; the run is computed again")

    def losses(self) -> list[str]:
        """Messages about workers that have left the cluster: killed, out of memory, or retired by the scheduler."""
        before, self._workers = self._workers, self._names()
        told, self._messages = self._messages, []
        if self._workers:
            self._alone_since, self._patience = time.monotonic(), _PATIENCE
        elif (waited := time.monotonic() - self._alone_since) >= self._patience:
            self._patience *= 4
            told.append(
                f"no worker of the cluster for {waited:.0f} s; the sweep waits for one: are its jobs in the queue?"
            )
        left = sorted(before.keys() - self._workers.keys())
        told += [f"the worker {one} has left; its run goes to another one" for one in left]
        return told + (self._jobs.renewed(self._workers.values()) if self._jobs is not None else [])

    def _names(self) -> dict[str, str]:
        """Names of the workers by their addresses."""
        workers = self._client.scheduler_info(n_workers=-1)["workers"]
        return {address: str(worker["name"]) for address, worker in workers.items()}

    def stop(self) -> None:
        """Requests all runs to stop after their current step; runs that have not started return at once."""
        self._stop_file.touch()

    def close(self) -> None:
        """Disconnects from the cluster; after an error the remaining runs are stopped."""
        if self._submitted:
            self.stop()
            self._executor.shutdown(wait=False)
        else:
            self._stop_file.unlink(missing_ok=True)
        if self._is_mine:
            self._client.close()
        if self._jobs is not None:
            self._jobs.close()
        if self._started is not None:
            self._started.close()


def compute_chunk(tasks: Sequence[Task], journal_file: str, stop_file: str) -> list[Outcome]:
    """Computes runs one after the other in a worker of a cluster.

    The journal has what an earlier worker that was lost has done of them; a run that has taken several workers with it
    has failed.

    Raises:
        IoError: the folder of the sweep is not there, or cannot be written.
    """
    from distributed import get_worker

    file, stop = Path(journal_file), Path(stop_file)
    if not stop.parent.is_dir():
        raise IoError(f"{stop.parent}: is not there on this machine")
    journal = Journal(file)
    entries = list(JournalReader(file.parent).entries_of(file))
    earlier = {entry["index"]: outcome_of(entry) for entry in entries if "index" in entry}
    begun = attempts(entries)
    outcomes = []
    for task in tasks:
        if task.index in earlier:
            outcomes.append(earlier[task.index])
            continue
        with ONE_AT_A_TIME:  # so that a run that waits for another one has not begun
            if begun[task.index] >= MOST_LOSSES:
                outcome = Outcome(task.index, "failed", reason=lost_reason(MOST_LOSSES))
            else:
                journal.begun(task)
                threads = task.threads or get_worker().state.nthreads
                outcome = compute(replace(task, threads=threads), stop.exists)
            if outcome.status == "stopped":
                journal.stopped(task)
            else:
                journal.add(outcome, task.text)
        outcomes.append(outcome)
    return outcomes
