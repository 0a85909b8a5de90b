# SPDX-License-Identifier: BSD-3-Clause
# ruff: noqa: E402 (the extra is asked for first)
"""Sweeps by a real Slurm on this machine: tables, failures, cancelled tasks, a killed process on the login node."""

import json
import shutil
import signal
import subprocess
import sys
import threading
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest

import brinell
from brinell import Case, InputError, IoError

pd = pytest.importorskip("pandas")
parquet = pytest.importorskip("pyarrow.parquet")
pytest.importorskip("scipy")

from brinell.sweeps import Site, Slurm, open_sweep
from brinell.sweeps.arrays import arrays_of
from brinell.sweeps.journal import JournalReader, journal_folder
from slurm_here import LARGEST_ARRAY, reason_to_skip, slurm_here
from sweep_case import CASE, LONG, wait_for

pytestmark = [
    pytest.mark.skipif(bool(reason_to_skip()), reason=reason_to_skip() or "Slurm is here"),
    pytest.mark.filterwarnings("ignore::brinell.ResolutionWarning"),
]

CRASH = """
import os, signal
from pathlib import Path

def check(run):
    value = run.summary["case"]["tugging"]["interference"]
    if value in (1.5, 3.0) and Path(__file__).with_name("crash").exists():
        os.kill(os.getpid(), signal.SIGKILL)
    return {"own": 2 * value}
"""
OVER = {"tugging.interference": [1, 1.5, 2, 2.5, 3]}


@pytest.fixture(scope="module", autouse=True)
def slurm(tmp_path_factory: pytest.TempPathFactory) -> Iterator[None]:
    try:
        with slurm_here(tmp_path_factory.mktemp("slurm")):
            yield
    except RuntimeError as error:
        pytest.skip(str(error))


def sweep(output: Path, over: dict[str, Any] = OVER, **options: Any) -> brinell.sweeps.Sweep:
    return brinell.sweep(Case(CASE), over, output=output, progress=False, **options)


def results(result: brinell.sweeps.Sweep) -> Any:
    """The table without times, which differ."""
    return result.table[[name for name in result.table if not name.endswith("wall_time_s")]]


def begun(output: Path) -> list[int]:
    """Runs that have begun, as the journals have it."""
    return [entry["begun"] for entry in JournalReader(journal_folder(output)).entries() if "begun" in entry]


def test_tables_are_the_same_whichever_way(tmp_path: Path) -> None:
    distributed = pytest.importorskip("distributed")
    over = {"tugging.interference": [0.5, 1, 4, 1.5, 2], "solver.max_evaluations": [60, 60, 1, 60, 60]}
    options: dict[str, Any] = {
        "design": "list",
        "threads": 1,
        "keep": "0,3-4",
        "numbers": lambda run: {"steps": run.history.steps},
    }
    with distributed.LocalCluster(n_workers=2, threads_per_worker=1, dashboard_address=None) as cluster:
        on_dask = sweep(tmp_path / "dask", over, cluster=cluster, chunk=2, **options)
    here = sweep(tmp_path / "here", over, workers=1, **options)
    by_array = sweep(tmp_path / "slurm", over, submit=Slurm("--time=5", chunk=2), **options)
    assert here.table["status"].tolist() == ["done", "done", "failed", "done", "done"]
    assert here.table["folder"].tolist() == ["runs/000000", "", "", "runs/000003", "runs/000004"]
    assert (here.table["steps"].dropna() > 3).all()
    for other in (on_dask, by_array):
        pd.testing.assert_frame_equal(results(other), results(here))
        assert list(other.runs) == [0, 3, 4]
        assert sorted(path.name for path in (other.path / "runs").iterdir()) == ["000000", "000003", "000004"]
        pd.testing.assert_frame_equal(results(open_sweep(other.path)), results(open_sweep(here.path)))
    # One table by columns, of numbers where there are numbers, and of the runs only those folders that are asked for.
    schema = parquet.read_schema(here.path / "table.parquet")
    assert all(schema.field(name).type == "double" for name in ("steps", "energy.net_J", "tugging.interference"))
    for one in (here, on_dask, by_array):
        assert parquet.read_schema(one.path / "table.parquet").equals(schema)
        assert len(pd.read_parquet(one.path / "table.parquet")) == 5
        assert {path.name for path in one.path.iterdir()} == {
            *("sweep.json", "table.csv", "table.parquet", "failures.json", "runs", "journal")
        }
        assert [path.name for path in (one.path / "journal").iterdir()] == ["results.jsonl"]
    # The same call again computes nothing, and needs no cluster.
    pd.testing.assert_frame_equal(sweep(tmp_path / "slurm", over, workers=1, **options).table, by_array.table)


def test_options_of_the_call_precede_those_of_the_site(tmp_path: Path) -> None:
    site = Site(Slurm("--partition=nowhere --time=5", chunk=5))
    with pytest.raises(InputError, match="invalid partition"):
        sweep(tmp_path / "one", submit=site.slurm)
    given = site.with_slurm(Slurm("--partition=short"))
    assert sweep(tmp_path / "other", submit=given).table["status"].tolist() == ["done"] * 5


def test_runs_that_kill_their_process_are_named_and_only_they_are_repeated(tmp_path: Path) -> None:
    (tmp_path / "own.py").write_text(CRASH)
    (tmp_path / "crash").touch()
    options: dict[str, Any] = {"submit": Slurm(chunk=5), "numbers": f"{tmp_path / 'own.py'}:check"}
    first = sweep(tmp_path / "sweep", **options)
    assert first.failures["index"].tolist() == [1, 4]
    assert set(first.failures["reason"]) == {"its process came to a sudden end 3 times: killed, or out of memory?"}
    assert first.table["own"].dropna().tolist() == [2, 4, 5]
    (tmp_path / "crash").unlink()
    done = first.table.loc[first.table["status"] == "done", "wall_time_s"]
    again = sweep(tmp_path / "sweep", retry_failed=True, **options)
    assert again.table["status"].tolist() == ["done"] * 5
    assert again.table["own"].tolist() == [2, 3, 4, 5, 6]
    # A time to the nanosecond tells whether a run is the one that was computed before.
    assert again.table["wall_time_s"][done.index].tolist() == done.tolist()


def long_command(case: Path, output: Path, passes: int = 60) -> list[str]:
    over = ["--over", "tugging.interference=1,1.5,2", "--over", f"tugging.passes=1,1,{passes}", "--design", "list"]
    words = [sys.executable, "-m", "brinell", "sweep", str(case), *over, "-o", str(output), "--submit", "slurm"]
    return [*words, "--chunk", "1", "--quiet", *(word for one in LONG for word in ("--set", one))]


def test_a_cancelled_task_is_named_and_the_same_command_computes_it(tmp_path: Path) -> None:
    case, output = tmp_path / "case.toml", tmp_path / "sweep"
    case.write_text(CASE)
    command = long_command(case, output)
    with subprocess.Popen(command, stderr=subprocess.PIPE, text=True) as process:
        wait_for(lambda: 2 in begun(output), "the long run")
        job = arrays_of(output)[0].job
        subprocess.run(["scancel", f"{job}_2"], check=True)
        _, errors = process.communicate(timeout=60)
    assert process.returncode == 1
    assert f"task 2 of job {job}: was cancelled" in errors
    assert "run 2 is missing. The same sweep computes them" in errors
    table = pd.read_csv(output / "table.csv")
    assert table["index"].tolist() == [0, 1]
    again = subprocess.run(command, capture_output=True, text=True, check=False)
    assert again.returncode == 0, again.stderr
    both = pd.read_csv(output / "table.csv")
    assert both["index"].tolist() == [0, 1, 2]
    assert both["wall_time_s"].tolist()[:2] == table["wall_time_s"].tolist()
    assert not (output / "slurm").exists() or not list((output / "slurm").glob("*/submission.json"))


def test_a_command_that_is_killed_while_it_waits_is_taken_up(tmp_path: Path) -> None:
    case, output = tmp_path / "case.toml", tmp_path / "sweep"
    case.write_text(CASE)
    command = long_command(case, output)
    with subprocess.Popen(command, stderr=subprocess.PIPE, text=True) as process:
        wait_for(lambda: 2 in begun(output), "the long run")
        process.kill()
    job = arrays_of(output)[0].job
    with pytest.raises(IoError, match=rf"job {job} of Slurm computes there.*scancel {job}"):
        brinell.sweep(
            Case(CASE, overrides=LONG),
            {"tugging.interference": [1, 1.5, 2], "tugging.passes": [1, 1, 60]},
            output=output,
            design="list",
            workers=1,
            progress=False,
        )
    again = subprocess.run(command, capture_output=True, text=True, check=False)
    assert again.returncode == 0, again.stderr
    assert pd.read_csv(output / "table.csv")["status"].tolist() == ["done"] * 3
    jobs = subprocess.run(["squeue", "-h", "-t", "all", "-o", "%F %j"], capture_output=True, text=True, check=True)
    assert {line.split()[0] for line in jobs.stdout.splitlines() if "brinell-sweep" in line} >= {job}
    assert max(int(line.split()[0]) for line in jobs.stdout.splitlines()) == int(job)  # no second array


def test_ctrl_c_leaves_the_array_in_peace(tmp_path: Path) -> None:
    case, output = tmp_path / "case.toml", tmp_path / "sweep"
    case.write_text(CASE)
    command = long_command(case, output, passes=600)
    with subprocess.Popen(command, stderr=subprocess.PIPE, text=True) as process:
        wait_for(lambda: 2 in begun(output), "the long run")
        job = arrays_of(output)[0].job
        process.send_signal(signal.SIGINT)
        _, errors = process.communicate(timeout=60)
    assert process.returncode == 130
    assert errors.splitlines()[-1] == (
        f"brinell: interrupted; job {job} of Slurm goes on: the same command collects what it does, "
        f"'scancel {job}' ends it"
    )
    not_yet = subprocess.run([*command, "--no-wait"], capture_output=True, text=True, check=False)
    assert not_yet.returncode == 0, not_yet.stderr
    assert "1 are with Slurm; the same command collects them" in not_yet.stdout
    subprocess.run(["scancel", job], check=True)


def test_the_size_of_an_array_is_respected(tmp_path: Path, capfd: pytest.CaptureFixture[str]) -> None:
    count = LARGEST_ARRAY + 4
    over = {"tugging.interference": f"0.2:0.3:{count}"}
    result = brinell.sweep(Case(CASE), over, output=tmp_path, submit=Slurm(chunk=1), progress=True)
    assert result.table["status"].tolist() == ["done"] * count
    told = capfd.readouterr().err
    assert f"2 runs a task instead of 1: an array has at most {LARGEST_ARRAY} tasks here" in told
    assert f"{count} runs in 13 tasks" in told


def test_a_dry_run_prints_the_script_and_writes_nothing(tmp_path: Path) -> None:
    case, output = tmp_path / "case.toml", tmp_path / "sweep"
    case.write_text(CASE)
    words = ["--slurm", "--partition=short --comment 'two words'", "--preamble", "module load python", "--at-once", "3"]
    command = [*long_command(case, output), "--dry-run", *words]
    done = subprocess.run(command, capture_output=True, text=True, check=True)
    lines = done.stdout.splitlines()
    assert lines[:2] == ["# 3 runs in 3 tasks of 1", "#!/bin/bash"]
    for line in (
        "#SBATCH --array=0-2%3",
        "#SBATCH --partition=short",
        "#SBATCH --comment 'two words'",
        "module load python",
    ):
        assert line in lines
    assert not output.exists()


@pytest.mark.parametrize(
    ("options", "message"),
    [
        ("--array=0-3", "the option --array=0-3 is the sweep's own: at_once"),
        ("-o log", "the option -o log is the sweep's own: logs are"),
        ("partition", "'partition' is no option of sbatch"),
        ("--partition=none", "sbatch refuses the job array: .*invalid partition"),
    ],
)
def test_bad_options_are_refused(tmp_path: Path, options: str, message: str) -> None:
    with pytest.raises(InputError, match=message):
        sweep(tmp_path / "sweep", submit=Slurm(options))
    assert not list(tmp_path.glob("sweep/slurm/*"))


def test_a_folder_that_is_not_there_on_a_node_is_told(tmp_path: Path) -> None:
    output = tmp_path / "sweep"

    def hide() -> None:
        def is_submitted() -> bool:  # arrays_of would take a submission under way for one of a killed process
            records = [record.read_text("utf-8") for record in output.glob("slurm/*/submission.json")]
            return any(json.loads(record)["job"] for record in records)

        wait_for(is_submitted, "the array")
        (array,) = arrays_of(output)
        shutil.rmtree(array.folder)  # as if the node did not see it
        release = ["scontrol", "release", array.job]  # refused for a moment after the job was submitted
        wait_for(lambda: subprocess.run(release).returncode == 0, "a job that can be released")

    thread = threading.Thread(target=hide)
    thread.start()
    with pytest.raises(IoError, match=r"task 0 of job \d+: .*shared.*: runs 0-4 are missing\. The same sweep"):
        sweep(output, submit=Slurm("--hold", chunk=5))
    thread.join()
    assert sweep(output, submit=Slurm(chunk=5)).table["status"].tolist() == ["done"] * 5
