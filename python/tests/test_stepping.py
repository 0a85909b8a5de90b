# SPDX-License-Identifier: BSD-3-Clause
"""Runs that Python steps: the same numbers as a whole run, and fields that belong to them."""

from __future__ import annotations

import numpy as np
import pytest

import brinell
from brinell import Case, ConvergenceError, InputError
from brinell.scenarios import SCENARIOS
from template_cases import template_case

STEEL = brinell.Material("210 GPa", 0.3, brinell.Perfect("1 GPa"))
BALL = brinell.Body(brinell.Sphere("1 mm"), STEEL)
RIGID_BALL = brinell.Body(brinell.Sphere("1 mm"), brinell.RIGID)


def indentation() -> Case:
    flat = brinell.Body(brinell.Flat(), STEEL)
    return brinell.Indentation(flat, RIGID_BALL, load=["2 N", 0], steps=4, grid={"resolution": 5})


@pytest.fixture(params=SCENARIOS, scope="module")
def case(request: pytest.FixtureRequest) -> Case:
    return template_case(request.param)


def test_steps_are_those_of_a_whole_run(case: Case) -> None:
    steps = case.steps()
    records = list(steps)
    run = case.run()
    for name, column in run.history.items():
        np.testing.assert_array_equal([record[name] for record in records], column, name)  # NaN is NaN
    assert steps.is_done
    assert steps.summary()["energy"] == run.summary["energy"]


def test_fields_belong_to_the_record(case: Case) -> None:
    steps = case.steps()
    for record in steps:
        fields = steps.fields()
        area = (fields["x"][1] - fields["x"][0]) * (fields["y"][1] - fields["y"][0])
        assert fields["pressure"].sum() * area == pytest.approx(record["F_n"], rel=1e-12)
        assert fields["pressure"].shape == (fields["y"].size, fields["x"].size)
        lower = fields["lower"]
        assert lower["stress"].shape == (6, lower["z"].size, lower["y"].size, lower["x"].size)
        assert lower["equivalent_plastic_strain"].max() <= record["max_equivalent_plastic_strain"]
    assert lower["equivalent_plastic_strain"].max() > 0
    assert np.trace(lower["plastic_strain"][[0, 1, 2]].sum(axis=0).sum(axis=0)) == pytest.approx(0, abs=1e-12)


def test_the_loop_may_be_left_and_taken_up(case: Case) -> None:
    steps = case.steps()
    first = next(steps)
    assert first["step"] == 0
    assert not steps.is_done
    assert "1 of about" in repr(steps)
    assert next(iter(steps))["step"] == 1


def test_a_step_that_fails_is_told_and_ends_the_run() -> None:
    steps = brinell.Tugging(
        BALL, BALL, 6, grid={"resolution": 6}, solver={"yield_tolerance": 1e-15, "max_evaluations": 2}
    ).steps()
    with pytest.raises(ConvergenceError):
        list(steps)
    with pytest.raises(InputError, match="has ended with an error"):
        next(steps)


def test_a_grid_that_does_not_fit_is_refused() -> None:
    with pytest.raises(InputError, match="grid.resolution = 1000"):
        indentation().with_values({"grid.resolution": 1000}).steps()


def test_it_is_part_of_the_package() -> None:
    assert isinstance(indentation().steps(), brinell.Stepping)
