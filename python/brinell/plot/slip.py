# SPDX-License-Identifier: BSD-3-Clause
"""Stick and slip in one state: maps over the contact, and profiles along the motion; SI with prefixes throughout."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from matplotlib.axes import Axes
from matplotlib.cm import ScalarMappable
from matplotlib.colors import ListedColormap, Normalize
from matplotlib.figure import Figure
from numpy.typing import NDArray

from brinell.plot import style
from brinell.plot.cells import contact_edge, contact_patch, extent
from brinell.plot.overlay import Look, largest, legend_beside, zero_line
from brinell.plot.scales import Scale, si
from brinell.plot.states import of_state, state_title
from brinell.plot.tangential import (
    SLIP,
    STICK,
    BoolArray,
    FloatArray,
    Tangential,
    draw_field,
    draw_outline,
    draw_size,
    map_size,
    shade_sticking,
    since,
    stick_edge,
    tangential,
)
from brinell.results import ContactFields, Run, RunError, Snapshot

__all__ = ["stick_slip_maps", "stick_slip_profiles"]


@style.figure
@of_state
def stick_slip_maps(run: Run, snapshot: Snapshot, *, cells: bool = False, ax: style.Target | None = None) -> Figure:
    """Pressure with the shear as arrows, sticking and slipping area, magnitudes of shear and slip.

    Args:
        run: the run of the state, for friction and direction.

    Raises:
        RunError: the bodies do not touch in this state, or no shear is stored.
    """
    state = tangential(run, snapshot)
    contact = state.contact
    if contact.y.size == 1:
        raise RunError(f"{run.path}: a single row of cells has no maps; profiles show all of it")
    length = si(max(contact_patch(contact, 1.0)[0][1], contact_patch(contact, 1.0)[1][1]), "m")
    wide, high = map_size(contact)
    fig = style.new_figure(2.6 + 2.0 * wide, 0.8 + 2.0 * high, to_scale=True)
    axes = fig.subplots(2, 2, sharex=True, sharey=True)
    _draw_pressure(axes[0, 0], state, length, cells=cells)
    _draw_sticking(axes[0, 1], state, length, cells=cells)
    shear, slip = (si(largest([size]), unit) for size, unit in ((state.shear_size, "Pa"), (state.slip_size, "m")))
    draw_size(
        axes[1, 0], state, state.shear_size, length, shear, (style.STRESS_MAP, shear.label("", "|q|")), cells=cells
    )
    draw_size(axes[1, 1], state, state.slip_size, length, slip, (style.STRAIN_MAP, slip.label("", "|s|")), cells=cells)
    both = "pressure, and shear on the lower body" if wide > 2.0 else "pressure, and shear\n     on the lower body"
    titles = (both, "what sticks", "shear", f"slip since {since([run])}")
    for ax, letter, title in zip(axes.flat, "abcd", titles, strict=True):
        ax.set_title(f"({letter})  {title}")
    patch = contact_patch(contact, length.size)
    axes[0, 0].set_xlim(*patch[0])
    axes[0, 0].set_ylim(*patch[1])
    for ax in axes[1]:
        ax.set_xlabel(length.label("", "x'"))
    for ax in axes[:, 0]:
        ax.set_ylabel(length.label("", "y'"))
    fig.suptitle(f"Stick and slip:  {state_title(run, snapshot)}", x=0.01, ha="left", fontsize=style.font(10))
    return fig


def _draw_pressure(ax: Axes, state: Tangential, length: Scale, *, cells: bool) -> None:
    pressure = si(float(state.contact.pressure.max()), "Pa")
    image = draw_field(ax, state, state.contact.pressure, length, pressure, style.PRESSURE_MAP, cells=cells)
    ax.figure.colorbar(image, ax=ax, label=pressure.label("", "p"), pad=0.02)
    _draw_arrows(ax, state, length)


_ARROWS = 13
"""Number of arrows across the contact."""


def _draw_arrows(ax: Axes, state: Tangential, length: Scale) -> None:
    """Draws the shear as arrows on some of the cells."""
    contact, most = state.contact, float(state.shear_size.max())
    touching = contact.pressure > 0.0
    if most == 0.0:
        return
    columns, rows = np.flatnonzero(touching.any(axis=0)), np.flatnonzero(touching.any(axis=1))
    dx, dy = (float(axis[1] - axis[0]) / length.size for axis in (contact.x, contact.y))
    distance = max(columns.size * dx, rows.size * dy) / _ARROWS
    along_x, along_y = (max(1, round(distance / size)) for size in (dx, dy))
    chosen = np.zeros_like(touching)
    chosen[_about_middle(rows, along_y)[:, None], _about_middle(columns, along_x)] = True
    j, i = np.nonzero(chosen & touching)
    step = max(along_x * dx, along_y * dy)
    arrows = ax.quiver(
        contact.x[i] / length.size,
        contact.y[j] / length.size,
        state.shear[0][j, i] / most * step,
        state.shear[1][j, i] / most * step,
        angles="xy",
        scale_units="xy",
        scale=1.0,
        pivot="middle",
        units="inches",
        width=0.019,
        color="white",
        edgecolor="black",
        linewidth=0.4,
    )
    told = _round_below(most)
    ax.quiverkey(
        arrows,
        0.89,
        0.05,
        told / most * step,
        style.quantity(told, "Pa"),
        coordinates="axes",
        labelpos="W",
        labelsep=0.05,
        fontproperties={"size": 8},
    )


def _round_below(value: float) -> float:
    """The largest number of one digit that is not larger than a value > 0."""
    power = 10.0 ** np.floor(np.log10(value))
    return float(max(n for n in range(1, 10) if n * power <= value * (1.0 + 1e-12)) * power)


def _about_middle(indices: NDArray[np.intp], stride: int) -> NDArray[np.intp]:
    """Indices at a distance of `stride`, equally far from both ends."""
    return indices[((indices.size - 1) % stride) // 2 :: stride]


def _draw_sticking(ax: Axes, state: Tangential, length: Scale, *, cells: bool) -> None:
    contact, level, edge = state.contact, stick_edge(state), contact_edge(state.contact)
    two = ListedColormap([SLIP, STICK])
    if cells:
        zones = np.where(state.sticking, 1.0, 0.0)
        shown = np.ma.masked_where(contact.pressure <= 0.0, zones)
        where = extent(contact.x, contact.y, length.size)
        ax.imshow(shown, origin="lower", extent=where, cmap=two, norm=Normalize(0.0, 1.0), interpolation="nearest")
    else:
        place = (contact.x / length.size, contact.y / length.size)
        ax.contourf(*place, edge, levels=[0.0, edge.max() + 1.0], colors=SLIP)
        if level.max() > 0.0:
            ax.contourf(*place, np.minimum(level, edge / edge.max()), levels=[0.0, 2.0], colors=STICK)
            draw_outline(ax, state, level, length, "black")
        draw_outline(ax, state, edge, length, "black")
        ax.set_aspect("equal")
    share = float(state.sticking.sum() / (contact.pressure > 0.0).sum())
    bar = ax.figure.colorbar(ScalarMappable(Normalize(0.0, 1.0), two), ax=ax, pad=0.02, ticks=[0.25, 0.75])
    bar.ax.tick_params(length=0)
    bar.set_ticklabels([f"slips\n{100.0 * (1.0 - share):.0f} %", f"sticks\n{100.0 * share:.0f} %"])


@dataclass(frozen=True, eq=False)
class _Profile:
    """A line along the motion through the middle of the contact, to a cell beyond its edges."""

    place: FloatArray
    """[m]."""
    bound: FloatArray
    shear: FloatArray
    slip: FloatArray
    sticking: BoolArray


def _profile(state: Tangential) -> _Profile:
    contact = state.contact
    (left, right), (low, high) = contact_patch(contact, 1.0)
    cos, sin = state.direction if contact.y.size > 1 else (1.0, 0.0)  # in plane strain the row is all there is
    reach = min(r / abs(c) if abs(c) > 1e-12 else np.inf for r, c in ((min(-left, right), cos), (min(-low, high), sin)))
    step = float(contact.x[1] - contact.x[0])
    count = int(reach / step)
    place = step * np.arange(-count, count + 1, dtype=np.float64)

    def at_line(values: FloatArray) -> FloatArray:
        return _bilinear(contact, values, place * cos, place * sin)

    sizes = np.where(contact.pressure > 0.0, 1.0, 0.0), np.where(state.sticking, 1.0, 0.0)
    touching, sticking = (at_line(size) > 0.5 for size in sizes)
    slip = at_line(np.where(contact.pressure > 0.0, state.along(state.slip), 0.0))
    return _Profile(place, at_line(state.bound), at_line(state.along(state.shear)), slip, touching & sticking)


def _bilinear(contact: ContactFields, values: FloatArray, x: FloatArray, y: FloatArray) -> FloatArray:
    """Values at places between the cells; those of a single row do not depend on y."""
    at_x, at_y = (np.interp(place, axis, np.arange(axis.size)) for place, axis in ((x, contact.x), (y, contact.y)))
    i, j = (at.astype(int) for at in (at_x, at_y))
    to_i, to_j = np.minimum(i + 1, contact.x.size - 1), np.minimum(j + 1, contact.y.size - 1)
    s, t = at_x - i, at_y - j
    return np.asarray(
        (1.0 - t) * ((1.0 - s) * values[j, i] + s * values[j, to_i])
        + t * ((1.0 - s) * values[to_j, i] + s * values[to_j, to_i])
    )


@style.figure
def stick_slip_profiles(states: Sequence[tuple[Run, Snapshot, Look]], *, ax: style.Target | None = None) -> Figure:
    """Shear along the motion between the bounds of friction, and the slip, through the middle of the contact.

    Args:
        states: the states to draw with their looks; the sticking area of a single state is shaded.

    Raises:
        RunError: the bodies do not touch in one of them, or no shear is stored.
    """
    profiles = [_profile(tangential(run, snapshot)) for run, snapshot, _ in states]
    shear = si(largest(one.bound for one in profiles), "Pa")
    slip = si(largest(one.slip for one in profiles), "m")
    length = si(largest(one.place for one in profiles), "m")
    fig = style.new_figure(6.6, 5.2)
    upper, lower = fig.subplots(2, 1, sharex=True)
    alone = len(states) == 1
    for (_, _, look), one in zip(states, profiles, strict=True):
        place, cells = one.place / length.size, {"marker": "o", "markersize": 2.5}
        for sign in (1.0, -1.0):
            colour = style.REFERENCE if alone else look["color"]
            label = r"friction $\times$ pressure" if alone and sign > 0.0 else "_"
            upper.plot(place, sign * one.bound / shear.size, "--", color=colour, linewidth=0.9, label=label)
        upper.plot(place, one.shear / shear.size, **look | cells | ({"label": "shear"} if alone else {}))
        lower.plot(place, one.slip / slip.size, **look | cells)
        for ax in (upper, lower) if alone else ():
            shade_sticking(ax, place, one.sticking)
    for ax in (upper, lower):
        zero_line(ax)
    upper.set_title(f"(a)  {state_title(*states[0][:2]) if alone else 'shear on the lower body'}")
    upper.set_ylabel(shear.label("shear", "q"))
    lower.set_title(f"(b)  slip since {since([run for run, _, _ in states])}")
    lower.set_ylabel(slip.label("slip", "s"))
    lower.set_xlabel(length.label("along the motion", r"x_\parallel"))
    if alone:
        upper.legend(loc="upper left", bbox_to_anchor=(1.02, 1.0), borderaxespad=0.0)
    legend_beside(upper, [look for _, _, look in states])
    return fig
