# SPDX-License-Identifier: BSD-3-Clause
"""Figures of one state: contact pressure, residual surfaces, stress, plastic strain and heat under the contact."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.colors import Normalize, TwoSlopeNorm
from matplotlib.figure import Figure
from matplotlib.image import AxesImage
from matplotlib.ticker import FuncFormatter, MaxNLocator
from numpy.typing import NDArray

from brinell.plot import style
from brinell.plot.cells import at_centre, contact_edge, contact_patch, draw_cells, extent, refined
from brinell.plot.cuts import has_section
from brinell.plot.friction_heat import friction_heat_map, has_friction_heat
from brinell.plot.scales import Scale, Scales
from brinell.plot.sections import section
from brinell.plot.sheets import enlarged, few_ticks, lying, sheet_of
from brinell.plot.slip import stick_slip_maps
from brinell.plot.states import Side, of_state, sides, state_title
from brinell.plot.tangential import has_slip
from brinell.plot.temperature import has_heat, surface_temperature_maps, temperature_section
from brinell.results import BodyFields, ContactFields, Run, RunError, Snapshot
from brinell.results.snapshots import how_to_store
from brinell.scenarios import SCENARIOS

__all__ = ["FIGURES", "gap_map", "pressure_map", "residual_surfaces", "section", "suits"]

FloatArray = NDArray[np.float64]


@style.figure
@of_state
def pressure_map(run: Run, snapshot: Snapshot, *, cells: bool = False, ax: style.Target | None = None) -> Figure:
    """Contact pressure over p0_c in the plane of contact, with the edge of contact; in plane strain a line over x.

    Args:
        run: where the scales come from.
        snapshot: the state to draw; its bodies must touch.
        cells: show each cell as a rectangle of one colour instead of interpolating between their centres; the patch
            then needs no outline.
        ax: axes of the caller, one per panel, or a figure, to draw into; None: a new figure.

    Raises:
        RunError: the bodies do not touch in this state.
    """
    contact = snapshot.contact
    if not snapshot.in_contact:
        raise RunError(f"{run.path}: no contact in the state at step {snapshot.step}, so no pressure to draw")
    scales = Scales(run)
    length = scales.length(max(np.abs(contact.x).max(), np.abs(contact.y).max()))
    pressure = scales.pressure(contact.pressure.max())
    title = f"Contact pressure:  {state_title(run, snapshot)}"
    if _is_one_row(contact):
        return _row(contact.pressure, pressure, pressure.label("", "p"), title, snapshot, length, cells)
    sheet = sheet_of(*contact_patch(contact, length.size))
    contact = lying(contact, sheet)
    fig = sheet.new_figure()
    ax = fig.subplots()
    draw = _pressure_cells if cells else _smooth_pressure
    image = draw(ax, contact, length.size, pressure.size)
    sheet.finish(ax, length, snapshot, *contact_patch(contact, length.size))
    ax.set_title(title)
    sheet.colour_bar(fig, ax, image, pressure.label("", "p"))
    return fig


def _is_one_row(contact: ContactFields) -> bool:
    """Whether the contact is in plane strain, so that a line shows all of it."""
    return bool(contact.y.size == 1)


def _row(
    values: FloatArray, scale: Scale, label: str, title: str, snapshot: Snapshot, length: Scale, cells: bool
) -> Figure:
    """Draws a field of a contact with one row of cells over x, in and around the contact."""
    contact = snapshot.contact
    left, right = contact_patch(contact, length.size)[0]
    x = contact.x / length.size
    shown = (left <= x) & (x <= right)
    fig = style.new_figure(5.4, 3.2)
    ax = fig.subplots()
    ax.plot(x[shown], values[0, shown] / scale.size, drawstyle="steps-mid" if cells else "default")
    ax.set_xlim(left, right)
    ax.set_ylim(bottom=0.0)
    ax.set_xlabel(length.label("along the motion" if SCENARIOS[snapshot.scenario].motion else "", "x'"))
    ax.set_ylabel(label)
    ax.set_title(title)
    return fig


def _pressure_cells(ax: Axes, contact: ContactFields, length: float, unit: float) -> AxesImage:
    return _pressure_image(ax, contact, np.ma.masked_less_equal(contact.pressure, 0.0) / unit, length, unit)


def _smooth_pressure(ax: Axes, contact: ContactFields, length: float, unit: float) -> AxesImage:
    """Interpolates p^2 between cells: p^2 is linear up to the edge, where p itself rises like a square root."""
    edge = contact_edge(contact)
    factor = max(2, min(800 // min(contact.pressure.shape), 3000 // max(contact.pressure.shape)))
    inside = np.clip(refined(edge, factor), 0.0, None)
    shown = np.ma.masked_equal(contact.pressure.max() * np.sqrt(inside), 0.0)
    image = _pressure_image(ax, contact, shown / unit, length, unit)
    # Even the refined cells show as steps: cut them along the edge.
    place = (contact.x / length, contact.y / length, edge)
    ax.contourf(*place, levels=[edge.min() - 1.0, 0.0], colors="white")
    ax.contour(*place, levels=[0.0], colors=style.CONTACT_LINE, linewidths=1.0)
    return image


def _pressure_image(ax: Axes, contact: ContactFields, shown: FloatArray, length: float, unit: float) -> AxesImage:
    return ax.imshow(
        shown,
        origin="lower",
        extent=extent(contact.x, contact.y, length),
        cmap=style.PRESSURE_MAP,
        norm=Normalize(0.0, contact.pressure.max() / unit),
        interpolation="nearest",
    )


def _crop(ax: Axes, x: tuple[float, float], y: tuple[float, float]) -> None:
    ax.set_xlim(*x)
    ax.set_ylim(*y)


@style.figure
@of_state
def gap_map(run: Run, snapshot: Snapshot, *, cells: bool = False, ax: style.Target | None = None) -> Figure:
    """Gap between the deformed surfaces around the contact, with the edge of contact; in plane strain a line over x.

    Args:
        run: where the scales come from.
        snapshot: the state to draw; its bodies must touch.
        cells: show each cell as a rectangle of one colour instead of interpolating between their centres.
        ax: axes of the caller, one per panel, or a figure, to draw into; None: a new figure.

    Raises:
        RunError: the bodies do not touch in this state.
    """
    contact = snapshot.contact
    if not snapshot.in_contact:
        raise RunError(f"{run.path}: no contact in the state at step {snapshot.step}, so no gap around it to draw")
    scales = Scales(run)
    length = scales.length(max(np.abs(contact.x).max(), np.abs(contact.y).max()))
    sheet = sheet_of(*contact_patch(contact, length.size))
    contact = lying(contact, sheet)
    ranges = contact_patch(contact, length.size)
    shown = [
        (low <= c / length.size) & (c / length.size <= high)
        for c, (low, high) in zip((contact.x, contact.y), ranges, strict=True)
    ]
    largest = float(contact.gap[np.ix_(shown[1], shown[0])].max())
    gap = scales.displacement(largest)
    title = f"Gap:  {state_title(run, snapshot)}"
    if _is_one_row(snapshot.contact):
        return _row(snapshot.contact.gap, gap, gap.label("", "h"), title, snapshot, length, cells)
    fig = sheet.new_figure()
    ax = fig.subplots()
    image = draw_cells(
        ax,
        contact.x,
        contact.y,
        contact.gap / gap.size,
        length.size,
        cmap=style.GAP_MAP,
        norm=Normalize(0.0, largest / gap.size or 1.0),
        interpolation="nearest" if cells else "bilinear",
    )
    ax.contour(
        contact.x / length.size,
        contact.y / length.size,
        contact_edge(contact),
        levels=[0.0],
        colors=style.CONTACT_LINE,
        linewidths=1.0,
    )
    sheet.finish(ax, length, snapshot, *ranges)
    ax.set_title(title)
    sheet.colour_bar(fig, ax, image, gap.label("", "h"))
    return fig


def _height(body: BodyFields) -> FloatArray:
    """Residual displacement seen from outside: pile-up positive, depth negative [m]."""
    return -body.residual_displacement


@style.figure
@of_state
def residual_surfaces(run: Run, snapshot: Snapshot, *, cells: bool = False, ax: style.Target | None = None) -> Figure:
    """Permanent shape of the surfaces along the track: profile on y = 0, and maps.

    Heights are out of each body: pile-up positive, the groove negative. Coordinates are those of each body. A body
    that has kept its shape is left out, unless both have.

    Args:
        run: where the scales come from.
        snapshot: the state to draw.
        cells: show each cell as a rectangle of one colour instead of interpolating between their centres.
        ax: axes of the caller, one per panel, or a figure, to draw into; None: a new figure.

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
    width = 8.0
    if deformed[0].body.y.size == 1:  # plane strain: the profile is all there is
        fig = style.new_figure(width, 3.2)
        ax = fig.subplots()
        _draw_profile(ax, deformed, length.size, depth)
        ax.set_title(f"Residual surfaces:  {state_title(run, snapshot)}")
        ax.set_xlabel(length.label("along the surface", "x"))
        return fig

    ranges = _active_range(deformed, 0.01 * max(-lowest, highest), length.size)
    to_scale = (width - 1.9) * (ranges[1][1] - ranges[1][0]) / (ranges[0][1] - ranges[0][0])
    map_height = min(max(to_scale, _LEAST_MAP), _MOST_MAP)
    count = len(deformed)
    fig = style.new_figure(width, 3.8 + count * map_height + (count * map_height < _FLAT_MAPS), to_scale=True)
    axes = fig.subplots(1 + count, 1, sharex=True, gridspec_kw={"height_ratios": [2.3, *[map_height] * count]})
    _draw_profile(axes[0], deformed, length.size, depth)
    axes[0].set_title(f"Residual surfaces:  {state_title(run, snapshot)}")
    norm = _height_norm(lowest / depth.size, highest / depth.size)
    for ax, side in zip(axes[1:], deformed, strict=True):
        # A smooth surface: cubic, through the cell values.
        image = draw_cells(
            ax,
            side.body.x,
            side.body.y,
            _height(side.body) / depth.size,
            length.size,
            cmap=style.RESIDUAL_MAP,
            norm=norm,
            interpolation="nearest" if cells else "catrom",
        )
        _crop(ax, *ranges)
        ax.set_ylabel(enlarged(length.label("", "y", value=False), map_height / to_scale))
        if map_height != to_scale:
            ax.set_aspect(map_height / to_scale)
            few_ticks(ax, map_height)
        ax.text(0.01, 0.95, side.name, transform=ax.transAxes, ha="left", va="top")
    axes[-1].set_xlabel(length.label("along the surface", "x"))
    name = depth.label("height", "-u^r") + _enlargement(norm)
    # Beside flat maps its label would be longer than the bar.
    place: dict[str, Any] = (
        {"location": "bottom", "aspect": 45.0, "shrink": 0.75} if count * map_height < _FLAT_MAPS else {"pad": 0.02}
    )
    bar = fig.colorbar(image, ax=axes[1:], label=name, format=FuncFormatter(lambda t, _: f"{t:.3g}"), **place)
    bar.set_ticks(_height_ticks(lowest / depth.size, highest / depth.size))
    return fig


def _draw_profile(ax: Axes, deformed: Sequence[Side], length: float, depth: Scale) -> None:
    """Draws the heights on y = 0."""
    ax.axhline(0.0, color="0.8", linewidth=0.8, zorder=0.5)
    for side in deformed:
        line = at_centre(side.body.y, _height(side.body)) / depth.size
        ax.plot(side.body.x / length, line, color=side.colour, linestyle=side.dash, label=side.name)
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


_LEAST_MAP, _MOST_MAP = 0.9, 5.0
"""Heights of a map [inch], beyond which it is not drawn to scale."""

_FLAT_MAPS = 1.8
"""Height of all maps together [inch], up to which the colour bar is below them."""

_NEGLIGIBLE = 1e-3
"""Share of the larger of depth and pile-up that is not worth a colour."""


def _active_range(
    deformed: Sequence[Side], threshold: float, scale: float
) -> tuple[tuple[float, float], tuple[float, float]]:
    """Ranges of x and y in which either surface is deformed, over the scale, symmetric in y, within the grids."""
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
    if y_reach == 0.0:  # nothing has moved, or a single row of cells
        x_low, x_high = min(e[0] for e in extents), max(e[1] for e in extents)
        y_reach = max(max(-e[2], e[3]) for e in extents)
    return (float(x_low), float(x_high)), (-float(y_reach), float(y_reach))


FIGURES: dict[str, Callable[..., Figure]] = {
    "pressure": pressure_map,
    "gap": gap_map,
    "residual-surfaces": residual_surfaces,
    "section": section,
    "stick-slip": stick_slip_maps,
    "friction-heat": friction_heat_map,
    "temperature": temperature_section,
    "surface-temperature-maps": surface_temperature_maps,
}
"""What the command `fields` writes: end of the file name and function."""


def suits(name: str, snapshot: Snapshot) -> bool:
    """Whether a figure of `FIGURES` has data in a state: contact, stick and slip, or heat."""
    if name == "stick-slip":
        return has_slip(snapshot) and not _is_one_row(snapshot.contact)
    if name == "friction-heat":
        return has_friction_heat(snapshot)
    if name == "temperature":
        return any(body.temperature is not None for body in (snapshot.lower, snapshot.upper))
    if name == "surface-temperature-maps":
        return has_heat(snapshot)
    if name == "residual-surfaces":
        return any(side.body.has("residual_displacement") for side in sides(snapshot))
    if name == "section":
        return has_section(sides(snapshot))
    return snapshot.in_contact or name not in ("pressure", "gap")
