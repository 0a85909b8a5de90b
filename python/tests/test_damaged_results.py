# SPDX-License-Identifier: BSD-3-Clause
"""Results that are unfinished, damaged or of something else: each is told by one error."""

import json
from collections.abc import Callable
from pathlib import Path

import h5py
import numpy as np
import pytest

from brinell.results import RunError, open_run

MakeRun = Callable[..., Path]


def test_unfinished_run_is_refused_unless_asked_for(make_run: MakeRun) -> None:
    folder = make_run(finished=False)
    with pytest.raises(
        RunError, match=r"no summary\.json, the run has not finished \(25 steps\); allow_unfinished=True opens"
    ):
        open_run(folder)
    run = open_run(folder, allow_unfinished=True)
    assert not run.complete
    assert run.history.steps == 25
    with pytest.raises(RunError, match="has not finished"):
        _ = run.critical
    with pytest.raises(RunError, match="no final state, the run has not finished"):
        run.snapshot("final")


def test_title_of_an_unfinished_run_is_that_of_its_case(make_run: MakeRun) -> None:
    folder = make_run(finished=False)
    assert open_run(folder, allow_unfinished=True).title == ""
    with h5py.File(folder / "result.vtkhdf", "a") as file:
        del file["case"]
        file["case"] = 'scenario = "tugging"\ntitle = "Half a pass"\n'
    run = open_run(folder, allow_unfinished=True)
    assert run.title == "Half a pass"
    assert repr(run) == f"<brinell.Run tugging 'Half a pass' 25 steps, unfinished, '{folder}'>"
    (folder / "result.vtkhdf").unlink()
    assert open_run(folder, allow_unfinished=True).title == ""


def test_folder_of_a_sweep_is_no_run(tmp_path: Path) -> None:
    (tmp_path / "sweep.json").write_text("{}")
    with pytest.raises(
        RunError, match=r"is a sweep; name a run in its folder runs/, or take brinell\.sweeps\.open_sweep"
    ):
        open_run(tmp_path)


def test_half_a_row_at_the_end_is_dropped(make_run: MakeRun) -> None:
    folder = make_run(finished=False)
    text = (folder / "history.csv").read_text()
    (folder / "history.csv").write_text(text[:-7])
    assert open_run(folder, allow_unfinished=True).history.steps == 24


def test_no_such_folder(tmp_path: Path) -> None:
    with pytest.raises(RunError, match="nowhere: no such folder"):
        open_run(tmp_path / "nowhere")
    with pytest.raises(RunError, match=r"nothing\.vtkhdf: no such file"):
        open_run(tmp_path / "nothing.vtkhdf")


def test_files_that_are_no_results(tmp_path: Path) -> None:
    (tmp_path / "file").write_text("")
    with pytest.raises(RunError, match="file: not a readable HDF5 file"):
        open_run(tmp_path / "file")
    with h5py.File(tmp_path / "other.h5", "w"):
        pass
    with pytest.raises(RunError, match=r"other\.h5: not a result of brinell"):
        open_run(tmp_path / "other.h5")


def test_damaged_file_alone(make_run: MakeRun) -> None:
    path = make_run() / "result.vtkhdf"
    with h5py.File(path, "a") as file:
        del file["history/F_X"]
        file["history/F_X"] = np.zeros(3)
    with pytest.raises(RunError, match="/history is damaged .columns of different lengths"):
        open_run(path)
    with h5py.File(path, "a") as file:
        del file["history/F_X"]
    with pytest.raises(RunError, match="/history: the header is not that of a history .of tugging without F_X"):
        open_run(path)
    with h5py.File(path, "a") as file:
        del file["summary"]
        file["summary"] = "{"
    with h5py.File(path, "a") as file:
        file["history/F_X"] = np.zeros(25)
    with pytest.raises(RunError, match=r"result\.vtkhdf: /summary:1: not valid JSON"):
        open_run(path)


@pytest.mark.parametrize("version", [2, 4])
def test_another_format_version_is_told_on_one_line(make_run: MakeRun, version: int) -> None:
    folder = make_run()
    path = folder / "summary.json"
    path.write_text(json.dumps({**json.loads(path.read_text()), "format_version": version}))
    with h5py.File(folder / "result.vtkhdf", "a") as file:
        file.attrs["format_version"] = version
    told = rf"has format version {version}, but this brinell reads version 3; compute the run again[^\n]*$"
    history = folder / "history.csv"
    history.write_text(history.read_text().replace("evaluations", "iterations"))  # columns may differ, too
    for place in (folder, folder / "result.vtkhdf"):
        with pytest.raises(RunError, match=told):
            open_run(place)


def test_empty_folder(tmp_path: Path) -> None:
    with pytest.raises(RunError, match=r"no history\.csv"):
        open_run(tmp_path)


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"passes": [{}]}, r"passes\[0\]: no pass that can be read"),
        ({"passes": 3}, "passes is not a list"),
        ({"profile": {"depth_m": "deep"}}, "profile: no depth that can be read"),
        ({"scenario": "indentation"}, "is of scenario 'indentation', but the history of 'rolling'"),
    ],
)
def test_damaged_lists_of_the_summary(make_rolling: MakeRun, change: dict, message: str) -> None:
    path = make_rolling() / "summary.json"
    path.write_text(json.dumps(json.loads(path.read_text()) | change))

    def read() -> None:
        run = open_run(path.parent)
        _ = run.passes, run.profile

    with pytest.raises(RunError, match=message):
        read()


@pytest.mark.parametrize(
    ("change", "message"),
    [
        (lambda t: t.replace("F_X", "F_x"), r"history\.csv:1: the header .* tugging without F_X, F_X_macro"),
        (lambda t: "", r"history\.csv:1: the header"),
        (lambda t: t.splitlines()[0] + "\n", "no finished step"),
        (lambda t: t.replace("\n3,", "\nthree,"), r"history\.csv:5: could not convert"),
        (lambda t: t.replace("\n3,", "\n3,4,"), r"history\.csv:5: 23 values, expected 22"),
        (lambda t: t.replace("\n3,", "\nnan,"), r"history\.csv:5: step = nan is not a finite number"),
    ],
)
def test_damaged_history(make_run: MakeRun, change: Callable[[str], str], message: str) -> None:
    folder = make_run()
    path = folder / "history.csv"
    path.write_text(change(path.read_text()))
    with pytest.raises(RunError, match=message):
        open_run(folder)


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("{", r"summary\.json:1: not valid JSON"),
        ("[]", "not a summary of brinell"),
        ('{"format": "brinell-summary", "format_version": 99}', "format version 99, but this brinell reads version 3"),
    ],
)
def test_damaged_summary(make_run: MakeRun, text: str, message: str) -> None:
    folder = make_run()
    (folder / "summary.json").write_text(text)
    with pytest.raises(RunError, match=message):
        open_run(folder)


def test_missing_summary_entry(make_run: MakeRun) -> None:
    folder = make_run()
    path = folder / "summary.json"
    summary = json.loads(path.read_text())
    del summary["geometry"]["equivalent_radius_m"]
    summary["critical"]["C"] = "1.6"
    path.write_text(json.dumps(summary))
    run = open_run(folder)
    with pytest.raises(RunError, match=r"no entry geometry\.equivalent_radius_m"):
        _ = run.equivalent_radius
    with pytest.raises(RunError, match=r"critical\.C = '1\.6' is not a number"):
        _ = run.critical


def test_missing_and_damaged_fields(make_run: MakeRun) -> None:
    folder = make_run()
    run = open_run(folder)
    with h5py.File(folder / "result.vtkhdf", "a") as file:
        del file["steps/000012/contact/gap"]
    with pytest.raises(RunError, match=r"/steps/000012 is damaged"):
        run.snapshot(12)
    with h5py.File(folder / "result.vtkhdf", "a") as file:
        file.attrs["format_version"] = 4
    with pytest.raises(RunError, match="format version 4"):
        run.snapshot(6)
    (folder / "result.vtkhdf").write_bytes(b"not HDF5")
    with pytest.raises(RunError, match="not a readable HDF5 file"):
        run.snapshot(6)
    (folder / "result.vtkhdf").unlink()
    with pytest.raises(RunError, match=r"no result\.vtkhdf"):
        run.snapshot(6)
