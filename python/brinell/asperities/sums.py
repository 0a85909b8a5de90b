# SPDX-License-Identifier: BSD-3-Clause
"""Expected forces, losses and contact area of two sliding rough surfaces, from the passes of pairs of asperities.

The surfaces have n1 and n2 asperities per nominal area, and all offsets between two asperities are equally likely. A
quantity with the integral I over one pass therefore has the mean n1 n2 <integral of I over the offset>
(docs/theory/asperities.md).
"""

from __future__ import annotations

import math
from collections.abc import Iterable
from dataclasses import dataclass, field, replace
from statistics import NormalDist

import numpy as np
from numpy.typing import NDArray

from brinell._arrays import number, require_positive
from brinell.asperities.crossings import ADDED, CrossingTable
from brinell.asperities.population import Population
from brinell.asperities.tugging_map import AsperityMap
from brinell.errors import InputError

__all__ = ["AsperitySum", "Estimate", "bootstrap_weights", "friction_curve", "half_width", "statistical_sum"]

FloatArray = NDArray[np.float64]

_MOST_PAIRS = 25_000_000
_MOST_BEYOND = 0.5


@dataclass(frozen=True)
class Estimate:
    """A number with its uncertainty, all in the SI unit of the number.

    Attributes:
        value: the estimate.
        sampling: half-width of the interval from the finite sample of asperities (bootstrap) or of encounters.
        mesh: discretisation error from the cells of the map's runs.
        interpolation: interpolation error from the distance of the map's nodes.
    """

    value: float
    sampling: float = 0.0
    mesh: float = 0.0
    interpolation: float = 0.0

    @property
    def half_width(self) -> float:
        """Half-width of the interval: the sum of the map's errors, combined with the independent sampling error."""
        return math.hypot(self.sampling, self.mesh + self.interpolation)

    @property
    def low(self) -> float:
        """Lower end of the interval."""
        return self.value - self.half_width

    @property
    def high(self) -> float:
        """Upper end of the interval."""
        return self.value + self.half_width

    def __str__(self) -> str:
        return f"{self.value:.4g} +- {self.half_width:.2g}"


@dataclass(frozen=True, eq=False)
class AsperitySum:
    """Expected values for two rough surfaces that slide at a constant separation.

    Attributes:
        separation: distance of the two reference planes [m].
        pressure: normal force per nominal area [Pa].
        shear: resisting force per nominal area, which equals the work per area and sliding distance [Pa].
        friction_coefficient: shear over pressure [-].
        dissipation: plastic work and heat of friction per area and sliding distance [J/m^3].
        contact_fraction: real over nominal contact area [-].
        dent_lower: volume of new dents in the lower surface per area and sliding distance [-].
        dent_upper: volume of new dents in the upper surface per area and sliding distance [-].
        contacts: number of pairs in contact at a time per area [1/m^2].
        encounters: number of passes per area and sliding distance [1/m^3].
        largest_interference: largest interference of a pair over alpha_c [-].
        beyond: fraction of the pressure from pairs with more interference than the map covers [-]; it is extrapolated
            and counts in full as interpolation error.
    """

    separation: float
    pressure: Estimate
    shear: Estimate
    friction_coefficient: Estimate
    dissipation: Estimate
    contact_fraction: Estimate
    dent_lower: Estimate
    dent_upper: Estimate
    contacts: float
    encounters: float
    largest_interference: float
    beyond: float
    _variances: dict[tuple[str, str], float] = field(repr=False)
    _quantile: float = field(repr=False)

    def over(self, area: float, way: float) -> AsperitySum:
        """Adds the scatter of a finite experiment to pressure, shear and friction coefficient.

        The populations are those of the sum; the positions of the asperities are random.

        Args:
            area: nominal area [m^2].
            way: sliding distance [m].
        """
        require_positive(area=area, way=way)
        of = {pair: value / (area * way) for pair, value in self._variances.items()}
        z = self._quantile
        p, q = self.pressure.value, self.shear.value
        relative = 0.0
        if p > 0.0 and q > 0.0:
            relative = of["work", "work"] / q**2 + of["normal", "normal"] / p**2 - 2.0 * of["work", "normal"] / (p * q)
        return replace(
            self,
            pressure=_wider(self.pressure, z * math.sqrt(of["normal", "normal"])),
            shear=_wider(self.shear, z * math.sqrt(of["work", "work"])),
            friction_coefficient=_wider(
                self.friction_coefficient, z * self.friction_coefficient.value * math.sqrt(max(0.0, relative))
            ),
        )

    def __repr__(self) -> str:
        return (
            f"<AsperitySum at {self.separation:.4g} m: pressure {self.pressure} Pa, shear {self.shear} Pa, "
            f"coefficient {self.friction_coefficient}>"
        )


def statistical_sum(
    of: AsperityMap,
    lower: Population,
    upper: Population,
    separation: float,
    *,
    confidence: float = 0.95,
    samples: int = 400,
    seed: int = 0,
) -> AsperitySum:
    """Sums over all pairs of asperities of two surfaces that slide on each other along x.

    Args:
        of: map of the results of one pass, for the materials of the lower and the upper surface.
        lower: asperities of the lower surface.
        upper: asperities of the upper surface.
        separation: distance of the two reference planes [m]. The interference of a pair is the sum of its heights minus
            the separation.
        confidence: confidence level of the intervals, in (0, 1).
        samples: number of bootstrap samples for the sampling error, 2 or more. In each sample an asperity of a measured
            population is counted with a Poisson-distributed multiplicity of mean 1, so that the number varies, too.
        seed: seed of the bootstrap.

    Raises:
        InputError: most of the pressure comes from pairs with more interference than the map covers, or there are too
            many pairs.
    """
    number(separation, "separation")
    if not 0.0 < confidence < 1.0 or samples < 2:
        raise InputError(f"confidence = {confidence}, samples = {samples}; allowed: in (0, 1), and 2 or more")
    return _Pairs(CrossingTable(of), of, lower, upper).at(separation, confidence, samples, seed)


def friction_curve(
    of: AsperityMap,
    lower: Population,
    upper: Population,
    separations: Iterable[float],
    *,
    confidence: float = 0.95,
    samples: int = 400,
    seed: int = 0,
) -> list[AsperitySum]:
    """Statistical sums at several separations [m]; the other arguments are those of `statistical_sum`."""
    pairs = _Pairs(CrossingTable(of), of, lower, upper)
    return [pairs.at(number(one, "separation"), confidence, samples, seed) for one in separations]


class _Pairs:
    """All pairs of two populations."""

    def __init__(self, table: CrossingTable, of: AsperityMap, lower: Population, upper: Population):
        if lower.count * upper.count > _MOST_PAIRS:
            raise InputError(
                f"{lower.count} and {upper.count} asperities make {lower.count * upper.count:.3g} pairs; allowed: up "
                f"to {_MOST_PAIRS:.3g}, as Population.drawn(2000) leaves"
            )
        self._table, self._map, self._lower, self._upper = table, of, lower, upper
        self._heights = lower.heights[:, None] + upper.heights[None, :]
        self._radii = np.broadcast_arrays(lower.radii[:, None], upper.radii[None, :])
        self._density = lower.density * upper.density

    def at(self, separation: float, confidence: float, samples: int, seed: int) -> AsperitySum:
        alpha = self._heights - separation
        touch = alpha > 0.0
        deep, R1, R2 = alpha[touch], self._radii[0][touch], self._radii[1][touch]
        quantile = NormalDist().inv_cdf(0.5 + 0.5 * confidence)
        random = np.random.default_rng(seed)
        weights = tuple(bootstrap_weights(one, samples, random) for one in (self._lower, self._upper))
        estimates, drawn = {}, {}
        for name in ADDED:
            crossing = self._table.of_pairs(name, deep, R1, R2)
            value, mesh, between = (
                self._expected(touch, part) for part in (crossing.value, crossing.mesh, crossing.interpolation)
            )
            drawn[name] = self._drawn(touch, crossing.value, weights)
            estimates[name] = Estimate(value, half_width(drawn[name], confidence), mesh, between)
        total = R1 + R2
        a = deep / (self._map.pair.interference * R1 * R2 / total)
        beyond = self._beyond(touch, a, self._table.of_pairs("normal", deep, R1, R2).value)
        return AsperitySum(
            separation,
            estimates["normal"],
            estimates["work"],
            _ratio(estimates["work"], estimates["normal"], drawn["work"], drawn["normal"], confidence),
            estimates["dissipation"],
            estimates["area"],
            estimates["dent_lower"],
            estimates["dent_upper"],
            self._expected(touch, np.pi * deep * (2.0 * total - deep)),
            self._expected(touch, 2.0 * np.sqrt(deep * (2.0 * total - deep))),
            float(a.max(initial=0.0)),
            beyond,
            {
                product: self._expected(touch, self._table.of_products(product, deep, R1, R2))
                for product in (("work", "work"), ("normal", "normal"), ("work", "normal"))
            },
            quantile,
        )

    def _beyond(self, touch: NDArray[np.bool_], a: FloatArray, normal: FloatArray) -> float:
        total = self._expected(touch, normal)
        last = self._map.interferences[-1]
        share = self._expected(touch, np.where(a > last, normal, 0.0)) / total if total > 0.0 else 0.0
        if share > _MOST_BEYOND:
            raise InputError(
                f"{100 * share:.0f} % of the pressure comes from pairs that interfere by more than the map's "
                f"{last:g} alpha_c; allowed: a larger separation, or a map with more interferences"
            )
        return share

    def _expected(self, touch: NDArray[np.bool_], values: FloatArray) -> float:
        """Product n1 n2 times the mean over all pairs."""
        return self._density * float(self._lower.shares @ self._spread(touch, values) @ self._upper.shares)

    def _drawn(self, touch: NDArray[np.bool_], values: FloatArray, weights: tuple[FloatArray, ...]) -> FloatArray:
        """Expected value in each bootstrap sample."""
        of_lower, of_upper = weights
        return np.asarray(self._density * ((of_lower @ self._spread(touch, values)) * of_upper).sum(axis=1))

    @staticmethod
    def _spread(touch: NDArray[np.bool_], values: FloatArray) -> FloatArray:
        matrix = np.zeros(touch.shape)
        matrix[touch] = values
        return matrix


def bootstrap_weights(population: Population, samples: int, random: np.random.Generator) -> FloatArray:
    """(samples, count) shares of the asperities in each bootstrap sample; constant for a distribution."""
    if not population.is_sample:
        return np.broadcast_to(population.shares, (samples, population.count))
    return np.asarray(random.poisson(1.0, (samples, population.count)) * population.shares)


def half_width(drawn: FloatArray, confidence: float) -> float:
    """Half-width of the central interval with the share `confidence` of the drawn values."""
    low, high = np.quantile(drawn, [0.5 - 0.5 * confidence, 0.5 + 0.5 * confidence])
    return float(0.5 * (high - low))


def _ratio(
    above: Estimate, below: Estimate, drawn_above: FloatArray, drawn_below: FloatArray, confidence: float
) -> Estimate:
    """Ratio of two estimates: their map errors are independent, their sampling errors are drawn together."""
    if not below.value > 0.0:
        return Estimate(math.nan)
    value = above.value / below.value
    touching = drawn_below > 0.0
    mesh, between = (
        math.hypot(one, value * other) / below.value
        for one, other in ((above.mesh, below.mesh), (above.interpolation, below.interpolation))
    )
    return Estimate(value, half_width(drawn_above[touching] / drawn_below[touching], confidence), mesh, between)


def _wider(estimate: Estimate, half_width: float) -> Estimate:
    return replace(estimate, sampling=math.hypot(estimate.sampling, half_width))
