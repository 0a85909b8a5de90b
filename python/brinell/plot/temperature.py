# SPDX-License-Identifier: BSD-3-Clause
"""Heat of friction: temperatures of the surfaces and within the bodies, and the heat that enters each body."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.cm import ScalarMappable
from matplotlib.colors import Normalize
from matplotlib.figure import Figure
from matplotlib.ticker import MaxNLocator
from numpy.typing import NDArray

from brinell.plot import style
from brinell.plot.cells import contact_edge, contact_patch, contact_span, draw_cells, extent, refined
from brinell.plot.history import Course, course_of
from brinell.plot.overlay import zero_line
from brinell.plot.quantities import QUANTITIES
from brinell.plot.scales import DEGREES, Scale, Scales, si
from brinell.plot.sections import draw_outline, name_contact_axes, section
from brinell.plot.states import of_state, state_title
from brinell.results import ContactFields, History, Run, RunError, Snapshot
from brinell.scenarios import SCENARIOS

__all__ = ["has_heat", "surface_temperature_maps", "surface_temperatures", "temperature_section"]

FloatArray = NDArray[np.float64]
Span = tuple[float, float]

_SIDES: tuple[tuple[str, Mapping[str, Any]], ...] = (
    ("lower", {"color": style.LOWER, "linestyle": "-"}),
    ("upper", {"color": style.UPPER, "linestyle": (0, (4, 2))}),  # often equal: both must show
)


# --- Step by step -----------------------------------------------------------------------------------------------------


def _is_heated(run: Run) -> bool:
    """Whether heat of friction was computed."""
    return any(np.any(run.history[name]) for name in ("heat_lower", "heat_upper") if name in run.history)


def _moving(one: History, column: str) -> History:
    """The part of a pass in which the contact moves, without pressing and lifting off; all of it if it never moves."""
    moving = np.flatnonzero(np.diff(one[column]))
    return one.part(slice(int(moving[0]), int(moving[-1]) + 2)) if moving.size else one


def _heated_course(run: Run) -> Course:
    """The course over a distance: that of the history, or the distance slid or rolled; in fretting over the cycles."""
    course = course_of(run)
    if SCENARIOS[run.scenario].abscissa is not None:
        return course
    if "cycle" in run.history:
        cycles = [_cycles_done(one["cycle"]) for one in course.passes]
        return Course(course.passes, cycles, "cycles done", course.scales)
    column, name = ("way", "way slid") if "way" in run.history else ("x", "distance rolled")
    passes = [_moving(one, column) for one in course.passes]
    ways = [np.abs(one[column] - one[column][0]) for one in passes]
    starts = np.cumsum([0.0, *(float(way[-1]) for way in ways[:-1])])
    scale = si(max(float(start + way[-1]) for start, way in zip(starts, ways, strict=True)), "m")
    x = [(start + way) / scale.size for start, way in zip(starts, ways, strict=True)]
    return Course(passes, x, scale.label(name, "s"), course.scales)


def _cycles_done(cycle: FloatArray) -> FloatArray:
    """Cycles done after each step, from the number of the cycle to which it belongs; negative while pressing."""
    pressing = int(np.count_nonzero(cycle == 0))
    steps_per_cycle = max(1, int(np.count_nonzero(cycle == 1)))
    return (np.arange(cycle.size) + 1.0 - pressing) / steps_per_cycle


def _draw_course(ax: Axes, course: Course, column: str, scale: Scale, look: Mapping[str, Any]) -> None:
    """Draws one column, with a gap between two passes."""
    for index, (x, one) in enumerate(zip(course.x, course.passes, strict=True)):
        ax.plot(x, one[column] / scale.size, **(look if index == 0 else {**look, "label": "_"}))


@style.figure
def surface_temperatures(run: Run, *, ax: style.Target | None = None) -> Figure | None:
    """Largest temperature of each surface, and the heat that has entered each body, over a distance.

    The distance is the sliding coordinate for tugging, the sliding distance in several passes, otherwise the distance
    slid or rolled; steps of pressing and lifting off are left out. In fretting the cycles are counted instead. The heat
    of the plastic work in both bodies and that of a source from outside are drawn, too.

    Returns:
        None if no heat was computed.
    """
    if not _is_heated(run):
        return None
    course = _heated_course(run)
    heat = si(course.largest("heat_lower", "heat_upper", "heat_of_source"), "J")
    fig = style.new_figure(9.6, 3.3)
    warm, taken = fig.subplots(1, 2, sharex=True)
    for side, look in _SIDES:
        _draw_course(warm, course, f"max_temperature_{side}", DEGREES, {**look, "label": side})
        _draw_course(taken, course, f"heat_{side}", heat, {**look, "label": side})
    further = [
        ("heat_of_plastic_work", {"color": style.CATEGORIES[2], "linestyle": ":", "label": "of plastic work, both"}),
        ("heat_of_source", {"color": style.CATEGORIES[3], "linestyle": "-.", "label": "of the source"}),
    ]
    drawn = [(name, look) for name, look in further if course.largest(name) > 0.0]
    for name, look in drawn:
        _draw_course(taken, course, name, heat, look)
    if drawn:
        taken.legend()
    warm.set_title("(a)  hottest place of each surface")
    warm.set_ylabel(DEGREES.label("temperature", "T"))
    zero_line(taken)
    taken.set_title("(b)  heat in each body since the start")
    taken.set_ylabel(heat.label("", "Q"))
    at_alignment = [0.0] if SCENARIOS[run.scenario].abscissa is not None and not course.several else []
    for ax in (warm, taken):
        for place in (*at_alignment, *(float(x[0]) for x in course.x[1:])):
            ax.axvline(place, color="0.8", linewidth=0.8, zorder=0.5)
        ax.set_xlabel(course.label)
        ax.xaxis.set_major_locator(MaxNLocator(nbins=6, steps=[1, 2, 5, 10]))
        ax.margins(x=0.02)
    warm.legend()
    return fig


# --- One state --------------------------------------------------------------------------------------------------------


@style.figure
@of_state
def temperature_section(run: Run, snapshot: Snapshot, *, cells: bool = False, ax: style.Target | None = None) -> Figure:
    """Temperature of the bodies on the plane y = 0, or through the largest plastic strain, as `section` does.

    Args:
        run: where the scales come from.

    Raises:
        RunError: no temperature is stored.
    """
    return section(run, snapshot, field="temperature", cells=cells)


def has_heat(snapshot: Snapshot) -> bool:
    """Whether temperatures of the surfaces are stored."""
    return snapshot.contact.temperature_lower is not None


@dataclass(frozen=True, eq=False)
class _Surface:
    """Heat of one of the two surfaces; arrays [y][x]."""

    name: str
    look: Mapping[str, Any]
    temperature: FloatArray
    """[°C]."""
    flux: FloatArray
    """Into the body [W/m^2]."""


def _surfaces(run: Run, snapshot: Snapshot) -> list[_Surface]:
    """The surfaces that take heat, which a rigid body without thermal constants does not; both if neither does."""
    contact = snapshot.contact
    found = []
    for side, look in _SIDES:
        temperature, flux = (getattr(contact, f"{name}_{side}") for name in ("temperature", "heat_flux"))
        if temperature is None or flux is None:
            raise RunError(f"{run.path}: no heat in the state at step {snapshot.step}, so no temperatures to draw")
        found.append(_Surface(side, look, temperature, flux))
    return [one for one in found if np.any(one.flux) or np.ptp(one.temperature) > 0.0] or found


@style.figure
@of_state
def surface_temperature_maps(
    run: Run, snapshot: Snapshot, *, cells: bool = False, ax: style.Target | None = None
) -> Figure:
    """Temperature of each surface and, while the bodies touch, the heat flux into it, with the edge of contact.

    The colours of a row mean the same for both bodies. The flux is negative where heat comes out of a body. A body that
    takes no heat is left out. In plane strain there are lines over x.

    Args:
        run: where the scales come from.

    Raises:
        RunError: no heat is stored in this state.
    """
    surfaces, contact = _surfaces(run, snapshot), snapshot.contact
    length = Scales(run).length(max(float(np.abs(contact.x).max()), float(np.abs(contact.y).max())))
    title = f"Surface temperature:  {state_title(run, snapshot)}"
    if contact.y.size == 1:
        return _lines(snapshot, surfaces, length, title, cells=cells)
    window = _window(snapshot, surfaces, length.size)
    shape = (window[1][1] - window[1][0]) / (window[0][1] - window[0][0])
    width, rows = 3.9, 2 if snapshot.in_contact else 1
    if len(surfaces) == 1:  # beside each other
        fig = style.new_figure(rows * (width + 1.2) + 0.5, width * shape + 1.4, to_scale=True)
        axes = fig.subplots(1, rows, sharex=True, sharey=True, squeeze=False).T
    else:
        fig = style.new_figure(2.0 * width + 1.7, rows * (width * shape + 0.5) + 0.9, to_scale=True)
        axes = fig.subplots(rows, 2, sharex=True, sharey=True, squeeze=False)
    _draw_temperatures(axes[0], snapshot, surfaces, length.size, cells=cells)
    titles = [f"temperature of the {one.name} surface" for one in surfaces]
    if snapshot.in_contact:
        _draw_fluxes(axes[1], contact, surfaces, length.size, cells=cells)
        titles += [f"heat flux into the {one.name} body" for one in surfaces]
    for ax, letter, text in zip(axes.flat, "abcd", titles, strict=False):
        ax.set_title(f"({letter})  {text}" if len(titles) > 1 else text)
        name_contact_axes(ax, length, snapshot)
        ax.label_outer()
    axes[0, 0].set_xlim(*window[0])
    axes[0, 0].set_ylim(*window[1])
    fig.suptitle(title, x=0.01, ha="left", fontsize=style.font(10))
    return fig


_WARM = 0.1
"""Of the largest rise of temperature: what is worth drawing beside the contact."""
_OUT = 0.01
"""Of the largest flux: a smaller one out of a body needs no colours of its own."""


def _window(snapshot: Snapshot, surfaces: Sequence[_Surface], length: float) -> tuple[Span, Span]:
    """Ranges of x and y around the contact and the warm area, over the length, within the grid."""
    contact = snapshot.contact
    rises = [one.temperature - one.temperature.min() for one in surfaces]
    warm = np.any([rise > _WARM * max(float(rise.max()) for rise in rises) for rise in rises], axis=0)
    places = (contact.x[np.any(warm, axis=0)], contact.y[np.any(warm, axis=1)])
    patch = contact_patch(contact, length) if snapshot.in_contact else ((np.inf, -np.inf), (np.inf, -np.inf))
    edges = extent(contact.x, contact.y, length)
    found = []
    for (low, high), warm_places, rim in zip(patch, places, (edges[:2], edges[2:]), strict=True):
        low = min(low, float(warm_places.min(initial=np.inf)) / length)
        high = max(high, float(warm_places.max(initial=-np.inf)) / length)
        found.append((max(low, rim[0]), min(high, rim[1])) if low < high else rim)
    return found[0], found[1]


def _range(fields: Sequence[FloatArray]) -> tuple[float, float]:
    return min(float(one.min()) for one in fields), max(float(one.max()) for one in fields)


def _draw_temperatures(
    axes: Sequence[Axes], snapshot: Snapshot, surfaces: Sequence[_Surface], length: float, *, cells: bool
) -> None:
    contact = snapshot.contact
    colour_map, norm = QUANTITIES["temperature"].colours(*_range([one.temperature for one in surfaces]))
    for ax, one in zip(axes, surfaces, strict=True):
        smooth = "nearest" if cells else "bilinear"
        draw_cells(ax, contact.x, contact.y, one.temperature, length, cmap=colour_map, norm=norm, interpolation=smooth)
        if snapshot.in_contact:
            draw_outline(ax, contact, length)
    _colour_bar(axes, colour_map, norm, DEGREES.label("", "T"))


def _draw_fluxes(
    axes: Sequence[Axes], contact: ContactFields, surfaces: Sequence[_Surface], length: float, *, cells: bool
) -> None:
    """Draws the heat fluxes; white around the contact, unless a source from outside heats the surface there."""
    lowest, highest = _range([one.flux for one in surfaces])
    flux = si(max(-lowest, highest), "W/m²")
    reach = max(-lowest, highest) / flux.size or 1.0
    is_signed = -lowest / flux.size > _OUT * reach
    colour_map, norm = (
        (style.SIGNED_MAP, Normalize(-reach, reach)) if is_signed else (style.PRESSURE_MAP, Normalize(0.0, reach))
    )
    edge = contact_edge(contact)
    factor = 1 if cells else max(2, 600 // min(edge.shape))
    outside = contact.pressure <= 0.0 if cells else refined(edge, factor) <= 0.0
    place = extent(contact.x, contact.y, length)
    for ax, one in zip(axes, surfaces, strict=True):
        is_heated_around = bool(np.any(one.flux[contact.pressure <= 0.0]))
        values = refined(one.flux, factor) / flux.size
        shown = values if is_heated_around else np.ma.masked_where(outside, values)
        ax.imshow(shown, origin="lower", extent=place, cmap=colour_map, norm=norm, interpolation="nearest")
        if not cells and edge.min() < 0.0:  # even refined cells show as steps: cut them along the edge
            middles = (contact.x / length, contact.y / length, edge)
            if not is_heated_around:
                ax.contourf(*middles, levels=[edge.min() - 1.0, 0.0], colors="white")
            ax.contour(*middles, levels=[0.0], colors=style.CONTACT_LINE, linewidths=1.0)
    _colour_bar(axes, colour_map, norm, flux.label("", "q"))


def _colour_bar(axes: Sequence[Axes], colour_map: str, norm: Normalize, label: str) -> None:
    axes[0].figure.colorbar(ScalarMappable(norm, colour_map), ax=list(axes), label=label, pad=0.02)


def _lines(snapshot: Snapshot, surfaces: Sequence[_Surface], length: Scale, title: str, *, cells: bool) -> Figure:
    """Figure of a contact in plane strain: lines over x, with the contact in grey."""
    contact = snapshot.contact
    lowest, highest = _range([one.flux for one in surfaces])
    flux = si(max(-lowest, highest), "W/m²")
    x = contact.x / length.size
    fig = style.new_figure(9.6, 3.5)
    warm, taken = fig.subplots(1, 2, sharex=True)
    for one in surfaces:
        look = {**one.look, "label": one.name, "drawstyle": "steps-mid" if cells else "default"}
        warm.plot(x, one.temperature[0], **look)
        taken.plot(x, one.flux[0] / flux.size, **look)
    zero_line(taken)
    start, end = (place / length.size for place in contact_span(contact))
    for ax in (warm, taken):
        if snapshot.in_contact:
            ax.axvspan(start, end, color="0.93", zorder=0.1, label="contact")
        name_contact_axes(ax, length, snapshot)
    warm.set_title("(a)  temperature of each surface")
    warm.set_ylabel(DEGREES.label("temperature", "T"))
    warm.set_xlim(float(x[0]), float(x[-1]))
    warm.legend()
    taken.set_title("(b)  heat flux into each body")
    taken.set_ylabel(flux.label("", "q"))
    fig.suptitle(title, x=0.01, ha="left", fontsize=style.font(10))
    return fig
