# SPDX-License-Identifier: BSD-3-Clause
"""Columns of the histories of all scenarios, as the engine defines them, and recognition of the scenario."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from types import MappingProxyType

from brinell import _core
from brinell.results.errors import RunError
from brinell.scenarios import SCENARIOS, Scenario

__all__ = [
    "COLUMN_UNITS",
    "HISTORY_COLUMNS",
    "INTEGER_COLUMNS",
    "NOT_ALWAYS_FINITE",
    "OF_A_PERIOD",
    "scenario_of",
]

OF_A_PERIOD = ("nominal_pressure", "contact_fraction", "mean_gap", "contact_stiffness")
"""Columns that are NaN unless both axes are periodic; the stiffness is infinite in full contact."""

_OF_FRICTION = ("dissipation_friction", "F_friction", "share_at_shear_limit")
_OF_STICK_AND_SLIP = ("F_x", "F_y", "M_z", "stick_share", "stick_area", "slip_path")  # of rolling
_OF_HEAT = (
    "max_temperature_lower",
    "max_temperature_upper",
    "heat_lower",
    "heat_upper",
    "heat_of_source",
    "heat_of_current",
    "heat_of_plastic_work",
    "work_of_expansion",
)
_OF_EFFECTS = tuple(column.name for column in _core.effect_columns())
NOT_ALWAYS_FINITE = frozenset(
    (*OF_A_PERIOD, *(column.name for column in _core.effect_columns() if column.may_be_infinite))
)
"""Columns that may be infinite or NaN: of a period, and of effects such as a current without contact."""

_ADDED_LATER = (
    *("height", "friction", "contact_cells", "patches", "largest_patch"),
    *OF_A_PERIOD,
    *_OF_FRICTION,
    *_OF_STICK_AND_SLIP,
    *_OF_HEAT,
    *_OF_EFFECTS,
)
"""Columns that the histories of older versions do not have."""

HISTORY_COLUMNS: Mapping[Scenario, tuple[str, ...]] = MappingProxyType(
    {
        scenario: tuple(column.name for column in _core.columns()[scenario] if column.name not in _ADDED_LATER)
        for scenario in SCENARIOS
    }
)
"""Columns that history.csv must have in each scenario, in order; a file may have more."""

INTEGER_COLUMNS: Mapping[Scenario, frozenset[str]] = MappingProxyType(
    {
        scenario: frozenset(column.name for column in _core.columns()[scenario] if column.is_integer)
        for scenario in SCENARIOS
    }
)
"""Columns with counts or numbers of steps, passes and so on."""

COLUMN_UNITS: Mapping[Scenario, Mapping[str, str]] = MappingProxyType(
    {
        scenario: MappingProxyType({column.name: column.unit for column in _core.columns()[scenario]})
        for scenario in SCENARIOS
    }
)
"""Units of the columns; "1" for a pure number."""


def scenario_of(columns: Iterable[str]) -> Scenario:
    """Scenario of a history with these columns.

    Raises:
        RunError: the columns of no scenario are complete; the text names the most likely scenario and the missing
            columns.
    """
    present = set(columns)
    missing = {name: [c for c in HISTORY_COLUMNS[name] if c not in present] for name in SCENARIOS}
    # The columns of one scenario may be a subset of those of another.
    likeliest: Scenario = min(missing, key=lambda name: (len(missing[name]), len(present - COLUMN_UNITS[name].keys())))
    if missing[likeliest]:
        raise RunError(f"the header is not that of a history (of {likeliest} without {', '.join(missing[likeliest])})")
    return likeliest
