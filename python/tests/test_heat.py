# SPDX-License-Identifier: BSD-3-Clause
"""Conduction on the floor of the half space."""

from __future__ import annotations

import math

import numpy as np
import pytest

import brinell
from brinell.halfspace import SurfaceGrid
from brinell.heat import HeatResponse, SurfaceTemperature, Thermal

STEEL = Thermal(conductivity=50.0, density=7850.0, specific_heat=450.0)


def test_square_that_is_heated_for_ever() -> None:
    """4 asinh(1)/pi q a/K in the middle (Carslaw and Jaeger 1959, section 10.5)."""
    grid = SurfaceGrid(9, 9, 1e-3, 1e-3)
    rise = HeatResponse(grid, STEEL).temperature(np.full(grid.shape, 2e6))
    assert rise[4, 4] == pytest.approx(4.0 / math.pi * math.asinh(1.0) * 2e6 * 4.5e-3 / 50.0, rel=1e-7)


def test_steps_are_one_motion() -> None:
    grid = SurfaceGrid(48, 32, 1e-4, 1e-4)
    velocity, duration, steps = 0.05, 2e-3, 12
    flux = 1e7 * np.exp(-((grid.x - 1e-3) ** 2 + grid.y**2) / (6e-4) ** 2)
    memory = SurfaceTemperature(grid, STEEL, shortest_step=duration, duration=steps * duration)
    for n in range(steps):
        rise = memory.step(np.roll(flux, n + 1 - steps, axis=1), duration, velocity)
    whole = HeatResponse(grid, STEEL, duration=steps * duration, velocity=velocity).temperature(flux)
    assert memory.time == pytest.approx(steps * duration)
    assert np.abs(rise - whole).max() < 1e-4 * whole.max()


@pytest.mark.parametrize(
    ("call", "words"),
    [
        (lambda: Thermal(0.0, 1.0, 1.0), "conductivity = 0.0"),
        (lambda: HeatResponse(SurfaceGrid(4, 4, 1.0, 1.0), STEEL, duration=0.0), "duration of 0"),
        (lambda: HeatResponse(SurfaceGrid(4, 4, 1.0, 1.0, "periodic"), STEEL), "no steady state"),
        (lambda: HeatResponse(SurfaceGrid(4, 4, 1.0, 1.0), STEEL, velocity=(1.0, 2.0, 3.0)), "velocity"),  # type: ignore[arg-type]
        (lambda: HeatResponse(SurfaceGrid(4, 4, 1.0, 1.0), STEEL).temperature(np.zeros((4, 5))), r"shape \(4, 5\)"),
        (lambda: SurfaceTemperature(SurfaceGrid(4, 4, 1.0, 1.0), STEEL, shortest_step=2.0, duration=1.0), "duration"),
    ],
)
def test_what_cannot_be(call, words: str) -> None:  # type: ignore[no-untyped-def]
    with pytest.raises(brinell.InputError, match=words):
        call()
