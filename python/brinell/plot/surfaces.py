# SPDX-License-Identifier: BSD-3-Clause
"""A height map in one figure: heights, spectrum, distribution and bearing-area curve."""

from __future__ import annotations

from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.ticker import FuncFormatter, LogLocator, NullFormatter, PercentFormatter
from numpy.typing import NDArray

from brinell.errors import InputError
from brinell.plot import style
from brinell.plot.scales import si
from brinell.surfaces import HeightMap

__all__ = ["points_of_curve", "surface"]

_BINS = 60
_MOST_POINTS = 1000
"""Of a curve and of a side of the map: a sheet shows no more."""


@style.figure
def surface(heightmap: HeightMap, *, title: str = "", ax: style.Target | None = None) -> Figure:
    """The map, the power spectral density over the wavenumber, the distribution of heights, the bearing-area curve.

    Args:
        heightmap: what to draw; level it before if it lies askew.
        title: above it; empty: none.

    Raises:
        InputError: the map has too few points, or is flat.
    """
    if heightmap.Sq == 0.0:
        raise InputError("the surface is flat: there is nothing to draw")
    fig = style.new_figure(9.0, 7.2)
    if title:
        fig.suptitle(style.as_written(title), x=0.01, ha="left", fontsize=style.font(11))
    (map_axes, spectrum_axes), (distribution_axes, bearing_axes) = fig.subplots(2, 2)
    _map(fig, map_axes, heightmap)
    _spectrum(spectrum_axes, heightmap)
    _distribution(distribution_axes, heightmap)
    _bearing(bearing_axes, heightmap)
    return fig


def _map(fig: Figure, ax: Axes, heightmap: HeightMap) -> None:
    places, heights = si(max(heightmap.size), "m"), si(3.0 * heightmap.Sq, "m")
    step = max(1, *(-(-n // _MOST_POINTS) for n in heightmap.heights.shape))
    values = (heightmap.heights - heightmap.heights.mean())[::step, ::step] / heights.size
    half = [0.5 * size / places.size for size in heightmap.size]
    x, y = heightmap.x / places.size, heightmap.y / places.size
    most = 3.0 * heightmap.Sq / heights.size
    image = ax.imshow(
        values,
        origin="lower",
        extent=(x - half[0], x + half[0], y - half[1], y + half[1]),
        cmap="cividis",
        vmin=-most,
        vmax=most,
        interpolation="nearest",
    )
    ax.set_xlabel(f"$x$  [{places.unit}]")
    ax.set_ylabel(f"$y$  [{places.unit}]")
    ax.set_title("Height above the mean")
    bar = fig.colorbar(image, ax=ax, shrink=0.85, extend="both")
    bar.set_label(f"$h$  [{heights.unit}]")


def _spectrum(ax: Axes, heightmap: HeightMap) -> None:
    spectrum = heightmap.power_spectrum()
    # What lies twelve orders below the rest is rounding, beyond the cutoff of a made surface.
    shown = spectrum.density > 1e-12 * spectrum.density.max()
    ax.loglog(spectrum.wavenumber[shown], spectrum.density[shown], color=style.LOWER, gid="density")
    ax.set_xlabel(r"wavenumber  $q = 2\pi/\lambda$  [rad/m]")
    ax.set_ylabel(r"$C(q)$  [m$^4$]")
    ax.set_title("Power spectral density, mean over all directions")
    wavelengths = si(2.0 * np.pi / float(np.exp(np.log(spectrum.wavenumber).mean())), "m")

    def other(value: Any) -> Any:
        """Wavelength of a wavenumber, and the reverse."""
        return 2.0 * np.pi / (np.maximum(value, 1e-300) * wavelengths.size)

    above = ax.secondary_xaxis("top", functions=(other, other))
    above.set_xlabel(rf"wavelength  $\lambda$  [{wavelengths.unit}]")
    above.xaxis.set_major_locator(LogLocator(subs=(1.0, 2.0, 5.0)))
    above.xaxis.set_major_formatter(FuncFormatter(lambda value, _: style.number(value)))
    above.xaxis.set_minor_formatter(NullFormatter())


def _distribution(ax: Axes, heightmap: HeightMap) -> None:
    heights, rms = heightmap.heights.ravel() - heightmap.heights.mean(), heightmap.Sq
    scaled = heights / rms
    # Each height once in a bin of its own is no distribution: few points, wide bins.
    bins = int(np.clip(np.sqrt(scaled.size), 10, _BINS))
    density, edges = np.histogram(scaled, bins=bins, density=True)
    ax.stairs(density, edges, fill=True, color=style.LOWER, alpha=0.35)
    ax.stairs(density, edges, color=style.LOWER, label="heights")
    z = np.linspace(min(edges[0], -3.5), max(edges[-1], 3.5), 300)
    ax.plot(z, np.exp(-0.5 * z**2) / np.sqrt(2.0 * np.pi), color=style.REFERENCE, ls="--", label="Gaussian")
    ax.set_xlabel(f"$h/S_q$    ($S_q$ = {style.quantity(rms, 'm')})")
    ax.set_ylabel("density")
    ax.set_ylim(bottom=0.0)
    ax.set_title(f"Height distribution: skewness {style.number(heightmap.Ssk)}, kurtosis {style.number(heightmap.Sku)}")
    ax.legend(loc="upper right")


def points_of_curve(size: int) -> NDArray[np.int64]:
    """Points of a bearing-area curve: few where the curve is even, all at both ends, which are steep."""
    picked = np.linspace(0, size - 1, min(size, _MOST_POINTS)).astype(np.int64)
    ends = np.arange(min(size, 100))
    return np.unique(np.concatenate([picked, ends, size - 1 - ends]))


def _bearing(ax: Axes, heightmap: HeightMap) -> None:
    share, heights = heightmap.bearing_area()
    scale = si(3.0 * heightmap.Sq, "m")
    picked = points_of_curve(share.size)
    ax.plot(share[picked], heights[picked] / scale.size, color=style.LOWER, gid="bearing")
    ax.axhline(0.0, color=style.REFERENCE, lw=0.8)
    ax.xaxis.set_major_formatter(PercentFormatter(1.0, decimals=0, symbol=" %"))
    ax.set_xlim(0.0, 1.0)
    ax.set_xlabel("share of the area at that height or above")
    ax.set_ylabel(f"height above the mean  [{scale.unit}]")
    ax.set_title("Bearing-area curve (Abbott and Firestone)")
