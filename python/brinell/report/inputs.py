# SPDX-License-Identifier: BSD-3-Clause
"""The case as computed, as a readable table: keys of the case file, values with their units."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from typing import Any

from brinell.report import text
from brinell.results import Run

__all__ = ["UNITS", "Input", "inputs_of"]

UNITS: Mapping[str, str] = {
    **dict.fromkeys(
        (
            "radius",
            "radius_x",
            "radius_y",
            "length",
            "tip_radius",
            "edge_radius",
            "depth",
            "height",
            "heights",
            "spacing",
            "x",
            "y",
            "interference",
            "mean_gap",
            "approach",
            "places",
            "displacement",
            "distance",
            "shift",
            "offset",
            "width",
            "amplitude",
            "wavelength_x",
            "wavelength_y",
            "rms_height",
            "rolloff",
            "cutoff",
            "size",
            "layer",
            "reference",
            "region_x",
            "region_y",
            "region_z",
        ),
        "m",
    ),
    **dict.fromkeys(
        (
            "young_modulus",
            "yield_stress",
            "shear_limit",
            "modulus",
            "coefficient",
            "saturation",
            "stress",
            "value",
            "hertz_pressure",
            "pressure",
        ),
        "Pa",
    ),
    "force": "N",
    "load": "N",
    "direction": "°",
    "half_angle": "°",
    "spin": "rad/m",
    "speed": "m/s",
    "frequency": "Hz",
    "conductivity": "W/(m K)",
    "conductance": "W/(m² K)",
    "power": "W",
    "flux": "W/m²",
    "density": "kg/m³",
    "specific_heat": "J/(kg K)",
    "expansion": "1/K",
    **dict.fromkeys(("temperature", "reference_temperature", "melting_temperature"), "°C"),
    **dict.fromkeys(("lower", "upper"), "1/Pa"),  # of wear
    "checkpoint_interval": "s",
}
"""Unit of each key of a case that has one; the last part of its name tells."""

_PURE = "hardening.offset"
"""A strain, whose last part is the name of a length."""

_NORMALISED = {"load": "P_c", "interference": "α_c", "approach": "α_c", "offset": "a_c"}
"""What these keys count where `normalised` is true."""


@dataclass(frozen=True)
class Input:
    """One key of the case."""

    key: str
    """Within its section: "shape.radius"."""
    value: str
    is_text: bool = False
    """Whether the user wrote the value as text, such as the name of a file, in which there are no symbols."""


def inputs_of(run: Run) -> dict[str, list[Input]]:
    """The keys by section of the case file: lower, upper, the scenario, grid, solver, output.

    Raises:
        RunError: the run has not finished.
    """
    case = run.case()
    return {section: list(_flattened(content, "")) for section, content in case.items() if isinstance(content, Mapping)}


def _flattened(content: Mapping[str, Any], prefix: str) -> Iterator[Input]:
    normalised = content.get("normalised") is True
    for key, value in content.items():
        if isinstance(value, Mapping):
            yield from _flattened(value, f"{prefix}{key}.")
        elif isinstance(value, list) and value and all(isinstance(one, Mapping) for one in value):
            for index, one in enumerate(value):
                yield from _flattened(one, f"{prefix}{key}[{index}].")
        else:
            unit = _NORMALISED.get(key) if normalised else None
            known = "" if f"{prefix}{key}".endswith(_PURE) else UNITS.get(key, "")
            yield Input(f"{prefix}{key}", _written(value, unit or known), isinstance(value, str))


def _written(value: Any, unit: str) -> str:
    most = 12
    if isinstance(value, list) and len(value) > most:
        return f"{len(value)} values from {_written(min(value), unit)} to {_written(max(value), unit)}"
    if isinstance(value, list):
        return ", ".join(_written(one, unit) for one in value) or "none"
    if isinstance(value, bool):
        return "yes" if value else "no"
    if isinstance(value, int | float):
        return _of_number(float(value), unit)
    return "none" if value is None else str(value)


_WITHOUT_PREFIX = frozenset({"°", "s", "W/(m K)", "kg/m³", "J/(kg K)", "1/K", "1/Pa", "°C", *_NORMALISED.values()})


def _of_number(value: float, unit: str) -> str:
    if unit in _WITHOUT_PREFIX:
        return f"{text.number(value, 4)} {unit}"
    return text.quantity(value, unit, 4)
