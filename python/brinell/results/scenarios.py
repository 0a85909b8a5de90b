# SPDX-License-Identifier: BSD-3-Clause
"""What differs between the scenarios: the columns of their history, and what their summary lists.

All numbers are SI.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Mapping
from dataclasses import MISSING, dataclass, fields
from types import MappingProxyType
from typing import Any, Literal, TypeVar, get_args

import numpy as np
from numpy.typing import NDArray

from brinell import _core
from brinell.results.errors import RunError

__all__ = [
    "COLUMN_UNITS",
    "HISTORY_COLUMNS",
    "INTEGER_COLUMNS",
    "OF_A_PERIOD",
    "Indent",
    "RollingPass",
    "Scenario",
    "TrackProfile",
    "distance_from_middle",
    "parsed",
    "scenario_of",
]

FloatArray = NDArray[np.float64]

Scenario = Literal["tugging", "indentation", "rolling"]
"""Names of the scenarios, as in the case file."""

OF_A_PERIOD = ("nominal_pressure", "contact_fraction", "mean_gap", "contact_stiffness")
"""Columns that are NaN unless both axes are periodic; the stiffness is infinite in full contact."""

_OF_FRICTION = ("dissipation_friction", "F_friction", "share_at_shear_limit")
_ADDED_LATER = ("height", "friction", "contact_cells", *OF_A_PERIOD, *_OF_FRICTION)
"""Columns that the histories of older versions do not have."""

HISTORY_COLUMNS: Mapping[Scenario, tuple[str, ...]] = MappingProxyType(
    {
        scenario: tuple(column.name for column in _core.columns()[scenario] if column.name not in _ADDED_LATER)
        for scenario in get_args(Scenario)
    }
)
"""Columns that history.csv must have in each scenario, in order; a file may have more."""

INTEGER_COLUMNS: Mapping[Scenario, frozenset[str]] = MappingProxyType(
    {
        scenario: frozenset(column.name for column in _core.columns()[scenario] if column.is_integer)
        for scenario in get_args(Scenario)
    }
)
"""Those that count or number something."""

COLUMN_UNITS: Mapping[Scenario, Mapping[str, str]] = MappingProxyType(
    {
        scenario: MappingProxyType({column.name: column.unit for column in _core.columns()[scenario]})
        for scenario in get_args(Scenario)
    }
)
"""Units of the columns; "1" for a pure number."""

# Smallest for the state that "aligned" stands for. In an indentation the stored steps are the ends of the list of
# loads: the unloaded ones have nothing to show.
_DISTANCES: Mapping[Scenario, Callable[[Mapping[str, float]], float]] = {
    "tugging": lambda row: abs(row["X"]),
    "indentation": lambda row: -row["F_n"],
    "rolling": lambda row: abs(row["x"]),
}


def scenario_of(columns: Iterable[str]) -> Scenario:
    """The scenario that a history with these columns belongs to.

    Raises:
        RunError: none has all of its columns; the text names the likeliest one and what it lacks.
    """
    present = set(columns)
    missing = {name: [c for c in HISTORY_COLUMNS[name] if c not in present] for name in get_args(Scenario)}
    likeliest: Scenario = min(missing, key=lambda name: len(missing[name]))
    if missing[likeliest]:
        raise RunError(f"the header is not that of a history (of {likeliest} without {', '.join(missing[likeliest])})")
    return likeliest


def distance_from_middle(scenario: Scenario, row: Mapping[str, float]) -> float:
    """How far a step is from the one that "aligned" stands for: smallest for the nearest.

    Args:
        scenario: of the run.
        row: the step's row of the history.
    """
    return _DISTANCES[scenario](row)


@dataclass(frozen=True)
class Indent:
    """One loading and unloading at one place: read at the largest load, and where the contact opens."""

    place: int
    """Which of the places of the case; counts from 1."""
    cycle: int
    """Of the loads at this place; counts from 1."""
    x: float
    """Where the indenter's apex is on the lower body [m]."""
    max_load: float
    """[N]."""
    max_approach: float
    """Approach at that load, from first touch of the undeformed bodies [m]."""
    contact_area: float
    """Projected, at that load [m^2]."""
    hardness: float
    """Largest load over that area [Pa]."""
    loading_stiffness: float
    """Slope of load over approach on the way to the largest load [N/m]."""
    unloading_stiffness: float
    """Slope on the way back from it [N/m]; 0 without unloading."""
    final_approach: float
    """Approach at which the contact opens [m]; NaN if it does not."""
    residual_depth: float
    """Largest residual displacement of the lower body then, into the body positive [m]."""
    pile_up: float
    """Largest height of its residual surface then, outwards positive [m]."""
    work: float
    """Net work of the drive in this indent [J]."""
    contact_fraction: float = math.nan
    """Contact area over that of the period, at the largest load; NaN unless both axes are periodic [-]."""
    mean_gap: float = math.nan
    """Mean gap over the period then [m]; NaN unless both axes are periodic."""
    contact_stiffness: float = math.nan
    """Elastic, nominal pressure over mean gap as they change, then [Pa/m]; NaN unless both axes are periodic."""


@dataclass(frozen=True)
class RollingPass:
    """What one pass has left, under the middle of the track."""

    pass_: int
    """Which one; counts from 1."""
    rut_depth: float
    """Residual displacement of the lower body at x = y = 0, into the body positive [m]."""
    shoulder_height: float
    """Largest height of its residual surface in the section x = 0, outwards positive [m]."""
    max_equivalent_plastic_strain: float
    """Largest over both bodies [-]."""
    track_plastic_strain: float
    """Largest equivalent plastic strain of the lower body under x = y = 0 [-]."""
    track_plastic_increment: float
    """Largest growth of it in this pass [-]."""
    dissipation: float
    """Plastic work in both bodies in this pass [J]."""
    resistance: float
    """Energy that both bodies take up, dissipated and locked in, per length over the middle half of the track [N]."""
    max_pressure: float
    """Mean over the same of the largest pressure [Pa]."""
    steady: bool = False
    """Whether the resistance was the same all along: then it does not depend on the length of the track."""
    unsteadiness: float = math.nan
    """Difference of it between the two quarters of the middle half, over the larger of them; steady up to 0.1 [-]."""
    mean_F_X: float = math.nan
    """Mean F_X over the middle half of the track, positive if it resists the motion [N]."""
    friction: float = math.nan
    """Mean F_X over mean F_n over the same [-]."""
    contact_area: float = math.nan
    """Mean over the same [m^2]."""


@dataclass(frozen=True, eq=False)
class TrackProfile:
    """Under x = y = 0 of the lower body after the last pass, unloaded; one value per layer of cells."""

    depth: FloatArray
    """Of the layers' centres, > 0 [m]."""
    residual_xx: FloatArray
    """Residual stress along the motion, positive in tension [Pa]."""
    residual_yy: FloatArray
    """Residual stress across it, positive in tension [Pa]."""
    equivalent_plastic_strain: FloatArray
    """[-]."""


_T = TypeVar("_T", Indent, RollingPass, TrackProfile)


def parsed(kind: type[_T], entry: Any, where: str) -> _T:
    """An object of summary.json as one of the classes above, whose names are the keys without their unit.

    Args:
        kind: the class.
        entry: the object; null stands for NaN.
        where: file and key, for the message.

    Raises:
        RunError: a key is missing, or its value is not of the right kind.
    """
    values = {}
    for one in fields(kind):
        name = one.name.rstrip("_")  # of `pass_`, which is no name in Python
        if one.default is not MISSING and not any(name + unit in entry for unit in _UNITS):
            continue  # a result of an older version
        try:
            key = next(name + unit for unit in _UNITS if name + unit in entry)
            values[one.name] = _READERS[str(one.type)](entry[key])
        except (StopIteration, OverflowError, TypeError, ValueError) as error:
            raise RunError(f"{where}: no {name} that can be read") from error
    return kind(**values)


_UNITS = ("", "_m", "_m2", "_N", "_N_per_m", "_J", "_Pa", "_Pa_per_m")
"""What keys of the summary end with."""

_READERS: Mapping[str, Callable[[Any], Any]] = {
    "bool": bool,
    "int": int,
    "float": lambda value: float("nan") if value is None else float(value),
    "FloatArray": lambda value: np.array(value, dtype=np.float64),
}
