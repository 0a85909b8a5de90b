# SPDX-License-Identifier: BSD-3-Clause
"""Stick and slip in one state: maps over the contact, profiles along the motion, and the heat of friction per area.

SI with prefixes throughout. The shear is that on the lower body, the slip that of the upper surface over the lower one
since the start; in rolling, since these places came under the contact.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from matplotlib.axes import Axes
from matplotlib.cm import ScalarMappable
from matplotlib.colors import ListedColormap, Normalize
from matplotlib.figure import Figure
from matplotlib.image import AxesImage
from matplotlib.lines import Line2D
from numpy.typing import NDArray

from brinell.plot import style
from brinell.plot.cells import contact_edge, contact_patch, contact_span, extent, refined
from brinell.plot.overlay import Look, largest, legend_beside, zero_line
from brinell.plot.scales import Scale, si
from brinell.plot.states import of_state, state_title
from brinell.results import ContactFields, Run, RunError, Snapshot

__all__ = ["friction_heat_map", "has_friction_heat", "has_slip", "stick_slip_maps", "stick_slip_profiles", "sticks"]

FloatArray = NDArray[np.float64]
BoolArray = NDArray[np.bool_]
Component = FloatArray | None

_BOUND = 1.0 - 1e-12
"""Of friction times pressure: a shear that is larger slips."""
_STICK, _SLIP = "#56B4E9", "#F6DDB0"  # Okabe-Ito sky blue, and a tint of its orange


@dataclass(frozen=True, eq=False)
class _Tangential:
    """What acts and what moves along the surface in a state that touches; arrays [y][x]."""

    contact: ContactFields
    bound: FloatArray
    """Friction times pressure [Pa]."""
    shear: tuple[FloatArray, FloatArray]
    """Along x and y [Pa]."""
    slip: tuple[FloatArray, FloatArray]
    """[m]."""
    direction: tuple[float, float]
    """Unit vector of the motion."""
    sticking: BoolArray

    @property
    def shear_size(self) -> FloatArray:
        return np.hypot(*self.shear)

    @property
    def slip_size(self) -> FloatArray:
        """Where the surfaces touch, and as much in the cells around: it is largest at the edge, where it ends."""
        touching = self.contact.pressure > 0.0
        return _extended(np.hypot(*self.slip), touching)

    def along(self, vector: tuple[FloatArray, FloatArray]) -> FloatArray:
        """Its component along the motion."""
        return vector[0] * self.direction[0] + vector[1] * self.direction[1]


def _since(runs: Sequence[Run]) -> str:
    """From when on the slip counts: where the contact moves, each place has its own beginning."""
    return "the start" if all(run.scenario == "fretting" for run in runs) else "these places touched"


def has_slip(snapshot: Snapshot) -> bool:
    """Whether the bodies touch, and shears and slips are stored."""
    contact = snapshot.contact
    return snapshot.in_contact and contact.shear_x is not None and contact.slip_x is not None


def sticks(contact: ContactFields, bound: FloatArray) -> BoolArray:
    """Cells under pressure whose shear is below its bound [Pa]; without a shear all of them."""
    return np.asarray((contact.pressure > 0.0) & (_shear_size(contact) < _BOUND * bound))


def _shear_size(contact: ContactFields) -> FloatArray:
    zero = np.zeros_like(contact.pressure)
    return np.hypot(*(zero if one is None else one for one in (contact.shear_x, contact.shear_y)))


def _tangential(run: Run, snapshot: Snapshot) -> _Tangential:
    if not has_slip(snapshot):
        raise RunError(f"{run.path}: no shear and slip in the state at step {snapshot.step}, so nothing to draw")
    contact = snapshot.contact

    def field(values: Component) -> FloatArray:
        return np.zeros_like(contact.pressure) if values is None else values

    angle = np.radians(float(run.case("fretting", "direction") or 0.0)) if run.complete else 0.0
    friction = float(run.case("interface", "friction") or 0.0)
    return _Tangential(
        contact,
        friction * contact.pressure,
        (field(contact.shear_x), field(contact.shear_y)),
        (field(contact.slip_x), field(contact.slip_y)),
        (float(np.cos(angle)), float(np.sin(angle))),
        _sticking(snapshot, friction * contact.pressure),
    )


def _sticking(snapshot: Snapshot, bound: FloatArray) -> BoolArray:
    """What sticks, as much of it as the history tells.

    A surface that yields carries less than friction times pressure, by a limit that is not stored: of the cells below
    that bound those with the largest shear are at it.
    """
    contact = snapshot.contact
    found = sticks(contact, bound)
    told = round(snapshot.row["stick_share"] * int(np.count_nonzero(contact.pressure > 0.0)))
    surplus = int(np.count_nonzero(found)) - told
    if surplus > 0:
        size = np.where(found, _shear_size(contact), -1.0)
        found.flat[np.argsort(size, axis=None)[-surplus:]] = False
    return found


def _stick_edge(state: _Tangential) -> FloatArray:
    """A function whose zero line is the edge of the sticking area, positive inside [-], array [y][x].

    Near the edge what is left to the bound grows with the root of the distance, as pressure does near the edge of
    contact: its square is linear there. What slips has nothing of the kind, so the edge is halfway to the next cell.
    """
    inside = state.sticking
    left = np.where(inside, state.bound - state.shear_size, 0.0) ** 2
    if not inside.any():
        return np.full_like(left, -1.0)
    rim = np.zeros_like(inside)
    rim[:, 1:] |= inside[:, 1:] & ~inside[:, :-1]
    rim[:, :-1] |= inside[:, :-1] & ~inside[:, 1:]
    rim[1:, :] |= inside[1:, :] & ~inside[:-1, :]
    rim[:-1, :] |= inside[:-1, :] & ~inside[1:, :]
    beyond = float(left[rim].mean()) if rim.any() else float(left.max())
    return np.asarray(np.where(inside, left, -beyond) / left.max())


def _extended(values: FloatArray, where: BoolArray) -> FloatArray:
    """The values there, in the cells beside it the means of those neighbours, and 0 elsewhere."""
    inside = np.where(where, values, 0.0)
    total, count = (np.pad(one, 1) for one in (inside, where.astype(np.float64)))
    ny, nx = values.shape
    shifts = [(j, i) for j in range(3) for i in range(3)]
    sums, counts = (sum(one[j : j + ny, i : i + nx] for j, i in shifts) for one in (total, count))
    return np.asarray(np.where(where, inside, sums / np.maximum(counts, 1.0)))


@style.figure
@of_state
def stick_slip_maps(run: Run, snapshot: Snapshot, *, cells: bool = False) -> Figure:
    """Pressure with the shear as arrows, what sticks and what slips, sizes of shear and slip.

    Args:
        run: where friction and direction come from.
        snapshot: the state to draw.
        cells: show each cell as a rectangle of one colour instead of interpolating between their centres.

    Raises:
        RunError: the bodies do not touch in this state, or no shear is stored.
    """
    state = _tangential(run, snapshot)
    contact = state.contact
    if contact.y.size == 1:
        raise RunError(f"{run.path}: a single row of cells has no maps; profiles show all of it")
    length = si(max(contact_patch(contact, 1.0)[0][1], contact_patch(contact, 1.0)[1][1]), "m")
    wide, high = _map_size(contact)
    fig = style.new_figure(2.6 + 2.0 * wide, 0.8 + 2.0 * high, to_scale=True)
    axes = fig.subplots(2, 2, sharex=True, sharey=True)
    _draw_pressure(axes[0, 0], state, length, cells=cells)
    _draw_sticking(axes[0, 1], state, length, cells=cells)
    shear, slip = (si(largest([size]), unit) for size, unit in ((state.shear_size, "Pa"), (state.slip_size, "m")))
    _draw_size(
        axes[1, 0], state, state.shear_size, length, shear, (style.STRESS_MAP, shear.label("", "|q|")), cells=cells
    )
    _draw_size(axes[1, 1], state, state.slip_size, length, slip, (style.STRAIN_MAP, slip.label("", "|s|")), cells=cells)
    both = "pressure, and the shear on the lower body" if wide > 2.0 else "pressure, and shear\n     on the lower body"
    titles = (both, "what sticks", "shear", f"slip since {_since([run])}")
    for ax, letter, title in zip(axes.flat, "abcd", titles, strict=True):
        ax.set_title(f"({letter})  {title}")
    patch = contact_patch(contact, length.size)
    axes[0, 0].set_xlim(*patch[0])
    axes[0, 0].set_ylim(*patch[1])
    for ax in axes[1]:
        ax.set_xlabel(length.label("", "x'"))
    for ax in axes[:, 0]:
        ax.set_ylabel(length.label("", "y'"))
    fig.suptitle(f"Stick and slip:  {state_title(run, snapshot)}", x=0.01, ha="left", fontsize=10)
    return fig


def _map_size(contact: ContactFields) -> tuple[float, float]:
    """Width and height of a map [inch], by the shape of the contact: with no empty space beside a narrow one."""
    (left, right), (low, high) = contact_patch(contact, 1.0)
    aspect = (right - left) / (high - low)
    return max(1.3, 3.3 * min(aspect, 1.0)), max(1.1, 3.3 / max(aspect, 1.0))


def _image(
    ax: Axes, state: _Tangential, values: FloatArray, length: Scale, scale: Scale, cmap: str, *, cells: bool
) -> AxesImage:
    """A field of the contact, white around it."""
    contact = state.contact
    edge = contact_edge(contact)
    factor = 1 if cells else max(2, 600 // min(contact.pressure.shape))
    outside = contact.pressure <= 0.0 if cells else refined(edge, factor) <= 0.0
    shown = np.ma.masked_where(outside, refined(values, factor) / scale.size)
    image = ax.imshow(
        shown,
        origin="lower",
        extent=extent(contact.x, contact.y, length.size),
        cmap=cmap,
        norm=Normalize(0.0, float(values.max()) / scale.size or 1.0),
        interpolation="nearest",
    )
    if not cells:
        # Even the refined cells show as steps: cut them along the edge.
        place = (contact.x / length.size, contact.y / length.size)
        ax.contourf(*place, edge, levels=[edge.min() - 1.0, 0.0], colors="white")
        _outline(ax, state, edge, length, "black")
    return image


def _outline(ax: Axes, state: _Tangential, level: FloatArray, length: Scale, colour: str) -> None:
    if level.min() < 0.0 < level.max():
        place = (state.contact.x / length.size, state.contact.y / length.size)
        ax.contour(*place, level, levels=[0.0], colors=colour, linewidths=1.0)


def _draw_pressure(ax: Axes, state: _Tangential, length: Scale, *, cells: bool) -> None:
    pressure = si(float(state.contact.pressure.max()), "Pa")
    image = _image(ax, state, state.contact.pressure, length, pressure, style.PRESSURE_MAP, cells=cells)
    ax.figure.colorbar(image, ax=ax, label=pressure.label("", "p"), pad=0.02)
    _draw_arrows(ax, state, length)


_ARROWS = 13
"""Across the contact."""


def _draw_arrows(ax: Axes, state: _Tangential, length: Scale) -> None:
    """The shear, on every so many cells."""
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
    """The largest number of one digit that is not larger; of a value > 0."""
    power = 10.0 ** np.floor(np.log10(value))
    return float(max(n for n in range(1, 10) if n * power <= value * (1.0 + 1e-12)) * power)


def _about_middle(indices: NDArray[np.intp], stride: int) -> NDArray[np.intp]:
    """Every so many of them, as far from both ends."""
    return indices[((indices.size - 1) % stride) // 2 :: stride]


def _draw_sticking(ax: Axes, state: _Tangential, length: Scale, *, cells: bool) -> None:
    contact, level, edge = state.contact, _stick_edge(state), contact_edge(state.contact)
    two = ListedColormap([_SLIP, _STICK])
    if cells:
        zones = np.where(state.sticking, 1.0, 0.0)
        shown = np.ma.masked_where(contact.pressure <= 0.0, zones)
        where = extent(contact.x, contact.y, length.size)
        ax.imshow(shown, origin="lower", extent=where, cmap=two, norm=Normalize(0.0, 1.0), interpolation="nearest")
    else:
        place = (contact.x / length.size, contact.y / length.size)
        ax.contourf(*place, edge, levels=[0.0, edge.max() + 1.0], colors=_SLIP)
        if level.max() > 0.0:
            ax.contourf(*place, np.minimum(level, edge / edge.max()), levels=[0.0, 2.0], colors=_STICK)
            _outline(ax, state, level, length, "black")
        _outline(ax, state, edge, length, "black")
        ax.set_aspect("equal")
    share = float(state.sticking.sum() / (contact.pressure > 0.0).sum())
    bar = ax.figure.colorbar(ScalarMappable(Normalize(0.0, 1.0), two), ax=ax, pad=0.02, ticks=[0.25, 0.75])
    bar.ax.tick_params(length=0)
    bar.set_ticklabels([f"slips\n{100.0 * (1.0 - share):.0f} %", f"sticks\n{100.0 * share:.0f} %"])


def _draw_size(
    ax: Axes,
    state: _Tangential,
    values: FloatArray,
    length: Scale,
    scale: Scale,
    look: tuple[str, str],
    *,
    cells: bool,
    stick: str = "white",
) -> None:
    """A size with colour map and label, and around what sticks a line of the colour `stick`."""
    image = _image(ax, state, values, length, scale, look[0], cells=cells)
    if not cells:
        _outline(ax, state, _stick_edge(state), length, stick)
    ax.figure.colorbar(image, ax=ax, label=look[1], pad=0.02)


def has_friction_heat(snapshot: Snapshot) -> bool:
    """Whether stick and slip are stored, and the heat of friction with them."""
    return has_slip(snapshot) and snapshot.contact.friction_heat is not None


@style.figure
@of_state
def friction_heat_map(run: Run, snapshot: Snapshot, *, cells: bool = False) -> Figure:
    """Energy that friction has dissipated per area, with the edges of the contact and of what sticks.

    Since the start; in rolling, since these places came under the contact. In plane strain a line over x, with what
    sticks shaded.

    Args:
        run: where friction and direction come from.
        snapshot: the state to draw.
        cells: show each cell as a rectangle of one colour instead of interpolating between their centres.

    Raises:
        RunError: the bodies do not touch in this state, or no heat of friction is stored.
    """
    state = _tangential(run, snapshot)
    contact, values = state.contact, state.contact.friction_heat
    if values is None:
        raise RunError(f"{run.path}: no heat of friction in the state at step {snapshot.step}, so nothing to draw")
    # As for the slip, the cells around the contact have the heat of those beside them: at the edge it need not end.
    around = _extended(values, contact.pressure > 0.0)
    heat = si(largest([values]), "J/m²")
    title = f"Heat of friction per area since {_since([run])}:\n{state_title(run, snapshot)}"
    if contact.y.size == 1:
        return _heat_line(state, values[0], heat, title)
    patch = contact_patch(contact, 1.0)
    length = si(max(patch[0][1], patch[1][1]), "m")
    wide, high = _map_size(contact)
    fig = style.new_figure(1.7 + 1.1 * wide, 1.3 + 1.1 * high, to_scale=True)
    ax = fig.subplots()
    label = heat.label("", "w^f")
    _draw_size(ax, state, around, length, heat, (_HEAT_MAP, label), cells=cells, stick=_STICK)
    patch = contact_patch(contact, length.size)
    ax.set_xlim(*patch[0])
    ax.set_ylim(*patch[1])
    ax.set_xlabel(length.label("", "x'"))
    ax.set_ylabel(length.label("", "y'"))
    ax.set_title(title)
    if not cells:
        _name_edges(fig, state)
    return fig


_HEAT_MAP = "inferno"


def _name_edges(fig: Figure, state: _Tangential) -> None:
    """Below the map: which line is the edge of what."""
    named = [Line2D([], [], color="black", linewidth=1.0, label="edge of the contact")]
    if state.sticking.any() and not state.sticking.all():
        named.append(Line2D([], [], color=_STICK, linewidth=1.0, label="edge of the sticking area"))
    fig.legend(handles=named, loc="outside lower center", ncols=2 if fig.get_figwidth() > 4.0 else 1)


def _heat_line(state: _Tangential, values: FloatArray, heat: Scale, title: str) -> Figure:
    """In plane strain."""
    contact = state.contact
    left, right = contact_patch(contact, 1.0)[0]
    length = si(max(-left, right), "m")
    shown = (left <= contact.x) & (contact.x <= right)
    fig = style.new_figure(5.8, 3.3)
    ax = fig.subplots()
    place = contact.x[shown] / length.size
    _shade(ax, place, state.sticking[0, shown])
    ax.plot(place, values[shown] / heat.size, marker="o", markersize=2.5, color=style.LOWER)
    for number, at in enumerate(contact_span(contact)):
        label = "edge of the contact" if number == 0 else "_"
        ax.axvline(at / length.size, color="black", linewidth=1.0, label=label)
    ax.set_xlim(left / length.size, right / length.size)
    ax.set_ylim(bottom=0.0)
    ax.set_xlabel(length.label("", "x'"))
    ax.set_ylabel(heat.label("", "w^f"))
    ax.set_title(title)
    ax.legend(loc="upper left", bbox_to_anchor=(1.02, 1.0), borderaxespad=0.0)
    return fig


@dataclass(frozen=True, eq=False)
class _Profile:
    """Along the motion through the middle of the contact, as far as it touches and a cell beyond."""

    place: FloatArray
    """[m]."""
    bound: FloatArray
    shear: FloatArray
    slip: FloatArray
    sticking: BoolArray


def _profile(state: _Tangential) -> _Profile:
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
    """Between the cells; a single row is the same along y."""
    at_x, at_y = (np.interp(place, axis, np.arange(axis.size)) for place, axis in ((x, contact.x), (y, contact.y)))
    i, j = (at.astype(int) for at in (at_x, at_y))
    to_i, to_j = np.minimum(i + 1, contact.x.size - 1), np.minimum(j + 1, contact.y.size - 1)
    s, t = at_x - i, at_y - j
    return np.asarray(
        (1.0 - t) * ((1.0 - s) * values[j, i] + s * values[j, to_i])
        + t * ((1.0 - s) * values[to_j, i] + s * values[to_j, to_i])
    )


@style.figure
def stick_slip_profiles(states: Sequence[tuple[Run, Snapshot, Look]]) -> Figure:
    """Shear along the motion between the bounds of friction, and the slip, through the middle of the contact.

    Args:
        states: what to draw, with its looks; of a single one what sticks is shaded.

    Raises:
        RunError: the bodies do not touch in one of them, or no shear is stored.
    """
    profiles = [_profile(_tangential(run, snapshot)) for run, snapshot, _ in states]
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
            _shade(ax, place, one.sticking)
    for ax in (upper, lower):
        zero_line(ax)
    upper.set_title(f"(a)  {state_title(*states[0][:2]) if alone else 'shear on the lower body'}")
    upper.set_ylabel(shear.label("shear", "q"))
    lower.set_title(f"(b)  slip since {_since([run for run, _, _ in states])}")
    lower.set_ylabel(slip.label("slip", "s"))
    lower.set_xlabel(length.label("along the motion", r"x_\parallel"))
    if alone:
        upper.legend(loc="upper left", bbox_to_anchor=(1.02, 1.0), borderaxespad=0.0)
    legend_beside(upper, [look for _, _, look in states])
    return fig


def _shade(ax: Axes, place: FloatArray, sticking: BoolArray) -> None:
    """Behind the curves, where the surfaces stick: half a cell beyond the centres."""
    half = 0.5 * (place[1] - place[0])
    ends = np.flatnonzero(np.diff(np.concatenate([[False], sticking, [False]]).astype(int)))
    for number, (first, last) in enumerate(ends.reshape(-1, 2)):
        label = "sticks" if number == 0 else "_"
        ax.axvspan(place[first] - half, place[last - 1] + half, color=_STICK, alpha=0.25, lw=0.0, zorder=0, label=label)
