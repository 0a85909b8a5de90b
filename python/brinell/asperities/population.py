# SPDX-License-Identifier: BSD-3-Clause
"""The asperities of one surface: density, heights and radii."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import ArrayLike, NDArray

from brinell._arrays import contiguous, require_positive
from brinell.asperities.moments import SpectralMoments
from brinell.errors import InputError
from brinell.surfaces import HeightMap

__all__ = ["Population"]

FloatArray = NDArray[np.float64]

_NEIGHBOURS = [(j, i) for j in (-1, 0, 1) for i in (-1, 0, 1) if (j, i) != (0, 0)]
_DEVIATIONS = 6.0
"""Range of a Gaussian distribution in standard deviations; a probability of some 1e-9 is neglected."""
_NODES = 241
"""Number of heights that represent a Gaussian distribution."""


@dataclass(frozen=True, eq=False)
class Population:
    """Asperities of one surface, with spherical tops.

    Attributes:
        heights: (count,) heights of the tops above the reference plane of the surface, positive out of the body [m].
        radii: (count,) radii of curvature of the tops [m].
        density: number of asperities per nominal area [1/m^2].
        weights: (count,) share of each asperity in the population; None: equal shares.
        is_sample: whether the asperities are a (measured) sample, so that sums have a sampling error; False for the
            heights of a distribution.

    Raises:
        InputError: there are no heights, or a radius, the density or a weight is out of range.
    """

    heights: FloatArray
    radii: FloatArray
    density: float
    weights: FloatArray | None = None
    is_sample: bool = True

    def __post_init__(self) -> None:
        heights = contiguous(self.heights, "heights").reshape(-1)
        radii = np.array(np.broadcast_to(contiguous(self.radii, "radii"), heights.shape))
        if heights.size == 0:
            raise InputError("no asperities; allowed: heights of one or more")
        if not (radii > 0).all():
            raise InputError(f"radii has the value {radii.min()}; allowed: above 0")
        require_positive(density=self.density)
        weights = np.full(heights.size, 1.0 / heights.size)
        if self.weights is not None:
            weights = contiguous(self.weights, "weights").reshape(-1)
            if weights.shape != heights.shape or (weights < 0).any() or not weights.sum() > 0:
                raise InputError("weights; allowed: one for each height, none below 0, some above")
            weights = weights / weights.sum()
        for name, value in (("heights", heights), ("radii", radii), ("weights", weights)):
            object.__setattr__(self, name, value)

    @classmethod
    def of(cls, heights: ArrayLike, radius: ArrayLike, density: float) -> Population:
        """Population of given asperities.

        Args:
            heights: heights of the tops above the reference plane [m].
            radius: radius of the tops, one for all or one for each [m].
            density: number of asperities per nominal area [1/m^2].
        """
        return cls(np.atleast_1d(contiguous(heights, "heights")), contiguous(radius, "radius"), density)

    @classmethod
    def gaussian(cls, mean: float, rms: float, radius: float, density: float) -> Population:
        """Population with Gaussian heights and a single radius (Greenwood and Williamson 1966).

        Args:
            mean: mean height [m].
            rms: standard deviation of the heights [m].
            radius: radius of all tops [m].
            density: number of asperities per nominal area [1/m^2].
        """
        require_positive(rms=rms)
        t = np.linspace(-_DEVIATIONS, _DEVIATIONS, _NODES)
        return cls(mean + rms * t, np.full(t.size, float(radius)), density, np.exp(-0.5 * t**2), is_sample=False)

    @classmethod
    def from_moments(cls, moments: SpectralMoments) -> Population:
        """Summits of an isotropic, Gaussian surface: Nayak's density, one radius, Gaussian heights (McCool 1986).

        Heights are measured from the mean plane of the surface.
        """
        return cls.gaussian(moments.summit_mean, moments.summit_rms, moments.summit_radius, moments.summit_density)

    @classmethod
    def from_surface(cls, surface: HeightMap) -> Population:
        """Summits of a height map: points above their eight neighbours, with the curvature of a least-squares fit.

        Heights are measured from the mean of the map; level a measured map first. The number of summits depends on the
        distance of the points: docs/howto/asperities.md.

        Raises:
            InputError: the map has fewer than 3 points along an axis, or no summit.
        """
        h = surface.heights - surface.heights.mean()
        if min(h.shape) < 3:
            raise InputError(f"a map of {h.shape} points; allowed: 3 or more along x and y")
        dx, dy = surface.spacing
        top = np.ones(h.shape, dtype=bool)
        numerator, denominator = np.zeros(h.shape), 0.0
        for j, i in _NEIGHBOURS:
            drop = h - np.roll(h, (-j, -i), (0, 1))
            top &= drop > 0 if (j, i) > (0, 0) else drop >= 0  # only one point of a flat top is counted
            square = (i * dx) ** 2 + (j * dy) ** 2
            numerator += square * drop
            denominator += square**2
        if not surface.periodic:
            top[[0, -1], :] = False
            top[:, [0, -1]] = False
        if not top.any():
            raise InputError("the map has no summit: no point is above its eight neighbours")
        cells = h.size if surface.periodic else (h.shape[0] - 2) * (h.shape[1] - 2)
        # Least squares of h - h0 = -k r^2/2 over the neighbours.
        curvature = 2.0 * numerator[top] / denominator
        return cls(h[top], 1.0 / curvature, float(top.sum() / (cells * dx * dy)))

    @property
    def count(self) -> int:
        """Number of asperities, or of heights that represent a distribution."""
        return self.heights.size

    @property
    def mean_height(self) -> float:
        """Mean height of the tops [m]."""
        return float(self.shares @ self.heights)

    @property
    def rms_height(self) -> float:
        """Standard deviation of the tops' heights [m]."""
        return float(np.sqrt(self.shares @ (self.heights - self.mean_height) ** 2))

    @property
    def mean_radius(self) -> float:
        """Inverse of the mean curvature of the tops [m]."""
        return float(1.0 / (self.shares @ (1.0 / self.radii)))

    @property
    def shares(self) -> FloatArray:
        """(count,) weights, normalised to a sum of 1."""
        assert self.weights is not None  # since __post_init__
        return self.weights

    def with_radius(self, radius: float | None = None) -> Population:
        """Population in which all tops have the same radius [m]; None: `mean_radius`."""
        require_positive(radius=self.mean_radius if radius is None else radius)
        return replace(self, radii=np.full(self.count, self.mean_radius if radius is None else float(radius)))

    def drawn(self, count: int, seed: int = 0) -> Population:
        """Random sample of the population.

        Args:
            count: number of asperities.
            seed: seed of the random numbers.

        Raises:
            InputError: the count is below 1.
        """
        if count < 1:
            raise InputError(f"count = {count}; allowed: 1 or more")
        chosen = np.random.default_rng(seed).choice(self.count, count, p=self.shares)
        return Population(self.heights[chosen], self.radii[chosen], self.density)

    def __repr__(self) -> str:
        kind = "asperities" if self.is_sample else "heights of a distribution"
        return (
            f"<Population {self.count} {kind}, {self.density:.4g} per m2, heights {self.mean_height:.4g} +- "
            f"{self.rms_height:.4g} m, radius {self.mean_radius:.4g} m>"
        )
