# SPDX-License-Identifier: BSD-3-Clause
"""Elastic contact against Hertz; what is refused, and what other threads do meanwhile."""

from __future__ import annotations

import threading

import numpy as np
import pytest

import brinell
from brinell.contact import ElasticContact, contact_area
from brinell.halfspace import SurfaceGrid
from brinell.reference import point_contact

STEEL = brinell.Material("210 GPa", 0.3)
RADIUS = 0.01
HERTZ = point_contact(RADIUS, 210e9 / (1 - 0.3**2), load=10.0)


def ball(cells: int) -> tuple[ElasticContact, np.ndarray]:
    """A ball, on a grid of that many cells per contact radius and 1.5 contact radii each way."""
    half = cells + cells // 2
    grid = SurfaceGrid(2 * half + 1, 2 * half + 1, HERTZ.contact_radius / cells, HERTZ.contact_radius / cells)
    return ElasticContact(grid, STEEL), (grid.x**2 + grid.y**2) / (2 * RADIUS)


def test_pressure_and_approach_converge_to_hertz() -> None:
    pressures, approaches = [], []
    for cells in (8, 16, 32, 64):
        contact, distance = ball(cells)
        result = contact.solve(distance, load=HERTZ.load)
        assert result.converged
        assert result.load == pytest.approx(HERTZ.load, rel=1e-14)
        assert result.pressure.min() == 0.0
        exact = HERTZ.peak_pressure * np.sqrt(np.clip(1 - 2 * RADIUS * distance / HERTZ.contact_radius**2, 0, None))
        pressures.append(float(np.sqrt(np.mean((result.pressure - exact) ** 2))) / HERTZ.peak_pressure)
        approaches.append(abs(result.approach / HERTZ.approach - 1))
    print("pressure", pressures, "approach", approaches)
    # The root of the pressure at the rim: the mean square error is of first order or better; that of the approach, an
    # energy, is smaller.
    order = np.log2(np.array(pressures[:-1]) / pressures[1:])
    assert order.mean() > 1.0
    assert approaches[-1] < 1e-5


def test_area_is_finer_than_the_cells() -> None:
    exact = np.pi * HERTZ.contact_radius**2
    for cells in (4, 8, 16):
        contact, distance = ball(cells)
        result = contact.solve(distance, load=HERTZ.load)
        # A scatter of first order remains; that of counted cells is five times as large (13 %, 6 % and 1 % here).
        assert result.contact_area == pytest.approx(exact, rel=0.08 / cells)
        again = contact_area(contact.grid, result.pressure, result.gap, contact.compliance.contact_modulus)
        assert again == result.contact_area
    with pytest.raises(brinell.InputError, match="pressure"):
        contact_area(contact.grid, result.pressure[1:], result.gap, 1e9)
    with pytest.raises(brinell.InputError, match="contact_modulus = 0; allowed: > 0"):
        contact_area(contact.grid, result.pressure, result.gap, 0.0)


def test_load_and_approach_give_the_same_contact() -> None:
    contact, distance = ball(16)
    by_load = contact.solve(distance, load=HERTZ.load)
    by_approach = contact.solve(distance, approach=by_load.approach)
    assert by_approach.load == pytest.approx(by_load.load, rel=1e-6)
    # Both are solved to a gap of 1e-7 of the approach.
    np.testing.assert_allclose(by_approach.pressure, by_load.pressure, atol=1e-5 * HERTZ.peak_pressure)


def test_the_solution_meets_its_conditions() -> None:
    contact, distance = ball(16)
    tolerance = 1e-12
    result = contact.solve(distance, load=HERTZ.load, tolerance=tolerance)
    assert result.residual <= tolerance
    gap = distance - result.approach + contact.compliance.pressure_to_displacement(result.pressure)
    np.testing.assert_allclose(result.gap, gap, atol=1e-14 * HERTZ.approach)
    assert np.abs(gap[result.pressure > 0]).max() <= tolerance * (1 + 1e-9)
    assert gap.min() >= -tolerance * (1 + 1e-9)


def test_a_good_guess_saves_iterations_and_stays_as_it_was() -> None:
    contact, distance = ball(16)
    first = contact.solve(distance, load=HERTZ.load)
    guess = first.pressure.copy()
    again = contact.solve(distance, load=HERTZ.load, guess=guess)
    assert again.contact_iterations < 0.2 * first.contact_iterations
    np.testing.assert_array_equal(guess, first.pressure)
    assert not np.shares_memory(guess, again.pressure)


def test_without_load_the_surfaces_touch() -> None:
    contact, distance = ball(8)
    result = contact.solve(distance + 3e-6, load=0.0)
    assert result.approach == pytest.approx(3e-6, rel=1e-12)
    assert not result.pressure.any()
    apart = contact.solve(distance, approach=-1e-6)
    assert apart.load == 0.0
    assert apart.gap.min() == pytest.approx(1e-6)


def test_a_contact_that_the_grid_cuts_off_is_told() -> None:
    contact, distance = ball(6)
    assert not contact.solve(distance, load=10.0).reaches_edge
    with pytest.warns(brinell.CaseWarning, match="reaches the edge of its grid"):
        assert contact.solve(distance, load=100.0).reaches_edge


def test_unconverged_is_an_error() -> None:
    contact, distance = ball(8)
    with pytest.raises(brinell.ConvergenceError, match="no convergence after 2 iterations: .* residual is .* m"):
        contact.solve(distance, load=HERTZ.load, max_iterations=2)


def test_what_does_not_fit_is_an_input_error() -> None:
    contact, distance = ball(8)
    with pytest.raises(brinell.InputError, match="load = -1; allowed: finite, not below 0"):
        contact.solve(distance, load=-1.0)
    with pytest.raises(brinell.InputError, match="either load or approach"):
        contact.solve(distance)
    with pytest.raises(brinell.InputError, match="either load or approach"):
        contact.solve(distance, load=1.0, approach=1e-6)
    with pytest.raises(brinell.InputError, match=r"distance has the shape \(24, 25\); it must be \(25, 25\)"):
        contact.solve(distance[1:], load=1.0)
    with pytest.raises(brinell.InputError, match="guess has the shape"):
        contact.solve(distance, load=1.0, guess=[0.0])
    with pytest.raises(brinell.InputError, match="load has 2 values; allowed: one, a finite number, in N"):
        contact.solve(distance, load=[1.0, 2.0])  # type: ignore[arg-type]
    with pytest.raises(brinell.InputError, match="approach = '1 um' is text; allowed: a finite number, in m"):
        contact.solve(distance, approach="1 um")  # type: ignore[arg-type]
    with pytest.raises(brinell.InputError, match="load = '1 N' is text; allowed: a finite number, in N"):
        contact.solve(distance, load="1 N")  # type: ignore[arg-type]
    with pytest.raises(brinell.InputError, match="max_iterations = -1"):
        contact.solve(distance, load=1.0, max_iterations=-1)
    with pytest.raises(brinell.InputError, match="approach = nan"):
        contact.solve(distance, approach=float("nan"))
    with pytest.raises(brinell.InputError, match="distance has values that are not finite"):
        contact.solve(np.where(distance > 0, distance, np.nan), load=1.0)


def test_other_threads_go_on_while_it_solves() -> None:
    contact, distance = ball(64)
    running, counted = threading.Event(), 0
    done = threading.Event()

    def count() -> None:
        nonlocal counted
        running.set()
        while not done.wait(1e-4):
            counted += 1

    thread = threading.Thread(target=count)
    thread.start()
    running.wait()
    before = counted
    contact.solve(distance, load=HERTZ.load)
    during = counted - before
    done.set()
    thread.join()
    # The solution takes hundreds of transforms of 384^2 values; with the lock held the other thread would not move, but
    # perhaps before and after. A busy machine leaves it few turns.
    assert during > 3


def test_reprs_are_short() -> None:
    contact, distance = ball(2)
    assert repr(contact) == "<ElasticContact 7 x 7 cells>"
    result = contact.solve(distance, load=2.5)
    assert repr(result) == f"<ContactResult 7 x 7 cells, load 2.5 N, approach {result.approach:g} m>"


def test_periodic_waves_are_westergaards() -> None:
    # The mean pressure pi E' h / L closes a wave h (1 - cos(2 pi x / L)); half of it presses on (2/pi) asin(sqrt(1/2)).
    n, length, height = 256, 1e-3, 1e-6
    grid = SurfaceGrid(n, 4, length / n, length / n, boundary="periodic")
    contact = ElasticContact(grid, STEEL)
    distance = height * (1 - np.cos(2 * np.pi * grid.x / length)) + 0 * grid.y
    full = np.pi * contact.compliance.contact_modulus * height / length
    half = contact.solve(distance, load=0.5 * full * length * 4 * grid.dy)
    assert np.count_nonzero(half.pressure) / half.pressure.size == pytest.approx(0.5, abs=2 / n)
    with pytest.raises(brinell.InputError, match="allowed: at most the mean distance of the surfaces"):
        contact.solve(distance, approach=1.01 * height)


def test_a_row_with_copies_is_a_long_roller() -> None:
    load, modulus = 1e5, 210e9 / (1 - 0.3**2)  # N/m
    half_width = float(np.sqrt(4 * load * RADIUS / (np.pi * modulus)))
    grid = SurfaceGrid(161, 1, half_width / 40, 1e-3, boundary=("open", "periodic"))
    contact = ElasticContact(grid, STEEL, reference=1.0)
    result = contact.solve(grid.x**2 / (2 * RADIUS) + 0 * grid.y, load=load * grid.dy)
    # A strip of one cell at the edge carries a share (dx / a)^1.5 of the load.
    assert result.pressure.max() == pytest.approx(2 * load / (np.pi * half_width), rel=40**-1.5)
    with pytest.raises(brinell.InputError, match="reference = None"):
        ElasticContact(grid, STEEL)
    with pytest.raises(brinell.InputError, match="reference = -1"):
        ElasticContact(grid, STEEL, reference=-1.0)
    with pytest.raises(brinell.InputError, match="boundary = 'closed' of a grid; allowed: 'open', 'periodic'"):
        SurfaceGrid(3, 3, 1.0, 1.0, "closed")
