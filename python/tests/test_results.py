# SPDX-License-Identifier: BSD-3-Clause
import json
import pickle
import shutil
import sys
from collections.abc import Callable
from pathlib import Path

import h5py
import numpy as np
import pytest

import brinell
from brinell.results import COMPONENTS, HISTORY_COLUMNS, RunError, open_run

MakeRun = Callable[..., Path]


def test_version_is_that_of_the_repository() -> None:
    version_file = Path(__file__).parents[2] / "VERSION"
    assert brinell.__version__ == version_file.read_text(encoding="utf-8").strip()


def test_history_holds_every_column_and_row(make_run: MakeRun) -> None:
    folder = make_run(9.0, steps=25)
    run = open_run(folder)
    assert tuple(run.history) == HISTORY_COLUMNS["tugging"]
    table = np.loadtxt(folder / "history.csv", delimiter=",", skiprows=1)
    assert run.history.steps == 25
    for i, name in enumerate(HISTORY_COLUMNS["tugging"]):
        np.testing.assert_array_equal(run.history[name], table[:, i])


def test_columns_are_those_of_the_specification() -> None:
    specification = Path(__file__).parents[2] / "docs" / "reference" / "results-format.md"
    if not specification.is_file():
        pytest.skip("not in the repository")
    text = specification.read_text(encoding="utf-8")
    names = {name for columns in HISTORY_COLUMNS.values() for name in columns}
    assert not [name for name in sorted(names) if f"`{name}`" not in text]


def test_scales_come_from_the_summary(make_run: MakeRun) -> None:
    run = open_run(make_run(4.0))
    assert run.complete
    assert run.critical.load == 3.460928e5
    assert run.critical.yield_stress == pytest.approx(0.9115e9)
    assert run.equivalent_radius == 0.5
    assert (run.lower_radius, run.upper_radius) == (1.0, 1.0)
    assert run.normalised_interference == pytest.approx(4.0)


def test_passes_are_split(make_run: MakeRun) -> None:
    run = open_run(make_run(4.0, passes=3, steps=11))
    passes = run.history.passes()
    assert [one.steps for one in passes] == [11, 11, 11]
    assert all(np.all(np.diff(one["X"]) > 0.0) for one in passes)
    np.testing.assert_array_equal(np.concatenate([one["work"] for one in passes]), run.history["work"])


def test_one_pass_is_one_history(make_run: MakeRun) -> None:
    assert len(open_run(make_run(4.0)).history.passes()) == 1


@pytest.mark.parametrize("which", [6, 12, "aligned", "final"])
def test_snapshot_holds_the_stored_fields(make_run: MakeRun, which: int | str) -> None:
    folder = make_run(9.0)
    run = open_run(folder)
    assert run.steps == [6, 12]
    snapshot = run.snapshot(which, tensors=True)  # type: ignore[arg-type]
    name = "final" if which == "final" else f"steps/{12 if which == 'aligned' else which:06d}"
    with h5py.File(folder / "result.vtkhdf") as file:
        group = file[name]
        assert snapshot.row["X"] == group.attrs["X"]
        assert snapshot.step == group.attrs["step"]
        assert snapshot.is_final == (which == "final")
        np.testing.assert_array_equal(snapshot.contact.pressure, group["contact/pressure"])
        np.testing.assert_array_equal(snapshot.contact.gap, group["contact/gap"])
        for body, data in ((snapshot.lower, group["lower"]), (snapshot.upper, group["upper"])):
            np.testing.assert_array_equal(body.residual_displacement, data["residual_displacement"])
            np.testing.assert_array_equal(body.equivalent_plastic_strain, data["equivalent_plastic_strain"])
            np.testing.assert_array_equal(body.von_mises_stress, data["von_mises_stress"])
            np.testing.assert_array_equal(body.stress["xz"], data["stress/xz"])
            np.testing.assert_array_equal(body.plastic_strain["yy"], data["plastic_strain/yy"])
            assert body.equivalent_plastic_strain.shape == (len(body.z), len(body.y), len(body.x))
            assert body.contact_x == data.attrs["contact_x"]
            assert (body.x[0], body.y[0], body.z[0]) == tuple(data.attrs["origin"])
            assert body.x[1] - body.x[0] == pytest.approx(data.attrs["spacing"][0])


def test_components_are_read_when_they_are_asked_for(make_run: MakeRun) -> None:
    folder = make_run()
    later, at_once, gone = (open_run(folder).snapshot("aligned", tensors=whole) for whole in (False, True, False))
    assert list(later.lower.stress) == list(COMPONENTS)
    assert "xx" in later.lower.stress
    np.testing.assert_array_equal(later.lower.stress["xz"], at_once.lower.stress["xz"])
    assert later.lower.stress["xz"] is later.lower.stress["xz"]
    with h5py.File(folder / "result.vtkhdf") as file:
        np.testing.assert_array_equal(later.upper.stress["yy"], file["steps/000012/upper/stress/yy"])
    shutil.rmtree(folder)
    np.testing.assert_array_equal(at_once.lower.stress["yz"].shape, later.lower.stress["xz"].shape)
    with pytest.raises(RunError, match="no result.vtkhdf"):
        gone.lower.stress["xx"]


def test_what_is_not_stored_says_so(make_indentation: MakeRun) -> None:
    upper = open_run(make_indentation()).snapshot("aligned").upper
    with pytest.raises(KeyError, match="nothing is stored of the stress of this body: it is rigid"):
        upper.stress["xx"]
    assert upper.stress.get("xx") is None


def test_a_history_is_a_table_of_pandas(make_run: MakeRun) -> None:
    pandas = pytest.importorskip("pandas")
    history = open_run(make_run()).history
    for table in (history.to_pandas(), pandas.DataFrame(history)):
        assert list(table.columns) == list(history)
        assert len(table) == history.steps
        assert table["step"].dtype == table["pass"].dtype == table["evaluations"].dtype == np.int64
        assert table["F_X"].dtype == np.float64
        np.testing.assert_array_equal(table["F_X"], history["F_X"])
    assert history.to_pandas().attrs["units"]["F_X"] == "N"
    assert history.units["step"] == "1"


def test_without_pandas(make_run: MakeRun, monkeypatch: pytest.MonkeyPatch) -> None:
    history = open_run(make_run()).history
    monkeypatch.setitem(sys.modules, "pandas", None)
    with pytest.raises(brinell.MissingExtraError, match=r'pip install "brinell\[pandas\]"'):
        history.to_pandas()


def test_a_history_can_be_sent_to_another_process(make_run: MakeRun) -> None:
    history = open_run(make_run()).history
    again = pickle.loads(pickle.dumps(history))
    assert type(again) is type(history)
    assert again.scenario == history.scenario
    np.testing.assert_array_equal(again["F_X"], history["F_X"])


def test_elastic_body_has_zero_plastic_fields(make_run: MakeRun) -> None:
    upper = open_run(make_run(elastic_upper=True)).snapshot("aligned", tensors=True).upper
    assert upper.equivalent_plastic_strain.shape == (20, 15, 61)
    assert not np.any(upper.equivalent_plastic_strain)
    assert upper.plastic_strain == {}


def test_aligned_is_searched_in_the_first_pass_only(make_run: MakeRun) -> None:
    folder = make_run()
    with h5py.File(folder / "result.vtkhdf", "a") as file:
        file.copy("steps/000012", "steps/000037")
        file["steps/000037"].attrs["pass"] = 2
        file["steps/000037"].attrs["X"] = 0.0
        file["steps/000037"].attrs["step"] = 37
        file["steps/000012"].attrs["X"] = 0.001
    assert open_run(folder).snapshot("aligned").step == 12


# --- Indentation and rolling ------------------------------------------------------------------------------------------


@pytest.mark.parametrize("scenario", ["tugging", "indentation", "rolling"])
def test_scenario_is_told_by_the_columns(
    make_run: MakeRun, make_indentation: MakeRun, make_rolling: MakeRun, scenario: str
) -> None:
    make = {"tugging": make_run, "indentation": make_indentation, "rolling": make_rolling}[scenario]
    run = open_run(make(finished=False), allow_unfinished=True)
    assert run.scenario == scenario
    assert tuple(run.history) == HISTORY_COLUMNS[scenario]  # type: ignore[index]
    snapshot = run.snapshot("aligned")
    assert snapshot.scenario == scenario
    # Attributes of a stored step are its row of the history.
    assert dict(snapshot.row) == {name: column[snapshot.step] for name, column in run.history.items()}


def test_a_later_program_may_add_columns(make_rolling: MakeRun) -> None:
    path = make_rolling() / "history.csv"
    header, *rows = path.read_text().splitlines()
    path.write_text("\n".join([f"{header},temperature", *(f"{row},300" for row in rows)]) + "\n")
    history = open_run(path.parent).history
    assert history.scenario == "rolling"
    assert np.all(history["temperature"] == 300.0)
    assert np.all(history.passes()[1]["temperature"] == 300.0)


def test_indents(make_indentation: MakeRun) -> None:
    run = open_run(make_indentation(cycles=2, places=(-0.1, 0.1)))
    assert [(one.place, one.cycle, one.x) for one in run.indents] == [
        (1, 1, -0.1),
        (1, 2, -0.1),
        (2, 1, 0.1),
        (2, 2, 0.1),
    ]
    assert all(type(one.place) is int for one in run.indents)
    one = run.indents[0]
    assert (one.max_load, one.hardness) == (3e6, 2.5e9)
    assert one.final_approach == pytest.approx(0.6 * one.max_approach)
    assert np.isnan(run.indents[1].final_approach)  # null: the contact does not open
    assert len(run.history.passes()) == 4
    assert [rows["x"][0] for rows in run.history.split("place")] == [-0.1, 0.1]


def test_rolling_passes_and_profile(make_rolling: MakeRun) -> None:
    run = open_run(make_rolling(passes=2))
    assert [one.pass_ for one in run.passes] == [1, 2]
    assert [one.rut_depth for one in run.passes] == pytest.approx([5e-5, 7.5e-5])
    assert run.passes[1].resistance == 25.0
    assert (run.passes[1].steady, run.passes[1].mean_F_X) == (True, 30.0)
    assert run.passes[1].track_plastic_increment == pytest.approx(0.0015)
    assert run.profile.depth.shape == run.profile.residual_xx.shape == (12,)
    assert run.profile.residual_yy[0] < 0.0
    with pytest.raises(RunError, match="is of scenario 'rolling'; indents are of 'indentation'"):
        _ = run.indents


@pytest.mark.parametrize("name", ["passes", "profile"])
def test_lists_of_rolling_are_of_no_other_scenario(make_indentation: MakeRun, name: str) -> None:
    run = open_run(make_indentation())
    with pytest.raises(RunError, match=f"is of scenario 'indentation'; {name} are of 'rolling'"):
        getattr(run, name)


@pytest.mark.parametrize(
    ("name", "message"),
    [
        ("FX", "no column 'FX'; close: F_X"),
        ("max_presure", "no column 'max_presure'; close: max_pressure"),
        ("qqq", "no column 'qqq'; allowed: step, pass, X, "),
    ],
)
def test_unknown_columns(make_run: MakeRun, name: str, message: str) -> None:
    history = open_run(make_run()).history
    assert name not in history
    with pytest.raises(KeyError, match=message):
        history[name]


def test_reprs_are_short(make_run: MakeRun, make_indentation: MakeRun) -> None:
    run = open_run(make_run(passes=2))
    assert repr(run) == f"<brinell.Run tugging {run.title!r} {run.history.steps} steps, complete, '{run.path}'>"
    assert repr(run.history) == f"<History tugging {run.history.steps} steps, {len(run.history)} columns>"
    final = run.snapshot("final")
    assert repr(run.snapshot(6)) == "<Snapshot tugging step 6, pass 1>"
    assert repr(final) == "<Snapshot tugging final state, pass 2>"
    body = final.lower
    assert repr(body) == f"<BodyFields {len(body.x)} x {len(body.y)} x {len(body.z)} cells>"
    assert repr(final.contact) == f"<ContactFields {len(final.contact.x)} x {len(final.contact.y)} cells>"
    assert repr(open_run(make_indentation()).snapshot("aligned").upper) == "<BodyFields rigid>"


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


def test_rigid_body_has_no_fields(make_indentation: MakeRun) -> None:
    snapshot = open_run(make_indentation()).snapshot("aligned", tensors=True)
    assert snapshot.upper.is_rigid
    assert snapshot.upper.x.size == snapshot.upper.equivalent_plastic_strain.size == 0
    assert snapshot.upper.von_mises_stress is None
    assert snapshot.upper.stress == {}
    assert not snapshot.lower.is_rigid


def test_aligned_of_an_indentation_is_its_first_largest_load(make_indentation: MakeRun) -> None:
    run = open_run(make_indentation(cycles=2, steps=8))
    assert run.steps == [7, 15, 23, 31]
    snapshot = run.snapshot("aligned")
    assert (snapshot.step, snapshot.pass_) == (7, 1)
    assert snapshot.in_contact


def test_aligned_of_rolling_is_the_middle_of_the_first_pass(make_rolling: MakeRun) -> None:
    snapshot = open_run(make_rolling()).snapshot("aligned")
    assert (snapshot.pass_, snapshot.row["x"]) == (1, pytest.approx(0.0))


def test_values_of_the_case(make_indentation: MakeRun) -> None:
    run = open_run(make_indentation(upper="vickers"))
    assert run.case("upper", "shape", "type") == "vickers"
    assert run.case("upper", "shape", "type", "further") is None
    assert not run.has_critical_values


# --- Stopped runs -----------------------------------------------------------------------------------------------------


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
    with pytest.raises(RunError, match=r"is a sweep; brinell\.sweeps\.open_sweep opens it, or name a run in its"):
        open_run(tmp_path)


def test_half_a_row_at_the_end_is_dropped(make_run: MakeRun) -> None:
    folder = make_run(finished=False)
    text = (folder / "history.csv").read_text()
    (folder / "history.csv").write_text(text[:-7])
    assert open_run(folder, allow_unfinished=True).history.steps == 24


def test_linked_snapshots_of_a_killed_run(make_run: MakeRun) -> None:
    folder = make_run(finished=False)
    (folder / "snapshots").mkdir()
    with h5py.File(folder / "result.vtkhdf", "a") as file:
        with h5py.File(folder / "snapshots" / "000012.h5", "w") as part:
            file.copy("steps/000012", part, "step")
        del file["steps/000012"]
        file["steps/000012"] = h5py.ExternalLink("snapshots/000012.h5", "/step")
    run = open_run(folder, allow_unfinished=True)
    assert run.snapshot(12).step == 12
    assert not run.snapshot(12).is_final
    shutil.rmtree(folder / "snapshots")
    with pytest.raises(RunError, match="snapshots missing"):
        run.snapshot(12)


# --- What can be wrong with a folder ----------------------------------------------------------------------------------


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


def test_results_of_version_1_are_told(make_run: MakeRun) -> None:
    folder = make_run()
    with h5py.File(folder / "result.vtkhdf", "a") as file:
        file.attrs["format_version"] = 1
    (folder / "result.vtkhdf").rename(folder / "result.h5")
    for path in (folder, folder / "result.h5"):
        with pytest.raises(RunError, match="format version 1, this program reads version 3"):
            open_run(path)


def test_empty_folder(tmp_path: Path) -> None:
    with pytest.raises(RunError, match=r"no history\.csv"):
        open_run(tmp_path)


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
        ('{"format": "brinell-summary", "format_version": 99}', "format version 99, this program reads version 3"),
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


def test_elastic_pair_has_no_critical_values(make_run: MakeRun) -> None:
    folder = make_run()
    path = folder / "summary.json"
    summary = json.loads(path.read_text())
    summary["critical"] = dict.fromkeys(summary["critical"])
    path.write_text(json.dumps(summary))
    run = open_run(folder)
    assert not run.has_critical_values
    with pytest.raises(RunError, match="both bodies are elastic"):
        _ = run.critical


def test_step_that_is_not_stored(make_run: MakeRun) -> None:
    with pytest.raises(RunError, match=r"step 7 is not stored \(stored: 6, 12\)"):
        open_run(make_run()).snapshot(7)


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
