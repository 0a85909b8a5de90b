# SPDX-License-Identifier: BSD-3-Clause
"""Figures of one state: contact pressure, residual surfaces, stress, plastic strain and heat under the contact."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from matplotlib.axes import Axes
from matplotlib.colors import Normalize
from matplotlib.figure import Figure
from matplotlib.image import AxesImage
from numpy.typing import NDArray

from brinell.plot import style
from brinell.plot.cells import contact_edge, contact_patch, draw_cells, extent, refined
from brinell.plot.current import current_density_map, has_current
from brinell.plot.cuts import has_section
from brinell.plot.friction_heat import friction_heat_map, has_friction_heat
from brinell.plot.residual import residual_surfaces
from brinell.plot.scales import Scale, Scales
from brinell.plot.sections import section
from brinell.plot.sheets import lying, sheet_of
from brinell.plot.slip import stick_slip_maps
from brinell.plot.states import of_state, sides, state_title
from brinell.plot.tangential import has_slip
from brinell.plot.temperature import has_heat, surface_temperature_maps, temperature_section
from brinell.results import ContactFields, Run, RunError, Snapshot
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


FIGURES: dict[str, Callable[..., Figure]] = {
    "pressure": pressure_map,
    "gap": gap_map,
    "residual-surfaces": residual_surfaces,
    "section": section,
    "stick-slip": stick_slip_maps,
    "friction-heat": friction_heat_map,
    "current-density": current_density_map,
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
    if name == "current-density":
        return has_current(snapshot)
    if name == "temperature":
        return any(body.temperature is not None for body in (snapshot.lower, snapshot.upper))
    if name == "surface-temperature-maps":
        return has_heat(snapshot)
    if name == "residual-surfaces":
        return any(side.body.has("residual_displacement") for side in sides(snapshot))
    if name == "section":
        return has_section(sides(snapshot))
    return snapshot.in_contact or name not in ("pressure", "gap")
