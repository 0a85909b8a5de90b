#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Does a change make the engine work more? Usage: bench/instructions.py PYTHON [--record]

Instructions of small runs in memory, on one thread, counted by valgrind: unlike times they are the same on a busy machine,
to about 0.1 %. PYTHON is that of an environment with the wheel (docs/install.md), whose instructions for any x86-64 are
counted, so that the processor does not matter; the compiler does, and counts of another one are shown but not judged. What Python itself does
before and after is counted in a run of nothing and taken off.

Ends with status 1 if a run takes more than 5 % above what bench/instructions.toml has; --record writes that file anew.
"""

import argparse
import os
import re
import shutil
import subprocess
import sys
import tempfile
import tomllib
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

RECORD = Path(__file__).with_suffix(".toml")
CASES = Path(__file__).resolve().parents[1] / "cases"
ALLOWED = 0.05  # above what is recorded

# What each keeps from growing: small enough for a minute under valgrind, large enough that the engine is what counts.
RUNS = {
    "tugging": ("tugging-paper/case.toml", ["tugging.interference=4"]),
    "rolling": ("rolling-sliding/case.toml", ["grid.resolution=4"]),
    "rolling with friction": ("rolling-friction/case.toml", ["grid.resolution=4"]),
    "indentation": ("indentation-sphere/case.toml", ["grid.resolution=6"]),
    "rough contact": ("rough-periodic/case.toml", ["indentation.steps=6"]),
    "fretting": ("fretting-sphere/case.toml", ["grid.resolution=6"]),
    "heat": ("tugging-heat/case.toml", ["grid.resolution=6"]),
}

PROGRAM = """
import sys, warnings
import brinell
brinell.Case, brinell.Run, brinell.Tugging  # loads their modules, also in the run of nothing
warnings.simplefilter("ignore")
if sys.argv[1:]:
    brinell.Case.from_file(sys.argv[1], sys.argv[2:]).run(in_memory=True, threads=1)
"""


def instructions(python: str, *arguments: str) -> int:
    """Of one process."""
    command = ["valgrind", "--tool=cachegrind", "--cache-sim=no", "--cachegrind-out-file=/dev/null"]
    environment = os.environ | {"OMP_NUM_THREADS": "1", "PYTHONHASHSEED": "0", "BRINELL_PROCESSOR": "x86-64"}
    with tempfile.TemporaryDirectory() as elsewhere:  # not beside the sources of the package
        done = subprocess.run(
            [*command, python, "-c", PROGRAM, *arguments],
            cwd=elsewhere, env=environment, capture_output=True, text=True, check=False,
        )  # fmt: skip
    found = re.search(r"I\s+refs:\s+([\d,]+)", done.stderr)
    if done.returncode or not found:
        sys.exit(f"instructions: {' '.join(arguments) or 'nothing'} failed:\n{done.stderr[-2000:]}")
    return int(found.group(1).replace(",", ""))


def count_all(python: str) -> dict[str, float]:
    """Millions of instructions by run, as many runs at once as there are processors: counts do not depend on that."""
    with ThreadPoolExecutor(os.cpu_count()) as processes:
        nothing = processes.submit(instructions, python)
        runs = {
            name: processes.submit(instructions, python, str(CASES / case), *settings)
            for name, (case, settings) in RUNS.items()
        }
        return {name: (run.result() - nothing.result()) / 1e6 for name, run in runs.items()}


def compiler(python: str) -> str:
    """Which has made the wheel, as it says in its library."""
    text = "from brinell import _core; print(_core.__file__)"
    library = subprocess.run([python, "-c", text], capture_output=True, text=True, check=True, cwd="/").stdout.strip()
    comment = subprocess.run(["readelf", "-p", ".comment", library], capture_output=True, text=True, check=True).stdout
    return ", ".join(sorted(set(re.findall(r"GCC: .*|clang version .*", comment))))


def main() -> int:
    """Counts, compares or records."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("python", help="of an environment with the wheel")
    parser.add_argument("--record", action="store_true", help="write the counts as the new measure")
    options = parser.parse_args()
    if not shutil.which("valgrind"):
        sys.exit("instructions: no valgrind; tools/setup.sh count installs it")
    python = os.path.abspath(options.python)
    before = tomllib.loads(RECORD.read_text()) if RECORD.exists() else {"compiler": "", "runs": {}}
    made_by = compiler(python)
    counted = count_all(python)
    grown = []
    for name, count in counted.items():
        known = before["runs"].get(name)
        print(f"{name:22} {count:9.0f} million instructions" + (f", {count / known - 1:+.1%}" if known else ""))
        if known and count > (1 + ALLOWED) * known:
            grown.append(name)
    if options.record:
        rows = "".join(f'"{name}" = {count:.0f}\n' for name, count in counted.items())
        RECORD.write_text(
            f'# Written by bench/instructions.py --record.\ncompiler = "{made_by}"\n\n[runs] # millions\n{rows}'
        )
        return 0
    if made_by != before["compiler"]:
        print(f"not judged: made by {made_by}, recorded of {before['compiler']}")
        return 0
    if grown:
        print(f"more than {ALLOWED:.0%} above bench/instructions.toml: {', '.join(grown)}", file=sys.stderr)
    return 1 if grown else 0


if __name__ == "__main__":
    sys.exit(main())
