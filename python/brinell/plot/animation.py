# SPDX-License-Identifier: BSD-3-Clause
"""Animations of one pass, from its stored states."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np
from matplotlib.animation import FFMpegWriter, FuncAnimation, PillowWriter
from matplotlib.artist import Artist

from brinell.errors import InputError
from brinell.plot import style
from brinell.plot.cells import extent
from brinell.plot.cuts import Cut, Panel, Window, contact_on, cut_of, panel_over, window_of
from brinell.plot.planes import Plane, plane_of
from brinell.plot.pressure import animate_pressure
from brinell.plot.quantities import Quantity, needs_tensors, quantity_of
from brinell.plot.scales import Scales
from brinell.plot.sections import across_label, broken_line, draw_contact, draw_panel, upright_axes
from brinell.plot.states import Bodies, Follow, Side, chosen_sides, state_title, stored_in_pass
from brinell.plot.where import cutting_of
from brinell.results import Run, RunError, Snapshot
from brinell.results.snapshots import how_to_store

__all__ = ["ENDINGS", "Follow", "animate", "save_animation", "writer_of"]

ENDINGS = (".gif", ".mp4")
"""Of files that an animation can be saved to."""


@dataclass(frozen=True, eq=False)
class _Frame:
    """One stored state with the fields that are drawn."""

    title: str
    cuts: dict[str, Cut]
    """By name of the body."""
    touched: list[tuple[float, float]]
    """First and last place of each piece of the contact [m]."""
    window: Window


@style.figure
def animate(
    run: Run,
    *,
    field: str = "von_mises_stress",
    plane: Plane | str | tuple[str, float] | None = None,
    pass_: int = 1,
    bodies: Bodies = "both",
    follow: Follow | None = None,
    cells: bool = False,
    interval: float = 120.0,
) -> FuncAnimation:
    """A field on a plane normal to the surface in the course of a pass, one frame per stored state.

    Colours and axes mean the same in all frames.

    Args:
        run: needs at least two stored states in the pass: `[output] snapshots = "all"` of the case stores all.
        field: one of `brinell.plot.QUANTITIES`; or "pressure", which is seen from above: then plane and bodies do not
            count.
        plane: normal to x or y; see `planes.plane_of`. A place along x counts from where `follow` says. None: y = 0, or
            the plane through the largest plastic strain at the end of the pass if little has yielded on y = 0.
        pass_: which pass; counts from 1.
        bodies: "both", "lower" or "upper".
        follow: "contact": x counts from the centre of contact, which stays in the middle; "body", for a single one: x
            is that of the body. By default "contact" for two bodies, and "body" for one. Of the pressure "body" is
            the lower one, over which it travels, round a period if there is one; by default so.
        interval: time per frame [ms].

    Raises:
        RunError: fewer than two states of the pass are stored, or the field is not; the plane lies outside the grids.
        InputError: no such field or plane, or nothing that can be followed.
    """
    if field == "pressure":
        return animate_pressure(run, pass_=pass_, follow=follow or "body", interval=interval)
    given, quantity = None if plane is None else plane_of(plane), quantity_of(field)
    if given is not None and given.axis == "z":
        raise InputError("an animation needs a plane normal to x or y, as in 'y=0'")
    steps = stored_in_pass(run, pass_)
    first = run.snapshot(steps[0])
    sides = chosen_sides(run, first, bodies)
    if all(quantity.values(side.body) is None for side in sides):
        raise RunError(f"{run.path}: {quantity.name} is not stored{how_to_store(quantity.name)}")
    on_body = (follow or ("contact" if len(sides) > 1 else "body")) == "body"
    if on_body and len(sides) > 1:
        raise InputError("follow = 'body' needs a single body: each has a coordinate of its own")
    last = run.snapshot(steps[-1])
    cut = given or cutting_of(last, chosen_sides(run, last, bodies)).plane
    frames = list(_frames(run, steps, bodies, quantity, cut, on_body=on_body))
    panel = _panel(run, frames, quantity)
    return _animation(run, first, frames, panel, cut, on_body=on_body, cells=cells, interval=interval)


def remark_on(run: Run, pass_: int) -> str:
    """Warning for an animation of a pass of which less than half of the steps are stored; otherwise empty."""
    stored = len(stored_in_pass(run, pass_))
    steps = int(np.count_nonzero(run.history["pass"] == pass_))
    if 2 * stored >= steps:
        return ""
    return f'{stored} frames: of {steps} steps only these are stored; [output] snapshots = "all" in the case stores all'


def _frames(
    run: Run, steps: Sequence[int], bodies: Bodies, quantity: Quantity, plane: Plane, *, on_body: bool
) -> Iterator[_Frame]:
    """Reads the states one after the other, so that the fields of only one are in memory."""
    for step in steps:
        snapshot = run.snapshot(step, tensors=needs_tensors([quantity]))
        sides = chosen_sides(run, snapshot, bodies)
        yield _frame(run, snapshot, sides, quantity, plane, on_body=on_body)


def _frame(
    run: Run, snapshot: Snapshot, sides: Sequence[Side], quantity: Quantity, plane: Plane, *, on_body: bool
) -> _Frame:
    def origin(side: Side) -> float:
        return 0.0 if on_body else side.body.contact_x

    found = [cut_of(side, quantity, plane, origin) for side in sides]
    shift = sides[0].body.contact_x if on_body else 0.0  # of the contact's frame
    seen = replace(plane, value=plane.value - shift) if plane.axis == "x" else plane
    window = window_of(snapshot, sides, seen, lambda side: side.body.contact_x)
    touched = contact_on(snapshot.contact, seen) if snapshot.in_contact else []
    if plane.axis == "y":
        window = replace(window, across=(window.across[0] + shift, window.across[1] + shift))
        touched = [(start + shift, end + shift) for start, end in touched]
    cuts = {cut.side.name: cut for cut in found if cut is not None}
    return _Frame(state_title(run, snapshot), cuts, touched, window)


def _panel(run: Run, frames: Sequence[_Frame], quantity: Quantity) -> Panel:
    """Panel of the first frame with a colour range for all frames, of the bodies that all frames show."""
    names = [name for name in frames[0].cuts if all(name in frame.cuts for frame in frames)]
    if not names:
        raise RunError(f"{run.path}: {quantity.name} is not stored, or the plane lies outside the grids")
    every = [frame.cuts[name].values for frame in frames for name in names]
    lowest, highest = min(float(v.min()) for v in every), max(float(v.max()) for v in every)
    cuts = [frames[0].cuts[name] for name in names]
    return panel_over(Scales(run), quantity, quantity.title, cuts, lowest, highest)


def _animation(
    run: Run,
    first: Snapshot,
    frames: Sequence[_Frame],
    panel: Panel,
    plane: Plane,
    *,
    on_body: bool,
    cells: bool,
    interval: float,
) -> FuncAnimation:
    window = _common(frame.window for frame in frames)
    length = Scales(run).length(float(np.max(np.abs(window.across))))
    width = 6.0
    fig = style.new_figure(width + 1.6, width * window.shape + 2.0, to_scale=True)
    ax = fig.subplots()
    images = draw_panel(ax, panel, window, length.size, "nearest" if cells else "bilinear")
    upright_axes(ax, first, panel, window, length.size)
    contact = draw_contact(ax, first.contact, plane, length.size)
    ax.set_xlabel(across_label(length, plane, from_contact=not on_body, bodies=len(panel.cuts)))
    ax.set_ylabel(length.label("depth", "z", value=False))
    title = fig.suptitle(" ", fontsize=style.font(10))
    place = plane.label(from_contact=plane.axis == "x" and not on_body)

    def update(frame: _Frame) -> list[Artist]:
        for image, cut in zip(images, panel.cuts, strict=True):
            now = frame.cuts[cut.side.name]
            image.set_data(now.values / panel.unit)
            image.set_extent(extent(now.across, now.upward, length.size))
        ax.set_xlim(*(edge / length.size for edge in window.across))  # which a new extent has moved
        ax.set_ylim(*(edge / length.size for edge in window.upward))
        contact.set_data(*broken_line(frame.touched, length.size))
        title.set_text(f"Plane {place}:  {frame.title}")
        return [*images, contact, title]

    update(max(frames, key=lambda frame: len(frame.title)))
    fig.draw_without_rendering()
    fig.set_layout_engine("none")  # else the axes would move from frame to frame
    return FuncAnimation(fig, update, frames=frames, interval=interval, blit=False, cache_frame_data=False)


def _common(windows: Iterator[Window]) -> Window:
    """The smallest window that contains all windows."""
    across, upward = (np.array(edges) for edges in zip(*((w.across, w.upward) for w in windows), strict=True))
    return Window(
        (float(across[:, 0].min()), float(across[:, 1].max())), (float(upward[:, 0].min()), float(upward[:, 1].max()))
    )


def writer_of(path: Path) -> type[FFMpegWriter] | type[PillowWriter]:
    """The writer of files with this ending. To be called before an animation is drawn, because drawing takes long.

    Raises:
        InputError: no animation is saved with this ending, or its program is not installed.
    """
    if path.suffix not in ENDINGS:
        raise InputError(f"{path}: an animation is saved as {' or '.join(ENDINGS)}")
    if path.suffix == ".mp4" and not FFMpegWriter.isAvailable():
        raise InputError(f"{path}: .mp4 needs the program ffmpeg, which is not installed; .gif works without it")
    return FFMpegWriter if path.suffix == ".mp4" else PillowWriter


def save_animation(animation: FuncAnimation, path: str | Path, *, frames_per_second: int = 8) -> Path:
    """Writes an animation as GIF (by Pillow) or MP4 (by ffmpeg).

    Args:
        animation: what `animate` returns.
        path: ends with .gif or .mp4; its folder is made if it is not there.
        frames_per_second: speed.

    Returns:
        The path.

    Raises:
        InputError: another ending, or there is no ffmpeg for an MP4.
    """
    path = Path(path)
    writer = writer_of(path)
    path.parent.mkdir(parents=True, exist_ok=True)
    with style.look():
        animation.save(path, writer=writer(fps=frames_per_second), dpi=110)
    return path
