# SPDX-License-Identifier: BSD-3-Clause
"""Pictures of one state: contact pressure, residual surfaces, stress and plastic strain under the contact."""

from __future__ import annotations

from collections.abc import Callable, Sequence

import numpy as np
from matplotlib.axes import Axes
from matplotlib.cm import ScalarMappable
from matplotlib.colors import Normalize, TwoSlopeNorm
from matplotlib.figure import Figure
from matplotlib.image import AxesImage
from matplotlib.patheffects import withStroke
from matplotlib.ticker import FuncFormatter, MaxNLocator
from numpy.typing import NDArray

from brinell.plot import style
from brinell.plot.scales import Scales
from brinell.results import BodyFields, ContactFields, Run, RunError, Snapshot

__all__ = ["FIGURES", "contact_edge", "pressure_map", "residual_surfaces", "section"]

FloatArray = NDArray[np.float64]


def contact_edge(contact: ContactFields) -> FloatArray:
    """A function whose zero line is the edge of contact, positive inside [-], array [y][x].

    Near the edge the pressure grows with the square root of the distance and the gap with its power 3/2, so that p^2
    and gap^(2/3) are linear there and linear interpolation finds the edge within a fraction of a cell.
    """
    touching = contact.pressure > 0.0
    if not np.any(touching):
        return np.full_like(contact.pressure, -1.0)
    inside = np.where(touching, contact.pressure / contact.pressure.max(), 0.0) ** 2
    outside = np.where(touching, 0.0, np.clip(contact.gap, 0.0, None)) ** (2.0 / 3.0)
    # Equal slopes on both sides: compare the first cells beyond the edge with the last ones before it.
    rim = np.zeros_like(touching)
    rim[:, 1:] |= touching[:, 1:] != touching[:, :-1]
    rim[:, :-1] |= touching[:, 1:] != touching[:, :-1]
    rim[1:, :] |= touching[1:, :] != touching[:-1, :]
    rim[:-1, :] |= touching[1:, :] != touching[:-1, :]
    first, last = outside[rim & ~touching], inside[rim & touching]
    slope = float(last.mean() / first.mean()) if first.size and first.mean() > 0.0 else 1.0
    return inside - slope * outside


def _refined(values: FloatArray, factor: int) -> FloatArray:
    """Cell values [y][x], linear between centres, on cells `factor` times smaller; constant beyond the rim."""

    def along(array: FloatArray, count: int) -> FloatArray:  # last axis
        position = np.clip((np.arange(count * factor) + 0.5) / factor - 0.5, 0.0, count - 1.0)
        left = np.minimum(position.astype(int), max(count - 2, 0))
        t = position - left
        right = np.minimum(left + 1, count - 1)
        mixed: FloatArray = array[..., left] * (1.0 - t) + array[..., right] * t
        return mixed

    ny, nx = values.shape
    return np.ascontiguousarray(along(along(values, nx).T, ny).T)


def _extent(x: FloatArray, y: FloatArray, scale: float) -> tuple[float, float, float, float]:
    """Outer cell edges for imshow, over the scale."""
    half_x = 0.5 * (x[1] - x[0]) if len(x) > 1 else 0.5
    half_y = 0.5 * (y[1] - y[0]) if len(y) > 1 else 0.5
    return (
        float(x[0] - half_x) / scale,
        float(x[-1] + half_x) / scale,
        float(y[0] - half_y) / scale,
        float(y[-1] + half_y) / scale,
    )


def _image(
    ax: Axes,
    x: FloatArray,
    y: FloatArray,
    values: FloatArray,
    scale: float,
    *,
    cmap: str,
    norm: Normalize,
    interpolation: str,
) -> AxesImage:
    """Cell values on a regular grid, to scale; `y` may run down (depth)."""
    return ax.imshow(
        values,
        origin="lower",
        extent=_extent(x, y, scale),
        aspect="equal",
        cmap=cmap,
        norm=norm,
        interpolation=interpolation,
        interpolation_stage="data",
    )


def _state(run: Run, snapshot: Snapshot) -> str:
    """One line that says which state is drawn."""
    scales = Scales(run)
    position = scales.radius(abs(snapshot.X) or 1.0)
    parts = ["final state" if snapshot.is_final else f"step {snapshot.step}"]
    if scales.normalised:
        parts.append(rf"$\alpha^*$ = {style.number(run.normalised_interference)}")
    if position.symbol:
        parts.append(f"$X/{position.symbol}$ = {style.number(snapshot.X / position.size)}")
    else:
        parts.append(f"$X$ = {style.quantity(snapshot.X, 'm') if snapshot.X else 0}")
    return ",  ".join(parts)


def _at_centre(y: FloatArray, values: FloatArray) -> FloatArray:
    """Values on the plane y = 0 of an array [..., y, x]: one row of cells, or the mean of the two beside the plane."""
    distance = np.abs(y)
    rows = np.flatnonzero(np.isclose(distance, distance.min(), rtol=0.0, atol=1e-6 * (abs(y[-1] - y[0]) + 1e-30)))
    return np.asarray(values[..., rows, :].mean(axis=-2), dtype=np.float64)


def _crop(ax: Axes, x: tuple[float, float], y: tuple[float, float]) -> None:
    ax.set_xlim(*x)
    ax.set_ylim(*y)


@style.figure
def pressure_map(run: Run, snapshot: Snapshot, *, cells: bool = False) -> Figure:
    """Contact pressure over p0_c in the plane of contact, with the edge of contact.

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

    columns, rows = np.any(contact.pressure > 0.0, axis=0), np.any(contact.pressure > 0.0, axis=1)
    reach_x = 1.25 * np.abs(contact.x[columns]).max() + contact.x[1] - contact.x[0]
    reach_y = 1.25 * np.abs(contact.y[rows]).max() + contact.y[1] - contact.y[0]
    left, right, bottom, top = _extent(contact.x, contact.y, length.size)
    x_range = (max(left, -reach_x / length.size), min(right, reach_x / length.size))
    y_range = (max(bottom, -reach_y / length.size), min(top, reach_y / length.size))

    # Between the cells it is p^2 that is interpolated: linear up to the edge, where p itself rises like a square root.
    edge = contact_edge(contact)
    factor = max(2, 800 // min(contact.pressure.shape))
    shown = contact.pressure if cells else contact.pressure.max() * np.sqrt(np.clip(_refined(edge, factor), 0.0, None))
    fig = style.new_figure(5.4, 4.3, to_scale=True)
    ax = fig.subplots()
    image = ax.imshow(
        np.ma.masked_less_equal(shown, 0.0) / pressure.size if cells else shown / pressure.size,
        origin="lower",
        extent=(left, right, bottom, top),
        cmap=style.PRESSURE_MAP,
        norm=Normalize(0.0, contact.pressure.max() / pressure.size),
        interpolation="nearest",
    )
    if not cells:  # even the refined cells show as steps: cut them along the edge
        place = (contact.x / length.size, contact.y / length.size, edge)
        ax.contourf(*place, levels=[edge.min() - 1.0, 0.0], colors="white")
        ax.contour(*place, levels=[0.0], colors=style.CONTACT_LINE, linewidths=1.0)
    _crop(ax, x_range, y_range)
    ax.set_xlabel(length.label("along the motion", "x'"))
    ax.set_ylabel(length.label("across", "y'", value=False))
    ax.set_title(f"Contact pressure:  {_state(run, snapshot)}")
    fig.colorbar(image, ax=ax, label=pressure.label("", "p"), pad=0.02)
    return fig


def _height(body: BodyFields) -> FloatArray:
    """Residual displacement seen from outside: pile-up positive, depth negative [m]."""
    return -body.residual_displacement


@style.figure
def residual_surfaces(run: Run, snapshot: Snapshot, *, cells: bool = False) -> Figure:
    """Permanent shape of both surfaces along the track: profile on y = 0, and both maps.

    Heights are out of each body: pile-up positive, the groove negative. Coordinates are those of each body, x = 0 where
    it is touched at alignment.

    Args:
        run: where the scales come from.
        snapshot: the state to draw.
        cells: show each cell as a rectangle of one colour instead of interpolating between their centres.
    """
    scales = Scales(run)
    bodies = (
        ("lower body", snapshot.lower, style.LOWER, "-"),
        ("upper body", snapshot.upper, style.UPPER, (0, (4, 2))),
    )
    heights = [_height(body) for _, body, _, _ in bodies]
    lowest = min(min(float(h.min()) for h in heights), 0.0)
    highest = max(max(float(h.max()) for h in heights), 0.0)
    depth = scales.displacement(max(-lowest, highest))
    length = scales.length(max(float(np.abs(body.x).max()) for _, body, _, _ in bodies))

    # Where something happened on either body, with some margin.
    threshold = 0.01 * max(-lowest, highest)
    x_range, y_range = _active_range(bodies, heights, threshold, length.size)

    width = 8.0
    map_height = (width - 1.9) * (y_range[1] - y_range[0]) / (x_range[1] - x_range[0])
    fig = style.new_figure(width, 2.7 + 2.0 * map_height + 1.1, to_scale=True)
    axes = fig.subplots(3, 1, sharex=True, gridspec_kw={"height_ratios": [2.3, map_height, map_height]})

    profile = axes[0]
    profile.axhline(0.0, color="0.8", linewidth=0.8, zorder=0.5)
    for (name, body, colour, dash), height in zip(bodies, heights, strict=True):
        line = _at_centre(body.y, height) / depth.size
        profile.plot(body.x / length.size, line, color=colour, linestyle=dash, label=name)
    profile.set_ylabel(depth.label("height", "-u^r", value=False))
    profile.set_title(f"Residual surfaces:  {_state(run, snapshot)}")
    profile.legend(loc="lower right", bbox_to_anchor=(1.0, 1.0), borderaxespad=0.2, ncol=2)
    profile.margins(y=0.08)

    # The pile-up is much lower than the groove is deep: each side of zero gets its own half of the colours.
    norm: Normalize = Normalize(-1.0, 1.0)
    if lowest < 0.0 or highest > 0.0:
        small = 1e-3 * max(-lowest, highest)
        norm = TwoSlopeNorm(0.0, min(lowest, -small) / depth.size, max(highest, small) / depth.size)
    for ax, (name, body, _, _), height in zip(axes[1:], bodies, heights, strict=True):
        image = _image(
            ax,
            body.x,
            body.y,
            height / depth.size,
            length.size,
            cmap=style.RESIDUAL_MAP,
            norm=norm,
            interpolation="nearest" if cells else "catrom",  # a smooth surface: cubic, through the cell values
        )
        _crop(ax, x_range, y_range)
        ax.set_ylabel(length.label("", "y", value=False))
        ax.text(0.01, 0.95, name, transform=ax.transAxes, ha="left", va="top")
    axes[-1].set_xlabel(length.label("along the surface", "x"))
    bar = fig.colorbar(image, ax=axes[1:], label=depth.label("height", "-u^r"), pad=0.02)
    bar.ax.set_yscale("linear")
    return fig


def _active_range(
    bodies: Sequence[tuple[str, BodyFields, str, object]],
    heights: Sequence[FloatArray],
    threshold: float,
    scale: float,
) -> tuple[tuple[float, float], tuple[float, float]]:
    """Ranges of x and y in which either surface has moved, over the scale, symmetric in y, within the grids."""
    extents = [_extent(body.x, body.y, scale) for _, body, _, _ in bodies]
    x_low, x_high, y_reach = np.inf, -np.inf, 0.0
    for (_, body, _, _), height, extent in zip(bodies, heights, extents, strict=True):
        moved = np.abs(height) > threshold
        if threshold <= 0.0 or not np.any(moved):
            continue
        xs, ys = body.x[np.any(moved, axis=0)] / scale, body.y[np.any(moved, axis=1)] / scale
        margin = 0.08 * (xs.max() - xs.min())
        x_low, x_high = min(x_low, max(extent[0], xs.min() - margin)), max(x_high, min(extent[1], xs.max() + margin))
        y_reach = max(y_reach, min(max(-extent[2], extent[3]), 1.15 * np.abs(ys).max()))
    if y_reach == 0.0:  # nothing has moved, or a single row of cells
        x_low, x_high = min(e[0] for e in extents), max(e[1] for e in extents)
        y_reach = max(max(-e[2], e[3]) for e in extents)
    return (float(x_low), float(x_high)), (-float(y_reach), float(y_reach))


@style.figure
def section(run: Run, snapshot: Snapshot, *, cells: bool = False) -> Figure:
    """Von Mises stress over S_y and equivalent plastic strain of both bodies on the plane y = 0.

    The lower body lies below, the upper one is mirrored above it; they share the line of contact. Depth and length have
    the same scale. While the bodies touch, x' is measured from the centre of contact; afterwards each body keeps its
    own coordinate, x = 0 where it is touched at alignment.

    Args:
        run: where the scales come from.
        snapshot: the state to draw.
        cells: show each cell as a rectangle of one colour instead of interpolating between their centres.
    """
    scales = Scales(run)
    touching = snapshot.in_contact
    bodies = (snapshot.lower, snapshot.upper)
    stresses = [body.von_mises_stress for body in bodies]
    largest_stress = max((float(s.max()) for s in stresses if s is not None), default=0.0)
    largest_strain = max((float(b.equivalent_plastic_strain.max()) for b in bodies), default=0.0)
    stress = scales.stress(largest_stress)
    length = scales.length(max(float(np.abs(body.x).max()) for body in bodies))

    panels: list[tuple[str, str, list[FloatArray | None], str]] = []
    if largest_stress > 0.0:
        over = [s / stress.size if s is not None else None for s in stresses]
        panels.append(("Von Mises stress", stress.label("", r"\sigma_\mathrm{vM}"), list(over), style.STRESS_MAP))
    if largest_strain > 0.0 or not panels:
        percent: list[FloatArray | None] = [100.0 * b.equivalent_plastic_strain for b in bodies]
        panels.append(("Equivalent plastic strain", r"$\varepsilon^p_\mathrm{eq}$  [%]", percent, style.STRAIN_MAP))

    offsets = [body.contact_x if touching else 0.0 for body in bodies]
    x_range, depth = _section_range(snapshot, offsets)
    x_range = (x_range[0] / length.size, x_range[1] / length.size)
    depth /= length.size

    # Flat panels one above the other, tall ones side by side.
    shape = 2.0 * depth / (x_range[1] - x_range[0])
    stacked = shape < 0.7
    rows, columns = (len(panels), 1) if stacked else (1, len(panels))
    panel_width = 5.5 if stacked else 4.0
    fig = style.new_figure(columns * (panel_width + 1.1) + 0.8, rows * (panel_width * shape + 0.4) + 0.8, to_scale=True)
    axes = np.atleast_1d(fig.subplots(rows, columns, sharex=True, sharey=True))
    outline = withStroke(linewidth=1.6, foreground="black", alpha=0.6)
    for ax, (name, label, values, cmap) in zip(axes, panels, strict=True):
        planes = [
            _at_centre(body.y, value) if value is not None and value.size else None
            for body, value in zip(bodies, values, strict=True)
        ]
        top = max(float(p.max()) for p in planes if p is not None)
        norm = Normalize(0.0, top if top > 0.0 else 1.0)
        image = None
        for body, offset, plane, side in zip(bodies, offsets, planes, (-1.0, 1.0), strict=True):
            if plane is not None:
                shown = _image(
                    ax,
                    body.x - offset,
                    side * body.z,
                    plane,
                    length.size,
                    cmap=cmap,
                    norm=norm,
                    interpolation="nearest" if cells else "bilinear",
                )
                image = image or shown
        ax.set_facecolor("0.93")
        ax.axhline(0.0, color="white", linewidth=0.8)
        if touching:
            start, end = _contact_span(snapshot)
            ax.plot(
                [start / length.size, end / length.size],
                [0.0, 0.0],
                color="white",
                linewidth=2.6,
                solid_capstyle="butt",
                label="contact",
            )
        _crop(ax, x_range, (-depth, depth))
        ax.yaxis.set_major_locator(MaxNLocator(nbins=6, steps=[1, 2, 5, 10]))
        ax.yaxis.set_major_formatter(FuncFormatter(lambda value, _: f"{abs(value):g}"))
        ax.set_title(name)
        for text, height, anchor in (("upper body", 0.96, "top"), ("lower body", 0.04, "bottom")):
            ax.text(0.015, height, text, transform=ax.transAxes, color="white", va=anchor, path_effects=[outline])
        if image is not None:
            fig.colorbar(ScalarMappable(norm, cmap), ax=ax, label=label, pad=0.02)
    along = length.label("from the centre of contact", "x'") if touching else length.label("along each surface", "x")
    for ax in axes if not stacked else axes[-1:]:
        ax.set_xlabel(along)
    for ax in axes if stacked else axes[:1]:
        ax.set_ylabel(length.label("depth", "z", value=False))
    fig.suptitle(f"Plane $y$ = 0:  {_state(run, snapshot)}", fontsize=10)
    return fig


def _contact_span(snapshot: Snapshot) -> tuple[float, float]:
    """Where the contact begins and ends on y = 0, x' [m]."""
    contact = snapshot.contact
    edge = _at_centre(contact.y, contact_edge(contact))
    inside = np.flatnonzero(edge > 0.0)
    if inside.size == 0:
        return 0.0, 0.0

    def crossing(i: int, j: int) -> float:
        if not 0 <= j < len(edge):
            return float(contact.x[i])
        t = edge[i] / (edge[i] - edge[j])
        return float(contact.x[i] + t * (contact.x[j] - contact.x[i]))

    first, last = int(inside[0]), int(inside[-1])
    return crossing(first, first - 1), crossing(last, last + 1)


def _section_range(snapshot: Snapshot, offsets: Sequence[float]) -> tuple[tuple[float, float], float]:
    """Part of the plane worth drawing [m]: around the contact, or all that has yielded; and how deep."""
    bodies = (snapshot.lower, snapshot.upper)
    low, high, deep = np.inf, -np.inf, 0.0
    if snapshot.in_contact:
        start, end = _contact_span(snapshot)
        centre, reach = 0.5 * (start + end), 0.5 * (end - start)
        low, high, deep = centre - 2.0 * reach, centre + 2.0 * reach, 1.2 * reach
    for body, offset in zip(bodies, offsets, strict=True):
        strain = body.equivalent_plastic_strain
        if strain.size == 0 or strain.max() <= 0.0:
            continue
        plastic = _at_centre(body.y, strain) > 1e-2 * strain.max()
        if not snapshot.in_contact and np.any(plastic):
            xs = body.x[np.any(plastic, axis=0)] - offset
            margin = 0.1 * float(xs.max() - xs.min())
            low, high = min(low, float(xs.min()) - margin), max(high, float(xs.max()) + margin)
        if np.any(plastic):
            deep = max(deep, 1.15 * float(body.z[np.any(plastic, axis=1)].max()))
    full = [_extent(body.x - offset, body.z, 1.0) for body, offset in zip(bodies, offsets, strict=True)]
    left, right, bottom = min(e[0] for e in full), max(e[1] for e in full), max(e[3] for e in full)
    if not np.isfinite(low):
        return (left, right), bottom
    return (max(left, low), min(right, high)), min(bottom, deep) if deep > 0.0 else bottom


FIGURES: dict[str, Callable[..., Figure]] = {
    "pressure": pressure_map,
    "residual-surfaces": residual_surfaces,
    "section": section,
}
"""What the command `fields` writes: end of the file name and function."""
