# SPDX-License-Identifier: BSD-3-Clause
from collections.abc import Callable

import numpy as np
import pytest

import brinell
from brinell import reference
from brinell.contact import ElasticContact
from brinell.halfspace import Layer, SurfaceGrid
from brinell.reference import elastic_tugging_forces, elastic_tugging_reach

ALPHA_C = 2.214290e-4  # R1 = R2 = 1 m, E = 200 GPa, nu = 0.32, S_y = 0.9115 GPa


@pytest.mark.parametrize(
    ("alpha", "slope", "peak", "position", "aligned"),
    [
        (1, 0.01488, 0.00483, -0.02976, 1.000),
        (4, 0.02977, 0.07733, -0.05951, 8.000),
        (9, 0.04467, 0.39156, -0.08923, 27.000),
        (15, 0.05770, 1.08790, -0.11516, 58.095),
    ],
)
def test_elastic_limit(alpha: float, slope: float, peak: float, position: float, aligned: float) -> None:
    """Exact values, given to five digits: half a unit of the last one is the tolerance."""
    geometry = (1.0, 1.0, alpha * ALPHA_C)
    reach = elastic_tugging_reach(*geometry)
    assert reach / (2.0 - alpha * ALPHA_C) == pytest.approx(slope, abs=0.6e-5)
    X = np.linspace(-reach, reach, 200001)
    f_x, f_z = elastic_tugging_forces(X, *geometry, ALPHA_C)
    assert f_x.max() == pytest.approx(peak, abs=0.6e-5)
    assert X[f_x.argmax()] / 0.5 == pytest.approx(position, abs=1e-5)
    assert f_z[100000] == pytest.approx(aligned, abs=0.6e-3)
    np.testing.assert_allclose(f_x, -f_x[::-1], atol=1e-12 * aligned)  # nothing is lost
    np.testing.assert_allclose(f_z, f_z[::-1], atol=1e-12 * aligned)


def test_no_force_without_overlap() -> None:
    reach = elastic_tugging_reach(1.0, 2.0, 1e-3)
    f_x, f_z = elastic_tugging_forces([-1.1 * reach, 1.1 * reach], 1.0, 2.0, 1e-3, 1e-4)
    assert not np.any(f_x)
    assert not np.any(f_z)


def test_point_contact_meets_its_equations() -> None:
    R, E = 0.01, 1.1e11
    contact = reference.point_contact(R, E, load=50.0)
    a = contact.contact_radius
    assert a == pytest.approx((0.75 * 50.0 * R / E) ** (1 / 3), rel=1e-14)  # Johnson 1985, Eq. 4.22
    assert contact.approach == pytest.approx(a * a / R, rel=1e-14)
    assert contact.peak_pressure == pytest.approx(1.5 * 50.0 / (np.pi * a * a), rel=1e-14)
    again = reference.point_contact(R, E, approach=contact.approach)
    assert again.load == pytest.approx(50.0, rel=1e-13)


def test_elliptical_contact_of_equal_radii_is_a_circle() -> None:
    circle = reference.point_contact(0.01, 1.1e11, load=50.0)
    ellipse = reference.elliptical_contact(0.01, 0.01, 1.1e11, load=50.0)
    assert ellipse.semi_axis_x == pytest.approx(circle.contact_radius, rel=1e-12)
    assert ellipse.approach == pytest.approx(circle.approach, rel=1e-12)
    long = reference.elliptical_contact(0.01, 0.1, 1.1e11, approach=1e-6)
    assert long.semi_axis_y > long.semi_axis_x
    assert long.load == pytest.approx(2 / 3 * np.pi * long.semi_axis_x * long.semi_axis_y * long.peak_pressure)


def test_line_contact_carries_its_load() -> None:
    line = reference.line_contact(0.01, 1.1e11, 2e4)
    a, p0 = line.half_width, line.peak_pressure
    z = np.linspace(0.0, 5 * a, 11)
    xx, yy, zz, _, xz, _ = reference.line_contact_stress(0.0, z, a, p0, 0.3)
    s = z / a  # Johnson 1985, Eqs. 4.46
    np.testing.assert_allclose(zz, -p0 / np.hypot(1, s), rtol=1e-13)
    np.testing.assert_allclose(xx, -p0 * ((1 + 2 * s**2) / np.hypot(1, s) - 2 * s), rtol=1e-11)
    np.testing.assert_allclose(yy, 0.3 * (xx + zz), rtol=1e-14)
    np.testing.assert_array_equal(xz, 0.0)
    points, weights = np.polynomial.legendre.leggauss(200)  # the load at a depth, in t = arctan(x/z)
    t = 0.5 * np.pi * points
    below = reference.line_contact_stress(2 * a * np.tan(t), 2 * a, a, p0, 0.3)[2]
    assert -np.sum(0.5 * np.pi * weights * below * 2 * a / np.cos(t) ** 2) == pytest.approx(2e4, rel=1e-10)


def test_first_yield_is_where_the_field_is_largest() -> None:
    first = reference.first_yield(0.3)
    assert first.pressure_ratio == pytest.approx(1.6128, abs=1e-4)
    assert reference.critical_pressure_ratio(0.3) == pytest.approx(first.pressure_ratio, rel=1.5e-3)
    z = np.linspace(0, 2, 2001)
    xx, _, zz, *_ = reference.point_contact_stress(0, 0, z, 1.0, 1.0, 0.3)  # xx = yy on the axis
    assert z[np.argmax(xx - zz)] == pytest.approx(first.depth_ratio, abs=1e-3)
    assert (xx - zz).max() * first.pressure_ratio == pytest.approx(1.0, rel=1e-6)


def test_friction_brings_first_yield_to_the_edge_behind_the_slider() -> None:
    assert reference.first_yield(0.3, 0.0) == reference.first_yield(0.3)
    beneath, edge = reference.first_yield(0.3, 0.2), reference.first_yield(0.3, 0.4)
    assert beneath.pressure_ratio == pytest.approx(1.5684, abs=3e-4)  # Cerruti's point force, on a grid of a/50
    assert beneath.x_ratio == pytest.approx(0.2, abs=0.05)
    assert (edge.x_ratio, edge.depth_ratio) == (-1.0, 0.0)
    xx, _, _, _, xz, _ = reference.point_contact_stress([-1.0, 0.0], 0.0, 0.0, 1.0, 1.0, 0.3, friction=0.4)
    assert xx[0] == pytest.approx((1 - 2 * 0.3) / 3 + 0.4 * np.pi * 4.3 / 8, abs=1e-7)  # Hamilton 1983
    assert xz[1] == pytest.approx(-0.4, rel=1e-9)
    line = reference.line_contact_first_yield(0.3, 0.3)
    stress = reference.line_contact_stress(line.x_ratio, line.depth_ratio, 1.0, 1.0, 0.3, friction=0.3)
    xx, yy, zz, _, xz, _ = stress
    von_mises = np.sqrt(0.5 * ((xx - yy) ** 2 + (yy - zz) ** 2 + (zz - xx) ** 2) + 3 * xz**2)
    assert von_mises * line.pressure_ratio == pytest.approx(1.0, rel=1e-10)


def test_critical_values_are_those_of_hertz() -> None:
    critical = reference.critical_values(0.01, 1.1e11, 8e8, poisson_ratio=0.3)
    hertz = reference.point_contact(0.01, 1.1e11, approach=critical.interference)
    assert critical.peak_pressure == pytest.approx(reference.critical_pressure_ratio(0.3) * 8e8)
    assert hertz.peak_pressure == pytest.approx(critical.peak_pressure, rel=1e-13)
    assert hertz.load == pytest.approx(critical.load, rel=1e-13)
    assert reference.critical_values(0.01, 1.1e11, 8e8, C=1.6).C == 1.6


def test_first_yield_of_a_line_is_where_the_field_is_largest() -> None:
    for nu in (0.0, 0.15, 0.25, 0.32, 0.5):
        first = reference.line_contact_first_yield(nu)
        x, z = np.meshgrid(np.linspace(0, 1.2, 121), np.linspace(0, 2, 2001))
        xx, yy, zz, _, xz, _ = reference.line_contact_stress(x, z, 1.0, 1.0, nu)
        von_mises = np.sqrt(0.5 * ((xx - yy) ** 2 + (yy - zz) ** 2 + (zz - xx) ** 2) + 3 * xz**2)
        assert von_mises.max() * first.pressure_ratio == pytest.approx(1.0, rel=1e-6)
        assert z.flat[von_mises.argmax()] == pytest.approx(first.depth_ratio, abs=1e-3)
        fit = 1.164 + 2.975 * nu - 2.906 * nu**2 if nu > 0.1938 else 1 / (1 - 2 * nu)  # Green 2005
        assert fit == pytest.approx(first.pressure_ratio, rel=1.5e-3)


def test_critical_values_of_cylinders_are_those_of_hertz_and_green() -> None:
    R, E, S_y = 0.5, 1.114082e11, 0.9115e9
    critical = reference.critical_line_values(R, E, S_y, poisson_ratio=0.32, length=2.0)
    p = critical.peak_pressure / E
    logarithm = np.log(2 / p)
    assert reference.line_contact_first_yield(0.32).pressure_ratio == critical.C
    assert critical.interference == pytest.approx(R * p**2 * (2 * logarithm - 1), rel=1e-12)
    assert critical.energy == pytest.approx(2 * np.pi * R**2 * p**4 * E / 4 * (4 * logarithm - 3), rel=1e-12)
    line = reference.line_contact(R, E, approach=critical.interference)
    assert 2.0 * line.load_per_length == pytest.approx(critical.load, rel=1e-12)
    assert line.half_width == pytest.approx(critical.contact_radius, rel=1e-12)
    assert critical.contact_area == pytest.approx(2 * line.half_width * 2.0, rel=1e-12)
    other = reference.critical_line_values(R, E, S_y, C=critical.C, reference=0.1)
    approach = reference.line_contact(R, E, other.load, reference=0.1).approach
    assert approach == pytest.approx(other.interference, rel=1e-12)
    assert approach < critical.interference


def test_elastic_tugging_of_cylinders_is_that_of_their_line_contact() -> None:
    R, E, alpha = 0.5, 1.1e11, 1e-3
    cylinders = reference.ElasticTugging(1.0, 1.0, E, alpha, length=3.0, reference=0.4)
    line = reference.line_contact(R, E, approach=alpha, reference=0.4)
    assert float(cylinders.forces(0.0).F_Z) == pytest.approx(3.0 * line.load_per_length, rel=1e-12)
    critical = 0.25 * alpha
    X = np.linspace(-0.05, 0.05, 11)
    f_x, f_z = reference.elastic_tugging_forces(X, 1.0, 1.0, alpha, critical, reference=0.4)
    P_c = 3.0 * reference.line_contact(R, E, approach=critical, reference=0.4).load_per_length
    np.testing.assert_allclose(f_x, cylinders.forces(X).F_X / P_c, rtol=1e-12)
    np.testing.assert_allclose(f_z, cylinders.forces(X).F_Z / P_c, rtol=1e-12)


def test_indented_spheres_are_hertz_at_first() -> None:
    ratio = np.array([[0.5, 1.0], [1.5, 1.8]])  # the fits begin at 1.9
    load = reference.jackson_green_load(ratio, 2e11, 0.3, 1e9)
    np.testing.assert_allclose(load, ratio**1.5, rtol=1e-14)
    np.testing.assert_allclose(reference.jackson_green_area(ratio, 2e11, 0.3, 1e9), ratio, rtol=1e-14)
    assert reference.jackson_green_pressure_ratio(0.3) == pytest.approx(1.295 * np.exp(0.736 * 0.3))
    np.testing.assert_allclose(
        reference.kogut_etsion_load([0.5, 3.0, 50.0]), [0.5**1.5, 1.03 * 3**1.425, 1.4 * 50**1.263], rtol=1e-14
    )


def test_peak_and_work_of_elastic_tugging_are_those_of_its_forces() -> None:
    tugging = reference.ElasticTugging(1.0, 2.0, 1e11, 1e-3)
    d0 = tugging.half_sliding_distance
    X = np.linspace(-d0, d0, 100001)
    forces = tugging.forces(X)
    F_X, at = tugging.peak()
    assert forces.F_X.max() == pytest.approx(F_X, rel=1e-8)
    assert X[forces.F_X.argmax()] == pytest.approx(at, abs=2 * d0 / 100000)
    half = X <= 0
    assert tugging.work(-d0, 0.0) == pytest.approx(np.trapezoid(forces.F_X[half], X[half]), rel=1e-8)
    np.testing.assert_allclose(np.hypot(forces.F_X, forces.F_Z), forces.load, rtol=1e-14)


@pytest.mark.parametrize(
    ("call", "message"),
    [
        (lambda: reference.point_contact(0.01, 1e11, load=-1.0), "load = -1"),
        (lambda: reference.point_contact(0.01, 1e11), "either load or approach"),
        (lambda: reference.point_contact(0.01, 1e11, load=1.0, approach=1e-6), "either load or approach"),
        (lambda: reference.line_contact(0.0, 1e11, 1.0), "radius = 0"),
        (lambda: reference.first_yield(0.6), "0.6 is outside"),
        (lambda: reference.first_yield(0.3, -0.1), "friction = -0.1"),
        (lambda: reference.kogut_etsion_load([1.0, 111.0]), "111"),
        (lambda: reference.critical_values(0.01, 1e11, 1e9), "either poisson_ratio or C"),
        (lambda: reference.critical_line_values(0.01, 1e11, 1e9), "either poisson_ratio or C"),
        (lambda: reference.critical_line_values(0.01, 1e11, 1e9, C=1.8, reference=1e-6), "reference = 1e-06"),
        (lambda: reference.line_contact_first_yield(0.6), "0.6 is outside"),
        (lambda: reference.line_contact(0.01, 1e11), "either load_per_length or approach"),
        (lambda: reference.line_contact(0.01, 1e11, approach=0.01), "approach = 0.01"),
        (lambda: reference.ElasticTugging(1.0, 1.0, 1e11, 1e-3, reference=1.0), "give their length"),
        (lambda: reference.ElasticTugging(1.0, 1.0, 1e11, 3.0), "interference"),
        (lambda: reference.point_contact_stress(0, 0, -1, 1, 1, 0.3), "z has the value -1"),
        (lambda: reference.contact_modulus(brinell.RIGID), "both bodies are rigid"),
    ],
)
def test_what_is_out_of_range_is_an_input_error(call: Callable[[], object], message: str) -> None:
    with pytest.raises(brinell.InputError, match=message):
        call()


def test_coated_contact_is_what_the_cells_find() -> None:
    steel, coat = brinell.Material("210 GPa", 0.3), Layer(2e-6, brinell.Material("600 GPa", 0.2))
    contact = reference.CoatedContact(1e-4, steel, load=0.05, lower_layers=[coat])
    grid = SurfaceGrid(63, 63, contact.contact_radius / 24, contact.contact_radius / 24)
    cells = ElasticContact(grid, steel, lower_layers=[coat]).solve((grid.x**2 + grid.y**2) / 2e-4, load=0.05)
    assert cells.approach == pytest.approx(contact.approach, rel=1e-3)
    middle = contact.pressure(np.hypot(grid.x, grid.y))[31]
    assert cells.pressure[31, 10:54] == pytest.approx(middle[10:54], abs=0.01 * middle.max())
    for given in ({"approach": contact.approach}, {"contact_radius": contact.contact_radius}):
        assert reference.CoatedContact(1e-4, steel, lower_layers=[coat], **given).load == pytest.approx(0.05, rel=1e-11)
    hertz = reference.point_contact(1e-4, reference.contact_modulus(steel), load=0.05)
    assert reference.CoatedContact(1e-4, steel, load=0.05).approach == pytest.approx(hertz.approach, rel=1e-12)
    assert contact.approach < hertz.approach
    assert contact.stiffness > 0.0


def test_coated_contact_refuses() -> None:
    steel = brinell.Material("210 GPa", 0.3)
    with pytest.raises(brinell.InputError, match="one of load, approach and contact_radius"):
        reference.CoatedContact(1e-4, steel, load=1.0, approach=1e-6)
    with pytest.raises(brinell.InputError, match="load = -1"):
        reference.CoatedContact(1e-4, steel, load=-1.0)
    with pytest.raises(brinell.InputError, match="thickness / contact_radius"):
        reference.CoatedContact(1e-4, steel, load=1.0, lower_layers=[Layer(1e-9, brinell.Material("100 GPa", 0.3))])
    with pytest.raises(brinell.InputError, match="r is negative"):
        reference.CoatedContact(1e-4, steel, load=1.0).pressure([-1e-6])
