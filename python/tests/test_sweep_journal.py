# SPDX-License-Identifier: BSD-3-Clause
# ruff: noqa: E402 (the extra is asked for first)
"""Sweeps whose runs leave no folders: journals, what is asked for, clusters by name."""

import json
import signal
from pathlib import Path
from typing import Any

import pytest

import brinell
from brinell import Case, InputError, IoError
from brinell.cli import main
from brinell.report import write_sweep_report

pd = pytest.importorskip("pandas")
pytest.importorskip("pyarrow")
pytest.importorskip("scipy")

from brinell.sweeps import Cluster, Slurm
from brinell.sweeps.journal import Journal, JournalReader, attempts, case_key, is_of
from brinell.sweeps.kept import kept_of
from brinell.sweeps.point import Outcome, Task
from sweep_case import CASE

pytestmark = pytest.mark.filterwarnings("ignore::brinell.ResolutionWarning")
OVER = {"tugging.interference": [0.5, 1, 1.5]}


def sweep(output: Path, over: dict[str, Any] = OVER, **options: Any) -> brinell.sweeps.Sweep:
    return brinell.sweep(Case(CASE), over, output=output, **{"workers": 1, "progress": False, **options})


def test_runs_without_folders_have_the_same_rows_and_are_not_computed_again(tmp_path: Path) -> None:
    with_folders = sweep(tmp_path / "all")
    without = sweep(tmp_path / "none", keep="none")
    same = [name for name in with_folders.table if name != "folder" and not name.endswith("wall_time_s")]
    pd.testing.assert_frame_equal(without.table[same], with_folders.table[same])
    assert without.table["folder"].tolist() == [""] * 3
    assert not (tmp_path / "none" / "runs").exists()
    assert dict(without.runs) == {}
    # To the nanosecond: these are the times of the first runs.
    again = sweep(tmp_path / "none", keep="none")
    pd.testing.assert_frame_equal(again.table, without.table)
    # Whose folder is asked for later is computed for it; the others stay.
    one = sweep(tmp_path / "none", keep=[1])
    assert one.table["folder"].tolist() == ["", "runs/000001", ""]
    assert one.table["wall_time_s"].tolist()[::2] == without.table["wall_time_s"].tolist()[::2]
    assert "3 runs" in repr(one)
    write_sweep_report(one, tmp_path / "report.html")
    write_sweep_report(without, tmp_path / "report.html")


def test_a_journal_that_is_broken_off_loses_one_run_only(tmp_path: Path) -> None:
    first = sweep(tmp_path, keep="none")
    file = tmp_path / "journal" / "results.jsonl"
    lines = file.read_bytes().splitlines(keepends=True)
    assert len(lines) == 3
    file.write_bytes(b"".join(lines[:2]) + lines[2][:100])
    again = sweep(tmp_path, keep="none")
    times = (first.table["wall_time_s"] == again.table["wall_time_s"]).tolist()
    assert times == [True, True, False]


def test_a_line_after_a_broken_one_is_read(tmp_path: Path) -> None:
    file = tmp_path / "one.jsonl"
    text = Case(CASE).to_toml()
    file.write_bytes(b'{"index": 3, "sta')
    journal = Journal(file)
    journal.begun(Task(4, text, "", 1))
    journal.begun(Task(5, text, "", 1))
    journal.add(Outcome(4, "failed", reason="as it must"), text)
    entries = JournalReader(tmp_path).entries_of(file)
    assert [entry.get("index", entry.get("begun")) for entry in entries] == [4, 5, 4]
    assert attempts(entries) == {5: 1}


def test_a_full_disk_is_told(tmp_path: Path) -> None:
    if not Path("/dev/full").exists():
        pytest.skip("no /dev/full")
    file = tmp_path / "full.jsonl"
    file.symlink_to("/dev/full")
    with pytest.raises(IoError, match=r"full\.jsonl: cannot be written: No space left on device"):
        Journal(file).begun(Task(0, "", "", 1))


def test_a_line_of_another_case_is_not_taken() -> None:
    base = Case(CASE)
    entry = json.loads(json.dumps(case_key(base.to_toml())))
    assert is_of(entry, case_key(base.to_toml()))
    assert not is_of(entry, case_key(base.with_values({"tugging.interference": 3}).to_toml()))
    finer = case_key(base.with_values({"grid.resolution": 3}).to_toml())
    assert not is_of(entry, finer)
    assert is_of(entry, finer, ["grid.resolution"])


def test_numbers_of_runs_without_folders(tmp_path: Path) -> None:
    def steps(run: brinell.Run) -> dict[str, int]:
        return {"steps": run.history.steps}

    result = sweep(tmp_path / "one", keep="none", numbers=steps)
    assert (result.table["steps"] > 3).all()
    with pytest.raises(InputError, match=r"residual_stress needs the folder of run 0, which is not kept"):
        sweep(tmp_path / "one", keep="none", numbers=brinell.sweeps.residual_stress)
    failed = sweep(tmp_path / "other", keep="none", numbers=lambda run: {"a": 1 / 0})
    assert failed.failures["reason"].tolist()[0] == "numbers: <lambda> of run 0: ZeroDivisionError: division by zero"


@pytest.mark.parametrize(
    ("keep", "message"),
    [
        ("some", "keep = 'some'; allowed: all, none, or numbers of runs"),
        ("3", "there is no run 3; allowed: 0 to 2"),
        ([-1], "there is no run -1"),
        (["a"], "allowed: all, none, or numbers"),
    ],
)
def test_what_cannot_be_kept(keep: Any, message: str) -> None:
    with pytest.raises(InputError, match=message):
        kept_of(keep, 3, otherwise="all")


def test_a_cluster_is_started_by_the_name_of_its_class(tmp_path: Path) -> None:
    pytest.importorskip("distributed")
    options = {"n_workers": 1, "threads_per_worker": 1, "dashboard_address": None}
    result = sweep(tmp_path, workers=None, cluster=Cluster("LocalCluster", options, 1), keep="none", chunk=2)
    assert result.table["status"].tolist() == ["done"] * 3
    assert sorted(path.name for path in (tmp_path / "journal").iterdir()) == ["results.jsonl"]
    with pytest.raises(InputError, match=r"cluster distributed:SpecCluster: its options are refused: .*no_such"):
        Cluster("distributed:SpecCluster", {"no_such": 1}).started()
    with pytest.raises(InputError, match="distributed has no such class; allowed: a class of dask_jobqueue"):
        Cluster("distributed:NoCluster").started()


@pytest.mark.parametrize(
    ("words", "message"),
    [
        (["--slurm", "--time=1"], "--slurm has no meaning without --submit slurm"),
        (["--jobs", "3"], "--jobs has no meaning without --cluster CLASS"),
        (["--cluster", "LocalCluster", "--cluster-option", "cores"], "--cluster-option cores: allowed: NAME=VALUE"),
        (["--submit", "slurm", "--workers", "2"], "workers = 2 has no meaning with a job array"),
        (["--chunk", "3"], "chunk = 3; allowed: 1 or more, with a Dask cluster"),
        (["--submit", "slurm", "--slurm", "--array=1"], "the option --array=1 is the sweep's own"),
    ],
)
def test_options_that_do_not_fit(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], words: list[str], message: str
) -> None:
    case = tmp_path / "case.toml"
    case.write_text(CASE)
    numbers = (signal.SIGTERM, signal.SIGHUP, signal.SIGPIPE)
    handlers = {number: signal.getsignal(number) for number in numbers}
    try:
        with pytest.raises(SystemExit) as end:
            main(["sweep", str(case), "--over", "tugging.interference=1,2", "-o", str(tmp_path / "sweep"), *words])
    finally:
        for number, handler in handlers.items():
            signal.signal(number, handler)
    assert end.value.code == 2
    assert message in capsys.readouterr().err
    assert not (tmp_path / "sweep").exists()


def test_where_there_is_no_slurm(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("PATH", str(tmp_path))
    with pytest.raises(IoError, match="scontrol is not on this machine; a sweep is submitted where sbatch is"):
        sweep(tmp_path / "sweep", workers=None, submit=Slurm())
