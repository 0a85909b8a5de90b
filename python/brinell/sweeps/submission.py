# SPDX-License-Identifier: BSD-3-Clause
"""The runs of a sweep by job arrays of Slurm: submitted, awaited, and what is lost submitted again."""

from __future__ import annotations

import time
from collections import Counter
from collections.abc import Callable, Mapping, Sequence
from pathlib import Path
from typing import Any

from brinell.sweeps import slurm
from brinell.sweeps.arrays import Array, arrays_of, chunks_of, submit
from brinell.sweeps.journal import attempts
from brinell.sweeps.ledger import Ledger
from brinell.sweeps.loop import MOST_LOSSES
from brinell.sweeps.point import Outcome, Task
from brinell.sweeps.slurm import Slurm, TaskState
from brinell.sweeps.task import EXIT_CODES

__all__ = ["SlurmRuns"]

_FORGOTTEN = TaskState("UNKNOWN", reason="Slurm does not know its end")
_NO_LOG = "0:53"
"""Exit code of a task whose log Slurm could not open."""
_LONGEST_PAUSE = 15.0
"""Longest time between two questions to Slurm [s]; a scheduler serves many users."""
_MOST_TOLD = 10
"""Number of tasks that are named in a message."""


class SlurmRuns:
    """The job arrays of a sweep."""

    def __init__(self, path: Path, wanted: Slurm, ledger: Ledger, bar: Any, tell: Callable[[str], object]):
        """Finds arrays of an earlier call that still compute.

        Args:
            path: folder of the sweep.
            wanted: how runs are submitted.
            ledger: where their outcomes go.
            bar: progress bar.
            tell: function that tells the user what happens.

        Raises:
            IoError: there is no Slurm, or it does not answer.
        """
        self._path = path
        self._wanted = wanted
        self._ledger = ledger
        self._bar = bar
        self._tell = tell
        self._losses: Counter[int] = Counter()
        self._begun: list[Mapping[str, Any]] = []
        self._left_out: dict[int, str] = {}
        self.arrays = self._running()
        self.problems: list[str] = []
        """What the user must do something about: tasks that were cancelled, or cannot compute."""

    def _running(self) -> list[Array]:
        found = []
        for array in arrays_of(self._path):
            states = slurm.task_states(array.job)
            if states is not None and all(state.has_ended for state in states.values()):
                array.close(is_complete=False)
            else:
                found.append(array)
        return found

    def compute(self, tasks: Sequence[Task]) -> None:
        """Computes runs; those of arrays that are computing already are not submitted again.

        Raises:
            InputError: Slurm refuses the options.
            IoError: a file cannot be written, or Slurm does not answer.
        """
        if self.arrays:
            self._tell(f"job {self._jobs()} of an earlier call still computes")
        self._take()
        while True:
            if not self._wanted.wait and self.arrays:
                self._take()
                return
            for array in self.arrays:
                self._judge(array, self._ends_of(array))
            self.arrays = []
            missing = [task for task in tasks if task.index not in self._ledger and task.index not in self._left_out]
            if not missing:
                break
            self._submit(missing)
        for text in dict.fromkeys(self._left_out.values()):
            self.problems.append(text)

    def _jobs(self) -> str:
        return ", ".join(array.job for array in self.arrays)

    def _submit(self, tasks: Sequence[Task]) -> None:
        largest = slurm.largest_array()
        chunks = chunks_of(tasks, self._wanted, largest)
        size = len(chunks[0])
        if self._wanted.chunk is not None and size > self._wanted.chunk:
            self._tell(f"{size} runs a task instead of {self._wanted.chunk}: an array has at most {largest} tasks here")
        self.arrays = [submit(self._path, self._wanted, chunks)]
        self._tell(f"job {self._jobs()} of Slurm: {len(tasks)} runs in {len(chunks)} tasks")

    def _ends_of(self, array: Array) -> dict[int, TaskState]:
        """Waits until an array has ended; returns what Slurm says of its tasks."""
        known: dict[int, TaskState] = {}
        began, answers = time.monotonic(), True
        while True:
            states = slurm.task_states(array.job)
            self._take()
            if states is None:
                if answers:
                    self._tell("Slurm does not answer; the sweep waits for it")
                answers = False
            else:
                answers = True
                known |= states
                for number in known.keys() - states.keys():
                    if not known[number].has_ended:
                        known[number] = _FORGOTTEN
                if all(state.has_ended for state in states.values()):
                    break
                count = Counter(state.state.lower() for state in states.values() if not state.has_ended)
                self._bar.set_postfix_str(", ".join(f"{n} tasks {state}" for state, n in count.items()))
            time.sleep(min(_LONGEST_PAUSE, max(0.5, (time.monotonic() - began) / 20)))
        for _ in range(5):  # a network file system may be late
            silent = [i for i, state in known.items() if state.state == "COMPLETED" and self._missing(array, i)]
            if not silent:
                break
            time.sleep(1.0)
            self._take()
        return known

    def _take(self) -> None:
        new, entries = self._ledger.take_new()
        self._begun += [entry for entry in entries if not {"begun", "stopped", "index"}.isdisjoint(entry)]
        for entry in entries:
            if "lost" in entry:
                self._tell(f"run {entry['lost']}: {entry['what']} It is computed again")
        self._bar.update(len(new))

    def _missing(self, array: Array, number: int) -> list[int]:
        return [index for index in array.chunks[number] if index not in self._ledger]

    def _judge(self, array: Array, states: Mapping[int, TaskState]) -> None:
        """Decides on the runs of tasks that have ended without an outcome for them."""
        begun = attempts(self._begun)
        ends: dict[str, list[tuple[int, list[int]]]] = {}
        for number in range(len(array.chunks)):
            missing = self._missing(array, number)
            if not missing:
                continue
            state = states.get(number, _FORGOTTEN)
            if (final := _final(state)) is not None:
                log = array.log(number)
                ends.setdefault(f"{final}{f' ({log})' if log else ''}", []).append((number, missing))
                continue
            self._tell(f"task {number} of job {array.job}: {state}: {_runs(missing)} computed again")
            self._lose([index for index in missing if begun[index]] or missing, state)
        for text, tasks in ends.items():
            which = ", ".join(str(number) for number, _ in tasks[:_MOST_TOLD])
            more = f" and {len(tasks) - _MOST_TOLD} more" if len(tasks) > _MOST_TOLD else ""
            runs = [index for _, missing in tasks for index in missing]
            whole = (
                f"task{'s' if len(tasks) > 1 else ''} {which}{more} of job {array.job}: {text}: {_runs(runs)} missing"
            )
            self._left_out |= dict.fromkeys(runs, whole)
        self._begun = []
        array.close(is_complete=not any(self._missing(array, i) for i in range(len(array.chunks))))

    def _lose(self, indices: Sequence[int], state: TaskState) -> None:
        for index in indices:
            self._losses[index] += 1
            if self._losses[index] >= MOST_LOSSES:
                reason = f"its task came to an end {MOST_LOSSES} times: {state}"
                self._ledger.add(Outcome(index, "failed", reason=reason), "")
                self._bar.update()


def _final(state: TaskState) -> str | None:
    """Why a task is not submitted again; None if it is."""
    code = state.exit_code.partition(":")[0]
    if state.state == "CANCELLED":
        return "was cancelled"
    if code.isdecimal() and int(code) in EXIT_CODES:
        return EXIT_CODES[int(code)]
    if state.exit_code == _NO_LOG:
        return f"Slurm could not write its log on {state.node}: is the folder of the sweep shared, and is there room?"
    return None


def _runs(indices: Sequence[int]) -> str:
    """Names of runs, in ranges: "runs 3, 5-8 are"."""
    if len(indices) == 1:
        return f"run {indices[0]} is"
    ranges: list[list[int]] = []
    for index in sorted(indices):
        if ranges and ranges[-1][1] == index - 1:
            ranges[-1][1] = index
        else:
            ranges.append([index, index])
    texts = [str(first) if first == last else f"{first}-{last}" for first, last in ranges]
    more = f" and {len(texts) - _MOST_TOLD} more ranges" if len(texts) > _MOST_TOLD else ""
    return f"runs {', '.join(texts[:_MOST_TOLD])}{more} are"
