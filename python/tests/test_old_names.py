# SPDX-License-Identifier: BSD-3-Clause
"""Names that have changed: old ones still work, with a warning; results of the old format open under the new names."""

import json
import shutil
import warnings
from collections.abc import Callable, Mapping
from pathlib import Path
from typing import Any

import h5py
import numpy as np
import pandas as pd
import pytest

import brinell
from brinell import _core
from brinell.case import OldNameWarning
from brinell.results import open_run
from brinell.results.old_format import table_of_today
from brinell.sweeps.driver import _axes
from brinell.sweeps.folder import start_folder

MakeRun = Callable[..., Path]
IS_NOW = r"{} is now called {}: the old name is understood in this version still"


# --- Keys and arguments -----------------------------------------------------------------------------------------------


def test_an_old_key_works_with_a_warning(real_case: str) -> None:
    told = IS_NOW.format(r"solver\.max_iterations", r"solver\.max_evaluations")
    with pytest.warns(OldNameWarning, match=told):
        case = brinell.Case(real_case, overrides=["solver.max_iterations=50"])
    assert "max_evaluations = 50" in case.to_toml()
    assert "max_iterations" not in case.to_toml()
    assert case.warnings[0].key == "old_name"
    assert issubclass(OldNameWarning, FutureWarning)
    assert issubclass(OldNameWarning, brinell.case.CaseWarning)
    with pytest.warns(OldNameWarning, match=told):
        brinell.Case(real_case).with_values({"solver.max_iterations": 50})


def test_the_summary_tells_of_old_keys(real_case: str, tmp_path: Path) -> None:
    with pytest.warns(OldNameWarning):
        case = brinell.Case(real_case, overrides=["solver.max_iterations=50"])
    with warnings.catch_warnings():
        warnings.simplefilter("error", OldNameWarning)  # told when the case was read
        run = case.run(tmp_path)
    assert run.warnings[0].key == "old_name"
    assert run.case("solver", "max_evaluations") == 50


def test_old_arguments_work_with_a_warning() -> None:
    with pytest.warns(FutureWarning, match=IS_NOW.format("max_iterations", "max_evaluations")) as caught:
        solver = brinell.Solver(max_iterations=50)  # type: ignore[call-arg]
    assert caught[0].filename == __file__
    assert solver == brinell.Solver(max_evaluations=50)
    with pytest.warns(FutureWarning, match=IS_NOW.format("max_iterations", "max_evaluations")):
        assert solver.max_iterations == 50  # type: ignore[attr-defined]
    with pytest.warns(FutureWarning, match=IS_NOW.format("kinematic", "back_stresses")):
        material = brinell.Material("210 GPa", 0.3, brinell.Perfect("1 GPa"), kinematic=[("20 GPa", 100)])  # type: ignore[call-arg]
    assert material == brinell.Material("210 GPa", 0.3, brinell.Perfect("1 GPa"), back_stresses=[("20 GPa", 100)])
    with pytest.warns(FutureWarning):
        assert material.kinematic == (("20 GPa", 100),)  # type: ignore[attr-defined]


def test_both_names_are_an_error() -> None:
    with pytest.raises(brinell.InputError, match="max_iterations is an old name of max_evaluations, which is given"):
        brinell.Solver(max_iterations=50, max_evaluations=50)  # type: ignore[call-arg]
    with pytest.raises(brinell.InputError, match="kinematic is an old name of back_stresses"):
        brinell.Material(2e11, 0.3, kinematic=[(1e9, 0)], back_stresses=[(1e9, 0)])  # type: ignore[call-arg]


def test_new_names_are_told_nothing_of(real_case: str) -> None:
    with warnings.catch_warnings():
        warnings.simplefilter("error", FutureWarning)
        material = brinell.Material("210 GPa", 0.3, brinell.Perfect("1 GPa"), back_stresses=[("20 GPa", 100)])
        assert material.back_stresses == (("20 GPa", 100),)
        assert brinell.Solver(max_evaluations=7).to_case() == {"max_evaluations": 7}
        brinell.Case(real_case, overrides=["solver.max_evaluations=50"])


def test_an_old_column_is_found_with_a_warning(make_run: MakeRun) -> None:
    history = open_run(make_run()).history
    with pytest.warns(FutureWarning, match="the column iterations is now called evaluations"):
        np.testing.assert_array_equal(history["iterations"], history["evaluations"])
    assert "iterations" not in history


def test_an_axis_of_a_sweep_gets_the_new_name() -> None:
    with pytest.warns(FutureWarning, match=IS_NOW.format(r"solver\.max_iterations", r"solver\.max_evaluations")):
        assert list(_axes({"solver.max_iterations": [50, 60]})) == ["solver.max_evaluations"]
    moduli = "lower.material.hardening.kinematic_moduli"
    with pytest.warns(FutureWarning):
        assert list(_axes({moduli: "10GPa:20GPa:2"})) == ["lower.material.hardening.back_stresses[0].modulus"]
    with pytest.raises(brinell.InputError, match="which is an axis, too"):
        _axes({"solver.max_evaluations": [50], "solver.max_iterations": [50]})


def test_passes_count_from_1(make_run: MakeRun) -> None:
    run = open_run(make_run(passes=2))
    assert [one["pass"][0] for one in run.history.passes()] == [1, 2]
    with pytest.raises(brinell.InputError, match="pass_ = 0; allowed: 1 or more"):
        brinell.plot.animate(run, pass_=0)


# --- Results of the old format ----------------------------------------------------------------------------------------


def _old_row(attributes: Any) -> None:
    attributes["iterations"] = attributes["evaluations"]
    del attributes["evaluations"]
    for name in ("pass", "place"):
        if name in attributes:
            attributes[name] = attributes[name] - 1


def _old_summary(summary: Mapping[str, Any]) -> dict[str, Any]:
    old = {**summary, "format_version": 2}
    if "evaluations" in summary["run"]:
        old["run"] = {**summary["run"], "iterations": summary["run"]["evaluations"]}
        del old["run"]["evaluations"]
    for indent in old.get("indents", []):
        indent["place"] -= 1
        indent["cycle"] -= 1
    for one in old.get("passes", []):
        del one["pass"]
    case = old["case"]
    if "max_evaluations" in case.get("solver", {}):
        case["solver"]["max_iterations"] = case["solver"].pop("max_evaluations")
    hardening = case.get("lower", {}).get("material", {}).get("hardening", {})
    if terms := hardening.pop("back_stresses", []):
        hardening["kinematic_moduli"] = [term["modulus"] for term in terms]
        hardening["kinematic_recall"] = [term["recall"] for term in terms]
    return old


def make_old(folder: Path) -> None:
    """Makes of a result what a program of format version 2 would have written."""
    with h5py.File(folder / "result.vtkhdf", "a") as file:
        file.attrs["format_version"] = 2
        file.move("history/evaluations", "history/iterations")
        for name in {"pass", "place"} & set(file["history"]):
            file[f"history/{name}"][...] = file[f"history/{name}"][...] - 1
        for state in [*(file["steps"][name] for name in file["steps"]), *([file["final"]] if "final" in file else [])]:
            _old_row(state.attrs)
        if "summary" in file:
            text = json.dumps(_old_summary(json.loads(file["summary"].asstr()[()])))
            del file["summary"]
            file["summary"] = text
    path = folder / "history.csv"
    table = pd.read_csv(path).rename(columns={"evaluations": "iterations"})
    for name in {"pass", "place"} & set(table):
        table[name] -= 1
    table.to_csv(path, index=False)
    if (folder / "summary.json").is_file():
        summary = json.loads((folder / "summary.json").read_text())
        (folder / "summary.json").write_text(json.dumps(_old_summary(summary)))


@pytest.mark.parametrize("finished", [True, False])
@pytest.mark.parametrize("scenario", ["tugging", "indentation", "rolling"])
def test_an_old_result_opens_under_the_new_names(
    make_run: MakeRun, make_indentation: MakeRun, make_rolling: MakeRun, scenario: str, finished: bool
) -> None:
    make = {"tugging": make_run, "indentation": make_indentation, "rolling": make_rolling}[scenario]
    options = {"cycles": 2, "places": (-0.1, 0.1)} if scenario == "indentation" else {"passes": 2}
    folder = make(finished=finished, **options)
    again = shutil.copytree(folder, folder.with_name("old"))
    make_old(again)
    assert "iterations" in (again / "history.csv").read_text()
    for new, old in ((folder, again), (folder / "result.vtkhdf", again / "result.vtkhdf")):
        expected, run = (open_run(path, allow_unfinished=True) for path in (new, old))
        assert sorted(run.history) == sorted(expected.history)  # in the order of the file
        for name, column in expected.history.items():
            np.testing.assert_array_equal(run.history[name], column)
        assert run.snapshot("aligned").row == expected.snapshot("aligned").row
        assert run.summary == expected.summary
        if finished:
            assert run.snapshot("final").pass_ == expected.snapshot("final").pass_ > 1
        if finished and scenario == "indentation":
            assert repr(run.indents) == repr(expected.indents)  # with NaN
        if finished and scenario == "rolling":
            assert repr(run.passes) == repr(expected.passes)


def test_the_case_of_an_old_result_has_the_keys_of_today(real_case: str, tmp_path: Path) -> None:
    terms = 'lower.material.hardening.back_stresses=[{modulus="20 GPa", recall=100}, {modulus=1e9, recall=0}]'
    run = brinell.Case(real_case, overrides=[terms]).run(tmp_path / "run")
    assert run.summary is not None
    make_old(tmp_path / "run")
    again = open_run(tmp_path / "run")
    assert "kinematic_moduli" in (tmp_path / "run" / "summary.json").read_text()
    assert again.summary == run.summary
    assert again.case("lower", "material", "hardening", "back_stresses")[1] == {"modulus": 1e9, "recall": 0.0}
    assert again.case("solver", "max_evaluations") == 60
    assert _core.FORMAT_VERSION == 3


def test_a_sweep_of_the_old_format_goes_on(real_case: str, tmp_path: Path) -> None:
    record = {
        "format": "brinell-sweep",
        "format_version": 1,
        "axes": {"solver.max_evaluations": {"values": [50]}},
        "design": "grid",
        "samples": None,
        "seed": None,
        "case": brinell.Case(real_case).to_toml(),
    }
    old = {
        **record,
        "axes": {"solver.max_iterations": {"values": [50]}},
        "case": record["case"].replace("max_evaluations", "max_iterations"),  # type: ignore[attr-defined]
    }
    (tmp_path / "sweep.json").write_text(json.dumps(old))
    assert start_folder(tmp_path, record, resume=True) == set()


def test_the_table_of_an_old_sweep_has_the_columns_of_today() -> None:
    old = {"solver.max_iterations": [50], "run.iterations": [300], "indents.0.cycle": np.array([0])}
    table = table_of_today(old)
    assert list(table) == ["solver.max_evaluations", "run.evaluations", "indents.0.cycle"]
    assert table["indents.0.cycle"].tolist() == [1]
    assert table_of_today(table) == table


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


def test_old_attributes_of_contacts_work_with_a_warning() -> None:
    grid = brinell.halfspace.SurfaceGrid(17, 17, 1e-6, 1e-6)
    steel = brinell.Material("210 GPa", 0.3)
    contact = brinell.contact.FrictionalContact(grid, steel, steel, friction=0.3)
    solved = contact.step((grid.x**2 + grid.y**2) / 2e-3, load=1e-3, force_x=1e-4)
    for owner, old, new in (
        (solved.contact, "area", "contact_area"),
        (solved.contact, "iterations", "contact_iterations"),
        (solved.tangential, "iterations", "contact_iterations"),
        (solved.tangential, "dissipated", "dissipation_friction"),
        (solved, "dissipated", "dissipation_friction"),
    ):
        with pytest.warns(FutureWarning, match=IS_NOW.format(old, new)):
            assert getattr(owner, old) == getattr(owner, new)
