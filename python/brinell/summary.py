# SPDX-License-Identifier: BSD-3-Clause
"""Summary of a result, independent of the scenario: base class of `Run` and of the results of each scenario."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import MISSING, dataclass, fields
from functools import cached_property
from pathlib import Path
from typing import TYPE_CHECKING, Any, TypeVar

import numpy as np
from numpy.typing import NDArray

from brinell.errors import InputError

if TYPE_CHECKING:  # these modules import the scenarios, which import this module
    from brinell.results.history import History
    from brinell.results.result_file import MemoryFile
    from brinell.scenarios import Scenario

__all__ = ["CriticalValues", "FloatArray", "RunError", "RunSummary", "summary_place", "unfinished"]

FloatArray = NDArray[np.float64]

_T = TypeVar("_T")


class RunError(InputError):
    """A folder or file is not a readable result, or lacks the requested data; the text is one line."""


@dataclass(frozen=True, eq=False)
class CriticalValues:
    """First yield of the normal contact of the two bodies (Green 2005)."""

    C: float
    """Peak pressure over yield stress [-]."""
    interference: float
    """Critical interference alpha_c [m]."""
    load: float
    """Critical load P_c [N]."""
    energy: float
    """Elastic energy U_c [J]."""
    contact_radius: float
    """Contact radius a_c; for cylinders the half-width [m]."""
    contact_area: float
    """Contact area A_c = pi a_c²; for cylinders of length L, 2 a_c L [m²]."""
    peak_pressure: float
    """Peak pressure p0_c = C S_y [Pa]."""

    @property
    def yield_stress(self) -> float:
        """Yield stress S_y of the body that yields first [Pa]."""
        return self.peak_pressure / self.C


@dataclass(frozen=True, eq=False)
class RunSummary:
    """A run with its history, and access to the values of its summary."""

    path: Path
    """Folder of the run, or its file if only that was opened; for a run in memory only a name."""
    history: History
    """History of the run, one row per step."""
    summary: dict[str, Any] | None
    """Key results and the case (docs/reference/results-format.md); None if the run has not finished."""
    memory: MemoryFile | None = None
    """For a run in memory: the content of its result file."""

    @property
    def complete(self) -> bool:
        """Whether the run reached its end."""
        return self.summary is not None

    @property
    def scenario(self) -> Scenario:
        """Name of the scenario."""
        return self.history.scenario

    def _value(self, *keys: str) -> Any:
        """Value of the summary at nested keys.

        Raises:
            RunError: the run has not finished, or there is no such entry.
        """
        if self.summary is None:
            raise unfinished(self.path, self.history.steps)
        entry: Any = self.summary
        for key in keys:
            if not isinstance(entry, Mapping) or key not in entry:
                raise RunError(f"{summary_place(self.path)}: no entry {'.'.join(keys)}")
            entry = entry[key]
        return entry

    def _number(self, *keys: str) -> float:
        value = self._value(*keys)
        if value is None or isinstance(value, bool) or not isinstance(value, int | float) or not np.isfinite(value):
            raise RunError(f"{self._place('.'.join(keys))} = {value!r} is not a number")
        return float(value)

    def case(self, *keys: str) -> Any:
        """Value of the computed case in SI units; None if the case has no such key.

        `run.case("upper", "shape", "radius")` is upper.shape.radius of the case file.

        Raises:
            RunError: the run has not finished.
        """
        entry = self._value("case")
        for key in keys:
            entry = entry.get(key) if isinstance(entry, Mapping) else None
        return entry

    @property
    def has_critical_values(self) -> bool:
        """Whether first yield is known in closed form, as for spheres and cylinders in plane strain."""
        return self._value("critical", "load_N") is not None

    @cached_property
    def critical(self) -> CriticalValues:
        """Values at first yield, used as scales of dimensionless results.

        Raises:
            RunError: there are no critical values, or the run has not finished.
        """
        if not self.has_critical_values:
            raise RunError(
                f"{self.path}: no critical values to normalise with: both bodies are elastic, or they are neither "
                "round nor cylinders in plane strain"
            )
        radius = self._number("critical", "contact_radius_m")
        is_old = "contact_area_m2" not in self._value("critical")  # written before line contacts: always spheres
        return CriticalValues(
            C=self._number("critical", "C"),
            interference=self._number("critical", "interference_m"),
            load=self._number("critical", "load_N"),
            energy=self._number("critical", "energy_J"),
            contact_radius=radius,
            contact_area=np.pi * radius**2 if is_old else self._number("critical", "contact_area_m2"),
            peak_pressure=self._number("critical", "peak_pressure_Pa"),
        )

    @property
    def line_reference(self) -> float | None:
        """Reference distance of the approach of cylinders in plane strain [m]; None for other bodies."""
        exists = self._value("critical").get("line_reference_m") is not None
        return self._number("critical", "line_reference_m") if exists else None

    @property
    def equivalent_radius(self) -> float:
        """Equivalent radius R = 1 / (1/R1 + 1/R2) of spheres or cylinders in plane strain [m]."""
        return self._number("geometry", "equivalent_radius_m")

    def _require(self, scenario: Scenario, what: str) -> None:
        """Checks that the run is of the scenario that has something.

        Raises:
            RunError: the run has another scenario.
        """
        if self.scenario != scenario:
            place = self.path if self.memory is None else self.memory
            raise RunError(f"{place}: is of scenario {self.scenario!r}; only results of {scenario!r} have {what}")

    def _value_of(self, scenario: Scenario, key: str) -> Any:
        """Entry of the summary that is specific to one scenario."""
        self._require(scenario, key)
        return self._value(key)

    def _number_of(self, scenario: Scenario, name: str, *keys: str) -> float:
        """Number of the summary that is specific to one scenario, which has it as attribute `name`."""
        self._require(scenario, name)
        return self._number(*keys)

    def _entry_of(self, scenario: Scenario, key: str, kind: type[_T]) -> _T:
        """Entry that is specific to one scenario, as a dataclass."""
        return _parsed(kind, self._value_of(scenario, key), self._place(key))

    def _entries_of(self, scenario: Scenario, key: str, kind: type[_T]) -> list[_T]:
        """List of entries that is specific to one scenario, as dataclasses."""
        value = self._value_of(scenario, key)
        if not isinstance(value, list):
            raise RunError(f"{self._place(key)} is not a list")
        return [_parsed(kind, entry, self._place(f"{key}[{i}]")) for i, entry in enumerate(value)]

    def _place(self, key: str) -> str:
        return f"{summary_place(self.path)}: {key}"


def _parsed(kind: type[_T], entry: Any, where: str) -> _T:
    """Converts an object of summary.json to a dataclass.

    Args:
        kind: the dataclass; the types of its fields are those in `_READERS`, and fields with a default may be missing.
        entry: the object; null stands for NaN.
        where: file and key, for error messages.

    Raises:
        RunError: a key is missing, or its value is not of the right kind.
    """
    values = {}
    for one in fields(kind):  # type: ignore[arg-type]
        name = one.name.rstrip("_")  # `pass_` has an underscore because `pass` is a keyword
        if one.default is not MISSING and not any(name + unit in entry for unit in _UNITS):
            continue  # a result of an older version
        try:
            key = next(name + unit for unit in _UNITS if name + unit in entry)
            values[one.name] = _READERS[str(one.type)](entry[key])
        except (StopIteration, OverflowError, TypeError, ValueError) as error:
            raise RunError(f"{where}: no {name} that can be read") from error
    return kind(**values)


_UNITS = ("", "_m", "_m2", "_N", "_Nm", "_N_per_m", "_J", "_Pa", "_Pa_per_m")
"""Suffixes of keys in the summary, which give the unit."""

_READERS: Mapping[str, Callable[[Any], Any]] = {
    "bool": bool,
    "int": int,
    "float": lambda value: float("nan") if value is None else float(value),
    "FloatArray": lambda value: np.array(value, dtype=np.float64),
}


def summary_place(path: Path) -> str:
    """Location of the summary of a result folder or file, for messages."""
    return f"{path}: /summary" if path.is_file() else str(path / "summary.json")


def unfinished(path: Path, steps: int) -> RunError:
    """Error for a run without a summary."""
    return RunError(
        f"{path}: no {'/summary' if path.is_file() else 'summary.json'}, the run has not finished ({steps} steps); "
        "allow_unfinished=True opens it as far as it is"
    )
