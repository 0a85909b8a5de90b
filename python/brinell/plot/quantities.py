# SPDX-License-Identifier: BSD-3-Clause
"""The fields of a body that can be drawn: name, symbol, values, scale and colours of each."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Literal

import numpy as np
from matplotlib.colors import Normalize
from numpy.typing import NDArray

from brinell._names import did_you_mean
from brinell.errors import InputError
from brinell.plot import style
from brinell.plot.scales import DEGREES, PERCENT, Scale, Scales
from brinell.results import COMPONENTS, BodyFields

__all__ = ["QUANTITIES", "Quantity", "needs_tensors", "quantity_of"]

FloatArray = NDArray[np.float64]


@dataclass(frozen=True)
class Quantity:
    """A field of a body."""

    name: str
    """As in the results: "von_mises_stress", "stress_xx"."""
    title: str
    symbol: str
    """LaTeX."""
    kind: Literal["stress", "strain", "temperature"]
    component: str = ""
    """Of a tensor: xx ... xy; empty for an equivalent value, which is never negative."""

    def values(self, body: BodyFields) -> FloatArray | None:
        """Values in SI, [z][y][x]; None if the body has no such field."""
        if self.kind == "temperature":
            found = body.temperature
        elif self.component:
            found = (body.stress if self.kind == "stress" else body.plastic_strain).get(self.component)
        else:
            found = body.von_mises_stress if self.kind == "stress" else body.equivalent_plastic_strain
            found = found if body.has(self.name) else None
        return found if found is not None and found.size else None

    def title_in(self, *, in_contact: bool) -> str:
        """Title in a state; stress after unloading is residual stress."""
        is_residual = self.kind == "stress" and not in_contact
        return f"Residual {self.title[0].lower()}{self.title[1:]}" if is_residual else self.title

    def scale(self, scales: Scales, largest: float) -> Scale:
        """The scale of the field."""
        return DEGREES if self.kind == "temperature" else scales.stress(largest) if self.kind == "stress" else PERCENT

    def colours(self, lowest: float, highest: float) -> tuple[str, Normalize]:
        """Colour map and range: from 0, or symmetric about 0; for temperatures from the lowest one."""
        if self.kind == "temperature":
            return style.TEMPERATURE_MAP, Normalize(lowest, highest if highest > lowest else lowest + 1.0)
        if not self.component:
            return (style.STRESS_MAP if self.kind == "stress" else style.STRAIN_MAP), Normalize(0.0, highest or 1.0)
        reach = max(-lowest, highest) or 1.0
        return style.SIGNED_MAP, Normalize(-reach, reach)


QUANTITIES: Mapping[str, Quantity] = {
    quantity.name: quantity
    for quantity in (
        Quantity("von_mises_stress", "Von Mises stress", r"\sigma_\mathrm{vM}", "stress"),
        Quantity("equivalent_plastic_strain", "Equivalent plastic strain", r"\varepsilon^p_\mathrm{eq}", "strain"),
        *(Quantity(f"stress_{c}", f"Stress ${c}$", rf"\sigma_{{{c}}}", "stress", c) for c in COMPONENTS),
        *(
            Quantity(f"plastic_strain_{c}", f"Plastic strain ${c}$", rf"\varepsilon^p_{{{c}}}", "strain", c)
            for c in COMPONENTS
        ),
        Quantity("temperature", "Temperature", "T", "temperature"),
    )
}
"""By name."""


def quantity_of(name: str) -> Quantity:
    """The field of this name.

    Raises:
        InputError: there is none.
    """
    if name in QUANTITIES:
        return QUANTITIES[name]
    raise InputError(f"{name!r} is not a field; {did_you_mean(name, QUANTITIES)}allowed: {', '.join(QUANTITIES)}")


def needs_tensors(quantities: Sequence[Quantity]) -> bool:
    """Whether one of the fields needs components of a tensor."""
    return any(quantity.component for quantity in quantities)
