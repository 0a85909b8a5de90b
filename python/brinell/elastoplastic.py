# SPDX-License-Identifier: BSD-3-Clause
"""Contact of two elastic-plastic bodies, increment by increment: to build a scenario of one's own.

    contact = SurfaceGrid(25, 25, 1e-6, 1e-6)
    body = VolumeGrid(contact, nz=12, dz=1e-6)
    pair = CoupledContact(contact, body, body, steel, RIGID, scale=1e-7)
    for approach in np.linspace(0, 5e-7, 11)[1:]:
        pair.advance((contact.x**2 + contact.y**2) / (2 * radius), approach=approach)
    pair.lower.residual_displacement

The plastic strain of a body stays on its own grid, over which the contact grid moves (`Place`). Arrays are [y, x] and
[z, y, x]; tensors have six components, which come first: xx, yy, zz, yz, xz, xy. z points into the body whose fields
they are, pressure is positive in compression, stress in tension. Every array is a copy of the state, which the next
increment leaves alone.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal, TypeAlias

from numpy.typing import ArrayLike

from brinell import _core
from brinell._arrays import Array, contiguous, require_positive
from brinell._reprs import cells
from brinell.constitutive import Integration
from brinell.contact import drive_of
from brinell.errors import ConvergenceError, InputError
from brinell.halfspace import SurfaceGrid, VolumeGrid, require_memory
from brinell.materials import Material

__all__ = ["BodyState", "CoupledContact", "IncrementReport", "Place", "Twin"]

Twin: TypeAlias = Literal["none", "mirror_image", "alike"]


@dataclass(frozen=True)
class Place:
    """Where the contact grid lies on a body's grid: contact column i is at column i + column + fraction.

    Attributes:
        column: whole columns.
        fraction: of a column, in [0, 1); other than 0 surfaces are interpolated.
    """

    column: int = 0
    fraction: float = 0.0

    def __post_init__(self) -> None:
        if not 0 <= self.fraction < 1:
            raise InputError(f"fraction = {self.fraction} of a place; allowed: in [0, 1)")


@dataclass(frozen=True)
class IncrementReport:
    """How an increment ended.

    Attributes:
        approach: imposed, or found for the load [m].
        load: sum of the pressure [N].
        evaluations: of the elastic-plastic operator of both bodies.
        contact_iterations: of the conjugate gradients, in all evaluations.
        yield_error: largest violation of the yield condition, over the yield stress [-].
        displacement_error: last change of the residual displacement [m].
        gap_error: complementarity of the contact [m].
        energy: locked in, elastic and dissipated in the increment [J].
    """

    approach: float
    load: float
    evaluations: int
    contact_iterations: int
    yield_error: float
    displacement_error: float
    gap_error: float
    energy: float


_BYTES_OF_BODY = 500
"""Per cell of a body that can yield, at least: operators and fields."""


class BodyState:
    """The fields of one body of a `CoupledContact`, as they are after the last increment."""

    def __init__(self, contact: _core.CoupledContact, upper: bool, grid: VolumeGrid, material: Material):
        self.grid = grid
        self.material = material
        self._contact = contact
        self._upper = upper

    def __repr__(self) -> str:
        return f"<BodyState {cells(self.grid.shape)}>"

    @property
    def plastic_strain(self) -> Array:
        """(6, nz, ny, nx) [-], xx + yy + zz = 0."""
        return self._contact.plastic_strain(self._upper)

    @property
    def equivalent_plastic_strain(self) -> Array:
        """(nz, ny, nx) accumulated [-]."""
        return self._contact.equivalent_plastic_strain(self._upper)

    @property
    def backstress(self) -> Array:
        """(terms, 6, nz, ny, nx) of kinematic hardening [Pa]."""
        return self._contact.backstress(self._upper)

    @property
    def stress(self) -> Array:
        """(6, nz, ny, nx) of the pressure, the plastic strain and what was there before the first load [Pa].

        Raises:
            InputError: the body is rigid.
        """
        return self._contact.stress(self._upper)

    @property
    def residual_displacement(self) -> Array:
        """(ny, nx) of the surface, by the plastic strain, into the body positive [m]."""
        return self._contact.residual_displacement(self._upper)

    @property
    def dissipation(self) -> float:
        """Plastic work since the start [J]; with back stresses, a part of it stays in the material."""
        return self._contact.dissipation(self._upper)

    @property
    def locked_in_energy(self) -> float:
        """Elastic energy of the residual stress [J]."""
        return self._contact.locked_in_energy(self._upper)


class CoupledContact:
    """Two bodies with their history. One thread at a time may use it.

    Attributes:
        grid: the `SurfaceGrid` of the contact.
        lower: the `BodyState` of the lower body.
        upper: the `BodyState` of the upper body.
    """

    def __init__(
        self,
        contact: SurfaceGrid,
        lower: VolumeGrid,
        upper: VolumeGrid,
        lower_material: Material,
        upper_material: Material,
        *,
        scale: float,
        yield_tolerance: float = 1e-4,
        displacement_tolerance: float = 1e-5,
        contact_tolerance: float = 1e-7,
        twin: Twin = "none",
        lower_texture: ArrayLike | None = None,
        upper_texture: ArrayLike | None = None,
    ):
        """Plans the operators of both bodies; they are without plastic strain.

        Args:
            contact: grid of the contact.
            lower: grid of the lower body, with the rows and cells of `contact`, and columns wherever it will pass.
            upper: that of the upper one; what it is for a rigid body does not matter but for its rows and cells.
            lower_material: a body without hardening law stays elastic.
            upper_material: at least one is not `RIGID`.
            scale: a length to which tolerances of lengths are relative [m]: the approach at first yield is a good one.
            yield_tolerance: largest violation of the yield condition, relative to the yield stress.
            displacement_tolerance: largest change of the residual displacement in the last evaluation, over `scale`.
            contact_tolerance: largest gap under pressure, over `scale`.
            twin: of two bodies that are alike only the lower one is solved, and the upper one has its fields:
                "mirror_image", reversed in x (asperities that pass each other), or "alike" (rolling).
            lower_texture: (ny, nx) on the grid of the lower body: depth of its surface before the first load [m].
            upper_texture: the same for the upper body.

        Raises:
            InputError: what does not fit together.
        """
        if twin not in ("none", "mirror_image", "alike"):
            raise InputError(f'twin = "{twin}"; allowed: "none", "mirror_image" or "alike"')
        require_positive(
            scale=scale,
            yield_tolerance=yield_tolerance,
            displacement_tolerance=displacement_tolerance,
            contact_tolerance=contact_tolerance,
        )
        for grid, material in ((lower, lower_material), (upper, upper_material)):
            if material.hardening is not None:
                require_memory(grid.nz * grid.surface.nx * grid.surface.ny, _BYTES_OF_BODY, "a body")
        self.grid = contact
        self._has_twin = twin != "none"
        self._engine = _core.CoupledContact(
            contact._engine,
            lower._engine,
            upper._engine,
            lower_material._engine,
            upper_material._engine,
            _core.Scales(scale, scale),
            _core.Settings(yield_tolerance, displacement_tolerance, contact_tolerance),
            getattr(_core.Twin, twin),
            None if lower_texture is None else contiguous(lower_texture, "lower_texture"),
            None if upper_texture is None else contiguous(upper_texture, "upper_texture"),
        )
        self.lower = BodyState(self._engine, False, lower, lower_material)
        self.upper = BodyState(self._engine, True, upper, upper_material)

    def __repr__(self) -> str:
        return f"<CoupledContact {cells(self.grid.shape)}>"

    def set_softening(self, lower: ArrayLike | None = None, upper: ArrayLike | None = None) -> None:
        """Sets factors on the yield stress, as by the temperature; they hold from the next increment on.

        Args:
            lower: (nz, ny, nx) of the cells of the lower body, > 0, as by
                `brinell.constitutive.softening_factor` [-]; None: 1 everywhere.
            upper: the same of the upper body; a twin has those of the lower one.

        Raises:
            InputError: a wrong shape, a factor that is not above 0, or factors for a twin.
        """
        if upper is not None and self._has_twin:
            raise InputError("upper: a twin has the softening of the lower body; allowed: None")
        self._engine.set_softening(
            None if lower is None else contiguous(lower, "lower"), None if upper is None else contiguous(upper, "upper")
        )

    def advance(
        self,
        distance: ArrayLike,
        *,
        load: float | None = None,
        approach: float | None = None,
        mean_gap: float | None = None,
        lower: Place = Place(),
        upper: Place = Place(),
        integration: Integration = "path",
        max_evaluations: int = 60,
        anderson_depth: int = 6,
    ) -> IncrementReport:
        """Solves one increment from the present state, and keeps it. Ctrl-C stops between two evaluations.

        Args:
            distance: (ny, nx) of the smooth, undeformed surfaces on the contact grid where they touch without load [m].
            load: [N], >= 0.
            approach: instead of the load [m].
            mean_gap: instead, with two periodic axes, the mean gap over the period, >= 0 [m].
            lower: where the contact grid lies on the lower body's.
            upper: where it lies on the upper body's.
            integration: of the plastic strain: "path", second order in the increment, or "backward_euler", first order.
            max_evaluations: after which an attempt is given up.
            anderson_depth: earlier evaluations used to accelerate; 0: plain fixed point.

        Raises:
            ConvergenceError: two attempts did not converge, and a smaller increment may help. After any error, and
                after Ctrl-C, everything is as it was before.
            InputError: a wrong shape, a negative load or mean gap, not one of load, approach and mean gap, or
                a contact that leaves a grid.
        """
        if integration not in ("path", "backward_euler"):
            raise InputError(f'integration = "{integration}"; allowed: "path" or "backward_euler"')
        if max_evaluations < 1 or anderson_depth < 0:
            raise InputError(
                f"max_evaluations = {max_evaluations}, anderson_depth = {anderson_depth}; allowed: from 1 and from 0 on"
            )
        distance = contiguous(distance, "distance")
        drive = drive_of(load, approach, mean_gap)
        evaluations = 0
        # A cell's own stiffness converges fastest; with all of it the plain fixed point would descend always.
        for stiffness_share in (0.6, 1.0):
            report = self._engine.advance(
                distance,
                drive,
                _core.Place(lower.column, lower.fraction),
                _core.Place(upper.column, upper.fraction),
                getattr(_core.Integration, integration),
                max_evaluations,
                anderson_depth,
                stiffness_share,
            )
            evaluations += report.evaluations
            if report.converged:
                return IncrementReport(
                    report.approach,
                    self._engine.load,
                    evaluations,
                    report.contact_iterations,
                    report.yield_error,
                    report.displacement_error,
                    report.gap_error,
                    report.energy,
                )
        raise ConvergenceError(
            f"no convergence after {evaluations} evaluations; yield violation {report.yield_error:.2e} S_y, change of "
            f"displacement {report.displacement_error:.2e} m, contact gap {report.gap_error:.2e} m. "
            "A smaller increment or a larger max_evaluations may help"
        )

    @property
    def pressure(self) -> Array:
        """(ny, nx) on the contact grid [Pa]."""
        return self._engine.pressure

    @property
    def gap(self) -> Array:
        """(ny, nx) on the contact grid [m]."""
        return self._engine.gap

    @property
    def approach(self) -> float:
        """Of the last increment [m]."""
        return self._engine.approach

    @property
    def load(self) -> float:
        """Sum of the pressure [N]."""
        return self._engine.load

    @property
    def elastic_energy(self) -> float:
        """What unloading gives back, 1/2 p A p [J]."""
        return self._engine.elastic_energy

    @property
    def reaches_edge(self) -> bool:
        """Whether pressure acts on the outermost cells of the contact grid, so that this is too small."""
        return self._engine.reaches_edge
