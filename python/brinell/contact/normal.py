# SPDX-License-Identifier: BSD-3-Clause
"""Frictionless normal contact of two elastic bodies."""

from __future__ import annotations

import math
import warnings
from collections.abc import Sequence
from dataclasses import dataclass

from numpy.typing import ArrayLike

from brinell import _core
from brinell._arrays import Array, contiguous, number
from brinell._names import level_of_caller
from brinell._reprs import cells
from brinell.contact.areas import contact_area
from brinell.errors import ConvergenceError, InputError
from brinell.halfspace import Layer, SurfaceCompliance, SurfaceGrid
from brinell.materials import RIGID, Material

__all__ = ["ContactResult", "ElasticContact"]


@dataclass(frozen=True)
class ContactResult:
    """Result of a normal contact problem.

    Attributes:
        pressure: (ny, nx) contact pressure, >= 0 [Pa].
        gap: (ny, nx) gap between the deformed surfaces [m].
        approach: approach of the bodies, imposed or found [m]; at zero load the approach at first touch.
        load: normal load, the integral of the pressure [N].
        contact_iterations: number of conjugate gradient iterations.
        converged: whether the residual is within the tolerance.
        residual: largest |gap| under pressure or penetration elsewhere [m].
        contact_area: contact area with a resolution finer than one cell, by the function `contact_area` [m^2].
        reaches_edge: whether pressure acts on the outermost cells of an axis that is not periodic. The grid then cuts
            the contact off, and the result is that of a smaller body; a `CaseWarning` says so.
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
    """Frictionless elastic contact by the preconditioned, constrained conjugate gradient method.

    The method follows Polonsky and Keer (1999). It finds the pressure p >= 0 with gap = distance - approach + A p >= 0
    and p gap = 0, where A is the surface compliance.
    """

    def __init__(
        self,
        grid: SurfaceGrid,
        lower: Material,
        upper: Material = RIGID,
        *,
        reference: float | None = None,
        lower_layers: Sequence[Layer] = (),
        upper_layers: Sequence[Layer] = (),
    ):
        """Sets up the problem and its operators.

        Args:
            grid: grid of all fields; along axes that are not periodic it must contain the whole contact.
            lower: material of the lower body; only its elastic constants are used.
            upper: material of the upper body; only its elastic constants are used.
            reference: reference distance as in `SurfaceCompliance`, from which the approach is measured [m].
            lower_layers: layers on the lower body, from the surface down, as in `SurfaceCompliance`.
            upper_layers: layers on the upper body, from its surface.

        Raises:
            InputError: both bodies are rigid, a material is invalid, or `reference` is missing or not applicable.
        """
        self.grid = grid
        self.compliance = SurfaceCompliance(
            grid, lower, upper, reference=reference, lower_layers=lower_layers, upper_layers=upper_layers
        )
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
            distance: (ny, nx) distance of the undeformed surfaces at zero approach [m].
            load: normal load, >= 0 [N].
            approach: approach of the bodies, instead of the load [m]. With two periodic axes it is at most the mean
                distance, at which the whole surface is in contact.
            mean_gap: mean gap over the period, instead of the load, with two periodic axes; >= 0 [m].
            tolerance: largest accepted residual [m]. None: 1e-7 of the overlap of the undeformed surfaces if the
                approach or the mean gap is given; 1e-7 load/(E' sqrt(area of the grid)) if the load is given.
            max_iterations: largest number of iterations.
            guess: (ny, nx) initial pressure, for example the solution of a similar problem [Pa].

        Raises:
            ConvergenceError: the residual did not reach the tolerance.
            InputError: a wrong shape, a negative load or mean gap, a mean gap without two periodic axes, an approach
                beyond full contact, or not exactly one of load, approach and mean gap.
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
            raise ConvergenceError(f"{not_solved(report)}. A larger tolerance or max_iterations may help")
        return contact_result(self.compliance, pressure, gap, report)

    def stiffness(self, pressure: ArrayLike) -> float:
        """Elastic stiffness d load/d approach of a solved contact [N/m].

        It is the stiffness of a rigid flat punch with the shape of the contact area: 0 without contact, infinite in
        full contact on a grid with two periodic axes, NaN if the computation failed.

        Args:
            pressure: (ny, nx) pressure of the solved contact [Pa]; only the set of cells with a value above zero is
                used.

        Raises:
            InputError: a wrong shape.
        """
        return _core.contact_stiffness(self.compliance._engine, contiguous(pressure, "pressure"))


def contact_result(
    compliance: SurfaceCompliance, pressure: Array, gap: Array, report: _core.ContactReport
) -> ContactResult:
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


def not_solved(report: _core.ContactReport) -> str:
    return f"no convergence after {report.iterations} iterations: the contact's residual is {_residual(report):.2e} m"


def default_tolerance(
    compliance: SurfaceCompliance, distance: Array, load: float | None, approach: float | None
) -> float:
    """Default tolerance of a normal contact [m], as documented in `ElasticContact.solve`."""
    if load is not None:
        return load_tolerance(compliance, load)
    overlap = (approach or 0.0) - float(distance.min())
    return 1e-7 * max(overlap, 0.0)


def load_tolerance(compliance: SurfaceCompliance, load: float) -> float:
    """Default tolerance [m]: 1e-7 of the displacement scale load/(E' sqrt(area of the grid)), with the load in N."""
    length = math.sqrt(math.prod(compliance.grid.shape) * compliance.grid.cell_area)
    return 1e-7 * load / (compliance.contact_modulus * length)


def drive_of(load: float | None, approach: float | None, mean_gap: float | None = None) -> _core.Drive:
    """Builds the engine's description of the imposed load, approach or mean gap.

    Raises:
        InputError: not exactly one of the three is given, the load is negative, or a value is not finite.
    """
    if (load is not None) + (approach is not None) + (mean_gap is not None) != 1:
        raise InputError("a contact needs either load or approach, or with two periodic axes mean_gap")
    if load is not None:
        return _core.Drive.of_load(number(load, "load"))
    if approach is not None:
        return _core.Drive.of_approach(number(approach, "approach"))
    return _core.Drive.of_mean_gap(number(mean_gap, "mean_gap"))
