#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""What does a small run in memory cost beside its steps? Usage: .venv/bin/python bench/small_run.py [REPEATS]

The run reads the case, plans, writes its result into memory and opens it; `Case.steps` takes the same steps and keeps
nothing. By turns, on one thread; the smallest times of the processor are compared. 1 would be a run that costs nothing
besides. The same run through a folder shows what loops of small runs save.
"""

import sys
import tempfile
import time
import warnings
from collections.abc import Callable
from pathlib import Path

import brinell

STEEL = brinell.Material("210 GPa", 0.3, brinell.Linear("600 MPa", "2 GPa"))
BALL = brinell.Body(brinell.Sphere("10 um"), STEEL)


def case() -> brinell.Case:
    """One that is solved in a moment."""
    few, none = brinell.Grid(resolution=3), brinell.Output(snapshots="none")
    return brinell.Tugging(BALL, BALL, interference=1.05, grid=few, output=none)


def seconds(work: Callable[[], object]) -> float:
    """Of the processor."""
    start = time.process_time()
    work()
    return time.process_time() - start


def main() -> None:
    """Prints the times and their ratios."""
    repeats = int(sys.argv[1]) if len(sys.argv) > 1 else 20
    warnings.simplefilter("ignore")  # of few cells
    with tempfile.TemporaryDirectory() as folder:
        times = [
            (
                seconds(lambda: list(case().steps())),
                seconds(lambda: case().run(in_memory=True, threads=1)),
                seconds(lambda: case().run(Path(folder) / "run", threads=1)),
            )
            for _ in range(repeats)
        ]
    steps, memory, disk = (min(each) for each in zip(*times, strict=True))
    print(
        f"steps {1e3 * steps:.1f} ms; run in memory {1e3 * memory:.1f} ms, ratio {memory / steps:.2f}; "
        f"through a folder {1e3 * disk:.1f} ms, ratio {disk / steps:.2f} (smallest of {repeats})"
    )


if __name__ == "__main__":
    main()
