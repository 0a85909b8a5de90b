# SPDX-License-Identifier: BSD-3-Clause
"""What tests look for in a figure."""

import itertools

import matplotlib
from matplotlib.axes import Axes
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure
from matplotlib.lines import Line2D

from brinell.plot import style


def curve(ax: Axes, label: str) -> Line2D:
    found = [line for line in ax.lines if line.get_label() == label]
    assert len(found) == 1, f"{len(found)} curves {label!r} among {[line.get_label() for line in ax.lines]}"
    return found[0]


def texts(fig: Figure) -> list[str]:
    """All visible text; drawing proves that every formula in it is valid."""
    fig.draw_without_rendering()  # lays out every text; the canvas of a figure without a window draws nothing
    return [t.get_text() for t in fig.findobj(matplotlib.text.Text) if t.get_text() and t.get_visible()]


def legend_of(ax: Axes) -> list[str]:
    legend = ax.get_legend()
    assert legend is not None
    return [text.get_text() for text in legend.get_texts()]


def overlaps(fig: Figure) -> list[tuple[str, str]]:
    """Pairs of visible texts that lie on each other when the figure is drawn."""
    with style.look():
        canvas = FigureCanvasAgg(fig)
        canvas.draw()
        renderer = canvas.get_renderer()
    hidden = set()  # labels of ticks outside the limits, which are made, but not drawn
    for axis in (axis for ax in fig.axes for axis in (ax.xaxis, ax.yaxis)):
        low, high = sorted(axis.get_view_interval())
        reach = 1e-9 * (high - low)
        for tick in axis.get_major_ticks():
            if not low - reach <= tick.get_loc() <= high + reach:
                hidden |= {tick.label1, tick.label2}
    boxes = [
        (text.get_text(), text.get_window_extent(renderer).shrunk(0.95, 0.8))
        for text in fig.findobj(matplotlib.text.Text)
        if text.get_visible() and text.get_text().strip() and text not in hidden
    ]
    return [(a[0], b[0]) for a, b in itertools.combinations(boxes, 2) if a[1].overlaps(b[1]) and a[0] != b[0]]
