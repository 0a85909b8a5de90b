# SPDX-License-Identifier: BSD-3-Clause
"""Runs without a folder, for loops of small ones."""

from __future__ import annotations

import pickle
import tempfile
from pathlib import Path

import numpy as np
import pytest

import brinell
from brinell.results import Run


@pytest.fixture(scope="module")
def both(real_folder: Path) -> tuple[Run, Run]:
    """The same run in a folder and in memory."""
    run = brinell.open(real_folder)
    return run, brinell.Case(run.case_text).run(in_memory=True)


def test_a_run_in_memory_has_all_that_one_in_a_folder_has(both: tuple[Run, Run]) -> None:
    disk, memory = both
    assert list(memory.history) == list(disk.history)
    for name, column in disk.history.items():
        np.testing.assert_array_equal(memory.history[name], column)
        assert memory.history[name].dtype == column.dtype
    assert memory.summary is not None
    assert disk.summary is not None
    same = {key: value for key, value in disk.summary.items() if key != "run"}
    assert {key: value for key, value in memory.summary.items() if key != "run"} == same
    assert memory.case_text == disk.case_text
    assert memory.sources == disk.sources
    assert memory.steps == disk.steps
    assert memory.complete
    for body in ("lower", "upper"):
        assert sorted(memory.field_names(body)) == sorted(disk.field_names(body))  # type: ignore[arg-type]
        for name in memory.field_names(body):  # type: ignore[arg-type]
            of_memory, of_disk = (run.field(body, name) for run in (memory, disk))  # type: ignore[arg-type]
            np.testing.assert_array_equal(of_memory.values, of_disk.values)
            assert (of_memory.dims, of_memory.units) == (of_disk.dims, of_disk.units)
    final, other = memory.snapshot("final"), disk.snapshot("final")
    np.testing.assert_array_equal(final.lower.stress["xz"], other.lower.stress["xz"])
    assert "in memory" in repr(memory)


def test_nothing_is_written(real_case: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr(tempfile, "tempdir", str(tmp_path))
    run = brinell.Case(real_case).run(in_memory=True)
    assert brinell.plot.section(run, run.snapshot("final"), field="stress_xx")
    assert list(tmp_path.iterdir()) == []


def test_a_run_in_memory_can_be_sent_to_another_process(both: tuple[Run, Run]) -> None:
    memory = both[1]
    again = pickle.loads(pickle.dumps(memory))
    np.testing.assert_array_equal(again.history["F_X"], memory.history["F_X"])
    stress = memory.snapshot("final").lower.stress["xx"]
    np.testing.assert_array_equal(again.snapshot("final").lower.stress["xx"], stress)
    np.testing.assert_array_equal(pickle.loads(pickle.dumps(memory.snapshot("final"))).lower.stress["xx"], stress)


def test_a_run_in_memory_has_no_folder(real_case: str, tmp_path: Path) -> None:
    case = brinell.Case(real_case)
    for wrong in ({"output": tmp_path}, {"resume": True}, {"accuracy": 0.1}):
        with pytest.raises(
            brinell.InputError,
            match="cannot stand together with (a folder|resume|accuracy);",
        ):
            case.run(in_memory=True, **wrong)  # type: ignore[arg-type]
    with pytest.raises(brinell.InputError, match="a series of runs, which needs a folder"):
        case.with_values({"solver.accuracy": 0.1}).run(in_memory=True)
    with pytest.raises(brinell.InputError, match="threads = 0"):
        case.run(in_memory=True, threads=0)


def test_a_run_in_memory_is_watched_and_stopped(real_case: str) -> None:
    steps = []

    def watch(step: int, *_: object) -> None:
        steps.append(step)
        if step == 5:
            raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt, match="nothing is kept of a run in memory"):
        brinell.Case(real_case).run(in_memory=True, progress=watch)
    assert steps == [0, 1, 2, 3, 4, 5]
