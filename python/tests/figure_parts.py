# SPDX-License-Identifier: BSD-3-Clause
"""What tests look for in a figure."""

import matplotlib
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.lines import Line2D


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
