# SPDX-License-Identifier: BSD-3-Clause
# ruff: noqa: E402 (the extra is asked for first)
"""Axes, designs, and one run of a sweep."""

from collections.abc import Sequence
from concurrent.futures import Future
from pathlib import Path

import numpy as np
import pytest

from brinell import Case, InputError

for extra in ("pandas", "pyarrow", "scipy"):
    pytest.importorskip(extra)

from brinell.sweeps import Choices, Range
from brinell.sweeps.axes import axis_of
from brinell.sweeps.designs import points_of
from brinell.sweeps.folder import flattened
from brinell.sweeps.ledger import Ledger
from brinell.sweeps.lists import with_whole_lists
from brinell.sweeps.loop import compute_all, lost_reason
from brinell.sweeps.point import Outcome, Task, compute, finished_summary
from brinell.sweeps.pools import Lost
from sweep_case import CASE


@pytest.mark.parametrize(
    ("text", "values"),
    [
        ("1:15:15", list(range(1, 16))),
        ("1:2:3", [1.0, 1.5, 2.0]),
        ("0.1:0.3:3", [0.1, 0.2, 0.3]),
        ("3:3:1", [3]),
        ("200GPa:220 GPa:3", ["200 GPa", "210 GPa", "220 GPa"]),
        ("1e-3 mm:2e-3 mm:2", ["0.001 mm", "0.002 mm"]),
        ("log:1:100:3", [1, 10, 100]),
        ("log:1 um:2 um:3", ["1.0 um", "1.41421356237 um", "2.0 um"]),
        ("1,2.5, 4", [1, 2.5, 4]),
        ("200 GPa,210 GPa", ["200 GPa", "210 GPa"]),
        ("exact,paper", ["exact", "paper"]),
        ("true,false", [True, False]),
        ("[1, 2],[3, 4]", [[1, 2], [3, 4]]),
        ('"a, b",c', ["a, b", "c"]),
        ("maps/a:b.csv", ["maps/a:b.csv"]),
    ],
)
def test_axis_text(text: str, values: list[object]) -> None:
    axis = axis_of(text)
    assert axis.values() == values
    assert [type(value) for value in axis.values()] == [type(value) for value in values]


def test_axes_from_python() -> None:
    assert axis_of(np.linspace(1.0, 2.0, 3)) == Choices((1.0, 1.5, 2.0))
    assert axis_of(["200 GPa", Path("a.csv")]) == Choices(("200 GPa", "a.csv"))
    assert axis_of(Range(1, 3, 3)).values() == [1, 2, 3]


@pytest.mark.parametrize(
    ("given", "what"),
    [
        ("1 GPa:2 MPa:3", "'GPa' and 'MPa'"),
        ("200:220GPa:3", "'' and 'GPa'"),
        ("1:2:many", "'many'"),
        ("1:2:0", "count of 0"),
        ("log:0:1:3", "both ends > 0"),
        ("log:1,2,3", "log:START:STOP:COUNT"),
        ("", "no values"),
        (7, "neither a list"),
    ],
)
def test_bad_axes(given: object, what: str) -> None:
    with pytest.raises(InputError, match=what):
        axis_of(given)


def test_grid_has_all_combinations_the_last_axis_fastest() -> None:
    axes = {"a": axis_of("1:3:3"), "b": axis_of("x,y")}
    assert [tuple(point.values()) for point in points_of(axes, "grid")] == [
        (a, b) for a in (1, 2, 3) for b in ("x", "y")
    ]


def test_list_walks_in_step() -> None:
    points = points_of({"a": axis_of("1:3:3"), "b": axis_of("x,y,z")}, "list")
    assert points == [{"a": 1, "b": "x"}, {"a": 2, "b": "y"}, {"a": 3, "b": "z"}]
    with pytest.raises(InputError, match="a has 3, b has 2"):
        points_of({"a": axis_of("1:3:3"), "b": axis_of("x,y")}, "list")


def test_latin_hypercube_covers_each_axis_evenly() -> None:
    axes = {"a": axis_of("0:10"), "b": axis_of("log:1 mm:1000 mm"), "c": axis_of("x,y")}
    points = points_of(axes, "latin_hypercube", samples=10, seed=3)
    assert sorted(int(point["a"]) for point in points) == list(range(10))  # one in each tenth
    decades = [np.log10(float(point["b"].removesuffix(" mm"))) for point in points]
    assert sorted(int(decade / 0.3) for decade in decades) == list(range(10))
    assert sorted(point["c"] for point in points) == ["x"] * 5 + ["y"] * 5
    assert points == points_of(axes, "latin_hypercube", samples=10, seed=3)
    assert points != points_of(axes, "latin_hypercube", samples=10, seed=4)


def test_designs_refuse_what_does_not_suit_them() -> None:
    with pytest.raises(InputError, match="a: the range 0:1 needs a count"):
        points_of({"a": axis_of("0:1")}, "grid")
    with pytest.raises(InputError, match="has no count"):
        points_of({"a": axis_of("0:1:3")}, "latin_hypercube", samples=3)
    with pytest.raises(InputError, match="needs 1 or more"):
        points_of({"a": axis_of("0:1")}, "latin_hypercube")
    with pytest.raises(InputError, match="goes with latin_hypercube"):
        points_of({"a": axis_of("0:1:3")}, "grid", samples=3)
    with pytest.raises(InputError, match="at least one axis"):
        points_of({}, "grid")


def test_entries_of_lists() -> None:
    table = {"indentation": {"load": [10.0, 0.0, 20.0], "steps": 3}}
    point = {"indentation.load": "5 N", "indentation.load.2": 7, "indentation.steps": 4}
    assert with_whole_lists(point, table) == {"indentation.load": ["5 N", 0.0, 7], "indentation.steps": 4}
    assert with_whole_lists({"indentation.load": [1, 2]}, table) == {"indentation.load": [1, 2]}
    assert with_whole_lists({"indentation.approach": 3}, table) == {"indentation.approach": [3]}
    assert with_whole_lists({"grid.spacing": [1, 2, 3]}, table) == {"grid.spacing": [1, 2, 3]}
    for key in ("indentation.load.3", "indentation.approach.1"):
        with pytest.raises(InputError, match="entries in the case; allowed"):
            with_whole_lists({key: 1}, table)


def test_summary_in_one_row() -> None:
    summary = {"energy": {"net_J": 1.0}, "indents": [{"hardness_Pa": 2.0}], "profile": {"depth_m": [0.0, 1.0]}}
    assert flattened(summary) == {"energy.net_J": 1.0, "indents.0.hardness_Pa": 2.0}


def test_a_run_that_was_stopped_goes_on_from_its_checkpoint(tmp_path: Path) -> None:
    case = Case(CASE)
    task = Task(0, case.to_toml(), str(tmp_path / "run"), 1)
    asked = 0

    def after_three() -> bool:
        nonlocal asked
        asked += 1
        return asked > 3

    assert compute(task, after_three).status == "stopped"
    assert finished_summary(task.folder, task.text) is None
    asked = -100
    outcome = compute(task, after_three)
    steps = outcome.summary["run"]["steps"]
    assert outcome.status == "done"
    assert asked + 100 == 1 + steps - 3  # once at the start, then after each step that was left
    asked = -100
    assert compute(task, after_three).summary == outcome.summary
    assert asked + 100 == 1  # taken as it is

    other = Task(0, case.with_values({"tugging.interference": 3}).to_toml(), task.folder, 1)
    assert finished_summary(other.folder, other.text) is None
    assert compute(other, lambda: False).summary["normalised"]["interference"] == pytest.approx(3)


def test_an_error_is_told_as_text(tmp_path: Path) -> None:
    case = Case(CASE, overrides=["solver.max_evaluations=1", "tugging.interference=4"])
    outcome = compute(Task(0, case.to_toml(), str(tmp_path / "run"), 1), lambda: False)
    assert outcome.status == "failed"
    assert "no convergence" in outcome.reason
    assert "ConvergenceError" in outcome.traceback
    assert outcome.wall_time > 0


class _LosingPool:
    """Loses the first run every time, the others never."""

    threads = 1
    has_room = True

    def __init__(self) -> None:
        self.submitted: list[int] = []

    def chunks(self, tasks: Sequence[Task]) -> list[list[Task]]:
        return [[task] for task in tasks]

    def submit(self, chunk: Sequence[Task]) -> Future[list[Outcome]]:
        self.submitted += [task.index for task in chunk]
        future: Future[list[Outcome]] = Future()
        future.set_result([Outcome(task.index, "failed", reason="as it must") for task in chunk])
        return future

    def collect(self, future: Future[list[Outcome]]) -> list[Outcome]:
        if future.result()[0].index == 0:
            raise Lost
        return future.result()

    def losses(self) -> list[str]:
        return []

    def stop(self) -> None:
        raise AssertionError("nobody asked to stop")

    def close(self) -> None:
        pass


def test_a_run_that_is_lost_again_and_again_has_failed(tmp_path: Path) -> None:
    text = Case(CASE).to_toml()
    ledger = Ledger(tmp_path, [{}, {}], [text, text])
    pool = _LosingPool()
    tasks = [Task(i, text, str(tmp_path / str(i)), 1) for i in (0, 1)]
    compute_all(tasks, pool, ledger, print)
    assert sorted(pool.submitted) == [0, 0, 0, 1]
    assert ledger.table()["reason"].tolist() == [lost_reason(3), "as it must"]
