# SPDX-License-Identifier: BSD-3-Clause
"""Runs whose increments do not converge in one piece: they are split, and end where runs end that need not be."""

from __future__ import annotations

import pytest

import brinell

STEEL = brinell.Material("200 GPa", 0.3, brinell.Linear(yield_stress="600 MPa", modulus="2 GPa"))


def split_increments(run: brinell.Run) -> int:
    assert run.summary is not None
    return int(run.summary["run"]["split_increments"])


def numbers(run: brinell.Run) -> dict[str, float]:
    """What a user looks at: the largest force, and what is left at the end."""
    last = ("dissipation_lower", "max_residual_lower", "max_equivalent_plastic_strain")
    return {"F_n": float(run.history["F_n"].max())} | {name: float(run.history[name][-1]) for name in last}


def test_a_press_with_few_iterations_is_halved_and_agrees() -> None:
    """Shorter pieces are what a user would take: the difference is the error of four steps, of second order."""
    press = brinell.Indentation(
        lower=brinell.Body(brinell.Flat(), STEEL),
        upper=brinell.Body(brinell.Sphere("100 um"), brinell.Material("300 GPa", 0.25)),
        approach=[8, 0],
        normalised=True,
        steps=4,
        grid={"resolution": 4},
    )
    whole = press.run()
    split = press.with_values({"solver.max_evaluations": 10}).run()
    assert split_increments(whole) == 0
    assert split_increments(split) > 0
    assert "split_increments" in [warning.key for warning in split.warnings]
    assert len(split.history["F_n"]) == len(whole.history["F_n"])
    assert numbers(split) == pytest.approx(numbers(whole), rel=0.02)


def test_a_slide_that_only_the_plain_iteration_solves_is_that_of_backward_euler() -> None:
    """The plain iteration takes pieces of half a cell, by backward Euler: a run of such steps ends the same, to the
    tolerance of 1e-4 of the yield stress in each of its 24 steps."""
    ball = brinell.Body(brinell.Sphere("100 um"), STEEL)
    slide = brinell.Tugging(ball, ball, interference=4, grid={"resolution": 4})
    split = slide.with_values({"solver.max_evaluations": 3}).run()
    assert split_increments(split) > 0
    assert split.summary is not None
    half_a_cell = 0.5 * split.summary["grid"]["spacing_m"][0]
    plain = slide.with_values({"solver.integration": "backward_euler", "tugging.shift": half_a_cell}).run()
    assert split_increments(plain) == 0
    assert numbers(split) == pytest.approx(numbers(plain), rel=5e-4)
    # Of first order, where steps that need no splitting are of second.
    assert numbers(split) == pytest.approx(numbers(slide.run()), rel=0.1)
