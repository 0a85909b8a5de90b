# SPDX-License-Identifier: BSD-3-Clause
"""Closed-form solutions to lay under computed curves.

Elastic limit of the tugging of two spheres: at the sliding coordinate X the centres are omega' apart,
``omega'^2 = omega^2 + X^2``, and the Hertz force of the remaining interference acts along the line of centres::

    P   = 4/3 E' sqrt(R) (R1 + R2 - omega')^(3/2)
    F_X = -P X / omega'          resistance to the motion: positive before alignment, X < 0
    F_Z =  P omega / omega'

With ``P_c = 4/3 E' sqrt(R) alpha_c^(3/2)`` the forces over the critical load need no elastic constant.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike, NDArray

__all__ = ["elastic_tugging_forces", "elastic_tugging_reach"]


def elastic_tugging_reach(lower_radius: float, upper_radius: float, interference: float) -> float:
    """Sliding coordinate at which two elastic spheres part, d0 (Eq. 2 of Boucly, Nelias, Green 2006).

    Args:
        lower_radius: radius of the lower sphere [m].
        upper_radius: radius of the upper sphere [m].
        interference: rigid-body interference at alignment [m], > 0.

    Returns:
        Half the sliding distance in contact [m]; the contact lasts from -d0 to d0.
    """
    total = lower_radius + upper_radius
    separation = total - interference
    return float(np.sqrt(total**2 - separation**2))


def elastic_tugging_forces(
    X: ArrayLike, lower_radius: float, upper_radius: float, interference: float, critical_interference: float
) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Forces of two elastic spheres over the critical load.

    Args:
        X: sliding coordinate, 0 at alignment [m].
        lower_radius: radius of the lower sphere [m].
        upper_radius: radius of the upper sphere [m].
        interference: rigid-body interference at alignment [m], > 0.
        critical_interference: interference at first yield, alpha_c [m].

    Returns:
        F_X / P_c and F_Z / P_c [-], zero where the spheres do not touch.
    """
    X = np.asarray(X, dtype=np.float64)
    total = lower_radius + upper_radius
    omega = total - interference
    omega_local = np.hypot(omega, X)
    load = (np.clip(total - omega_local, 0.0, None) / critical_interference) ** 1.5
    return -load * X / omega_local + 0.0, load * omega / omega_local
