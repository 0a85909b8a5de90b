# SPDX-License-Identifier: BSD-3-Clause
"""The loop that keeps a pool busy until each run has an outcome; a run whose process dies is computed again."""

from __future__ import annotations

from collections import Counter, deque
from collections.abc import Callable, Sequence
from concurrent.futures import FIRST_COMPLETED, Future, as_completed, wait
from typing import Protocol

from brinell.sweeps.point import Outcome, Task
from brinell.sweeps.pools import Lost, Pool

__all__ = ["MOST_LOSSES", "Notes", "compute_all", "lost_reason"]

MOST_LOSSES = 3
"""Number of times that the process of a run may die before the run counts as failed."""
_PAUSE = 10.0
"""Time [s] after which a pool may tell something although no run has ended."""


class Notes(Protocol):
    """Where is noted what becomes of the runs."""

    def begun(self, task: Task) -> None:
        """Notes that a run begins."""

    def stopped(self, task: Task) -> None:
        """Notes that a run was stopped on request."""

    def lost(self, task: Task, what: str) -> None:
        """Notes that the process of a run died."""

    def add(self, outcome: Outcome, text: str) -> None:
        """Notes the outcome of a finished or failed run of the case `text`."""


def compute_all(tasks: Sequence[Task], pool: Pool, notes: Notes, tell: Callable[[str], object]) -> None:
    """Computes runs.

    Args:
        tasks: the runs.
        pool: pool that computes them.
        notes: where their outcomes go.
        tell: function that tells the user of processes or workers that have died.

    Raises:
        KeyboardInterrupt: as it came, when the runs that were under way have stopped.
    """
    waiting = deque(pool.chunks(tasks))
    running: dict[Future[list[Outcome]], list[Task]] = {}
    losses: Counter[int] = Counter()

    def settle(future: Future[list[Outcome]]) -> list[Task]:
        """Notes the outcomes of a chunk; returns its runs that have none."""
        chunk = running.pop(future)
        found = {outcome.index: outcome for outcome in _outcomes(pool, future)}
        for task in chunk:
            if task.index in found and found[task.index].status != "stopped":
                notes.add(found[task.index], task.text)
        return [task for task in chunk if task.index not in found or found[task.index].status == "stopped"]

    try:
        while waiting or running:
            while waiting and pool.has_room:
                chunk = waiting.popleft()
                for task in chunk:
                    notes.begun(task)
                running[pool.submit(chunk)] = chunk
            for future in wait(running, timeout=_PAUSE, return_when=FIRST_COMPLETED).done:
                chunk = running[future]
                left = settle(future)
                if len(chunk) > 1 and len(left) < len(chunk):  # it goes on: the next one begins anew
                    losses.subtract({task.index: losses[task.index] for task in left})
                again = [task for task in left if not _is_given_up(task, losses, notes)]
                if again:
                    waiting.appendleft(again)
            for loss in pool.losses():
                tell(loss)
    except KeyboardInterrupt:
        pool.stop()
        for future in as_completed(list(running)):
            for task in settle(future):
                notes.stopped(task)
        raise


def _outcomes(pool: Pool, future: Future[list[Outcome]]) -> list[Outcome]:
    """Outcomes of a chunk; none of those runs whose process has died."""
    try:
        return pool.collect(future)
    except Lost as lost:
        return lost.outcomes


def _is_given_up(task: Task, losses: Counter[int], notes: Notes) -> bool:
    """Whether a run has now lost its process, or was stopped by something else than its sweep, too often."""
    losses[task.index] += 1
    if losses[task.index] < MOST_LOSSES:
        notes.lost(task, lost_reason(losses[task.index]))
        return False
    notes.add(Outcome(task.index, "failed", reason=lost_reason(MOST_LOSSES)), task.text)
    return True


def lost_reason(times: int) -> str:
    """Reason of the failure of a run whose process died again and again."""
    often = "once" if times == 1 else "twice" if times == 2 else f"{times} times"
    return f"its process came to a sudden end {often}: killed, or out of memory?"
