# SPDX-License-Identifier: BSD-3-Clause
"""Random cases with dents, bumps, waves, rough and measured surfaces, each drawn from its number alone."""

from __future__ import annotations

import json
import math
import random
from typing import Any

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
