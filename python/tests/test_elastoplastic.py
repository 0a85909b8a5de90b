# SPDX-License-Identifier: BSD-3-Clause
"""Increments of two bodies: the same as those of a scenario, and what stops them."""

from __future__ import annotations

import os
import signal
import threading
import time
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

import brinell
from brinell.contact import ElasticContact
from brinell.elastoplastic import CoupledContact, Place
from brinell.halfspace import HalfSpace, SurfaceGrid, VolumeGrid

STEEL = brinell.Material("210 GPa", 0.3, brinell.Swift("1.2 GPa", 4e-3, 0.1))
RADIUS = 1e-3
ALPHA_C = 5.75e-8  # approach at first yield [m]
TIGHT = {"yield_tolerance": 1e-9, "displacement_tolerance": 1e-9, "contact_tolerance": 1e-10}
CELL = 4e-6
CONTACT = SurfaceGrid(15, 15, CELL, CELL)
BODY = VolumeGrid(CONTACT, nz=10, dz=CELL)
COMPONENTS = ("xx", "yy", "zz", "yz", "xz", "xy")


def ball(grid: SurfaceGrid = CONTACT) -> NDArray[np.float64]:
    return (grid.x**2 + grid.y**2) / (2 * RADIUS)


def pressed(material: brinell.Material = STEEL, upper: brinell.Material = brinell.RIGID, **more: Any) -> CoupledContact:
    return CoupledContact(CONTACT, BODY, BODY, material, upper, scale=ALPHA_C, **(TIGHT | more))


def close(found: NDArray[np.float64], expected: NDArray[np.float64], share: float) -> None:
    np.testing.assert_allclose(found, expected, rtol=0, atol=share * np.abs(expected).max())


def test_increments_are_those_of_an_indentation() -> None:
    case = brinell.Indentation(
        brinell.Body(brinell.Flat(), STEEL),
        brinell.Body(brinell.Sphere(RADIUS), brinell.RIGID),
        approach=["0.4 um"],
        steps=2,
        grid={"spacing": [CELL] * 3},
        solver=TIGHT,
    )
    run = case.run()
    assert run.summary["run"]["split_increments"] == 0
    expected = run.snapshot("final", tensors=True)
    lower, contact = expected.lower, expected.contact
    surface = SurfaceGrid(len(contact.x), len(contact.y), CELL, CELL)
    body = VolumeGrid(SurfaceGrid(len(lower.x), len(lower.y), CELL, CELL), len(lower.z), CELL)
    pair = CoupledContact(surface, body, body, STEEL, brinell.RIGID, scale=ALPHA_C, **TIGHT)
    place = Place(column=(body.surface.nx - surface.nx) // 2)
    for approach in (0.2e-6, 0.4e-6):
        report = pair.advance(ball(surface), approach=approach, lower=place, upper=place)
    # Both are solved to 1e-9 of the yield stress.
    share = 1e-6
    assert report.load == pytest.approx(run.history["F_n"][-1], rel=share)
    close(pair.pressure, contact.pressure, share)
    np.testing.assert_allclose(pair.gap, contact.gap, atol=share * ALPHA_C)
    close(pair.lower.residual_displacement, lower.residual_displacement, share)
    close(pair.lower.equivalent_plastic_strain, lower.equivalent_plastic_strain, share)
    close(pair.lower.plastic_strain, np.array([lower.plastic_strain[c] for c in COMPONENTS]), share)
    close(pair.lower.stress, np.array([lower.stress[c] for c in COMPONENTS]), share)
    assert pair.lower.dissipation == pytest.approx(run.history["dissipation_lower"][-1], rel=share)
    assert pair.lower.locked_in_energy == pytest.approx(run.summary["energy"]["residual_J"], rel=share)
    assert pair.elastic_energy == pytest.approx(run.history["energy_elastic"][-1], rel=share)


def test_without_plasticity_it_is_the_elastic_contact() -> None:
    elastic = brinell.Material("210 GPa", 0.3)
    pair = pressed(elastic)
    report = pair.advance(ball(), load=1.0)
    expected = ElasticContact(CONTACT, elastic).solve(ball(), load=1.0, tolerance=1e-10 * ALPHA_C)
    assert report.evaluations == 1
    assert report.approach == pytest.approx(expected.approach, rel=1e-9)
    close(pair.pressure, expected.pressure, 1e-9)
    assert pair.lower.dissipation == 0.0
    close(pair.lower.stress, HalfSpace(BODY, elastic).pressure_to_stress(pair.pressure), 1e-12)


def test_the_state_is_consistent() -> None:
    """After loading and unloading: stress and displacement are those of the plastic strain, which is traceless."""
    pair = pressed()
    for load in (1.0, 2.0, 0.0):
        report = pair.advance(ball(), load=load)
    assert report.load == 0.0
    assert not pair.pressure.any()
    strain = pair.lower.plastic_strain
    half_space = HalfSpace(BODY, STEEL)
    close(pair.lower.residual_displacement, half_space.eigenstrain_to_displacement(strain), 1e-12)
    close(pair.lower.stress, half_space.eigenstrain_to_stress(strain), 1e-12)
    assert pair.lower.residual_displacement.max() > 0.1 * ALPHA_C
    energy = -0.5 * np.einsum("c,ckji,ckji", [1, 1, 1, 2, 2, 2], strain, pair.lower.stress) * BODY.cell_volume
    assert pair.lower.locked_in_energy == pytest.approx(energy, rel=1e-9)
    assert pair.upper.residual_displacement.max() == 0.0


def test_load_and_approach_give_the_same_increment() -> None:
    by_load, by_approach = pressed(), pressed()
    report = by_load.advance(ball(), load=2.0)
    assert by_approach.advance(ball(), approach=report.approach).load == pytest.approx(2.0, rel=1e-6)
    close(by_approach.lower.plastic_strain, by_load.lower.plastic_strain, 1e-5)


def test_back_stresses_have_their_field() -> None:
    material = brinell.Material("210 GPa", 0.3, brinell.Perfect("600 MPa"), back_stresses=[("20 GPa", 0.0)])
    pair = pressed(material)
    pair.advance(ball(), load=2.0)
    assert pair.lower.backstress.shape == (1, 6, *BODY.shape)
    close(pair.lower.backstress[0], 2 / 3 * 20e9 * pair.lower.plastic_strain, 1e-9)  # Prager


def test_a_moved_grid_moves_the_fields() -> None:
    """The contact on a body that is longer, at two places: the same but for the place."""
    long = VolumeGrid(SurfaceGrid(25, 15, CELL, CELL), nz=10, dz=CELL)
    fields = []
    for column in (0, 10):
        pair = CoupledContact(CONTACT, long, BODY, STEEL, brinell.RIGID, scale=ALPHA_C, **TIGHT)
        pair.advance(ball(), load=2.0, lower=Place(column))
        fields.append(pair.lower.plastic_strain)
    # The image correction is a polynomial in the distance, the rest is rounding and the tolerance.
    close(fields[1][..., 10:], fields[0][..., :15], 1e-6)


def test_twins_are_two_bodies_that_are_alike() -> None:
    both, twin = pressed(upper=STEEL), pressed(upper=STEEL, twin="alike")
    for pair in (both, twin):
        pair.advance(ball(), load=2.0)
    close(twin.lower.plastic_strain, both.lower.plastic_strain, 1e-6)
    np.testing.assert_array_equal(twin.upper.residual_displacement, twin.lower.residual_displacement)
    close(both.upper.residual_displacement, both.lower.residual_displacement, 1e-6)


def test_a_texture_is_part_of_the_distance() -> None:
    bump = -2e-7 * np.exp(-((CONTACT.x / 8e-6) ** 2 + (CONTACT.y / 8e-6) ** 2))
    textured, shaped = pressed(lower_texture=bump), pressed()
    textured.advance(ball(), load=1.0)
    shaped.advance(ball() + bump, load=1.0)
    close(textured.pressure, shaped.pressure, 1e-6)


def test_a_function_is_as_good_as_the_law() -> None:
    function = brinell.Material("210 GPa", 0.3, lambda e: 1.2e9 * (4e-3 + e) ** 0.1)
    pairs = pressed(), pressed(function)
    for pair in pairs:
        pair.advance(ball(), load=2.0)
    # The table's yield stress is within 1e-4.
    close(pairs[1].lower.stress, pairs[0].lower.stress, 1e-3)
    assert pairs[1].lower.dissipation == pytest.approx(pairs[0].lower.dissipation, rel=1e-3)


def test_unconverged_is_an_error_and_leaves_the_bodies() -> None:
    pair = pressed()
    pair.advance(ball(), load=1.0)
    before = pair.lower.plastic_strain, pair.lower.stress, pair.pressure, pair.gap
    load = pair.load
    with pytest.raises(brinell.ConvergenceError, match="no convergence after 4 evaluations; yield violation .* S_y"):
        pair.advance(ball(), load=4.0, max_evaluations=2)
    after = pair.lower.plastic_strain, pair.lower.stress, pair.pressure, pair.gap
    for field, field_before in zip(after, before, strict=True):
        np.testing.assert_array_equal(field, field_before)
    assert pair.load == load
    report = pair.advance(ball(), load=2.0)  # it goes on
    assert report.load == pytest.approx(2.0)


def test_arrays_are_not_touched_by_the_next_increment() -> None:
    pair = pressed()
    pair.advance(ball(), load=1.0)
    pressure, strain = pair.pressure, pair.lower.equivalent_plastic_strain
    copies = pressure.copy(), strain.copy()
    pair.advance(ball(), load=2.0)
    np.testing.assert_array_equal(pressure, copies[0])
    np.testing.assert_array_equal(strain, copies[1])


def heavy() -> tuple[CoupledContact, NDArray[np.float64]]:
    """Its increments take tenths of a second."""
    grid = SurfaceGrid(40, 40, 1.5e-6, 1.5e-6)
    body = VolumeGrid(grid, nz=20, dz=1.5e-6)
    return CoupledContact(grid, body, body, STEEL, brinell.RIGID, scale=ALPHA_C, yield_tolerance=1e-6), ball(grid)


def test_ctrl_c_stops_an_increment() -> None:
    grid = SurfaceGrid(80, 80, 0.75e-6, 0.75e-6)
    body = VolumeGrid(grid, nz=40, dz=0.75e-6)
    pair = CoupledContact(grid, body, body, STEEL, brinell.RIGID, scale=ALPHA_C, yield_tolerance=1e-9)
    timer = threading.Timer(0.5, os.kill, (os.getpid(), signal.SIGINT))
    timer.start()
    with pytest.raises(KeyboardInterrupt):
        pair.advance(ball(grid), load=20.0, max_evaluations=1000)
    timer.join()
    assert pair.load == 0.0  # within this increment, of which nothing is left
    assert not pair.lower.plastic_strain.any()


def test_another_thread_may_not_use_it_meanwhile() -> None:
    pair, distance = heavy()
    started = threading.Event()

    def advance() -> None:
        started.set()
        pair.advance(distance, load=2.0)

    thread = threading.Thread(target=advance)
    thread.start()
    started.wait()
    messages = set()
    while thread.is_alive():
        try:
            _ = pair.pressure
        except brinell.InputError as error:
            messages.add(str(error))
        time.sleep(1e-3)
    # So this thread went on while the other one computed.
    assert messages == {"this contact is in use by another thread; give each thread a contact of its own"}
    assert pair.load == pytest.approx(2.0)


@pytest.mark.parametrize(
    ("call", "message"),
    [
        (lambda: pressed(brinell.RIGID), "both bodies are rigid"),
        (lambda: pressed(yield_tolerance=0.0), "yield_tolerance = 0.0; allowed: above 0"),
        (lambda: pressed(twin="alike"), "the bodies differ in grid or material"),
        (lambda: pressed(twin="same"), 'twin = "same"; allowed: "none", "mirror_image" or "alike"'),
        (lambda: pressed(lower_texture=np.zeros(3)), r"lower_texture has the shape \(3\); it must be \(15, 15\)"),
        (lambda: pressed().advance(ball(), load=-1.0), "load = -1; allowed: finite, not below 0"),
        (lambda: pressed().advance(ball()), "either load or approach"),
        (lambda: pressed().advance(ball()[1:], load=1.0), r"distance has the shape \(14, 15\); it must be \(15, 15\)"),
        (lambda: pressed().advance(ball(), load=1.0, integration="euler"), 'integration = "euler"'),
        (lambda: pressed().advance(ball(), load=1.0, anderson_depth=-1), "anderson_depth = -1; allowed: .* from 0 on"),
        (lambda: pressed().advance(ball(), load=1.0, lower=Place(12)), "reached the end of a material grid"),
        (lambda: pressed().upper.stress, "the body is rigid"),
        (lambda: Place(0, 1.0), r"fraction = 1.0 of a place; allowed: in \[0, 1\)"),
        (
            lambda: CoupledContact(
                CONTACT, VolumeGrid(SurfaceGrid(15, 15, CELL, 2 * CELL), 2, CELL), BODY, STEEL, STEEL, scale=1e-7
            ),
            "lower has 15 rows of cells of 4e-06 x 8e-06 m; it must have those of the contact grid",
        ),
    ],
)
def test_what_does_not_fit_is_an_input_error(call: Any, message: str) -> None:
    with pytest.raises(brinell.InputError, match=message):
        call()


def test_reprs_name_the_grid() -> None:
    pair = pressed()
    assert repr(pair) == "<CoupledContact 15 x 15 cells>"
    assert repr(pair.lower) == "<BodyState 15 x 15 x 10 cells>"


def test_a_factor_on_the_yield_stress_is_another_material() -> None:
    soft, weak = (
        pressed(brinell.Material("210 GPa", 0.3, brinell.Perfect("1 GPa"))),
        pressed(brinell.Material("210 GPa", 0.3, brinell.Perfect("0.8 GPa"))),
    )
    soft.set_softening(np.full((10, 15, 15), 0.8))
    for contact in (soft, weak):
        contact.advance(ball(), approach=0.3e-6)
    close(soft.lower.plastic_strain, weak.lower.plastic_strain, 1e-6)
    load = soft.load
    soft.set_softening(np.full((10, 15, 15), 0.5))
    soft.advance(ball(), approach=0.3e-6)  # it flows where it is
    assert soft.load < 0.95 * load
    for bad, message in ((np.ones((2, 2)), "shape"), (np.zeros((10, 15, 15)), "above 0")):
        with pytest.raises(brinell.InputError, match=message):
            soft.set_softening(bad)
    twins = CoupledContact(CONTACT, BODY, BODY, STEEL, STEEL, scale=ALPHA_C, twin="alike")
    with pytest.raises(brinell.InputError, match="a twin has the softening of the lower body"):
        twins.set_softening(np.ones((10, 15, 15)), np.ones((10, 15, 15)))
