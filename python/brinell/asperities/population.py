# SPDX-License-Identifier: BSD-3-Clause
"""The asperities of one surface: how many, how high, how round."""

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
"""Up to which a Gaussian distribution is followed; its last 1e-9 are left out."""
_NODES = 241
"""Heights that stand for a Gaussian distribution."""


@dataclass(frozen=True, eq=False)
class Population:
    """Asperities of one surface, spheres near their tops.

    Attributes:
        heights: of the tops above the surface's reference plane, out of the body [m].
        radii: of the tops [m], one for each.
        density: asperities per nominal area [1/m^2].
        weights: share of each in the population; None: all the same.
        is_sample: whether these asperities are a sample of more like them (measured ones): then sums over them have an
            error of sampling. Those of a distribution are none.
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
        """Given asperities.

        Args:
            heights: of the tops above the reference plane [m].
            radius: of the tops [m]; one for all, or one for each.
            density: per nominal area [1/m^2].
        """
        return cls(np.atleast_1d(contiguous(heights, "heights")), contiguous(radius, "radius"), density)

    @classmethod
    def gaussian(cls, mean: float, rms: float, radius: float, density: float) -> Population:
        """Heights of a Gaussian distribution, one radius (Greenwood and Williamson 1966).

        Args:
            mean: of the heights [m].
            rms: their standard deviation [m].
            radius: of all tops [m].
            density: per nominal area [1/m^2].
        """
        require_positive(rms=rms)
        t = np.linspace(-_DEVIATIONS, _DEVIATIONS, _NODES)
        return cls(mean + rms * t, np.full(t.size, float(radius)), density, np.exp(-0.5 * t**2), is_sample=False)

    @classmethod
    def from_moments(cls, moments: SpectralMoments) -> Population:
        """Summits of an isotropic, Gaussian surface: Nayak's density, one radius, Gaussian heights (McCool 1986).

        Heights count from the mean plane of the surface.
        """
        return cls.gaussian(moments.summit_mean, moments.summit_rms, moments.summit_radius, moments.summit_density)

    @classmethod
    def from_surface(cls, surface: HeightMap) -> Population:
        """Summits of a map: points above their eight neighbours, with the curvature that fits these best.

        Heights count from the mean of the map; level a measured one before. What counts as a summit depends on the
        distance of the points: docs/howto/asperities.md.
        """
        h = surface.heights - surface.heights.mean()
        if min(h.shape) < 3:
            raise InputError(f"a map of {h.shape} points; allowed: 3 or more along x and y")
        dx, dy = surface.spacing
        top = np.ones(h.shape, dtype=bool)
        numerator, denominator = np.zeros(h.shape), 0.0
        for j, i in _NEIGHBOURS:
            drop = h - np.roll(h, (-j, -i), (0, 1))
            top &= drop > 0 if (j, i) > (0, 0) else drop >= 0  # of a flat top one point counts
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
        """Of asperities, or of heights that stand for a distribution."""
        return self.heights.size

    @property
    def mean_height(self) -> float:
        """Of the tops [m]."""
        return float(self.shares @ self.heights)

    @property
    def rms_height(self) -> float:
        """Standard deviation of the tops' heights [m]."""
        return float(np.sqrt(self.shares @ (self.heights - self.mean_height) ** 2))

    @property
    def mean_radius(self) -> float:
        """Inverse of the mean curvature [m]."""
        return float(1.0 / (self.shares @ (1.0 / self.radii)))

    @property
    def shares(self) -> FloatArray:
        """The weights, which sum up to 1."""
        assert self.weights is not None  # since __post_init__
        return self.weights

    def with_radius(self, radius: float | None = None) -> Population:
        """All tops of one radius [m]; None: their mean curvature's."""
        require_positive(radius=self.mean_radius if radius is None else radius)
        return replace(self, radii=np.full(self.count, self.mean_radius if radius is None else float(radius)))

    def drawn(self, count: int, seed: int = 0) -> Population:
        """A sample of that many asperities, drawn at random."""
        if count < 1:
            raise InputError(f"count = {count}; allowed: 1 or more")
        chosen = np.random.default_rng(seed).choice(self.count, count, p=self.shares)
        return Population(self.heights[chosen], self.radii[chosen], self.density)

    def __repr__(self) -> str:
        what = "asperities" if self.is_sample else "heights of a distribution"
        return (
            f"<Population {self.count} {what}, {self.density:.4g} per m2, heights {self.mean_height:.4g} +- "
            f"{self.rms_height:.4g} m, radius {self.mean_radius:.4g} m>"
        )
