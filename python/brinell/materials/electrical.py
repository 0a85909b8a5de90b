# SPDX-License-Identifier: BSD-3-Clause
"""Electrical constants of a material."""

from __future__ import annotations

from dataclasses import dataclass

from brinell._tables import CaseTable, Quantity

__all__ = ["Electrical"]


@dataclass(frozen=True)
class Electrical(CaseTable):
    """Electrical constants of a body, which conducts.

    Attributes:
        resistivity: resistivity at 20 deg C, > 0 [ohm m], or text such as "1.7e-8 ohm m".
        temperature_coefficient: growth of the resistivity per degree over that at 20 deg C, >= 0 [1/K].
    """

    resistivity: Quantity
    temperature_coefficient: Quantity = 0.0
