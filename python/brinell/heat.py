# SPDX-License-Identifier: BSD-3-Clause
"""Heat flux into the surface of a half space: temperature rise, thermal displacement and thermal stress.

The grid is at rest on the body, and the flux moves over it; the surface is adiabatic elsewhere. Arrays are [y, x].
The theory page on heat describes the method, which tugging, rolling, sliding and fretting use.

    grid = SurfaceGrid(64, 64, 1e-5, 1e-5)
    steel = Thermal(conductivity=50, density=7850, specific_heat=450)
    steady = HeatResponse(grid, steel, velocity=1.0).temperature(flux)

Thermal displacement and stress need the thermal expansion as well:

    steel = Thermal(conductivity=50, density=7850, specific_heat=450, expansion=12e-6)
    field = ThermalField(grid, steel, Material("210 GPa", 0.3), shortest_step=1e-5, duration=1e-3, depths=[0.0, 2e-5])
    field.step(flux, duration=1e-5, velocity=1.0)
    u_z, stress = field.displacement(), field.stress()
    always = SteadyField(grid, steel, Material("210 GPa", 0.3), velocity=1.0, depths=[0.0, 2e-5])
    u_z, stress = always.displacement(flux), always.stress(flux)

Layers on the body are those of `brinell.halfspace`, of materials with thermal constants; under a flux that has always
been there they are not computed:

    carbon = Material("150 GPa", 0.2, thermal=Thermal(conductivity=2, density=2200, specific_heat=900, expansion=2e-6))
    coated = HeatResponse(grid, steel, duration=1e-5, velocity=1.0, layers=[Layer(5e-6, carbon)])
"""

from __future__ import annotations

import math
import sys
from collections.abc import Sequence

from numpy.typing import ArrayLike

from brinell import _core
from brinell._arguments import explain_argument_errors
from brinell._arrays import Array, contiguous, number
from brinell._reprs import cells
from brinell.errors import InputError
from brinell.halfspace import Layer, SurfaceGrid, require_memory
from brinell.materials import Material, Thermal

__all__ = ["HeatResponse", "SteadyField", "SurfaceTemperature", "ThermalField"]

_BYTES_OF_RESPONSE, _BYTES_OF_MEMORY, _BYTES_OF_FIELD = 130, 1500, 5000
"""Memory per cell [B] of an operator, of the state of all waves (without most images), and of that state with fields in
the body."""
_BYTES_OF_EXCESS, _BYTES_OF_FINE_EXCESS = 10_000, 90_000
"""Memory per cell [B] that the response of a coated body takes while it is found; and where its first layer is thinner
than a cell."""
_BYTES_OF_STEADY_LAYER = 500
"""Memory per cell and depth [B]: seven operators, and one table for each of them during the setup."""


class HeatResponse:
    """Surface temperature at the end of a time during which a constant flux rested on the body or moved over it.

    The operator is exact for cells of uniform flux (Carslaw and Jaeger 1959) at any speed. There are periodic images
    only along axes that are periodic.
    """

    def __init__(
        self,
        grid: SurfaceGrid,
        thermal: Thermal,
        *,
        duration: float | None = None,
        velocity: float | tuple[float, float] = 0.0,
        layers: Sequence[Layer] = (),
    ):
        """Sets up the operator.

        Args:
            grid: grid of flux and temperature.
            thermal: thermal constants of the body.
            duration: time for which the flux has acted [s]; None: infinite, the steady state.
            velocity: velocity of the flux over the body, along x, or along x and y [m/s].
            layers: layers on the body, from the surface down, of materials with thermal constants; `thermal` is that of
                the body beneath. They need a duration.

        Raises:
            InputError: a duration that is not above 0; a steady state that does not exist because heat accumulates
                along a periodic axis, or of a body with layers; a first layer thinner than a quarter of a cell; or a
                grid that needs more memory than the machine has.
        """
        of_excess = 0
        if layers:
            is_thin = layers[0].thickness < max(grid.dx, grid.dy)
            of_excess = _BYTES_OF_FINE_EXCESS if is_thin else _BYTES_OF_EXCESS
        require_memory(grid.nx * grid.ny, _BYTES_OF_RESPONSE + of_excess, "a surface")
        self.grid = grid
        self._engine = _core.HeatResponse(
            grid._engine, thermal._engine, _motion(duration, velocity), _constants(layers)
        )

    def __repr__(self) -> str:
        return f"<HeatResponse {cells(self.grid.shape)}>"

    def temperature(self, flux: ArrayLike) -> Array:
        """Temperature rise of the surface at the end of the duration.

        Args:
            flux: (ny, nx) heat flux into the body, at its position at the end [W/m^2].

        Returns:
            (ny, nx) temperature rise at the cell centres [K].
        """
        return self._engine.temperature(contiguous(flux, "flux"))


class SurfaceTemperature:
    """Surface temperature under a heat flux that is given step by step.

    The thermal history of the body is stored in a fixed amount of memory, and the cost of a step does not depend on the
    number of earlier steps. A step is exact for a flux that is constant while it moves with the velocity of the step.
    """

    def __init__(self, grid: SurfaceGrid, thermal: Thermal, *, shortest_step: float, duration: float):
        """Sets up the history of a body without initial temperature rise.

        Args:
            grid: grid of flux and temperature, at rest on the body.
            thermal: thermal constants of the body.
            shortest_step: lower bound of the durations of all steps [s].
            duration: upper bound of the total time of all steps [s].

        Raises:
            InputError: times that are not above 0, a duration below the shortest step, or a grid that needs more memory
                than the machine has.
        """
        require_memory(grid.nx * grid.ny, _BYTES_OF_MEMORY, "the memory of a surface")
        self.grid = grid
        self._thermal = thermal
        self._engine = _core.SurfaceTemperature(
            grid._engine, thermal._engine, number(shortest_step, "shortest_step"), number(duration, "duration")
        )
        self._response: tuple[tuple[object, ...], HeatResponse] | None = None  # that of the last motion, for reuse

    def __repr__(self) -> str:
        return f"<SurfaceTemperature {cells(self.grid.shape)}, {self.time:g} s>"

    @property
    def time(self) -> float:
        """Total time of the steps so far [s]."""
        return self._engine.time

    def step(self, flux: ArrayLike, duration: float, velocity: float | tuple[float, float] = 0.0) -> Array:
        """Advances the body by one step.

        Args:
            flux: (ny, nx) heat flux into the body, at its position at the end of the step [W/m^2].
            duration: duration of the step [s].
            velocity: velocity of the flux over the body, along x, or along x and y [m/s].

        Returns:
            (ny, nx) temperature rise of the surface at the end of the step [K].

        Raises:
            InputError: the step is shorter than `shortest_step`, or ends after `duration`.
        """
        heat = contiguous(flux, "flux")
        rise = self._engine.remaining(number(duration, "duration"))
        motion = (duration, velocity)
        if self._response is None or self._response[0] != motion:
            self._response = motion, HeatResponse(self.grid, self._thermal, duration=duration, velocity=velocity)
        rise += self._response[1].temperature(heat)
        self._engine.add_step(heat, _motion(duration, velocity))
        return rise


class ThermalField:
    """Thermal displacement of the surface, temperature and stress in the body under a flux that is given step by step.

    The surface is free of traction. The history is stored as in `SurfaceTemperature`. Along open axes the error by
    periodic images is some 1e-3 of the largest value. The displacement is relative to points far away; under a flux at
    rest it grows with the logarithm of the time. If both axes are periodic, the mean strain along the surface is zero.
    """

    def __init__(
        self,
        grid: SurfaceGrid,
        thermal: Thermal,
        material: Material,
        *,
        shortest_step: float,
        duration: float,
        depths: Sequence[float] = (),
        layers: Sequence[Layer] = (),
    ):
        """Sets up the history of a body without initial temperature rise.

        Args:
            grid: grid of flux and fields, at rest on the body.
            thermal: thermal constants of the body, with its expansion.
            material: material of the body; only its elastic constants are used.
            shortest_step: lower bound of the durations of all steps [s].
            duration: upper bound of the total time of all steps [s].
            depths: depths at which temperature and stress are computed [m]; 0 is the surface. An interface belongs to
                what is beneath.
            layers: layers on the body, from the surface down, of materials with thermal constants; `thermal` and
                `material` are those of the body beneath.

        Raises:
            InputError: times that are not above 0, a duration below the shortest step, a negative depth, a rigid body,
                or a grid that needs more memory than the machine has.
        """
        if material.is_rigid:
            raise InputError("a rigid body has no thermal stress; allowed: an elastic material")
        require_memory(grid.nx * grid.ny, _BYTES_OF_FIELD, "the memory of a heated body")
        self.grid = grid
        self.depths = tuple(number(depth, "depths") for depth in depths)
        self._engine = _core.ThermalField(
            grid._engine,
            thermal._engine,
            material._engine,
            number(shortest_step, "shortest_step"),
            number(duration, "duration"),
            list(self.depths),
            _constants(layers),
        )

    def __repr__(self) -> str:
        return f"<ThermalField {cells(self.grid.shape)}, {len(self.depths)} layers, {self.time:g} s>"

    @property
    def time(self) -> float:
        """Total time of the steps so far [s]."""
        return self._engine.time

    def step(self, flux: ArrayLike, duration: float, velocity: float | tuple[float, float] = 0.0) -> None:
        """Advances the body by one step.

        Args:
            flux: (ny, nx) heat flux into the body, at its position at the end of the step [W/m^2].
            duration: duration of the step [s].
            velocity: velocity of the flux over the body, along x, or along x and y [m/s].

        Raises:
            InputError: the step is shorter than `shortest_step`, or ends after `duration`.
        """
        self._engine.add_step(contiguous(flux, "flux"), _motion(duration, velocity))

    def displacement(self, axis: str = "z", *, later: float = 0.0) -> Array:
        """Thermal displacement of the surface.

        Args:
            axis: direction "x", "y" or "z". z points into the body, so thermal expansion gives negative values.
            later: time after the end of the last step, without flux [s]: 0, or at least `shortest_step`.

        Returns:
            (ny, nx) displacement [m].

        Raises:
            InputError: an unknown axis, or a time `later` that is not allowed.
        """
        if axis not in ("x", "y", "z"):
            raise InputError(f"axis = {axis!r} of a displacement; allowed: 'x', 'y', 'z'")
        return self._engine.displacement(axis, number(later, "later"))

    def temperature(self, *, later: float = 0.0) -> Array:
        """Temperature rise at the depths, (len(depths), ny, nx) [K]; `later` as in `displacement`."""
        return self._engine.temperature(number(later, "later"))

    def stress(self, *, later: float = 0.0) -> Array:
        """Stress at the depths, (6, len(depths), ny, nx) [Pa], at the cell centres; `later` as in `displacement`."""
        return self._engine.stress(number(later, "later"))


class SteadyField:
    """Steady thermal displacement, temperature and stress under a flux that has always moved along x or been at rest.

    The surface is free of traction. Along open axes the error by periodic images is some 1e-5 of the largest value. The
    displacement of a moving flux is relative to points far away.
    """

    def __init__(
        self,
        grid: SurfaceGrid,
        thermal: Thermal,
        material: Material,
        *,
        velocity: float = 0.0,
        reference: float | None = None,
        depths: Sequence[float] = (),
    ):
        """Sets up the operators.

        Args:
            grid: grid of flux and fields, open along x.
            thermal: thermal constants of the body, with its expansion.
            material: material of the body; only its elastic constants are used.
            velocity: velocity of the flux over the body, along x [m/s].
            reference: for a flux at rest: distance at which the displacement of the surface is set to zero [m].
            depths: depths at which temperature and stress are computed [m]; 0 is the surface.

        Raises:
            InputError: a negative depth, a rigid body, a steady state that does not exist because heat accumulates
                along a periodic axis, or a grid that needs more memory than the machine has.
        """
        if material.is_rigid:
            raise InputError("a rigid body has no thermal stress; allowed: an elastic material")
        self.depths = tuple(number(depth, "depths") for depth in depths)
        layers = _BYTES_OF_STEADY_LAYER * (1 + len(self.depths))
        require_memory(grid.nx * grid.ny, layers, "a heated body")
        self.grid = grid
        self._engine = _core.SteadyField(
            grid._engine,
            thermal._engine,
            material._engine,
            number(velocity, "velocity"),
            None if reference is None else number(reference, "reference"),
            list(self.depths),
        )

    def __repr__(self) -> str:
        return f"<SteadyField {cells(self.grid.shape)}, {len(self.depths)} layers>"

    def displacement(self, flux: ArrayLike) -> Array:
        """Displacement of the surface along z, positive into the body, so thermal expansion gives negative values.

        Args:
            flux: (ny, nx) heat flux into the body [W/m^2].

        Returns:
            (ny, nx) displacement [m].

        Raises:
            InputError: the flux is at rest, and no `reference` was given.
        """
        return self._engine.displacement(contiguous(flux, "flux"))

    def temperature(self, flux: ArrayLike) -> Array:
        """Temperature rise at the depths, (len(depths), ny, nx) [K]; flux: (ny, nx) into the body [W/m^2]."""
        return self._engine.temperature(contiguous(flux, "flux"))

    def stress(self, flux: ArrayLike) -> Array:
        """Stress at the depths, (6, len(depths), ny, nx) [Pa], at the cell centres; flux: (ny, nx) [W/m^2]."""
        return self._engine.stress(contiguous(flux, "flux"))


def _constants(layers: Sequence[Layer]) -> list[tuple[float, float, float, _core.Thermal]]:
    constants = []
    for n, layer in enumerate(layers):
        if layer.material.thermal is None:
            raise InputError(f"the material of layer {n} has no thermal constants; allowed: Material(..., thermal=...)")
        constants.append((*layer._constants, layer.material.thermal._engine))
    return constants


def _motion(duration: float | None, velocity: float | tuple[float, float]) -> _core.HeatMotion:
    pair = velocity if isinstance(velocity, tuple) else (velocity, 0.0)
    if len(pair) != 2:
        raise InputError(f"velocity = {velocity}; allowed: a number, or a pair for x and y")
    seconds = math.inf if duration is None else number(duration, "duration")
    return _core.HeatMotion(seconds, number(pair[0], "velocity"), number(pair[1], "velocity"))


explain_argument_errors(sys.modules[__name__])
