# SPDX-License-Identifier: BSD-3-Clause
# Written by tools/render_python.py from the engine's schema; do not edit.
"""Fields on surfaces that exist where something acts; None: it does not act, or the field is not stored."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

__all__ = ["LOWERING", "FieldsOfBody", "FieldsOfContact"]

FloatArray = NDArray[np.float64]

LOWERING = ("worn_depth",)
"""Depths by which the surface of a body lies deeper than before."""


@dataclass(frozen=True, eq=False, kw_only=True)
class FieldsOfContact:
    """Fields on the contact; (ny, nx) arrays."""

    shear_x: FloatArray | None = None
    """Shear on the lower body along x [Pa]."""
    shear_y: FloatArray | None = None
    """Shear on the lower body along y [Pa]."""
    slip_x: FloatArray | None = None
    """Slip of the upper surface over the lower one since the start, along x [m]."""
    slip_y: FloatArray | None = None
    """Slip of the upper surface over the lower one since the start, along y [m]."""
    slip_path: FloatArray | None = None
    """Length of the way slipped since the start [m]."""
    friction_heat: FloatArray | None = None
    """Heat of friction since the start [J/m^2]."""
    temperature_lower: FloatArray | None = None
    """Temperature of the lower surface [deg C]."""
    temperature_upper: FloatArray | None = None
    """Temperature of the upper surface [deg C]."""
    heat_flux_lower: FloatArray | None = None
    """Heat of friction into the lower body [W/m^2]."""
    heat_flux_upper: FloatArray | None = None
    """Heat of friction into the upper body [W/m^2]."""
    current_density: FloatArray | None = None
    """Density of the electric current, mean over each cell [A/m^2]."""
    film_resistance: FloatArray | None = None
    """Area resistance of the film between the surfaces [ohm m^2]."""


@dataclass(frozen=True, eq=False, kw_only=True)
class FieldsOfBody:
    """Fields on the surface of a body; (ny, nx) arrays."""

    worn_depth: FloatArray | None = None
    """Depth that the surface has lost by wear since the start [m]."""
