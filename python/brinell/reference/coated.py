# SPDX-License-Identifier: BSD-3-Clause
"""Contact of round bodies with elastic layers."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import ArrayLike

from brinell import _core
from brinell._arrays import Array, contiguous, number
from brinell.errors import InputError
from brinell.halfspace import Layer
from brinell.materials import RIGID, Material


class CoatedContact:
    """Frictionless contact of two round bodies, of which one or both have bonded elastic layers.

    The solution of dual integral equations, without cells (Sneddon 1951; Lebedev, Ufliand 1958; Yu, Sanday, Rath 1990).
    """

    def __init__(
        self,
        radius: float,
        lower: Material,
        upper: Material = RIGID,
        *,
        load: float | None = None,
        approach: float | None = None,
        contact_radius: float | None = None,
        lower_layers: Sequence[Layer] = (),
        upper_layers: Sequence[Layer] = (),
    ):
        """Solves the contact for one of load, approach and contact radius.

        Args:
            radius: equivalent radius R, 1/R = 1/R1 + 1/R2 [m].
            lower: material of the lower body beneath its layers; only its elastic constants are used.
            upper: material of the upper body.
            load: normal load, > 0 [N].
            approach: approach of distant points, > 0 [m].
            contact_radius: radius of the contact, > 0 [m].
            lower_layers: layers on the lower body, from its surface.
            upper_layers: layers on the upper body, from its surface.

        Raises:
            InputError: a value is out of range, not exactly one of the three is given, both bodies are rigid, or a
                first layer is thinner than 0.02 contact radii.
        """
        given = {"load": load, "approach": approach, "contact_radius": contact_radius}
        named = [(name, value) for name, value in given.items() if value is not None]
        if len(named) != 1:
            raise InputError("CoatedContact needs one of load, approach and contact_radius")
        name, value = named[0]
        self._engine = _core.CoatedContact(
            number(radius, "radius"),
            name,
            number(value, name),
            lower._engine,
            upper._engine,
            [layer._constants for layer in lower_layers],
            [layer._constants for layer in upper_layers],
        )

    def __repr__(self) -> str:
        return f"<CoatedContact load {self.load:.4g} N, radius {self.contact_radius:.4g} m>"

    @property
    def load(self) -> float:
        """Load P [N]."""
        return self._engine.load

    @property
    def approach(self) -> float:
        """Approach of distant points [m]."""
        return self._engine.approach

    @property
    def contact_radius(self) -> float:
        """Radius of the contact a [m]."""
        return self._engine.contact_radius

    @property
    def stiffness(self) -> float:
        """dP/d(approach) [N/m]: that of a flat punch of the contact radius."""
        return self._engine.stiffness

    def pressure(self, r: ArrayLike) -> Array:
        """Pressure at a distance from the axis.

        Args:
            r: (...) distances [m], >= 0.

        Returns:
            (...) pressure [Pa]; zero outside the contact.
        """
        distances = contiguous(r, "r")
        if np.any(distances < 0.0):
            raise InputError("r is negative; allowed: distances from the axis, >= 0")
        return self._engine.pressure(distances.reshape(-1)).reshape(distances.shape)
