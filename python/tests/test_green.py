# SPDX-License-Identifier: BSD-3-Clause
"""Closed forms of rectangle and cuboid against point loads, point strains and identities."""

from __future__ import annotations

import numpy as np
import pytest
from numpy.typing import NDArray

import brinell
from brinell import green

NU = 0.3
E = 2e11


def gauss(low: float, high: float, order: int = 24) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    points, weights = np.polynomial.legendre.leggauss(order)
    return 0.5 * (low + high) + 0.5 * (high - low) * points, 0.5 * (high - low) * weights


def boussinesq(x: NDArray[np.float64], y: NDArray[np.float64], z: float) -> dict[str, NDArray[np.float64]]:
    """Stress under a unit point load at the origin (Johnson 1985, Eqs. 3.19)."""
    rho = np.sqrt(x * x + y * y + z * z)
    vertical = -3 * z / (2 * np.pi * rho**5)
    return {
        "zz": vertical * z * z,
        "yz": vertical * y * z,
        "xz": vertical * x * z,
        "trace": -(1 + NU) * z / (np.pi * rho**3),
    }


def test_displacement_of_a_square_at_its_centre() -> None:
    # Four times that of a corner of the quarter, s/2 asinh(1) twice.
    assert green.rectangle_displacement(0, 0, 2.0, 2.0) == pytest.approx(8 * np.arcsinh(1), rel=1e-15)


def test_displacement_is_the_integral_of_the_distance() -> None:
    x, y, dx, dy = 1.7, -2.2, 1.0, 2.5
    (xs, wx), (ys, wy) = gauss(-dx / 2, dx / 2), gauss(-dy / 2, dy / 2)
    integral = np.einsum("i,j,ij", wx, wy, 1 / np.hypot(x - xs[:, None], y - ys))
    assert green.rectangle_displacement(x, y, dx, dy) == pytest.approx(integral, rel=1e-13)


def test_far_displacement_is_that_of_a_point_load() -> None:
    # The next term is the quadrupole of the rectangle, of order (d/r)^2: here (dx^2 + dy^2 - 3 dx^2)/24 r^2 < 1e-7.
    r = 1000.0
    assert green.rectangle_displacement(r, 0, 1.0, 2.0) == pytest.approx(2 / r, rel=1e-6)


def test_rectangle_stress_is_the_sum_of_point_loads() -> None:
    x, y, z, dx, dy = 0.4, 1.1, 1.3, 1.0, 2.0
    (xs, wx), (ys, wy) = gauss(-dx / 2, dx / 2), gauss(-dy / 2, dy / 2)
    load = boussinesq(x - xs[:, None], y - ys, z)
    expected = {name: np.einsum("i,j,ij", wx, wy, values) for name, values in load.items()}
    xx, yy, zz, yz, xz, _ = green.rectangle_stress(x, y, z, dx, dy, NU)
    found = {"zz": zz, "yz": yz, "xz": xz, "trace": xx + yy + zz}
    for name, value in found.items():
        assert value == pytest.approx(expected[name], rel=1e-12), name


def test_surface_carries_the_pressure() -> None:
    stress = green.rectangle_stress([0.0, 0.49, 0.51], 0.2, 0.0, 1.0, 1.0, NU)
    np.testing.assert_allclose(stress[2], [-1, -1, 0], atol=1e-15)
    np.testing.assert_allclose(stress[3:5], 0, atol=1e-15)


def test_points_are_broadcast() -> None:
    x, y, z = np.linspace(-1, 1, 4), np.linspace(-2, 2, 3)[:, None], np.array([0.5, 1.5])[:, None, None]
    stress = green.rectangle_stress(x, y, z, 1.0, 2.0, NU)
    assert stress.shape == (6, 2, 3, 4)
    np.testing.assert_array_equal(stress[:, 1, 2, 0], green.rectangle_stress(-1, 2, 1.5, 1.0, 2.0, NU))
    assert green.rectangle_displacement(x, y, 1.0, 1.0).shape == (3, 4)
    assert green.rectangle_displacement(0, 0, 1.0, 1.0).shape == ()


def test_any_kind_of_array_is_taken() -> None:
    x = np.arange(12)[::3]
    expected = green.rectangle_displacement(np.array([0.0, 3.0, 6.0, 9.0]), 0.5, 1, 1)
    np.testing.assert_array_equal(green.rectangle_displacement(x, np.float32(0.5), 1, 1), expected)
    np.testing.assert_array_equal(green.rectangle_displacement(list(x), 0.5, 1, 1), expected)


def test_dilating_cube_has_at_its_centre_the_stress_of_a_ball() -> None:
    # By symmetry it is hydrostatic there, and its trace is that of any dilating inclusion: -2 E e/(1 - nu) (Mura 1987).
    e = 1e-3
    stress = green.cuboid_stress(0, 0, 0, 1, 1, 1, [e, e, e, 0, 0, 0], E, NU)
    np.testing.assert_allclose(stress[:3], -2 * E * e / (3 * (1 - NU)), rtol=1e-14)
    np.testing.assert_allclose(stress[3:], 0, atol=1e-14 * E * e)


def test_no_traction_on_the_free_surface() -> None:
    strain = [1.0, -0.3, 0.2, 0.4, -0.5, 0.6]
    x = np.linspace(-3, 3, 13)
    stress = green.cuboid_stress_half_space(x, x[:, None], 0.0, 0.8, 1.0, 1.5, 1.2, strain, 1.0, NU)
    # Rounding of closed forms whose parts are of order one.
    np.testing.assert_allclose(stress[2:5], 0, atol=1e-13)
    assert np.abs(stress[[0, 1, 5]]).max() > 0.1


def test_a_deep_cuboid_does_not_feel_the_surface() -> None:
    strain = [1.0, -0.3, 0.2, 0.4, -0.5, 0.6]
    point = (0.7, 0.3, 0.2)
    full = green.cuboid_stress(*point, 1.0, 1.5, 1.2, strain, 1.0, NU)
    errors = []
    for depth in (20.0, 40.0):
        x, y, z = point
        half = green.cuboid_stress_half_space(x, y, depth + z, depth, 1.0, 1.5, 1.2, strain, 1.0, NU)
        errors.append(np.abs(half - full).max())
    assert errors[0] < 1e-3
    assert errors[0] / errors[1] == pytest.approx(8, rel=0.1)  # the image's stress falls as depth^-3


def test_surface_over_a_deep_dilatation_rises_as_over_a_point() -> None:
    # (1 + nu) e V d/(pi R^3) upwards (Mindlin, Cheng 1950; Mogi 1958); the next moment of a cube is of order (s/d)^4.
    e, depth = 1e-3, 100.0
    x = np.array([0.0, 50.0, 200.0])
    u = green.cuboid_surface_displacement(x, 0.0, depth, 1.0, 1.0, 1.0, [e, e, e, 0, 0, 0], NU)
    np.testing.assert_allclose(u, -(1 + NU) * e * depth / (np.pi * np.hypot(x, depth) ** 3), rtol=1e-6)


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        ((0, 0, -1.0, 1, 1, NU), "z has the value -1.0; allowed: not below 0"),
        ((0, 0, 1.0, 0, 1, NU), "dx = 0; allowed: above 0"),
        (([0, 1], [0, 1, 2], 1.0, 1, 1, NU), r"do not go together: x \(2,\), y \(3,\), z \(\)"),
        ((np.nan, 0, 1.0, 1, 1, NU), "x has values that are not finite"),
        (("a", 0, 1.0, 1, 1, NU), "x is not an array of real numbers"),
        (([[1], [1, 2]], 0, 1.0, 1, 1, NU), "x is not an array of real numbers"),
    ],
)
def test_what_cannot_be_computed_is_an_input_error(arguments: tuple[object, ...], message: str) -> None:
    with pytest.raises(brinell.InputError, match=message):
        green.rectangle_stress(*arguments)  # type: ignore[arg-type]


def test_an_eigenstrain_has_six_components() -> None:
    with pytest.raises(brinell.InputError, match=r"eigenstrain has the shape \(5\); it must be \(6\)"):
        green.cuboid_stress(2, 0, 0, 1, 1, 1, [1, 0, 0, 0, 0], E, NU)
    with pytest.raises(brinell.InputError, match="at least dz/2 = 0.5"):
        green.cuboid_surface_displacement(0, 0, 0.4, 1, 1, 1, [0] * 6, NU)
