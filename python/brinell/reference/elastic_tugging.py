# SPDX-License-Identifier: BSD-3-Clause
"""Elastic tugging: two elastic bodies that move past each other with interference."""

from __future__ import annotations

from dataclasses import dataclass

from numpy.typing import ArrayLike

from brinell import _core
from brinell._arrays import Array, number, numbers, points, require_positive
from brinell.errors import InputError
from brinell.reference.hertz import approach_origin, line_contact, point_contact


@dataclass(frozen=True)
class TuggingForces:
    """Forces of two elastic spheres or cylinders that pass each other.

    Attributes:
        load: (...) force P along the line of centres [N].
        F_X: (...) force along the motion, positive if it resists the motion, as before alignment [N].
        F_Z: (...) normal force, positive if it presses the bodies apart [N].
        interference: (...) interference of the undeformed bodies along the line of centres; 0 without contact [m].
    """

    load: Array
    F_X: Array
    F_Z: Array
    interference: Array


class ElasticTugging:
    """Two elastic bodies, of which the upper one moves past the lower one at constant height, without friction.

    At the sliding coordinate X the distance of the centres is omega', omega'^2 = omega^2 + X^2, with
    omega = R1 + R2 - interference; F_X = -P X/omega', F_Z = P omega/omega'. P is the load at the approach
    R1 + R2 - omega': 4/3 E' sqrt(R) approach^1.5 for spheres; for cylinders the load per length of `line_contact` times
    their length.
    """

    def __init__(
        self,
        radius_lower: float,
        radius_upper: float,
        contact_modulus: float,
        interference: float,
        *,
        length: float | None = None,
        reference: float | None = None,
    ):
        """Defines two spheres, or two cylinders in plane strain if a length is given.

        Args:
            radius_lower: radius R1 of the lower body [m].
            radius_upper: radius R2 of the upper body [m].
            contact_modulus: contact modulus E' [Pa].
            interference: interference at alignment, in (0, R1 + R2) [m].
            length: length of cylinders, to which forces and energies refer [m]; None: spheres.
            reference: for cylinders: reference distance l of the approach [m]; None: 2 R/e.

        Raises:
            InputError: a value is out of range.
        """
        if length is None and reference is not None:
            raise InputError("reference goes with cylinders: give their length")
        require_positive(radius_lower=radius_lower, radius_upper=radius_upper)
        radius = 1.0 / (1.0 / radius_lower + 1.0 / radius_upper)
        line = None if length is None else (number(length, "length"), approach_origin(radius, reference))
        lower, upper, modulus, overlap = numbers(
            radius_lower=radius_lower,
            radius_upper=radius_upper,
            contact_modulus=contact_modulus,
            interference=interference,
        )
        self._engine = _core.ElasticTugging(lower, upper, modulus, overlap, line)

    @property
    def half_sliding_distance(self) -> float:
        """Half the sliding distance in contact, d0 [m]: the contact lasts from X = -d0 to d0.

        Source: Boucly, Nelias, Green 2006, Eq. 2.
        """
        return self._engine.half_sliding_distance()

    def forces(self, X: ArrayLike) -> TuggingForces:
        """Forces at the sliding coordinates X.

        Args:
            X: (...) sliding coordinates, 0 at alignment [m].

        Returns:
            Forces and interference of shape (...).
        """
        shape, (X,) = points(X=X)
        return TuggingForces(*self._engine.forces(X).reshape(4, *shape))

    def peak(self) -> tuple[float, float]:
        """Largest F_X [N], and the coordinate X < 0 at which it occurs [m]."""
        return self._engine.peak()

    def work(self, X1: float, X2: float) -> float:
        """Work of F_X from X1 to X2 [J]."""
        return self._engine.work(X1, X2)


def elastic_tugging_reach(lower_radius: float, upper_radius: float, interference: float) -> float:
    """Sliding coordinate d0 at which two elastic spheres or cylinders separate (Boucly, Nelias, Green 2006, Eq. 2).

    Args:
        lower_radius: radius of the lower sphere [m].
        upper_radius: radius of the upper sphere [m].
        interference: rigid-body interference at alignment [m], > 0.

    Returns:
        Half the sliding distance in contact [m]; the contact lasts from -d0 to d0.
    """
    return ElasticTugging(lower_radius, upper_radius, 1.0, interference).half_sliding_distance


def elastic_tugging_forces(
    X: ArrayLike,
    lower_radius: float,
    upper_radius: float,
    interference: float,
    critical_interference: float,
    *,
    reference: float | None = None,
) -> tuple[Array, Array]:
    """Forces of two elastic spheres or cylinders relative to the critical load, which need no elastic constants.

    Args:
        X: (...) sliding coordinates, 0 at alignment [m].
        lower_radius: radius of the lower body [m].
        upper_radius: radius of the upper body [m].
        interference: rigid-body interference at alignment [m], > 0.
        critical_interference: interference at first yield, alpha_c [m].
        reference: for cylinders: reference distance l of the approach [m]; None: spheres.

    Returns:
        F_X / P_c and F_Z / P_c, each (...) [-]; zero where the bodies do not touch.
    """
    radius = 1.0 / (1.0 / lower_radius + 1.0 / upper_radius)
    if reference is None:
        critical_load = point_contact(radius, 1.0, approach=critical_interference).load
        forces = ElasticTugging(lower_radius, upper_radius, 1.0, interference).forces(X)
    else:
        critical_load = line_contact(radius, 1.0, approach=critical_interference, reference=reference).load_per_length
        cylinders = ElasticTugging(lower_radius, upper_radius, 1.0, interference, length=1.0, reference=reference)
        forces = cylinders.forces(X)
    return forces.F_X / critical_load, forces.F_Z / critical_load
