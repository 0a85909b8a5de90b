# SPDX-License-Identifier: BSD-3-Clause
# Written by tools/render_python.py from the engine's schema; do not edit.
"""Laws of hardening and of thermal softening."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from brinell._tables import Hardening, Quantity, Softening

__all__ = [
    "Hollomon",
    "JohnsonCook",
    "Linear",
    "LinearSoftening",
    "Ludwik",
    "Perfect",
    "Swift",
    "SwiftMicrostrain",
    "Voce",
]


@dataclass(frozen=True)
class Perfect(Hardening):
    """sigma_y(e) = S_y.

    Attributes:
        yield_stress: Yield stress S_y in uniaxial tension, before any plastic strain. In Pa, > 0.
    """

    law: ClassVar[str] = "perfect"
    yield_stress: Quantity


@dataclass(frozen=True)
class Linear(Hardening):
    """sigma_y(e) = S_y + modulus e.

    Attributes:
        yield_stress: Yield stress S_y in uniaxial tension, before any plastic strain. In Pa, > 0.
        modulus: Growth of the yield stress per unit of equivalent plastic strain. In Pa, >= 0.
    """

    law: ClassVar[str] = "linear"
    yield_stress: Quantity
    modulus: Quantity


@dataclass(frozen=True)
class Swift(Hardening):
    """sigma_y(e) = coefficient (offset + e)^exponent (Swift 1952).

    Attributes:
        coefficient: Factor of the power law. In Pa, > 0.
        offset: Strain offset of the power law; in millionths with swift_microstrain. Allowed: > 0.
        exponent: Exponent of the power law. Allowed: in (0, 1].
    """

    law: ClassVar[str] = "swift"
    coefficient: Quantity
    offset: float
    exponent: float


@dataclass(frozen=True)
class SwiftMicrostrain(Hardening):
    """sigma_y(e) = coefficient (offset + 1e6 e)^exponent, the law of Swift in microstrain.

    Attributes:
        coefficient: Factor of the power law. In Pa, > 0.
        offset: Strain offset of the power law; in millionths with swift_microstrain. Allowed: > 0.
        exponent: Exponent of the power law. Allowed: in (0, 1].
    """

    law: ClassVar[str] = "swift_microstrain"
    coefficient: Quantity
    offset: float
    exponent: float


@dataclass(frozen=True)
class Hollomon(Hardening):
    """sigma_y(e) = coefficient (e_0 + e)^exponent with e_0 such that it begins at S_y (Hollomon 1945).

    Attributes:
        yield_stress: Yield stress S_y in uniaxial tension, before any plastic strain. In Pa, > 0.
        coefficient: Factor of the power law. In Pa, > 0.
        exponent: Exponent of the power law. Allowed: in (0, 1].
    """

    law: ClassVar[str] = "hollomon"
    yield_stress: Quantity
    coefficient: Quantity
    exponent: float


@dataclass(frozen=True)
class Ludwik(Hardening):
    """sigma_y(e) = S_y + coefficient e^exponent (Ludwik 1909).

    Attributes:
        yield_stress: Yield stress S_y in uniaxial tension, before any plastic strain. In Pa, > 0.
        coefficient: Factor of the power law. In Pa, > 0.
        exponent: Exponent of the power law. Allowed: in (0, 1].
    """

    law: ClassVar[str] = "ludwik"
    yield_stress: Quantity
    coefficient: Quantity
    exponent: float


@dataclass(frozen=True)
class Voce(Hardening):
    """sigma_y(e) = S_y + saturation (1 - exp(-rate e)) (Voce 1948).

    Attributes:
        yield_stress: Yield stress S_y in uniaxial tension, before any plastic strain. In Pa, > 0.
        saturation: Largest increase of the yield stress. In Pa, >= 0.
        rate: Rate at which the yield stress saturates with plastic strain. Allowed: > 0.
    """

    law: ClassVar[str] = "voce"
    yield_stress: Quantity
    saturation: Quantity
    rate: float


@dataclass(frozen=True)
class LinearSoftening(Softening):
    """Factor on the yield stress that falls from 1 at the reference to 0 at the melting temperature.

    The factor at the temperature T is linear between T_r and T_m.

    Attributes:
        melting_temperature: Temperature at which no yield stress is left. In degC, > -273.15.
        reference_temperature: Temperature up to which the yield stress is that of the hardening law. In degC,
            > -273.15; default: 20 degC.
    """

    law: ClassVar[str] = "linear"
    melting_temperature: Quantity
    reference_temperature: Quantity = 20.0


@dataclass(frozen=True)
class JohnsonCook(Softening):
    """Factor on the yield stress that falls from 1 at the reference to 0 at the melting temperature.

    The factor at the temperature T is 1 - ((T - T_r)/(T_m - T_r))^exponent (Johnson and Cook 1983).

    Attributes:
        melting_temperature: Temperature at which no yield stress is left. In degC, > -273.15.
        exponent: Exponent m of Johnson and Cook. Allowed: > 0.
        reference_temperature: Temperature up to which the yield stress is that of the hardening law. In degC,
            > -273.15; default: 20 degC.
    """

    law: ClassVar[str] = "johnson_cook"
    melting_temperature: Quantity
    exponent: float
    reference_temperature: Quantity = 20.0
