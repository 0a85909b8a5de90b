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
import math
import pathlib
import random
import re
import subprocess
import tempfile
import time
from collections.abc import Callable
from typing import Any

ROOT = pathlib.Path(__file__).resolve().parents[1]
PROGRAM = ROOT / "build/release/bin/brinell"
Table = dict[str, Any]


def toml(value: Any) -> str:
    """A value in TOML, on one line."""
    if isinstance(value, dict):
        return "{ " + ", ".join(f"{key} = {toml(item)}" for key, item in value.items()) + " }"
    if isinstance(value, list | tuple):
        return "[" + ", ".join(toml(item) for item in value) + "]"
    if isinstance(value, bool):
        return str(value).lower()
    return json.dumps(value) if isinstance(value, str) else repr(value)


def text_of(case: Table) -> str:
    """The case file."""
    lines = []
    for key, value in case.items():
        if isinstance(value, dict):
            lines += [f"[{key}]", *(f"{name} = {toml(item)}" for name, item in value.items())]
        else:
            lines.append(f"{key} = {toml(value)}")
    return "\n".join(lines) + "\n"


class Draw(random.Random):
    """Random numbers of a case."""

    def power(self, low: float, high: float) -> float:
        """Evenly distributed logarithm between both values."""
        return math.exp(self.uniform(math.log(low), math.log(high)))


STIFFNESS, POISSON = 210e9, 0.3


def materials(draw: Draw) -> tuple[Table, Table, float, float]:
    """Lower and upper material, contact modulus and the lower yield stress."""
    yields = draw.power(0.4e9, 1.4e9)
    steel = {
        "young_modulus": STIFFNESS,
        "poisson_ratio": POISSON,
        "hardening": {"law": "linear", "yield_stress": yields, "modulus": draw.power(1e9, 10e9)},
    }
    if draw.random() < 0.2:
        steel["hardening"] = {"law": "voce", "yield_stress": yields, "saturation": 0.3 * yields, "rate": 40}
    upper: Table = {"young_modulus": 310e9, "poisson_ratio": 0.26}
    kind = draw.random()
    if kind < 0.25:
        upper = {"rigid": True}
    elif kind < 0.5:
        upper = {**steel, "hardening": {"law": "linear", "yield_stress": 1.2 * yields, "modulus": 5e9}}
    compliance = (1 - POISSON**2) / STIFFNESS
    if "rigid" not in upper:
        compliance += (1 - upper["poisson_ratio"] ** 2) / upper["young_modulus"]
    return steel, upper, 1 / compliance, yields


def heights(draw: Draw, amplitude: float, shortest: float, is_plane: bool) -> Table:
    """A map of a sum of waves, periodic or not, with eight points to the shortest one."""
    points, spacing = 48, shortest / 8
    size = points * spacing
    waves = [
        (draw.randint(2, 6), 0 if is_plane else draw.randint(0, 6), draw.uniform(0, 2 * math.pi)) for _ in range(12)
    ]
    rows = 1 if is_plane else points
    values = []
    for j in range(rows):
        for i in range(points):
            x, y = i * spacing, j * spacing
            total = sum(math.cos(2 * math.pi * (m * x + n * y) / size + phase) for m, n, phase in waves)
            values.append(amplitude * total / math.sqrt(6))
    return {
        "type": "height_map",
        "heights": [float(f"{value:.6g}") for value in values],
        "columns": points,
        "spacing": [spacing, 1.0 if is_plane else spacing],
        "periodic": True,
    }


def texture(draw: Draw, length: float, pressure: float, modulus: float, kind: str, is_plane: bool = False) -> Table:
    """A texture whose shortest wave is flattened by about a pressure.

    Args:
        draw: random numbers
        length: its shortest wave; of a dent four times the radius of its crater [m]
        pressure: [Pa]
        modulus: contact modulus [Pa]
        kind: of the texture
        is_plane: whether nothing varies along y
    """
    amplitude = pressure * length / (math.pi * modulus)
    if kind in ("dent", "bump"):
        return {
            "type": kind,
            "depth" if kind == "dent" else "height": amplitude,
            "edge_radius": 0.25 * length,
            "x": draw.uniform(-0.1, 0.1) * length,
            **({"y": draw.uniform(-0.3, 0.3) * length} if draw.random() < 0.3 else {}),
        }
    if kind == "waves":
        along_y = not is_plane and draw.random() < 0.5
        return {
            "type": "sinusoid",
            "amplitude": amplitude,
            "wavelength_x": length,
            **({"wavelength_y": length * draw.uniform(1, 2)} if along_y else {}),
            "x": draw.uniform(0, 1) * length,
        }
    if kind == "random":
        return {
            "type": "random",
            "rms_slope": 2 * pressure / modulus,
            "rolloff": length * draw.uniform(1, 3),
            "cutoff": length,
            "seed": draw.randint(0, 10**6),
        }
    return heights(draw, 0.3 * amplitude, length, is_plane)


def flats(draw: Draw, scenario: str, case: Table, modulus: float, yields: float) -> Table:
    """Rough flats over a period."""
    cells = draw.randint(16, 30)
    size = draw.power(1e-5, 1e-3)
    kind = draw.choice(["random", "random", "waves", "map"])
    waves = draw.choice([1, 1.5, 2, 3])
    slope = 2 * draw.power(1.0, 12.0) * yields / modulus
    if kind == "random":
        texture_of_flat = {
            "type": "random",
            "rms_slope": slope,
            "rolloff": 0.7 * size,
            "cutoff": size / (1.5 * waves),
            "size": [size, size],
            "seed": draw.randint(0, 10**6),
        }
    elif kind == "waves":
        length = size / max(1, round(waves))
        texture_of_flat = {
            "type": "sinusoid",
            "amplitude": slope * length / (2 * math.pi),
            "wavelength_x": length,
            "wavelength_y": length,
            "x": draw.uniform(0, 1) * length,
        }
    else:
        texture_of_flat = heights(draw, slope * size / 40, size / 6, False)
    case["lower"]["texture"] = texture_of_flat
    case["grid"] = {"boundary": "periodic", "size": [size, size], "cells": [cells, cells], "layer": 0.5 * size / cells}
    pressure = draw.power(0.01, 0.3) * yields
    if scenario == "indentation":
        case["indentation"] = {"pressure": [pressure, 0], "steps": 4}
    elif scenario == "sliding":
        case["sliding"] = {"pressure": pressure, "distance": 0.3 * size, "press_steps": 3}
        case["upper"]["texture"] = {**texture_of_flat, **({"seed": 7} if kind == "random" else {})}
        if kind != "random":
            del case["upper"]["texture"]
    return case


def drawn(number: int) -> Table:
    """The case of a number."""
    draw = Draw(number)
    scenario = ["rolling", "indentation", "tugging", "sliding", "fretting"][number % 5]
    lower, upper, modulus, yields = materials(draw)
    is_line = scenario != "fretting" and draw.random() < 0.25
    radius = draw.power(1e-4, 2e-2)
    case: Table = {"scenario": scenario, "lower": {}, "upper": {}}
    case["lower"] = {"shape": {"type": "flat"}, "material": lower}
    case["upper"] = {"shape": {"type": "flat"}, "material": upper}
    if scenario in ("indentation", "sliding") and draw.random() < 0.4:
        return flats(draw, scenario, case, modulus, yields)
    peak = draw.power(0.7, 2.2) * 1.6 * yields  # of the smooth elastic contact
    half = 2 * peak * radius / modulus if is_line else math.pi * peak * radius / (2 * modulus)
    load = math.pi * peak * half / 2 if is_line else 2 / 3 * math.pi * peak * half**2
    kinds = ["waves", "waves", "map"] if is_line else ["dent", "dent", "bump", "waves", "random", "map"]
    kind = draw.choice(kinds)
    length = half * (draw.power(0.7, 3.0) if kind in ("dent", "bump") else draw.power(0.5, 1.6))
    resolution = round(draw.power(8, 20) if is_line else draw.power(3.5, 7), 1)
    textured = texture(draw, length, draw.power(0.08, 8.0) * peak, modulus, kind, is_line)
    case["upper"]["shape"] = {"type": "cylinder" if is_line else "sphere", "radius": radius}
    case["grid"] = {"resolution": resolution, **({"boundary": ["open", "periodic"]} if is_line else {})}
    side = "lower" if draw.random() < 0.75 else "upper"
    if side == "upper" and upper.get("rigid") and scenario == "tugging":
        side = "lower"
    case[side]["texture"] = textured
    if scenario == "rolling":
        case["rolling"] = {"load": load, "distance": draw.uniform(2, 3) * half}
    elif scenario == "indentation":
        case["indentation"] = {"load": [load, 0], "steps": draw.randint(3, 6)}
    elif scenario == "sliding":
        case["sliding"] = {"load": load, "distance": draw.uniform(0.7, 1.5) * half}
        if draw.random() < 0.4:
            case["interface"] = {"friction": 0.1}
    elif scenario == "fretting":
        case["fretting"] = {
            "load": load,
            "cycles": 1,
            "displacement": draw.uniform(0.3, 1.5) * 0.3 * half * peak / modulus,
        }
        case["interface"] = {"friction": draw.uniform(0.15, 0.4)}
    else:
        case["lower"]["shape"] = {"type": "cylinder" if is_line else "sphere", "radius": 2 * radius}
        case["upper"]["shape"]["radius"] = 2 * radius
        case["tugging"] = {"interference": half**2 / radius, "normalised": False}
        if is_line:
            case["tugging"]["interference"] = half**2 / radius * 1.2
    return case


def finer(case: Table, factor: float) -> Table:
    """The case with cells smaller by a factor."""
    grid = dict(case["grid"])
    for key in ("resolution", "cells", "layer"):
        if key in grid:
            value = grid[key]
            grid[key] = (
                [round(factor * n) for n in value]
                if key == "cells"
                else value / factor
                if key == "layer"
                else factor * value
            )
    return {**case, "grid": grid}


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
