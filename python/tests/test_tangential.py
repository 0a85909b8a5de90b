# SPDX-License-Identifier: BSD-3-Clause
"""Stick and slip against Cattaneo and Mindlin; what is refused."""

from __future__ import annotations

import numpy as np
import pytest

import brinell
from brinell.contact import ElasticContact, FrictionalContact, TangentialContact
from brinell.halfspace import SurfaceGrid
from brinell.reference import point_contact

# Two equal balls of 50 mm, without Poisson's effect, so that the closed forms are exact.
FRICTION, SHEAR_MODULUS = 0.4, 200e6
BODY = brinell.Material(2 * SHEAR_MODULUS, 0.0)
RADIUS = 0.025
HERTZ = point_contact(RADIUS, SHEAR_MODULUS, load=10.0)
LIMIT = FRICTION * HERTZ.load
SLIDING = 3 * LIMIT * 2 / (8 * SHEAR_MODULUS * HERTZ.contact_radius)


def balls(cells: int) -> tuple[SurfaceGrid, np.ndarray]:
    n = 2 * cells + 5
    grid = SurfaceGrid(n, n, HERTZ.contact_radius / cells, HERTZ.contact_radius / cells)
    return grid, (grid.x**2 + grid.y**2) / (2 * RADIUS)


def test_stick_radius_and_shift_are_mindlins() -> None:
    grid, distance = balls(24)
    pressure = ElasticContact(grid, BODY, BODY).solve(distance, load=HERTZ.load).pressure
    contact = TangentialContact(grid, BODY, BODY)
    pushed = contact.step(FRICTION * pressure, force_x=7 / 8 * LIMIT)
    assert pushed.force == pytest.approx((7 / 8 * LIMIT, 0.0), abs=1e-10 * LIMIT)
    # By a cell at the rim of the stick area, and by the power 1.5 of the cell in what is integrated.
    assert np.sqrt(pushed.stick_area / np.pi) == pytest.approx(0.5 * HERTZ.contact_radius, rel=1 / 12)
    assert pushed.shift[0] == pytest.approx(0.75 * SLIDING, rel=24**-1.5)
    assert pushed.shift[1] == 0.0
    assert np.all(np.hypot(pushed.shear_x, pushed.shear_y) <= FRICTION * pressure * (1 + 1e-12))
    assert np.abs(pushed.slip_x[pushed.sticks]).max() <= pushed.residual <= 1e-6 * SLIDING
    assert pushed.dissipation_friction == pytest.approx(pushed.dissipation.sum() * grid.cell_area)

    back = contact.step(FRICTION * pressure, force_x=0.0, before=pushed)
    left = 2 * (1 - 7 / 16) ** (2 / 3) - (1 / 8) ** (2 / 3) - 1
    assert pushed.shift[0] + back.shift[0] == pytest.approx(left * SLIDING, rel=24**-1.5)
    again = contact.step(FRICTION * pressure, shift_x=-back.shift[0], before=back)
    assert again.force[0] == pytest.approx(7 / 8 * LIMIT, rel=1e-5)


def test_spin_and_changes_of_the_displacement() -> None:
    grid, _ = balls(8)
    bound = np.full(grid.shape, 1e5)
    contact = TangentialContact(grid, BODY, BODY)
    turned = contact.step(bound, spin=1e-6)
    assert turned.force == pytest.approx((0.0, 0.0), abs=1e-12)
    assert turned.shear_y[10, -1] > 0.0 > turned.shear_y[10, 0]
    # Surfaces that have been displaced by as much as the bodies were have nothing left to carry.
    none = contact.step(bound, shift_x=1e-7, change_x=np.full(grid.shape, 1e-7))
    assert np.abs(none.shear_x).max() < 1e-6 * np.abs(contact.step(bound, shift_x=1e-7).shear_x).max()


def test_contact_with_friction() -> None:
    grid, distance = balls(12)
    contact = FrictionalContact(grid, BODY, BODY, friction=FRICTION)
    pressed = contact.step(distance, load=HERTZ.load)
    assert pressed.alternations == 1
    assert np.abs(pressed.tangential.shear_x).max() == 0.0
    pushed = contact.step(distance, load=HERTZ.load, force_y=0.5 * LIMIT, before=pressed)
    assert pushed.shift[1] == pytest.approx(SLIDING * (1 - 0.5 ** (2 / 3)), rel=12**-1.5)
    assert pushed.dissipation_friction > 0.0
    # Equal bodies: the pressure stays, but for the rounding of its sum, to which a load is held anew.
    np.testing.assert_allclose(pushed.contact.pressure, pressed.contact.pressure, rtol=1e-14)
    # A rigid ball on a soft flat: friction holds what the pressure draws to the middle, and so stiffens the contact.
    rigid = FrictionalContact(grid, BODY, friction=FRICTION).step(distance, approach=1e-4)
    free = ElasticContact(grid, BODY).solve(distance, approach=1e-4)
    assert rigid.alternations > 1
    assert 1.01 < rigid.contact.load / free.load < 1.0986  # that of a flat punch that sticks: ln 3


def test_rolling_cylinders_tend_to_carters_force() -> None:
    cells, stick, reference = 16, 0.6, 2.0  # half-width of the contact and of its stick zone: 1 and 0.6
    grid = SurfaceGrid(2 * cells + 7, 1, 1 / cells, 1.0, boundary=("open", "periodic"))
    radius, body = 100.0, brinell.Material(2 * (1 - 0.3**2), 0.3)  # E' = 1
    load = np.pi / 4 / radius
    line = np.broadcast_to(grid.x**2 / (2 * radius), grid.shape)
    contact = FrictionalContact(grid, body, body, friction=FRICTION, reference=reference)
    creepage = FRICTION * (1 - stick) / radius
    state = None
    for _ in range(20 * cells):
        state = contact.step(line, load=load, shift_x=creepage * grid.dx, carried=(-1, 0), before=state)
    assert state is not None
    # Second order in the cell: 0.06 % with 8 cells.
    assert state.tangential.force[0] == pytest.approx(FRICTION * load * (1 - stick**2), rel=1e-3)
    np.testing.assert_array_equal(state.tangential.sticks[0, 2:5], False)  # slip at the trailing edge


def test_what_is_refused() -> None:
    grid, distance = balls(6)
    contact = TangentialContact(grid, BODY, BODY)
    bound = np.ones(grid.shape)
    with pytest.raises(brinell.InputError, match="the whole contact slides"):
        contact.step(bound, force_x=1.0)
    with pytest.raises(brinell.InputError, match="shift_x = 1 and force_x = 2; allowed: one of them"):
        contact.step(bound, shift_x=1.0, force_x=2.0)
    with pytest.raises(brinell.InputError, match="bound"):
        contact.step(-bound)
    with pytest.raises(brinell.InputError, match=r"change_y has the shape"):
        contact.step(bound, change_y=np.ones(3))
    with pytest.raises(brinell.ConvergenceError, match="the slip's residual"):
        contact.step(bound, force_x=0.9 * bound.sum() * grid.cell_area, max_iterations=1)
    with pytest.raises(brinell.InputError, match="friction"):
        FrictionalContact(grid, BODY, friction=-0.1).step(distance, load=1.0)
