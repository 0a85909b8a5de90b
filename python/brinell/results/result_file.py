# SPDX-License-Identifier: BSD-3-Clause
"""result.vtkhdf: the file with all results of a run."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from typing import Literal, TypeAlias

import h5py
import numpy as np
from numpy.typing import NDArray

from brinell.results.errors import FORMAT_VERSION, RunError, listed, one_line, other_version, reports_damage
from brinell.results.history import History
from brinell.results.snapshots import Snapshot, row_of, snapshot_of
from brinell.scenarios import SCENARIOS, Scenario

__all__ = ["FILE_NAME", "MemoryFile", "ResultFile", "Source"]

FloatArray = NDArray[np.float64]

FILE_NAME = "result.vtkhdf"
"""Name of the result file in the folder of a run."""


class MemoryFile:
    """Content of a result file that exists only in memory."""

    def __init__(self, image: bytes):
        self.image = image

    @cached_property
    def opened(self) -> h5py.File:
        """The opened file; it stays open as long as this object."""
        return h5py.File(h5py.h5f.open_file_image(self.image))

    def __getstate__(self) -> dict[str, bytes]:
        return {"image": self.image}  # the open file cannot be pickled

    def __str__(self) -> str:
        return "result in memory"


Source: TypeAlias = Path | MemoryFile
"""Source of a result: a file on disk or in memory."""


@dataclass(frozen=True)
class _Components:
    """Function object that reads components of the tensors of a state."""

    path: Source
    state: str
    owner: object

    def __call__(self, body: str, tensor: str, component: str) -> FloatArray:
        with ResultFile(self.path) as file, reports_damage(self.path, f"/{self.state}/{body}/{tensor}"):
            return np.asarray(file.group(self.state)[body][tensor][component][()], dtype=np.float64)


def _columns(group: h5py.Group) -> dict[str, FloatArray]:
    """All data sets of a group, by HDF5's own functions: objects of h5py take three times as long if they are short."""
    columns = {}
    for name in group:
        data = h5py.h5d.open(group.id, name.encode())
        columns[name] = np.empty(data.shape)
        data.read(h5py.h5s.ALL, h5py.h5s.ALL, columns[name])
    return columns


class ResultFile:
    """An open result.vtkhdf, for use in a with statement.

    Args:
        path: path of the file, or a file in memory.

    Raises:
        RunError: the file is missing, not HDF5, not a result of brinell, or has another format version.
    """

    def __init__(self, path: Source):
        self.path = path
        if isinstance(path, MemoryFile):
            self._file = path.opened
            return
        if not path.is_file():
            raise RunError(f"{path.parent}: no {path.name}, so there are no fields to read")
        try:
            self._file = h5py.File(path, "r")
        except OSError as error:
            raise RunError(f"{path}: not a readable HDF5 file ({one_line(error)})") from error
        try:
            with reports_damage(path, "its description"):
                self._require_format()
        except RunError:
            self._file.close()
            raise

    def _require_format(self) -> None:
        kind, version = (self._file.attrs.get(name) for name in ("format", "format_version"))
        if not isinstance(kind, str) or kind != "brinell-result":
            raise RunError(f"{self.path}: not a result of brinell")
        if np.ndim(version) != 0 or version != FORMAT_VERSION:
            raise other_version(self.path, version)

    def __enter__(self) -> ResultFile:
        return self

    def __exit__(self, *_: object) -> None:
        if not isinstance(self.path, MemoryFile):
            self._file.close()

    def text(self, name: str) -> str | None:
        """A text in the file: "case" (the resolved case), "sources" or "summary"; None if it is missing."""
        with reports_damage(self.path, f"/{name}"):
            return str(self._file[name].asstr()[()]) if name in self._file else None

    def history(self) -> History:
        """The history up to the last stored step; the whole history of a complete run.

        Raises:
            RunError: no step is finished, or the history is damaged.
        """
        with reports_damage(self.path, "/history"):
            columns = _columns(self._file["history"])
            if len({column.shape for column in columns.values()}) > 1 or any(c.ndim != 1 for c in columns.values()):
                raise ValueError("columns of different lengths")
        if not columns:
            raise RunError(f"{self.path}: no finished step")
        try:
            return History(columns)
        except RunError as error:
            raise RunError(f"{self.path}: /history: {error}") from error

    def table(self, name: str) -> dict[str, FloatArray]:
        """Columns of a table, by name; empty if there is none."""
        with reports_damage(self.path, f"/{name}"):
            if name not in self._file:
                return {}
            return {column: np.asarray(values[()], dtype=np.float64) for column, values in self._file[name].items()}

    def steps(self) -> list[int]:
        """Numbers of the steps whose fields are stored, in order."""
        with reports_damage(self.path, "/steps"):
            return sorted(int(name) for name in self._file["steps"]) if "steps" in self._file else []

    def states(self) -> dict[int, str]:
        """Names of the groups with fields by step; the final state is last and has the number after the last step."""
        groups = {step: self._step_name(step) for step in self.steps()}
        with reports_damage(self.path, "/final"):
            if "final" in self._file:
                groups[int(self.group("final").attrs["step"]) + 1] = "final"
        return groups

    def snapshot(self, which: int | Literal["aligned", "final"], scenario: Scenario, owner: object = None) -> Snapshot:
        """Fields at one step; see `Run.snapshot`.

        Args:
            which: the state.
            scenario: scenario of the run.
            owner: object that must live as long as the snapshot, which reads tensor components from the file on demand.
        """
        name = self._group_name(which, scenario)
        group = self.group(name)
        with reports_damage(self.path, f"/{name}"):
            components = _Components(self.path, name, owner)
            return snapshot_of(group, row_of(group), components, scenario, is_final=which == "final")

    def group(self, name: str) -> h5py.Group:
        """HDF5 group of a state; until the run has finished it is a link to a file in snapshots/."""
        try:
            group = self._file[name]
        except (KeyError, OSError, RuntimeError) as error:
            missing = f"; is {self.path.parent / 'snapshots'} missing?" if isinstance(self.path, Path) else ""
            raise RunError(f"{self.path}: /{name} cannot be opened{missing}") from error
        if not isinstance(group, h5py.Group):
            raise RunError(f"{self.path}: /{name} is damaged (no group)")
        return group

    def _group_name(self, which: int | Literal["aligned", "final"], scenario: Scenario) -> str:
        if which == "final":
            if "final" not in self._file:
                raise RunError(f"{self.path}: no final state, the run has not finished")
            return "final"
        if which == "aligned":
            return self._aligned(scenario)
        steps = self.steps()
        if which not in steps:
            raise RunError(f"{self.path}: step {which} is not stored (stored: {listed(steps)})")
        return self._step_name(which)

    def _step_name(self, step: int) -> str:
        return next(f"steps/{name}" for name in self._file["steps"] if int(name) == step)

    def _aligned(self, scenario: Scenario) -> str:
        names = [self._step_name(step) for step in self.steps()]
        if not names:
            raise RunError(f"{self.path}: no stored step; [output] of the case chooses them")
        with reports_damage(self.path, "/steps"):
            rows = {name: row_of(self.group(name)) for name in names}
            distance = SCENARIOS[scenario].distance_from_middle
            return min(names, key=lambda name: (rows[name]["pass"], distance(rows[name])))
