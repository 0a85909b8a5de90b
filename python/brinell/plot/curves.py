# SPDX-License-Identifier: BSD-3-Clause
"""A measured stress-strain curve and the hardening curve that it becomes."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from matplotlib.figure import Figure
from matplotlib.ticker import FuncFormatter

from brinell.plot import style
from brinell.plot.scales import si

if TYPE_CHECKING:
    from brinell.materials import MeasuredCurve

__all__ = ["measured_curve"]


@style.figure
def measured_curve(curve: MeasuredCurve, *, ax: style.Target | None = None) -> Figure:
    """The measured points, those that are used, and the hardening curve that they become, over the strain.

    Args:
        curve: what to draw.
        ax: axes to draw into; None: a new figure.
    """
    fig = style.new_figure(5.8, 4.0)
    axes = fig.subplots()
    stress = si(max(np.abs(curve.stress).max(), curve.flow_stress.max()), "Pa")
    sign = -1.0 if curve.stress.sum() < 0.0 else 1.0
    used_strain, used_stress = curve.loading
    for strain, values, look in (
        (
            sign * curve.strain,
            sign * curve.stress,
            {"ls": "", "marker": ".", "ms": 3.0, "color": style.REFERENCE, "label": "as measured", "gid": "measured"},
        ),
        (used_strain, used_stress, {"color": style.LOWER, "lw": 1.0, "label": "used, true values", "gid": "loading"}),
        (
            curve.plastic_strain,
            curve.flow_stress,
            {
                "color": style.UPPER,
                "label": f"over plastic strain, from {style.quantity(curve.yield_stress, 'Pa')}",
                "gid": "hardening",
            },
        ),
    ):
        axes.plot(100.0 * strain, values / stress.size, **look)
    axes.plot(0.0, curve.yield_stress / stress.size, "o", color=style.UPPER, ms=5.0, clip_on=False)
    axes.xaxis.set_major_formatter(FuncFormatter(lambda value, _: style.number(value)))
    axes.set_xlabel("strain  [%]")
    axes.set_ylabel(f"stress  [{stress.unit}]")
    axes.legend(loc="lower right")
    return fig
