# SPDX-License-Identifier: BSD-3-Clause
"""Fatigue of one body under the surface: maps, worst points, profiles over the depth, shakedown, relative life."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from brinell._names import did_you_mean
from brinell.results.errors import RunError, listed
from brinell.results.fields import Body

__all__ = ["Fatigue", "FatiguePlace", "fatigue_of"]

FloatArray = NDArray[np.float64]

FIELDS = (
    "orthogonal_shear",
    "principal_shear",
    "mean_stress",
    "hydrostatic_stress",
    "plastic_strain",
    "ratchetting",
    "shakedown",
    "utilisation",
)
"""Fields of fatigue; in the result file their names begin with "fatigue_"."""


@dataclass(frozen=True)
class FatiguePlace:
    """The largest value of a quantity, and the centre of its cell on the body."""

    value: float
    """In SI units."""
    x: float
    """Along the motion [m]."""
    y: float
    """Across [m]."""
    depth: float
    """[m]."""


@dataclass(frozen=True, eq=False)
class Fatigue:
    """Fatigue of a body in the last cycle of a run: `run.fatigue("lower")`.

    Key numbers are those of the columns over which the contact has passed as a whole; without such columns, of the
    whole body. Fields have all cells.
    """

    body: Body
    criterion: str
    """Word of the case: "dang_van"; "none" without a criterion."""
    cycle: int
    """Number of the cycle that is judged, from 1."""
    orthogonal_shear: FatiguePlace
    """Largest amplitude of the shear xz or yz [Pa]."""
    principal_shear: FatiguePlace
    """Largest principal shear stress [Pa]."""
    utilisation: FatiguePlace | None
    """Largest equivalent stress over its limit: 1 is the endurance limit. None without a criterion."""
    shakedown: str
    """Worst state of a point: "elastic", "elastic_shakedown", "plastic_shakedown" or "ratchetting"."""
    shares: Mapping[str, float]
    """Share of the cells in each of these states."""
    stress_volume: float
    """Stress-volume per length of the track, GPa^c mm^(2-h); NaN where the contact does not travel."""
    life: float
    """Life over that of the reference; NaN where there is none."""
    judged_share: float
    """Share of the cells of the track in which the criterion was evaluated; the others have no utilisation (NaN)."""
    path_error: float
    """Bound for the error of shear amplitudes because steps of the history are left out, over the orthogonal shear."""
    columns: tuple[float, float]
    """Centres of the first and the last column that the key numbers are of [m]."""
    _field: Callable[[Body, str], Any]

    def field(self, name: str) -> Any:
        """A field over z, y and x at the end, as `Run.field` returns it.

        Args:
            name: "orthogonal_shear", "principal_shear", "mean_stress", "hydrostatic_stress", "plastic_strain",
                "ratchetting", "shakedown" (0 to 3) or "utilisation".

        Raises:
            RunError: there is no such field, or it is not stored.
        """
        if name not in FIELDS:
            raise RunError(f"no field of fatigue {name!r}; {did_you_mean(name, FIELDS)}allowed: {listed(FIELDS)}")
        return self._field(self.body, f"fatigue_{name}").isel(step=-1)

    def map(self, name: str = "utilisation") -> FloatArray:
        """(ny, nx) largest value of a field over the depth; NaN where no layer has one."""
        return largest(self.field(name).values, (0,))

    def depth_profile(self, name: str = "utilisation") -> tuple[FloatArray, FloatArray]:
        """Depths of the layers [m], and the largest value of a field in each, over the judged columns."""
        field = self.field(name)
        x = np.asarray(field.coords["x"])
        slack = 1e-6 * abs(x[1] - x[0]) if len(x) > 1 else 0.0
        inside = (x >= self.columns[0] - slack) & (x <= self.columns[1] + slack)
        values = field.values[:, :, inside] if inside.any() else field.values
        return np.asarray(field.coords["z"], dtype=np.float64), largest(values, (1, 2))

    def __repr__(self) -> str:
        worst = f", utilisation {self.utilisation.value:.3g}" if self.utilisation is not None else ""
        return f"<Fatigue {self.body}, {self.criterion}{worst}, {self.shakedown}>"


def largest(values: FloatArray, axes: tuple[int, ...]) -> FloatArray:
    """Largest value along axes, without NaN; NaN where there is no other value."""
    known = np.where(np.isnan(values), -np.inf, values).max(axis=axes)
    return np.where(np.isneginf(known), np.nan, known)


def fatigue_of(summary: Mapping[str, Any] | None, body: Body, field: Callable[[Body, str], Any], place: str) -> Fatigue:
    """The fatigue of a body from the summary of a run.

    Args:
        summary: of the run; None if it has not finished.
        body: "lower" or "upper".
        field: function that returns a field of a body by name.
        place: of the run, for messages.

    Raises:
        RunError: the run has not finished, or fatigue of the body was not computed.
    """
    if body not in ("lower", "upper"):
        raise RunError(f"{place}: no body {body!r}; allowed: 'lower' or 'upper'")
    if summary is None:
        raise RunError(f"{place}: the run has not finished, so that it has no summary")
    numbers = summary.get("fatigue", {}).get(body)
    if numbers is None:
        raise RunError(
            f"{place}: fatigue of the {body} body was not computed; {body}.material.fatigue.criterion of the case "
            "requests it"
        )

    def place_of(name: str, value: str) -> FatiguePlace | None:
        one = numbers[name]
        return None if one is None else FatiguePlace(one[value], one["x_m"], one["y_m"], one["depth_m"])

    def number(name: str) -> float:
        return float("nan") if numbers[name] is None else float(numbers[name])

    orthogonal, principal = place_of("orthogonal_shear", "value_Pa"), place_of("principal_shear", "value_Pa")
    assert orthogonal is not None
    assert principal is not None
    return Fatigue(
        body=body,
        criterion=str(numbers["criterion"]),
        cycle=int(numbers["cycle"]),
        orthogonal_shear=orthogonal,
        principal_shear=principal,
        utilisation=place_of("utilisation", "value"),
        shakedown=str(numbers["shakedown"]),
        shares=dict(numbers["shares"]),
        stress_volume=number("stress_volume"),
        life=number("life"),
        judged_share=number("judged_share"),
        path_error=number("path_error"),
        columns=(float(numbers["columns_m"][0]), float(numbers["columns_m"][1])),
        _field=field,
    )
