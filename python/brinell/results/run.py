# SPDX-License-Identifier: BSD-3-Clause
"""A result: its history, its summary (`brinell.summary`), and the way to its fields."""

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
from brinell.results.fields import field_names, labelled_field
from brinell.results.labelled import Labelled
from brinell.results.patches import patches_of
from brinell.results.result_file import FILE_NAME, ResultFile, Source
from brinell.results.snapshots import Snapshot
from brinell.scenarios import OfScenarios
from brinell.summary import summary_place

if TYPE_CHECKING:
    import pyvista

__all__ = ["Run"]


@dataclass(frozen=True, eq=False)
class Run(OfScenarios):
    """One result. Made by `brinell.open`."""

    @property
    def file(self) -> Source:
        """The HDF5 file with the fields."""
        if self.memory is not None:
            return self.memory
        return self.path if self.path.is_file() else self.path / FILE_NAME

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
            name: a field of `BodyFields`, or a component of a tensor, as "stress_xx"; of `ContactFields`, as
                "pressure", "gap" and, where surfaces stick and slip, "shear_x" or "slip_path": they lie on the lower
                body's surface (around the contact's grid the gap is NaN, all others 0).

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
                x = 0), in an indentation the one under the largest load, in fretting that at the first turn; or
                "final", the state after the last step, over the entire track.
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

    def patches(self, which: int | Literal["aligned", "final"] = "aligned") -> Patches:
        """The patches of the contact at one step: the cells that hang together, with area and load.

        Args:
            which: as in `snapshot`.

        Raises:
            RunError: there is no such step, the run has not finished, or the file is damaged.
        """
        cells = (self._value("grid", "spacing_m")[0], self._value("grid", "spacing_m")[1])
        boundary = str(self.case("grid", "boundary") or "open")
        modulus = self._number("geometry", "contact_modulus_Pa")
        return patches_of(self.snapshot(which).contact, (float(cells[0]), float(cells[1])), boundary, modulus)

    @cached_property
    def patch_history(self) -> dict[int, Patches]:
        """The patches of all stored steps, by the number of the step.

        How many there were in each step, and the area of the largest one, stand in the history of a sliding:
        `history["patches"]`, `history["largest_patch"]`.
        """
        return {step: self.patches(step) for step in self.steps}

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
            body: the displacement is into the body); and "contact", a sheet with what is stored of it, as pressure and
            gap, if they touch. What is not stored, as of a rigid body, is left out. Components of tensors are those of
            each body's own axes, with z into it.

        Raises:
            RunError: there is no such step, or the file is damaged.
            InputError: there is no such field.
            MissingExtraError: pyvista is not installed.
        """
        return blocks_of(self.snapshot(which), fields)
