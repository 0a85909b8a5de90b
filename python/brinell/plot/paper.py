# SPDX-License-Identifier: BSD-3-Clause
"""Figures 11 to 15 of Boucly, Nelias, Green (2006), Part II, from one run per interference.

Forces are divided by the critical load P_c, lengths across the surface by the equivalent radius R, energies by U_c and
interferences by alpha_c: the values at first yield that each run wrote into its summary. Only the first pass is drawn,
as in the paper. F_X is the resistance to the motion: positive where the drive must push (X < 0), negative where the
asperities repel each other forwards. Dashed lines are elastic spheres, or cylinders in plane strain, with the same
geometry (Hertz). What the paper says of its spheres is drawn beside spheres only.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from matplotlib.ticker import MaxNLocator, PercentFormatter
from numpy.typing import NDArray

from brinell import reference
from brinell.plot import style
from brinell.plot.overlay import of_runs, require_scenario
from brinell.results import History, Run, RunError

__all__ = ["PAPER_LOAD_RATIO", "fig11", "fig12", "fig13", "fig14", "fig15", "overview"]

PAPER_LOAD_RATIO = -0.045
"""F_X/F_Z at the end of the contact that the paper reports, with the sign of F_X used here."""

_PAPER_RESIDUAL_FRACTION = 0.25  # "up to 25 % of the interference"


@dataclass(frozen=True)
class _Curve:
    """One run, ready to draw."""

    run: Run
    history: History  # first pass
    label: str
    colour: str

    @property
    def abscissa(self) -> NDArray[np.float64]:
        return self.history["X"] / self.run.equivalent_radius


def _curves(runs: Sequence[Run]) -> list[_Curve]:
    """Curves sorted by interference, with labels and colours; runs of equal interference are also named by folder."""
    require_scenario(runs, "tugging")
    ordered = sorted(runs, key=lambda run: run.normalised_interference)
    labels = [style.number(run.normalised_interference) for run in ordered]
    labels = [
        f"{label} ({style.as_written(run.path.name)})" if labels.count(label) > 1 else label
        for label, run in zip(labels, ordered, strict=True)
    ]
    colours = style.family_colours(len(ordered))
    curves = [
        _Curve(run, run.history.passes()[0], label, colour)
        for run, label, colour in zip(ordered, labels, colours, strict=True)
    ]
    for curve in curves:
        if curve.history.steps < 2:
            raise RunError(f"{curve.run.path}: fewer than two steps, nothing to draw")
    return curves


def _elastic(curve: _Curve) -> tuple[NDArray[np.float64], NDArray[np.float64], NDArray[np.float64]]:
    """X/R, F_X/P_c and F_Z/P_c of elastic bodies while they touch."""
    run = curve.run
    geometry = (run.lower_radius, run.upper_radius, run.interference)
    reach = reference.elastic_tugging_reach(*geometry)
    X = np.linspace(-reach, reach, 401)
    f_x, f_z = reference.elastic_tugging_forces(X, *geometry, run.critical.interference, reference=run.line_reference)
    return X / run.equivalent_radius, f_x, f_z


def _common(values: Sequence[float], symbol: str, unit: str) -> str:
    """Value of a scale as a note for an axis label; empty if it differs between the runs."""
    texts = {style.quantity(value, unit) for value in values}
    return f"    ({symbol} = {texts.pop()})" if len(texts) == 1 else ""


def _zero_line(ax: Axes, *, vertical: bool = False) -> None:
    line = ax.axvline if vertical else ax.axhline
    line(0.0, color="0.8", linewidth=0.8, zorder=0.5)


def _sliding_axis(ax: Axes, curves: Sequence[_Curve]) -> None:
    note = _common([c.run.equivalent_radius for c in curves], "$R$", "m")
    ax.set_xlabel(f"sliding coordinate  $X/R${note}")
    ax.margins(x=0.02)
    _zero_line(ax, vertical=True)


def _interference_axis(ax: Axes, curves: Sequence[_Curve]) -> None:
    note = _common([c.run.critical.interference for c in curves], r"$\alpha_c$", "m")
    ax.set_xlabel(rf"interference  $\alpha^* = \alpha/\alpha_c${note}")
    largest = max(c.run.normalised_interference for c in curves)
    ax.set_xlim(0.0, 1.05 * largest)
    ax.xaxis.set_major_locator(MaxNLocator(integer=True, nbins=8))


def _family_handles(curves: Sequence[_Curve]) -> list[Line2D]:
    """Entries of the legend, largest interference first, in the order of the curves; then the dashed reference."""
    handles = [Line2D([], [], color=c.colour, marker="o", label=c.label) for c in reversed(curves)]
    handles.append(Line2D([], [], color=style.REFERENCE, linestyle="--", linewidth=0.9, label="elastic (Hertz)"))
    return handles


_FAMILY_TITLE = r"$\alpha^* = \alpha/\alpha_c$"


def _family_legend(ax: Axes, curves: Sequence[_Curve]) -> None:
    """Legend beside the axes."""
    ax.legend(
        handles=_family_handles(curves),
        title=_FAMILY_TITLE,
        alignment="left",
        loc="upper left",
        bbox_to_anchor=(1.02, 1.0),
        borderaxespad=0.0,
    )


def _family_legend_row(ax: Axes, curves: Sequence[_Curve]) -> None:
    """The same legend in one row that fills axes of its own."""
    *family, elastic = _family_handles(curves)
    title = Line2D([], [], linestyle="none", label=f"{_FAMILY_TITLE}:")
    ax.axis("off")
    legend = ax.legend(
        handles=[title, *reversed(family), elastic],
        ncol=len(family) + 2,
        loc="center",
        borderaxespad=0.0,
        fontsize=style.font(10),
    )
    legend.get_texts()[0].set_position((-16.0, 0.0))  # over the place of the handle it does not have


def _draw_force(ax: Axes, curves: Sequence[_Curve], name: str) -> None:
    """F_X or F_Z over P_c against X/R; the elastic curves first, so that they lie below."""
    for curve in curves:
        x, f_x, f_z = _elastic(curve)
        elastic = f_x if name == "F_X" else f_z
        ax.plot(x, elastic, color=curve.colour, linestyle="--", linewidth=0.9, label=f"elastic {curve.label}")
    for curve in curves:
        force = curve.history[name] / curve.run.critical.load
        ax.plot(curve.abscissa, force, color=curve.colour, marker="o", label=curve.label)
    _sliding_axis(ax, curves)


def _draw_fig11(ax: Axes, curves: Sequence[_Curve]) -> None:
    _draw_force(ax, curves, "F_X")
    _zero_line(ax)
    note = _common([c.run.critical.load for c in curves], "$P_c$", "N")
    ax.set_ylabel(f"tangential force  $F_X/P_c${note}")


def _draw_fig12(ax: Axes, curves: Sequence[_Curve]) -> None:
    _draw_force(ax, curves, "F_Z")
    ax.set_ylim(bottom=0.0)
    note = _common([c.run.critical.load for c in curves], "$P_c$", "N")
    ax.set_ylabel(f"normal force  $F_Z/P_c${note}")


def _draw_fig13(ax: Axes, curves: Sequence[_Curve]) -> None:
    alpha = np.array([c.run.normalised_interference for c in curves])
    scale = np.array([c.run.critical.energy for c in curves])
    last = {name: np.array([c.history[name][-1] for c in curves]) for name in _ENERGIES}
    absorbed = last["dissipation_lower"] + last["dissipation_upper"] + last["energy_residual"]
    _zero_line(ax)
    ax.plot(
        alpha,
        last["work"] / scale,
        color=style.LOWER,
        marker="o",
        markersize=5,
        clip_on=False,
        label="net work of $F_X$",
    )
    ax.plot(
        alpha,
        absorbed / scale,
        color=style.UPPER,
        linestyle="none",
        marker="D",
        markersize=8,
        markerfacecolor="none",
        markeredgewidth=1.2,
        label="dissipated + locked in",
    )
    ax.axhline(0.0, color=style.REFERENCE, linestyle="--", linewidth=0.9, label="elastic (Hertz)")
    ax.legend(loc="upper left")
    _interference_axis(ax, curves)
    note = _common(scale.tolist(), "$U_c$", "J")
    ax.set_ylabel(f"net energy  $U/U_c${note}")


_ENERGIES = ("work", "dissipation_lower", "dissipation_upper", "energy_residual")


def _draw_fig14(ax: Axes, curves: Sequence[_Curve]) -> None:
    # The elastic ratio -X/omega is one line: the run with the longest contact shows it all.
    widest = max(curves, key=lambda c: c.run.normalised_interference)
    x, f_x, f_z = _elastic(widest)
    touching = f_z > 0.0
    ax.plot(
        x[touching],
        f_x[touching] / f_z[touching],
        color=style.REFERENCE,
        linestyle="--",
        linewidth=0.9,
        label="elastic",
    )
    for curve in curves:
        history = curve.history
        touching = history.in_contact & (history["F_Z"] > 0.0)
        ratio = np.full(history.steps, np.nan)
        np.divide(history["F_X"], history["F_Z"], out=ratio, where=touching)
        ax.plot(curve.abscissa, ratio, color=curve.colour, marker="o", label=curve.label)
    _zero_line(ax)
    _sliding_axis(ax, curves)
    if _are_spheres(curves):
        _draw_load_ratio_of_paper(ax)
    ax.set_ylabel("load ratio  $F_X/F_Z$")


def _are_spheres(curves: Sequence[_Curve]) -> bool:
    """Whether the bodies are spheres, as in the paper."""
    return all(curve.run.line_reference is None for curve in curves)


def _draw_load_ratio_of_paper(ax: Axes) -> None:
    right = ax.get_xlim()[1]
    ax.plot([0.0, right], [PAPER_LOAD_RATIO] * 2, color=style.REFERENCE, linestyle=":", linewidth=1.2, label="paper")
    ax.annotate(
        f"paper: {style.number(abs(PAPER_LOAD_RATIO))}",
        xy=(0.0, PAPER_LOAD_RATIO),
        xytext=(-4, 0),
        textcoords="offset points",
        ha="right",
        va="center",
        color=style.REFERENCE,
    )
    ax.set_xlim(right=right)


def _residuals(curves: Sequence[_Curve]) -> list[tuple[str, str, str, NDArray[np.float64]]]:
    """Largest residual depth after the pass [m] as (label, colour, marker, values): one entry if the bodies agree."""
    lower = np.array([c.history["max_residual_lower"][-1] for c in curves])
    upper = np.array([c.history["max_residual_upper"][-1] for c in curves])
    if np.allclose(lower, upper, rtol=0.01, atol=0.0):
        return [("each body", style.LOWER, "o", np.maximum(lower, upper))]
    return [("lower body", style.LOWER, "o", lower), ("upper body", style.UPPER, "s", upper)]


def _draw_fig15(ax: Axes, curves: Sequence[_Curve]) -> None:
    alpha = np.array([c.run.normalised_interference for c in curves])
    scale = np.array([c.run.critical.interference for c in curves])
    for label, colour, marker, depth in _residuals(curves):
        ax.plot(alpha, depth / scale, color=colour, marker=marker, markersize=5, clip_on=False, label=label)
    _interference_axis(ax, curves)
    ax.set_ylim(bottom=0.0)
    ax.set_ylabel(r"residual depth  $u^r_{\max}/\alpha_c$")


def _draw_residual_fraction(ax: Axes, curves: Sequence[_Curve]) -> None:
    alpha = np.array([c.run.normalised_interference for c in curves])
    interference = np.array([c.run.interference for c in curves])
    for label, colour, marker, depth in _residuals(curves):
        ax.plot(alpha, depth / interference, color=colour, marker=marker, markersize=5, clip_on=False, label=label)
    if _are_spheres(curves):
        label = "paper: up to 25 %"
        ax.axhline(_PAPER_RESIDUAL_FRACTION, color=style.REFERENCE, linestyle=":", linewidth=1.2, label=label)
    _interference_axis(ax, curves)
    ax.set_ylim(0.0)
    ax.yaxis.set_major_formatter(PercentFormatter(xmax=1.0, decimals=0, symbol=" %"))
    ax.set_ylabel(r"residual depth  $u^r_{\max}/\alpha$")


@style.figure
@of_runs
def fig11(runs: Sequence[Run], *, ax: style.Target | None = None) -> Figure:
    """Tangential force F_X/P_c against X/R, one curve per run."""
    curves = _curves(runs)
    fig = style.new_figure(6.4, 3.9)
    ax = fig.subplots()
    _draw_fig11(ax, curves)
    _family_legend(ax, curves)
    return fig


@style.figure
@of_runs
def fig12(runs: Sequence[Run], *, ax: style.Target | None = None) -> Figure:
    """Normal force F_Z/P_c against X/R, one curve per run."""
    curves = _curves(runs)
    fig = style.new_figure(6.4, 3.9)
    ax = fig.subplots()
    _draw_fig12(ax, curves)
    _family_legend(ax, curves)
    return fig


@style.figure
@of_runs
def fig13(runs: Sequence[Run], *, ax: style.Target | None = None) -> Figure:
    """Net energy over U_c against alpha*, one point per run, and the energy that the bodies store or dissipate.

    Both agree if the energy balance closes.
    """
    curves = _curves(runs)
    fig = style.new_figure(5.2, 3.9)
    _draw_fig13(fig.subplots(), curves)
    return fig


@style.figure
@of_runs
def fig14(runs: Sequence[Run], *, ax: style.Target | None = None) -> Figure:
    """Load ratio F_X/F_Z against X/R where the bodies touch, one curve per run."""
    curves = _curves(runs)
    fig = style.new_figure(6.4, 3.9)
    ax = fig.subplots()
    _draw_fig14(ax, curves)
    _family_legend(ax, curves)
    return fig


@style.figure
@of_runs
def fig15(runs: Sequence[Run], *, ax: style.Target | None = None) -> Figure:
    """Largest residual displacement after unloading against alpha*: over alpha_c, and over the interference."""
    curves = _curves(runs)
    fig = style.new_figure(8.4, 3.7)
    left, right = fig.subplots(1, 2)
    _draw_fig15(left, curves)
    _draw_residual_fraction(right, curves)
    left.legend(loc="upper left")
    right.legend(loc="lower right", bbox_to_anchor=(1.0, 0.05))
    return fig


@style.figure
@of_runs
def overview(runs: Sequence[Run], *, ax: style.Target | None = None) -> Figure:
    """The five figures on one sheet, the second half of Fig. 15 as a panel of its own."""
    curves = _curves(runs)
    fig = style.new_figure(12.0, 6.9)
    grid = fig.add_gridspec(3, 3, height_ratios=[0.05, 1.0, 1.0])
    panels = [fig.add_subplot(grid[row, column]) for row in (1, 2) for column in range(3)]
    draw = {
        "tangential force": _draw_fig11,
        "normal force": _draw_fig12,
        "load ratio": _draw_fig14,
        "net energy": _draw_fig13,
        "residual depth": _draw_fig15,
        "residual depth over interference": _draw_residual_fraction,
    }
    for ax, (title, paint), letter in zip(panels, draw.items(), "abcdef", strict=True):
        paint(ax, curves)
        ax.set_title(f"({letter})  {title}")
    for ax in panels[:3]:
        ax.xaxis.set_major_locator(MaxNLocator(nbins=5, steps=[1, 2, 5, 10]))
    panels[5].legend(loc="lower right", bbox_to_anchor=(1.0, 0.05))
    _family_legend_row(fig.add_subplot(grid[0, :]), curves)
    return fig
