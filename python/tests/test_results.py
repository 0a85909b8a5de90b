# SPDX-License-Identifier: BSD-3-Clause
import json
import pickle
import sys
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest

import brinell
from brinell.results import HISTORY_COLUMNS, RunError, open_run

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
    with pytest.raises(RunError, match="is of scenario 'rolling'; only results of 'indentation' have indents"):
        _ = run.indents


@pytest.mark.parametrize("name", ["passes", "profile"])
def test_lists_of_rolling_are_of_no_other_scenario(make_indentation: MakeRun, name: str) -> None:
    run = open_run(make_indentation())
    with pytest.raises(RunError, match=f"is of scenario 'indentation'; only results of 'rolling' have {name}"):
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


def test_values_of_the_case(make_indentation: MakeRun) -> None:
    run = open_run(make_indentation(upper="vickers"))
    assert run.case("upper", "shape", "type") == "vickers"
    assert run.case("upper", "shape", "type", "further") is None
    assert not run.has_critical_values


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


def test_passes_count_from_1(make_run: MakeRun) -> None:
    run = open_run(make_run(passes=2))
    assert [one["pass"][0] for one in run.history.passes()] == [1, 2]
    with pytest.raises(brinell.InputError, match="pass_ = 0; allowed: 1 or more"):
        brinell.plot.animate(run, pass_=0)


def test_passes_places_and_cycles_count_from_1_in_a_run() -> None:
    case = brinell.Indentation(
        brinell.Body(brinell.Flat(), brinell.Material("200 GPa", 0.3, brinell.Perfect("1 GPa"))),
        brinell.Body(brinell.Sphere("1 mm"), brinell.RIGID),
        load=["20 N", 0],
        steps=2,
        cycles=2,
        places=["0 um", "200 um"],
        grid={"resolution": 3},
    )
    run = case.run(in_memory=True)
    history = run.history
    np.testing.assert_array_equal(history["step"], np.arange(16))
    np.testing.assert_array_equal(history["pass"], np.repeat([1, 2, 3, 4], 4))
    np.testing.assert_array_equal(history["place"], np.repeat([1, 2], 8))
    assert [(one.place, one.cycle, one.x) for one in run.indents] == [(1, 1, 0), (1, 2, 0), (2, 1, 2e-4), (2, 2, 2e-4)]
    assert np.all(history["evaluations"] >= 1)
    assert np.sum(history["evaluations"]) == run.summary["run"]["evaluations"]  # type: ignore[index]
