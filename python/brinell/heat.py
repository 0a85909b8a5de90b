# SPDX-License-Identifier: BSD-3-Clause
"""Heat: a flux into the surface of a half space, the rise of its temperature, and how that swells and stresses it.

The grid is at rest on the body, and the flux moves over it; no heat leaves the surface elsewhere. Arrays are [y, x].
The method is on the page on heat of the theory. Tugging, rolling and sliding use it.

    grid = SurfaceGrid(64, 64, 1e-5, 1e-5)
    steel = Thermal(conductivity=50, density=7850, specific_heat=450)
    steady = HeatResponse(grid, steel, velocity=1.0).temperature(flux)

What heat does to an elastic body needs its thermal expansion, too:

    steel = Thermal(conductivity=50, density=7850, specific_heat=450, expansion=12e-6)
    field = ThermalField(grid, steel, Material("210 GPa", 0.3), shortest_step=1e-5, duration=1e-3, depths=[0.0, 2e-5])
    field.step(flux, duration=1e-5, velocity=1.0)
    u_z, stress = field.displacement(), field.stress()
    always = SteadyField(grid, steel, Material("210 GPa", 0.3), velocity=1.0, depths=[0.0, 2e-5])
    u_z, stress = always.displacement(flux), always.stress(flux)
"""

from __future__ import annotations

import math
from collections.abc import Sequence

from numpy.typing import ArrayLike

from brinell import _core
from brinell._arrays import Array, contiguous, number
from brinell._reprs import cells
from brinell.errors import InputError
from brinell.halfspace import SurfaceGrid, require_memory
from brinell.materials import Material, Thermal

__all__ = ["HeatResponse", "SteadyField", "SurfaceTemperature", "ThermalField"]

_BYTES_OF_RESPONSE, _BYTES_OF_MEMORY, _BYTES_OF_FIELD = 130, 1500, 5000
"""Per cell: the planned operator; the state of all waves, without most images; the same for fields in the body."""
_BYTES_OF_STEADY_LAYER = 500
"""Per cell and depth: seven planned operators, and while they are planned a table each."""


class HeatResponse:
    """A flux that has been constant while it stood or moved over the body -> temperature of the surface at the end.

    Exact for cells of uniform flux (Carslaw and Jaeger 1959), at any speed, without periodic images but along axes that
    are periodic.
    """

    def __init__(
        self,
        grid: SurfaceGrid,
        thermal: Thermal,
        *,
        duration: float | None = None,
        velocity: float | tuple[float, float] = 0.0,
    ):
        """Plans the operator.

        Args:
            grid: of flux and temperature.
            thermal: constants of the body.
            duration: for how long [s]; None: for ever, the steady state.
            velocity: of the flux over the body, along x, or along x and y [m/s].

        Raises:
            InputError: a duration that is not above 0; a steady state that there is not, because heat piles up along a
                periodic axis.
        """
        require_memory(grid.nx * grid.ny, _BYTES_OF_RESPONSE, "a surface")
        self.grid = grid
        self._engine = _core.HeatResponse(grid._engine, thermal._engine, _motion(duration, velocity))

    def __repr__(self) -> str:
        return f"<HeatResponse {cells(self.grid.shape)}>"

    def temperature(self, flux: ArrayLike) -> Array:
        """Rise of the temperature at the end.

        Args:
            flux: (ny, nx) into the body [W/m^2], where it is at the end.

        Returns:
            (ny, nx) [K], in the middles of the cells.
        """
        return self._engine.temperature(contiguous(flux, "flux"))


class SurfaceTemperature:
    """Flux, step by step -> temperature of the surface.

    What a body remembers of all steps has a fixed size, and a step costs the same however many there were. A step is
    exact for a flux that is constant while it moves with the step's velocity.
    """

    def __init__(self, grid: SurfaceGrid, thermal: Thermal, *, shortest_step: float, duration: float):
        """Plans the memory of a body that is cold.

        Args:
            grid: of flux and temperature, at rest on the body.
            thermal: constants of the body.
            shortest_step: of all steps [s].
            duration: of all steps together [s].

        Raises:
            InputError: times that are not above 0, or a duration below the shortest step.
        """
        require_memory(grid.nx * grid.ny, _BYTES_OF_MEMORY, "the memory of a surface")
        self.grid = grid
        self._thermal = thermal
        self._engine = _core.SurfaceTemperature(
            grid._engine, thermal._engine, number(shortest_step, "shortest_step"), number(duration, "duration")
        )
        self._response: tuple[tuple[object, ...], HeatResponse] | None = None  # of the last motion

    def __repr__(self) -> str:
        return f"<SurfaceTemperature {cells(self.grid.shape)}, {self.time:g} s>"

    @property
    def time(self) -> float:
        """Of all steps so far [s]."""
        return self._engine.time

    def step(self, flux: ArrayLike, duration: float, velocity: float | tuple[float, float] = 0.0) -> Array:
        """Takes one step.

        Args:
            flux: (ny, nx) into the body [W/m^2], where it is at the end of the step.
            duration: of the step [s].
            velocity: of the flux over the body, along x, or along x and y [m/s].

        Returns:
            (ny, nx) rise of the temperature at the end [K].

        Raises:
            InputError: the step is shorter than `shortest_step`, or ends after `duration`.
        """
        heat = contiguous(flux, "flux")
        rise = self._engine.remaining(number(duration, "duration"))
        motion = (duration, velocity)
        if self._response is None or self._response[0] != motion:
            self._response = motion, HeatResponse(self.grid, self._thermal, duration=duration, velocity=velocity)
        rise += self._response[1].temperature(heat)
        self._engine.take_up(heat, _motion(duration, velocity))
        return rise


class ThermalField:
    """Flux, step by step -> displacement of the surface, temperature and stress in the body.

    The surface is free of traction. It remembers as `SurfaceTemperature` does. Along open axes there are no images, to
    some 1e-3 of the largest value; the displacement is that from far away, and of a flux that stands it grows with the
    logarithm of the time. If both axes are periodic, the mean strain along the surface is zero.
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
    ):
        """Plans the memory of a body that is cold.

        Args:
            grid: of flux and fields, at rest on the body.
            thermal: constants of the body.
            material: of it only the elastic constants count.
            shortest_step: of all steps [s].
            duration: of all steps together [s].
            depths: of the layers with temperature and stress [m]; 0 is the surface.

        Raises:
            InputError: times that are not above 0, a duration below the shortest step, a depth below 0, a rigid body.
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
        )

    def __repr__(self) -> str:
        return f"<ThermalField {cells(self.grid.shape)}, {len(self.depths)} layers, {self.time:g} s>"

    @property
    def time(self) -> float:
        """Of all steps so far [s]."""
        return self._engine.time

    def step(self, flux: ArrayLike, duration: float, velocity: float | tuple[float, float] = 0.0) -> None:
        """Takes one step.

        Args:
            flux: (ny, nx) into the body [W/m^2], where it is at the end of the step.
            duration: of the step [s].
            velocity: of the flux over the body, along x, or along x and y [m/s].

        Raises:
            InputError: the step is shorter than `shortest_step`, or ends after `duration`.
        """
        self._engine.take_up(contiguous(flux, "flux"), _motion(duration, velocity))

    def displacement(self, axis: str = "z", *, later: float = 0.0) -> Array:
        """Displacement of the surface.

        Args:
            axis: along which; z points into the body, so that heat makes it negative.
            later: 0 for the end of the last step; or so much later, if nothing enters meanwhile, at least
                `shortest_step` [s].

        Returns:
            (ny, nx) [m].
        """
        if axis not in ("x", "y", "z"):
            raise InputError(f"axis = {axis!r} of a displacement; allowed: 'x', 'y', 'z'")
        return self._engine.displacement(axis, number(later, "later"))

    def temperature(self, *, later: float = 0.0) -> Array:
        """Rise of the temperature at the depths, (len(depths), ny, nx) [K]; `later` as for `displacement`."""
        return self._engine.temperature(number(later, "later"))

    def stress(self, *, later: float = 0.0) -> Array:
        """Stress at the depths, (6, len(depths), ny, nx) [Pa], in the middles of cells; `later`: see `displacement`."""
        return self._engine.stress(number(later, "later"))


class SteadyField:
    """A flux that has always been there and moves along x -> displacement of the surface, temperature and stress.

    The surface is free of traction. There are no images of open axes, to some 1e-5 of the largest value. Of a flux that
    moves the displacement counts from far away.
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
        """Plans the operator.

        Args:
            grid: of flux and fields, open along x.
            thermal: constants of the body.
            material: of it only the elastic constants count.
            velocity: of the flux over the body, along x [m/s].
            reference: distance at which the surface counts as not displaced, of a flux at rest [m].
            depths: of the layers with temperature and stress [m]; 0 is the surface.

        Raises:
            InputError: a depth below 0, a rigid body; a steady state that there is not, because heat piles up along a
                periodic axis.
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
        """Displacement of the surface along z, into the body, so that heat makes it negative.

        Args:
            flux: (ny, nx) into the body [W/m^2].

        Returns:
            (ny, nx) [m].

        Raises:
            InputError: the flux is at rest, and there is no `reference`.
        """
        return self._engine.displacement(contiguous(flux, "flux"))

    def temperature(self, flux: ArrayLike) -> Array:
        """Rise of the temperature at the depths under such a flux, (len(depths), ny, nx) [K]."""
        return self._engine.temperature(contiguous(flux, "flux"))

    def stress(self, flux: ArrayLike) -> Array:
        """Stress at the depths under such a flux, (6, len(depths), ny, nx) [Pa], in the middles of cells."""
        return self._engine.stress(contiguous(flux, "flux"))


def _motion(duration: float | None, velocity: float | tuple[float, float]) -> _core.HeatMotion:
    pair = velocity if isinstance(velocity, tuple) else (velocity, 0.0)
    if len(pair) != 2:
        raise InputError(f"velocity = {velocity}; allowed: a number, or a pair for x and y")
    seconds = math.inf if duration is None else number(duration, "duration")
    return _core.HeatMotion(seconds, number(pair[0], "velocity"), number(pair[1], "velocity"))
