# SPDX-License-Identifier: BSD-3-Clause
"""Cases from Python: the same as from files, the same errors, runs that are watched, stopped and resumed."""

from __future__ import annotations

import copy
import gc
import os
import pickle
import signal
import tempfile
import threading
import time
import warnings
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import brinell
from brinell._toml import tomllib

CASES = Path(__file__).parents[2] / "cases"
COARSE = ["tugging.interference=2", "grid.resolution=4", "output.snapshots='aligned'"]


@pytest.fixture
def case() -> brinell.Case:
    return brinell.Case.from_file(CASES / "tugging" / "case.toml", COARSE)


def test_a_run_gives_its_results_and_takes_its_temporary_folder_along(case: brinell.Case) -> None:
    run = case.run()
    folder = run.path
    assert run.complete
    assert run.scenario == "tugging"
    assert np.max(run.history["F_X"]) > 0.0
    assert run.snapshot("aligned").lower.equivalent_plastic_strain.max() > 0.0
    del run
    gc.collect()
    assert not folder.exists()


def test_a_folder_of_ones_own_stays(case: brinell.Case, tmp_path: Path) -> None:
    run = case.run(tmp_path / "mine")
    again = brinell.open(tmp_path / "mine")
    np.testing.assert_array_equal(again.history["work"], run.history["work"])


def test_the_same_case_as_text_has_the_same_results(case: brinell.Case) -> None:
    again = brinell.Case(case.to_toml(), file="again.toml")
    assert again.to_toml() == case.to_toml()
    np.testing.assert_array_equal(again.run().history["F_X"], case.run().history["F_X"])


def test_a_case_of_nested_values_is_that_of_its_text(case: brinell.Case) -> None:
    again = brinell.Case.from_values(tomllib.loads(case.to_toml()))
    assert again.to_toml() == case.to_toml()


def test_values_can_be_replaced(case: brinell.Case) -> None:
    other = case.with_values({"tugging.interference": np.float64(3.0), "lower.material.young_modulus": "190 GPa"})
    values = tomllib.loads(other.to_toml())
    assert values["tugging"]["interference"] == 3.0
    assert values["lower"]["material"]["young_modulus"] == 190e9
    assert tomllib.loads(case.to_toml())["tugging"]["interference"] == 2.0
    assert case.with_values(["tugging.interference=3"]).to_toml() != case.to_toml()


@pytest.mark.parametrize(
    ("values", "message"),
    [
        ({"tugging.interference": -1}, "tugging.interference = -1 is out of range; allowed: number > 0"),
        ({"tugging.interferense": 1}, "did you mean tugging.interference?"),
        ({"lower.material.young_modulus": "200 GP"}, "unknown unit"),
        ({"lower.material.young_modulus": "200 mm"}, "length"),
    ],
)
def test_errors_name_key_value_and_what_is_allowed(case: brinell.Case, values: dict[str, object], message: str) -> None:
    with pytest.raises(brinell.InputError) as error:
        case.with_values(values)
    assert message in str(error.value)
    assert "--set" not in str(error.value)  # the key is named, and no option was given
    overrides = [f"{key}={value}" for key, value in values.items()]
    with pytest.raises(brinell.InputError, match="^--set ") as error:
        case.with_values(overrides)
    assert message in str(error.value)
    assert isinstance(error.value, ValueError)


def test_a_file_that_is_not_there_is_an_error(tmp_path: Path) -> None:
    with pytest.raises(brinell.InputError, match="nothing.toml: cannot be opened"):
        brinell.Case.from_file(tmp_path / "nothing.toml")


def test_a_grid_beyond_all_memory_is_refused_before_anything_is_written(case: brinell.Case, tmp_path: Path) -> None:
    huge = case.with_values({"grid.resolution": 400})
    for call in (huge.check, lambda: huge.run(tmp_path / "huge")):
        with pytest.raises(brinell.InputError, match="grid.resolution"):
            call()
    assert not (tmp_path / "huge").exists()


def test_no_convergence_is_an_error_and_keeps_the_finished_steps(case: brinell.Case, tmp_path: Path) -> None:
    hopeless = case.with_values({"solver.yield_tolerance": 1e-15, "solver.max_evaluations": 2})
    with pytest.raises(brinell.ConvergenceError, match="All earlier steps are kept"):
        hopeless.run(tmp_path)
    assert (tmp_path / "history.csv").read_text(encoding="utf-8").count("\n") > 1
    assert not (tmp_path / "summary.json").exists()


def test_a_folder_that_cannot_be_written_is_an_error(case: brinell.Case, tmp_path: Path) -> None:
    (tmp_path / "file").touch()
    with pytest.raises(brinell.IoError) as error:
        case.run(tmp_path / "file" / "results")
    assert isinstance(error.value, OSError)


def test_warnings_are_pythons() -> None:
    text = (CASES / "tugging" / "case.toml").read_text(encoding="utf-8")
    with pytest.warns(brinell.CaseWarning, match="radius"):
        brinell.Case(text, overrides=["tugging.interference=2000"])


def test_progress_is_told_of_each_step(case: brinell.Case) -> None:
    told: list[tuple[int, int, str, int]] = []
    run = case.run(progress=lambda *step: told.append(step))
    assert [step for step, *_ in told] == list(range(run.history.steps))
    assert [evaluations for *_, evaluations in told] == run.history["evaluations"].tolist()


def test_a_bar_is_shown(case: brinell.Case, capsys: pytest.CaptureFixture[str]) -> None:
    case.run(progress=True)
    assert "100%" in capsys.readouterr().err


def test_a_bar_is_shown_of_a_run_in_memory_and_without_asking_in_a_terminal(
    case: brinell.Case, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    case.run(in_memory=True, progress=True)
    assert "100%" in capsys.readouterr().err
    case.run(in_memory=True)
    monkeypatch.setattr("brinell.case._someone_looks", lambda: True)
    case.run(in_memory=True)  # over before anybody waits
    assert capsys.readouterr().err == ""
    monkeypatch.setattr("brinell.case._PATIENCE", 1e-9)
    for options in ({"in_memory": True}, {}):
        case.run(**options)
        assert "100%" in capsys.readouterr().err
    case.run(in_memory=True, progress=False)
    assert capsys.readouterr().err == ""


def test_an_earlier_result_is_replaced_as_told(case: brinell.Case, tmp_path: Path) -> None:
    folder = tmp_path / "run"
    with warnings.catch_warnings():
        warnings.simplefilter("error", brinell.ReplacementWarning)
        case.run(folder, replace=False)
        before = (folder / "summary.json").stat().st_mtime_ns
        case.run(folder, replace=True)
    assert (folder / "summary.json").stat().st_mtime_ns > before
    kept = {path: path.stat().st_mtime_ns for path in folder.iterdir() if path.is_file()}
    with pytest.raises(brinell.InputError, match="run: holds an earlier result, which is to be kept; allowed: another"):
        case.run(folder, replace=False)
    with pytest.raises(brinell.InputError, match="holds an earlier result"):
        case.run(folder, replace=False, accuracy=0.2)
    assert {path: path.stat().st_mtime_ns for path in folder.iterdir() if path.is_file()} == kept
    with pytest.warns(brinell.ReplacementWarning, match=r"the earlier result in .*run is replaced; replace = ") as told:
        case.run(folder)
    assert told[0].filename == __file__


def test_a_stopped_run_is_an_earlier_result_too(case: brinell.Case, tmp_path: Path) -> None:
    with pytest.raises(KeyboardInterrupt):
        case.run(tmp_path / "run", progress=interrupted_after(2))
    with pytest.raises(brinell.InputError, match="holds an earlier result"):
        case.run(tmp_path / "run", replace=False)
    assert case.run(tmp_path / "run", resume=True).complete


@pytest.mark.parametrize("arguments", [{"replace": True}, {"replace": False, "in_memory": True}])
def test_replacing_goes_with_a_folder(case: brinell.Case, arguments: dict[str, Any]) -> None:
    with pytest.raises(brinell.InputError, match=r"run\(replace=.* has no effect without a folder; allowed"):
        case.run(**arguments)


def test_replacing_does_not_go_with_resuming(case: brinell.Case, tmp_path: Path) -> None:
    with pytest.raises(brinell.InputError, match="has no effect together with resume"):
        case.run(tmp_path / "run", replace=True, resume=True)


def test_what_progress_raises_ends_the_run_and_it_can_go_on(case: brinell.Case, tmp_path: Path) -> None:
    whole = case.run(tmp_path / "whole")

    def stop(step: int, *_: object) -> None:
        if step == 5:
            raise LookupError("enough")

    with pytest.raises(LookupError, match="enough"):
        case.run(tmp_path / "part", progress=stop)
    part = brinell.open(tmp_path / "part", allow_unfinished=True)
    assert part.history.steps == 6
    resumed = case.run(tmp_path / "part", resume=True)
    np.testing.assert_array_equal(resumed.history["F_X"], whole.history["F_X"])


def test_ctrl_c_in_the_midst_of_a_long_step_ends_within_seconds(tmp_path: Path) -> None:
    """A step of many seconds ends between two evaluations; the signal comes while it is being prepared or computed."""
    long = brinell.Case.from_file(
        CASES / "indentation-sphere" / "case.toml", ["grid.resolution=32", "indentation.steps=1", "grid.extent=1.5"]
    )
    threading.Timer(0.5, os.kill, (os.getpid(), signal.SIGINT)).start()
    start = time.monotonic()
    with pytest.raises(KeyboardInterrupt, match=r"^interrupted; (nothing has been finished$|the first step is kept)"):
        long.run(tmp_path)
    assert time.monotonic() - start < 60.0
    assert not (tmp_path / "summary.json").exists()
    stepping = long.steps()
    threading.Timer(0.5, os.kill, (os.getpid(), signal.SIGINT)).start()
    with pytest.raises(KeyboardInterrupt, match=r"interrupted in step 0: nothing is written"):
        next(stepping)


def interrupted_after(step_of_interruption: int) -> Callable[..., None]:
    def watch(step: int, *_: object) -> None:
        if step == step_of_interruption:
            raise KeyboardInterrupt

    return watch


def test_ctrl_c_says_what_is_kept(case: brinell.Case, tmp_path: Path) -> None:
    with pytest.raises(KeyboardInterrupt, match=r"the first 4 steps are kept in .*: the same call with resume"):
        case.run(tmp_path / "run", progress=interrupted_after(3))
    assert brinell.open(tmp_path / "run", allow_unfinished=True).history.steps == 4
    assert case.run(tmp_path / "run", resume=True).complete


def test_ctrl_c_leaves_a_temporary_folder_that_holds_something(
    case: brinell.Case, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(tempfile, "tempdir", str(tmp_path))
    with pytest.raises(KeyboardInterrupt, match=r"the first 3 steps are kept in ") as raised:
        case.run(progress=interrupted_after(2))
    (folder,) = tmp_path.iterdir()
    assert str(folder) in str(raised.value)
    assert case.run(folder, resume=True).complete
    with pytest.raises(LookupError):
        case.run(progress=lambda *_: {}["no step"])
    assert list(tmp_path.iterdir()) == [folder]


def test_ctrl_c_in_a_series_for_an_accuracy_says_where_its_runs_are(case: brinell.Case, tmp_path: Path) -> None:
    with pytest.raises(KeyboardInterrupt, match=r"the runs for the accuracy so far are kept in .*run: the same call"):
        case.run(tmp_path / "run", accuracy=0.2, progress=interrupted_after(3))


def test_other_threads_go_on_meanwhile(case: brinell.Case) -> None:
    ticks = 0
    done = threading.Event()

    def count() -> None:
        nonlocal ticks
        while not done.wait(0.005):
            ticks += 1

    thread = threading.Thread(target=count)
    thread.start()
    start = time.monotonic()
    case.with_values({"grid.resolution": 8}).run()
    seconds = time.monotonic() - start
    done.set()
    thread.join()
    assert ticks > 0.1 * seconds / 0.005


def test_threads_are_those_asked_for_and_only_for_this_run(case: brinell.Case) -> None:
    run = case.run(threads=1)
    assert run.summary is not None
    assert run.summary["run"]["threads"] == 1
    again = case.run()
    assert again.summary is not None
    assert again.summary["run"]["threads"] == int(os.environ.get("OMP_NUM_THREADS", len(os.sched_getaffinity(0))))


def test_a_device_computes_the_bodies(case: brinell.Case) -> None:
    case = case.with_values({"solver.windows": False})
    here, there = case.run(device="host"), case.run()
    assert here.summary is not None
    assert there.summary is not None
    assert here.history["dissipation_lower"][-1] > 0.0
    for column, values in there.history.items():
        if np.issubdtype(np.asarray(values).dtype, np.floating) and column != "F_Y":  # a sum of rounding errors
            largest = np.max(np.abs(values))
            np.testing.assert_allclose(here.history[column], values, rtol=0.0, atol=1e-10 * largest, err_msg=column)
    with pytest.raises(brinell.InputError, match='solver.device = "gpu" is not known; allowed: "cpu"'):
        case.run(device="gpu")


def test_a_gpu_is_no_part_of_this_build(case: brinell.Case, tmp_path: Path) -> None:
    with pytest.raises(brinell.InputError, match=r"solver\.device = cuda, and .* built without CUDA"):
        case.run(tmp_path / "out", device="cuda")
    assert not (tmp_path / "out").exists()


def test_several_runs_at_once_in_one_process(case: brinell.Case) -> None:
    all_steps = case.with_values({"output.snapshots": "all"})
    alone = all_steps.run(threads=1).history["F_X"]
    with ThreadPoolExecutor(4) as pool:
        runs = list(pool.map(lambda _: all_steps.run(threads=1), range(4)))
    for run in runs:
        np.testing.assert_array_equal(run.history["F_X"], alone)
        assert run.snapshot("aligned").lower.equivalent_plastic_strain.max() > 0.0


def test_a_case_can_be_copied_and_sent_to_another_process(case: brinell.Case) -> None:
    other = case.with_values({"tugging.passes": 2})
    for again in (copy.deepcopy(other), pickle.loads(pickle.dumps(other))):
        assert type(again) is type(other)
        assert again.to_toml() == other.to_toml()


def test_parts_of_bodies_are_values(case: brinell.Case) -> None:
    other = case.with_values({"lower.material.hardening": brinell.Voce("600 MPa", "200 MPa", 12.0)})
    assert tomllib.loads(other.to_toml())["lower"]["material"]["hardening"]["saturation"] == 200e6
    with pytest.raises(brinell.InputError, match="is no value of a case"):
        case.with_values({"tugging.interference": object()})


def test_one_override_may_stand_alone(case: brinell.Case) -> None:
    assert tomllib.loads(case.with_values("tugging.passes=3").to_toml())["tugging"]["passes"] == 3
    one = brinell.Case.from_file(CASES / "tugging" / "case.toml", "tugging.passes=3")
    assert tomllib.loads(one.to_toml())["tugging"]["passes"] == 3


@pytest.mark.parametrize("threads", [0, -1, "2", 1.5])
def test_threads_are_a_whole_number(case: brinell.Case, threads: Any) -> None:
    with pytest.raises(brinell.InputError, match="threads"):
        case.run(threads=threads)


def test_a_warning_points_to_the_code_of_the_user() -> None:
    text = (CASES / "tugging" / "case.toml").read_text(encoding="utf-8")
    for make in (
        lambda: brinell.Case(text, overrides=["tugging.interference=2000"]),
        lambda: brinell.Case.from_file(CASES / "tugging" / "case.toml", ["tugging.interference=2000"]),
    ):
        with pytest.warns(brinell.CaseWarning) as told:
            make()
        assert {Path(one.filename).name for one in told} == {Path(__file__).name}


def test_plain_numbers_that_look_like_megapascal_and_millimetres_are_asked_for() -> None:
    steel = brinell.Material(210000, 0.3, brinell.Linear(600, 2000))
    ball = brinell.Body(brinell.Sphere(10), brinell.materials.RIGID)
    with pytest.warns(brinell.CaseWarning) as told:
        brinell.Indentation(brinell.Body(brinell.Flat(), steel), ball, load=[1000, 0])
    texts = "\n".join(str(one.message) for one in told)
    for part in (
        "young_modulus = 210000",
        "yield_stress = 600",
        "modulus = 2000",
        '"210000 MPa"',
        "radius = 10",
        '"10 mm"',
    ):
        assert part in texts
    with warnings.catch_warnings():
        warnings.simplefilter("error", brinell.CaseWarning)
        steel = brinell.Material("210 GPa", 0.3, brinell.Linear("600 MPa", "2 GPa"))
        brinell.Indentation(
            brinell.Body(brinell.Flat(), steel), brinell.Body(brinell.Sphere("10 mm"), ball.material), load=["10 N", 0]
        )
