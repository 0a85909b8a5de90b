# SPDX-License-Identifier: BSD-3-Clause
"""Conduction on the floor of the half space."""

from __future__ import annotations

import math

import numpy as np
import pytest

import brinell
from brinell.halfspace import Layer, SurfaceGrid
from brinell.heat import HeatResponse, SteadyField, SurfaceTemperature, ThermalField
from brinell.materials import Material, Thermal

STEEL = Thermal(conductivity=50.0, density=7850.0, specific_heat=450.0, expansion=12e-6)
ELASTIC = Material("210 GPa", 0.3)


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


def test_plane_that_is_heated() -> None:
    """Held along the surface: -E alpha T/(1 - nu), and alpha (1 + nu)/(1 - nu) of the heat per area and rho c."""
    grid = SurfaceGrid(8, 6, 1e-4, 1e-4, "periodic")
    field = ThermalField(grid, STEEL, ELASTIC, shortest_step=1e-3, duration=1e-2, depths=[0.0, 2e-4])
    for _ in range(10):
        field.step(np.full(grid.shape, 1e7), 1e-3, velocity=0.3)
    assert field.time == pytest.approx(1e-2)
    assert field.displacement() == pytest.approx(-12e-6 * 1.3 / 0.7 * 1e5 / (7850 * 450), rel=1e-9)
    assert field.displacement("x") == pytest.approx(0.0, abs=1e-18)
    rise, stress = field.temperature(), field.stress()
    assert rise.shape == (2, 6, 8)
    assert stress.shape == (6, 2, 6, 8)
    surface = 2.0 * 1e7 / 50.0 * math.sqrt(STEEL.diffusivity * 1e-2 / math.pi)
    assert rise[0] == pytest.approx(surface, rel=1e-4)
    assert stress[0] == pytest.approx(-210e9 * 12e-6 / 0.7 * rise, rel=1e-9)
    assert np.abs(stress[2:]).max() < 1e-9 * np.abs(stress[0]).max()


def test_layers_conduct() -> None:
    """A layer keeps its own temperature at first; layers of the body's constants are the body."""
    grid = SurfaceGrid(24, 20, 1e-5, 1e-5)
    flux = 1e7 * np.exp(-(grid.x**2 + grid.y**2) / (4e-5) ** 2)
    carbon = Thermal(conductivity=2.0, density=2200.0, specific_heat=900.0, expansion=2e-6)
    film = Layer(2e-5, Material("150 GPa", 0.2, thermal=carbon))
    brief = (0.1 * 2e-5) ** 2 / carbon.diffusivity
    coated = HeatResponse(grid, STEEL, duration=brief, layers=[film]).temperature(flux)
    alone = HeatResponse(grid, carbon, duration=brief).temperature(flux)
    assert np.abs(coated - alone).max() < 1e-9 * alone.max()
    long = 1e4 * brief
    bodies: list[tuple[Thermal, list[Layer]]] = [(STEEL, []), (STEEL, [film]), (carbon, [])]
    rise = [HeatResponse(grid, body, duration=long, layers=on).temperature(flux).max() for body, on in bodies]
    assert rise[0] < rise[1] < rise[2]

    steel = Layer(2e-5, Material("210 GPa", 0.3, thermal=STEEL))
    fields = [
        ThermalField(grid, STEEL, ELASTIC, shortest_step=1e-5, duration=1e-4, depths=[5e-6, 3e-5], layers=layers)
        for layers in ([], [steel])
    ]
    for field in fields:
        field.step(flux, 1e-5, velocity=1.0)
    bare, layered = fields
    assert np.abs(layered.displacement() - bare.displacement()).max() < 1e-4 * np.abs(bare.displacement()).max()
    assert np.abs(layered.temperature() - bare.temperature()).max() < 1e-4 * bare.temperature().max()

    with pytest.raises(brinell.InputError, match="layer 0 has no thermal constants"):
        HeatResponse(grid, STEEL, duration=1e-5, layers=[Layer(2e-5, ELASTIC)])
    with pytest.raises(brinell.InputError, match="heated for ever"):
        HeatResponse(grid, STEEL, layers=[film])
    with pytest.raises(brinell.InputError, match="1e-06 m thick on cells of 1e-05 m"):
        HeatResponse(grid, STEEL, duration=1e-5, layers=[Layer(1e-6, film.material)])


def test_a_source_that_has_always_moved() -> None:
    grid = SurfaceGrid(40, 24, 1e-4, 1e-4)
    flux = 1e7 * np.exp(-(grid.x**2 + grid.y**2) / (4e-4) ** 2)
    velocity = 4.0 * STEEL.diffusivity / 4e-4
    always = SteadyField(grid, STEEL, ELASTIC, velocity=velocity, depths=[0.0, 2e-4])
    rise, stress = always.temperature(flux), always.stress(flux)
    assert rise.shape == (2, 24, 40)
    assert stress.shape == (6, 2, 24, 40)
    assert rise[0] == pytest.approx(
        HeatResponse(grid, STEEL, velocity=velocity).temperature(flux), abs=0.01 * rise.max()
    )
    assert np.abs(stress[2:5, 0]).max() < 1e-9 * np.abs(stress[0]).max()
    assert always.displacement(flux).max() < 0.0


def test_a_source_at_rest_needs_a_reference() -> None:
    grid = SurfaceGrid(24, 24, 1e-4, 1e-4)
    flux = 1e7 * np.exp(-(grid.x**2 + grid.y**2) / (3e-4) ** 2)
    with pytest.raises(brinell.InputError, match="allowed: a reference"):
        SteadyField(grid, STEEL, ELASTIC).displacement(flux)
    near, far = (SteadyField(grid, STEEL, ELASTIC, reference=r).displacement(flux) for r in (1e-2, 2e-2))
    # Barber (1971): (1 + nu) alpha Q ln 2/(2 pi K)
    shift = 1.3 * 12e-6 * flux.sum() * 1e-8 * math.log(2.0) / (2.0 * math.pi * 50.0)
    assert near - far == pytest.approx(shift, rel=1e-6)


def test_later_the_same_heat_is_spread() -> None:
    grid = SurfaceGrid(32, 32, 1e-4, 1e-4)
    field = ThermalField(grid, STEEL, ELASTIC, shortest_step=1e-3, duration=0.1, depths=[0.0, 3e-4])
    field.step(1e7 * np.exp(-(grid.x**2 + grid.y**2) / (5e-4) ** 2), 1e-3)
    now, later = field.stress(), field.stress(later=5e-2)
    assert np.abs(later).max() < 0.2 * np.abs(now).max()
    assert field.displacement().min() < field.displacement(later=5e-2).min() < 0.0
    assert np.allclose(field.displacement("x"), -field.displacement("x")[:, ::-1], atol=1e-9 * np.abs(now).max() / 1e12)


def _field(depths: tuple[float, ...] = ()) -> ThermalField:
    grid = SurfaceGrid(4, 4, 1.0, 1.0)
    return ThermalField(grid, STEEL, ELASTIC, shortest_step=1.0, duration=2.0, depths=depths)


@pytest.mark.parametrize(
    ("call", "words"),
    [
        (lambda: Thermal(0.0, 1.0, 1.0), "conductivity = 0.0"),
        (lambda: HeatResponse(SurfaceGrid(4, 4, 1.0, 1.0), STEEL, duration=0.0), "duration of 0"),
        (lambda: HeatResponse(SurfaceGrid(4, 4, 1.0, 1.0, "periodic"), STEEL), "no steady state"),
        (lambda: HeatResponse(SurfaceGrid(4, 4, 1.0, 1.0), STEEL, velocity=(1.0, 2.0, 3.0)), "velocity"),  # type: ignore[arg-type]
        (lambda: HeatResponse(SurfaceGrid(4, 4, 1.0, 1.0), STEEL).temperature(np.zeros((4, 5))), r"shape \(4, 5\)"),
        (lambda: Thermal(1.0, 1.0, 1.0, math.nan), "expansion"),
        (lambda: _field(depths=(-1.0,)), "depth of -1"),
        (lambda: _field().displacement("w"), "axis = 'w'"),
        (lambda: _field(depths=(0.0,)).stress(later=0.5), "a step of 0.5 s"),
        (lambda: SurfaceTemperature(SurfaceGrid(4, 4, 1.0, 1.0), STEEL, shortest_step=2.0, duration=1.0), "duration"),
    ],
)
def test_what_cannot_be(call, words: str) -> None:  # type: ignore[no-untyped-def]
    with pytest.raises(brinell.InputError, match=words):
        call()
