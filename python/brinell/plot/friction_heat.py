# SPDX-License-Identifier: BSD-3-Clause
"""The heat of friction per area in one state, with the edges of contact and of the sticking area; SI with prefixes."""

from __future__ import annotations

from matplotlib.figure import Figure
from matplotlib.lines import Line2D

from brinell.plot import style
from brinell.plot.cells import contact_patch, contact_span
from brinell.plot.overlay import largest
from brinell.plot.scales import Scale, si
from brinell.plot.states import of_state, state_title
from brinell.plot.tangential import (
    STICK,
    FloatArray,
    Tangential,
    draw_size,
    extended,
    has_slip,
    map_size,
    shade_sticking,
    since,
    tangential,
)
from brinell.results import Run, RunError, Snapshot

__all__ = ["friction_heat_map", "has_friction_heat"]


def has_friction_heat(snapshot: Snapshot) -> bool:
    """Whether stick and slip are stored, and the heat of friction with them."""
    return has_slip(snapshot) and snapshot.contact.friction_heat is not None


@style.figure
@of_state
def friction_heat_map(run: Run, snapshot: Snapshot, *, cells: bool = False, ax: style.Target | None = None) -> Figure:
    """Energy that friction has dissipated per area, with the edges of the contact and of the sticking area.

    The energy counts from the start; in rolling, from when each place came under the contact. In plane strain the
    figure is a line over x, and the sticking area is shaded.

    Args:
        run: the run of the state, for friction and direction.

    Raises:
        RunError: the bodies do not touch in this state, or no heat of friction is stored.
    """
    state = tangential(run, snapshot)
    contact, values = state.contact, state.contact.friction_heat
    if values is None:
        raise RunError(f"{run.path}: no heat of friction in the state at step {snapshot.step}, so nothing to draw")
    # As for the slip, the cells around the contact have the heat of those beside them: at the edge it need not end.
    around = extended(values, contact.pressure > 0.0)
    heat = si(largest([values]), "J/m²")
    title = f"Heat of friction per area since {since([run])}:\n{state_title(run, snapshot)}"
    if contact.y.size == 1:
        return _heat_line(state, values[0], heat, title)
    patch = contact_patch(contact, 1.0)
    length = si(max(patch[0][1], patch[1][1]), "m")
    wide, high = map_size(contact)
    fig = style.new_figure(1.7 + 1.1 * wide, 1.3 + 1.1 * high, to_scale=True)
    ax = fig.subplots()
    label = heat.label("", "w^f")
    draw_size(ax, state, around, length, heat, (_HEAT_MAP, label), cells=cells, stick=STICK)
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


def _name_edges(fig: Figure, state: Tangential) -> None:
    """Explains below the map which line is the edge of the contact, and which that of the sticking area."""
    named = [Line2D([], [], color="black", linewidth=1.0, label="edge of the contact")]
    if state.sticking.any() and not state.sticking.all():
        named.append(Line2D([], [], color=STICK, linewidth=1.0, label="edge of the sticking area"))
    fig.legend(handles=named, loc="outside lower center", ncols=2 if fig.get_figwidth() > 4.0 else 1)


def _heat_line(state: Tangential, values: FloatArray, heat: Scale, title: str) -> Figure:
    """The heat over x, in plane strain."""
    contact = state.contact
    left, right = contact_patch(contact, 1.0)[0]
    length = si(max(-left, right), "m")
    shown = (left <= contact.x) & (contact.x <= right)
    fig = style.new_figure(5.8, 3.3)
    ax = fig.subplots()
    place = contact.x[shown] / length.size
    shade_sticking(ax, place, state.sticking[0, shown])
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
