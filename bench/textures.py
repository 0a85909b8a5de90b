# SPDX-License-Identifier: BSD-3-Clause
"""Held against refinement: random cases with dents, bumps, waves, rough and measured surfaces.

Each case is drawn from its number alone, computed with cells of the drawn size and of half that size, or a quarter of
it, and the change of each number with a stated error is compared with that error. docs/verification/accuracy.md (dents
and roughness) gives the result.

    python bench/textures.py run --from 3000 --to 3300 -o textures.jsonl  # appends cases that it lacks
    python bench/textures.py show textures.jsonl                          # changes above 1.5 and 3 times the stated
    python bench/textures.py accuracy --from 0 --to 20 -o accuracy.jsonl  # --accuracy 5%, and cells half as large

The last one looks whether the intervals that a series of runs ends with hold the numbers of a run with cells half as
large as its finest ones.
"""

from __future__ import annotations

import argparse
import concurrent.futures
import json
import pathlib
import re
import subprocess
import tempfile
import time
from collections.abc import Callable
from typing import Any

from texture_cases import Table, drawn, finer, text_of

ROOT = pathlib.Path(__file__).resolve().parents[1]
PROGRAM = ROOT / "build/release/bin/brinell"


def extreme_columns(history: pathlib.Path) -> Table:
    """Largest values of the history's columns."""
    rows = [line.split(",") for line in history.read_text().splitlines() if line and not line.startswith("#")]
    largest = {}
    for i, name in enumerate(rows[0]):
        try:
            largest[name.strip()] = max(abs(float(row[i])) for row in rows[1:])
        except ValueError:
            continue
    return largest


def computed(case: Table, program: str, timeout: float, *more: str) -> Table:
    """Summary of a run, without profiles, or why there is none."""
    with tempfile.TemporaryDirectory() as folder:
        place = pathlib.Path(folder)
        (place / "case.toml").write_text(text_of({**case, "output": {"snapshots": "none"}}))
        begin = time.process_time()
        try:
            done = subprocess.run(
                [program, "run", "case.toml", "-o", "result", "-q", "--threads", "1", *more],
                cwd=place,
                capture_output=True,
                text=True,
                timeout=timeout,
            )
        except subprocess.TimeoutExpired:
            return {"error": "too slow"}
        if done.returncode != 0:
            return {"error": done.stderr[-400:]}
        summary = json.loads((place / "result/summary.json").read_text())
        summary.pop("profile", None)
        summary["columns"] = extreme_columns(place / "result/history.csv")
        summary["seconds"] = time.process_time() - begin
        return summary


def work(number: int, options: argparse.Namespace) -> Table:
    """A case of a number with both summaries."""
    case = drawn(number)
    row = {"number": number, "case": case, "coarse": computed(case, options.program, options.timeout)}
    if "error" not in row["coarse"]:
        row["fine"] = computed(finer(case, 2**options.halvings), options.program, options.timeout)
    return row


def run(options: argparse.Namespace) -> None:
    """Computes cases and appends them to the file."""
    append(options, work)


def append(options: argparse.Namespace, compute: Callable[[int, argparse.Namespace], Table]) -> None:
    """Appends the rows that the file lacks."""
    out = pathlib.Path(options.output)
    done = {json.loads(line)["number"] for line in out.read_text().splitlines()} if out.exists() else set()
    numbers = [n for n in range(options.first, options.to) if n not in done]
    with concurrent.futures.ThreadPoolExecutor(options.jobs) as pool, out.open("a") as file:
        for row in pool.map(lambda n: compute(n, options), numbers):
            file.write(json.dumps(row) + "\n")
            file.flush()


def outside(number: int, options: argparse.Namespace) -> Table:
    """A case by a series of runs: which of its intervals do not hold the numbers of a run with cells half as large."""
    case = drawn(number)
    row: Table = {"number": number, "scenario": case["scenario"]}
    series = computed(case, options.program, options.timeout, "--accuracy", "5%")
    if "error" in series:
        return {**row, "error": series["error"]}
    found = series["accuracy"]
    finest = min(step["cells"] for step in found["runs"])
    fine = computed(finer(case, 2.0 / finest), options.program, options.timeout)
    if "error" in fine:
        return {**row, "error": fine["error"]}
    numbers_of_fine = numbers(fine)
    row |= {"reached": found["reached"], "error_of_series": found["error"], "runs": len(found["runs"])}
    row |= {"warnings": [warning["key"] for warning in series["warnings"]]}
    held = {
        name: interval["low"] <= numbers_of_fine[name] <= interval["high"]
        for name, interval in found["numbers"].items()
        if name in numbers_of_fine
    }
    row |= {"numbers": len(held), "outside": [name for name, holds in held.items() if not holds]}
    row |= {"outside_of_key_numbers": [name for name in row["outside"] if name in found["key_numbers"]]}
    return row


def accuracy(options: argparse.Namespace) -> None:
    """Computes series of runs, appends what they end with, and prints it."""
    append(options, outside)
    rows = [json.loads(line) for line in pathlib.Path(options.output).read_text().splitlines()]
    done = [row for row in rows if "error" not in row]
    reached = sum(row["reached"] for row in done)
    held = sum(not row["outside"] for row in done)
    all_numbers, beyond = sum(row["numbers"] for row in done), sum(len(row["outside"]) for row in done)
    print(f"{len(rows)} cases, {len(done)} with a run twice as fine; {reached} reach the accuracy")
    print(f"{held} hold all numbers; {beyond} of {all_numbers} numbers lie outside of their interval")


# Names of the numbers of each stated error; columns are the largest values of the history.
NAMES = {
    "rut": "passes[*].rut_depth_m",
    "resistance": "passes[*].resistance_N",
    "dissipation": "passes[*].dissipation_J",
    "shoulder": "passes[*].shoulder_height_m",
    "strain under the track": "passes[*].track_plastic_strain",
    "contact area": "*[*].contact_area_m2",
    "largest pressure": "*max_pressure*",
    "load": "indents[*].max_load_N",
    "residual depth": "indents[*].residual_depth_m",
    "hardness": "indents[*].hardness_Pa",
    "pile-up": "indents[*].pile_up_m",
    "largest plastic strain": "residual.max_equivalent_plastic_strain",
    "loading stiffness": "indents[*].loading_stiffness_N_per_m",
    "unloading stiffness": "indents[*].unloading_stiffness_N_per_m",
    "peak force": "forces.peak_*_N",
    "dents": "residual.max_*er_m",
    "net energy": "energy.net_J",
    "F_X at alignment": "forces.F_X_aligned_N",
    "friction by ploughing": "strokes[*].friction_ploughing",
    "largest force along the surface": "cycles[*].max_force_N",
    "heat of friction": "cycles[*].dissipation_friction_J",
    "slip amplitude": "cycles[*].slip_amplitude_m",
}
WORK = {"indentation": "energy.dissipation_*er_J", "tugging": "energy.dissipation_*er_J"}


def numbers(value: Any, name: str = "") -> dict[str, float]:
    """The numbers of a summary by their names."""
    if isinstance(value, dict):
        return {k: v for key, item in value.items() for k, v in numbers(item, f"{name}.{key}".lstrip(".")).items()}
    if isinstance(value, list):
        return {k: v for i, item in enumerate(value) for k, v in numbers(item, f"{name}[{i}]").items()}
    return {name: value} if isinstance(value, int | float) and not isinstance(value, bool) else {}


def errors(row: Table) -> list[tuple[str, float, float]]:
    """Quantity, change with cells half as large relative to its largest value, and stated error."""
    coarse, fine = numbers(row["coarse"]), numbers(row["fine"])
    found = []
    for quantity, stated in row["coarse"]["resolution"]["expected_errors"].items():
        pattern = NAMES.get(quantity) or WORK.get(row["case"]["scenario"], "*[*].dissipation_plastic_J")
        match = re.compile(re.escape(pattern).replace(r"\*", ".*")).fullmatch
        names = [name for name in fine if name in coarse and match(name)]
        size = max((abs(fine[name]) for name in names), default=0.0)
        if size > 0.0 and (quantity in NAMES or quantity == "plastic work"):
            found.append((quantity, max(abs(coarse[name] - fine[name]) for name in names) / size, stated))
    return found


def show(options: argparse.Namespace) -> None:
    """Prints how many changes exceed the stated errors."""
    rows = [json.loads(line) for file in options.files for line in pathlib.Path(file).read_text().splitlines()]
    done = [row for row in rows if "error" not in row["coarse"] and "error" not in row["fine"]]
    print(f"{len(rows)} cases, {len(done)} computed twice")
    by_quantity: dict[tuple[str, str], list[tuple[float, float, Table]]] = {}
    for row in done:
        for quantity, error, stated in errors(row):
            key = row["case"]["scenario"], quantity
            by_quantity.setdefault(key, []).append((error / stated, stated, row))
    print(f"{'':44s} errors  median stated  > 1.5  > 3   worst")
    for (scenario, quantity), found in sorted(by_quantity.items()):
        ratios = sorted(ratio for ratio, _, _ in found)
        stated = sorted(stated for _, stated, _ in found)[len(found) // 2]
        above = [sum(ratio > limit for ratio in ratios) for limit in (1.5, 3.0)]
        print(
            f"{scenario:12s}{quantity:32s} {len(found):6d} {stated:14.3f} {above[0]:6d} {above[1]:4d} {ratios[-1]:7.2f}"
        )
    every = [(ratio, row) for found in by_quantity.values() for ratio, _, row in found]
    unwarned = [ratio for ratio, row in every if not row["coarse"]["warnings"]]
    for name, ratios in ("all", [ratio for ratio, _ in every]), ("in runs without a warning", unwarned):
        above = [sum(ratio > limit for ratio in ratios) for limit in (1.5, 3.0)]
        print(f"{name}: {len(ratios)} errors, {above[0]} above 1.5, {above[1]} above 3 times the stated")
    for ratio, row in sorted(every, key=lambda pair: -pair[0])[: options.worst]:
        print(f"  case {row['number']}: {ratio:.1f}, warnings {[w['key'] for w in row['coarse']['warnings']]}")


def main() -> None:
    """The command line."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    sub = parser.add_subparsers(required=True)
    draws = argparse.ArgumentParser(add_help=False)
    draws.add_argument("--from", dest="first", type=int, default=0)
    draws.add_argument("--to", type=int, default=300)
    draws.add_argument("--jobs", type=int, default=2)
    draws.add_argument("--timeout", type=float, default=120)
    draws.add_argument("--program", default=str(PROGRAM))
    draws.add_argument("-o", "--output", default="textures.jsonl")
    runs = sub.add_parser("run", parents=[draws])
    runs.add_argument("--halvings", type=int, choices=(1, 2), default=1, help="of the cells")
    runs.set_defaults(do=run)
    sub.add_parser("accuracy", parents=[draws]).set_defaults(do=accuracy)
    shows = sub.add_parser("show")
    shows.add_argument("files", nargs="+")
    shows.add_argument("--worst", type=int, default=10)
    shows.set_defaults(do=show)
    options = parser.parse_args()
    options.do(options)


if __name__ == "__main__":
    main()
