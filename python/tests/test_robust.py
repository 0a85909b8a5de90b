# SPDX-License-Identifier: BSD-3-Clause
"""What is hostile, damaged or absurd ends in a clear error, never in a wrong number or a process that hangs."""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path
from typing import Any

import h5py
import numpy as np
import pytest

import brinell
from brinell import RunError
from brinell.sweeps.folder import start_folder, without_formulas

MakeRun = Callable[..., Path]

FORKING = """
import multiprocessing, sys
import numpy as np
import brinell
from brinell.halfspace import HalfSpace, SurfaceGrid, VolumeGrid

body = HalfSpace(VolumeGrid(SurfaceGrid(32, 32, 1e-6, 1e-6), 16, 1e-6), brinell.Material("210 GPa", 0.3))
strain = np.zeros((6, 16, 32, 32))
strain[5] = 1e-3
before = body.eigenstrain_to_stress(strain)

def compute():
    later = HalfSpace(VolumeGrid(SurfaceGrid(16, 16, 1e-6, 1e-6), 4, 1e-6), brinell.Material("210 GPa", 0.3))
    later.pressure_to_stress(np.ones((16, 16)))
    sys.exit(0 if np.array_equal(body.eigenstrain_to_stress(strain), before) else 3)

child = multiprocessing.get_context("fork").Process(target=compute)
child.start()
child.join(30)
if child.is_alive():
    child.kill()
    sys.exit("the child hangs")
assert np.array_equal(body.eigenstrain_to_stress(strain), before)
sys.exit(child.exitcode)
"""


def test_forked_child_computes(tmp_path: Path) -> None:
    """The threads of the parent are not in the child, which waited for them for ever."""
    script = tmp_path / "forking.py"
    script.write_text(FORKING)
    environment = os.environ | {"OMP_NUM_THREADS": "3"}
    done = subprocess.run([sys.executable, script], env=environment, timeout=120, capture_output=True, text=True)
    assert done.returncode == 0, done.stderr


@pytest.mark.parametrize("where", ["output", "case"])
def test_files_of_others_stay(tmp_path: Path, real_case: str, where: str) -> None:
    mine = tmp_path / "mine"
    (mine / "snapshots").mkdir(parents=True)
    (mine / "snapshots" / "2024.txt").write_text("mine")
    (mine / "summary.json").write_text("{}")
    case = brinell.Case(real_case).with_values({"output.directory": str(mine)} if where == "case" else {})
    folder = case._core.default_folder if where == "case" else mine
    with pytest.raises(brinell.InputError, match=r"holds other files: summary\.json"):
        case.run(folder)
    assert (mine / "summary.json").read_text() == "{}"
    assert (mine / "snapshots" / "2024.txt").read_text() == "mine"
    assert sorted(path.name for path in mine.iterdir()) == ["snapshots", "summary.json"]


@pytest.mark.parametrize("name", ["table.csv", "table.parquet", "failures.json"])
def test_sweep_replaces_no_files_of_others(tmp_path: Path, name: str) -> None:
    (tmp_path / name).write_text("mine")
    with pytest.raises(brinell.InputError, match=rf"holds other files: {name}"):
        start_folder(tmp_path, {}, resume=True)
    assert (tmp_path / name).read_text() == "mine"
    assert not (tmp_path / "sweep.json").exists()


def test_table_has_no_formulas(tmp_path: Path) -> None:
    """A spreadsheet computes what begins with one of these."""
    import pandas as pd

    frame = pd.DataFrame({"title": ["=cmd|' /C calc'!A0", "@x", "+1+1", "-2+3", "plain", "-1.5"], "x": [-1.0] * 6})
    told = without_formulas(frame)
    assert told["title"].tolist() == ["'=cmd|' /C calc'!A0", "'@x", "'+1+1", "'-2+3", "plain", "-1.5"]
    assert told["x"].tolist() == [-1.0] * 6
    assert frame["title"][0].startswith("="), "the frame itself is as it was"


def test_history_that_was_cut_is_told(real_folder: Path, tmp_path: Path) -> None:
    folder = shutil.copytree(real_folder, tmp_path / "cut")
    history = folder / "history.csv"
    lines = history.read_text().splitlines(keepends=True)
    steps = len(lines) - 1
    for kept in (
        lines[:-1],
        lines[:5],
        [*lines[:4], *lines[5:]],
        [*lines, lines[-1]],
        [*lines[:3], lines[4], lines[3]],
    ):
        history.write_text("".join(kept))
        with pytest.raises(RunError, match=rf"history\.csv: has {len(kept) - 1} rows, the run had {steps} steps"):
            brinell.open(folder)
    assert brinell.open(folder / "result.vtkhdf").history.steps == steps


def _replace_dataset(file: h5py.File, name: str, value: Any) -> None:
    del file[name]
    file[name] = value


DAMAGE: dict[str, Callable[[h5py.File], object]] = {
    "version": lambda f: f.attrs.__setitem__("format_version", "x"),
    "versions": lambda f: f.attrs.__setitem__("format_version", [3, 3]),
    "format": lambda f: f.attrs.__setitem__("format", 3.0),
    "case": lambda f: _replace_dataset(f, "case", 1.5),
    "case as a group": lambda f: (f.__delitem__("case"), f.create_group("case")),
    "sources": lambda f: _replace_dataset(f, "sources", [1, 2]),
    "case in another coding": lambda f: _replace_dataset(f, "case", np.bytes_(b"\xff\xfe")),
    "step": lambda f: f.create_group("steps/abc"),
    "steps": lambda f: _replace_dataset(f, "steps", 3),
    "step as numbers": lambda f: _replace_dataset(f, "steps/000004", [1.0]),
    "loop": lambda f: (f.__delitem__("steps/000004"), f.__setitem__("steps/000004", h5py.SoftLink("/steps/000004"))),
    "spacing": lambda f: f["steps/000004/lower"].attrs.__setitem__("spacing", [1.0]),
    "spacing of the contact": lambda f: f["steps/000004/contact"].attrs.__setitem__("spacing", 1.0),
    "origin": lambda f: f["steps/000004/lower"].attrs.__setitem__("origin", "here"),
    "pressure": lambda f: _replace_dataset(f, "steps/000004/contact/pressure", "text"),
    "pressure of one row": lambda f: _replace_dataset(f, "steps/000004/contact/pressure", [1.0]),
    "final": lambda f: _replace_dataset(f, "final", [1.0]),
    "step of the final state": lambda f: f["final"].attrs.__setitem__("step", "last"),
    "history": lambda f: _replace_dataset(f, "history", [1.0]),
    "column": lambda f: _replace_dataset(f, "history/F_X", "text"),
    "column of one number": lambda f: _replace_dataset(f, "history/F_X", 1.0),
}


@pytest.mark.parametrize("what", DAMAGE)
def test_damaged_results_are_told_by_one_error(real_folder: Path, tmp_path: Path, what: str) -> None:
    """Not by whatever h5py and NumPy raise; and the error names the file."""
    file = shutil.copy(real_folder / "result.vtkhdf", tmp_path / "damaged.vtkhdf")
    with h5py.File(file, "a") as opened:
        DAMAGE[what](opened)

    def read_all() -> None:
        run = brinell.open(file)
        _ = run.case_text, run.sources, run.steps
        for step in [*run.steps, "final", "aligned"]:
            run.snapshot(step, tensors=True)
        for body in ("lower", "upper"):
            for name in run.field_names(body):
                _ = run.field(body, name).values

    with pytest.raises(RunError, match=r"damaged\.vtkhdf"):
        read_all()


@pytest.mark.filterwarnings("ignore")
def test_random_damage_of_results(real_folder: Path, tmp_path: Path) -> None:
    whole = (real_folder / "result.vtkhdf").read_bytes()
    random = np.random.default_rng(1)
    file = tmp_path / "damaged.vtkhdf"
    refused = 0
    for _ in range(40):
        content = np.frombuffer(whole, dtype=np.uint8).copy()
        content[random.integers(0, min(len(content), 60_000), 20)] = random.integers(0, 256, 20)
        file.write_bytes(content.tobytes())
        try:
            run = brinell.open(file)
            _ = run.case_text, run.sources, run.steps, run.snapshot("final"), run.field("lower", "pressure").values
        except RunError:
            refused += 1
    assert 0 < refused <= 40, "any other error ends the test"


def test_masked_arrays_are_refused() -> None:
    """What lies under a mask is no measurement."""
    masked = np.ma.masked_array(np.full((3, 3), 7.0), mask=np.eye(3))
    with pytest.raises(brinell.InputError, match="3 masked values"):
        brinell.HeightMap(masked, (1e-6, 1e-6))
    grid = brinell.halfspace.SurfaceGrid(3, 3, 1e-6, 1e-6)
    steel = brinell.Material("210 GPa", 0.3)
    with pytest.raises(brinell.InputError, match="pressure has 3 masked values"):
        brinell.halfspace.SurfaceCompliance(grid, steel).pressure_to_displacement(masked)
    with pytest.raises(brinell.InputError, match="masked"):
        brinell.contact.ElasticContact(grid, steel).solve(masked, load=1.0)
    with pytest.raises(brinell.InputError, match="masked"):
        brinell.constitutive.return_mapping(steel, masked)
    with pytest.raises(brinell.InputError):
        brinell.Body(brinell.Flat(), brinell.Material("210 GPa", 0.3, brinell.Table(masked[0], masked[0]))).to_case()
    with pytest.raises(brinell.InputError, match="masked"):
        brinell.Material("210 GPa", 0.3, lambda e: np.ma.masked_array([1e9], mask=[True]))
    unmasked = np.ma.masked_array(np.full((3, 3), 7.0), mask=np.zeros((3, 3)))
    assert brinell.HeightMap(unmasked, (1e-6, 1e-6)).heights.sum() == 63.0


def test_absurd_grids_are_refused_at_once() -> None:
    from brinell.halfspace import HalfSpace, SurfaceCompliance, SurfaceGrid, VolumeGrid

    steel = brinell.Material("210 GPa", 0.3)
    with pytest.raises(brinell.InputError, match=r"8\.0e\+12 cells needs some .* GB, this machine has"):
        HalfSpace(VolumeGrid(SurfaceGrid(20000, 20000, 1, 1), 20000, 1), steel)
    with pytest.raises(brinell.InputError, match=r"1\.0e\+10 cells needs"):
        SurfaceCompliance(SurfaceGrid(100_000, 100_000, 1, 1), steel)
    yielding = brinell.Material("210 GPa", 0.3, brinell.Perfect("1 GPa"))
    surface = SurfaceGrid(20000, 20000, 1, 1)
    volume = VolumeGrid(surface, 20000, 1)
    with pytest.raises(brinell.InputError, match=r"cells needs"):
        brinell.elastoplastic.CoupledContact(surface, volume, volume, yielding, brinell.RIGID, scale=1.0)
    for size in (5e-324, 1e-310, 1e-31, 1e31):
        with pytest.raises(brinell.InputError, match="of a grid; allowed: a length from 1e-30 to 1e"):
            SurfaceGrid(3, 3, size, 1.0)


@pytest.mark.parametrize("name", ["pipe", "/dev/zero"])
def test_files_without_end_are_refused(tmp_path: Path, name: str) -> None:
    path = tmp_path / name
    if name == "pipe":
        os.mkfifo(path)
    with pytest.raises(brinell.InputError, match="is a device or a pipe"):
        brinell.Case.from_file(path)
    with pytest.raises(brinell.IoError, match="no such file"):
        brinell.surfaces.read(path, spacing=(1, 1))


def test_deep_keys_are_refused(tmp_path: Path, real_case: str) -> None:
    path = tmp_path / "deep.toml"
    path.write_text("a." * 40000 + "a = 1\n")
    with pytest.raises(brinell.InputError, match=r"deep\.toml:1: a key of more than 30 parts"):
        brinell.Case.from_file(path)
    with pytest.raises(brinell.InputError, match="a key of more than 30 parts"):
        brinell.Case(real_case).with_values(["a." * 40000 + "a=1"])


def test_text_of_heights_may_begin_with_the_mark_of_utf8(tmp_path: Path) -> None:
    path = tmp_path / "map.csv"
    path.write_bytes(b"\xef\xbb\xbf1,2\n3,4\n")
    assert brinell.surfaces.read(path, spacing=(1, 1)).heights.tolist() == [[1, 2], [3, 4]]
    for name in ("map.npy", "map.npz"):
        (tmp_path / name).write_bytes(b"no array")
        with pytest.raises(brinell.InputError, match=rf"{name}: is no file of NumPy arrays"):
            brinell.surfaces.read(tmp_path / name, spacing=(1, 1))


def test_command_line_that_is_not_utf8(tmp_path: Path, real_case: str) -> None:
    (tmp_path / "case.toml").write_text(real_case)
    program = [sys.executable, "-m", "brinell", "check", "case.toml", "--set", b"title=a\xffb"]
    done = subprocess.run(program, cwd=tmp_path, capture_output=True, timeout=60)
    assert done.returncode == 2
    assert b"not UTF-8" in done.stderr
    assert b"Traceback" not in done.stderr
