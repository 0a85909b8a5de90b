#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""What does a scenario cost from Python, compared with the program? Usage: .venv/bin/python bench/python.py [REPEATS]

Both run the paper's case on cells refined by 1.5, by turns, on one thread; the smallest times are compared. That of Python is the
whole call, with the results written and opened; that of the program the whole process.
"""

import subprocess
import sys
import tempfile
import time
from pathlib import Path

import brinell

ROOT = Path(__file__).resolve().parents[1]
CASE = ROOT / "cases" / "tugging-paper" / "case.toml"
OVERRIDES = ["grid.spacing=['2.5 mm', '4.2 mm', '1.7 mm']", "output.checkpoint_interval=1e6"]


def of_program(folder: Path) -> float:
    """Seconds of ``brinell run``."""
    sets = [word for override in OVERRIDES for word in ("--set", override)]
    start = time.perf_counter()
    subprocess.run(
        [ROOT / "build/release/bin/brinell", "run", CASE, *sets, "-o", folder, "--threads", "1", "-q"], check=True
    )
    return time.perf_counter() - start


def of_python(folder: Path) -> float:
    """Seconds of `Case.run`."""
    start = time.perf_counter()
    brinell.Case.from_file(CASE, OVERRIDES).run(folder, threads=1)
    return time.perf_counter() - start


def main() -> None:
    """Prints both times and their ratio."""
    repeats = int(sys.argv[1]) if len(sys.argv) > 1 else 5
    with tempfile.TemporaryDirectory() as folder:
        times = [(of_program(Path(folder) / "a"), of_python(Path(folder) / "b")) for _ in range(repeats)]
    program, python = (min(each) for each in zip(*times, strict=True))
    print(f"program {program:.3f} s, Python {python:.3f} s, ratio {python / program:.4f} (smallest of {repeats})")


if __name__ == "__main__":
    main()
