# SPDX-License-Identifier: BSD-3-Clause
"""Bodies with layers: contact and stress under pressure, and what is refused."""

import math

import numpy as np
import pytest

from brinell.contact import ElasticContact
from brinell.errors import InputError
from brinell.halfspace import HalfSpace, Layer, SurfaceCompliance, SurfaceGrid, VolumeGrid
from brinell.materials import RIGID, Material

BASE, COAT = Material(1.0e9, 0.3), Material("3 GPa", 0.25)
GRID = SurfaceGrid(33, 33, 1e-6, 1e-6)
DISTANCE = (GRID.x**2 + GRID.y**2) / 2e-4  # of a sphere of 0.1 mm


def peak(load=1e-4, **layers):
    """Largest pressure under a rigid sphere."""
    return ElasticContact(GRID, BASE, RIGID, **layers).solve(DISTANCE, load=load).pressure.max()


def test_a_stiffer_coating_raises_the_pressure_from_one_half_space_to_the_other():
    plain = peak()
    coated = [peak(lower_layers=[Layer(h, COAT)]) for h in (1e-6, 1e-5, 2e-3)]
    assert plain < coated[0] < coated[1] < coated[2]
    thick = ElasticContact(GRID, COAT, RIGID).solve(DISTANCE, load=1e-4).pressure.max()
    assert coated[2] == pytest.approx(thick, rel=0.02)  # radius over thickness is 0.003


def test_a_layer_of_the_same_material_changes_nothing():
    assert peak(lower_layers=[Layer(5e-6, BASE)]) == pytest.approx(peak(), rel=1e-6)


def test_both_bodies_may_have_layers_and_may_be_exchanged():
    layers = [Layer(2e-6, COAT)]
    one = SurfaceCompliance(GRID, BASE, RIGID, lower_layers=layers)
    other = SurfaceCompliance(GRID, RIGID, BASE, upper_layers=layers)
    both = SurfaceCompliance(GRID, BASE, BASE, lower_layers=layers, upper_layers=layers)
    pressure = np.exp(-DISTANCE / 1e-7)
    u = one.pressure_to_displacement(pressure)
    assert other.pressure_to_displacement(pressure) == pytest.approx(u, rel=1e-12)
    assert both.pressure_to_displacement(pressure) == pytest.approx(2.0 * u, rel=1e-10)


def test_traction_is_continuous_and_the_stress_along_an_interface_jumps():
    grid = VolumeGrid(GRID, 16, 0.5e-6)
    pressure = np.sqrt(np.maximum(0.0, 1.0 - (GRID.x**2 + GRID.y**2) / 8e-6**2)) * 1e6
    stress = HalfSpace(grid, BASE, layers=[Layer(4e-6, COAT)]).pressure_to_stress(pressure)
    middle = stress[:, :, 16, 16]
    above, below = middle[:, 7], middle[:, 8]
    step = np.abs(np.diff(middle[2])).max()
    assert abs(above[2] - below[2]) <= step
    assert middle[2, 0] == pytest.approx(-1e6, rel=0.05)  # just beneath the surface
    # A stiff coating is bent: its lower side is in tension, the soft body beneath is not.
    assert above[0] > below[0] + 1e5


def test_pressure_and_shear_on_layers_are_reciprocal():
    pair = SurfaceCompliance(GRID, BASE, RIGID, lower_layers=[Layer(2e-6, COAT)])
    random = np.random.default_rng(1)
    pressure, shear = random.random(GRID.shape), random.random(GRID.shape)
    by_shear = pair.displacement(shear_x=shear)[2]
    by_pressure = pair.displacement(pressure=pressure)
    assert np.vdot(pressure, by_shear) == pytest.approx(np.vdot(shear, by_pressure[0]), rel=1e-9)
    # Alone, the pressure takes a shorter way, on another lattice of waves, whose images are below 1e-4.
    alone = pair.pressure_to_displacement(pressure)
    np.testing.assert_allclose(by_pressure[2], alone, rtol=0, atol=1e-4 * alone.max())


def test_plastic_strain_in_layers_and_the_load_on_them_are_reciprocal():
    grid = VolumeGrid(SurfaceGrid(8, 6, 1e-6, 1e-6), 4, 1e-6)
    body = HalfSpace(grid, BASE, layers=[Layer(2e-6, COAT)])
    random = np.random.default_rng(2)
    strain = random.random((6, *grid.shape)) - 0.5
    strain[2] = -strain[0] - strain[1]
    pressure = random.random(grid.surface.shape)
    stress = body.pressure_to_stress(pressure)
    weights = np.array([1, 1, 1, 2, 2, 2]).reshape(-1, 1, 1, 1)
    work = np.vdot(stress, weights * strain) * grid.dz
    assert np.vdot(pressure, body.eigenstrain_to_displacement(strain)) == pytest.approx(work, rel=1e-9)
    # The coating is as much stiffer as its modulus is larger.
    held, alone = body.eigenstrain_to_stress(strain), HalfSpace(grid, BASE).eigenstrain_to_stress(strain)
    assert np.abs(held[:, 0]).max() > 1.5 * np.abs(alone[:, 0]).max()
    assert np.abs(held[:, 3]).max() < 1.5 * np.abs(alone[:, 3]).max()


def test_what_layers_cannot_do_is_refused():
    grid = VolumeGrid(SurfaceGrid(4, 4, 1e-6, 1e-6), 3, 0.9e-6)
    body = HalfSpace(grid, BASE, layers=[Layer(2e-6, COAT)])
    strain = np.zeros((6, *grid.shape))
    strain[3, 0, 0, 0] = 1e-3
    for call in (body.eigenstrain_to_stress, body.eigenstrain_to_displacement):
        with pytest.raises(InputError, match="for example 1e-06 m thick"):
            call(strain)
    for thickness in (0.0, -1e-6, math.inf):
        with pytest.raises(InputError, match="thickness"):
            Layer(thickness, COAT)
    with pytest.raises(InputError, match="rigid"):
        Layer(1e-6, RIGID)
    with pytest.raises(InputError, match="thickness of 2.5e-07 m at least"):
        SurfaceCompliance(GRID, BASE, RIGID, lower_layers=[Layer(0.2e-6, COAT)])
