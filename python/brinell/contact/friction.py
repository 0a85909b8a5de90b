# SPDX-License-Identifier: BSD-3-Clause
"""Contact of two elastic bodies with Coulomb friction: the normal and the tangential problem together."""

from __future__ import annotations

from dataclasses import dataclass

from numpy.typing import ArrayLike

from brinell import _core
from brinell._arrays import contiguous, number
from brinell._reprs import cells
from brinell.contact.normal import ContactResult, contact_result, default_tolerance, drive_of, not_solved
from brinell.contact.tangential import TangentialResult, no_convergence, tangential_drive_of, tangential_result
from brinell.errors import ConvergenceError
from brinell.halfspace import SurfaceCompliance, SurfaceGrid
from brinell.materials import RIGID, Material

__all__ = ["FrictionResult", "FrictionalContact"]


@dataclass(frozen=True)
class FrictionResult:
    """Result of one step of a contact with friction.

    Attributes:
        contact: normal part: pressure, gap, approach, load and contact area.
        tangential: tangential part: shear, slip, stick area, shift and force of this step.
        shift: displacement along x and y of the upper body relative to the lower one, summed over all steps [m].
        dissipation_friction: energy dissipated by friction in all steps [J].
        alternations: number of alternations between the normal and the tangential problem.
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
    """Contact of two elastic bodies with Coulomb friction: |q| <= friction * p, slip along q.

    If the elastic constants of the bodies differ, shear changes the gap and pressure causes tangential displacement.
    The normal and the tangential problem are then solved in alternation until the gap no longer changes
    (Panagiotopoulos 1975). The sign conventions are those of `TangentialContact`.

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
        """Sets up the problem and its operators.

        Args:
            grid: grid of all fields; along axes that are not periodic it must contain the whole contact.
            lower: material of the lower body; only its elastic constants are used.
            upper: material of the upper body; only its elastic constants are used.
            friction: friction coefficient, >= 0 [-].
            reference: reference distance as in `SurfaceCompliance`, from which approach and shift are measured [m].

        Raises:
            InputError: both bodies are rigid, a material is invalid, or `reference` is missing or not applicable.
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
        """Solves one step of a loading history.

        The result depends on the path of load and force: use enough steps to resolve it.

        Args:
            distance: (ny, nx) distance of the undeformed surfaces at zero approach [m].
            load: normal load at the end of the step, >= 0 [N].
            approach: approach at the end of the step, instead of the load [m].
            mean_gap: mean gap at the end of the step, instead of the load, with two periodic axes; >= 0 [m].
            shift_x: displacement of the upper body along x in this step [m]; 0 if neither `shift_x` nor `force_x` is
                given.
            shift_y: displacement of the upper body along y in this step [m]; the default is as for `shift_x`.
            force_x: force along x on the lower body at the end of the step, instead of `shift_x` [N].
            force_y: force along y on the lower body at the end of the step, instead of `shift_y` [N].
            spin: rotation of the upper body in this step about the middle of the grid, positive from x to y [rad].
            before: result of the previous step; None: the bodies do not touch yet.
            carried: cells by which the surfaces have moved in rolling, as in `TangentialContact.step`.
            tolerance: largest accepted residual of the gap [m]; that of the slip is min(friction, 1) times this. None:
                as in `ElasticContact.solve`.
            max_iterations: largest number of iterations of each normal and each tangential solution.

        Raises:
            ConvergenceError: a residual did not reach the tolerance, or the alternation did not converge.
            InputError: an invalid argument, as in `ElasticContact.solve` and `TangentialContact.step`.
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
            contact_result(self.compliance, pressure, gap, report.normal),
            slip,
            (shift[0] + slip.shift[0], shift[1] + slip.shift[1]),
            dissipation + slip.dissipation_friction,
            report.alternations,
        )


def _reason(report: _core.FrictionReport) -> str:
    if not report.normal.converged:
        return not_solved(report.normal)
    if not report.tangential.converged:
        return no_convergence(report.tangential)
    return (
        f"no convergence after {report.alternations} turns of the normal and the tangential problem: the shears still "
        f"move the gap by {report.gap_change:.2e} m. Smaller steps or a larger tolerance may help"
    )
