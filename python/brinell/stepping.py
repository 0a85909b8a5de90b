# SPDX-License-Identifier: BSD-3-Clause
"""A case that is computed step by step, with a look at every state on the way."""

from __future__ import annotations

import json
from collections.abc import Iterator
from typing import TYPE_CHECKING, Any

from brinell import _core

if TYPE_CHECKING:
    from brinell.case import Case

__all__ = ["Stepping"]


class Stepping(Iterator[dict[str, float]]):
    """A run whose steps the caller takes one by one. Nothing is written; results come as dictionaries and arrays.

    for record in case.steps():
        print(record["step"], record["F_n"])

    Made by `Case.steps`. The loop may be left and taken up again; Ctrl-C ends the run.
    """

    def __init__(self, case: Case):
        """Plans the grids and places the bodies.

        Args:
            case: what is to be computed.

        Raises:
            InputError: the grid does not fit this machine.
        """
        self._core = _core.Stepping(case._core)
        self._title = case.title or case.name
        self._taken = 0

    def __next__(self) -> dict[str, float]:
        """Solves the next step.

        Returns:
            Its row of the history, by the names of the columns (docs/reference/results-format.md), SI units.

        Raises:
            ConvergenceError: the step did not converge.
            GridError: a larger grid, which the step needs, does not fit into the memory.
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
        """Of the whole run, an estimate."""
        return self._core.step_count

    @property
    def is_done(self) -> bool:
        """Whether all steps have been taken."""
        return self._core.is_done

    def fields(self) -> dict[str, Any]:
        """The state after the last step.

        Returns:
            ``x``, ``y`` [m] from the contact's centre, ``pressure`` [Pa] and ``gap`` [m] of shape (y, x), where
            surfaces slide or stick also ``shear_x``, ``shear_y`` [Pa], ``slip_x``, ``slip_y``, ``slip_path`` [m] and
            ``friction_heat`` [J/m^2], as far as they exist, and a dictionary for each body, ``lower`` and ``upper``:
            ``x``, ``y``, ``z`` [m] on the body, ``contact_x``, the contact's place there, ``residual_displacement`` [m]
            of shape (y, x), into the body positive, where it wears ``worn_depth`` [m] likewise, where it has a texture
            ``height`` [m] of the surface as it is, out of the body positive,
            ``equivalent_plastic_strain`` (z, y, x), and ``plastic_strain`` and ``stress`` [Pa] of shape (6, z, y, x):
            xx, yy, zz, yz, xz, xy. What a rigid body does not have is left out.
        """
        return self._core.fields()

    def summary(self) -> dict[str, Any]:
        """Of the steps so far, as in summary.json (docs/reference/results-format.md)."""
        summary: dict[str, Any] = json.loads(self._core.summary_text())
        return summary

    def __repr__(self) -> str:
        return f"<brinell.Stepping {self._title!r}, {self._taken} of about {self.step_count} steps>"
