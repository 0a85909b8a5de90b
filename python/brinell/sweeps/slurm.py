# SPDX-License-Identifier: BSD-3-Clause
"""Slurm as a sweep needs it: the script of a job array, its submission, and the states of its tasks."""

from __future__ import annotations

import re
import shlex
import subprocess
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path

from brinell.errors import InputError, IoError

__all__ = ["ENDED", "Slurm", "TaskState", "job_named", "largest_array", "script", "submitted", "task_states"]

ENDED = frozenset(
    ("COMPLETED", "CANCELLED", "FAILED", "TIMEOUT", "NODE_FAIL", "OUT_OF_MEMORY", "BOOT_FAIL", "DEADLINE", "PREEMPTED")
)
"""States from which a task does not go on; a task that Slurm repeats is pending again."""
_OURS = {
    "array": "at_once limits how many tasks compute at a time, chunk how many runs a task has",
    "output": "logs are in the folder of the sweep",
    "error": "logs are in the folder of the sweep",
    "chdir": "tasks work in the folder of the sweep",
    "wrap": "the sweep writes the script",
    "parsable": "the sweep reads what sbatch prints",
    "job-name": "by its name the sweep finds the job again",
    "wait": "the sweep waits itself, unless it is told not to",
    "test-only": "a dry run prints the script",
}
_SHORT = {"a": "array", "o": "output", "e": "error", "D": "chdir", "J": "job-name", "W": "wait"}
_PATIENCE = 60.0
"""Time [s] in which a command of Slurm answers."""


@dataclass(frozen=True)
class Slurm:
    """How a sweep is computed by a job array of Slurm.

    Attributes:
        options: what the site wants sbatch to be told, as text or words, such as ``--partition=short``.
        preamble: lines of the shell in front of the runs, such as ``module load python``.
        chunk: number of runs of a task; None: such that there are 200 tasks or fewer.
        at_once: largest number of tasks that compute at a time; None: as Slurm decides.
        wait: wait until all tasks have ended. False: submit, or collect what is done, and return.
    """

    options: str | Sequence[str] = ()
    preamble: str | Sequence[str] = ()
    chunk: int | None = None
    at_once: int | None = None
    wait: bool = True

    def __post_init__(self) -> None:
        for name, value in (("chunk", self.chunk), ("at_once", self.at_once)):
            if value is not None and value < 1:
                raise InputError(f"slurm: {name} = {value}; allowed: 1 or more")
        for word in self.words():
            name = re.split(r"[=\s]", word.lstrip("-"), maxsplit=1)[0]
            name = name if word.startswith("--") else _SHORT.get(word[1:2], "")
            if word.startswith("-") and name in _OURS:
                raise InputError(f"slurm: the option {word} is the sweep's own: {_OURS[name]}")

    def words(self) -> list[str]:
        """The options as words, each with its value: "--time=10", "-p short"."""
        words = _words_of(self.options)
        found: list[str] = []
        for word in words:
            if word.startswith("-"):
                found.append(word)
            elif found and "=" not in found[-1] and " " not in found[-1]:
                found[-1] += f" {shlex.quote(word)}"
            else:
                raise InputError(f"slurm: {word!r} is no option of sbatch; allowed: words such as --partition=short")
        return found

    def lines(self) -> list[str]:
        """Lines of the preamble."""
        given = [self.preamble] if isinstance(self.preamble, str) else self.preamble
        return [line for text in given for line in text.splitlines()]


def _words_of(options: str | Sequence[str]) -> list[str]:
    try:
        return [word for text in ([options] if isinstance(options, str) else options) for word in shlex.split(text)]
    except ValueError as error:
        raise InputError(f"slurm: the options {options!r} cannot be read: {error}") from error


@dataclass(frozen=True)
class TaskState:
    """What Slurm says of a task."""

    state: str
    """PENDING, RUNNING, COMPLETED, FAILED, ...; UNKNOWN if Slurm has forgotten it."""
    exit_code: str = ""
    """As Slurm writes it, CODE:SIGNAL."""
    reason: str = ""
    node: str = ""

    @property
    def has_ended(self) -> bool:
        """Whether the task does not go on."""
        return self.state in ENDED

    def __str__(self) -> str:
        code, _, number = self.exit_code.partition(":")
        how = [f"exit code {code}"] if code not in ("", "0") else []
        how += [f"signal {number}"] if number not in ("", "0") else []
        how += [self.reason] if self.reason not in ("", "None", "NonZeroExitCode") else []
        how += [f"on {self.node}"] if self.node not in ("", "(null)") else []
        return f"{self.state} ({', '.join(how)})" if how else self.state


def script(slurm: Slurm, *, name: str, tasks: int, folder: Path, command: Sequence[str]) -> str:
    """Script of a job array.

    Args:
        slurm: options.
        name: name of the job.
        tasks: number of tasks.
        folder: folder of the array, which all nodes must see.
        command: words that compute a task, to which its number is added.
    """
    throttle = f"%{slurm.at_once}" if slurm.at_once else ""
    quoted = shlex.quote(str(folder))
    head = [
        f"--job-name={name}",
        f"--array=0-{tasks - 1}{throttle}",
        f"--output={shlex.quote(str(folder).replace('%', '%%') + '/%a.log')}",
        "--open-mode=append",
        f"--chdir={quoted}",
        *(_option(word) for word in slurm.words()),
    ]
    return "\n".join(
        [
            "#!/bin/bash",
            *(f"#SBATCH {word}" for word in head),
            *slurm.lines(),
            f"folder={quoted}",
            'if [ ! -d "$folder" ]; then',
            '    echo "brinell: the folder $folder is not there on $(hostname)" >&2',
            "    exit 72",
            "fi",
            f'exec {shlex.join(command)} "$folder" "$SLURM_ARRAY_TASK_ID"',
            "",
        ]
    )


def _option(word: str) -> str:
    """An option as a line of a script has it."""
    name, equals, value = word.partition("=")
    return f"{name}={shlex.quote(value)}" if equals else word


def submitted(text: str) -> str:
    """Submits a script; returns the number of the job.

    Raises:
        InputError: sbatch refuses the script or its options.
        IoError: there is no Slurm, or it does not answer.
    """
    done = _called(["sbatch", "--parsable"], text)
    if done.returncode != 0:
        said = _one_line(done.stderr)
        kind = IoError if "contact slurm controller" in said.lower() or "timed out" in said else InputError
        raise kind(f"slurm: sbatch refuses the job array: {said}")
    return done.stdout.strip().splitlines()[-1].partition(";")[0]


def largest_array() -> int:
    """Largest number of tasks of an array on this cluster (MaxArraySize).

    Raises:
        IoError: there is no Slurm, or it does not answer.
    """
    done = _called(["scontrol", "show", "config"])
    found = re.search(r"^MaxArraySize\s*=\s*(\d+)", done.stdout, re.MULTILINE)
    if done.returncode != 0 or found is None:
        raise IoError(f"slurm: scontrol does not tell MaxArraySize: {_one_line(done.stderr)}")
    return max(1, int(found[1]))


def job_named(name: str) -> str | None:
    """Number of the job of this name that has not ended; None if there is none.

    Raises:
        IoError: there is no Slurm, or it does not answer.
    """
    done = _called(["squeue", "--noheader", f"--name={name}", "--format=%F"])
    if done.returncode != 0:
        raise IoError(f"slurm: squeue does not answer: {_one_line(done.stderr)}")
    return done.stdout.split()[0] if done.stdout.split() else None


def task_states(job: str) -> dict[int, TaskState] | None:
    """States of the tasks of a job by their number; those that Slurm has forgotten are left out.

    Returns:
        None if Slurm does not answer now.

    Raises:
        IoError: there is no Slurm on this machine.
    """
    done = _called(["scontrol", "--oneliner", "show", "job", job])
    if done.returncode != 0:
        return {} if "invalid job id" in done.stderr.lower() else None
    states: dict[int, TaskState] = {}
    for line in done.stdout.splitlines():
        found = dict(re.findall(r"(\w+)=(\S*)", line))
        state = TaskState(
            found.get("JobState", "UNKNOWN"),
            found.get("ExitCode", ""),
            found.get("Reason", ""),
            found.get("NodeList", ""),
        )
        for number in _numbers(found.get("ArrayTaskId", "")):
            states[number] = state
    return states


def _numbers(text: str) -> Iterator[int]:
    """Numbers of a list of tasks such as 3,5-8,10-20:2%4."""
    for first, last, step in re.findall(r"(\d+)(?:-(\d+))?(?::(\d+))?", text.partition("%")[0]):
        yield from range(int(first), int(last or first) + 1, int(step or 1))


def _called(words: Sequence[str], text: str | None = None) -> subprocess.CompletedProcess[str]:
    """Calls a command of Slurm; one that takes too long has failed."""
    try:
        return subprocess.run(words, input=text, capture_output=True, text=True, timeout=_PATIENCE, check=False)
    except FileNotFoundError as error:
        raise IoError(f"slurm: {words[0]} is not on this machine; a sweep is submitted where sbatch is") from error
    except subprocess.TimeoutExpired:
        return subprocess.CompletedProcess(list(words), 1, "", f"{words[0]} timed out")


def _one_line(text: str) -> str:
    lines = [line.strip() for line in text.splitlines() if line.strip()]
    return "; ".join(lines) or "no message"
