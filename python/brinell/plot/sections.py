# SPDX-License-Identifier: BSD-3-Clause
"""Stress, plastic strain and temperature inside the bodies: cuts along any plane."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.cm import ScalarMappable
from matplotlib.figure import Figure
from matplotlib.image import AxesImage
from matplotlib.lines import Line2D
from matplotlib.patheffects import withStroke
from matplotlib.ticker import FuncFormatter, MaxNLocator
from numpy.typing import NDArray

from brinell.plot import style
from brinell.plot.cells import contact_edge, draw_cells
from brinell.plot.cuts import (
    Cut,
    Panel,
    Window,
    contact_on,
    from_contact,
    panel_of,
    round_contact,
    usual_quantities,
    window_of,
)
from brinell.plot.inclusions import draw_inclusions
from brinell.plot.interfaces import draw_interfaces
from brinell.plot.planes import Plane, plane_of
from brinell.plot.quantities import quantity_of
from brinell.plot.scales import Scale, Scales
from brinell.plot.sheets import enlarged, few_ticks
from brinell.plot.states import Bodies, Side, both_sides, chosen_sides, of_state, state_title
from brinell.plot.where import Cutting, goes_round, section_of
from brinell.results import ContactFields, Run, Snapshot
from brinell.scenarios import SCENARIOS

__all__ = [
    "across_label",
    "broken_line",
    "draw_contact",
    "draw_outline",
    "draw_panel",
    "name_contact_axes",
    "section",
    "upright_axes",
]


_FLAT = 0.3
"""Height over width below which a colour bar finds no room beside the picture."""
_LEAST_HEIGHT = 1.2
"""Of a panel [inch]; a depth that would be lower is drawn enlarged."""


@style.figure
@of_state
def section(
    run: Run,
    snapshot: Snapshot,
    *,
    field: str | Sequence[str] | None = None,
    plane: Plane | str | tuple[str, float] | None = None,
    bodies: Bodies = "both",
    cells: bool = False,
    ax: style.Target | None = None,
) -> Figure:
    """Fields of the bodies on a plane, to scale.

    On a plane along y or x the lower body lies below, the upper one is mirrored above it; they share the line of
    contact. A rigid body in contact is a grey strip; a body with nothing to show is left out. On a plane z, at a
    depth of each body, there is a picture per body, with the outline of the contact. Interfaces
    of coated bodies and outlines of inclusions are dashed. While the bodies touch, x' is
    measured from the centre of contact, also that of the plane; afterwards each body keeps its own coordinate.

    Args:
        run: where the scales come from.
        snapshot: the state to draw; with tensors if a component is asked for.
        field: one or several of `brinell.plot.QUANTITIES`; by default von Mises stress and equivalent plastic strain.
        plane: "y=0", "x = 0.1 mm", ("z", 2e-5); see `planes.plane_of`. None: y = 0, or the plane through the largest
            plastic strain if little has yielded on y = 0, as the title then says.
        bodies: "both", "lower" or "upper".

    Raises:
        RunError: a field is not stored, the plane lies outside the grids, or the body is rigid.
        InputError: no such field or plane.
    """
    names = [field] if isinstance(field, str) else field
    drawn = _with_content(chosen_sides(run, snapshot, bodies), names or ())
    cutting = section_of(snapshot, drawn) if plane is None else Cutting(plane_of(plane), "")
    cut = cutting.plane
    quantities = usual_quantities(drawn) if names is None else [quantity_of(name) for name in names]
    origin = from_contact(snapshot)
    panels = [panel_of(run, snapshot, drawn, quantity, cut, origin) for quantity in quantities]
    if _is_turned(run, snapshot, cut):
        for panel in panels:
            panel.cuts[:] = [round_contact(one) for one in panel.cuts]
    window = window_of(snapshot, drawn, cut, origin, goes_round(run)).within(panels)
    interpolation = "nearest" if cells else "bilinear"
    draw = _level if cut.axis == "z" else _upright
    fig = draw(run, snapshot, panels, window, cut, interpolation)
    place = cut.label(from_contact=snapshot.in_contact and cut.axis == "x")
    place = f"{'Depth' if cut.axis == 'z' else 'Plane'} {place}"
    place += f", {cutting.reason}" if cutting.reason else ""
    fig.suptitle(f"{place}:  {state_title(run, snapshot)}", fontsize=style.font(10))
    return fig


def _is_turned(run: Run, snapshot: Snapshot, plane: Plane) -> bool:
    """Whether a period along x is turned round so that the contact is in the middle."""
    return goes_round(run)[0] and snapshot.in_contact and plane.axis != "x"


def _with_content(bodies: list[Side], names: Sequence[str]) -> list[Side]:
    """The bodies with values to show; an unloaded elastic body may have only its temperature."""

    def has_content(side: Side) -> bool:
        if "temperature" in names and side.body.temperature is not None:
            return True
        stress = side.body.von_mises_stress
        return side.body.has_yielded or (stress is not None and bool(np.any(stress)))

    return [side for side in bodies if has_content(side)] or bodies


def _upright(
    run: Run, snapshot: Snapshot, panels: Sequence[Panel], window: Window, plane: Plane, interpolation: str
) -> Figure:
    """Figure of a plane normal to the surface, with a panel per field: wide panels in a column, tall ones in a row."""
    length = _length(run, panels)
    bodies = max(len(panel.cuts) for panel in panels)
    stacked = window.shape < 0.7
    rows, columns = (len(panels), 1) if stacked else (1, len(panels))
    width = 5.5 if stacked else 4.0
    to_scale = width * window.shape
    panel_height = max(to_scale, _LEAST_HEIGHT)
    height = panel_height + (1.3 if window.shape < _FLAT else 0.4)
    fig = style.new_figure(columns * (width + 1.1) + 0.8, rows * height + 0.8, to_scale=True)
    axes = np.atleast_1d(fig.subplots(rows, columns, sharex=True, sharey=True))
    for ax, panel in zip(axes, panels, strict=True):
        draw_panel(ax, panel, window, length.size, interpolation)
        draw_interfaces(ax, run, panel.cuts, length.size)
        turned = _is_turned(run, snapshot, plane)
        draw_inclusions(ax, panel.cuts, plane, from_contact(snapshot), length.size, turned=turned)
        upright_axes(ax, snapshot, panel, window, length.size)
        if panel_height > to_scale:
            few_ticks(ax, panel_height)
            ax.set_aspect(panel_height / to_scale)
        if snapshot.in_contact:
            draw_contact(ax, snapshot.contact, plane, length.size)
    for ax in axes[-1:] if stacked else axes:
        ax.set_xlabel(across_label(length, plane, from_contact=snapshot.in_contact, bodies=bodies))
    for ax in axes if stacked else axes[:1]:
        ax.set_ylabel(enlarged(length.label("depth", "z", value=False), panel_height / to_scale))
    return fig


def _level(
    run: Run, snapshot: Snapshot, panels: Sequence[Panel], window: Window, plane: Plane, interpolation: str
) -> Figure:
    """Figure of a plane at a depth: a row of panels per body, a column per field."""
    length = _length(run, panels)
    bodies = max(len(panel.cuts) for panel in panels)
    names = list(dict.fromkeys(cut.side.name for panel in panels for cut in panel.cuts))
    width = 4.0
    fig = style.new_figure(
        len(panels) * (width + 1.1) + 0.8, len(names) * (width * window.shape + 0.4) + 0.8, to_scale=True
    )
    axes = fig.subplots(len(names), len(panels), sharex=True, sharey=True, squeeze=False)
    for column, panel in zip(axes.T, panels, strict=True):
        for ax, name in zip(column, names, strict=True):
            cuts = [cut for cut in panel.cuts if cut.side.name == name]
            _draw_cuts(ax, panel, cuts, length.size, interpolation)
            turned = _is_turned(run, snapshot, plane)
            draw_inclusions(ax, cuts, plane, from_contact(snapshot), length.size, turned=turned)
            ax.set_xlim(*(edge / length.size for edge in window.across))
            ax.set_ylim(*(edge / length.size for edge in window.upward))
            _name_body(ax, name, 0.96, "top")
            if snapshot.in_contact:
                draw_outline(ax, snapshot.contact, length.size)
        column[0].set_title(panel.title)
        _colour_bar(column, panel, below=len(names) * window.shape < _FLAT)
    for ax in axes[-1]:
        ax.set_xlabel(across_label(length, plane, from_contact=snapshot.in_contact, bodies=bodies))
    for ax in axes[:, 0]:
        ax.set_ylabel(length.label("across", "y'" if snapshot.in_contact else "y", value=False))
    return fig


def _length(run: Run, panels: Sequence[Panel]) -> Scale:
    """Scale of both axes."""
    return Scales(run).length(max(float(np.abs(cut.across).max()) for panel in panels for cut in panel.cuts))


def across_label(length: Scale, plane: Plane, *, from_contact: bool, bodies: int) -> str:
    """Label of the horizontal axis, for a number of bodies."""
    if plane.axis == "x":
        return length.label("across", "y'" if from_contact else "y")
    if from_contact:
        return length.label("from the centre of contact", "x'")
    return length.label("along the surface" if bodies == 1 else "along each surface", "x")


def name_contact_axes(ax: Axes, length: Scale, snapshot: Snapshot) -> None:
    """Labels the axes of a map of the contact."""
    moves = SCENARIOS[snapshot.scenario].motion is not None
    ax.set_xlabel(length.label("along the motion" if moves else "", "x'"))
    ax.set_ylabel(length.label("across" if moves else "", "y'", value=False))


def draw_panel(ax: Axes, panel: Panel, window: Window, length: float, interpolation: str) -> list[AxesImage]:
    """Draws the bodies on a plane with colour bar and title; a panel per body."""
    images = _draw_cuts(ax, panel, panel.cuts, length, interpolation)
    ax.set_title(panel.title)
    _colour_bar(ax, panel, below=window.shape < _FLAT)
    return images


def _draw_cuts(ax: Axes, panel: Panel, cuts: Sequence[Cut], length: float, interpolation: str) -> list[AxesImage]:
    ax.set_facecolor("0.93")
    return [
        draw_cells(
            ax,
            cut.across,
            cut.upward,
            cut.values / panel.unit,
            length,
            cmap=panel.colour_map,
            norm=panel.norm,
            interpolation=interpolation,
        )
        for cut in cuts
    ]


def _colour_bar(ax: Axes | Sequence[Axes], panel: Panel, *, below: bool) -> None:
    """Draws the colour bar beside the axes, or below axes that are too flat for its label."""
    first = ax if isinstance(ax, Axes) else ax[0]
    place: dict[str, Any] = {"location": "bottom", "aspect": 40.0, "shrink": 0.7} if below else {"pad": 0.02}
    first.figure.colorbar(ScalarMappable(panel.norm, panel.colour_map), ax=ax, label=panel.label, **place)


def upright_axes(ax: Axes, snapshot: Snapshot, panel: Panel, window: Window, length: float) -> None:
    """Sets limits, ticks of the depth counted from the middle, and the names of the bodies."""
    ax.set_xlim(*(edge / length for edge in window.across))
    ax.set_ylim(*(edge / length for edge in window.upward))
    ax.axhline(0.0, color="white", linewidth=0.8)
    ax.yaxis.set_major_locator(MaxNLocator(nbins=6, steps=[1, 2, 5, 10]))
    ax.yaxis.set_major_formatter(FuncFormatter(lambda value, _: f"{abs(value):g}"))
    drawn = {cut.side.name for cut in panel.cuts}
    for side in both_sides(snapshot):
        height, anchor = (0.96, "top") if side.up > 0.0 else (0.04, "bottom")
        if side.name in drawn:
            _name_body(ax, side.name, height, anchor)
        elif side.body.is_rigid and snapshot.in_contact:
            ax.text(0.015, height, f"{side.name}, rigid", transform=ax.transAxes, va=anchor, color="0.35")


def _name_body(ax: Axes, name: str, height: float, anchor: str) -> None:
    """Writes the name of a body in white with a dark rim, which is legible on any colour."""
    text = ax.text(0.015, height, name, transform=ax.transAxes, va=anchor, color="white")
    text.set_path_effects([withStroke(linewidth=2.2, foreground="black", alpha=0.75)])


def draw_contact(ax: Axes, contact: ContactFields, plane: Plane, length: float) -> Line2D:
    """Draws where the bodies touch on a plane normal to the surface, with a dark rim that is visible on any map."""
    look: dict[str, Any] = {"color": "white", "linewidth": 2.2, "solid_capstyle": "butt", "label": "contact"}
    (line,) = ax.plot(*broken_line(contact_on(contact, plane), length), clip_on=False, **look)  # it may lie on the rim
    line.set_path_effects([withStroke(linewidth=3.6, foreground="black", alpha=0.7)])
    return line


def broken_line(pieces: Sequence[tuple[float, float]], length: float) -> tuple[NDArray[np.float64], ...]:
    """A line on the surface with gaps between its pieces [m], over the length."""
    ends = np.array([(start, end, np.nan) for start, end in pieces], dtype=np.float64).ravel()[:-1] / length
    return ends, np.where(np.isnan(ends), np.nan, 0.0)


def draw_outline(ax: Axes, contact: ContactFields, length: float) -> None:
    """Draws the edge of contact, seen from above, with a dark rim that is visible on any map."""
    edge = contact_edge(contact)
    if not edge.min() < 0.0 < edge.max():  # all touches, or nothing
        return
    lines = ax.contour(contact.x / length, contact.y / length, edge, levels=[0.0], colors="white", linewidths=1.0)
    lines.set_path_effects([withStroke(linewidth=2.2, foreground="black", alpha=0.6)])
