# SPDX-License-Identifier: BSD-3-Clause
"""Operators of a half space against sums of closed forms, Betti's theorem and Eshelby's inclusion."""

from __future__ import annotations

import threading

import numpy as np
import pytest
from numpy.typing import NDArray

import brinell
from brinell import green
from brinell.halfspace import HalfSpace, SurfaceCompliance, SurfaceGrid, VolumeGrid

STEEL = brinell.Material(1.0, 0.3)
GRID = VolumeGrid(SurfaceGrid(9, 6, 0.5, 1.5), nz=4, dz=0.3)
ROUNDING = 1e-12  # of transforms, relative to the largest value


def strain(seed: int, grid: VolumeGrid = GRID) -> NDArray[np.float64]:
    """A random traceless field."""
    field = np.random.default_rng(seed).normal(size=(6, *grid.shape))
    field[:3] -= field[:3].mean(axis=0)
    field[2] = -field[0] - field[1]
    return field


def pressure(seed: int) -> NDArray[np.float64]:
    return np.random.default_rng(seed).normal(size=GRID.surface.shape)


def contracted(a: NDArray[np.float64], b: NDArray[np.float64]) -> float:
    """The sum of a : b; a shear component stands for two."""
    return float(np.einsum("c,ckji,ckji", [1, 1, 1, 2, 2, 2], a, b))


def test_displacement_is_the_sum_of_rectangles() -> None:
    grid = GRID.surface
    p = pressure(1)
    x, y = (coordinate.reshape(-1) for coordinate in np.broadcast_arrays(grid.x, grid.y))
    influence = green.rectangle_displacement(x[:, None] - x, y[:, None] - y, grid.dx, grid.dy)
    compliance = SurfaceCompliance(grid, STEEL, brinell.Material(3.0, 0.2))
    modulus = 1 / ((1 - 0.3**2) / 1.0 + (1 - 0.2**2) / 3.0)
    assert compliance.contact_modulus == pytest.approx(modulus, rel=1e-14)
    expected = (influence @ p.reshape(-1)).reshape(grid.shape) / (np.pi * modulus)
    np.testing.assert_allclose(compliance.pressure_to_displacement(p), expected, atol=ROUNDING * np.abs(expected).max())


def test_compliance_is_symmetric_and_positive() -> None:
    compliance = SurfaceCompliance(GRID.surface, STEEL)
    p, q = pressure(1), pressure(2)
    Ap, Aq = compliance.pressure_to_displacement(p), compliance.pressure_to_displacement(q)
    assert np.vdot(q, Ap) == pytest.approx(np.vdot(p, Aq), abs=ROUNDING * np.linalg.norm(q) * np.linalg.norm(Ap))
    assert np.vdot(p, Ap) > 0


def test_stress_is_the_mean_of_rectangles_over_a_layer() -> None:
    grid, p = GRID.surface, pressure(3)
    points, weights = np.polynomial.legendre.leggauss(12)
    k, j, i = 2, 1, 7
    z = (k + 0.5 + 0.5 * points) * GRID.dz
    x, y = grid.x[i] - grid.x[:, None], grid.y[j] - grid.y[:, :, None]
    parts = green.rectangle_stress(x, y, z, grid.dx, grid.dy, 0.3)
    expected = np.einsum("cjig,ji,g", parts, p, 0.5 * weights)
    found = HalfSpace(GRID, STEEL).pressure_to_stress(p)
    assert found.shape == (6, 4, 6, 9)
    # The engine's rule in depth: three points a layer, of sixth order, for fields that vary over half a cell, 0.25.
    np.testing.assert_allclose(found[:, k, j, i], expected, atol=1e-6)


def test_reprs_name_the_grid() -> None:
    assert repr(HalfSpace(GRID, STEEL)) == "<HalfSpace 9 x 6 x 4 cells>"
    assert repr(SurfaceCompliance(GRID.surface, STEEL)) == "<SurfaceCompliance 9 x 6 cells>"


def test_betti_binds_pressure_and_plastic_strain() -> None:
    body = HalfSpace(GRID, STEEL)
    p, eps = pressure(4), strain(5)
    stress, u = body.pressure_to_stress(p), body.eigenstrain_to_displacement(eps)
    inside = contracted(stress, eps) * GRID.cell_volume
    assert inside == pytest.approx(
        np.vdot(p, u) * GRID.surface.cell_area,
        abs=ROUNDING * np.linalg.norm(stress) * np.linalg.norm(eps) * GRID.cell_volume,
    )


def test_residual_stress_is_symmetric_and_stores_energy() -> None:
    body = HalfSpace(GRID, STEEL)
    a, b = strain(6), strain(7)
    Ha, Hb = body.eigenstrain_to_stress(a), body.eigenstrain_to_stress(b)
    assert contracted(Ha, b) == pytest.approx(contracted(Hb, a), abs=ROUNDING * np.linalg.norm(Ha) * np.linalg.norm(b))
    assert contracted(Ha, a) < 0  # the elastic energy is -1/2 of it


def test_stresses_add_up() -> None:
    body = HalfSpace(GRID, STEEL)
    p, eps = pressure(8), strain(9)
    both = body.stress(p, eps)
    np.testing.assert_allclose(
        both, body.pressure_to_stress(p) + body.eigenstrain_to_stress(eps), atol=ROUNDING * np.abs(both).max()
    )


def test_displacement_of_a_cuboid_comes_from_its_closed_form() -> None:
    """Exact in the plane; in depth three Gauss points a layer, of sixth order."""
    eps = np.array([0.4, 0.3, -0.7, 0.2, -0.5, 0.6])
    errors = []
    for parts in (1, 2, 4):
        grid = VolumeGrid(SurfaceGrid(9 * parts, 9 * parts, 1 / parts, 1 / parts), nz=4 * parts, dz=1 / parts)
        field = np.zeros((6, *grid.shape))
        block = slice(4 * parts, 5 * parts)
        field[:, 2 * parts : 3 * parts, block, block] = eps[:, None, None, None]
        found = HalfSpace(grid, STEEL).eigenstrain_to_displacement(field)
        exact = green.cuboid_surface_displacement(grid.surface.x, grid.surface.y, 2.5, 1, 1, 1, eps, 0.3)
        errors.append(np.abs(found - exact).max() / np.abs(exact).max())
    print("displacement of a cuboid, relative errors", errors)
    orders = np.log2(np.array(errors[:-1]) / errors[1:])
    np.testing.assert_array_less(5.5, orders)


def test_deep_ball_has_eshelbys_stress_at_its_centre() -> None:
    """Ball after ball, each with a uniform stress inside: -2 mu (1 - beta) eps at the centre (Eshelby 1957)."""
    nu, s, depth = 0.3, 2.0, 16.0
    beta = 2 * (4 - 5 * nu) / (15 * (1 - nu))
    eps = np.array([0.4, 0.3, -0.7, 0.2, -0.5, 0.6])
    # The free surface, eight s above, adds the image of a point of strain, up to (s/16 s)^2 of itself.
    half = green.cuboid_stress_half_space(0, 0, depth, depth, 1, 1, 1, eps, 1.0, nu)
    image = (2 * np.pi) ** 1.5 * s**3 * (half - green.cuboid_stress(0, 0, 0, 1, 1, 1, eps, 1.0, nu))
    expected = -(1 - beta) / (1 + nu) * eps + image
    errors = []
    for layers in (1, 2, 4):
        dz = depth / (8 * layers + 0.5)  # the centre in the middle of a layer
        grid = VolumeGrid(SurfaceGrid(29, 29, 1.25, 1.25), nz=13 * layers + 1, dz=dz)
        r2 = grid.surface.x**2 + grid.surface.y**2 + (grid.z - depth) ** 2
        found = HalfSpace(grid, STEEL).eigenstrain_to_stress(eps[:, None, None, None] * np.exp(-0.5 * r2 / s**2))
        errors.append(np.abs(found[:, 8 * layers, 14, 14] - expected).max())
    print("stress at the centre of a ball, errors", errors)
    # Layers of constant strain: second order.
    assert np.log2(errors[1] / errors[2]) > 1.8


def test_one_operator_serves_several_threads() -> None:
    body = HalfSpace(GRID, STEEL)
    fields = [strain(seed) for seed in range(4)]
    expected = [body.eigenstrain_to_stress(field) for field in fields]
    found: dict[int, NDArray[np.float64]] = {}
    threads = [
        threading.Thread(target=lambda n=n: found.update({n: body.eigenstrain_to_stress(fields[n])})) for n in range(4)
    ]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    for n in range(4):
        np.testing.assert_array_equal(found[n], expected[n])


def test_results_own_their_memory_and_inputs_stay() -> None:
    body = HalfSpace(GRID, STEEL)
    p = pressure(1)
    before = p.copy()
    first, second = body.pressure_to_stress(p), body.pressure_to_stress(p)
    assert not np.shares_memory(first, second)
    assert first.flags.c_contiguous
    assert first.flags.writeable
    del body
    np.testing.assert_array_equal(first, second)
    np.testing.assert_array_equal(p, before)


def test_stress_of_shears_is_the_mean_of_rectangles_over_a_layer() -> None:
    grid, q_x, q_y = GRID.surface, pressure(11), pressure(12)
    points, weights = np.polynomial.legendre.leggauss(3)  # the rule that the engine uses
    x, y = (coordinate.reshape(-1) for coordinate in np.broadcast_arrays(grid.x, grid.y))
    expected = np.zeros((6, *GRID.shape))
    for layer in range(GRID.nz):
        for point, weight in zip(points, weights, strict=True):
            z = (layer + 0.5 + 0.5 * point) * GRID.dz
            for traction, q in (("shear_x", q_x), ("shear_y", q_y)):
                influence = green.rectangle_stress(
                    x[:, None] - x, y[:, None] - y, z, grid.dx, grid.dy, 0.3, traction=traction
                )
                expected[:, layer] += 0.5 * weight * (influence @ q.reshape(-1)).reshape(6, *grid.shape)
    found = HalfSpace(GRID, STEEL).stress(shear_x=q_x, shear_y=q_y)
    np.testing.assert_allclose(found, expected, atol=ROUNDING * np.abs(expected).max())


def test_betti_holds_for_shears() -> None:
    body, eps = HalfSpace(GRID, STEEL), strain(13)
    for axis, name in (("x", "shear_x"), ("y", "shear_y"), ("z", "pressure")):
        q = pressure(14)
        stress = body.stress(**{name: q})
        inside = contracted(stress, eps) * GRID.cell_volume
        outside = float(np.vdot(q, body.eigenstrain_to_displacement(eps, axis))) * GRID.surface.cell_area
        scale = np.linalg.norm(stress) * np.linalg.norm(eps) * GRID.cell_volume
        assert inside == pytest.approx(outside, abs=ROUNDING * scale)


@pytest.mark.parametrize(("boundary", "reference"), [("open", None), ("periodic", None), (("open", "periodic"), 40.0)])
def test_displacement_of_tractions_is_symmetric(boundary: str | tuple[str, str], reference: float | None) -> None:
    grid = SurfaceGrid(9, 6, 0.5, 1.5, boundary=boundary)
    compliance = SurfaceCompliance(grid, STEEL, brinell.Material(3.0, 0.1), reference=reference)
    a, b = (np.random.default_rng(seed).normal(size=(3, *grid.shape)) for seed in (1, 2))
    of_a, of_b = (compliance.displacement(load[2], load[0], load[1]) for load in (a, b))
    assert np.vdot(a, of_b) == pytest.approx(np.vdot(b, of_a), abs=ROUNDING * np.linalg.norm(a) * np.linalg.norm(of_b))
    assert np.vdot(a, of_a) > 0
    of_pressure = compliance.displacement(a[2])
    np.testing.assert_allclose(
        of_pressure[2], compliance.pressure_to_displacement(a[2]), atol=ROUNDING * np.abs(of_pressure).max()
    )


def test_a_shear_is_told_by_name() -> None:
    with pytest.raises(brinell.InputError, match=r"shear_y has the shape \(9, 6\); it must be \(6, 9\)"):
        HalfSpace(GRID, STEEL).stress(shear_y=np.zeros((9, 6)))
    with pytest.raises(brinell.InputError, match="shear_x has values that are not finite"):
        SurfaceCompliance(GRID.surface, STEEL).displacement(shear_x=np.full(GRID.surface.shape, np.nan))
    with pytest.raises(brinell.InputError, match="axis = 'w' of a displacement; allowed: 'x', 'y', 'z'"):
        HalfSpace(GRID, STEEL).eigenstrain_to_displacement(strain(1), "w")
    with pytest.raises(brinell.InputError, match="traction = 'friction'; allowed: 'pressure', 'shear_x', 'shear_y'"):
        green.rectangle_stress(0.0, 0.0, 1.0, 1.0, 1.0, 0.3, traction="friction")


def test_a_view_and_another_type_are_taken() -> None:
    compliance = SurfaceCompliance(GRID.surface, STEEL)
    p = np.arange(54).reshape(9, 6).T
    expected = compliance.pressure_to_displacement(np.ascontiguousarray(p, dtype=np.float64))
    np.testing.assert_array_equal(compliance.pressure_to_displacement(p), expected)
    np.testing.assert_array_equal(compliance.pressure_to_displacement(p.astype(np.float32)), expected)


def test_coordinates_have_their_origin_in_the_middle() -> None:
    np.testing.assert_allclose(GRID.surface.x, [-2, -1.5, -1, -0.5, 0, 0.5, 1, 1.5, 2])
    np.testing.assert_allclose(GRID.surface.y[:, 0], [-3.75, -2.25, -0.75, 0.75, 2.25, 3.75])
    np.testing.assert_allclose(GRID.z[:, 0, 0], [0.15, 0.45, 0.75, 1.05])
    assert (GRID.z + GRID.surface.x * GRID.surface.y).shape == GRID.shape


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        ((0, 1, 1.0, 1.0), "nx = 0 of a grid; allowed: a whole number of cells"),
        ((2.5, 1, 1.0, 1.0), "nx = 2.5"),
        ((1, 10**9, 1.0, 1.0), "ny = 1000000000"),
        ((1, 1, -1.0, 1.0), "dx = -1.0 of a grid; allowed: a length from 1e-30"),
        ((1, 1, 1.0, float("inf")), "dy = inf"),
        ((1, 1, "1 um", 1.0), "dx = '1 um' is text; allowed: a finite number, in m"),
    ],
)
def test_an_impossible_grid_is_an_input_error(arguments: tuple[int, int, float, float], message: str) -> None:
    with pytest.raises(brinell.InputError, match=message):
        SurfaceGrid(*arguments)


def test_wrong_shapes_are_told_with_both() -> None:
    body = HalfSpace(GRID, STEEL)
    with pytest.raises(brinell.InputError, match=r"pressure has the shape \(9, 6\); it must be \(6, 9\)"):
        body.pressure_to_stress(np.zeros((9, 6)))
    with pytest.raises(
        brinell.InputError, match=r"eigenstrain has the shape \(5, 4, 6, 9\); it must be \(6, 4, 6, 9\)"
    ):
        body.eigenstrain_to_stress(np.zeros((5, 4, 6, 9)))
    with pytest.raises(brinell.InputError, match="pressure has the shape"):
        SurfaceCompliance(GRID.surface, STEEL).pressure_to_displacement(np.zeros(54))
    with pytest.raises(brinell.InputError, match="eigenstrain has the trace 3"):
        body.eigenstrain_to_displacement(np.ones((6, 4, 6, 9)))
    with pytest.raises(brinell.InputError, match="rigid"):
        HalfSpace(GRID, brinell.RIGID)
    with pytest.raises(brinell.InputError, match="rigid"):
        SurfaceCompliance(GRID.surface, brinell.RIGID)
