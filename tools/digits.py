#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Whether a change keeps every digit: histories and fields of all cases, by two programs.

    tools/digits.py against COMMIT [--only NAME...] [--jobs N] [--within R] [--energies-within R]
    tools/digits.py run PROGRAM FOLDER [--only NAME...] [--jobs N]
    tools/digits.py compare BEFORE AFTER [--within R] [--energies-within R]

`run` computes each of cases/ with one thread and with two into FOLDER. `compare` reads two such folders: it exits with 1
if a case or a name has come or gone or a number is another one or, with the options, differs by more than R of the
largest magnitude in its column or dataset. `against` builds COMMIT and the working tree with the preset `digits` and does both;
what it needs lies in build/digits.

The preset does not let the compiler contract products and sums to one instruction: it does so as it likes, and a
function that merely moves to another file would change its last digits. Equality is then a property of the source.
"""

import argparse
import concurrent.futures
import hashlib
import shutil
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path

import h5py
import numpy as np

ROOT = Path(__file__).resolve().parents[1]
CASES = sorted(path.parent.name for path in ROOT.glob("cases/*/case.toml"))
THREADS = (1, 2)
WORDS_OF_ENERGIES = ("work", "energy", "dissipation", "heat")


def run(program: Path, folder: Path, only: list[str], jobs: int) -> None:
    """Results of all cases, in FOLDER/<threads>/<case>; those that are there already stay."""
    wanted = [(name, threads) for name in CASES for threads in THREADS if not only or name in only]

    def one(name: str, threads: int) -> None:
        output = folder / str(threads) / name
        if (output / "summary.json").exists():
            return
        case = ROOT / "cases" / name / "case.toml"
        command = [program, "run", "--quiet", "--threads", str(threads), case, "-o", output]
        done = subprocess.run([str(word) for word in command], capture_output=True, text=True)
        if done.returncode != 0:
            sys.exit(f"digits: {name} failed with {program}: {done.stderr.strip()}")

    with concurrent.futures.ThreadPoolExecutor(jobs) as pool:
        for future in [pool.submit(one, *pair) for pair in wanted]:
            future.result()


def history(path: Path) -> Iterator[tuple[str, np.ndarray]]:
    """Columns of history.csv as texts, so that a digit that is printed otherwise shows."""
    lines = [line for line in path.read_text(encoding="utf-8").splitlines() if not line.startswith("#")]
    rows = [line.split(",") for line in lines]
    for name, *column in zip(*rows, strict=True):
        yield f"history {name}", np.array(column)


def datasets(path: Path) -> Iterator[tuple[str, np.ndarray]]:
    """All numeric datasets of a result file, without what tells when and by which program."""
    found: list[tuple[str, np.ndarray]] = []

    def visit(name: str, node: object) -> None:
        if isinstance(node, h5py.Dataset) and node.dtype.kind in "fiub":
            found.append((name, node[()]))

    with h5py.File(path) as file:
        file.visititems(visit)
    yield from found


def numbers(folder: Path) -> dict[str, np.ndarray]:
    """All that a result holds, by name."""
    found = dict(history(folder / "history.csv"))
    for path in sorted(folder.rglob("*.vtkhdf")):
        found.update((f"{path.relative_to(folder)} {name}", values) for name, values in datasets(path))
    return found


def difference(before: np.ndarray, after: np.ndarray) -> float:
    """Largest difference as a part of the largest magnitude; 0 means the same bits, infinity another shape."""
    if before.shape != after.shape:
        return np.inf
    if before.tobytes() == after.tobytes():
        return 0.0
    try:
        a, b = before.astype(float), after.astype(float)
    except ValueError:
        return np.inf
    if not np.array_equal(np.isfinite(a), np.isfinite(b)):
        return np.inf
    finite = np.isfinite(a)
    size = max(np.abs(a[finite]).max(initial=0.0), np.abs(b[finite]).max(initial=0.0))
    part = float(np.abs(a[finite] - b[finite]).max(initial=0.0) / size) if size > 0.0 else 0.0
    return max(part, float(np.spacing(0.0)))  # also where only a sign of zero differs, or how a number is printed


def compare(before: Path, after: Path, within: float, energies_within: float) -> int:
    """Prints what differs; the number of names that differ by more than is allowed."""
    refused = differing = compared = 0
    digest = hashlib.sha256()
    there = [{path.parent.relative_to(folder) for path in folder.glob("*/*/summary.json")} for folder in (before, after)]
    for result in sorted(there[0] | there[1]):
        if not all(result in results for results in there):
            print(f"{result}: only {'after' if result in there[1] else 'before'}")
            refused += 1
            continue
        old, new = numbers(before / result), numbers(after / result)
        worst: tuple[float, str] = (0.0, "")
        for name in sorted(old.keys() | new.keys()):
            if name not in old or name not in new:
                print(f"{result}: {name}: only {'after' if name in new else 'before'}")
                refused += 1
                continue
            compared += 1
            digest.update(new[name].tobytes())
            part = difference(old[name], new[name])
            is_energy = any(word in name.lower() for word in WORDS_OF_ENERGIES)
            differing += part > 0.0
            refused += part > (energies_within if is_energy else within)
            worst = max(worst, (part, name))
        if worst[0] > 0.0:
            print(f"{result}: largest difference {worst[0]:.1e}, {worst[1]}")
    print(
        f"digits: {compared} columns and datasets, {differing} differ, {refused} refused; sha256 {digest.hexdigest()[:16]}"
    )
    return refused


def build(source: Path) -> Path:
    """The program of a tree of sources, built with the preset."""
    subprocess.run(["cmake", "--preset", "digits"], cwd=source, check=True, stdout=subprocess.DEVNULL)
    command = ["cmake", "--build", "--preset", "digits", "--target", "brinell_program"]
    subprocess.run(command, cwd=source, check=True, stdout=subprocess.DEVNULL)
    return source / "build" / "digits" / "bin" / "brinell"


def against(commit: str, only: list[str], jobs: int, allowed: tuple[float, float]) -> int:
    """Builds and computes a commit and the working tree, and compares. What is there of a commit is kept."""
    git = ["git", "-C", str(ROOT)]
    name = subprocess.run([*git, "rev-parse", "--short=12", commit], check=True, capture_output=True, text=True).stdout
    place = ROOT / "build" / "digits" / name.strip()
    source, results = place / "source", ROOT / "build" / "digits" / "results"
    if not source.exists():
        source.mkdir(parents=True)
        archive = subprocess.run([*git, "archive", commit], check=True, capture_output=True).stdout
        subprocess.run(["tar", "-x", "-C", str(source)], input=archive, check=True)
        shutil.copy(ROOT / "CMakePresets.json", source)  # an earlier commit may not have the preset
    run(build(source), place / "results", only, jobs)
    shutil.rmtree(results, ignore_errors=True)
    run(build(ROOT), results, only, jobs)
    return compare(place / "results", results, *allowed)


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    commands = parser.add_subparsers(dest="command", required=True)
    runs = argparse.ArgumentParser(add_help=False)
    runs.add_argument("--only", nargs="+", default=[], choices=CASES, metavar="NAME", help="these cases")
    runs.add_argument("--jobs", type=int, default=1, help="runs at a time")
    limits = argparse.ArgumentParser(add_help=False)
    limits.add_argument("--within", type=float, default=0.0, help="part of the largest magnitude of each column")
    limits.add_argument("--energies-within", type=float, default=0.0, help="the same for works, energies and heat")
    one = commands.add_parser("run", parents=[runs])
    one.add_argument("program", type=Path)
    one.add_argument("folder", type=Path)
    two = commands.add_parser("compare", parents=[limits])
    two.add_argument("before", type=Path)
    two.add_argument("after", type=Path)
    commands.add_parser("against", parents=[runs, limits]).add_argument("commit")
    given = parser.parse_args()
    if given.command == "run":
        run(given.program.resolve(), given.folder, given.only, given.jobs)
        return 0
    allowed = (given.within, given.energies_within)
    if given.command == "compare":
        return bool(compare(given.before, given.after, *allowed))
    return bool(against(given.commit, given.only, given.jobs, allowed))


if __name__ == "__main__":
    sys.exit(main())
