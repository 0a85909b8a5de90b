# SPDX-License-Identifier: BSD-3-Clause
"""Conduction: a flux into the surface of a half space, and the rise of the temperature of that surface.

The grid is at rest on the body, and the flux moves over it; no heat leaves the surface elsewhere. Arrays are [y, x].
The method is on the page on heat of the theory. No scenario uses it yet.

    grid = SurfaceGrid(64, 64, 1e-5, 1e-5)
    steel = Thermal(conductivity=50, density=7850, specific_heat=450)
    steady = HeatResponse(grid, steel, velocity=1.0).temperature(flux)
"""

from __future__ import annotations

import math
from dataclasses import dataclass

from numpy.typing import ArrayLike

from brinell import _core
from brinell._arrays import Array, contiguous, number
from brinell._reprs import cells
from brinell.errors import InputError
from brinell.halfspace import SurfaceGrid, require_memory

__all__ = ["HeatResponse", "SurfaceTemperature", "Thermal"]

_BYTES_OF_RESPONSE, _BYTES_OF_MEMORY = 130, 1500
"""Per cell: the planned operator; the state of all waves, without that of the images."""


@dataclass(frozen=True)
class Thermal:
    """Constants of a body that conducts heat.

    Attributes:
        conductivity: K [W/(m K)].
        density: rho [kg/m^3].
        specific_heat: c [J/(kg K)].
    """

    conductivity: float
    density: float
    specific_heat: float

    def __post_init__(self) -> None:
        for name in ("conductivity", "density", "specific_heat"):
            if not number(getattr(self, name), name) > 0.0:
                raise InputError(f"{name} = {getattr(self, name)}; allowed: a number above 0")

    @property
    def diffusivity(self) -> float:
        """K/(rho c) [m^2/s]."""
        return self.conductivity / (self.density * self.specific_heat)

    @property
    def _engine(self) -> _core.Thermal:
        return _core.Thermal(self.conductivity, self.density, self.specific_heat, 0.0)


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


def _motion(duration: float | None, velocity: float | tuple[float, float]) -> _core.HeatMotion:
    pair = velocity if isinstance(velocity, tuple) else (velocity, 0.0)
    if len(pair) != 2:
        raise InputError(f"velocity = {velocity}; allowed: a number, or a pair for x and y")
    seconds = math.inf if duration is None else number(duration, "duration")
    return _core.HeatMotion(seconds, number(pair[0], "velocity"), number(pair[1], "velocity"))
