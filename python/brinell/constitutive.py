# SPDX-License-Identifier: BSD-3-Clause
"""Plasticity at a material point: yield curves, and the return mappings of the engine.

Tensors have six components, first in an array: xx, yy, zz, yz, xz, xy. Stress is positive in tension.
"""

from __future__ import annotations

import sys
from dataclasses import dataclass
from typing import Literal, TypeAlias

import numpy as np
from numpy.typing import ArrayLike

from brinell import _core
from brinell._arguments import explain_argument_errors
from brinell._arrays import Array, contiguous, points
from brinell.errors import InputError
from brinell.materials import Hardening, Law, Material, Perfect, Softening

__all__ = [
    "Integration",
    "PlasticIncrement",
    "hardening_modulus",
    "plastic_work",
    "return_mapping",
    "softening_factor",
    "yield_stress",
]

Integration: TypeAlias = Literal["path", "backward_euler"]


def yield_stress(law: Hardening | Law, equivalent_plastic_strain: ArrayLike) -> Array:
    """The yield curve sigma_y(e).

    Args:
        law: hardening law of `brinell.materials`, or a function sigma_y(e).
        equivalent_plastic_strain: (...) equivalent plastic strain e, >= 0 [-].

    Returns:
        (...) yield stress [Pa].
    """
    shape, (e,) = points(equivalent_plastic_strain=equivalent_plastic_strain)
    return _core.yield_stress(_material(law), e).reshape(shape)


def hardening_modulus(law: Hardening | Law, equivalent_plastic_strain: ArrayLike) -> Array:
    """The slope d sigma_y / d e of the yield curve.

    Args:
        law: hardening law of `brinell.materials`, or a function sigma_y(e).
        equivalent_plastic_strain: (...) equivalent plastic strain e, >= 0 [-].

    Returns:
        (...) hardening modulus [Pa]; it may be infinite at e = 0.
    """
    shape, (e,) = points(equivalent_plastic_strain=equivalent_plastic_strain)
    return _core.hardening_modulus(_material(law), e).reshape(shape)


def plastic_work(law: Hardening | Law, equivalent_plastic_strain: ArrayLike) -> Array:
    """The work under the yield curve, the integral of sigma_y from 0 to e.

    Args:
        law: hardening law of `brinell.materials`, or a function sigma_y(e).
        equivalent_plastic_strain: (...) equivalent plastic strain e, >= 0 [-].

    Returns:
        (...) plastic work per volume [J/m^3].
    """
    shape, (e,) = points(equivalent_plastic_strain=equivalent_plastic_strain)
    return _core.plastic_work(_material(law), e).reshape(shape)


def softening_factor(law: Softening, temperature: ArrayLike) -> Array:
    """Factor of thermal softening on the yield stress, at least 0.01.

    Args:
        law: softening law of `brinell.materials`.
        temperature: (...) temperature [deg C].

    Returns:
        (...) factor [-].
    """
    shape, (t,) = points(temperature=temperature)
    material = Material(1.0, 0.0, Perfect(1.0), softening=law)  # the other constants have no effect
    return _core.softening_factor(material._engine, t).reshape(shape)


@dataclass(frozen=True)
class PlasticIncrement:
    """Result of a return mapping at many points.

    Attributes:
        plastic_strain: (6, ...) increment of the plastic strain, traceless [-].
        equivalent_plastic_strain: (...) increment of the equivalent plastic strain e, >= 0 [-].
        dissipation: (...) plastic work of the increment [J/m^3].
        stress: (6, ...) stress after the increment: trial stress minus 2 mu times the plastic strain increment [Pa].
        backstress: (terms, 6, ...) back stresses after the increment [Pa].
    """

    plastic_strain: Array
    equivalent_plastic_strain: Array
    dissipation: Array
    stress: Array
    backstress: Array


def return_mapping(
    material: Material,
    trial: ArrayLike,
    *,
    stress: ArrayLike | None = None,
    equivalent_plastic_strain: ArrayLike = 0.0,
    backstress: ArrayLike | None = None,
    yield_factor: ArrayLike = 1.0,
    integration: Integration = "backward_euler",
) -> PlasticIncrement:
    """Return mapping at each of many points (J2 plasticity, associated flow).

    Args:
        material: material with a hardening law and, optionally, back stresses; its profiles over depth are ignored.
        trial: (6, ...) trial stress, which would act without plastic flow in the increment [Pa]; only its deviator has
            an effect.
        stress: (6, ...) stress before the increment [Pa]; None: zero. It has no effect in backward Euler without back
            stresses.
        equivalent_plastic_strain: (...) equivalent plastic strain e before the increment [-].
        backstress: (terms, 6, ...) back stresses before the increment [Pa]; None: zero.
        yield_factor: (...) factor on the yield stress, > 0, for example from `softening_factor` [-].
        integration: "backward_euler": flow along the normal at the end of the increment (Wilkins 1964); "path": flow
            along the mean of the normals at the point where the straight path leaves the elastic domain and at the end,
            second order (Ortiz, Popov 1985).

    Returns:
        Increments of the plastic strain, and the state after the increment.

    Raises:
        InputError: an unknown integration, incompatible shapes, or a material without a hardening law.
    """
    if integration not in ("path", "backward_euler"):
        raise InputError(f'integration = "{integration}"; allowed: "path" or "backward_euler"')
    engine = material._engine
    q = contiguous(trial, "trial")
    shape = q.shape[1:]
    n = int(np.prod(shape))
    terms = engine.back_stresses
    s = np.zeros((6, *shape)) if stress is None else contiguous(stress, "stress")
    e = contiguous(equivalent_plastic_strain, "equivalent_plastic_strain")
    back = np.zeros((terms, 6, *shape)) if backstress is None else contiguous(backstress, "backstress")
    e = np.full(shape, e.item()) if e.ndim == 0 else e
    factor = contiguous(yield_factor, "yield_factor")
    factor = np.full(shape, factor.item()) if factor.ndim == 0 else factor
    wanted = {"trial": (q, (6, *shape)), "stress": (s, (6, *shape))}
    wanted |= {
        "equivalent_plastic_strain": (e, shape),
        "yield_factor": (factor, shape),
        "backstress": (back, (terms, 6, *shape)),
    }
    for name, (array, right) in wanted.items():
        if array.shape != right:
            raise InputError(f"{name} has the shape {array.shape}; it must be {right}")
    strain, de, work, after, back = _core.return_mapping(
        engine,
        s.reshape(6, n),
        q.reshape(6, n),
        e.reshape(n),
        back.reshape(terms, 6, n),
        factor.reshape(n),
        integration == "path",
    )
    return PlasticIncrement(
        strain.reshape(6, *shape),
        de.reshape(shape),
        work.reshape(shape),
        after.reshape(6, *shape),
        back.reshape(terms, 6, *shape),
    )


def _material(law: Hardening | Law) -> _core.Material:
    return Material(1.0, 0.0, law)._engine  # the elastic constants have no effect


explain_argument_errors(sys.modules[__name__])
