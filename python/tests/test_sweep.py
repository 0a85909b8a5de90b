# SPDX-License-Identifier: BSD-3-Clause
# ruff: noqa: E402 (the extra is asked for first)
"""Sweeps from end to end: table, resuming, failures, Ctrl-C, killed workers, a Dask cluster."""

import contextlib
import json
import multiprocessing
import os
import signal
import subprocess
import sys
import threading
from collections.abc import Callable, Iterator
from concurrent.futures import Future
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import brinell
from brinell import Case, InputError, IoError
from brinell.cli import main

pd = pytest.importorskip("pandas")
pytest.importorskip("pyarrow")
pytest.importorskip("scipy")

from brinell.sweeps import open_sweep
from brinell.sweeps.folder import locked, run_folder
from brinell.sweeps.point import Outcome
from brinell.sweeps.pools import LocalPool, Lost
from sweep_case import CASE, LONG, is_under_way, wait_for

INDENTATION = """scenario = "indentation"
[lower]
shape = {type = "flat"}
material = {young_modulus = "210 GPa", poisson_ratio = 0.3, hardening = {law = "perfect", yield_stress = "900 MPa"}}
[upper]
shape = {type = "sphere", radius = "5 mm"}
material = {rigid = true}
[indentation]
load = ["50 N", 0]
steps = 3
[grid]
resolution = 3
"""
OVER = {"tugging.interference": [1, 2], "lower.material.young_modulus": ["200 GPa", "210 GPa"]}


@pytest.fixture
def case_file(tmp_path: Path) -> Path:
    path = tmp_path / "case.toml"
    path.write_text(CASE)
    return path


def sweep(output: Path, over: dict[str, Any] = OVER, **options: Any) -> brinell.sweeps.Sweep:
    return brinell.sweep(Case(CASE), over, output=output, **{"workers": 1, "progress": False, **options})


def written(output: Path) -> dict[Path, int]:
    """When each file of the runs was written."""
    return {path: path.stat().st_mtime_ns for path in sorted((output / "runs").rglob("*")) if path.is_file()}


def test_table_equals_single_runs(tmp_path: Path) -> None:
    result = sweep(tmp_path / "sweep", workers=2)
    assert result.table["status"].tolist() == ["done"] * 4
    assert result.table["tugging.interference"].tolist() == [1.0, 1.0, 2.0, 2.0]
    assert result.table["lower.material.young_modulus"].tolist() == [200e9, 210e9, 200e9, 210e9]
    single = Case(CASE, overrides=["tugging.interference=2", "lower.material.young_modulus=210 GPa"]).run(threads=1)
    assert single.summary is not None
    row = result.table.iloc[3]
    assert row["energy.net_J"] == single.summary["energy"]["net_J"]
    assert row["forces.peak_F_X_N"] == single.summary["forces"]["peak_F_X_N"]
    np.testing.assert_array_equal(result.runs[3].history["F_X"], single.history["F_X"])
    assert len(result.failures) == 0

    text = pd.read_csv(tmp_path / "sweep" / "table.csv")
    assert text["energy.net_J"].tolist() == result.table["energy.net_J"].tolist()
    pd.testing.assert_frame_equal(open_sweep(tmp_path / "sweep").table, result.table)
    record = json.loads((tmp_path / "sweep" / "sweep.json").read_text())
    assert record["axes"]["tugging.interference"] == {"values": [1, 2]}
    assert record["versions"]["brinell"] == brinell.__version__


def test_warnings_of_the_runs_are_told(tmp_path: Path) -> None:
    over = {"grid.resolution": [2.0, 7.0], "tugging.interference": [0.5]}
    with pytest.warns(brinell.ResolutionWarning, match=r"of 2 runs have warnings: .*coarse_contact \(1\)"):
        result = sweep(tmp_path, over, workers=1)
    assert result.warnings["coarse_contact"] == [0]
    of_first = {key for key, runs in result.warnings.items() if 0 in runs}
    assert {warning.key for warning in result.runs[0].warnings} == of_first


def test_the_same_sweep_computes_only_what_is_missing(tmp_path: Path) -> None:
    first = sweep(tmp_path)
    before = written(tmp_path)
    lost = run_folder(tmp_path, 2)
    for path in lost.rglob("*"):
        path.unlink()
    again = sweep(tmp_path)
    after = written(tmp_path)
    assert after.keys() == before.keys()
    assert {path.parent for path in after if after[path] != before[path]} == {lost}
    results = [name for name in first.table if not name.endswith("wall_time_s")]
    pd.testing.assert_frame_equal(again.table[results], first.table[results])


def test_another_sweep_in_the_folder_is_refused(tmp_path: Path) -> None:
    over = {"tugging.interference": "1:2:2"}
    sweep(tmp_path, over)
    before = written(tmp_path)
    with pytest.raises(InputError, match=r"the axis tugging\.interference was 1:2:2, is 1:3:2"):
        sweep(tmp_path, {"tugging.interference": "1:3:2"})
    with pytest.raises(InputError, match="design was grid, is list"):
        sweep(tmp_path, over, design="list")
    with pytest.raises(InputError, match=r"upper\.shape\.radius of the case was 1e-05, is 2e-05"):
        brinell.sweep(Case(CASE, overrides=["upper.shape.radius=2e-5"]), over, output=tmp_path, progress=False)
    with pytest.raises(InputError, match="resume"):
        sweep(tmp_path, over, resume=False)
    with locked(tmp_path), pytest.raises(IoError, match="another sweep is working there"):
        sweep(tmp_path, over)
    assert written(tmp_path) == before


def test_a_failed_run_is_kept_with_its_reason(tmp_path: Path) -> None:
    # The first one stays elastic, the second cannot converge in one iteration.
    over = {"tugging.interference": [0.5, 4], "solver.max_evaluations": [1]}
    result = sweep(tmp_path, over)
    assert result.table["status"].tolist() == ["done", "failed"]
    assert result.failures["index"].tolist() == [1]
    assert "no convergence" in result.failures["reason"].item()
    assert list(result.runs) == [0]
    assert "ConvergenceError" in json.loads((tmp_path / "failures.json").read_text())["1"]["traceback"]

    before = written(tmp_path)
    assert "no convergence" in sweep(tmp_path, over).failures["reason"].item()
    assert written(tmp_path) == before
    sweep(tmp_path, over, retry_failed=True)
    assert {path.parent for path, time in written(tmp_path).items() if time != before.get(path)} == {
        run_folder(tmp_path, 1)
    }


def test_failed_runs_are_retried_with_another_solver(tmp_path: Path) -> None:
    over = {"tugging.interference": [0.5, 4]}

    def again(evaluations: int, resolution: int = 3, **options: bool) -> brinell.sweeps.Sweep:
        base = Case(CASE, overrides=[f"solver.max_evaluations={evaluations}", f"grid.resolution={resolution}"])
        return brinell.sweep(base, over, output=tmp_path, workers=1, progress=False, **options)

    assert again(1).table["status"].tolist() == ["done", "failed"]
    with pytest.raises(InputError, match=r"max_evaluations of the case was 1, is 60.*") as refused:
        again(60)
    assert "retry_failed" in str(refused.value)
    before = written(tmp_path)
    result = again(60, 4, retry_failed=True)
    assert result.table["status"].tolist() == ["done", "done"]
    assert result.table["solver.max_evaluations"].tolist() == [1, 60]
    assert result.table["grid.resolution"].tolist() == [3, 4]
    changed = {path.parent for path, time in written(tmp_path).items() if time != before.get(path)}
    assert changed == {run_folder(tmp_path, 1)}
    # The first command again: nothing is computed, and the table stays.
    before = written(tmp_path)
    pd.testing.assert_frame_equal(again(1).table, result.table)
    assert written(tmp_path) == before
    with pytest.raises(InputError, match=r"upper\.shape\.radius of the case"):
        brinell.sweep(
            Case(CASE, overrides=["upper.shape.radius=2e-5"]), over, output=tmp_path, progress=False, retry_failed=True
        )


def test_all_cases_are_checked_before_the_first_run(tmp_path: Path) -> None:
    with pytest.raises(InputError, match=r"run 1 \(lower\.shape\.radius = 3 GPa\)"):
        sweep(tmp_path / "sweep", {"lower.shape.radius": ["1 um", "3 GPa"]})
    with pytest.raises(InputError, match=r"tugging\.interferense: the range"):
        sweep(tmp_path / "sweep", {"tugging.interferense": "1:2:0"})
    assert not (tmp_path / "sweep").exists()


def exit_code(*arguments: object) -> int:
    """Of the command in this process."""
    handlers = {number: signal.getsignal(number) for number in (signal.SIGTERM, signal.SIGHUP)}
    try:
        with pytest.raises(SystemExit) as end:
            main(["sweep", *map(str, arguments)])
        return int(end.value.code or 0)
    finally:
        for number, handler in handlers.items():
            signal.signal(number, handler)


def test_command(case_file: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    output = tmp_path / "sweep"
    over = ["--over", "tugging.interference=0.5:4:2", "--set", "solver.max_evaluations=1"]
    assert exit_code(case_file, *over, "-o", output, "--workers", 1, "--quiet") == 1
    printed = capsys.readouterr()
    assert printed.out == ""
    assert "brinell: warning: 1 of 1 runs have warnings: coarse_contact (1)" in printed.err
    assert "\nbrinell: run 1: pass 1" in printed.err
    assert pd.read_csv(output / "table.csv")["status"].tolist() == ["done", "failed"]

    over = ["--over", "tugging.interference=1:2", "--design", "latin-hypercube", "--samples", "2"]
    assert exit_code(case_file, *over, "-o", tmp_path / "drawn", "--workers", 1) == 0
    assert capsys.readouterr().out == f"2 runs, 0 failed: {tmp_path / 'drawn' / 'table.csv'}\n"


@pytest.mark.parametrize(
    ("over", "what"),
    [
        ("tugging.interferense=1:3:3", "unknown key tugging.interferense"),
        ("tugging.interference", "allowed: KEY=VALUES"),
        ("tugging.interference=1:3", "needs a count"),
        ("tugging.interference=10:xx:3", "allowed: START:STOP:COUNT with both ends included, as in 10:50:3"),
        ("grid.resolution=2,0", "out of range"),
    ],
)
def test_command_with_a_bad_axis(
    case_file: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str], over: str, what: str
) -> None:
    assert exit_code(case_file, "--over", over, "-o", tmp_path / "sweep") == 2
    errors = capsys.readouterr().err
    assert errors.startswith("brinell: error: ")
    assert what in errors
    assert not (tmp_path / "sweep").exists()


def test_without_the_extra_the_error_tells_what_to_install(
    case_file: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    for module in [name for name in sys.modules if name == "brinell.sweeps" or name == "pyarrow"]:
        monkeypatch.delitem(sys.modules, module)
    monkeypatch.setitem(sys.modules, "pyarrow", None)
    assert exit_code(case_file, "--over", "tugging.interference=1,2", "-o", tmp_path / "sweep") == 2
    error = capsys.readouterr().err
    assert error == 'brinell: error: a sweep needs pyarrow, which is not installed: pip install "brinell[sweep]"\n'


def test_a_sweep_over_the_loads_of_an_indentation(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    case = tmp_path / "case.toml"
    case.write_text(INDENTATION)
    over = ["--over", "indentation.load=100 N:200 N:3", "--workers", "1"]
    assert exit_code(case, *over, "-o", tmp_path / "sweep") == 0
    table = open_sweep(tmp_path / "sweep").table
    assert table["indentation.load"].tolist() == [100.0, 150.0, 200.0]
    assert table["indents.0.max_load_N"].tolist() == pytest.approx([100.0, 150.0, 200.0])
    assert (table["indents.0.final_approach_m"] > 0).all()  # the second entry, 0, has stayed: the contact opens
    assert exit_code(case, "--over", "indentation.load.2=1,2", "-o", tmp_path / "other") == 2
    assert "indentation.load has 2 entries in the case" in capsys.readouterr().err


@contextlib.contextmanager
def command_process(case_file: Path, output: Path) -> Iterator[subprocess.Popen[str]]:
    """The command in a process group of its own; four runs, of which the last takes so long that it does not end."""
    over = ["--over", "tugging.interference=2,2.5,3,3.5", "--over", "tugging.passes=4,4,4,400", "--design", "list"]
    arguments = [*over, "-o", str(output), "--workers", "2", "--threads", "1"]
    for override in LONG:
        arguments += ["--set", override]
    process = subprocess.Popen(
        [sys.executable, "-m", "brinell", "sweep", str(case_file), *arguments, "--quiet"],
        stderr=subprocess.PIPE,
        text=True,
        start_new_session=True,
    )
    try:
        yield process
    finally:
        with contextlib.suppress(ProcessLookupError):
            os.killpg(process.pid, signal.SIGKILL)
        process.communicate()


def group_is_gone(process: subprocess.Popen[str]) -> bool:
    """Whether all processes that it has started have ended, too."""
    for status in Path("/proc").glob("[0-9]*/stat"):
        with contextlib.suppress(OSError):  # ended meanwhile
            state, _, group = status.read_text().rpartition(")")[2].split()[:3]
            if int(group) == process.pid and state != "Z":
                return False
    return True


@pytest.mark.parametrize("whole_group", [True, False], ids=["terminal", "main process"])
def test_ctrl_c(case_file: Path, tmp_path: Path, whole_group: bool) -> None:
    output = tmp_path / "sweep"
    with command_process(case_file, output) as process:
        wait_for(lambda: (output / "table.csv").exists(), "the first run")
        wait_for(lambda: any(is_under_way(run_folder(output, i)) for i in range(4)), "another run")
        send = os.killpg if whole_group else os.kill
        send(process.pid, signal.SIGINT)
        _, errors = process.communicate(timeout=30)
        assert process.returncode == 130, errors
        assert errors.splitlines() == [
            f"brinell: interrupted; what is done is in {output / 'table.csv'}, and the same command goes on"
        ]
        wait_for(lambda: group_is_gone(process), "the workers to end", timeout=10)
    table = pd.read_csv(output / "table.csv")
    assert 1 <= len(table) < 4
    assert set(table["status"]) == {"done"}


def test_workers_do_not_outlive_a_killed_sweep(case_file: Path, tmp_path: Path) -> None:
    output = tmp_path / "sweep"
    with command_process(case_file, output) as process:
        wait_for(lambda: any(is_under_way(run_folder(output, i)) for i in range(4)), "a run")
        process.kill()
        process.wait()
        wait_for(lambda: group_is_gone(process), "the workers to end")
    assert not (run_folder(output, 3) / "summary.json").exists()


def killed_in_the_midst(output: Path, pids: Callable[[], list[int]]) -> threading.Thread:
    """A thread that kills a worker by SIGKILL as soon as some run is under way."""

    def kill() -> None:
        wait_for(lambda: any(is_under_way(run_folder(output, i)) for i in range(3)), "a run")
        os.kill(pids()[0], signal.SIGKILL)

    thread = threading.Thread(target=kill)
    thread.start()
    return thread


def assert_complete(result: brinell.sweeps.Sweep) -> None:
    assert result.table["status"].tolist() == ["done"] * 3
    single = Case(CASE, overrides=[*LONG, "tugging.interference=2"]).run(threads=1)
    np.testing.assert_array_equal(result.runs[0].history["F_X"], single.history["F_X"])


def test_a_killed_process_loses_nothing(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    lost = []
    collect = LocalPool.collect

    def counting(self: LocalPool, future: Future[Outcome]) -> Outcome:
        try:
            return collect(self, future)
        except Lost:
            lost.append(future)
            raise

    monkeypatch.setattr(LocalPool, "collect", counting)

    def computing() -> list[int]:
        return [child.pid for child in multiprocessing.active_children() if child.pid is not None]

    thread = killed_in_the_midst(tmp_path, computing)
    case = Case(CASE, overrides=LONG)
    result = brinell.sweep(
        case, {"tugging.interference": [2, 2.5, 3]}, output=tmp_path, workers=1, threads=1, progress=True
    )
    thread.join()
    assert len(lost) == 1
    assert_complete(result)
    assert "a process came to a sudden end; its run is computed again" in capsys.readouterr().err


@pytest.fixture(scope="module")
def cluster() -> Iterator[Any]:
    distributed = pytest.importorskip("distributed")
    with distributed.LocalCluster(
        n_workers=2, threads_per_worker=1, processes=True, dashboard_address=None
    ) as local_cluster:
        yield local_cluster


def test_a_killed_dask_worker_loses_nothing(cluster: Any, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    with cluster.get_client() as client:
        pids = client.run(os.getpid)

        def computing() -> list[int]:
            return [pids[worker] for worker, tasks in client.processing().items() if tasks]

        thread = killed_in_the_midst(tmp_path, computing)
        over = {"tugging.interference": [2, 2.5, 3]}
        case = Case(CASE, overrides=LONG)
        result = brinell.sweep(case, over, output=tmp_path, cluster=cluster.scheduler_address, progress=True)
        thread.join()
        assert set(client.run(os.getpid).values()) != set(pids.values())
    assert_complete(result)
    assert "has left; its run goes to another one" in capsys.readouterr().err
    assert not (tmp_path / "stop").exists()


def test_ctrl_c_stops_the_runs_of_a_cluster(cluster: Any, tmp_path: Path) -> None:
    def interrupt() -> None:
        wait_for(lambda: any(is_under_way(run_folder(tmp_path, i)) for i in range(3)), "a run")
        os.kill(os.getpid(), signal.SIGINT)

    case, over = Case(CASE, overrides=LONG), {"tugging.interference": [2, 2.5, 3], "tugging.passes": [4, 4, 30]}
    options: dict[str, Any] = {"output": tmp_path, "design": "list", "cluster": cluster, "progress": False}
    thread = threading.Thread(target=interrupt)
    thread.start()
    with pytest.raises(KeyboardInterrupt, match=r"[012] of 3 runs are done, .* in .*: the same call goes on"):
        brinell.sweep(case, over, **options)
    thread.join()
    with cluster.get_client() as client:
        assert not any(client.processing().values())
    assert not (tmp_path / "stop").exists()
    assert not (run_folder(tmp_path, 2) / "summary.json").exists()  # many times as long as the others
    assert_complete(brinell.sweep(case, over, **options))
