# SPDX-License-Identifier: BSD-3-Clause
# ruff: noqa: E402 (the extra is asked for first)
"""Sweeps of many runs by Dask workers on this machine, and in the jobs of a real Slurm that dask_jobqueue submits."""

import subprocess
import threading
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest

import brinell
from brinell import Case, InputError, IoError

pd = pytest.importorskip("pandas")
pytest.importorskip("pyarrow")
pytest.importorskip("scipy")
distributed = pytest.importorskip("distributed")

from brinell.sweeps import Cluster
from brinell.sweeps.clusters import DaskPool
from brinell.sweeps.journal import journal_folder
from slurm_here import reason_to_skip, slurm_here
from sweep_case import CASE, wait_for

pytestmark = pytest.mark.filterwarnings("ignore::brinell.ResolutionWarning")

RUNS = 200
FAULTS = """
import os, signal
from pathlib import Path

def check(run):
    index = round(100 * (run.summary["case"]["tugging"]["interference"] - 0.5))
    if Path(__file__).with_name("faults").exists():
        if index == 20:
            os.kill(os.getpid(), signal.SIGKILL)
        if index in (99, 199):
            raise ValueError(f"fault {index}")
    return {"own": index}
"""
OVER = {"tugging.interference": [round(0.5 + 0.01 * i, 2) for i in range(RUNS)]}


@pytest.fixture(scope="module")
def slurm(tmp_path_factory: pytest.TempPathFactory) -> Iterator[None]:
    if reason_to_skip():
        pytest.skip(reason_to_skip())
    pytest.importorskip("dask_jobqueue", reason="no dask_jobqueue: pip install 'brinell[cluster]'")
    try:
        with slurm_here(tmp_path_factory.mktemp("slurm")):
            yield
    except RuntimeError as error:
        pytest.skip(str(error))


def jobs_of_slurm(folder: Path, **options: Any) -> Cluster:
    """One job with one worker: the machine of the tests may have few cores."""
    given = {"cores": 1, "memory": "1 GB", "walltime": "00:10:00", "log_directory": str(folder / "logs")}
    return Cluster("SLURMCluster", {**given, "scheduler_options": {"dashboard": False}, **options}, 1, 5)


def sweep(output: Path, **options: Any) -> brinell.sweeps.Sweep:
    return brinell.sweep(Case(CASE), OVER, output=output, progress=False, **options)


def assert_names_failures_and_repeats_only_them(folder: Path, cluster: Cluster) -> None:
    (folder / "own.py").write_text(FAULTS)
    (folder / "faults").touch()
    output = folder / "sweep"
    options: dict[str, Any] = {"cluster": cluster, "keep": "7-8", "numbers": f"{folder / 'own.py'}:check"}
    first = sweep(output, **options)
    reasons = dict(zip(first.failures["index"], first.failures["reason"], strict=True))
    assert reasons == {
        99: "numbers: check of run 99: ValueError: fault 99",
        199: "numbers: check of run 199: ValueError: fault 199",
    } | {20: "its process came to a sudden end 3 times: killed, or out of memory?"}
    assert first.table["index"].tolist() == list(range(RUNS))
    (folder / "faults").unlink()
    done = first.table.loc[first.table["status"] == "done", "wall_time_s"]
    assert len(done) == RUNS - 3
    again = sweep(output, retry_failed=True, **options)
    assert again.table["status"].tolist() == ["done"] * RUNS
    assert again.table["own"].tolist() == list(range(RUNS))
    # A time to the nanosecond tells whether a run is the one that was computed before.
    assert again.table["wall_time_s"][done.index].tolist() == done.tolist()
    assert sorted(path.name for path in (output / "runs").iterdir()) == ["000007", "000008"]
    assert pd.read_parquet(output / "table.parquet")["own"].tolist() == list(range(RUNS))


def test_workers_of_this_machine(tmp_path: Path) -> None:
    options = {"n_workers": 2, "threads_per_worker": 1, "dashboard_address": None}
    assert_names_failures_and_repeats_only_them(tmp_path, Cluster("LocalCluster", options, chunk=5))


@pytest.mark.usefixtures("slurm")
def test_jobs_of_slurm(tmp_path: Path) -> None:
    assert_names_failures_and_repeats_only_them(tmp_path, jobs_of_slurm(tmp_path))
    squeue = ["squeue", "--noheader", "--states=pending,running"]
    assert subprocess.run(squeue, capture_output=True, text=True, check=True).stdout == ""


@pytest.mark.usefixtures("slurm")
def test_a_job_that_ends_is_submitted_again(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("brinell.sweeps.jobs._PATIENCE", 2.0)
    monkeypatch.setattr("brinell.sweeps.loop._PAUSE", 1.0)
    output = tmp_path / "sweep"
    squeue = ["squeue", "--noheader", "--states=all", "--name=ends", "--format=%i"]

    def jobs() -> list[str]:
        return subprocess.run(squeue, capture_output=True, text=True, check=True).stdout.split()

    def cancel() -> None:
        wait_for(lambda: list(journal_folder(output).glob("*.jsonl")), "a run")
        subprocess.run(["scancel", *jobs()], check=True)

    thread = threading.Thread(target=cancel)
    thread.start()
    result = sweep(output, cluster=jobs_of_slurm(tmp_path, job_name="ends"), keep="none")
    thread.join()
    assert result.table["status"].tolist() == ["done"] * RUNS
    assert len(jobs()) == 2


@pytest.mark.usefixtures("slurm")
def test_jobs_that_slurm_refuses(tmp_path: Path) -> None:
    wrong = r"cluster SLURMCluster: its jobs are refused: sbatch: error: .*invalid partition.*nowhere"
    with pytest.raises(IoError, match=wrong):
        sweep(tmp_path / "sweep", cluster=jobs_of_slurm(tmp_path, queue="nowhere"))
    with pytest.raises(InputError, match=r"cluster SLURMCluster: its options are refused: .*no_such"):
        sweep(tmp_path / "sweep", cluster=jobs_of_slurm(tmp_path, no_such=1))
    assert not list(tmp_path.glob("sweep/table*"))


def test_a_cluster_without_jobs_is_an_error() -> None:
    pytest.importorskip("dask_jobqueue")
    with pytest.raises(InputError, match=r"cluster SLURMCluster: has no jobs; allowed: a number of them"):
        Cluster("SLURMCluster", {"cores": 1, "memory": "1 GB"}).started()


def test_a_cluster_without_workers_is_told(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(DaskPool.losses.__globals__, "_PATIENCE", 0.0)
    with distributed.LocalCluster(n_workers=0, dashboard_address=None) as cluster:
        pool = DaskPool(cluster, tmp_path, 1)
        assert pool.losses() == [
            "no worker of the cluster for 0 s; the sweep waits for one: are its jobs in the queue?"
        ]
        pool.close()
