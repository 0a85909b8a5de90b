# SPDX-License-Identifier: BSD-3-Clause
"""The permanent shape of the surfaces: a profile along x, and maps."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.colors import Normalize, TwoSlopeNorm
from matplotlib.figure import Figure
from matplotlib.image import AxesImage
from matplotlib.ticker import FuncFormatter, MaxNLocator
from numpy.typing import NDArray

from brinell.plot import style
from brinell.plot.cells import at_centre, draw_cells, extent
from brinell.plot.scales import Scale, Scales
from brinell.plot.sheets import Range, enlarged, few_ticks
from brinell.plot.states import Side, of_state, sides, state_title
from brinell.plot.where import Cutting, cutting_of, goes_round
from brinell.results import BodyFields, Run, RunError, Snapshot
from brinell.results.snapshots import how_to_store

__all__ = ["residual_surfaces"]

FloatArray = NDArray[np.float64]


def _height(body: BodyFields) -> FloatArray:
    """Residual displacement seen from outside: pile-up positive, depth negative [m]."""
    return -body.residual_displacement


@style.figure
@of_state
def residual_surfaces(run: Run, snapshot: Snapshot, *, cells: bool = False, ax: style.Target | None = None) -> Figure:
    """Permanent shape of the surfaces along the track: a profile, and maps.

    Heights are out of each body: pile-up positive, the groove negative. Coordinates are those of each body. A body
    that has kept its shape is left out, unless both have. The profile is on y = 0, or through the largest plastic
    strain if little has yielded on y = 0, as the title says; the maps show that line. Surfaces with a period are drawn
    over all of it.

    Args:
        run: where the scales come from.

    Raises:
        RunError: the residual displacement is not stored.
    """
    scales = Scales(run)
    known = [side for side in sides(snapshot) if side.body.has("residual_displacement")]
    if not known:
        name = "residual_displacement"
        raise RunError(f"{run.path}: {name} is not stored at step {snapshot.step}{how_to_store(name)}")
    deformed = [side for side in known if side.body.is_dented] or known
    lowest = min(0.0, *(float(_height(side.body).min()) for side in deformed))
    highest = max(0.0, *(float(_height(side.body).max()) for side in deformed))
    depth = scales.displacement(max(-lowest, highest))
    length = scales.length(max(float(np.abs(side.body.x).max()) for side in deformed))
    cutting = cutting_of(snapshot, deformed)
    title = f"Residual surfaces:  {state_title(run, snapshot)}"
    if deformed[0].body.y.size == 1:  # plane strain: the profile is all there is
        fig = style.new_figure(_WIDTH + _BESIDE, 3.2)
        ax = fig.subplots()
        _draw_profile(ax, deformed, cutting, length.size, depth)
        ax.set_title(title)
        ax.set_xlabel(length.label("along the surface", "x"))
        return fig

    ranges = _active_range(deformed, 0.01 * max(-lowest, highest), length.size, goes_round(run))
    sheet = _sheet_of(*ranges, len(deformed))
    fig = style.new_figure(
        sheet.width + _BESIDE, 3.8 + sheet.maps_height + (sheet.maps_height < _FLAT_MAPS), to_scale=True
    )
    heights = [2.3, *[sheet.height] * len(deformed)]
    axes = fig.subplots(len(heights), 1, sharex=True, gridspec_kw={"height_ratios": heights})
    _draw_profile(axes[0], deformed, cutting, length.size, depth)
    axes[0].set_title(f"{title}\nprofile on {cutting.text()}" if cutting.reason else title)
    norm = _height_norm(lowest / depth.size, highest / depth.size)
    for ax, side in zip(axes[1:], deformed, strict=True):
        image = _draw_map(ax, side, length.size, depth.size, norm, cells=cells)
        ax.set_xlim(*ranges[0])
        ax.set_ylim(*ranges[1])
        ax.set_ylabel(enlarged(length.label("", "y", value=False), sheet.enlargement))
        if sheet.enlargement != 1.0:
            ax.set_aspect(sheet.enlargement)
            few_ticks(ax, sheet.height)
        if cutting.reason:
            ax.axhline(cutting.plane.value / length.size, color=style.REFERENCE, linewidth=0.8, linestyle=(0, (4, 3)))
    axes[-1].set_xlabel(length.label("along the surface", "x"))
    name = depth.label("height", "-u^r") + _enlargement(norm)
    # Beside flat maps its label would be longer than the bar.
    place: dict[str, Any] = (
        {"location": "bottom", "aspect": 45.0, "shrink": 0.75} if sheet.maps_height < _FLAT_MAPS else {"pad": 0.02}
    )
    bar = fig.colorbar(image, ax=axes[1:], label=name, format=FuncFormatter(lambda t, _: style.number(t)), **place)
    bar.set_ticks(_height_ticks(lowest / depth.size, highest / depth.size))
    return fig


@dataclass(frozen=True)
class _MapSheet:
    """Size of the maps, one below the other [inch]."""

    width: float
    height: float
    """Of one map."""
    enlargement: float
    """Of y; 1 if the maps are to scale."""
    count: int

    @property
    def maps_height(self) -> float:
        """Height of all maps together."""
        return self.count * self.height


def _sheet_of(across: Range, upward: Range, count: int) -> _MapSheet:
    """The maps to scale: as wide as the sheet, or narrower if they would be too high; y enlarged or reduced at last."""
    ratio = (upward[1] - upward[0]) / (across[1] - across[0])
    most = _MOST_MAP if count == 1 else _MOST_OF_SEVERAL
    width = min(_WIDTH, max(most / ratio, _LEAST_WIDTH))
    height = min(max(width * ratio, _LEAST_MAP), most)
    enlargement = height / (width * ratio)
    return _MapSheet(width, height, 1.0 if np.isclose(enlargement, 1.0) else enlargement, count)


def _draw_map(ax: Axes, side: Side, length: float, depth: float, norm: Normalize, *, cells: bool) -> AxesImage:
    """Draws the heights of a body, seen from outside, with its name."""
    ax.text(0.01, 0.98, side.name, transform=ax.transAxes, ha="left", va="top")
    return draw_cells(
        ax,
        side.body.x,
        side.body.y,
        _height(side.body) / depth,
        length,
        cmap=style.RESIDUAL_MAP,
        norm=norm,
        interpolation="nearest" if cells else "catrom",  # a smooth surface: cubic, through the cell values
    )


def _draw_profile(ax: Axes, deformed: Sequence[Side], cutting: Cutting, length: float, depth: Scale) -> None:
    """Draws the heights on a plane along the motion."""
    ax.axhline(0.0, color="0.8", linewidth=0.8, zorder=0.5)
    for side in deformed:
        y, heights = side.body.y, _height(side.body)
        line = heights[int(np.argmin(np.abs(y - cutting.plane.value)))] if cutting.reason else at_centre(y, heights)
        ax.plot(side.body.x / length, line / depth.size, color=side.colour, linestyle=side.dash, label=side.name)
    ax.set_ylabel(depth.label("height", "-u^r", value=False))
    if len(deformed) > 1:  # else the map below names it
        ax.legend(loc="lower right")
    ax.margins(y=0.08)


def _height_norm(lowest: float, highest: float) -> Normalize:
    """Norm in which each side of zero has half of the colours, as the groove is deeper than the pile-up is high."""
    if lowest == highest == 0.0:
        return Normalize(-1.0, 1.0)
    small = _NEGLIGIBLE * max(-lowest, highest)
    return TwoSlopeNorm(0.0, min(lowest, -small), max(highest, small))


def _enlargement(norm: Normalize) -> str:
    """Label that says that pile-up has more colours for its height than the groove."""
    if not isinstance(norm, TwoSlopeNorm) or norm.vmin is None or norm.vmax is None:
        return ""
    ratio = -norm.vmin / norm.vmax
    if 0.5 < ratio < 2.0:
        return ""
    return f",  above 0 enlarged {ratio:.2g} times" if ratio > 1.0 else f",  below 0 enlarged {1 / ratio:.2g} times"


def _height_ticks(lowest: float, highest: float) -> list[float]:
    """Round heights on both halves of the colour bar, each half with its own distance."""
    ticks = [0.0]
    for end in (lowest, highest):
        if abs(end) > _NEGLIGIBLE * max(-lowest, highest):
            low, high = min(end, 0.0), max(end, 0.0)
            ticks += [t for t in MaxNLocator(nbins=4).tick_values(low, high) if low <= t <= high and t != 0.0]
    return sorted(ticks)


_WIDTH, _BESIDE = 6.1, 1.9
"""Of the maps, and of what is beside them [inch]."""

_LEAST_WIDTH = 2.6
"""Of maps that are higher than wide [inch]; beyond it they are not drawn to scale."""

_LEAST_MAP, _MOST_MAP, _MOST_OF_SEVERAL = 0.9, 5.0, 3.6
"""Heights of a map [inch]: of any, of a single one, of each of two."""

_FLAT_MAPS = 1.8
"""Height of all maps together [inch], up to which the colour bar is below them."""

_NEGLIGIBLE = 1e-3
"""Share of the larger of depth and pile-up that is not worth a colour."""


def _active_range(
    deformed: Sequence[Side], threshold: float, scale: float, whole: tuple[bool, bool]
) -> tuple[Range, Range]:
    """Ranges of x and y in which either surface is deformed, over the scale, symmetric in y, within the grids.

    Args:
        deformed: the bodies.
        threshold: smaller displacements do not count [m].
        scale: of lengths [m].
        whole: whether all of x and y is shown.
    """
    extents = [extent(side.body.x, side.body.y, scale) for side in deformed]
    x_low, x_high, y_reach = np.inf, -np.inf, 0.0
    for side, edges in zip(deformed, extents, strict=True):
        moved = np.abs(side.body.residual_displacement) > threshold
        if threshold <= 0.0 or not np.any(moved):
            continue
        xs, ys = side.body.x[np.any(moved, axis=0)] / scale, side.body.y[np.any(moved, axis=1)] / scale
        margin = 0.08 * (xs.max() - xs.min())
        x_low, x_high = min(x_low, max(edges[0], xs.min() - margin)), max(x_high, min(edges[1], xs.max() + margin))
        y_reach = max(y_reach, min(max(-edges[2], edges[3]), 1.15 * np.abs(ys).max()))
    x, y = (float(x_low), float(x_high)), (-float(y_reach), float(y_reach))
    has_moved = y_reach > 0.0  # otherwise nothing has, or there is a single row of cells
    all_x = (min(e[0] for e in extents), max(e[1] for e in extents))
    all_y = (min(e[2] for e in extents), max(e[3] for e in extents))
    return x if has_moved and not whole[0] else all_x, y if has_moved and not whole[1] else all_y
