# SPDX-License-Identifier: BSD-3-Clause
"""The result of a run: history, summary (`brinell.summary`) and access to the fields."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from typing import TYPE_CHECKING, Any, Literal

from brinell._reprs import fact_table
from brinell._toml import tomllib
from brinell.contact import Patches
from brinell.results.accuracy import Accuracy, RunWarning, accuracy_of, warnings_of
from brinell.results.blocks import blocks_of
from brinell.results.errors import RunError
from brinell.results.fatigue import Fatigue, fatigue_of
from brinell.results.fields import field_names, labelled_field
from brinell.results.interfaces import Interface, depths_of_interfaces, interfaces_in
from brinell.results.labelled import Labelled
from brinell.results.patches import patches_of
from brinell.results.points import PointHistory, point_histories
from brinell.results.result_file import FILE_NAME, ResultFile, Source
from brinell.results.snapshots import Snapshot
from brinell.scenarios import OfScenarios
from brinell.summary import summary_place

if TYPE_CHECKING:
    import pyvista

__all__ = ["Run"]


@dataclass(frozen=True, eq=False)
class Run(OfScenarios):
    """The result of one run, made by `brinell.open` or `Case.run`."""

    @property
    def file(self) -> Source:
        """The HDF5 file with the fields."""
        if self.memory is not None:
            return self.memory
        return self.path if self.path.is_file() else self.path / FILE_NAME

    @cached_property
    def title(self) -> str:
        """Title of the case; empty if it has none."""
        if self.summary is not None:
            return str(self.summary.get("title", ""))
        try:
            return str(tomllib.loads(self.case_text).get("title", ""))
        except (RunError, tomllib.TOMLDecodeError):  # an unfinished run may not have written its case yet
            return ""

    def __repr__(self) -> str:
        state = "complete" if self.complete else "unfinished"
        place = f"'{self.path}'" if self.memory is None else "in memory"
        return f"<brinell.Run {self.scenario} {self.title!r} {self.history.steps} steps, {state}, {place}>"

    def _repr_html_(self) -> str:
        """HTML for notebooks: the key numbers and the warnings."""
        from brinell.report.findings import findings_of  # these modules import this one
        from brinell.report.numbers import key_numbers

        facts = [(number.name, number.value, number.normalised) for number in key_numbers(self)]
        title = f"{self.scenario}{f': {self.title}' if self.title else ''} ({self.history.steps} steps)"
        return fact_table(title, facts, findings_of(self))

    @cached_property
    def warnings(self) -> list[RunWarning]:
        """Warnings of the engine about the result; empty if there are none or the run has not finished."""
        return warnings_of(self.summary, summary_place(self.path))

    @property
    def resolution(self) -> Mapping[str, Any]:
        """Cells per contact radius, layers of the plastic zone and expected errors: `summary["resolution"]`.

        Raises:
            RunError: the run has not finished, or it was written by an older version.
        """
        resolution = self._value("resolution")
        if not isinstance(resolution, Mapping):
            raise RunError(f"{self._place('resolution')} is no table")
        return resolution

    @cached_property
    def accuracy(self) -> dict[str, Accuracy]:
        """Accuracy of each number of the summary by name; empty if the run was computed without `accuracy`.

        `run.accuracy["forces.peak_F_X_N"].low`
        """
        return accuracy_of(self.summary, summary_place(self.path))

    @cached_property
    def case_text(self) -> str:
        """The computed case as the text of a case file, in SI units.

        Raises:
            RunError: the file is missing or damaged, or has no case.
        """
        with ResultFile(self.file) as file:
            text = file.text("case")
        if text is None:
            raise RunError(f"{self.file}: holds no case")
        return text

    @cached_property
    def sources(self) -> list[str]:
        """References to cite: brinell and the papers behind the models of the case, as printed by ``brinell cite``."""
        with ResultFile(self.file) as file:
            return (file.text("sources") or "").splitlines()

    @cached_property
    def points(self) -> list[PointHistory]:
        """Histories of the points that `output.points` of the case names, in their order; one value for each step."""
        return point_histories(self.path, self.file)

    def fatigue(self, body: Literal["lower", "upper"] = "lower") -> Fatigue:
        """Fatigue of a body whose material has `fatigue.criterion`: worst points, shakedown, life, fields and profiles.

        Raises:
            RunError: the run has not finished, or the fatigue of this body was not computed.
        """
        return fatigue_of(self.summary, body, self.field, str(self.path))

    @property
    def steps(self) -> list[int]:
        """Numbers of the steps whose fields are stored, in order; the final state is stored in addition."""
        with ResultFile(self.file) as file:
            return file.steps()

    def field_names(self, body: Literal["lower", "upper"]) -> list[str]:
        """Names of the stored fields of a body, which `field` accepts.

        Raises:
            RunError: there is no such body, or no state is stored.
        """
        return field_names(self.file, body)

    def field(self, body: Literal["lower", "upper"], name: str) -> Labelled:
        """One field in all stored states, with named axes; the values are read when they are first used.

        Args:
            body: body on whose grid the field is.
            name: a field of `BodyFields`, or a component of a tensor such as "stress_xx"; for the lower body also a
                field of `ContactFields`, such as "pressure", "gap" and, with stick and slip, "shear_x" or "slip_path".
                Contact fields are given on the lower body's surface, also if this body is rigid; outside the contact
                grid the gap and the temperatures are NaN and all others are 0.

        Returns:
            Array with the axes step, component (of a tensor), z (of a volume), y, x. The final state has the number
            after the last step, as in ParaView.

        Raises:
            RunError: there is no such body or field, or the file is damaged.
        """
        return replace(labelled_field(self.file, body, name), owner=self)

    def snapshot(self, which: int | Literal["aligned", "final"] = "aligned", *, tensors: bool = False) -> Snapshot:
        """Fields at one step.

        Args:
            which: number of a stored step; "aligned": the stored step of the first pass nearest to the middle (X = 0 or
                x = 0), in an indentation the one with the largest load, in fretting the first turning point; "final":
                the state after the last step, over the entire track.
            tensors: read all components of plastic strain and stress at once. Otherwise each component is read when it
                is first used, as in `snapshot.lower.stress["xx"]`.

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

    def patches(self, which: int | Literal["aligned", "final"] = "aligned") -> Patches:
        """Contact patches at one step, connected sets of cells under pressure, with area and load.

        Args:
            which: state, as in `snapshot`.

        Raises:
            RunError: there is no such step, the run has not finished, or the file is damaged.
        """
        cells = (self._value("grid", "spacing_m")[0], self._value("grid", "spacing_m")[1])
        boundary = str(self.case("grid", "boundary") or "open")
        layered = "surface_modulus_Pa" in (self.summary or {}).get("geometry", {})
        modulus = self._number("geometry", "surface_modulus_Pa" if layered else "contact_modulus_Pa")
        return patches_of(self.snapshot(which).contact, (float(cells[0]), float(cells[1])), boundary, modulus)

    def interface_depths(self, body: Literal["lower", "upper"]) -> list[float]:
        """Depths of the interfaces between the layers of a body [m], from the surface down; none of a homogeneous one.

        Raises:
            RunError: the case is missing or damaged.
        """
        return depths_of_interfaces(tomllib.loads(self.case_text).get(body, {}).get("material", {}))

    def interfaces(
        self, body: Literal["lower", "upper"], which: int | Literal["aligned", "final"] | Snapshot = "aligned"
    ) -> list[Interface]:
        """Shear and normal traction on the interfaces of a coated body at one step, from the surface down.

        Args:
            body: the coated body.
            which: state, as in `snapshot`, or the snapshot.

        Returns:
            Those with stored cells on both sides; none of a homogeneous body.

        Raises:
            RunError: there is no such step, or the file is damaged.
            KeyError: the stress of the body is not stored.
        """
        snapshot = which if isinstance(which, Snapshot) else self.snapshot(which)
        return interfaces_in(snapshot.lower if body == "lower" else snapshot.upper, self.interface_depths(body))

    @cached_property
    def patch_history(self) -> dict[int, Patches]:
        """Contact patches of all stored steps, by step number.

        In sliding, the history has the number of patches and the area of the largest one for every step:
        `history["patches"]`, `history["largest_patch"]`.
        """
        return {step: self.patches(step) for step in self.steps}

    def to_pyvista(
        self, which: int | Literal["aligned", "final"] = "aligned", *, fields: Sequence[str] | None = None
    ) -> pyvista.MultiBlock:
        """One state as pyvista datasets in one frame, with the lower body below z = 0 and the upper one above it.

        While the bodies touch, x is measured from the centre of contact, as in the figures; otherwise it is the
        coordinate on each body.

        Args:
            which: state, as in `snapshot`.
            fields: names as in `field`, such as "stress_xx"; None: all fields, which reads much data of a large run.

        Returns:
            Blocks "lower_volume" and "upper_volume" with cell data; "lower_surface" and "upper_surface", sheets of
            points with surface fields such as the residual displacement, which can be warped by warp_by_scalar (with a
            negative factor for the lower body, because the displacement is positive into the body); and, if the bodies
            touch, "contact", a sheet with the stored contact fields. Blocks without stored fields, such as those of a
            rigid body, are left out. Tensor components refer to each body's own axes, with z into the body.

        Raises:
            RunError: there is no such step, or the file is damaged.
            InputError: there is no such field, or none of the requested fields is stored.
            MissingExtraError: pyvista is not installed.
        """
        return blocks_of(self.snapshot(which), fields)
