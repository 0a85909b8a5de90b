#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Appends what the benchmarks measured to bench/results.csv.

    make bench                                   # measures; JSON of Google Benchmark in build/bench
    bench/record.py build/bench/*.json           # appends a row per number
    bench/render.py                              # writes the tables of bench/notebook/recorded.md

Of repeated runs (`--benchmark_repetitions`) the median is taken. Commit and number of threads are in the JSON, as
`make bench` passes them on. The machine is named after its processor unless --machine says otherwise: numbers are
compared only if the names are equal.
"""

import argparse
import csv
import json
import os
import re
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import Any

COLUMNS = ("date", "commit", "machine", "threads", "benchmark", "quantity", "value", "unit")
RESULTS = Path(__file__).with_name("results.csv")

# What Google Benchmark writes beside the counters of a benchmark.
_OF_THE_LIBRARY = {
    "name", "family_index", "per_family_instance_index", "run_name", "run_type", "repetitions", "repetition_index",
    "threads", "iterations", "real_time", "cpu_time", "time_unit", "aggregate_name", "aggregate_unit",
}  # fmt: skip


def processor() -> str:
    """Name of this machine's processor, with its number of cores."""
    model = re.search(r"^model name\s*: (.+)$", Path("/proc/cpuinfo").read_text(encoding="utf-8"), re.MULTILINE)
    return f"{model.group(1) if model else 'unknown processor'}; {os.cpu_count()} cores"


def unit_of(counter: str) -> str:
    """Unit of a counter by its name; a pure number has the unit 1."""
    return {"ns": "ns", "bytes": "B"}.get(counter.split("_")[0], "1")


def written(value: float, unit: str) -> tuple[str, str]:
    """Three digits without an exponent: a long time in a larger unit."""
    larger = {"ns": "us", "us": "ms", "ms": "s"}
    while value >= 1e4 and unit in larger:
        value, unit = value / 1e3, larger[unit]
    return f"{float(f'{value:.3g}'):g}", unit


def is_wanted(entry: dict[str, Any]) -> bool:
    """Single runs and the median of repeated ones; not the fitted law of growth, which is of CPU times."""
    if entry.get("error_occurred"):
        raise SystemExit(f"{entry['name']}: {entry['error_message']}")
    return entry.get("aggregate_name") == "median" if entry["repetitions"] > 1 else entry["run_type"] == "iteration"


def numbers(entry: dict[str, Any]) -> Iterator[tuple[str, float, str]]:
    """Quantity, value and unit of each number of one benchmark."""
    yield "time", entry["real_time"], entry["time_unit"]
    for counter in sorted(entry.keys() - _OF_THE_LIBRARY):
        yield counter, entry[counter], unit_of(counter)


def rows(report: dict[str, Any], machine: str) -> Iterator[dict[str, str]]:
    """Rows of results.csv from one report of Google Benchmark."""
    context = report["context"]
    for entry in filter(is_wanted, report["benchmarks"]):
        for quantity, value, unit in numbers(entry):
            cells = (
                context["date"][:10],
                context["commit"],
                machine,
                context["threads"],
                entry["run_name"].removesuffix("/manual_time"),
                quantity,
                *written(value, unit),
            )
            yield dict(zip(COLUMNS, cells, strict=True))


def main() -> int:
    """Command line."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("reports", nargs="+", type=Path, help="JSON files that 'make bench' has written")
    parser.add_argument("--machine", default=processor(), help="default: %(default)s")
    options = parser.parse_args()
    added = [
        row for path in options.reports for row in rows(json.loads(path.read_text(encoding="utf-8")), options.machine)
    ]
    with RESULTS.open("a", encoding="utf-8", newline="") as file:
        csv.DictWriter(file, COLUMNS, lineterminator="\n").writerows(added)
    print(f"{len(added)} rows for {options.machine}")
    return 0


if __name__ == "__main__":
    sys.exit(main())
