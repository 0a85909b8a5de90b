# SPDX-License-Identifier: BSD-3-Clause
"""Stress and plastic strain under the contact: a cut through both bodies along the motion."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from matplotlib.axes import Axes
from matplotlib.cm import ScalarMappable
from matplotlib.colors import Normalize
from matplotlib.figure import Figure
from matplotlib.patheffects import withStroke
from matplotlib.ticker import FuncFormatter, MaxNLocator
from numpy.typing import NDArray

from brinell.plot import style
from brinell.plot.cells import at_centre, contact_span, draw_cells, extent
from brinell.plot.scales import Scales
from brinell.plot.states import Side, both_sides, sides, state_title
from brinell.results import Run, Snapshot

__all__ = ["section"]

FloatArray = NDArray[np.float64]

_RIGID_SHARE = 0.15  # height of its strip, over the depth drawn of the other body


@dataclass(frozen=True, eq=False)
class _Field:
    """One field of all bodies, over its scale."""

    name: str
    label: str
    values: list[FloatArray | None]
    """By body, [z][y][x]; None if it is not stored."""
    colour_map: str


@dataclass(frozen=True, eq=False)
class _Window:
    """Part of the plane that is drawn [m]."""

    x: tuple[float, float]
    deep: float

    strip: float
    """Height left for a body that is rigid."""

    def vertical(self, bodies: Sequence[Side]) -> tuple[float, float]:
        """Limits, with the surfaces at 0."""
        drawn = {side.up for side in bodies}
        down, up = (self.deep if sign in drawn else self.strip for sign in (-1.0, 1.0))
        return -down, up


@style.figure
def section(run: Run, snapshot: Snapshot, *, cells: bool = False) -> Figure:
    """Von Mises stress over S_y and equivalent plastic strain of both bodies on the plane y = 0.

    The lower body lies below, the upper one is mirrored above it; they share the line of contact. A rigid body in
    contact is a grey strip; a body without stress and strain is left out. Depth and length have the same scale. While
    the bodies touch, x' is measured from the centre of contact; afterwards each body keeps its own coordinate.

    Args:
        run: where the scales come from.
        snapshot: the state to draw.
        cells: show each cell as a rectangle of one colour instead of interpolating between their centres.
    """
    scales = Scales(run)
    bodies = _stressed(snapshot)
    length = scales.length(max(float(np.abs(side.body.x).max()) for side in bodies))
    panels = _fields(bodies, scales)
    window = _window(snapshot, bodies)
    low, high = window.vertical(bodies)

    # Flat panels one above the other, tall ones side by side.
    shape = (high - low) / (window.x[1] - window.x[0])
    stacked = shape < 0.7
    rows, columns = (len(panels), 1) if stacked else (1, len(panels))
    panel_width = 5.5 if stacked else 4.0
    fig = style.new_figure(columns * (panel_width + 1.1) + 0.8, rows * (panel_width * shape + 0.4) + 0.8, to_scale=True)
    axes = np.atleast_1d(fig.subplots(rows, columns, sharex=True, sharey=True))
    for ax, panel in zip(axes, panels, strict=True):
        _draw(ax, panel, bodies, snapshot, length.size, interpolation="nearest" if cells else "bilinear")
        ax.set_xlim(window.x[0] / length.size, window.x[1] / length.size)
        ax.set_ylim(low / length.size, high / length.size)
    touching = snapshot.in_contact
    along = length.label("from the centre of contact", "x'") if touching else length.label("along each surface", "x")
    for ax in axes if not stacked else axes[-1:]:
        ax.set_xlabel(along)
    for ax in axes if stacked else axes[:1]:
        ax.set_ylabel(length.label("depth", "z", value=False))
    fig.suptitle(f"Plane $y$ = 0:  {state_title(run, snapshot)}", fontsize=10)
    return fig


def _stressed(snapshot: Snapshot) -> list[Side]:
    """The bodies with something to show: an elastic one has nothing once it is unloaded."""

    def has_content(side: Side) -> bool:
        stress = side.body.von_mises_stress
        return bool(np.any(side.body.equivalent_plastic_strain)) or (stress is not None and bool(np.any(stress)))

    return [side for side in sides(snapshot) if has_content(side)] or sides(snapshot)


def _fields(bodies: Sequence[Side], scales: Scales) -> list[_Field]:
    """Stress and plastic strain, as far as there is any; at least one of them."""
    stresses = [side.body.von_mises_stress for side in bodies]
    largest_stress = max((float(s.max()) for s in stresses if s is not None), default=0.0)
    largest_strain = max(float(side.body.equivalent_plastic_strain.max(initial=0.0)) for side in bodies)
    result = []
    if largest_stress > 0.0:
        stress = scales.stress(largest_stress)
        over = [s / stress.size if s is not None else None for s in stresses]
        result.append(_Field("Von Mises stress", stress.label("", r"\sigma_\mathrm{vM}"), over, style.STRESS_MAP))
    if largest_strain > 0.0 or not result:
        percent: list[FloatArray | None] = [100.0 * side.body.equivalent_plastic_strain for side in bodies]
        label = r"$\varepsilon^p_\mathrm{eq}$  [%]"
        result.append(_Field("Equivalent plastic strain", label, percent, style.STRAIN_MAP))
    return result


def _origin(side: Side, snapshot: Snapshot) -> float:
    """Where x is counted from on a body [m]: under the contact while there is one."""
    return side.body.contact_x if snapshot.in_contact else 0.0


def _draw(
    ax: Axes, panel: _Field, bodies: Sequence[Side], snapshot: Snapshot, scale: float, *, interpolation: str
) -> None:
    planes = [
        at_centre(side.body.y, values) if values is not None and values.size else None
        for side, values in zip(bodies, panel.values, strict=True)
    ]
    top = max((float(plane.max()) for plane in planes if plane is not None), default=0.0)
    norm = Normalize(0.0, top if top > 0.0 else 1.0)
    for side, plane in zip(bodies, planes, strict=True):
        if plane is not None:
            draw_cells(
                ax,
                side.body.x - _origin(side, snapshot),
                side.up * side.body.z,
                plane,
                scale,
                cmap=panel.colour_map,
                norm=norm,
                interpolation=interpolation,
            )
    ax.set_facecolor("0.93")
    ax.axhline(0.0, color="white", linewidth=0.8)
    if snapshot.in_contact:
        ends = [end / scale for end in contact_span(snapshot.contact)]
        colour = "white" if len(bodies) == 2 else style.CONTACT_LINE  # white is lost beside the strip
        ax.plot(ends, [0.0, 0.0], color=colour, linewidth=2.6, solid_capstyle="butt", label="contact")
    ax.yaxis.set_major_locator(MaxNLocator(nbins=6, steps=[1, 2, 5, 10]))
    ax.yaxis.set_major_formatter(FuncFormatter(lambda value, _: f"{abs(value):g}"))
    ax.set_title(panel.name)
    _name_bodies(ax, bodies, snapshot)
    ax.figure.colorbar(ScalarMappable(norm, panel.colour_map), ax=ax, label=panel.label, pad=0.02)


def _name_bodies(ax: Axes, bodies: Sequence[Side], snapshot: Snapshot) -> None:
    outline = withStroke(linewidth=1.6, foreground="black", alpha=0.6)
    drawn = {side.name for side in bodies}
    for side in both_sides(snapshot):
        height, anchor = (0.96, "top") if side.up > 0.0 else (0.04, "bottom")
        if side.name in drawn:
            text = ax.text(0.015, height, side.name, transform=ax.transAxes, va=anchor, color="white")
            text.set_path_effects([outline])
        elif snapshot.in_contact:
            ax.text(0.015, height, f"{side.name}, rigid", transform=ax.transAxes, va=anchor, color="0.35")


def _window(snapshot: Snapshot, bodies: Sequence[Side]) -> _Window:
    """Part of the plane worth drawing: around the contact, or all that has yielded."""
    low, high, deep = np.inf, -np.inf, 0.0
    if snapshot.in_contact:
        start, end = contact_span(snapshot.contact)
        centre, reach = 0.5 * (start + end), 0.5 * (end - start)
        low, high, deep = centre - 2.0 * reach, centre + 2.0 * reach, 1.2 * reach
    for side in bodies:
        x, z = _plastic_zone(side)
        if z.size == 0:
            continue
        deep = max(deep, 1.15 * float(z.max()))
        if not snapshot.in_contact:
            margin = 0.1 * float(x.max() - x.min())
            low, high = min(low, float(x.min()) - margin), max(high, float(x.max()) + margin)
    full = [extent(side.body.x - _origin(side, snapshot), side.body.z, 1.0) for side in bodies if side.body.z.size]
    left, right, bottom = min(e[0] for e in full), max(e[1] for e in full), max(e[3] for e in full)
    if not np.isfinite(low):
        low, high = left, right
    deep = min(bottom, deep) if deep > 0.0 else bottom
    strip = _RIGID_SHARE * deep if snapshot.in_contact else 0.0
    return _Window((max(left, low), min(right, high)), deep, strip)


def _plastic_zone(side: Side) -> tuple[FloatArray, FloatArray]:
    """Places x and depths z of cells on y = 0 that have more than a hundredth of the largest plastic strain [m]."""
    strain = side.body.equivalent_plastic_strain
    if strain.size == 0 or strain.max() <= 0.0:
        return np.empty(0), np.empty(0)
    plastic = at_centre(side.body.y, strain) > 1e-2 * strain.max()
    return side.body.x[np.any(plastic, axis=0)], side.body.z[np.any(plastic, axis=1)]
