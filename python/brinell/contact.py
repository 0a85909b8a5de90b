# SPDX-License-Identifier: BSD-3-Clause
"""Non-adhesive contact of two elastic bodies, without and with friction.

grid = SurfaceGrid(65, 65, 1e-6, 1e-6)
ball = (grid.x**2 + grid.y**2) / (2 * 0.01)
result = ElasticContact(grid, Material("210 GPa", 0.3)).solve(ball, load=0.5)

With friction, one step after another: `FrictionalContact`; under a given bound of the shear: `TangentialContact`.
Surfaces that go on without end: SurfaceGrid(..., boundary="periodic").
"""

from __future__ import annotations

import warnings
from dataclasses import dataclass

from numpy.typing import ArrayLike

from brinell import _core
from brinell._arrays import Array, contiguous, number
from brinell._names import level_of_caller, renamed
from brinell._patches import Patches, contact_area, patches
from brinell._reprs import cells
from brinell._tangential import (
    TangentialContact,
    TangentialResult,
    load_tolerance,
    no_convergence,
    tangential_drive_of,
    tangential_result,
)
from brinell.errors import ConvergenceError, InputError
from brinell.halfspace import SurfaceCompliance, SurfaceGrid
from brinell.materials import RIGID, Material

__all__ = [
    "ContactResult",
    "ElasticContact",
    "FrictionResult",
    "FrictionalContact",
    "Patches",
    "TangentialContact",
    "TangentialResult",
    "contact_area",
    "patches",
]


@renamed(area="contact_area", iterations="contact_iterations")
@dataclass(frozen=True)
class ContactResult:
    """A solved contact.

    Attributes:
        pressure: (ny, nx), >= 0 [Pa].
        gap: (ny, nx) between the deformed surfaces [m].
        approach: imposed or found [m]; without load that at which the surfaces touch.
        load: sum of the pressure [N].
        contact_iterations: of the conjugate gradients.
        converged: whether the residual is within the tolerance.
        residual: largest |gap| under pressure or penetration elsewhere [m].
        contact_area: finer than the cells: see the function `contact_area` [m^2].
        reaches_edge: whether pressure acts on the outermost cells of an axis that is not periodic: the grid cuts the
            contact off, and the result is that of a smaller body. It is warned of.
    """

    pressure: Array
    gap: Array
    approach: float
    load: float
    contact_iterations: int
    converged: bool
    residual: float
    contact_area: float
    reaches_edge: bool = False

    def __repr__(self) -> str:
        return f"<ContactResult {cells(self.pressure.shape)}, load {self.load:g} N, approach {self.approach:g} m>"


class ElasticContact:
    """Contact of two bodies by the preconditioned, constrained conjugate gradient method (after Polonsky, Keer 1999).

    Finds p >= 0, gap = distance - approach + A p >= 0, p gap = 0, with A the surface compliance.
    """

    def __init__(self, grid: SurfaceGrid, lower: Material, upper: Material = RIGID, *, reference: float | None = None):
        """Plans the contact.

        Args:
            grid: wide enough that the contact ends on it, along axes that are not periodic.
            lower: one body; of its material only the elastic constants count.
            upper: the other one.
            reference: see `SurfaceCompliance`; the approach counts from there.

        Raises:
            InputError: both are rigid, a material is impossible, or a reference is missing or of no use.
        """
        self.grid = grid
        self.compliance = SurfaceCompliance(grid, lower, upper, reference=reference)
        """The `SurfaceCompliance` of the pair."""

    def __repr__(self) -> str:
        return f"<ElasticContact {cells(self.grid.shape)}>"

    def solve(
        self,
        distance: ArrayLike,
        *,
        load: float | None = None,
        approach: float | None = None,
        mean_gap: float | None = None,
        tolerance: float | None = None,
        max_iterations: int = 2000,
        guess: ArrayLike | None = None,
    ) -> ContactResult:
        """Solves the contact.

        Args:
            distance: (ny, nx) of the undeformed surfaces at no approach [m].
            load: [N], >= 0.
            approach: instead of the load: how far the bodies have come together [m]. With two periodic axes at most the
                mean distance, where all of the surface touches.
            mean_gap: instead, with two periodic axes, the mean gap over the period, >= 0 [m].
            tolerance: largest residual [m]. None: 1e-7 of the overlap of the undeformed surfaces if the approach or
                the mean gap is given; of load/(E' sqrt(area of the grid)), less than the bodies come together, if the
                load is.
            max_iterations: after which it gives up.
            guess: (ny, nx) a pressure to begin with, as that of a neighbouring problem [Pa].

        Raises:
            ConvergenceError: the residual did not reach the tolerance.
            InputError: a wrong shape, a negative load or mean gap, a mean gap without two periodic axes, an approach
                beyond full contact, or not one of load, approach and mean gap is given.
        """
        if max_iterations < 0:
            raise InputError(f"max_iterations = {max_iterations}; allowed: not below 0")
        distance = contiguous(distance, "distance")
        drive = drive_of(load, approach, mean_gap)
        if mean_gap is not None:
            approach = float(distance.mean()) - mean_gap
        pressure, gap, report = _core.solve_contact(
            self.compliance._engine,
            distance,
            drive,
            default_tolerance(self.compliance, distance, load, approach) if tolerance is None else tolerance,
            max_iterations,
            None if guess is None else contiguous(guess, "guess"),
        )
        if not report.converged:
            raise ConvergenceError(f"{_not_solved(report)}. A larger tolerance or max_iterations may help")
        return _result(self.compliance, pressure, gap, report)

    def stiffness(self, pressure: ArrayLike) -> float:
        """Elastic stiffness of a solved contact [N/m]: load per approach as they begin to change.

        That of a flat punch of the shape of the contact: 0 without contact, infinite if all of a surface with two
        periodic axes touches, NaN if it could not be computed.

        Args:
            pressure: (ny, nx), only where it is above zero counts [Pa].

        Raises:
            InputError: a wrong shape.
        """
        return _core.contact_stiffness(self.compliance._engine, contiguous(pressure, "pressure"))


@renamed(dissipated="dissipation_friction")
@dataclass(frozen=True)
class FrictionResult:
    """A solved step of a contact with friction.

    Attributes:
        contact: pressure, gap, approach, load and contact area.
        tangential: shears, slips, stick, shift and force of the step.
        shift: along x and y, of the upper body past the lower one in all steps [m].
        dissipation_friction: in all steps [J].
        alternations: of the normal and the tangential problem.
    """

    contact: ContactResult
    tangential: TangentialResult
    shift: tuple[float, float]
    dissipation_friction: float
    alternations: int

    def __repr__(self) -> str:
        x, y = self.tangential.force
        load = self.contact.load
        return f"<FrictionResult {cells(self.contact.pressure.shape)}, load {load:g} N, force {x:g} N, {y:g} N>"


class FrictionalContact:
    """Contact of two elastic bodies with Coulomb's friction: |q| <= friction * p, slip along q.

    Where the bodies differ, shears open or close the gap and pressure pulls along the surface; then the normal and the
    tangential problem are solved by turns, until the gap stays (Panagiotopoulos 1975). Signs: `TangentialContact`.

        contact = FrictionalContact(grid, rubber, steel, friction=0.5)
        pressed = contact.step(ball, load=0.5)
        pushed = contact.step(ball, load=0.5, force_x=0.1, before=pressed)
    """

    def __init__(
        self,
        grid: SurfaceGrid,
        lower: Material,
        upper: Material = RIGID,
        *,
        friction: float,
        reference: float | None = None,
    ):
        """Plans the contact.

        Args:
            grid: wide enough that the contact ends on it, along axes that are not periodic.
            lower: one body; of its material only the elastic constants count.
            upper: the other one.
            friction: coefficient, >= 0.
            reference: see `SurfaceCompliance`; approach and shift count from there.

        Raises:
            InputError: both are rigid, a material is impossible, or a reference is missing or of no use.
        """
        self.grid = grid
        self.friction = number(friction, "friction")
        self.compliance = SurfaceCompliance(grid, lower, upper, reference=reference)
        """The `SurfaceCompliance` of the pair."""

    def __repr__(self) -> str:
        return f"<FrictionalContact {cells(self.grid.shape)}, friction {self.friction:g}>"

    def step(
        self,
        distance: ArrayLike,
        *,
        load: float | None = None,
        approach: float | None = None,
        mean_gap: float | None = None,
        shift_x: float | None = None,
        shift_y: float | None = None,
        force_x: float | None = None,
        force_y: float | None = None,
        spin: float = 0.0,
        before: FrictionResult | None = None,
        carried: tuple[int, int] = (0, 0),
        tolerance: float | None = None,
        max_iterations: int = 2000,
    ) -> FrictionResult:
        """Solves one step of a history. How the load and the force come together matters: give enough steps.

        Args:
            distance: see `ElasticContact.solve` [m].
            load: see `ElasticContact.solve` [N].
            approach: instead of the load [m].
            mean_gap: instead, with two periodic axes [m].
            shift_x: of the upper body in this step [m]; 0 if neither it nor the force is given.
            shift_y: the same along y [m].
            force_x: instead of the shift, the force along x on the lower body after the step [N].
            force_y: the same along y [N].
            spin: of the upper body in this step, about the middle of the grid, from x to y [rad].
            before: the step before; None: the bodies do not touch yet.
            carried: rolling: see `TangentialContact.step`.
            tolerance: largest residual of the gap, and of the slip over the friction coefficient [m]. None: as that of
                `ElasticContact.solve`.
            max_iterations: of each solution, after which it gives up.

        Raises:
            ConvergenceError: a residual did not reach the tolerance, or the turns did not come to an end.
            InputError: as `ElasticContact.solve` and `TangentialContact.step`.
        """
        distance = contiguous(distance, "distance")
        drive = drive_of(load, approach, mean_gap)
        tangential = tangential_drive_of(shift_x, shift_y, force_x, force_y, spin)
        if mean_gap is not None:
            approach = float(distance.mean()) - mean_gap
        if tolerance is None:
            tolerance = default_tolerance(self.compliance, distance, load, approach)
        last = None
        if before is not None:
            last = before.contact.pressure, before.tangential.shear_x, before.tangential.shear_y
        pressure, gap, *fields, report = _core.solve_friction(
            self.compliance._engine,
            self.compliance._traction_engine,
            distance,
            drive,
            tangential,
            self.friction,
            tolerance,
            min(self.friction, 1.0) * tolerance,
            max_iterations,
            last,
            carried,
        )
        if not report.converged:
            raise ConvergenceError(_reason(report))
        slip = tangential_result(self.grid, self.friction * pressure, fields, report.tangential)
        shift, dissipation = ((0.0, 0.0), 0.0) if before is None else (before.shift, before.dissipation_friction)
        return FrictionResult(
            _result(self.compliance, pressure, gap, report.normal),
            slip,
            (shift[0] + slip.shift[0], shift[1] + slip.shift[1]),
            dissipation + slip.dissipation_friction,
            report.alternations,
        )


def _result(compliance: SurfaceCompliance, pressure: Array, gap: Array, report: _core.ContactReport) -> ContactResult:
    reaches_edge = _reaches_edge(compliance.grid, pressure)
    if reaches_edge:
        from brinell.case import CaseWarning

        warnings.warn(
            "the contact reaches the edge of its grid, which cuts it off: take more cells",
            CaseWarning,
            stacklevel=level_of_caller(),
        )
    return ContactResult(
        pressure,
        gap,
        report.approach,
        float(pressure.sum()) * compliance.grid.cell_area,
        report.iterations,
        report.converged,
        _residual(report),
        contact_area(compliance.grid, pressure, gap, compliance.contact_modulus),
        reaches_edge,
    )


def _reaches_edge(grid: SurfaceGrid, pressure: Array) -> bool:
    periodic_x, periodic_y = grid.is_periodic
    at_ends = not periodic_x and bool(pressure[:, [0, -1]].any())
    return at_ends or (not periodic_y and bool(pressure[[0, -1], :].any()))


def _residual(report: _core.ContactReport) -> float:
    return max(report.gap_error, report.penetration)


def _not_solved(report: _core.ContactReport) -> str:
    return f"no convergence after {report.iterations} iterations: the contact's residual is {_residual(report):.2e} m"


def _reason(report: _core.FrictionReport) -> str:
    if not report.normal.converged:
        return _not_solved(report.normal)
    if not report.tangential.converged:
        return no_convergence(report.tangential)
    return (
        f"no convergence after {report.alternations} turns of the normal and the tangential problem: the shears still "
        f"move the gap by {report.gap_change:.2e} m. Smaller steps or a larger tolerance may help"
    )


def default_tolerance(
    compliance: SurfaceCompliance, distance: Array, load: float | None, approach: float | None
) -> float:
    """Largest residual of a contact if none is given: see `ElasticContact.solve`."""
    if load is not None:
        return load_tolerance(compliance, load)
    overlap = (approach or 0.0) - float(distance.min())
    return 1e-7 * max(overlap, 0.0)


def drive_of(load: float | None, approach: float | None, mean_gap: float | None = None) -> _core.Drive:
    """What is imposed on two bodies.

    Raises:
        InputError: not one of them is given, the load is negative, or a value is not finite.
    """
    if (load is not None) + (approach is not None) + (mean_gap is not None) != 1:
        raise InputError("a contact needs either load or approach, or with two periodic axes mean_gap")
    if load is not None:
        return _core.Drive.of_load(number(load, "load"))
    if approach is not None:
        return _core.Drive.of_approach(number(approach, "approach"))
    return _core.Drive.of_mean_gap(number(mean_gap, "mean_gap"))
