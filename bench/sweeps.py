#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""What does a run of a sweep cost beside the engine? Usage: .venv/bin/python bench/sweeps.py local|dask|slurm [RUNS]

Processor time of all processes that the sweep starts, wherever they end up, less that of the engine within them: so a busy
machine changes little. The engine is the call that computes a case in memory, from its plan to the image of its results. The gaps
between such calls in a process are wall times, of which the median is worth something on a busy machine, too.
Slurm is that of the tests, one node with its daemons on this machine, as root.
"""

import contextlib
import ctypes
import os
import resource
import sys
import tempfile
import time
import warnings
from contextlib import ExitStack
from pathlib import Path
from typing import Any

import brinell
from brinell.sweeps import Slurm
from brinell.sweeps.clusters import Cluster

sys.path.insert(0, str(Path(__file__).parents[1] / "python" / "tests"))
from slurm_here import slurm_here
from sweep_case import CASE


def processor_time() -> float:
    """Of this process and of its descendants that have ended [s]."""
    used = [resource.getrusage(who) for who in (resource.RUSAGE_SELF, resource.RUSAGE_CHILDREN)]
    return sum(one.ru_utime + one.ru_stime for one in used)


def reap() -> None:
    """Waits for descendants whose parents have ended: they are this process's own (`main`). Python's tracker stays."""
    end = time.monotonic() + 10
    with contextlib.suppress(ChildProcessError):
        while time.monotonic() < end:
            if os.waitpid(-1, os.WNOHANG)[0] == 0:
                time.sleep(0.1)


def main() -> None:
    """Prints the shares."""
    way, runs = sys.argv[1], int(sys.argv[2]) if len(sys.argv) > 2 else 1000
    ctypes.CDLL(None).prctl(36, 1, 0, 0, 0)  # PR_SET_CHILD_SUBREAPER
    warnings.simplefilter("ignore")  # of few cells
    options: dict[str, Any] = {
        "numbers": f"{Path(__file__).resolve().with_name('sweep_times.py')}:times",
        "keep": "none",
        "threads": 1,
    }
    if way == "dask":
        options["cluster"] = Cluster(
            "LocalCluster", {"n_workers": 2, "threads_per_worker": 1, "dashboard_address": None}
        )
    with tempfile.TemporaryDirectory() as folder:
        with ExitStack() as stack:
            if way == "slurm":
                stack.enter_context(slurm_here(Path(folder) / "slurm", largest_array=1001))
                options["submit"] = Slurm(chunk=50)  # ten thousand in 200 tasks
            start, began = processor_time(), time.monotonic()
            over = {"tugging.interference": f"0.5:2:{runs}"}
            table = brinell.sweep(
                brinell.Case(CASE), over, output=Path(folder) / "sweep", progress=False, **options
            ).table
            wall = time.monotonic() - began
        reap()
        total = processor_time() - start
    assert (table["status"] == "done").all(), table["reason"].unique()
    engine = table["processor"].mean()
    ordered = table.dropna(subset="began").sort_values("began")
    gaps = (ordered["began"] - ordered.groupby("process")["ended"].shift()).dropna()
    print(
        f"{way}: {runs} runs, {table['process'].nunique()} processes, {wall:.0f} s; processor {1e3 * total / runs:.1f} ms a run, "
        f"engine {1e3 * engine:.1f} ms (its steps {1e3 * table['run.wall_time_s'].median():.1f} ms), "
        f"beside it {1e3 * (total / runs - engine):.1f} ms; gap between two runs of a process: "
        f"median {1e3 * gaps.median():.1f} ms, mean {1e3 * gaps.mean():.1f} ms"
    )


if __name__ == "__main__":
    main()
