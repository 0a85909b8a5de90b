# SPDX-License-Identifier: BSD-3-Clause
"""Elastic asperities under a flat: the sum of Greenwood and Williamson (1966) for any population."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from brinell._arrays import number, require_positive
from brinell.asperities.population import Population
from brinell.asperities.sums import Estimate, bootstrap_weights, half_width

__all__ = ["RestingSum", "resting_sum"]

FloatArray = NDArray[np.float64]


@dataclass(frozen=True)
class RestingSum:
    """Contact of a flat that rests on a rough surface.

    Attributes:
        separation: distance of the flat from the reference plane of the heights [m].
        pressure: force per nominal area [Pa].
        contact_fraction: real over nominal contact area [-].
        contacts: number of asperities in contact per area [1/m^2].
    """

    separation: float
    pressure: Estimate
    contact_fraction: Estimate
    contacts: float


def resting_sum(
    population: Population,
    separation: float,
    contact_modulus: float,
    *,
    confidence: float = 0.95,
    samples: int = 400,
    seed: int = 0,
) -> RestingSum:
    """Sums Hertz contacts of asperities under a flat: n <4/3 E' R^(1/2) d^(3/2)> and n <pi R d>, d = z - separation.

    Args:
        population: the asperities.
        separation: distance of the flat from the reference plane of the heights [m].
        contact_modulus: contact modulus E' of asperities and flat [Pa].
        confidence: confidence level of the intervals.
        samples: number of bootstrap samples, as in `statistical_sum`.
        seed: seed of the bootstrap.
    """
    require_positive(contact_modulus=contact_modulus)
    depth = np.maximum(0.0, population.heights - number(separation, "separation"))
    weights = bootstrap_weights(population, samples, np.random.default_rng(seed))

    def summed(values: FloatArray) -> Estimate:
        value = population.density * float(population.shares @ values)
        return Estimate(value, half_width(population.density * (weights @ values), confidence))

    return RestingSum(
        float(separation),
        summed(4.0 / 3.0 * contact_modulus * np.sqrt(population.radii) * depth**1.5),
        summed(np.pi * population.radii * depth),
        population.density * float(population.shares[depth > 0.0].sum()),
    )
