# SPDX-License-Identifier: BSD-3-Clause
"""The pressure of the moving contact as an animation."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from matplotlib.animation import FuncAnimation
from matplotlib.artist import Artist
from matplotlib.colors import Normalize
from numpy.typing import NDArray

from brinell.plot import style
from brinell.plot.cells import extent
from brinell.plot.scales import Scales
from brinell.plot.states import Follow, state_title, stored_in_pass
from brinell.results import Run, RunError, Snapshot

__all__ = ["animate_pressure"]

FloatArray = NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class _Frame:
    """One stored state with the fields that are drawn."""

    title: str
    x: FloatArray
    y: FloatArray
    pressure: FloatArray


def animate_pressure(run: Run, *, pass_: int, follow: Follow, interval: float) -> FuncAnimation:
    """The pressure of the contact from above in the course of a pass, one frame per stored state; see `animate`.

    Raises:
        RunError: fewer than two states of the pass are stored, or nothing touches in any of them.
        InputError: there is no such pass.
    """
    steps = stored_in_pass(run, pass_)
    frames = [_frame(run, run.snapshot(step), follow) for step in steps]
    highest = max(float(frame.pressure.max()) for frame in frames)
    if highest <= 0.0:
        raise RunError(f"{run.path}: nothing touches in the stored states of pass {pass_}")
    scales = Scales(run)
    edges = [extent(frame.x, frame.y, 1.0) for frame in frames]
    left, bottom = min(e[0] for e in edges), min(e[2] for e in edges)
    right, top = max(e[1] for e in edges), max(e[3] for e in edges)
    length, pressure = scales.length(max(abs(left), abs(right), abs(bottom), abs(top))), scales.pressure(highest)
    width = 5.4
    fig = style.new_figure(width + 1.2, min(7.0, width * (top - bottom) / (right - left)) + 1.4, to_scale=True)
    ax = fig.subplots()
    image = ax.imshow(
        frames[0].pressure / pressure.size,
        origin="lower",
        cmap=style.PRESSURE_MAP,
        norm=Normalize(0.0, highest / pressure.size),
        interpolation="nearest",
    )
    ax.set_facecolor(image.cmap(0.0))
    ax.set_aspect("equal")
    ax.set_xlabel(length.label("on the lower body" if follow == "body" else "from the contact's centre", "x"))
    ax.set_ylabel(length.label("", "y", value=False))
    fig.colorbar(image, ax=ax, label=pressure.label("pressure", "p"), pad=0.02)
    title = ax.set_title(max((frame.title for frame in frames), key=len))

    def update(frame: _Frame) -> list[Artist]:
        image.set_data(frame.pressure / pressure.size)
        image.set_extent(extent(frame.x, frame.y, length.size))
        ax.set_xlim(left / length.size, right / length.size)  # which a new extent has moved
        ax.set_ylim(bottom / length.size, top / length.size)
        title.set_text(frame.title)
        return [image, title]

    update(frames[0])
    fig.draw_without_rendering()
    fig.set_layout_engine("none")  # else the axes would move from frame to frame
    return FuncAnimation(fig, update, frames=frames, interval=interval, blit=False, cache_frame_data=False)


def _frame(run: Run, snapshot: Snapshot, follow: Follow) -> _Frame:
    contact, body = snapshot.contact, snapshot.lower
    title = state_title(run, snapshot)
    if follow == "contact":
        return _Frame(title, contact.x, contact.y, contact.pressure)
    x = contact.x + body.contact_x
    goes_round = run.complete and run.case("grid", "boundary") in ("periodic", "periodic_x")
    if goes_round and len(body.x) == len(x) > 1:  # its columns are those of the lower body
        columns = round((x[0] - body.x[0]) / (x[1] - x[0]))
        return _Frame(title, body.x, contact.y, np.roll(contact.pressure, columns, axis=1))
    return _Frame(title, x, contact.y, contact.pressure)
