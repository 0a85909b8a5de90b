# SPDX-License-Identifier: BSD-3-Clause
"""Materials: elastic constants, hardening and softening laws, profiles over depth, thermal and electrical constants.

    steel = Material("210 GPa", 0.3, Swift(coefficient="2.1 GPa", offset=4e-3, exponent=0.095))
    other = preset("S355")
    soft = Material(70e9, 0.33, hardening=lambda e: 250e6 + 180e6 * np.tanh(30 * e))

Numbers are in SI units; text has its own unit, as in the case file. e is the equivalent plastic strain, sigma_y(e) the
yield stress in uniaxial tension.
"""

from brinell._tables import Hardening, Softening
from brinell.materials.curves import MeasuredCurve
from brinell.materials.electrical import Electrical
from brinell.materials.fatigue import FatigueConstants
from brinell.materials.hardening import Table
from brinell.materials.laws import (
    Hollomon,
    JohnsonCook,
    Linear,
    LinearSoftening,
    Ludwik,
    Perfect,
    Swift,
    SwiftMicrostrain,
    Voce,
)
from brinell.materials.material import RIGID, Material
from brinell.materials.presets import PRESETS, Preset, preset
from brinell.materials.sampling import Law
from brinell.materials.thermal import SofteningTable, Thermal

__all__ = [
    "PRESETS",
    "RIGID",
    "Electrical",
    "FatigueConstants",
    "Hardening",
    "Hollomon",
    "JohnsonCook",
    "Law",
    "Linear",
    "LinearSoftening",
    "Ludwik",
    "Material",
    "MeasuredCurve",
    "Perfect",
    "Preset",
    "Softening",
    "SofteningTable",
    "Swift",
    "SwiftMicrostrain",
    "Table",
    "Thermal",
    "Voce",
    "preset",
]
