# SPDX-License-Identifier: BSD-3-Clause
"""Residual stress and plastic strain over the depth after rolling, of several runs in one figure."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from matplotlib.figure import Figure

from brinell.plot import style
from brinell.plot.overlay import entries, largest, legend_beside, of_runs, zero_line
from brinell.plot.scales import PERCENT, Scale, si
from brinell.plot.where import most_strained
from brinell.results import Run, TrackProfile

__all__ = ["depth_profiles"]


@style.figure
@of_runs
def depth_profiles(runs: Sequence[Run], *, ax: style.Target | None = None) -> Figure | None:
    """Residual stresses xx and yy and equivalent plastic strain over the depth under the middle of the track.

    A body that has not yielded there is drawn under its largest plastic strain, as of a contact that yields at its rim;
    the legend names the place. Returns None if no lower body has yielded.
    """
    shown = [(*_yielded_profile(entry.run), entry) for entry in entries(runs, "rolling")]
    if not any(np.any(profile.equivalent_plastic_strain) for profile, _, _ in shown):
        return None
    depth = si(largest(profile.depth for profile, _, _ in shown), "m")
    stress = si(largest(s for profile, _, _ in shown for s in (profile.residual_xx, profile.residual_yy)), "Pa")
    fig = style.new_figure(11.0, 3.3)
    panels = fig.subplots(1, 3, sharex=True)
    panels[1].sharey(panels[0])
    quantities: tuple[tuple[str, str, str, Scale], ...] = (
        ("residual_xx", "residual stress along the motion", r"\sigma^r_{xx}", stress),
        ("residual_yy", "residual stress across it", r"\sigma^r_{yy}", stress),
        ("equivalent_plastic_strain", "equivalent plastic strain", r"\varepsilon^p_\mathrm{eq}", PERCENT),
    )
    for ax, (name, title, symbol, scale), letter in zip(panels, quantities, "abc", strict=True):
        zero_line(ax)
        for one, _, entry in shown:
            ax.plot(one.depth / depth.size, getattr(one, name) / scale.size, **entry.look, marker="o", markersize=2.5)
        ax.set_title(f"({letter})  {title}")
        ax.set_xlabel(depth.label("depth", "z"))
        ax.set_ylabel(scale.label("", symbol))
    panels[0].set_xlim(left=0.0)
    panels[2].set_ylim(bottom=0.0)
    if len(shown) == 1 and shown[0][1]:
        fig.suptitle(f"Under the largest plastic strain, {shown[0][1]}", fontsize=style.font(10))
    named = [entry.look | {"label": ",  ".join(filter(None, (entry.label, place)))} for _, place, entry in shown]
    legend_beside(panels[2], named)
    return fig


def _yielded_profile(run: Run) -> tuple[TrackProfile, str]:
    """Profile under the middle of the track; of a body that has yielded only elsewhere, there, with the place."""
    profile = run.profile
    if np.any(profile.equivalent_plastic_strain):
        return profile, ""
    body = run.snapshot("final", tensors=True).lower
    if (place := most_strained(body)) is None or not body.stress:
        return profile, ""
    row, column = place
    xx, yy = (np.asarray(body.stress[name][:, row, column]) for name in ("xx", "yy"))
    strain = np.asarray(body.equivalent_plastic_strain[:, row, column])
    where = f"$x$ = {style.length(float(body.x[column]))}, $y$ = {style.length(float(body.y[row]))}"
    return TrackProfile(np.asarray(body.z), xx, yy, strain), where
