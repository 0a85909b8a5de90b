# SPDX-License-Identifier: BSD-3-Clause
"""One case on several processes that mpi4py joins: the digits of one process, one voice, and errors that all have."""

import os
import shutil
import subprocess
import sys
from importlib.util import find_spec
from pathlib import Path

import h5py
import numpy as np
import pytest

import brinell

ROOT = Path(__file__).parents[2]
TEXT = (ROOT / "cases/tugging-heat/case.toml").read_text(encoding="utf-8")
FEW_CELLS = ["grid.resolution=3", 'output.snapshots="every 8"']
# As in tests/mpi/shared_runs.hpp: more processes than cores, on a machine that others use as well.
ENVIRONMENT = {
    "OMP_NUM_THREADS": "1",
    "OMPI_ALLOW_RUN_AS_ROOT": "1",
    "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1",
    "OMPI_MCA_rmaps_base_oversubscribe": "1",
    "OMPI_MCA_mpi_yield_when_idle": "1",
    "OMPI_MCA_hwloc_base_binding_policy": "none",
}
HEAD = f"""
import warnings
from pathlib import Path

import brinell
from mpi4py import MPI

comm = MPI.COMM_WORLD
rank = comm.Get_rank()
case = brinell.Case(Path("case.toml").read_text(), overrides={FEW_CELLS!r})


def say(*words):  # not to stdout, where lines of processes may mix
    with open(f"said-{{rank}}", "a") as file:
        print(*words, file=file)


"""

needs_mpi = pytest.mark.skipif(
    find_spec("mpi4py") is None or shutil.which("mpirun") is None,
    reason="mpi4py or mpirun is missing; make test-mpi installs both",
)


def started(folder: Path, ranks: int, script: str) -> subprocess.CompletedProcess[str]:
    """A script after HEAD, run by some processes."""
    (folder / "case.toml").write_text(TEXT, encoding="utf-8")
    (folder / "together.py").write_text(HEAD + script, encoding="utf-8")
    command = ["mpirun", "-n", str(ranks), sys.executable, "-W", "error::RuntimeWarning", "together.py"]
    return subprocess.run(
        command, cwd=folder, env=os.environ | ENVIRONMENT, capture_output=True, text=True, timeout=300, check=False
    )


def said(folder: Path, rank: int) -> list[str]:
    path = folder / f"said-{rank}"
    return path.read_text(encoding="utf-8").splitlines() if path.exists() else []


@pytest.fixture(scope="module")
def alone(tmp_path_factory: pytest.TempPathFactory) -> brinell.Run:
    return brinell.Case(TEXT, overrides=FEW_CELLS).run(tmp_path_factory.mktemp("alone"), threads=1)


def fields(folder: Path) -> dict[str, np.ndarray]:
    """All datasets of the stored steps and the end."""
    found: dict[str, np.ndarray] = {}
    with h5py.File(folder / "result.vtkhdf") as file:
        for group in ("steps", "final"):
            file[group].visititems(
                lambda name, item, group=group: (
                    found.update({f"{group}/{name}": item[()]}) if isinstance(item, h5py.Dataset) else None
                )
            )
    return found


@needs_mpi
@pytest.mark.parametrize("ranks", [2, 3])
def test_they_have_the_digits_of_one(tmp_path: Path, alone: brinell.Run, ranks: int) -> None:
    script = """
count = 0
def on_step(*_):
    global count
    count += 1

run = case.run("out", comm=comm, threads=1, progress=on_step)
say("steps", len(run.history["F_n"]), "told", count, "force", float(sum(run.history["F_n"])).hex())
"""
    done = started(tmp_path, ranks, script)
    assert done.returncode == 0, done.stderr
    steps, force = len(alone.history["F_n"]), float(sum(alone.history["F_n"])).hex()
    for rank in range(ranks):
        assert said(tmp_path, rank) == [f"steps {steps} told {steps if rank == 0 else 0} force {force}"]
    assert done.stdout == ""
    assert (tmp_path / "out/history.csv").read_bytes() == (alone.path / "history.csv").read_bytes()
    one, other = fields(alone.path), fields(tmp_path / "out")
    assert one.keys() == other.keys()
    assert len(one) > 10
    for name in one:
        np.testing.assert_array_equal(one[name], other[name], name)
    assert done.stderr.count("ResolutionWarning") == 1


@needs_mpi
def test_errors_are_raised_by_all(tmp_path: Path) -> None:
    script = """
Path("file").touch()
comm.Barrier()

def told(what, **arguments):
    try:
        case.run(comm=comm, **arguments)
    except brinell.BrinellError as error:
        say(what, type(error).__name__, error)

told("folder")
told("series", output="out", accuracy=0.1)
told("writing", output="file/out")
told("resume", output="out", resume=True)

def stops(step, *_):
    if step == 2:
        raise ValueError("the third step")

try:
    case.run("stopped", comm=comm, progress=stops)
except (ValueError, KeyboardInterrupt) as error:
    say("stopped", type(error).__name__)
run = case.run("stopped", comm=comm, resume=True)
say("resumed", len(run.history["F_n"]))
"""
    done = started(tmp_path, 2, script)
    assert done.returncode == 0, done.stderr
    whole = brinell.Case(TEXT, overrides=FEW_CELLS).run(tmp_path / "whole", threads=1)
    for rank in (0, 1):
        assert [line.split()[:2] for line in said(tmp_path, rank)] == [
            ["folder", "InputError"],
            ["series", "InputError"],
            ["writing", "IoError"],
            ["resume", "InputError"],
            ["stopped", "ValueError" if rank == 0 else "KeyboardInterrupt"],
            ["resumed", str(len(whole.history["F_n"]))],
        ]
    assert not (tmp_path / "out").exists()
    assert (tmp_path / "stopped/history.csv").read_bytes() == (whole.path / "history.csv").read_bytes()


@needs_mpi
def test_one_that_fails_alone_ends_all(tmp_path: Path) -> None:
    """As a full disk, of which the others hear nothing while they wait for numbers."""
    script = """
import resource, signal
signal.signal(signal.SIGXFSZ, signal.SIG_IGN)

def limit(step, *_):
    if step == 2:
        resource.setrlimit(resource.RLIMIT_FSIZE, (0, 0))

case.run("out", comm=comm, progress=limit)
say("has done it")
"""
    done = started(tmp_path, 2, script)
    assert done.returncode != 0
    assert said(tmp_path, 0) + said(tmp_path, 1) == []
    assert done.stderr.count("process 0 has failed") == 1
    assert "brinell.errors.IoError" in done.stderr
    assert not (tmp_path / "out/summary.json").exists()


def test_without_mpi4py_the_package_knows_nothing_of_it(tmp_path: Path) -> None:
    code = """
import sys
sys.modules["mpi4py"] = None  # as if it were not installed
import brinell
run = brinell.Case.from_file(sys.argv[1], sys.argv[2:]).run()
print(len(run.history["F_n"]), [name for name in sys.modules if name.startswith("mpi4py.") or name == "brinell._ranks"])
"""
    command = [sys.executable, "-c", code, str(ROOT / "cases/tugging-heat/case.toml"), *FEW_CELLS]
    done = subprocess.run(command, cwd=tmp_path, capture_output=True, text=True, check=True)
    assert done.stdout.split(" ", 1)[1].strip() == "[]"
