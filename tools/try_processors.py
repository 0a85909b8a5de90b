# SPDX-License-Identifier: BSD-3-Clause
"""Checks that an installed package computes the same with the instructions of every kind of processor that this machine is.

tools/package.sh runs it, away from the sources. Runs the templates of all scenarios by the command line.
"""

import os
import subprocess
import tempfile
from pathlib import Path

import numpy as np

import brinell
from brinell import _core

SCENARIOS = ("tugging", "indentation", "rolling", "fretting", "sliding")
COARSE = ("--set", "grid.resolution=4", "--quiet")
# The order of sums differs, and iterations end at a tolerance: the numbers agree to this fraction of the largest of a column.
AGREE = 1e-6


def command(kind: str, *words: str) -> str:
    """Output of the command; `kind` is what the processor is taken for."""
    environment = os.environ | {"BRINELL_PROCESSOR": kind}
    result = subprocess.run(["brinell", *words], env=environment, capture_output=True, text=True)
    if result.returncode != 0:
        raise SystemExit(f"brinell {' '.join(words)} with {kind}: {result.stderr}")
    return result.stdout


def history(kind: str, case: Path, folder: Path) -> dict[str, np.ndarray]:
    """Columns of a run."""
    command(kind, "run", str(case), *COARSE, "-o", str(folder))
    columns = brinell.open(folder).history
    return {name: np.asarray(columns[name], dtype=float) for name in ("F_n", "F_X", "load", "work", "max_pressure", "dissipation_lower")
            if name in columns}


def main() -> None:
    """Prints one line per kind."""
    kinds = [kind for kind in _core.compiled_processors() if runs_here(kind)]
    with tempfile.TemporaryDirectory() as folder:
        expected: dict[str, dict[str, np.ndarray]] = {}
        for kind in kinds:
            assert kind in command(kind, "--version")
            difference = 0.0
            for scenario in SCENARIOS:
                case = Path(folder, f"{scenario}.toml")
                if not case.exists():
                    command(kind, "new", scenario, "-o", str(case))
                found = history(kind, case, Path(folder, f"{scenario}-{kind}"))
                for name, values in found.items():
                    wanted = expected.setdefault(scenario, found)[name]
                    scale = np.abs(wanted).max() or 1.0
                    difference = max(difference, float(np.abs(values - wanted).max() / scale))
            print(f"{kind}: {len(SCENARIOS)} scenarios, largest difference {difference:.1e}")
            assert difference < AGREE
    refused = subprocess.run(["brinell", "--version"], env=os.environ | {"BRINELL_PROCESSOR": "z80"}, capture_output=True, text=True)
    assert refused.returncode == 2 and "BRINELL_PROCESSOR" in refused.stderr, refused


def runs_here(kind: str) -> bool:
    """Whether this processor has the instructions."""
    flags = set(Path("/proc/cpuinfo").read_text().partition("flags")[2].partition("\n")[0].split())
    needed = {"x86-64-v3": {"avx2", "fma", "bmi2"}, "x86-64-v4": {"avx2", "avx512f", "avx512vl"}}
    return needed.get(kind, set()) <= flags


if __name__ == "__main__":
    main()
