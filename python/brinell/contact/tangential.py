# SPDX-License-Identifier: BSD-3-Clause
"""Stick and slip of two elastic bodies under a given bound of the shear traction."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from brinell import _core
from brinell._arrays import Array, contiguous, number
from brinell._reprs import cells
from brinell.contact.normal import load_tolerance
from brinell.errors import ConvergenceError, InputError
from brinell.halfspace import SurfaceCompliance, SurfaceGrid
from brinell.materials import RIGID, Material

__all__ = ["TangentialContact", "TangentialResult"]


@dataclass(frozen=True)
class TangentialResult:
    """Result of one step of a stick-slip problem.

    Attributes:
        shear_x: (ny, nx) shear traction on the lower body along x [Pa].
        shear_y: (ny, nx) shear traction on the lower body along y [Pa].
        slip_x: (ny, nx) slip along x of the upper surface relative to the lower one in this step; zero where the bound
            is zero [m].
        slip_y: (ny, nx) slip along y [m].
        sticks: (ny, nx) true where the bound is above zero and the shear stays below it.
        dissipation: (ny, nx) shear at the end of the step times slip [J/m^2].
        shift: displacement along x and y of the upper body relative to the lower one in this step, imposed or found
            for the imposed force [m].
        force: tangential force along x and y on the lower body, the integral of the shear [N].
        stick_area: area of the cells that stick [m^2].
        dissipation_friction: energy dissipated in this step, the integral of `dissipation` [J].
        contact_iterations: number of conjugate gradient iterations.
        residual: largest error of the slip [m]: its size where the surfaces stick, its part across or against the
            shear where they slip.
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

    Each step finds the shear q with |q| <= bound and the slip s = shift - change - A (q - q_before), where s = 0 if
    |q| < bound and s is along q if |q| = bound. A maps a shear to the tangential displacement of the lower surface
    minus that of the upper one. The shear acts on the lower body. The shift is the displacement of the upper body
    relative to the lower one, of points far from the contact; on a grid that is periodic along both axes it is that of
    the mean planes. The solution is the minimum of a convex function, found by conjugate gradients with a projection on
    discs (docs/theory/contact.md).

        contact = TangentialContact(grid, steel, steel)
        pushed = contact.step(0.3 * pressure, force_x=2.0)
        back = contact.step(0.3 * pressure, force_x=0.0, before=pushed)
    """

    def __init__(self, grid: SurfaceGrid, lower: Material, upper: Material = RIGID, *, reference: float | None = None):
        """Sets up the problem and its operators.

        Args:
            grid: grid of all fields.
            lower: material of the lower body; only its elastic constants are used.
            upper: material of the upper body; only its elastic constants are used.
            reference: reference distance as in `SurfaceCompliance`, from which the shift is measured [m].

        Raises:
            InputError: both bodies are rigid, a material is invalid, or `reference` is missing or not applicable.
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
        """Solves one step of a loading history.

        Args:
            bound: (ny, nx) largest magnitude of the shear, >= 0, for example friction coefficient times pressure [Pa].
            shift_x: displacement of the upper body along x in this step [m]; 0 if neither `shift_x` nor `force_x` is
                given.
            shift_y: displacement of the upper body along y in this step [m]; the default is as for `shift_x`.
            force_x: tangential force along x at the end of the step, instead of `shift_x` [N].
            force_y: tangential force along y at the end of the step, instead of `shift_y` [N].
            spin: rotation of the upper body in this step about the middle of the grid, positive from x to y [rad].
            before: result of the previous step; None: there is no shear yet.
            change_x: (ny, nx) change in this step of the displacement along x of the lower surface minus that of the
                upper one, from causes other than the shear, such as plastic strain [m]; None: zero.
            change_y: (ny, nx) the same along y [m]; None: zero.
            carried: for rolling: number of cells along x and y by which both surfaces, and with them the shear of the
                previous step, have moved through the contact in this step. The shift is then creepage times distance.
                Where points come into the contact between two cells follows from pressure and gap, which
                `FrictionalContact.step` knows and this step does not: here forces have an error of first order.
            tolerance: largest accepted residual [m]. None: 1e-7 (integral of the bound)/(E' sqrt(area of the grid)),
                which is far below the shift at which the whole contact slides.
            max_iterations: largest number of iterations.

        Raises:
            ConvergenceError: the residual did not reach the tolerance.
            InputError: a wrong shape, a bound that is negative or not finite, both a shift and a force along one axis,
                or a force that reaches the integral of the bound: the whole contact then slides, and only a shift can
                be imposed.
        """
        drive = tangential_drive_of(shift_x, shift_y, force_x, force_y, spin)
        limit = contiguous(bound, "bound")
        if tolerance is None:
            tolerance = load_tolerance(self.compliance, float(limit.sum()) * self.grid.cell_area)
        *fields, report = _core.solve_tangential(
            self.compliance._engine,
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


def tangential_result(
    grid: SurfaceGrid, bound: Array, fields: list[Array], report: _core.TangentialReport
) -> TangentialResult:
    """Builds the result from the engine's fields: shear along x and y, slip along x and y."""
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
    """Builds the engine's description of the imposed tangential motion or force.

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
    """Both components of the change of displacement, with zeros for a missing one; None if both are missing."""
    if x is None and y is None:
        return None
    zeros = np.zeros(grid.shape)
    return (
        zeros if x is None else contiguous(x, "change_x"),
        zeros if y is None else contiguous(y, "change_y"),
    )


def no_convergence(report: _core.TangentialReport) -> str:
    """Error message for a step that has not converged."""
    return (
        f"no convergence after {report.iterations} iterations: the slip's residual is {report.slip_error:.2e} m. "
        "A larger tolerance or max_iterations may help"
    )
