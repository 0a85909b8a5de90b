# SPDX-License-Identifier: BSD-3-Clause
"""Return mapping of points: uniaxial curves, the yield condition, order of the integration, back stresses."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

import brinell
from brinell._toml import tomllib
from brinell.constitutive import hardening_modulus, plastic_work, return_mapping, softening_factor, yield_stress
from brinell.materials import (
    Hardening,
    JohnsonCook,
    Linear,
    LinearSoftening,
    Ludwik,
    Material,
    Perfect,
    Softening,
    SofteningTable,
    Swift,
    Table,
    Voce,
)

E, NU = 2e11, 0.3
MU = E / (2 * (1 + NU))
LAWS = [
    Perfect(6e8),
    Linear(6e8, 2e9),
    Swift(1.2e9, 4e-3, 0.1),
    Ludwik(6e8, 5e8, 0.5),
    Voce(6e8, 2e8, 40),
    Table([0, 0.01], [6e8, 7e8]),
]
ROUNDING = 1e-11  # of the root of the yield condition, found to 1e-13 of the yield stress


def von_mises(s: NDArray[np.float64]) -> NDArray[np.float64]:
    d = s - np.array([1, 1, 1, 0, 0, 0]).reshape(6, *[1] * (s.ndim - 1)) * s[:3].mean(axis=0)
    return np.sqrt(1.5 * np.einsum("c,c...,c...", [1, 1, 1, 2, 2, 2], d, d))


def random_stress(seed: int, shape: tuple[int, ...] = (4, 5)) -> NDArray[np.float64]:
    return np.random.default_rng(seed).normal(scale=1.5e9, size=(6, *shape))


@pytest.mark.parametrize("law", LAWS)
def test_slope_and_work_belong_to_the_yield_curve(law: Hardening) -> None:
    e = np.linspace(1e-3, 0.009, 9)
    h = 1e-6
    difference = (yield_stress(law, e + h) - yield_stress(law, e - h)) / (2 * h)
    # Rounding of the difference, 1e-16 6e8 / 1e-6 Pa, and its own error, of the order (h/e)^2.
    np.testing.assert_allclose(hardening_modulus(law, e), difference, rtol=1e-5, atol=1e3)
    difference = (plastic_work(law, e + h) - plastic_work(law, e - h)) / (2 * h)
    np.testing.assert_allclose(yield_stress(law, e), difference, rtol=1e-6)


@pytest.mark.parametrize("law", LAWS)
@pytest.mark.parametrize("integration", ["backward_euler", "path"])
def test_tension_follows_the_yield_curve(law: Hardening, integration: brinell.constitutive.Integration) -> None:
    """Uniaxial stress: with the plastic strain e along x, sigma = sigma_y(e), however large the increment."""
    de = np.array([1e-5, 1e-3, 0.02])
    sigma = yield_stress(law, de)
    flow = np.array([1, -0.5, -0.5, 0, 0, 0])[:, None]
    after = sigma * np.array([1, 0, 0, 0, 0, 0])[:, None]
    increment = return_mapping(Material(E, NU, law), after + 2 * MU * de * flow, integration=integration)
    np.testing.assert_allclose(increment.equivalent_plastic_strain, de, rtol=1e-6)  # 1e-11 S_y/(3 mu 1e-5)
    np.testing.assert_allclose(increment.plastic_strain, de * flow, rtol=1e-6, atol=1e-14)
    np.testing.assert_allclose(increment.stress, after, rtol=1e-9, atol=1e-9 * 6e8)


@pytest.mark.parametrize("law", LAWS)
def test_radial_return_ends_on_the_yield_surface(law: Hardening) -> None:
    trial, e = random_stress(1), np.full((4, 5), 2e-3)
    result = return_mapping(Material(E, NU, law), trial, equivalent_plastic_strain=e)
    de = result.equivalent_plastic_strain
    flows = de > 0
    assert flows.any()
    np.testing.assert_array_equal(flows, von_mises(trial) > yield_stress(law, e))
    np.testing.assert_allclose(von_mises(result.stress)[flows], yield_stress(law, e + de)[flows], rtol=ROUNDING)
    np.testing.assert_allclose(von_mises(trial) - 3 * MU * de, von_mises(result.stress), rtol=ROUNDING)
    np.testing.assert_allclose(result.stress, trial - 2 * MU * result.plastic_strain, atol=1.0)
    np.testing.assert_allclose(result.plastic_strain[:3].sum(axis=0), 0, atol=1e-16)
    np.testing.assert_allclose(
        result.dissipation, plastic_work(law, e + de) - plastic_work(law, e), atol=1e-9 * result.dissipation.max()
    )


def test_a_point_within_the_yield_surface_stays_elastic() -> None:
    trial = np.array([4e8, 0, 0, 0, 0, 0])
    result = return_mapping(Material(E, NU, Perfect(6e8)), trial)
    np.testing.assert_allclose(result.stress, trial, atol=1e-7)  # rounding
    assert result.equivalent_plastic_strain == 0.0
    assert result.dissipation == 0.0


@pytest.mark.parametrize(("integration", "order"), [("backward_euler", 1), ("path", 2)])
@pytest.mark.parametrize("kinematic", [[], [(2e10, 50.0)]])
def test_order_of_the_integration_on_a_path_that_turns(
    integration: brinell.constitutive.Integration, order: int, kinematic: list[tuple[float, float]]
) -> None:
    """Strain goes from tension to shear: the error of the stress falls with the step as it should."""
    material = Material(E, NU, Linear(6e8, 2e9), back_stresses=kinematic)
    total = 0.02

    def end(steps: int, integration: brinell.constitutive.Integration = integration) -> NDArray[np.float64]:
        stress = np.array([4e8, -2e8, -2e8, 0, 0, 0])
        e, back = 0.0, np.zeros((len(kinematic), 6))
        for i in range(steps):
            turn = 0.5 * np.pi * np.array([i, i + 1]) / steps
            c, s = np.diff(np.sin(turn))[0], -np.diff(np.cos(turn))[0]
            strain = total * np.array([c, -0.5 * c, -0.5 * c, 0, 0, s])
            result = return_mapping(
                material,
                stress + 2 * MU * strain,
                stress=stress,
                equivalent_plastic_strain=e,
                backstress=back,
                integration=integration,
            )
            stress, back = result.stress, result.backstress
            e += float(result.equivalent_plastic_strain)
        return stress

    exact = end(2048, "path")  # 64 times as exact as the finest below
    errors = [np.linalg.norm(end(steps) - exact) for steps in (64, 128, 256)]
    found = np.log2(np.array(errors[:-1]) / errors[1:])
    print(f"{integration}, {len(kinematic)} back stresses: orders {found}")
    np.testing.assert_allclose(found, order, atol=0.2)


def test_back_stresses_of_proportional_flow() -> None:
    """C/gamma (1 - exp(-gamma e)) in tension for each term (Armstrong, Frederick 1966), C e if gamma = 0."""
    material = Material(E, NU, Perfect(6e8), back_stresses=[(2e10, 100.0), (5e9, 0.0)])
    trial = np.array([1, -0.5, -0.5, 0, 0, 0])[:, None] * np.array([1e9, 3e9])
    result = return_mapping(material, trial)
    e = result.equivalent_plastic_strain
    expected = [2e10 / 100 * -np.expm1(-100 * e), 5e9 * e]
    np.testing.assert_allclose(von_mises(np.moveaxis(result.backstress, 0, 1)), expected, rtol=1e-12)
    np.testing.assert_allclose(von_mises(result.stress), 6e8 + sum(expected), rtol=ROUNDING)


def test_shapes_go_through() -> None:
    material = Material(E, NU, Linear(6e8, 2e9), back_stresses=[(1e9, 0)])
    trial = random_stress(2, (3, 2, 4))
    result = return_mapping(material, trial)
    assert result.plastic_strain.shape == (6, 3, 2, 4)
    assert result.backstress.shape == (1, 6, 3, 2, 4)
    one = return_mapping(material, trial[:, 1, 0, 3])
    assert one.equivalent_plastic_strain.shape == ()
    np.testing.assert_array_equal(one.stress, result.stress[:, 1, 0, 3])


def test_what_does_not_fit_is_an_input_error() -> None:
    material = Material(E, NU, Perfect(6e8))
    with pytest.raises(brinell.InputError, match=r"trial has the shape \(5, 2\); it must be \(6, 2\)"):
        return_mapping(material, np.zeros((5, 2)))
    with pytest.raises(brinell.InputError, match=r"equivalent_plastic_strain has the shape \(3,\); it must be \(2,\)"):
        return_mapping(material, np.zeros((6, 2)), equivalent_plastic_strain=np.zeros(3))
    with pytest.raises(brinell.InputError, match="backstress has the shape"):
        return_mapping(material, np.zeros((6, 2)), backstress=np.zeros((1, 6, 2)))
    with pytest.raises(brinell.InputError, match="allowed: not below 0"):
        yield_stress(Perfect(6e8), [-1e-3])
    with pytest.raises(brinell.InputError, match="it does not yield"):
        return_mapping(Material(E, NU), np.zeros(6))
    with pytest.raises(brinell.InputError, match='allowed: "path" or "backward_euler"'):
        return_mapping(material, np.zeros(6), integration="euler")  # type: ignore[arg-type]


@pytest.mark.parametrize(
    ("law", "formula"),
    [
        (JohnsonCook(1520, 1.03, 25), lambda t: 1 - np.clip((t - 25) / 1495, 0, 1) ** 1.03),
        (LinearSoftening("1500 degC"), lambda t: 1 - np.clip((t - 20) / 1480, 0, 1)),
        (LinearSoftening("1773.15 K", "293.15 K"), lambda t: 1 - np.clip((t - 20) / 1480, 0, 1)),
        (SofteningTable([20, "300 degC", 600], [1, 0.9, 0.4]), lambda t: np.interp(t, [20, 300, 600], [1, 0.9, 0.4])),
    ],
)
def test_softening_by_temperature(law: Softening, formula: Callable[[Any], Any]) -> None:
    t = np.linspace(-100, 2000, 43)
    np.testing.assert_allclose(softening_factor(law, t), np.maximum(formula(t), 0.01), rtol=1e-12)


def test_a_yield_factor_is_another_yield_stress() -> None:
    rng = np.random.default_rng(4)
    trial = 1e9 * rng.standard_normal((6, 50))
    factor = rng.uniform(0.2, 1.0, 50)
    steel = brinell.Material("210 GPa", 0.3, brinell.Voce(6e8, 2e8, 40))
    softened = return_mapping(steel, trial, yield_factor=factor)
    for i in range(50):
        soft = brinell.Material("210 GPa", 0.3, brinell.Voce(6e8 * factor[i], 2e8 * factor[i], 40))
        alone = return_mapping(soft, trial[:, i])
        np.testing.assert_allclose(softened.plastic_strain[:, i], alone.plastic_strain, rtol=1e-10, atol=1e-16)
        np.testing.assert_allclose(softened.dissipation[i], alone.dissipation, rtol=1e-10)
    with pytest.raises(brinell.InputError, match="yield_factor has the value 0; allowed: above 0"):
        return_mapping(steel, trial, yield_factor=0.0)
    with pytest.raises(brinell.InputError, match=r"yield_factor has the shape \(3,\)"):
        return_mapping(steel, trial, yield_factor=np.ones(3))


@pytest.mark.parametrize(
    ("law", "message"),
    [
        (LinearSoftening(10), r"melting_temperature = 10 degC is not above reference_temperature = 20 degC"),
        (JohnsonCook(1500, 0.0), r"^material.softening.exponent = 0.0 is out of range"),
        (
            LinearSoftening(-300),
            r"^material.softening.melting_temperature = -300 is out of range; allowed: temperature",
        ),
        (SofteningTable([20, 20], [1, 0.5]), "must ascend"),
        (SofteningTable([20, 30], [1]), "2 temperatures and 1 factors"),
    ],
)
def test_softening_is_checked_as_in_a_case_file(law: Softening, message: str) -> None:
    with pytest.raises(brinell.InputError, match=message):
        softening_factor(law, 20.0)


def test_softening_needs_a_law_and_stands_in_the_case() -> None:
    with pytest.raises(brinell.InputError, match=r"softening = 0.5; allowed: a law, as brinell.JohnsonCook"):
        brinell.Material(2e11, 0.3, softening=0.5)  # type: ignore[arg-type]
    steel = brinell.Material(2e11, 0.3, brinell.Perfect("1 GPa"), softening=JohnsonCook(1500, 1.0))
    ball = brinell.Sphere("1 mm")
    with pytest.warns(brinell.CaseWarning, match="lower.material.softening has no effect: no heat is computed"):
        case = brinell.Indentation(brinell.Body(ball, steel), brinell.Body(ball, brinell.RIGID), load=["1 N"], steps=1)
    table = tomllib.loads(case.to_toml())["lower"]["material"]["softening"]
    assert table == {
        "law": "johnson_cook",
        "reference_temperature": 20.0,
        "melting_temperature": 1500.0,
        "exponent": 1.0,
    }
