#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Convergence of a tugging case with mesh and step: runs it refined and prints the tables of docs/verification/accuracy.md.

    tools/convergence.py [--program build/release/bin/brinell] [--case cases/tugging-paper/case.toml]
                         [--refine 1 2 4] [--steps 1] [--threads 1]

`refine` divides dx, dy and dz of the case, and should double from mesh to mesh; `steps` are shifts per step in cells of the
refined mesh. Order and limit follow from the last three meshes (Aitken); where these do not show an order above 1/2 yet,
the limit takes the first order. Percentages are the distance from the limit.
"""

from __future__ import annotations

import argparse
import json
import math
import os
import subprocess
import sys
import tempfile
import tomllib
from pathlib import Path

QUANTITIES = {
    "peak F_X / P_c": "peak_F_X",
    "F_X(0) / P_c": "F_X_aligned",
    "min F_X / P_c": "min_F_X",
    "F_Z(0) / P_c": "F_Z_aligned",
    "net energy / U_c": "net_energy",
    "largest residual displacement / alpha_c": "max_residual_lower",
}


def run(options: argparse.Namespace, refine: float, step: float) -> dict:
    """Runs one mesh. @returns the summary, with the largest memory of the process [MB] as `memory`."""
    with tempfile.TemporaryDirectory() as folder:
        resolved = subprocess.run(
            [options.program, "check", options.case], capture_output=True, text=True, check=True
        ).stdout
        grid = tomllib.loads(resolved)["grid"]
        if "spacing" not in grid:
            sys.exit(f"{options.case} has no grid.spacing to refine")
        spacing = [length / refine for length in grid["spacing"]]
        command = [options.program, "run", options.case, "-o", folder, "--quiet", "--threads", str(options.threads)]
        command += ["--set", f"grid.spacing={spacing}", "--set", f"tugging.shift={spacing[0] * step}"]
        command += ["--set", "output.snapshots=none"]
        process = subprocess.Popen(command)
        _, status, usage = os.wait4(process.pid, 0)
        if status != 0:
            sys.exit(f"{' '.join(command)} failed")
        summary = json.loads((Path(folder) / "summary.json").read_text())
        summary["memory"] = usage.ru_maxrss / 1e3
        return summary


def extrapolated(values: list[float]) -> tuple[str, float]:
    """@returns observed order in the cell, as text, and limit, for cells that halve from value to value."""
    ratio = 0.0
    if len(values) >= 3 and values[-1] != values[-2]:
        ratio = (values[-2] - values[-3]) / (values[-1] - values[-2])
    order = f"{math.log2(ratio):.1f}" if ratio > 1.0 else "-"
    if ratio < math.sqrt(2.0):
        ratio = 2.0
    return order, values[-1] + ((values[-1] - values[-2]) / (ratio - 1.0) if len(values) > 1 else 0.0)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--program", default="build/release/bin/brinell")
    parser.add_argument("--case", default="cases/tugging-paper/case.toml")
    parser.add_argument("--refine", type=float, nargs="+", default=[1, 2, 4])
    parser.add_argument("--steps", type=float, nargs="+", default=[1])
    parser.add_argument("--threads", type=int, default=1)
    options = parser.parse_args()

    for step in options.steps:
        runs = [run(options, refine, step) for refine in options.refine]
        header = [f"dx/{refine:g}" for refine in options.refine]
        print(f"\nShift {step:g} cells per step:\n")
        print("| " + " | ".join(["quantity", *header, "order", "limit"]) + " |")
        print("| --- " * (len(header) + 3) + "|")
        for name, key in QUANTITIES.items():
            values = [summary["normalised"][key] for summary in runs]
            order, limit = extrapolated(values)
            cells = [f"{v:.5g} ({100 * (v / limit - 1):+.1f} %)" for v in values]
            print("| " + " | ".join([name, *cells, order, f"{limit:.5g}"]) + " |")
        rows = {
            "energy balance": [f"{100 * s['energy']['balance_error']:+.2f} %" for s in runs],
            "evaluations per step": [f"{s['run']['evaluations'] / s['run']['steps']:.1f}" for s in runs],
            "time": [f"{s['run']['wall_time_s']:.3g} s" for s in runs],
            "memory": [f"{s['memory']:.0f} MB" for s in runs],
        }
        for name, cells in rows.items():
            print("| " + " | ".join([name, *cells, "", ""]) + " |")


if __name__ == "__main__":
    main()
