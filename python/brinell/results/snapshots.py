# SPDX-License-Identifier: BSD-3-Clause
"""result.h5: the fields of the stored steps and of the final state."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Literal

import h5py
import numpy as np
from numpy.typing import NDArray

from brinell.results.errors import FORMAT_VERSION, RunError, listed, one_line
from brinell.results.scenarios import Scenario, distance_from_middle

__all__ = ["COMPONENTS", "BodyFields", "ContactFields", "ResultFile", "Snapshot"]

FloatArray = NDArray[np.float64]

COMPONENTS = ("xx", "yy", "zz", "yz", "xz", "xy")
"""Components of a symmetric tensor, in order."""


@dataclass(frozen=True, eq=False)
class ContactFields:
    """Surface of contact in the local frame that moves with it; cell centres, arrays [y][x]."""

    x: FloatArray
    """Along the motion, 0 at the centre of contact [m]."""
    y: FloatArray
    """Across [m]."""
    pressure: FloatArray
    """Positive in compression [Pa]."""
    gap: FloatArray
    """Zero in contact [m]."""


@dataclass(frozen=True, eq=False)
class BodyFields:
    """One body on its own material grid; cell centres, arrays [z][y][x] or [y][x]. All are empty if it is rigid."""

    x: FloatArray
    """Along the surface; 0 where it is touched at alignment, in the middle of the track or at place 0 [m]."""
    y: FloatArray
    """Across [m]."""
    z: FloatArray
    """Depth into this body, > 0 [m]."""
    contact_x: float
    """Where on this body the centre of contact is now [m]."""
    residual_displacement: FloatArray
    """Of the surface, into the body positive [m]; zero if the body is elastic."""
    equivalent_plastic_strain: FloatArray
    """[-]; zero if the body is elastic."""
    von_mises_stress: FloatArray | None
    """Of contact pressure and plastic strain together [Pa]; None if the run did not store it."""
    plastic_strain: dict[str, FloatArray] = field(default_factory=dict)
    """By component [-]; only if asked for and stored."""
    stress: dict[str, FloatArray] = field(default_factory=dict)
    """By component, positive in tension [Pa]; only if asked for and stored."""

    @property
    def is_rigid(self) -> bool:
        """Whether nothing is stored of this body, because it does not deform."""
        return self.residual_displacement.size == 0


@dataclass(frozen=True, eq=False)
class Snapshot:
    """Fields of both bodies at one step."""

    scenario: Scenario
    row: Mapping[str, float]
    """The step's row of the history, SI: `snapshot.row["F_n"]`."""
    is_final: bool
    """State after the last step, over the entire track."""
    contact: ContactFields
    lower: BodyFields
    upper: BodyFields

    @property
    def step(self) -> int:
        """Number of the step."""
        return int(self.row["step"])

    @property
    def pass_(self) -> int:
        """Counts from 0."""
        return int(self.row["pass"])

    @property
    def in_contact(self) -> bool:
        """Whether the bodies touch."""
        return bool(np.any(self.contact.pressure > 0.0))


class ResultFile:
    """An open result.h5; to be used in a with statement.

    Args:
        folder: of the run.
        scenario: of the run.

    Raises:
        RunError: it is missing, not HDF5, or of another version.
    """

    def __init__(self, folder: Path, scenario: Scenario):
        self._path = folder / "result.h5"
        self._scenario: Scenario = scenario
        if not self._path.is_file():
            raise RunError(f"{folder}: no result.h5, so there are no fields to read")
        try:
            self._file = h5py.File(self._path, "r")
        except OSError as error:
            raise RunError(f"{self._path}: not a readable HDF5 file ({one_line(error)})") from error
        version = self._file.attrs.get("format_version")
        if version is None or int(version) != FORMAT_VERSION:
            self._file.close()
            raise RunError(f"{self._path}: format version {version}, this program reads version {FORMAT_VERSION}")

    def __enter__(self) -> ResultFile:
        return self

    def __exit__(self, *_: object) -> None:
        self._file.close()

    def stored_steps(self) -> list[int]:
        """Numbers of the steps whose fields are stored, in order."""
        return sorted(int(name) for name in self._file["steps"]) if "steps" in self._file else []

    def snapshot(self, which: int | Literal["aligned", "final"], *, tensors: bool) -> Snapshot:
        """Fields at one step; see `Run.snapshot`."""
        name = self._group_name(which)
        group = self._group(name)
        try:
            return _snapshot(group, tensors, self._scenario, is_final=which == "final")
        except (KeyError, OSError, ValueError) as error:
            raise RunError(f"{self._path}: /{name} is damaged ({one_line(error)})") from error

    def _group_name(self, which: int | Literal["aligned", "final"]) -> str:
        if which == "final":
            if "final" not in self._file:
                raise RunError(f"{self._path}: no final state, the run has not finished")
            return "final"
        if which == "aligned":
            return self._aligned()
        steps = self.stored_steps()
        if which not in steps:
            raise RunError(f"{self._path}: step {which} is not stored (stored: {listed(steps)})")
        return self._step_name(which)

    def _step_name(self, step: int) -> str:
        return next(f"steps/{name}" for name in self._file["steps"] if int(name) == step)

    def _aligned(self) -> str:
        names = [self._step_name(step) for step in self.stored_steps()]
        if not names:
            raise RunError(f"{self._path}: no stored step; [output] of the case chooses them")
        rows = {name: _row(self._group(name)) for name in names}
        return min(names, key=lambda name: (rows[name]["pass"], distance_from_middle(self._scenario, rows[name])))

    def _group(self, name: str) -> h5py.Group:
        """A step; while the run has not finished it is a link to a file in snapshots/."""
        try:
            return self._file[name]
        except (KeyError, OSError) as error:
            folder = self._path.parent / "snapshots"
            raise RunError(f"{self._path}: /{name} cannot be opened; is {folder} missing?") from error


def _row(group: h5py.Group) -> dict[str, float]:
    return {name: float(value) for name, value in group.attrs.items()}


def _axis(origin: float, spacing: float, count: int) -> FloatArray:
    return origin + spacing * np.arange(count, dtype=np.float64)


def _snapshot(group: h5py.Group, tensors: bool, scenario: Scenario, *, is_final: bool) -> Snapshot:
    return Snapshot(
        scenario=scenario,
        row=_row(group),
        is_final=is_final,
        contact=_contact(group["contact"]),
        lower=_body(group["lower"], tensors),
        upper=_body(group["upper"], tensors),
    )


def _contact(group: h5py.Group) -> ContactFields:
    pressure = np.asarray(group["pressure"][()], dtype=np.float64)
    spacing, origin = group.attrs["spacing"], group.attrs["origin"]
    ny, nx = pressure.shape
    return ContactFields(
        x=_axis(origin[0], spacing[0], nx),
        y=_axis(origin[1], spacing[1], ny),
        pressure=pressure,
        gap=np.asarray(group["gap"][()], dtype=np.float64),
    )


def _body(group: h5py.Group, tensors: bool) -> BodyFields:
    def read(name: str) -> FloatArray | None:
        return np.asarray(group[name][()], dtype=np.float64) if name in group else None

    def components(name: str) -> dict[str, FloatArray]:
        if not tensors or name not in group:
            return {}
        return {c: np.asarray(group[name][c][()], dtype=np.float64) for c in COMPONENTS}

    residual = read("residual_displacement")
    strain = read("equivalent_plastic_strain")
    von_mises = read("von_mises_stress")
    nz, ny, nx = _shape(strain if strain is not None else von_mises, residual)
    spacing, origin = group.attrs["spacing"], group.attrs["origin"]
    return BodyFields(
        x=_axis(origin[0], spacing[0], nx),
        y=_axis(origin[1], spacing[1], ny),
        z=_axis(origin[2], spacing[2], nz),
        contact_x=float(group.attrs["contact_x"]),
        residual_displacement=residual if residual is not None else np.zeros((ny, nx)),
        equivalent_plastic_strain=strain if strain is not None else np.zeros((nz, ny, nx)),
        von_mises_stress=von_mises,
        plastic_strain=components("plastic_strain"),
        stress=components("stress"),
    )


def _shape(volume: FloatArray | None, surface: FloatArray | None) -> tuple[int, int, int]:
    """Cells [nz, ny, nx] of a body, as far as any field of it is stored."""
    if volume is not None:
        nz, ny, nx = volume.shape
        return nz, ny, nx
    if surface is not None:
        ny, nx = surface.shape
        return 0, ny, nx
    return 0, 0, 0
