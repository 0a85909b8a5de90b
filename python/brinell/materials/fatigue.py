# SPDX-License-Identifier: BSD-3-Clause
# Written by tools/render_python.py from the engine's schema; do not edit.
"""Fatigue constants of a material."""

from __future__ import annotations

from dataclasses import KW_ONLY, dataclass
from typing import Literal

from brinell._tables import CaseTable, Quantity

__all__ = ["FatigueConstants"]


@dataclass(frozen=True)
class FatigueConstants(CaseTable):
    """Criterion of fatigue and constants of the life of a material; they request the fatigue of the body.

    Attributes:
        criterion: Criterion by which the stress history of each point of the body over the last cycle (pass, stroke,
            cycle, indent) is judged. dang_van: mesoscopic shear and hydrostatic stress (Dang Van 1989); crossland:
            amplitude of sqrt(J2) and largest hydrostatic stress (Crossland 1956); findley: shear amplitude and largest
            normal stress on the worst plane (Findley 1959); fatemi_socie: shear strain amplitude, with plastic strain,
            and largest normal stress on the worst plane (Fatemi and Socie 1988); none: shear amplitudes, shakedown and
            life only.
        torsion_limit: Amplitude of the shear stress endured in reversed torsion. In Pa, > 0; only with criterion =
            "dang_van" or "crossland" or "findley" or "fatemi_socie".
        bending_limit: Amplitude of the stress endured in reversed bending. Its ratio to the torsion limit sets the
            weight of the hydrostatic or normal stress. In Pa, > 0; only with criterion = "dang_van" or "crossland" or
            "findley" or "fatemi_socie".
        map: Cells in which a criterion of critical planes is evaluated: those of the track that may reach 0.9 of its
            largest value (others have no value, NaN), or all, which takes far longer. Default: "worst"; only with
            criterion = "findley" or "fatemi_socie".
        stress_exponent: Exponent c of the shear amplitude in the stress-volume integral of Lundberg and Palmgren
            (1947). Allowed: in (0, 30]; default: 10.333333333333334; only with criterion = "none" or "dang_van" or
            "crossland" or "findley" or "fatemi_socie".
        weibull_slope: Exponent e of the life: 10/9 for point contact, 9/8 for line contact. Allowed: in (0, 30];
            default: 1.1111111111111112; only with criterion = "none" or "dang_van" or "crossland" or "findley" or
            "fatemi_socie".
        depth_exponent: Exponent h of the depth, by which the integrand is divided. Allowed: in [0, 30]; default:
            2.3333333333333335; only with criterion = "none" or "dang_van" or "crossland" or "findley" or
            "fatemi_socie".
        shear_threshold: Shear amplitude that causes no failure; it is subtracted in the integral (Ioannides and Harris
            1985). In Pa, >= 0; default: 0.0; only with criterion = "none" or "dang_van" or "crossland" or "findley" or
            "fatemi_socie".
        reference: Stress-volume per length of track, stress_volume of the summary, of the case whose life is 1.
            Allowed: > 0; default: median over the columns of the track; only with criterion = "none" or "dang_van" or
            "crossland" or "findley" or "fatemi_socie".
    """

    criterion: Literal["none", "dang_van", "crossland", "findley", "fatemi_socie"]
    torsion_limit: Quantity | None = None
    bending_limit: Quantity | None = None
    _: KW_ONLY
    map: Literal["worst", "all"] | None = None
    stress_exponent: float | None = None
    weibull_slope: float | None = None
    depth_exponent: float | None = None
    shear_threshold: Quantity | None = None
    reference: float | None = None
