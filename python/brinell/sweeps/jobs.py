# SPDX-License-Identifier: BSD-3-Clause
"""Jobs and processes of a Dask cluster that a sweep starts: a refusal is told, those that end are replaced."""

from __future__ import annotations

import contextlib
import gc
import logging
import time
from collections.abc import Iterable, Mapping
from typing import Any

__all__ = ["Jobs", "is_jobqueue", "submit_jobs"]

_PATIENCE = 60.0
"""Time [s] without a worker after which a job has ended. A worker that has died is started again within it, unless the
machine is very busy."""


def is_jobqueue(kind: type) -> bool:
    """Whether this is a class of clusters of dask_jobqueue."""
    return any(base.__name__ == "JobQueueCluster" for base in kind.__mro__)


def submit_jobs(cluster: Any, how_many: Mapping[str, Any]) -> None:
    """Submits jobs and waits until the batch system has taken them; `scale` alone leaves a refusal to a log.

    Raises:
        RuntimeError: the batch system refuses the jobs; the text has what it says.
    """

    async def submitted() -> None:
        cluster.scale(**how_many)
        await cluster._correct_state()

    logs = [logging.getLogger(name) for name in ("asyncio", "tornado.application")]
    before = [log.disabled for log in logs]
    for log in logs:  # in which the same refusal stands with pages of tracebacks
        log.disabled = True
    try:
        cluster.sync(submitted)
    finally:
        gc.collect()  # of what has failed, which may want to tell it
        for log, was_disabled in zip(logs, before, strict=True):
            log.disabled = was_disabled


class Jobs:
    """The jobs of a cluster that a sweep has started, or the processes of one on this machine.

    Dask does not submit another job if one comes to its end, by its time limit or since its node is lost; the sweep
    would wait for ever. Also, a quarter of a minute after a worker has died, Dask ends its job if the worker is not
    there at that moment, although it may just be starting again.
    """

    def __init__(self, cluster: Any):
        """Lets Dask wait longer for workers.

        Args:
            cluster: a cluster of Dask. One that does not list its jobs looks after them itself.
        """
        import dask

        self._cluster = cluster
        self._are_listed = all(hasattr(cluster, name) for name in ("workers", "worker_spec", "scale"))
        self._seen: dict[Any, float] = {}
        # Those that have just been asked for may be on their way.
        self._renewed: dict[Any, float] = dict.fromkeys(getattr(cluster, "worker_spec", ()), time.monotonic())
        self._settings = contextlib.ExitStack()
        self._settings.enter_context(dask.config.set({"distributed.deploy.lost-worker-timeout": f"{_PATIENCE:g}s"}))

    def renewed(self, workers: Iterable[str]) -> list[str]:
        """Submits jobs in place of those that have ended; one that has not begun yet stays in the queue.

        Args:
            workers: names of the workers that are there.

        Returns:
            Messages about it.
        """
        if not self._are_listed:
            return []
        names, now = list(workers), time.monotonic()
        for job in list(self._cluster.workers):
            # A worker is called like its job, with a number if the job has several.
            if any(name == str(job) or name.startswith(f"{job}-") for name in names):
                self._seen[job] = now
            elif now - self._seen.get(job, now) > _PATIENCE:
                del self._seen[job]
                self._cluster.sync(self._cluster.workers.pop(job).close)
        ended = [job for job in self._cluster.worker_spec if job not in self._cluster.workers]
        ended = [job for job in ended if now - self._renewed.get(job, now) > _PATIENCE]
        if ended:
            number = len(self._cluster.worker_spec)
            self._cluster.scale(**({"jobs": number} if is_jobqueue(type(self._cluster)) else {"n": number}))
            self._renewed |= dict.fromkeys(ended, now)
        return [f"the job {job} of the cluster has ended; another one is started" for job in ended]

    def close(self) -> None:
        """Restores the settings of Dask."""
        self._settings.close()
