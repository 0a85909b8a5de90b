# SPDX-License-Identifier: BSD-3-Clause
"""Random cases of every kind of run, each drawn from its number alone, for bench/forecast.py."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any

from texture_cases import Draw, heights

Table = dict[str, Any]

THERMAL = {"conductivity": 50, "density": 7850, "specific_heat": 460, "expansion": 12e-6}


def hardening(draw: Draw, yields: float, stiffness: float) -> Table:
    """A hardening law with this yield stress."""
    law = draw.choice(["linear", "linear", "perfect", "voce", "ludwik", "swift"])
    if law == "perfect":
        return {"law": law, "yield_stress": yields}
    if law == "linear":
        return {"law": law, "yield_stress": yields, "modulus": stiffness * draw.power(1e-3, 5e-2)}
    if law == "voce":
        return {
            "law": law,
            "yield_stress": yields,
            "saturation": yields * draw.power(0.2, 3),
            "rate": draw.power(5, 80),
        }
    if law == "ludwik":
        growth = yields * draw.power(0.5, 5)
        return {"law": law, "yield_stress": yields, "coefficient": growth, "exponent": draw.uniform(0.2, 0.6)}
    exponent, offset = draw.uniform(0.05, 0.3), draw.power(1e-4, 1e-2)
    return {"law": law, "coefficient": yields / offset**exponent, "offset": offset, "exponent": exponent}


class Bodies:
    """The materials of a case, and what follows from them.

    Args:
        draw: random numbers.
        soft: whether the lower body is a soft metal, of which E/S_y is from 500 to 5000.
        elastic: whether neither body yields.
        heated: whether the bodies conduct heat.
    """

    def __init__(self, draw: Draw, *, soft: bool = False, elastic: bool = False, heated: bool = False) -> None:
        stiffness, poisson = draw.power(60e9, 220e9), draw.uniform(0.25, 0.36)
        self.yields = stiffness / draw.power(500, 5000) if soft else stiffness / draw.power(80, 600)
        self.lower: Table = {"young_modulus": stiffness, "poisson_ratio": poisson}
        if not elastic:
            self.lower["hardening"] = hardening(draw, self.yields, stiffness)
            if draw.random() < 0.08:
                modulus = stiffness * draw.power(0.01, 0.1)
                self.lower["hardening"]["back_stresses"] = [{"modulus": modulus, "recall": draw.choice([0, 50, 300])}]
            if draw.random() < 0.08:
                depth = draw.power(1e-5, 1e-3)
                self.lower["yield_profile"] = {"depth": [0, depth], "factor": [draw.uniform(1, 1.6), 1]}
        kind = draw.choice(["rigid", "elastic", "elastic", "same", "harder"])
        if heated and kind == "rigid":
            kind = "elastic"
        self.upper: Table = {"young_modulus": draw.power(100e9, 600e9), "poisson_ratio": draw.uniform(0.2, 0.33)}
        if kind == "rigid":
            self.upper = {"rigid": True}
        elif kind in ("same", "harder"):
            self.upper = {key: value for key, value in self.lower.items() if key != "yield_profile"}
            if kind == "harder" and not elastic:
                self.upper["hardening"] = hardening(draw, self.yields * draw.uniform(1.05, 1.6), stiffness)
        if heated:
            self.lower["thermal"] = dict(THERMAL)
            if draw.random() < 0.7:
                self.upper["thermal"] = dict(THERMAL)
        compliance = (1 - poisson**2) / stiffness
        if kind != "rigid":
            compliance += (1 - self.upper["poisson_ratio"] ** 2) / self.upper["young_modulus"]
        self.modulus = 1 / compliance


def texture(draw: Draw, length: float, pressure: float, modulus: float, *, is_plane: bool = False) -> Table:
    """A texture whose shortest wave is flattened by about a pressure."""
    kind = draw.choice(["waves", "map"] if is_plane else ["dent", "bump", "waves", "random", "map"])
    amplitude = pressure * length / (math.pi * modulus)
    if kind in ("dent", "bump"):
        name = "depth" if kind == "dent" else "height"
        return {"type": kind, name: amplitude, "edge_radius": 0.25 * length, "x": draw.uniform(-0.1, 0.1) * length}
    if kind == "waves":
        waves = {"type": "sinusoid", "amplitude": amplitude, "wavelength_x": length}
        return {**waves, "wavelength_y": 1.5 * length} if not is_plane and draw.random() < 0.5 else waves
    if kind == "random":
        seed = draw.randint(0, 10**6)
        slope = 2 * pressure / modulus
        return {"type": "random", "rms_slope": slope, "rolloff": 2 * length, "cutoff": length, "seed": seed}
    return heights(draw, 0.3 * amplitude, length, is_plane)


def base(scenario: str, bodies: Bodies, lower: Table, upper: Table) -> Table:
    """The part that all cases have."""
    return {
        "scenario": scenario,
        "lower": {"shape": lower, "material": bodies.lower},
        "upper": {"shape": upper, "material": bodies.upper},
    }


FLAT: Table = {"type": "flat"}


class Round:
    """A round contact, or one along a line, whose elastic peak pressure is a multiple of that of first yield."""

    def __init__(self, draw: Draw, bodies: Bodies, over_yield: float, *, line: bool = False) -> None:
        self.radius = draw.power(1e-4, 2e-2)
        self.peak = 1.6 * bodies.yields * over_yield
        self.line = line
        factor = 2 if line else 0.5 * math.pi
        self.half = min(factor * self.peak / bodies.modulus, 0.2) * self.radius
        self.peak = self.half / self.radius / factor * bodies.modulus
        self.load = math.pi * self.peak * self.half / 2 if line else 2 / 3 * math.pi * self.peak * self.half**2
        self.shape: Table = {"type": "cylinder" if line else "sphere", "radius": self.radius}
        self.grid: Table = {"boundary": ["open", "periodic"]} if line else {}
        if not line and draw.random() < 0.2:
            self.shape = {"type": "ellipsoid", "radius_x": self.radius, "radius_y": self.radius * draw.uniform(1, 4)}
            self.load *= math.sqrt(self.shape["radius_y"] / self.radius)


def over_yield(draw: Draw, *, soft: bool = False) -> float:
    """How far the elastic peak pressure is above that of first yield."""
    return draw.power(2, 40) if soft else draw.power(0.6, 6)


def indentation(
    draw: Draw, *, soft: bool = False, rough: bool = False, line: bool = False, elastic: bool = False
) -> Table:
    """A ball, an ellipsoid or a cylinder is pressed into a flat."""
    bodies = Bodies(draw, soft=soft, elastic=elastic)
    contact = Round(draw, bodies, over_yield(draw, soft=soft), line=line)
    case = base("indentation", bodies, FLAT, contact.shape)
    case["indentation"] = {"load": [contact.load, 0] if draw.random() < 0.7 else [contact.load]}
    if draw.random() < 0.25 and not line:
        case["indentation"] = {"approach": [contact.half**2 / contact.radius, 0]}
    case["indentation"]["steps"] = draw.randint(2, 20)
    if draw.random() < 0.1 and len(next(iter(case["indentation"].values()))) == 2:
        case["indentation"]["cycles"] = draw.randint(2, 4)
    case["grid"] = {"resolution": 8.0, **contact.grid}
    if rough:
        side = draw.choice(["lower", "upper"])
        length = contact.half * draw.power(0.5, 2.0)
        case[side]["texture"] = texture(draw, length, draw.power(0.1, 5) * contact.peak, bodies.modulus, is_plane=line)
    return case


def tip(draw: Draw) -> Table:
    """A pyramid or a cone is pressed into a flat."""
    bodies = Bodies(draw, soft=draw.random() < 0.3)
    kind = draw.choice(["vickers", "berkovich", "cone"])
    shape: Table = {"type": kind, **({"half_angle": draw.uniform(60, 80)} if kind == "cone" else {})}
    if draw.random() < 0.4:
        shape["tip_radius"] = draw.power(1e-7, 1e-6)
    case = base("indentation", bodies, FLAT, shape)
    depth = draw.power(3e-7, 1e-5)
    if draw.random() < 0.5:
        case["indentation"] = {"approach": [depth, 0]}
    else:
        case["indentation"] = {"load": [2.8 * bodies.yields * math.pi * (3 * depth) ** 2, 0]}
    case["indentation"]["steps"] = draw.randint(3, 16)
    case["grid"] = {"resolution": 6.0}
    return case


def flats(draw: Draw, *, slides: bool = False, elastic: bool = False) -> Table:
    """Rough flats over a period, pressed together or sliding."""
    bodies = Bodies(draw, soft=draw.random() < 0.2, elastic=elastic)
    case = base("sliding" if slides else "indentation", bodies, FLAT, FLAT)
    size = draw.power(1e-5, 1e-3)
    slope = draw.power(0.5, 10.0) * 2 * bodies.yields / bodies.modulus
    kind = draw.choice(["random", "random", "random", "waves"])
    shortest = size / draw.uniform(2, 7)
    rough: Table = {
        "type": "random",
        "rms_slope": slope,
        "rolloff": draw.uniform(0.5, 1) * size,
        "cutoff": shortest,
        "size": [size, size],
        "seed": draw.randint(0, 10**6),
    }
    if kind == "waves":
        length = size / draw.randint(1, 3)
        rough = {
            "type": "sinusoid",
            "amplitude": slope * length / (2 * math.pi),
            "wavelength_x": length,
            "wavelength_y": length,
        }
        shortest = length
    case["lower"]["texture"] = rough
    if kind == "random" and draw.random() < 0.4:
        case["upper"]["texture"] = {**rough, "seed": rough["seed"] + 1}
    cells = max(12, round(size / shortest * draw.uniform(5, 9)))
    case["grid"] = {"boundary": "periodic", "size": [size, size], "cells": [cells, cells]}
    pressure = draw.power(0.01, 0.5) * bodies.yields
    if slides:
        case["sliding"] = {"pressure": pressure, "distance": draw.uniform(0.1, 0.6) * size}
        case["sliding"]["press_steps"] = draw.randint(2, 8)
        if draw.random() < 0.5:
            case["interface"] = {"friction": draw.uniform(0.05, 0.4)}
    else:
        case["indentation"] = {"pressure": [pressure, 0] if draw.random() < 0.6 else [pressure]}
        case["indentation"]["steps"] = draw.randint(2, 16)
    return case


def with_motion(draw: Draw, case: Table, *, heated: bool, wears: bool, least: float = 0.05, most: float = 0.4) -> Table:
    """Friction, with heat and wear."""
    case["interface"] = {"friction": draw.uniform(least, most)}
    if wears:
        coefficient = 10 ** draw.uniform(-16, -13)
        case["interface"]["wear"] = {"lower": coefficient, "upper": coefficient if draw.random() < 0.6 else 0.0}
    if heated and draw.random() < 0.3:
        case["thermal"] = {"heat_of_plastic_work": 0}
        if case["scenario"] != "fretting" and draw.random() < 0.5:
            case["thermal"]["regime"] = "steady"
    return case


def rolling(
    draw: Draw,
    *,
    slides: bool = False,
    heated: bool = False,
    wears: bool = False,
    rough: bool = False,
    line: bool = False,
    creeps: bool = False,
    long: bool = False,
    elastic: bool = False,
) -> Table:
    """A body rolls over a flat."""
    bodies = Bodies(draw, heated=heated, elastic=elastic)
    contact = Round(draw, bodies, draw.power(0.7, 3), line=line)
    case = base("rolling", bodies, FLAT, contact.shape)
    track = draw.power(10, 40) if long else draw.power(1.5, 8)
    case["rolling"] = {"load": contact.load, "distance": track * contact.half, "load_steps": draw.randint(3, 6)}
    if draw.random() < 0.3:
        case["rolling"]["passes"] = draw.randint(2, 5)
    case["grid"] = {"resolution": 8.0, **contact.grid}
    if rough:
        side = draw.choice(["lower", "upper"])
        length = contact.half * draw.power(0.5, 2.0)
        case[side]["texture"] = texture(draw, length, draw.power(0.1, 3) * contact.peak, bodies.modulus, is_plane=line)
    if creeps:
        case = with_motion(draw, case, heated=False, wears=wears)
        lateral = 0.0 if line else draw.choice([0.0, draw.uniform(-2e-3, 2e-3)])
        case["rolling"]["creepage"] = [draw.uniform(2e-4, 5e-3), lateral]
    elif slides or heated or wears:
        case["rolling"]["slide_to_roll"] = draw.choice([2.0, draw.uniform(0.02, 0.5)])
        case = with_motion(draw, case, heated=heated, wears=wears)
    if heated:
        case["rolling"]["speed"] = draw.power(0.1, 5)
    return case


def tugging(
    draw: Draw,
    *,
    slides: bool = False,
    heated: bool = False,
    wears: bool = False,
    line: bool = False,
    soft: bool = False,
) -> Table:
    """Two bodies pass each other."""
    bodies = Bodies(draw, heated=heated, soft=soft)
    if "rigid" in bodies.upper and draw.random() < 0.5:
        bodies.upper = {key: value for key, value in bodies.lower.items() if key != "yield_profile"}
        bodies.modulus *= 0.5
    contact = Round(draw, bodies, draw.power(1.0, 4), line=line)
    shape = {"type": "cylinder" if line else "sphere", "radius": 2 * contact.radius}
    case = base("tugging", bodies, shape, dict(shape))
    factor = 1.2 if line else 1.0
    case["tugging"] = {"interference": factor * contact.half**2 / contact.radius, "normalised": False}
    if draw.random() < 0.15 and not line:
        case["tugging"] = {"load": contact.load, "normalised": False}
    if draw.random() < 0.2:
        case["tugging"]["passes"] = 2
    case["grid"] = {"resolution": 10.0, **contact.grid}
    if slides or heated or wears:
        case = with_motion(draw, case, heated=heated, wears=wears)
    if heated:
        case["tugging"]["speed"] = draw.power(0.1, 5)
    return case


def sliding(
    draw: Draw,
    *,
    slides: bool = True,
    heated: bool = False,
    wears: bool = False,
    rough: bool = False,
    line: bool = False,
    long: bool = False,
    elastic: bool = False,
) -> Table:
    """A body slides over a flat."""
    bodies = Bodies(draw, heated=heated, elastic=elastic)
    contact = Round(draw, bodies, draw.power(0.6, 3), line=line)
    case = base("sliding", bodies, FLAT, contact.shape)
    track = draw.power(8, 30) if long else draw.power(0.6, 5)
    case["sliding"] = {"load": contact.load, "distance": track * contact.half, "press_steps": draw.randint(2, 8)}
    if draw.random() < 0.25:
        case["sliding"].update(strokes=draw.randint(2, 4), to_and_fro=True)
    case["grid"] = {"resolution": 8.0, **contact.grid}
    if rough:
        side = draw.choice(["lower", "upper"])
        length = contact.half * draw.power(0.5, 2.0)
        case[side]["texture"] = texture(draw, length, draw.power(0.1, 3) * contact.peak, bodies.modulus, is_plane=line)
    if slides or heated or wears:
        case = with_motion(draw, case, heated=heated, wears=wears)
    if heated:
        case["sliding"]["speed"] = draw.power(0.1, 5)
    return case


def fretting(
    draw: Draw,
    *,
    heated: bool = False,
    wears: bool = False,
    rough: bool = False,
    line: bool = False,
    elastic: bool = False,
) -> Table:
    """A body oscillates on a flat."""
    bodies = Bodies(draw, heated=heated, elastic=elastic)
    contact = Round(draw, bodies, draw.power(0.5, 2.5), line=line)
    case = base("fretting", bodies, FLAT, contact.shape)
    case = with_motion(draw, case, heated=heated, wears=wears, least=0.1, most=0.7)
    friction = case["interface"]["friction"]
    whole = 1.4 * friction * contact.half**2 / contact.radius
    case["fretting"] = {
        "load": contact.load,
        "cycles": draw.randint(1, 4),
        "steps_per_cycle": draw.choice([8, 12, 20, 40]),
    }
    if draw.random() < 0.6:
        case["fretting"]["displacement"] = whole * draw.power(0.2, 2)
    else:
        case["fretting"]["force"] = friction * contact.load * draw.uniform(0.2, 0.9)
    case["fretting"]["press_steps"] = draw.randint(3, 10)
    case["grid"] = {"resolution": 8.0, **contact.grid}
    if rough:
        length = contact.half * draw.power(0.5, 2.0)
        case["lower"]["texture"] = texture(
            draw, length, draw.power(0.1, 3) * contact.peak, bodies.modulus, is_plane=line
        )
    if heated:
        case["fretting"]["frequency"] = draw.power(5, 100)
    return case


KINDS: dict[str, Callable[[Draw], Table]] = {
    "indentation": indentation,
    "indentation, soft": lambda draw: indentation(draw, soft=True),
    "indentation, tip": tip,
    "indentation, rough": lambda draw: indentation(draw, rough=True, line=draw.random() < 0.2),
    "indentation, line": lambda draw: indentation(draw, line=True),
    "indentation, rough flats": flats,
    "rolling": rolling,
    "rolling, long": lambda draw: rolling(draw, long=True),
    "rolling, rough": lambda draw: rolling(draw, rough=True, line=draw.random() < 0.2),
    "rolling, line": lambda draw: rolling(draw, line=True, slides=draw.random() < 0.5),
    "rolling, friction": lambda draw: rolling(draw, slides=True),
    "rolling, creepage": lambda draw: rolling(draw, creeps=True, line=draw.random() < 0.2),
    "rolling, heat": lambda draw: rolling(draw, heated=True),
    "rolling, wear": lambda draw: rolling(draw, wears=True, creeps=draw.random() < 0.3),
    "tugging": tugging,
    "tugging, soft": lambda draw: tugging(draw, soft=True),
    "tugging, line": lambda draw: tugging(draw, line=True, slides=draw.random() < 0.5),
    "tugging, friction": lambda draw: tugging(draw, slides=True),
    "tugging, heat": lambda draw: tugging(draw, heated=True),
    "tugging, wear": lambda draw: tugging(draw, wears=True),
    "sliding": lambda draw: sliding(draw, slides=draw.random() < 0.5),
    "sliding, rough": lambda draw: sliding(draw, rough=True, slides=draw.random() < 0.5, line=draw.random() < 0.2),
    "sliding, rough flats": lambda draw: flats(draw, slides=True),
    "sliding, line": lambda draw: sliding(draw, line=True),
    "sliding, long": lambda draw: sliding(draw, long=True),
    "sliding, heat": lambda draw: sliding(draw, heated=True),
    "sliding, wear": lambda draw: sliding(draw, wears=True),
    "fretting": fretting,
    "fretting, rough": lambda draw: fretting(draw, rough=True),
    "fretting, line": lambda draw: fretting(draw, line=True),
    "fretting, heat": lambda draw: fretting(draw, heated=True),
    "fretting, wear": lambda draw: fretting(draw, wears=True),
    "elastic": lambda draw: draw.choice([indentation, rolling, sliding, fretting])(draw, elastic=True),
    "elastic, rough": lambda draw: draw.choice([indentation, rolling, sliding, fretting])(
        draw, elastic=True, rough=True
    ),
    "elastic, rough flats": lambda draw: flats(draw, elastic=True, slides=draw.random() < 0.3),
}


def drawn(number: int) -> tuple[str, Table, float]:
    """Kind and case of a number, and how much work it is to be: cells times steps."""
    draw = Draw(f"forecast {number}")
    kind = list(KINDS)[number % len(KINDS)]
    work = draw.power(5e4, 8e6)
    case = KINDS[kind](draw)
    output = draw.random()
    if output < 0.2:
        case["output"] = {"snapshots": "none"}
    elif output < 0.35:
        case["output"] = {"snapshots": "all" if output < 0.25 else "every 4"}
    return kind, case, work
