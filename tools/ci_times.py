#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Where the time of .ci/run goes: its stages and the thirty slowest tests of CTest and pytest, as a table and as rows.

    tools/ci_times.py STAGES JUNIT... [--csv build/ci.csv]

STAGES has a line "seconds<tab>stage" for each stage; the others are reports of `ctest --output-junit` and
`pytest --junitxml`. Those that do not exist, since a stage has failed before, are passed over. Long tests of CTest that
tests/long_tests.txt does not have are named, since they neither begin first nor are left out of quick runs.
"""

import argparse
import csv
import datetime
import subprocess
import sys
import xml.etree.ElementTree as ET
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
sys.path.insert(0, str(ROOT / "bench"))
from record import processor  # noqa: E402

COLUMNS = ("date", "commit", "machine", "kind", "name", "seconds")
LIST = ROOT / "tests" / "long_tests.txt"
SHOWN = 30
LONG = 10.0  # seconds of a test that is to be in the list


def stages(path: Path) -> list[tuple[str, float]]:
    """Names and seconds in their order."""
    rows = (line.split("\t", 1) for line in path.read_text(encoding="utf-8").splitlines())
    return [(name, float(seconds)) for seconds, name in rows]


def tests(report: Path) -> list[tuple[str, float]]:
    """Names and seconds. Those of CTest are called as `ctest -R` finds them, those of pytest file::test."""
    found = []
    for case in ET.parse(report).iter("testcase"):
        name, of = case.attrib["name"], case.attrib.get("classname", "")
        if of != name:
            name = f"{of.rsplit('.', 1)[-1]}.py::{name}"
        found.append((name, float(case.attrib["time"])))
    return found


def unlisted(measured: list[tuple[str, float]], text: str) -> list[str]:
    """Tests of CTest that take long and are not in the list; cmake/tests.cmake itself has the cost of those of the package and MPI."""
    listed = {line.split()[0] for line in text.splitlines() if line.strip()}
    return [
        name
        for name, seconds in measured
        if seconds >= LONG and "::" not in name and name not in listed and not name.startswith(("package.", "mpi."))
    ]


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("stages", type=Path)
    parser.add_argument("reports", nargs="*", type=Path)
    parser.add_argument("--csv", type=Path, help="file to which the rows are added")
    parser.add_argument("--machine", default=processor(), help="default: %(default)s")
    options = parser.parse_args()
    of_stages = stages(options.stages)
    of_tests = [test for report in options.reports if report.exists() for test in tests(report)]
    slowest = sorted(of_tests, key=lambda test: -test[1])[:SHOWN]
    print(f"--- Time of each stage, {sum(seconds for _, seconds in of_stages) / 60:.1f} min in all ---")
    for name, seconds in of_stages:
        print(f"{seconds:7.0f} s  {name}")
    total = sum(seconds for _, seconds in of_tests)
    print(f"\n--- The {len(slowest)} slowest of {len(of_tests)} tests, which take {total:.0f} s one by one ---")
    for name, seconds in slowest:
        print(f"{seconds:7.1f} s  {name}")
    if missing := unlisted(slowest, LIST.read_text(encoding="utf-8")):
        print(f"\nLonger than {LONG:g} s, but not in tests/long_tests.txt: {' '.join(missing)}")
    if options.csv:
        commit = subprocess.run(
            ["git", "-C", str(ROOT), "describe", "--always", "--dirty", "--abbrev=7", "--exclude=*"],
            capture_output=True, text=True, check=True,
        ).stdout.strip()  # fmt: skip
        head = (datetime.date.today().isoformat(), commit, options.machine)
        is_new = not options.csv.exists()
        with options.csv.open("a", encoding="utf-8", newline="") as file:
            writer = csv.writer(file, lineterminator="\n")
            if is_new:
                writer.writerow(COLUMNS)
            for kind, rows in (("stage", of_stages), ("test", slowest)):
                writer.writerows((*head, kind, name, f"{seconds:.1f}") for name, seconds in rows)
    return 0


if __name__ == "__main__":
    sys.exit(main())
