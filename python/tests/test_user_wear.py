# SPDX-License-Identifier: BSD-3-Clause
"""Friction and wear in increments of two bodies, by a law of the list and by a function."""

from __future__ import annotations

import gc
import weakref
from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

import brinell
from brinell.elastoplastic import CoupledContact, WearLaw
from brinell.halfspace import SurfaceGrid, VolumeGrid

ELASTIC = brinell.Material("210 GPa", 0.3)
GRID = SurfaceGrid(15, 15, 4e-6, 4e-6)
BODY = VolumeGrid(GRID, nz=4, dz=4e-6)
BALL = (GRID.x**2 + GRID.y**2) / (2 * 1e-3)
LOAD, SLID, SO_LITTLE = 1.0, 1e-6, (2e-18, 1e-18)  # N, m, 1/Pa


def worn(law: WearLaw, **more: Any) -> CoupledContact:
    """A ball that has slid on a flat, with so little wear that the pressure stays as it was."""
    pair = CoupledContact(GRID, BODY, BODY, ELASTIC, brinell.RIGID, scale=1e-7, wear=SO_LITTLE, wear_law=law, **more)
    pair.advance(BALL, load=LOAD)
    assert pair.lower.worn_volume == 0
    pair.advance(BALL, load=LOAD, slid=SLID)
    return pair


def area(field: Any) -> float:
    """Integral of a field over the surface."""
    return float(np.sum(field)) * GRID.dx * GRID.dy


# The coefficients make the gap change by 1e-6 of what the contact leaves unsolved.
CLOSE = 1e-6


def test_the_laws_of_the_list() -> None:
    pair = worn("archard")
    assert pair.lower.worn_volume == pytest.approx(SO_LITTLE[0] * LOAD * SLID, rel=CLOSE)
    assert pair.upper.worn_volume == pytest.approx(SO_LITTLE[1] * LOAD * SLID, rel=CLOSE)
    assert area(pair.lower.worn_depth) == pytest.approx(pair.lower.worn_volume)
    assert not pair.shear.any()
    pair = worn("energy", friction=0.3)
    np.testing.assert_allclose(pair.shear, 0.3 * pair.pressure)
    assert pair.lower.worn_volume == pytest.approx(SO_LITTLE[0] * 0.3 * LOAD * SLID, rel=CLOSE)


@pytest.mark.parametrize("friction", [0.0, 0.3])
def test_a_function_of_pressure_and_shear(friction: float) -> None:
    pair = worn(lambda p, q: p**2 / 1e9 + 3 * q, friction=friction)
    intensity = pair.pressure**2 / 1e9 + 3 * friction * pair.pressure
    np.testing.assert_allclose(pair.lower.worn_depth, SO_LITTLE[0] * SLID * intensity, rtol=CLOSE)
    np.testing.assert_allclose(pair.upper.worn_depth, pair.lower.worn_depth / 2, rtol=CLOSE)


def test_the_sign_of_the_way_is_the_direction() -> None:
    pair = worn("archard", friction=0.2)
    towards, volume = pair.shear, pair.lower.worn_volume
    pair.advance(BALL, load=LOAD, slid=-SLID)
    # A rigid ball on a compressible flat: under shear the pressure leans to one side, under its opposite to the other.
    np.testing.assert_allclose(pair.shear, -towards[:, ::-1], atol=CLOSE * towards.max())
    assert pair.lower.worn_volume == pytest.approx(2 * volume, rel=CLOSE)
    pair.advance(BALL, load=LOAD)
    assert not pair.shear.any()


def raises() -> float:
    raise ZeroDivisionError


@pytest.mark.parametrize(
    ("answer", "error"),
    [
        (raises, ZeroDivisionError),
        (lambda: None, TypeError),
        (lambda: -1.0, brinell.InputError),
        (lambda: float("nan"), brinell.InputError),
    ],
)
def test_a_law_that_fails_leaves_the_state_as_it_was(answer: Callable[[], Any], error: type[Exception]) -> None:
    fails = False
    pair = CoupledContact(
        *(GRID, BODY, BODY, ELASTIC, brinell.RIGID),
        scale=1e-7,
        wear=(1e-13, 0),
        wear_law=lambda p, _q: answer() if fails else p,
    )
    pair.advance(BALL, load=LOAD)
    before, fails = pair.pressure, True
    with pytest.raises(error):
        pair.advance(BALL, load=LOAD, slid=SLID)
    np.testing.assert_array_equal(pair.pressure, before)
    fails = False
    pair.advance(BALL, load=LOAD, slid=SLID)
    assert pair.lower.worn_volume > 0


@pytest.mark.parametrize(
    ("more", "message"),
    [
        ({"friction": -0.1}, "friction = -0.1; allowed: >= 0"),
        ({"wear": (1e-15, float("inf"))}, r"wear\[1\] = inf; allowed: >= 0"),
        ({"wear_law": "holm"}, "wear_law = 'holm'; allowed: \"archard\""),
        ({"wear_law": 3}, "wear_law = 3; allowed"),
        ({"wear": (1e-15, 0), "wear_law": "energy"}, "friction = 0: no friction work"),
        ({"wear": (1e-15, 0), "wear_law": lambda p, _q: -p}, "intensity -1 Pa at the pressure 1 Pa"),
        ({"friction": 0.1, "twin": "alike"}, "friction: the shear acts on the bodies in opposite directions"),
        ({"wear": (1e-15, 0), "twin": "mirror_image"}, "twins wear alike"),
    ],
)
def test_a_contact_refuses(more: dict[str, Any], message: str) -> None:
    with pytest.raises(brinell.InputError, match=message):
        CoupledContact(GRID, BODY, BODY, ELASTIC, ELASTIC, scale=1e-7, **more)


def test_a_way_is_finite() -> None:
    pair = CoupledContact(GRID, BODY, BODY, ELASTIC, brinell.RIGID, scale=1e-7)
    with pytest.raises(brinell.InputError, match="slid = nan"):
        pair.advance(BALL, load=LOAD, slid=float("nan"))


def held_by_its_own_law() -> weakref.ref[CoupledContact]:
    """A contact in a cycle with its law, as of a law that is defined beside it in a module."""
    names: dict[str, Any] = {}

    def law(pressure: float, _shear: float) -> float:
        return pressure if names else 0

    names["pair"] = CoupledContact(GRID, BODY, BODY, ELASTIC, brinell.RIGID, scale=1e-7, wear=SO_LITTLE, wear_law=law)
    gc.collect()
    return weakref.ref(names["pair"])


def test_a_contact_that_its_own_law_holds_is_let_go() -> None:
    reference = held_by_its_own_law()
    gc.collect()
    assert reference() is None
