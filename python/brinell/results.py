# SPDX-License-Identifier: BSD-3-Clause
"""Reads what ``brinell run`` wrote: ``history.csv``, ``summary.json``, ``result.h5`` of one folder.

The format is docs/reference/results-format.md, version 1. All numbers are SI, angles in radians, depths into the body,
stresses positive in tension, pressure in compression. Everything that is wrong with a folder is one `RunError` that
says where and what.

    run = open_run("results/alpha9")
    run.history["F_X"] / run.critical.load
    run.snapshot("aligned").lower.von_mises_stress
"""

from __future__ import annotations

import csv
import itertools
import json
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from functools import cached_property
from pathlib import Path
from typing import Any, Literal

import h5py
import numpy as np
from numpy.typing import NDArray

__all__ = [
    "COMPONENTS",
    "FORMAT_VERSION",
    "HISTORY_COLUMNS",
    "BodyFields",
    "ContactFields",
    "CriticalValues",
    "History",
    "Run",
    "RunError",
    "Snapshot",
    "open_run",
]

FORMAT_VERSION = 1
"""Version of the results format that this module reads."""

HISTORY_COLUMNS = (
    "step",
    "X",
    "theta",
    "interference",
    "contact_area",
    "max_pressure",
    "F_n",
    "F_X",
    "F_Y",
    "F_Z",
    "F_X_macro",
    "F_Z_macro",
    "work",
    "dissipation_lower",
    "dissipation_upper",
    "energy_residual",
    "max_residual_lower",
    "max_residual_upper",
    "max_equivalent_plastic_strain",
    "iterations",
)
"""Columns of history.csv, in order."""

COMPONENTS = ("xx", "yy", "zz", "yz", "xz", "xy")
"""Components of a symmetric tensor, in order."""

FloatArray = NDArray[np.float64]


class RunError(Exception):
    """A folder is not a readable result; the text is one line for the user."""


class History(Mapping[str, FloatArray]):
    """Columns of history.csv by name, SI, one value per step; see HISTORY_COLUMNS.

    Steps of several passes follow each other; `passes` takes them apart.
    """

    def __init__(self, columns: Mapping[str, FloatArray]):
        self._columns = {name: np.asarray(columns[name], dtype=np.float64) for name in HISTORY_COLUMNS}

    def __getitem__(self, name: str) -> FloatArray:
        return self._columns[name]

    def __iter__(self) -> Iterator[str]:
        return iter(self._columns)

    def __len__(self) -> int:
        return len(self._columns)

    @property
    def steps(self) -> int:
        """Number of rows."""
        return len(self._columns["step"])

    @property
    def in_contact(self) -> NDArray[np.bool_]:
        """Steps at which the bodies touch."""
        return (self["contact_area"] > 0.0) & (self["F_n"] > 0.0)

    def passes(self) -> list[History]:
        """One history per pass: X grows during a pass and jumps back between two."""
        starts = np.flatnonzero(np.diff(self["X"]) < 0.0) + 1
        bounds = [0, *starts.tolist(), self.steps]
        return [History({name: column[a:b] for name, column in self.items()}) for a, b in itertools.pairwise(bounds)]


@dataclass(frozen=True, eq=False)
class CriticalValues:
    """First yield of the normal contact of the two bodies (Green 2005)."""

    C: float
    """Peak pressure over yield stress [-]."""
    interference: float
    """alpha_c [m]."""
    load: float
    """P_c [N]."""
    energy: float
    """U_c [J]."""
    contact_radius: float
    """a_c [m]."""
    peak_pressure: float
    """p0_c = C S_y [Pa]."""

    @property
    def yield_stress(self) -> float:
        """S_y of the body that yields first [Pa]."""
        return self.peak_pressure / self.C


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
    """One body on its own material grid; cell centres, arrays [z][y][x] or [y][x]."""

    x: FloatArray
    """Along the surface from the point touched at alignment [m]."""
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


@dataclass(frozen=True, eq=False)
class Snapshot:
    """Fields of both bodies at one step."""

    step: int
    pass_: int
    """Counts from 0."""
    is_final: bool
    """State after the last step, over the entire track."""
    X: float
    """Sliding coordinate [m]."""
    theta: float
    """Angle of the line of centres with the vertical [rad]."""
    interference: float
    """Of the undeformed spheres along the line of centres [m]."""
    F_X: float
    """[N]."""
    F_Z: float
    """[N]."""
    contact: ContactFields
    lower: BodyFields
    upper: BodyFields

    @property
    def in_contact(self) -> bool:
        """Whether the bodies touch."""
        return bool(np.any(self.contact.pressure > 0.0))


@dataclass(frozen=True, eq=False)
class Run:
    """One result folder. Made by `open_run`."""

    path: Path
    history: History
    summary: dict[str, Any] | None
    """Content of summary.json; None if the run has not finished."""

    @property
    def complete(self) -> bool:
        """Whether the run reached its end."""
        return self.summary is not None

    def _value(self, *keys: str) -> Any:
        """An entry of the summary."""
        if self.summary is None:
            raise _unfinished(self.path, self.history.steps)
        entry: Any = self.summary
        for key in keys:
            if not isinstance(entry, Mapping) or key not in entry:
                raise RunError(f"{self.path / 'summary.json'}: no entry {'.'.join(keys)}")
            entry = entry[key]
        return entry

    def _number(self, *keys: str) -> float:
        value = self._value(*keys)
        if value is None or isinstance(value, bool) or not isinstance(value, int | float) or not np.isfinite(value):
            raise RunError(f"{self.path / 'summary.json'}: {'.'.join(keys)} = {value!r} is not a number")
        return float(value)

    @property
    def is_elastic(self) -> bool:
        """Whether neither body can yield, so that there are no critical values."""
        return self._value("critical", "load_N") is None

    @cached_property
    def critical(self) -> CriticalValues:
        """Values at first yield, the scales of all dimensionless results."""
        if self.is_elastic:
            raise RunError(f"{self.path}: both bodies are elastic, so there are no critical values to normalise with")
        return CriticalValues(
            C=self._number("critical", "C"),
            interference=self._number("critical", "interference_m"),
            load=self._number("critical", "load_N"),
            energy=self._number("critical", "energy_J"),
            contact_radius=self._number("critical", "contact_radius_m"),
            peak_pressure=self._number("critical", "peak_pressure_Pa"),
        )

    @property
    def lower_radius(self) -> float:
        """R1 [m]."""
        return self._number("geometry", "lower_radius_m")

    @property
    def upper_radius(self) -> float:
        """R2 [m]."""
        return self._number("geometry", "upper_radius_m")

    @property
    def equivalent_radius(self) -> float:
        """R = 1 / (1/R1 + 1/R2) [m]."""
        return self._number("geometry", "equivalent_radius_m")

    @property
    def interference(self) -> float:
        """Rigid-body interference at alignment [m]."""
        return self._number("geometry", "interference_m")

    @property
    def normalised_interference(self) -> float:
        """alpha* = alpha / alpha_c [-]."""
        return self.interference / self.critical.interference

    def stored_steps(self) -> list[int]:
        """Numbers of the steps whose fields are stored, in order; the final state comes beside them."""
        with self._open_fields() as file:
            return _stored_steps(file)

    def snapshot(self, which: int | Literal["aligned", "final"] = "aligned", *, tensors: bool = False) -> Snapshot:
        """Fields at one step.

        Args:
            which: number of a stored step; "aligned", the stored step of the first pass nearest to X = 0; or "final",
                the state after the last step, over the entire track.
            tensors: also read all components of plastic strain and stress.

        Raises:
            RunError: there is no such step, or the file is damaged.
        """
        with self._open_fields() as file:
            steps = _stored_steps(file)
            if which == "final":
                if "final" not in file:
                    raise RunError(f"{self.path / 'result.h5'}: no final state, the run has not finished")
                name = "final"
            elif which == "aligned":
                if not steps:
                    raise RunError(f"{self.path / 'result.h5'}: no stored step; [output] of the case chooses them")
                name = _aligned(self.path, file, steps)
            else:
                if which not in steps:
                    stored = ", ".join(map(str, steps)) if steps else "none"
                    raise RunError(f"{self.path / 'result.h5'}: step {which} is not stored (stored: {stored})")
                name = _group_name(file, which)
            try:
                return _read_snapshot(_group(self.path, file, name), tensors)
            except (KeyError, OSError, ValueError) as error:
                raise RunError(f"{self.path / 'result.h5'}: /{name} is damaged ({_text(error)})") from error

    def _open_fields(self) -> h5py.File:
        path = self.path / "result.h5"
        if not path.is_file():
            raise RunError(f"{self.path}: no result.h5, so there are no fields to read")
        try:
            file = h5py.File(path, "r")
        except OSError as error:
            raise RunError(f"{path}: not a readable HDF5 file ({_text(error)})") from error
        version = file.attrs.get("format_version")
        if version is None or int(version) != FORMAT_VERSION:
            file.close()
            raise RunError(f"{path}: format version {version}, this program reads version {FORMAT_VERSION}")
        return file


def open_run(path: str | Path, *, allow_unfinished: bool = False) -> Run:
    """Opens a result folder: reads the history and the summary; fields are read when asked for.

    Args:
        path: the folder that `brinell run -o` wrote.
        allow_unfinished: also accept a run that is still going or was stopped; its summary is then None.

    Raises:
        RunError: no such folder, a file is missing or damaged, or the run has not finished.
    """
    path = Path(path)
    if not path.is_dir():
        raise RunError(f"{path}: no such folder" if not path.exists() else f"{path}: not a folder")
    history = _read_history(path)
    summary_path = path / "summary.json"
    if not summary_path.is_file():
        if not allow_unfinished:
            raise _unfinished(path, history.steps)
        return Run(path, history, None)
    return Run(path, history, _read_summary(summary_path))


def _unfinished(path: Path, steps: int) -> RunError:
    return RunError(f"{path}: no summary.json, the run has not finished ({steps} steps in history.csv)")


def _text(error: BaseException) -> str:
    """An exception's message on one line."""
    return " ".join(str(error.args[0] if error.args else error).split())


def _read_history(folder: Path) -> History:
    path = folder / "history.csv"
    if not path.is_file():
        raise RunError(f"{folder}: no history.csv, so this is not a result of 'brinell run'")
    try:
        text = path.read_text(encoding="utf-8")
    except (OSError, UnicodeDecodeError) as error:
        raise RunError(f"{path}: cannot be read ({error})") from error
    # A run that was killed may leave half a row without its line end: the finished rows stay good.
    lines = text[: text.rfind("\n") + 1].splitlines()
    if not lines or tuple(lines[0].split(",")) != HISTORY_COLUMNS:
        raise RunError(f"{path}:1: the header is not that of a history (expected {','.join(HISTORY_COLUMNS[:3])},...)")
    rows = []
    for line_number, cells in enumerate(csv.reader(lines[1:]), start=2):
        if len(cells) != len(HISTORY_COLUMNS):
            raise RunError(f"{path}:{line_number}: {len(cells)} values, expected {len(HISTORY_COLUMNS)}")
        try:
            row = [float(cell) for cell in cells]
        except ValueError as error:
            raise RunError(f"{path}:{line_number}: {error}") from error
        for name, value in zip(HISTORY_COLUMNS, row, strict=True):
            if not np.isfinite(value):
                raise RunError(f"{path}:{line_number}: {name} = {value} is not a finite number")
        rows.append(row)
    if not rows:
        raise RunError(f"{path}: no finished step")
    table = np.array(rows, dtype=np.float64)
    return History({name: table[:, i] for i, name in enumerate(HISTORY_COLUMNS)})


def _read_summary(path: Path) -> dict[str, Any]:
    try:
        summary = json.loads(path.read_text(encoding="utf-8"))
    except (OSError, UnicodeDecodeError) as error:
        raise RunError(f"{path}: cannot be read ({error})") from error
    except json.JSONDecodeError as error:
        raise RunError(f"{path}:{error.lineno}: not valid JSON ({error.msg})") from error
    if not isinstance(summary, dict) or summary.get("format") != "brinell-summary":
        raise RunError(f"{path}: not a summary of brinell")
    if summary.get("format_version") != FORMAT_VERSION:
        version = summary.get("format_version")
        raise RunError(f"{path}: format version {version}, this program reads version {FORMAT_VERSION}")
    return summary


def _group_name(file: h5py.File, step: int) -> str:
    return next(f"steps/{name}" for name in file["steps"] if int(name) == step)


def _stored_steps(file: h5py.File) -> list[int]:
    return sorted(int(name) for name in file["steps"]) if "steps" in file else []


def _group(folder: Path, file: h5py.File, name: str) -> h5py.Group:
    """A step; in a killed run it is a link to a file in snapshots/."""
    try:
        return file[name]
    except (KeyError, OSError) as error:
        raise RunError(
            f"{folder / 'result.h5'}: /{name} cannot be opened; is {folder / 'snapshots'} missing?"
        ) from error


def _aligned(folder: Path, file: h5py.File, steps: list[int]) -> str:
    candidates = []
    for step in steps:
        name = _group_name(file, step)
        attributes = _group(folder, file, name).attrs
        candidates.append((int(attributes["pass"]), abs(float(attributes["X"])), name))
    first_pass = min(candidates)[0]
    return min(candidate for candidate in candidates if candidate[0] == first_pass)[2]


def _axis(origin: float, spacing: float, count: int) -> FloatArray:
    return origin + spacing * np.arange(count, dtype=np.float64)


def _read_snapshot(group: h5py.Group, tensors: bool) -> Snapshot:
    attributes = group.attrs
    contact = group["contact"]
    pressure = np.asarray(contact["pressure"][()], dtype=np.float64)
    spacing, origin = contact.attrs["spacing"], contact.attrs["origin"]
    ny, nx = pressure.shape
    return Snapshot(
        step=int(attributes["step"]),
        pass_=int(attributes["pass"]),
        is_final=group.name == "/final" or group.name.endswith("/final"),
        X=float(attributes["X"]),
        theta=float(attributes["theta"]),
        interference=float(attributes["interference"]),
        F_X=float(attributes["F_X"]),
        F_Z=float(attributes["F_Z"]),
        contact=ContactFields(
            x=_axis(origin[0], spacing[0], nx),
            y=_axis(origin[1], spacing[1], ny),
            pressure=pressure,
            gap=np.asarray(contact["gap"][()], dtype=np.float64),
        ),
        lower=_read_body(group["lower"], tensors),
        upper=_read_body(group["upper"], tensors),
    )


def _read_body(group: h5py.Group, tensors: bool) -> BodyFields:
    def read(name: str) -> FloatArray | None:
        return np.asarray(group[name][()], dtype=np.float64) if name in group else None

    def components(name: str) -> dict[str, FloatArray]:
        if not tensors or name not in group:
            return {}
        return {c: np.asarray(group[name][c][()], dtype=np.float64) for c in COMPONENTS}

    residual = read("residual_displacement")
    strain = read("equivalent_plastic_strain")
    von_mises = read("von_mises_stress")
    volume = strain if strain is not None else von_mises
    if volume is not None:
        nz, ny, nx = volume.shape
    elif residual is not None:
        nz, (ny, nx) = 0, residual.shape
    else:
        nz = ny = nx = 0
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
