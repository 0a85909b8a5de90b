#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Writes the tables of bench/notebook/recorded.md from bench/results.csv, between the two marks there.

With ``--check`` it only says whether the page is up to date: exit code 1 if it is not.
"""

import csv
import re
import sys
from pathlib import Path

BENCH = Path(__file__).resolve().parent
PAGE = BENCH / "notebook" / "recorded.md"
BEGIN = "<!-- measured: begin (bench/render.py) -->"
END = "<!-- measured: end -->"

# Benchmarks by their question, in the order of the page.
QUESTIONS = {
    "tugging_paper": "The paper's case, all in all",
    "sliding_step": "A step of two rough surfaces that yield and slide, on 64, 128, 256 squared cells with 24 layers",
    "residual_stress": "One residual-stress evaluation, on 45 x 13 x 31 cells refined 1, 2 and 4 times",
    "symmetric_residual_stress": "The same where both sides of y = 0 are mirror images: half of each field",
    "residual_stress_of_powers": "One residual-stress evaluation on powers of two, which strain the caches",
    "planning": "Planning a body's operators, on 45 x 13 x 31 cells refined 1 and 2 times",
    "contact_solution": "One elastic contact, from nothing (`warm:0`) and from the pressure before it (`warm:1`)",
    "rough_contact": "Rough periodic surfaces under a load, from nothing",
}
QUANTITIES = {
    "over_transforms": "time over that of the bare transforms",
    "over_fftw": "time over that of the transforms by FFTW within the cache",
    "ns_per_cell": "time per cell",
    "ns_per_cell_and_evaluation": "time per cell and evaluation",
    "processor_s_per_step": "processor time [s]",
    "contact_percent": "real contact [%]",
    "bytes_per_cell": "memory per cell",
    "evaluations_per_step": "evaluations per step",
    "split_increments": "increments that had to be split",
}

Row = dict[str, str]


def read_rows(path: Path = BENCH / "results.csv") -> list[Row]:
    """All rows, oldest first."""
    with path.open(encoding="utf-8", newline="") as file:
        return list(csv.DictReader(file))


def value(row: Row) -> str:
    """Value with its unit; a pure number has none."""
    return row["value"] if row["unit"] == "1" else f"{row['value']} {row['unit']}"


def when(row: Row) -> str:
    """Commit and date."""
    return f"`{row['commit']}` {row['date']}"


def table(rows: list[Row]) -> list[str]:
    """One line per number: the last row of it, and the first if there is an earlier one."""
    series: dict[tuple[str, str], list[Row]] = {}
    for row in rows:
        series.setdefault((row["benchmark"], row["quantity"]), []).append(row)
    lines = [
        "| benchmark | quantity | now | measured at | first | measured at |",
        "| --- | --- | --- | --- | --- | --- |",
    ]
    for benchmark, quantity in sorted(series, key=lambda key: (key[0], key[1] != "time")):
        history = series[benchmark, quantity]
        first = [value(history[0]), when(history[0])] if len(history) > 1 else ["", ""]
        name = QUANTITIES.get(quantity, quantity)
        lines.append("| " + " | ".join([f"`{benchmark}`", name, value(history[-1]), when(history[-1]), *first]) + " |")
    return lines


def rendered(rows: list[Row]) -> str:
    """The tables: a section per machine and number of threads, a table per question."""
    lines: list[str] = []
    for machine, threads in dict.fromkeys((row["machine"], row["threads"]) for row in rows):
        lines += [f"## {machine}; {threads} thread{'s' if threads != '1' else ''}", ""]
        own = [row for row in rows if (row["machine"], row["threads"]) == (machine, threads)]
        families = dict.fromkeys([*QUESTIONS, *(row["benchmark"].split("/")[0] for row in own)])
        for family in families:
            members = [row for row in own if row["benchmark"].split("/")[0] == family]
            if members:
                lines += [f"**{QUESTIONS.get(family, family)}**", "", *table(members), ""]
    return "\n".join(lines)


def updated(page: str, rows: list[Row]) -> str:
    """The page with new tables between its marks."""
    pattern = re.compile(f"{re.escape(BEGIN)}.*{re.escape(END)}", re.DOTALL)
    if not pattern.search(page):
        raise SystemExit(f"{PAGE}: the lines\n{BEGIN}\n{END}\nare missing")
    return pattern.sub(lambda _: f"{BEGIN}\n\n{rendered(rows)}\n{END}", page)


def main() -> int:
    """Command line."""
    if sys.argv[1:] not in ([], ["--check"]):
        print(__doc__, file=sys.stderr)
        return 2
    old = PAGE.read_text(encoding="utf-8")
    new = updated(old, read_rows())
    if sys.argv[1:] == ["--check"]:
        return 0 if new == old else 1
    PAGE.write_text(new, encoding="utf-8")
    return 0


if __name__ == "__main__":
    sys.exit(main())
