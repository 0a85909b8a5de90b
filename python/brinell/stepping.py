# SPDX-License-Identifier: BSD-3-Clause
"""A case that is computed step by step, with access to every state."""

from __future__ import annotations

import json
from collections.abc import Iterator
from typing import TYPE_CHECKING, Any

from brinell import _core

if TYPE_CHECKING:
    from brinell.case import Case

__all__ = ["Stepping"]


class Stepping(Iterator[dict[str, float]]):
    """Iterator that solves one step of a run at a time and writes no files; results are dictionaries and arrays.

    for record in case.steps():
        print(record["step"], record["F_n"])

    Made by `Case.steps`. The loop may be left and continued later; after Ctrl-C the run cannot be continued.
    """

    def __init__(self, case: Case, threads: int = 0):
        """Sets up the grids and positions the bodies.

        Args:
            case: the case to compute.
            threads: number of threads; 0: as OpenMP decides.

        Raises:
            InputError: the grid does not fit this machine.
        """
        self._core = _core.Stepping(case._core, threads)
        self._title = case.title or case.name
        self._taken = 0

    def __next__(self) -> dict[str, float]:
        """Solves the next step.

        Returns:
            The step's row of the history by column name (docs/reference/results-format.md), in SI units.

        Raises:
            ConvergenceError: the step did not converge.
            GridError: the step needs a larger grid that does not fit into the memory.
            KeyboardInterrupt: Ctrl-C was pressed; the run cannot be continued.
        """
        if self._core.is_done:
            raise StopIteration
        try:
            record = self._core.step()
        except KeyboardInterrupt:
            raise KeyboardInterrupt(
                f"interrupted in step {self._taken}: nothing is written, and the loop cannot go on; Case.run stores "
                "its steps and resumes"
            ) from None
        self._taken += 1
        return record

    @property
    def step_count(self) -> int:
        """Estimated number of steps of the whole run."""
        return self._core.step_count

    @property
    def is_done(self) -> bool:
        """Whether all steps have been solved."""
        return self._core.is_done

    def fields(self) -> dict[str, Any]:
        """The state after the last step.

        Returns:
            A dictionary. For the contact, arrays of shape (ny, nx): ``pressure`` [Pa], ``gap`` [m] and, with friction,
            ``shear_x``, ``shear_y`` [Pa], ``slip_x``, ``slip_y``, ``slip_path`` [m] and ``friction_heat`` [J/m^2] as
            far as the case has them; ``x`` and ``y`` [m] are the coordinates from the centre of contact.

            ``lower`` and ``upper`` are dictionaries with the fields of each body: coordinates ``x``, ``y``, ``z`` on
            the body [m], ``contact_x``, the position of the centre of contact on it [m], ``residual_displacement``
            (ny, nx), positive into the body [m], ``worn_depth`` (ny, nx) [m] with wear, ``height`` (ny, nx) of the
            present surface, positive out of the body [m], with a texture, ``equivalent_plastic_strain`` (nz, ny, nx)
            [-], ``plastic_strain`` [-] and ``stress`` [Pa] of shape (6, nz, ny, nx) with the components xx, yy, zz, yz,
            xz, xy. Fields that a rigid body does not have are missing, and, if neither body can yield, those within the
            bodies unless `output.fields` or another key of `output` asks for them.
        """
        return self._core.fields()

    def summary(self) -> dict[str, Any]:
        """Summary of the steps so far, with the keys of summary.json (docs/reference/results-format.md)."""
        summary: dict[str, Any] = json.loads(self._core.summary_text())
        return summary

    def __repr__(self) -> str:
        return f"<brinell.Stepping {self._title!r}, {self._taken} of about {self.step_count} steps>"
