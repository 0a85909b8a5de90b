# SPDX-License-Identifier: BSD-3-Clause
"""What every scenario must have in Python, also one that is new: run with few cells from the file of `brinell new`."""

from __future__ import annotations

from collections.abc import Callable
from typing import get_args

import pytest

import brinell
from brinell import _core
from brinell.plot import history, states
from brinell.report.numbers import key_numbers
from brinell.results import Run
from brinell.results.columns import COLUMN_UNITS, scenario_of
from brinell.scenarios import SCENARIOS, Scenario
from template_cases import template_case

Runs = Callable[[Scenario], Run]
every_scenario = pytest.mark.parametrize("scenario", SCENARIOS)


@pytest.fixture(scope="module")
def run_of(tmp_path_factory: pytest.TempPathFactory) -> Runs:
    found: dict[Scenario, Run] = {}

    def run(scenario: Scenario) -> Run:
        if scenario not in found:
            found[scenario] = template_case(scenario).run(tmp_path_factory.mktemp(scenario))
        return found[scenario]

    return run


def test_their_names_are_those_of_the_engine() -> None:
    (choices,) = (key.choices for key in _core.schema_keys() if key.key == "scenario")
    assert list(SCENARIOS) == list(get_args(Scenario)) == choices
    assert all(name == traits.name for name, traits in SCENARIOS.items())


@every_scenario
def test_each_is_a_class_with_the_keys_of_its_table(scenario: Scenario) -> None:
    keys = {entry.key.split(".")[1] for entry in _core.schema_keys() if entry.key.startswith(f"{scenario}.")}
    kind = getattr(brinell, scenario.capitalize())
    assert issubclass(kind, brinell.Case)
    assert keys
    assert keys <= kind.__init__.__annotations__.keys()


@every_scenario
def test_columns_tell_the_scenario(scenario: Scenario) -> None:
    assert scenario_of(COLUMN_UNITS[scenario]) == scenario
    traits = SCENARIOS[scenario]
    assert {traits.motion, traits.abscissa} - {None} <= COLUMN_UNITS[scenario].keys()


@every_scenario
@pytest.mark.filterwarnings("ignore::brinell.ResolutionWarning")
def test_all_figures_are_drawn(scenario: Scenario, run_of: Runs) -> None:
    run = run_of(scenario)
    names = [named.name for named in brinell.plot.standard_figures(run)]
    drawings = SCENARIOS[scenario].drawings
    own = {name for name, one in drawings().figures.items() if one.caption} if drawings is not None else set()
    assert {"loaded-pressure", "residual-surfaces", "history", "energy-balance"} <= set(names)
    assert not own or own & set(names)
    assert len(history.run_history(run).axes) == 6
    assert states.state_title(run, run.snapshot("aligned")).startswith("step ")


@every_scenario
@pytest.mark.filterwarnings("ignore::brinell.ResolutionWarning")
def test_key_numbers_also_of_a_run_that_has_not_finished(scenario: Scenario, run_of: Runs) -> None:
    run = run_of(scenario)
    stopped = Run(run.path, run.history, None)
    whole, part = ([number.name for number in key_numbers(one)] for one in (run, stopped))
    assert set(part) <= set(whole)
    assert len(set(whole)) == len(whole) > 4
