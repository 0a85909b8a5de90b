# SPDX-License-Identifier: BSD-3-Clause
"""The fields of one state of a result."""

import shutil
from collections.abc import Callable
from pathlib import Path

import h5py
import numpy as np
import pytest

from brinell.results import COMPONENTS, RunError, open_run

MakeRun = Callable[..., Path]


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


def test_aligned_of_an_indentation_is_its_first_largest_load(make_indentation: MakeRun) -> None:
    run = open_run(make_indentation(cycles=2, steps=8))
    assert run.steps == [7, 15, 23, 31]
    snapshot = run.snapshot("aligned")
    assert (snapshot.step, snapshot.pass_) == (7, 1)
    assert snapshot.in_contact


def test_aligned_of_rolling_is_the_middle_of_the_first_pass(make_rolling: MakeRun) -> None:
    snapshot = open_run(make_rolling()).snapshot("aligned")
    assert (snapshot.pass_, snapshot.row["x"]) == (1, pytest.approx(0.0))


def test_rigid_body_has_no_fields(make_indentation: MakeRun) -> None:
    snapshot = open_run(make_indentation()).snapshot("aligned", tensors=True)
    assert snapshot.upper.is_rigid
    assert snapshot.upper.x.size == snapshot.upper.equivalent_plastic_strain.size == 0
    assert snapshot.upper.von_mises_stress is None
    assert snapshot.upper.stress == {}
    assert not snapshot.lower.is_rigid


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


def test_step_that_is_not_stored(make_run: MakeRun) -> None:
    with pytest.raises(RunError, match=r"step 7 is not stored \(stored: 6, 12\)"):
        open_run(make_run()).snapshot(7)
