# SPDX-License-Identifier: BSD-3-Clause
"""Spectral moments of a rough surface, and properties of its summits by Nayak and McCool."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from brinell._arrays import require_positive
from brinell.errors import InputError
from brinell.surfaces import HeightMap

__all__ = ["SpectralMoments"]

FloatArray = NDArray[np.float64]


@dataclass(frozen=True)
class SpectralMoments:
    """Mean squares of height, slope and curvature of a profile of an isotropic, Gaussian surface (Nayak 1971).

    Attributes:
        m0: mean square height [m^2].
        m2: mean square slope of a profile, half the mean square of the gradient [-].
        m4: mean square curvature of a profile [1/m^2].

    Raises:
        InputError: a moment is not above 0, or m0 m4/m2^2 is below 1.5.
    """

    m0: float
    m2: float
    m4: float

    def __post_init__(self) -> None:
        require_positive(m0=self.m0, m2=self.m2, m4=self.m4)
        if self.bandwidth < 1.5:  # Nayak 1971, of any isotropic surface
            raise InputError(f"m0 m4/m2^2 = {self.bandwidth:.4g}; allowed: 1.5 or more, as every isotropic surface has")

    @classmethod
    def of(cls, surface: HeightMap) -> SpectralMoments:
        """Moments of a height map, averaged over profiles along x and y.

        For a periodic map the Fourier series is used, otherwise differences of neighbours, which underestimate
        wavelengths of a few points. Level a measured map first.

        Raises:
            InputError: the map has fewer than 4 points along an axis.
        """
        if min(surface.heights.shape) < 4:
            raise InputError(f"a map of {surface.heights.shape} points; allowed: 4 or more along x and y")
        slopes, curvatures = _by_waves(surface) if surface.periodic else _by_differences(surface)
        return cls(surface.Sq**2, 0.5 * sum(slopes), 0.5 * sum(curvatures))

    @property
    def bandwidth(self) -> float:
        """Bandwidth parameter m0 m4/m2^2, Nayak's alpha [-]: 1.5 for one wavelength, large for many."""
        return self.m0 * self.m4 / self.m2**2

    @property
    def summit_density(self) -> float:
        """Density of summits, m4/(6 pi sqrt(3) m2) [1/m^2] (Nayak 1971)."""
        return self.m4 / (6.0 * math.pi * math.sqrt(3.0) * self.m2)

    @property
    def summit_radius(self) -> float:
        """Radius of summits, the inverse of their mean curvature, 3 sqrt(pi/m4)/8 [m] (McCool 1986)."""
        return 0.375 * math.sqrt(math.pi / self.m4)

    @property
    def summit_mean(self) -> float:
        """Mean height of summits above the mean plane, 4 sqrt(m0/(pi alpha)) [m] (Bush, Gibson, Keogh 1976)."""
        return 4.0 * math.sqrt(self.m0 / (math.pi * self.bandwidth))

    @property
    def summit_rms(self) -> float:
        """Standard deviation of summit heights, sqrt((1 - 0.8968/alpha) m0) [m] (Bush, Gibson, Keogh 1976)."""
        return math.sqrt((1.0 - 0.8968 / self.bandwidth) * self.m0)


def _by_waves(surface: HeightMap) -> tuple[list[float], list[float]]:
    """Mean squares of first and second derivatives along x and y, by the Fourier series of a periodic map."""
    power = np.abs(np.fft.fft2(surface.heights)) ** 2 / surface.heights.size**2
    power[0, 0] = 0.0
    ny, nx = surface.heights.shape
    q = (
        2 * np.pi * np.fft.fftfreq(nx, surface.spacing[0]),
        2 * np.pi * np.fft.fftfreq(ny, surface.spacing[1])[:, None],
    )
    return [float((power * k**2).sum()) for k in q], [float((power * k**4).sum()) for k in q]


def _by_differences(surface: HeightMap) -> tuple[list[float], list[float]]:
    slopes, curvatures = [], []
    for axis, spacing in ((1, surface.spacing[0]), (0, surface.spacing[1])):
        slopes.append(float((np.diff(surface.heights, axis=axis) ** 2).mean() / spacing**2))
        curvatures.append(float((np.diff(surface.heights, 2, axis=axis) ** 2).mean() / spacing**4))
    return slopes, curvatures
