# SPDX-License-Identifier: BSD-3-Clause
"""Stick and slip under a given bound of the shear: part of `brinell.contact`."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from brinell import _core
from brinell._arrays import Array, contiguous, number
from brinell._names import renamed
from brinell._reprs import cells
from brinell.errors import ConvergenceError, InputError
from brinell.halfspace import SurfaceCompliance, SurfaceGrid
from brinell.materials import RIGID, Material

__all__ = ["TangentialContact", "TangentialResult"]


@renamed(dissipated="dissipation_friction", iterations="contact_iterations")
@dataclass(frozen=True)
class TangentialResult:
    """A solved step of stick and slip.

    Attributes:
        shear_x: (ny, nx), on the lower body along x [Pa].
        shear_y: (ny, nx), on the lower body along y [Pa].
        slip_x: (ny, nx), of the upper surface over the lower one in this step, zero where the bound is [m].
        slip_y: (ny, nx), the same along y [m].
        sticks: (ny, nx), where the shear stays below a bound that is above zero.
        dissipation: (ny, nx), shear at the end of the step times slip [J/m^2].
        shift: along x and y, of the upper body past the lower one in this step, imposed or found [m].
        force: along x and y, sum of the shear [N].
        stick_area: of the cells that stick [m^2].
        dissipation_friction: sum of the dissipation [J].
        contact_iterations: of the conjugate gradients.
        residual: largest slip where it sticks, and across or against the shear elsewhere [m].
    """

    shear_x: Array
    shear_y: Array
    slip_x: Array
    slip_y: Array
    sticks: NDArray[np.bool_]
    dissipation: Array
    shift: tuple[float, float]
    force: tuple[float, float]
    stick_area: float
    dissipation_friction: float
    contact_iterations: int
    residual: float

    def __repr__(self) -> str:
        x, y = self.force
        return f"<TangentialResult {cells(self.shear_x.shape)}, force {x:g} N along x, {y:g} N along y>"


class TangentialContact:
    """Stick and slip of two elastic bodies under a given bound of the shear (Cattaneo 1938, Mindlin 1949).

    Finds |q| <= bound and the slip s = shift - change - A (q - q_before) of a step, with s = 0 where |q| < bound and s
    along q where |q| = bound. A is the displacement along the surface of the lower body less that of the upper one. The
    shear acts on the lower body; the shift is that of the upper body past the lower one, of distant points, and on a
    grid that is periodic along both axes that of the mean planes. The step is the minimum of a convex function, found
    by conjugate gradients on discs (docs/theory/contact.md).

        contact = TangentialContact(grid, steel, steel)
        pushed = contact.step(0.3 * pressure, force_x=2.0)
        back = contact.step(0.3 * pressure, force_x=0.0, before=pushed)
    """

    def __init__(self, grid: SurfaceGrid, lower: Material, upper: Material = RIGID, *, reference: float | None = None):
        """Plans the contact.

        Args:
            grid: of all fields.
            lower: one body; of its material only the elastic constants count.
            upper: the other one.
            reference: see `SurfaceCompliance`; the shift counts from there.

        Raises:
            InputError: both are rigid, a material is impossible, or a reference is missing or of no use.
        """
        self.grid = grid
        self.compliance = SurfaceCompliance(grid, lower, upper, reference=reference)
        """The `SurfaceCompliance` of the pair."""

    def __repr__(self) -> str:
        return f"<TangentialContact {cells(self.grid.shape)}>"

    def step(
        self,
        bound: ArrayLike,
        *,
        shift_x: float | None = None,
        shift_y: float | None = None,
        force_x: float | None = None,
        force_y: float | None = None,
        spin: float = 0.0,
        before: TangentialResult | None = None,
        change_x: ArrayLike | None = None,
        change_y: ArrayLike | None = None,
        carried: tuple[int, int] = (0, 0),
        tolerance: float | None = None,
        max_iterations: int = 2000,
    ) -> TangentialResult:
        """Solves one step of a history.

        Args:
            bound: (ny, nx), largest size of the shear, >= 0: friction coefficient times pressure, say [Pa].
            shift_x: of the upper body in this step [m]; 0 if neither it nor the force is given.
            shift_y: the same along y [m].
            force_x: instead of the shift, the sum of the shear after the step [N].
            force_y: the same along y [N].
            spin: of the upper body in this step, about the middle of the grid, from x to y [rad].
            before: the step before; None: no shear yet.
            change_x: (ny, nx), what has been added in this step to the displacement of the lower surface less that of
                the upper one by anything but shear, as by plastic strain [m].
            change_y: (ny, nx), the same along y [m].
            carried: rolling: by how many cells both surfaces have moved through the contact along x and y in this step,
                with the shears before. The shift then is creepage times distance.
            tolerance: largest residual [m]. None: 1e-7 of (sum of the bound)/(E' sqrt(area of the grid)), less than the
                shift at which all slides.
            max_iterations: after which it gives up.

        Raises:
            ConvergenceError: the residual did not reach the tolerance.
            InputError: a wrong shape, a bound that is negative or not finite, both a shift and a force along one axis,
                or a force that reaches the sum of the bound: then all slides, and only a shift can be imposed.
        """
        drive = tangential_drive_of(shift_x, shift_y, force_x, force_y, spin)
        limit = contiguous(bound, "bound")
        if tolerance is None:
            tolerance = load_tolerance(self.compliance, float(limit.sum()) * self.grid.cell_area)
        *fields, report = _core.solve_tangential(
            self.compliance._traction_engine,
            limit,
            drive,
            None if before is None else (before.shear_x, before.shear_y),
            change_of(self.grid, change_x, change_y),
            carried,
            tolerance,
            max_iterations,
        )
        if not report.converged:
            raise ConvergenceError(no_convergence(report))
        return tangential_result(self.grid, limit, fields, report)


def load_tolerance(compliance: SurfaceCompliance, load: float) -> float:
    """Largest residual if none is given: less than a load [N] presses the bodies together, or pushes them along [m]."""
    length = math.sqrt(math.prod(compliance.grid.shape) * compliance.grid.cell_area)
    return 1e-7 * load / (compliance.contact_modulus * length)


def tangential_result(
    grid: SurfaceGrid, bound: Array, fields: list[Array], report: _core.TangentialReport
) -> TangentialResult:
    """The result of the engine's fields: shears along x and y, slips along x and y."""
    shear_x, shear_y, slip_x, slip_y = fields
    sticks = (np.hypot(shear_x, shear_y) < _core.slip_threshold * bound) & (bound > 0.0)
    return TangentialResult(
        shear_x,
        shear_y,
        slip_x,
        slip_y,
        sticks,
        shear_x * slip_x + shear_y * slip_y,
        (report.shift[0], report.shift[1]),
        (report.force[0], report.force[1]),
        float(np.count_nonzero(sticks)) * grid.cell_area,
        report.dissipated,
        report.iterations,
        report.slip_error,
    )


def tangential_drive_of(
    shift_x: float | None, shift_y: float | None, force_x: float | None, force_y: float | None, spin: float
) -> _core.TangentialDrive:
    """What is imposed along the surface.

    Raises:
        InputError: both a shift and a force are given along one axis, or a value is not finite.
    """

    def axis(name: str, shift: float | None, force: float | None) -> tuple[bool, float]:
        if shift is not None and force is not None:
            raise InputError(f"shift_{name} = {shift:g} and force_{name} = {force:g}; allowed: one of them")
        if force is not None:
            return True, number(force, f"force_{name}")
        return False, 0.0 if shift is None else number(shift, f"shift_{name}")

    return _core.TangentialDrive.of(*axis("x", shift_x, force_x), *axis("y", shift_y, force_y), number(spin, "spin"))


def change_of(grid: SurfaceGrid, x: ArrayLike | None, y: ArrayLike | None) -> tuple[Array, Array] | None:
    """Both fields of a change of the displacement, or None."""
    if x is None and y is None:
        return None
    nothing = np.zeros(grid.shape)
    return (
        nothing if x is None else contiguous(x, "change_x"),
        nothing if y is None else contiguous(y, "change_y"),
    )


def no_convergence(report: _core.TangentialReport) -> str:
    """What to say of a step that has not converged."""
    return (
        f"no convergence after {report.iterations} iterations: the slip's residual is {report.slip_error:.2e} m. "
        "A larger tolerance or max_iterations may help"
    )
