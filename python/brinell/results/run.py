# SPDX-License-Identifier: BSD-3-Clause
"""A result: its history, its summary, and the way to its fields."""

from __future__ import annotations

import tomllib
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from pathlib import Path
from typing import TYPE_CHECKING, Any, Literal

import numpy as np

from brinell._reprs import fact_table
from brinell.results.accuracy import Accuracy, RunWarning, accuracy_of, warnings_of
from brinell.results.blocks import blocks_of
from brinell.results.errors import RunError, summary_place, unfinished
from brinell.results.fields import field_names, labelled_field
from brinell.results.history import History
from brinell.results.labelled import Labelled
from brinell.results.result_file import FILE_NAME, MemoryFile, ResultFile, Source
from brinell.results.scenarios import Indent, RollingPass, Scenario, TrackProfile, parsed
from brinell.results.snapshots import Snapshot

if TYPE_CHECKING:
    import pyvista

__all__ = ["CriticalValues", "Run"]


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
    """a_c, of cylinders the half-width [m]."""
    contact_area: float
    """A_c = pi a_c², of cylinders of the length L 2 a_c L [m²]."""
    peak_pressure: float
    """p0_c = C S_y [Pa]."""

    @property
    def yield_stress(self) -> float:
        """S_y of the body that yields first [Pa]."""
        return self.peak_pressure / self.C


@dataclass(frozen=True, eq=False)
class Run:
    """One result. Made by `brinell.open`."""

    path: Path
    """The folder, or the file if that was opened alone; of a run in memory only a name."""
    history: History
    summary: dict[str, Any] | None
    """Key results and the case, docs/reference/results-format.md; None if the run has not finished."""
    memory: MemoryFile | None = None
    """Of a run in memory: what would be its file."""

    @property
    def file(self) -> Source:
        """The HDF5 file with the fields."""
        if self.memory is not None:
            return self.memory
        return self.path if self.path.is_file() else self.path / FILE_NAME

    @property
    def complete(self) -> bool:
        """Whether the run reached its end."""
        return self.summary is not None

    @property
    def scenario(self) -> Scenario:
        """What was computed."""
        return self.history.scenario

    @cached_property
    def title(self) -> str:
        """From the case; empty if it has none."""
        if self.summary is not None:
            return str(self.summary.get("title", ""))
        try:
            return str(tomllib.loads(self.case_text).get("title", ""))
        except (RunError, tomllib.TOMLDecodeError):  # an unfinished run may not have come to write its case
            return ""

    def __repr__(self) -> str:
        state = "complete" if self.complete else "unfinished"
        place = f"'{self.path}'" if self.memory is None else "in memory"
        return f"<brinell.Run {self.scenario} {self.title!r} {self.history.steps} steps, {state}, {place}>"

    def _repr_html_(self) -> str:
        """For notebooks: the key numbers, and what to be wary of."""
        from brinell.report.findings import findings_of  # these modules know this one
        from brinell.report.numbers import key_numbers

        facts = [(number.name, number.value, number.normalised) for number in key_numbers(self)]
        title = f"{self.scenario}{f': {self.title}' if self.title else ''} ({self.history.steps} steps)"
        return fact_table(title, facts, findings_of(self))

    def _value(self, *keys: str) -> Any:
        """An entry of the summary."""
        if self.summary is None:
            raise unfinished(self.path, self.history.steps)
        entry: Any = self.summary
        for key in keys:
            if not isinstance(entry, Mapping) or key not in entry:
                raise RunError(f"{summary_place(self.path)}: no entry {'.'.join(keys)}")
            entry = entry[key]
        return entry

    def _number(self, *keys: str) -> float:
        value = self._value(*keys)
        if value is None or isinstance(value, bool) or not isinstance(value, int | float) or not np.isfinite(value):
            raise RunError(f"{self._place('.'.join(keys))} = {value!r} is not a number")
        return float(value)

    def case(self, *keys: str) -> Any:
        """A value of the case as computed, SI; None if it does not apply there.

        `run.case("upper", "shape", "radius")` is upper.shape.radius of the case file.
        """
        entry = self._value("case")
        for key in keys:
            entry = entry.get(key) if isinstance(entry, Mapping) else None
        return entry

    @property
    def has_critical_values(self) -> bool:
        """Whether there is a first yield in closed form: of round bodies, or cylinders in plane strain."""
        return self._value("critical", "load_N") is not None

    @cached_property
    def critical(self) -> CriticalValues:
        """Values at first yield, the scales of dimensionless results."""
        if not self.has_critical_values:
            raise RunError(
                f"{self.path}: no critical values to normalise with: both bodies are elastic, or they are neither "
                "round nor cylinders in plane strain"
            )
        radius = self._number("critical", "contact_radius_m")
        from_before_lines = "contact_area_m2" not in self._value("critical")  # then it is that of spheres
        return CriticalValues(
            C=self._number("critical", "C"),
            interference=self._number("critical", "interference_m"),
            load=self._number("critical", "load_N"),
            energy=self._number("critical", "energy_J"),
            contact_radius=radius,
            contact_area=np.pi * radius**2 if from_before_lines else self._number("critical", "contact_area_m2"),
            peak_pressure=self._number("critical", "peak_pressure_Pa"),
        )

    @property
    def line_reference(self) -> float | None:
        """Distance from which the approach of cylinders in plane strain counts [m]; None of other bodies."""
        exists = self._value("critical").get("line_reference_m") is not None
        return self._number("critical", "line_reference_m") if exists else None

    @property
    def lower_radius(self) -> float:
        """R1 of a tugging [m]."""
        return self._number("geometry", "lower_radius_m")

    @property
    def upper_radius(self) -> float:
        """R2 of a tugging [m]."""
        return self._number("geometry", "upper_radius_m")

    @property
    def equivalent_radius(self) -> float:
        """R = 1 / (1/R1 + 1/R2) of round bodies, or cylinders in plane strain [m]."""
        return self._number("geometry", "equivalent_radius_m")

    @property
    def interference(self) -> float:
        """Rigid-body interference of a tugging at alignment [m]."""
        return self._number("geometry", "interference_m")

    @property
    def normalised_interference(self) -> float:
        """alpha* = alpha / alpha_c of a tugging [-]."""
        return self.interference / self.critical.interference

    @cached_property
    def indents(self) -> list[Indent]:
        """Of an indentation, in the order of time: place by place, cycle by cycle."""
        entries = self._list("indents", "indentation")
        return [parsed(Indent, entry, self._place(f"indents[{i}]")) for i, entry in enumerate(entries)]

    @cached_property
    def passes(self) -> list[RollingPass]:
        """Of a rolling, in the order of time."""
        entries = self._list("passes", "rolling")
        return [parsed(RollingPass, entry, self._place(f"passes[{i}]")) for i, entry in enumerate(entries)]

    @cached_property
    def profile(self) -> TrackProfile:
        """What rolling has left in the depth under the middle of the track."""
        return parsed(TrackProfile, self._value_of("rolling", "profile"), self._place("profile"))

    def _value_of(self, scenario: Scenario, key: str) -> Any:
        """An entry of the summary that only one scenario has."""
        if self.scenario != scenario:
            raise RunError(f"{self.path}: is of scenario {self.scenario!r}; {key} are of {scenario!r}")
        return self._value(key)

    def _list(self, key: str, scenario: Scenario) -> list[Any]:
        value = self._value_of(scenario, key)
        if not isinstance(value, list):
            raise RunError(f"{self._place(key)} is not a list")
        return value

    def _place(self, key: str) -> str:
        return f"{summary_place(self.path)}: {key}"

    @cached_property
    def warnings(self) -> list[RunWarning]:
        """What to be wary of before the numbers are used; decided by the engine, none if all is well or unfinished."""
        return warnings_of(self.summary, summary_place(self.path))

    @property
    def resolution(self) -> Mapping[str, Any]:
        """Cells per contact radius, layers of the plastic zone and the errors to be expected: `summary["resolution"]`.

        Raises:
            RunError: the run has not finished, or an older program has written it.
        """
        resolution = self._value("resolution")
        if not isinstance(resolution, Mapping):
            raise RunError(f"{self._place('resolution')} is no table")
        return resolution

    @cached_property
    def accuracy(self) -> dict[str, Accuracy]:
        """How well each number of the summary is known, by its name; empty unless the run was asked for an accuracy.

        `run.accuracy["forces.peak_F_X_N"].low`
        """
        return accuracy_of(self.summary, summary_place(self.path))

    @cached_property
    def case_text(self) -> str:
        """The case as computed, as the text of a case file, SI."""
        with ResultFile(self.file) as file:
            text = file.text("case")
        if text is None:
            raise RunError(f"{self.file}: holds no case")
        return text

    @cached_property
    def sources(self) -> list[str]:
        """Brinell and the papers behind the models of the case, as ``brinell cite`` tells them."""
        with ResultFile(self.file) as file:
            return (file.text("sources") or "").splitlines()

    @property
    def steps(self) -> list[int]:
        """Numbers of the steps whose fields are stored, in order; the final state comes beside them."""
        with ResultFile(self.file) as file:
            return file.steps()

    def field_names(self, body: Literal["lower", "upper"]) -> list[str]:
        """What `field` knows of a body; empty if it is rigid.

        Raises:
            RunError: there is no such body, or no state is stored.
        """
        return field_names(self.file, body)

    def field(self, body: Literal["lower", "upper"], name: str) -> Labelled:
        """One field in all stored states, with named axes; read when its values are asked for.

        Args:
            body: whose grid it is on.
            name: a field of `BodyFields`, or a component of a tensor, as "stress_xx"; "pressure" or "gap" of the
                contact, which lie on the lower body's surface (around the contact's grid the pressure is 0, the gap
                NaN).

        Returns:
            The axes are step, component (of a tensor), z (of a volume), y, x. The final state has the number after the
            last step, as in ParaView.

        Raises:
            RunError: there is no such body or field, or the file is damaged.
        """
        return replace(labelled_field(self.file, body, name), owner=self)

    def snapshot(self, which: int | Literal["aligned", "final"] = "aligned", *, tensors: bool = False) -> Snapshot:
        """Fields at one step.

        Args:
            which: number of a stored step; "aligned", the stored step of the first pass nearest to the middle (X = 0 or
                x = 0), in an indentation the one under the largest load; or "final", the state after the last step,
                over the entire track.
            tensors: read all components of plastic strain and stress at once; otherwise each one when it is asked
                for, as in `snapshot.lower.stress["xx"]`.

        Raises:
            RunError: there is no such step, or the file is damaged.
        """
        with ResultFile(self.file) as file:
            snapshot = file.snapshot(which, self.scenario, self)
        if tensors:
            for body in (snapshot.lower, snapshot.upper):
                for tensor in (body.plastic_strain, body.stress):
                    list(tensor.values())
        return snapshot

    def to_pyvista(
        self, which: int | Literal["aligned", "final"] = "aligned", *, fields: Sequence[str] | None = None
    ) -> pyvista.MultiBlock:
        """One state as datasets of pyvista, upright: the lower body lies below z = 0, the upper one above it.

        While the bodies touch, x counts from the centre of contact, as in the figures; afterwards as on each body.

        Args:
            which: as in `snapshot`.
            fields: names as in `field`, such as "stress_xx"; all if None, which reads much of a large run.

        Returns:
            The blocks "lower_volume" and "upper_volume", of cells; "lower_surface" and "upper_surface", sheets of
            points with the residual displacement, which warp_by_scalar raises (by a negative factor that of the lower
            body: the displacement is into the body); and "contact", a sheet with pressure and gap, if they touch. What
            is not stored, as of a rigid body, is left out. Components of tensors are those of each body's own axes,
            with z into it.

        Raises:
            RunError: there is no such step, or the file is damaged.
            InputError: there is no such field.
            MissingExtraError: pyvista is not installed.
        """
        return blocks_of(self.snapshot(which), fields)
