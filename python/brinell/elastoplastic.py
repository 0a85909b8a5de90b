# SPDX-License-Identifier: BSD-3-Clause
"""Contact of two elastic-plastic bodies, increment by increment, as a basis for scenarios of your own.

    contact = SurfaceGrid(25, 25, 1e-6, 1e-6)
    body = VolumeGrid(contact, nz=12, dz=1e-6)
    pair = CoupledContact(contact, body, body, steel, RIGID, scale=1e-7)
    for approach in np.linspace(0, 5e-7, 11)[1:]:
        pair.advance((contact.x**2 + contact.y**2) / (2 * radius), approach=approach)
    pair.lower.residual_displacement

The plastic strain of each body is stored on the body's own grid, over which the contact grid moves (`Place`). Arrays
are [y, x] and [z, y, x]; tensors have six components, which come first: xx, yy, zz, yz, xz, xy. z points into the
respective body, pressure is positive in compression, stress in tension. Every array is a copy of the state, so the next
increment does not change it.
"""

from __future__ import annotations

import math
import sys
from collections.abc import Callable
from dataclasses import dataclass
from typing import Literal, TypeAlias

from numpy.typing import ArrayLike

from brinell import _core
from brinell._arguments import explain_argument_errors
from brinell._arrays import Array, contiguous, require_positive
from brinell._reprs import cells
from brinell.constitutive import Integration
from brinell.contact.normal import drive_of
from brinell.errors import ConvergenceError, InputError
from brinell.halfspace import SurfaceGrid, VolumeGrid, require_memory
from brinell.materials import Material

__all__ = ["BodyState", "CoupledContact", "IncrementReport", "Place", "Twin", "WearLaw"]

Twin: TypeAlias = Literal["none", "mirror_image", "alike"]

WearLaw: TypeAlias = Literal["archard", "energy"] | Callable[[float, float], float]
"""A wear law: a word, or the intensity of wear [Pa] as a function of pressure and shear [Pa], >= 0 and finite. Where it
falls with the pressure, large increments may not converge."""


@dataclass(frozen=True)
class Place:
    """Position of the contact grid on a body's grid: contact column i is at body column i + column + fraction.

    Attributes:
        column: offset in whole columns.
        fraction: additional offset as a fraction of a column, in [0, 1). If it is not 0, surfaces are interpolated.

    Raises:
        InputError: the fraction is not in [0, 1).
    """

    column: int = 0
    fraction: float = 0.0

    def __post_init__(self) -> None:
        if not 0 <= self.fraction < 1:
            raise InputError(f"fraction = {self.fraction} of a place; allowed: in [0, 1)")


@dataclass(frozen=True)
class IncrementReport:
    """Convergence data of an increment.

    Attributes:
        approach: approach at the end, imposed or found for the load [m].
        load: normal load at the end, the integral of the pressure [N].
        evaluations: number of evaluations of the elastic-plastic operator of both bodies.
        contact_iterations: number of conjugate gradient iterations in all evaluations.
        yield_error: largest violation of the yield condition, relative to the yield stress [-].
        displacement_error: change of the residual displacement in the last evaluation [m].
        gap_error: error of the complementarity condition of the contact [m].
        energy: sum of the locked-in and elastic energy and the dissipation of the increment [J].
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
"""Least memory per cell [B] of a body that can yield, for its operators and fields."""


class BodyState:
    """Fields of one body of a `CoupledContact` after the last increment."""

    def __init__(self, contact: _core.CoupledContact, upper: bool, grid: VolumeGrid, material: Material):
        self.grid = grid
        self.material = material
        self._contact = contact
        self._upper = upper

    def __repr__(self) -> str:
        return f"<BodyState {cells(self.grid.shape)}>"

    @property
    def plastic_strain(self) -> Array:
        """(6, nz, ny, nx) plastic strain, xx + yy + zz = 0 [-]."""
        return self._contact.plastic_strain(self._upper)

    @property
    def equivalent_plastic_strain(self) -> Array:
        """(nz, ny, nx) accumulated equivalent plastic strain [-]."""
        return self._contact.equivalent_plastic_strain(self._upper)

    @property
    def backstress(self) -> Array:
        """(terms, 6, nz, ny, nx) back stresses of kinematic hardening [Pa]."""
        return self._contact.backstress(self._upper)

    @property
    def stress(self) -> Array:
        """(6, nz, ny, nx) stress of pressure, shear and plastic strain, plus the initial stress of the material [Pa].

        Raises:
            InputError: the body is rigid.
        """
        return self._contact.stress(self._upper)

    @property
    def residual_displacement(self) -> Array:
        """(ny, nx) residual normal displacement of the surface by the plastic strain, positive into the body [m]."""
        return self._contact.residual_displacement(self._upper)

    @property
    def worn_depth(self) -> Array:
        """(ny, nx) depth that the surface has lost by wear since the start [m]."""
        return self._contact.worn_depth(self._upper)

    @property
    def worn_volume(self) -> float:
        """Volume that the body has lost by wear since the start [m^3]."""
        return self._contact.worn_volume(self._upper)

    @property
    def dissipation(self) -> float:
        """Plastic work since the start [J]; with back stresses, a part of it is stored in the material."""
        return self._contact.dissipation(self._upper)

    @property
    def locked_in_energy(self) -> float:
        """Elastic energy of the residual stress [J]."""
        return self._contact.locked_in_energy(self._upper)


def _wear_law(friction: float, wear: tuple[float, float], law: WearLaw) -> _core.WearLaw:
    """The wear of both surfaces.

    Raises:
        InputError: a number is below 0 or not finite, or a law is unknown, or has nothing to follow.
    """
    for name, number in (("friction", friction), ("wear[0]", wear[0]), ("wear[1]", wear[1])):
        if not (number >= 0 and math.isfinite(number)):
            raise InputError(f"{name} = {number}; allowed: >= 0")
    if not callable(law) and law not in ("archard", "energy"):
        raise InputError(f'wear_law = {law!r}; allowed: "archard", "energy" or a function of pressure and shear')
    if law == "energy" and friction == 0 and any(wear):
        raise InputError('wear_law = "energy" with friction = 0: no friction work, no wear; allowed: friction > 0')
    return _core.WearLaw(*wear, law)


class CoupledContact:
    """Two elastic-plastic bodies in contact, with their loading history. Only one thread at a time may use an object.

    Attributes:
        grid: `SurfaceGrid` of the contact.
        lower: `BodyState` of the lower body.
        upper: `BodyState` of the upper body.
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
        friction: float = 0.0,
        wear: tuple[float, float] = (0.0, 0.0),
        wear_law: WearLaw = "archard",
    ):
        """Sets up the operators of both bodies, which start without plastic strain.

        Args:
            contact: grid of the contact.
            lower: grid of the lower body, with the same number of rows and the same cell size as `contact`, and with
                enough columns for every position of the contact.
            upper: grid of the upper body, as `lower`. For a rigid body only its rows and cell size matter.
            lower_material: material of the lower body; without a hardening law the body stays elastic.
            upper_material: material of the upper body. At least one of the two is not `RIGID`.
            scale: length to which the tolerances of lengths are relative [m], for example the approach at first yield.
            yield_tolerance: largest violation of the yield condition, relative to the yield stress [-].
            displacement_tolerance: largest change of the residual displacement in the last evaluation, relative to
                `scale`, or to its change in the increment if that is larger [-].
            contact_tolerance: largest gap under pressure, relative to `scale` [-]. At most a thousandth of
                `yield_tolerance` and a hundredth of `displacement_tolerance` is used, or 1e-12 if that is more.
            twin: for two equal bodies, of which only the lower one is solved: "mirror_image" gives the upper body the
                fields of the lower one mirrored in x (asperities that pass each other), "alike" the same fields
                (rolling). "none": both bodies are solved.
            lower_texture: (ny, nx) on the grid of the lower body, depth of its surface before the first load [m]; None:
                smooth.
            upper_texture: the same for the upper body.
            friction: shear over pressure where the surfaces slide, >= 0 [-].
            wear: wear coefficients of the lower and the upper surface, >= 0 [1/Pa]. A surface loses the depth
                coefficient x intensity x sliding distance.
            wear_law: the intensity of the wear: "archard", the pressure; "energy", the shear; or a function of both,
                ``intensity(pressure, shear)``, in Pa, which is called cell by cell where the pressure is above 0. See
                `brinell.elastoplastic.WearLaw`.

        Raises:
            InputError: grids, materials, textures, wear and `twin` are not compatible, a tolerance is not above 0, a
                coefficient is below 0, a wear law gives a number below 0, or a body needs more memory than the machine
                has.
        """
        if twin not in ("none", "mirror_image", "alike"):
            raise InputError(f'twin = "{twin}"; allowed: "none", "mirror_image" or "alike"')
        require_positive(
            scale=scale,
            yield_tolerance=yield_tolerance,
            displacement_tolerance=displacement_tolerance,
            contact_tolerance=contact_tolerance,
        )
        law = _wear_law(friction, wear, wear_law)
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
            friction,
            law,
        )
        self.lower = BodyState(self._engine, False, lower, lower_material)
        self.upper = BodyState(self._engine, True, upper, upper_material)

    def __repr__(self) -> str:
        return f"<CoupledContact {cells(self.grid.shape)}>"

    def set_softening(self, lower: ArrayLike | None = None, upper: ArrayLike | None = None) -> None:
        """Sets factors on the yield stress, for example for thermal softening; they apply from the next increment on.

        Args:
            lower: (nz, ny, nx) factors of the cells of the lower body, > 0, for example from
                `brinell.constitutive.softening_factor` [-]; None: 1 everywhere.
            upper: the same for the upper body; a twin uses those of the lower body.

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
        slid: float = 0.0,
        lower: Place = Place(),
        upper: Place = Place(),
        integration: Integration = "path",
        max_evaluations: int = 60,
        anderson_depth: int = 6,
    ) -> IncrementReport:
        """Solves one increment from the present state and stores the new state.

        Ctrl-C stops the solution between two evaluations. After an error or Ctrl-C the state is unchanged.

        Args:
            distance: (ny, nx) distance of the smooth, undeformed surfaces at zero approach, on the contact grid [m].
            load: normal load at the end of the increment, >= 0 [N].
            approach: approach at the end of the increment, instead of the load [m].
            mean_gap: mean gap over the period, instead of the load, with two periodic axes; >= 0 [m].
            slid: distance that the undeformed upper surface slides over the lower one along x in the increment [m];
                negative: towards -x. 0: the surfaces do not slide, so that there is neither shear nor wear.
            lower: position of the contact grid on the grid of the lower body.
            upper: position of the contact grid on the grid of the upper body.
            integration: of the plastic strain: "path", second order in the increment, or "backward_euler", first order.
            max_evaluations: largest number of evaluations of each of two attempts.
            anderson_depth: number of earlier evaluations in the Anderson acceleration; 0: plain fixed-point iteration.

        Raises:
            ConvergenceError: two attempts did not converge; a smaller increment may help.
            InputError: a wrong shape, a negative load or mean gap, not exactly one of load, approach and mean gap, a
                wear law that gives a number below 0, or a contact that leaves a grid.
        """
        if integration not in ("path", "backward_euler"):
            raise InputError(f'integration = "{integration}"; allowed: "path" or "backward_euler"')
        if max_evaluations < 1 or anderson_depth < 0:
            raise InputError(
                f"max_evaluations = {max_evaluations}, anderson_depth = {anderson_depth}; allowed: from 1 and from 0 on"
            )
        if not math.isfinite(slid):
            raise InputError(f"slid = {slid}; allowed: a finite distance")
        distance = contiguous(distance, "distance")
        drive = drive_of(load, approach, mean_gap)
        evaluations = 0
        # A share of 0.6 of a cell's own stiffness converges fastest. With the full stiffness the plain fixed-point
        # iteration always descends, so it is the second attempt.
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
                slid,
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
        """(ny, nx) pressure on the contact grid [Pa]."""
        return self._engine.pressure

    @property
    def shear(self) -> Array:
        """(ny, nx) shear along x on the lower body, on the contact grid [Pa]; 0 without friction or sliding."""
        return self._engine.shear

    @property
    def gap(self) -> Array:
        """(ny, nx) gap between the deformed surfaces on the contact grid [m]."""
        return self._engine.gap

    @property
    def approach(self) -> float:
        """Approach at the end of the last increment [m]."""
        return self._engine.approach

    @property
    def load(self) -> float:
        """Normal load, the integral of the pressure [N]."""
        return self._engine.load

    @property
    def elastic_energy(self) -> float:
        """Elastic energy of pressure and shear that is recovered on unloading [J]."""
        return self._engine.elastic_energy

    @property
    def reaches_edge(self) -> bool:
        """Whether pressure acts on the outermost cells of the contact grid, which is then too small."""
        return self._engine.reaches_edge


explain_argument_errors(sys.modules[__name__])
