# SPDX-License-Identifier: BSD-3-Clause
"""Held against runs: what brinell check foretells of time and memory, for random cases of every kind.

    python bench/forecast.py measure --from 0 --to 700 -o fitted.jsonl    # appends cases that it lacks
    python bench/forecast.py fit fitted.jsonl                             # writes forecast_constants.hpp
    python bench/forecast.py measure --from 1000 --to 1350 -o others.jsonl
    python bench/forecast.py show others.jsonl                            # after the program has been built again

Each case is drawn from its number alone (bench/forecast_cases.py). Times are processor times of one thread, which hold
on a machine with other work, too. Run it with the Python of .venv, whose package has to be that of the program.
"""

from __future__ import annotations

import argparse
import concurrent.futures
import json
import os
import pathlib
import re
import signal
import subprocess
import sys
import tempfile
from typing import Any

from forecast_cases import drawn
from texture_cases import text_of

ROOT = pathlib.Path(__file__).resolve().parents[1]
PROGRAM = ROOT / "build/release/bin/brinell"
Table = dict[str, Any]

# Starts the program from a small process: the largest resident set counts from before the program begins.
LAUNCHER = """
import json, os, sys, time
begin = time.monotonic()
pid = os.fork()
if pid == 0:
    os.execv(sys.argv[1], sys.argv[1:])
_, status, used = os.wait4(pid, 0)
print(json.dumps([os.waitstatus_to_exitcode(status), used.ru_utime + used.ru_stime, used.ru_maxrss * 1024,
                  time.monotonic() - begin]), file=sys.stderr)
"""


def launched(arguments: list[str], place: pathlib.Path, timeout: float) -> Table:
    """Output, processor time, largest resident set and time of a program."""
    command = [sys.executable, "-I", "-S", "-c", LAUNCHER, *arguments]
    with subprocess.Popen(
        command, cwd=place, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, start_new_session=True
    ) as process:
        try:
            out, err = process.communicate(timeout=timeout)
        except subprocess.TimeoutExpired:
            os.killpg(process.pid, signal.SIGKILL)
            process.communicate()
            return {"error": "too slow"}
    lines = err.splitlines()
    code, seconds, memory, wall = json.loads(lines[-1])
    if code != 0:
        return {"error": "\n".join(lines[:-1])[-400:]}
    return {"out": out, "seconds": seconds, "memory": memory, "wall": wall}


def size_of(report: str) -> float:
    """Cells of the solved bodies times steps, from the report of check."""
    grids = re.search(
        r"# Grids: contact .*, lower body (\d+) x (\d+) x (\d+) cells, upper body (\d+) x (\d+) x (\d+)", report
    )
    assert grids
    numbers = [int(n) for n in grids.groups()]
    lower, upper = numbers[0] * numbers[1] * numbers[2], numbers[3] * numbers[4] * numbers[5]
    cells = lower + (0 if "one of them is solved" in report else upper)
    steps = sum(int(n) for n in re.findall(r"(\d+) steps", report)) or 1
    return float(cells * steps)


def scaled(case: Table, factor: float) -> Table:
    """The case with cells finer by a factor."""
    grid = dict(case["grid"])
    if "cells" in grid:
        grid["cells"] = [min(160, max(8, round(factor * n))) for n in grid["cells"]]
    else:
        grid["resolution"] = round(min(40.0, max(2.5, grid["resolution"] * factor)), 2)
    return {**case, "grid": grid}


def sized(case: Table, work: float, program: str, place: pathlib.Path) -> tuple[Table, Table]:
    """The case with cells such that it is as much work as wanted, and its check."""
    checked: Table = {}
    for attempt in range(4):
        (place / "case.toml").write_text(text_of(case))
        checked = launched([program, "check", "case.toml"], place, 60)
        if "error" in checked or attempt == 3:
            break
        has_track = case["scenario"] not in ("indentation", "fretting")
        factor = (work / size_of(checked["out"])) ** (0.25 if has_track else 0.33)
        finer = scaled(case, factor)
        if abs(factor - 1) < 0.05 or finer == case:
            break
        case = finer
    return case, checked


def history_of(folder: pathlib.Path) -> list[int]:
    """Evaluations of each step."""
    lines = [line for line in (folder / "history.csv").read_text().splitlines() if line and not line.startswith("#")]
    column = [name.strip() for name in lines[0].split(",")].index("evaluations")
    return [int(float(line.split(",")[column])) for line in lines[1:]]


def measured(number: int, program: str, threads: int, timeout: float) -> Table:
    """A case, its check, and its run."""
    kind, case, work = drawn(number)
    with tempfile.TemporaryDirectory() as folder:
        place = pathlib.Path(folder)
        case, checked = sized(case, work, program, place)
        row: Table = {"number": number, "kind": kind, "case": case, "check": checked}
        if "error" in checked:
            return row
        row["run"] = launched(
            [program, "run", "case.toml", "-o", "result", "-q", "--threads", str(threads)], place, timeout
        )
        row["run"].pop("out", None)
        result = place / "result"
        if (result / "history.csv").exists():
            row["evaluations"] = history_of(result)
        if (result / "summary.json").exists():
            summary = json.loads((result / "summary.json").read_text())
            row["summary"] = {key: summary[key] for key in ("run", "grid")}
        return row


def measure(options: argparse.Namespace) -> None:
    """Runs cases and appends them to the file."""
    out = pathlib.Path(options.output)
    done = {json.loads(line)["number"] for line in out.read_text().splitlines()} if out.exists() else set()
    numbers = [n for n in range(options.first, options.to) if n not in done]

    def work(number: int) -> Table:
        return measured(number, options.program, options.threads, options.timeout)

    with concurrent.futures.ThreadPoolExecutor(options.jobs) as pool, out.open("a") as file:
        for row in pool.map(work, numbers):
            file.write(json.dumps(row) + "\n")
            file.flush()


def _fit(options: argparse.Namespace) -> None:
    import forecast_fit  # needs the package, which measuring does not

    forecast_fit.fit(options)


def _show(options: argparse.Namespace) -> None:
    import forecast_fit

    forecast_fit.show(options)


def main() -> None:
    """The command line."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    sub = parser.add_subparsers(required=True)
    runs = sub.add_parser("measure")
    runs.add_argument("--from", dest="first", type=int, default=0)
    runs.add_argument("--to", type=int, default=700)
    runs.add_argument("--jobs", type=int, default=1)
    runs.add_argument("--threads", type=int, default=1)
    runs.add_argument("--timeout", type=float, default=60)
    runs.add_argument("--program", default=str(PROGRAM))
    runs.add_argument("-o", "--output", default="forecast.jsonl")
    runs.set_defaults(do=measure)
    fits = sub.add_parser("fit")
    fits.add_argument("files", nargs="+")
    fits.set_defaults(do=_fit)
    shows = sub.add_parser("show")
    shows.add_argument("files", nargs="+")
    shows.add_argument("--worst", type=int, default=10)
    shows.set_defaults(do=_show)
    options = parser.parse_args()
    options.do(options)


if __name__ == "__main__":
    main()
