# SPDX-License-Identifier: BSD-3-Clause
"""Small cases of every kind: scenario, bodies, boundary and what acts between the surfaces."""

from __future__ import annotations

import itertools
from collections.abc import Iterator
from typing import Any, NamedTuple

import brinell
from brinell.scenarios import SCENARIOS, Scenario

__all__ = ["DOMAINS", "INTERFACES", "MATERIALS", "Kind", "covering_kinds"]

MATERIALS = ("rigid", "elastic", "plastic")
DOMAINS = ("open", "periodic", "plane")
INTERFACES = ("smooth", "friction", "heat", "wear")


class Kind(NamedTuple):
    """A kind of run."""

    scenario: Scenario
    lower: str
    upper: str
    domain: str
    interface: str

    @property
    def is_possible(self) -> bool:
        """Whether there is such a case: a body deforms, what passes has ends, and without friction nothing frets."""
        passes = self.scenario in ("tugging", "rolling")
        is_without_friction = {"indentation": True, "fretting": False}.get(self.scenario)
        return (
            {self.lower, self.upper} != {"rigid"}
            and not (passes and self.domain == "periodic")
            and is_without_friction in (None, self.interface == "smooth")
        )

    def case(self, **tables: Any) -> brinell.Case:
        """A case of this kind with few cells.

        Args:
            tables: further tables of the case, such as output.
        """
        values = {
            "scenario": self.scenario,
            "title": " ".join(self),
            "lower": _body(self, self.lower, is_upper=False),
            "upper": _body(self, self.upper, is_upper=True),
            self.scenario: _drive(self),
            "grid": _grid(self),
        }
        if self.interface != "smooth":
            values["interface"] = {"friction": 0.2}
        if self.interface == "wear":
            values["interface"]["wear"] = {"lower": "1e-3 mm^3/(N m)", "upper": "1e-3 mm^3/(N m)"}
        return brinell.Case.from_values({**values, **tables})


def covering_kinds() -> list[Kind]:
    """A small set of kinds in which each pair of levels occurs that can occur."""
    possible = [kind for kind in map(Kind._make, itertools.product(*_LEVELS)) if kind.is_possible]
    missing = {pair for kind in possible for pair in pairs(kind)}
    chosen = []
    while missing:
        best = max(possible, key=lambda kind: len(missing & set(pairs(kind))))
        chosen.append(best)
        missing -= set(pairs(best))
    return chosen


def pairs(kind: Kind) -> Iterator[tuple[int, str, int, str]]:
    """Pairs of levels of a kind."""
    for (i, one), (j, other) in itertools.combinations(enumerate(kind), 2):
        yield i, one, j, other


_LEVELS = (tuple(SCENARIOS), MATERIALS, MATERIALS, DOMAINS, INTERFACES)


def _body(kind: Kind, material: str, *, is_upper: bool) -> dict[str, Any]:
    curved = is_upper or kind.scenario == "tugging"
    shape: dict[str, Any] = {"type": "flat"}
    if curved and kind.domain != "periodic":
        shape = {"type": "cylinder" if kind.domain == "plane" else "sphere", "radius": "1 mm"}
    body = {"shape": shape, "material": _material(kind, material)}
    if kind.domain == "periodic" and is_upper:
        body["texture"] = {
            "type": "sinusoid",
            "amplitude": "0.2 um",
            "wavelength_x": "80 um",
            "wavelength_y": "80 um",
        }
    return body


def _material(kind: Kind, material: str) -> dict[str, Any]:
    thermal = {"thermal": {"conductivity": 50, "density": 7850, "specific_heat": 460, "expansion": 12e-6}}
    heated = thermal if kind.interface == "heat" else {}
    if material == "rigid":
        return {"rigid": True}
    table: dict[str, Any] = {"young_modulus": "210 GPa", "poisson_ratio": 0.3, **heated}
    if material == "plastic":
        table["hardening"] = {"law": "linear", "yield_stress": "400 MPa", "modulus": "4 GPa"}
    return table


def _drive(kind: Kind) -> dict[str, Any]:
    load = {"open": {"load": "10 N"}, "plane": {"load": "150 kN"}, "periodic": {"pressure": "300 MPa"}}[kind.domain]
    speed = {"speed": "1 m/s"} if kind.interface == "heat" else {}
    match kind.scenario:
        case "indentation":
            ((key, most),) = load.items()
            return {key: [most, 0], "steps": 2}
        case "tugging":
            return {"interference": "1 um", "normalised": False, **speed}
        case "rolling":
            return {**load, "distance": "120 um", "slide_to_roll": 0.1, **speed}
        case "fretting":
            timing = {"frequency": "20 Hz"} if speed else {}
            pressed = {"load": "2 N"} if kind.domain == "periodic" else load
            return {**pressed, "displacement": "0.2 um", "cycles": 1, "steps_per_cycle": 8, **timing}
        case _:
            return {**load, "distance": "40 um", **speed}


def _grid(kind: Kind) -> dict[str, Any]:
    if kind.domain == "periodic":
        return {"boundary": "periodic", "size": ["80 um", "80 um"], "cells": [8, 8]}
    return {"resolution": 3, "boundary": ["open", "periodic"] if kind.domain == "plane" else "open"}
