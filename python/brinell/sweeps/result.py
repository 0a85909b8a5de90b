# SPDX-License-Identifier: BSD-3-Clause
"""The results of a sweep: its table, and its runs."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from pathlib import Path

import pandas as pd

from brinell.errors import InputError
from brinell.results import Run, open_run
from brinell.sweeps.folder import read_record, run_folder
from brinell.sweeps.numbers import Numbers, functions_of, with_numbers

__all__ = ["Sweep", "open_sweep"]


@dataclass(frozen=True, eq=False)
class Sweep:
    """The results of a sweep.

    Attributes:
        path: folder of the sweep.
        table: one row per finished or failed run: index, values of the axes (SI, as in the case), status, reason of a
            failure, wall_time_s [s], folder (empty if it is not kept), and all scalar values of the summary by dotted
            key, such as "energy.net_J" or "indents.0.hardness_Pa".
        awaited: number of runs that a job array still computes (`Slurm.wait` is False).
    """

    path: Path
    table: pd.DataFrame
    awaited: int = 0

    @property
    def runs(self) -> Mapping[int, Run]:
        """Finished runs by index, of those whose folders are kept; each is opened when it is accessed."""
        has_folder = self.table["folder"].fillna("") != ""
        return _Runs(self.path, self.table["index"][(self.table["status"] == "done") & has_folder].tolist())

    @property
    def done(self) -> int:
        """Number of finished runs."""
        return int((self.table["status"] == "done").sum())

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
        return f"<brinell.Sweep {str(self.path)!r}: {self.done} runs done, {len(self.failures)} failed>"


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
