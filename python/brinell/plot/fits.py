# SPDX-License-Identifier: BSD-3-Clause
"""A fit: each curve with its residuals, the unknowns two by two, profiles over the depth."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from brinell._toml import tomllib
from brinell.errors import InputError
from brinell.plot import style
from brinell.plot.scales import Scale, si

if TYPE_CHECKING:
    from brinell.fits import Curve, Estimate, Fit

__all__ = ["all_figures", "fit_corner", "fit_curve", "fit_depth_profile", "fit_profiles"]

_AXES = {"load-depth": ("depth", "load"), "imprint": ("x", "height")}
_PROFILES = ("yield_profile.factor", "initial_stress.value")


def all_figures(fit: Fit) -> dict[str, Figure]:
    """All figures of a fit by name."""
    figures = {
        f"curve-{i + 1}" if len(fit.curves) > 1 else "curve": fit_curve(fit, one.data.name)
        for i, one in enumerate(fit.curves)
        if one.data.kind != "number"
    }
    if sum(one.determined for one in fit.estimates) > 1:
        figures["corner"] = fit_corner(fit)
    if any(one.profile[0] for one in fit.estimates):
        figures["profiles"] = fit_profiles(fit)
    if any(kind in one.key for one in fit.estimates for kind in _PROFILES):
        figures["depth-profile"] = fit_depth_profile(fit)
    return figures


@style.figure
def fit_curve(fit: Fit, name: str | None = None, *, ax: style.Target | None = None) -> Figure:
    """Measured points and the fitted curve; below, the residuals in standard deviations.

    Args:
        fit: a fit.
        name: name of the data; None: the first ones.
        ax: two axes of the caller, or a figure, to draw into; None: a new figure.

    Raises:
        InputError: there are no such data.
    """
    curve = next((one for one in fit.curves if name in (None, one.data.name)), None)
    if curve is None:
        raise InputError(f"no data {name!r}; allowed: {', '.join(one.data.name for one in fit.curves)}")
    fig = style.new_figure(5.8, 5.0)
    upper, lower = fig.subplots(2, 1, sharex=True, height_ratios=(3.0, 1.0))
    x, y = _scales(curve)
    upper.plot(
        *(curve.data.x / x.size, curve.data.y / y.size, "."),
        color=style.REFERENCE,
        ms=4.0,
        label="measured",
        gid="measured",
    )
    for i, (at, values) in enumerate(curve.line):
        upper.plot(at / x.size, values / y.size, color=style.LOWER, label="fitted" if i == 0 else None, gid="fitted")
    names = _AXES.get(curve.data.kind, tuple(curve.data.columns))
    upper.set_ylabel(_label(names[1], y))
    upper.legend(loc="best")
    if len(fit.curves) > 1:
        upper.set_title(style.as_written(curve.data.name))
    lower.axhspan(-2.0, 2.0, color="#eeeeee", lw=0.0)
    lower.axhline(0.0, color=style.REFERENCE, lw=0.8)
    lower.plot(curve.data.x / x.size, curve.residuals, ".", color=style.LOWER, ms=3.5, gid="residuals")
    lower.set_xlabel(_label(names[0], x))
    lower.set_ylabel("residual  [σ]")
    most = max(3.0, 1.1 * float(np.abs(curve.residuals).max()))
    lower.set_ylim(-most, most)
    return fig


def _scales(curve: Curve) -> tuple[Scale, Scale]:
    units = curve.data.units
    x, y = (
        si(max(float(np.abs(values).max()), 1e-300), unit) if unit in ("m", "N", "Pa", "J") else Scale(1.0, "", unit)
        for values, unit in zip((curve.data.x, curve.data.y), units, strict=True)
    )
    return x, y


def _label(name: str, scale: Scale) -> str:
    return f"{style.as_written(name).replace('_', ' ')}{f'  [{scale.unit}]' if scale.unit else ''}"


@style.figure
def fit_corner(fit: Fit, *, ax: style.Target | None = None) -> Figure:
    """The unknowns two by two: ellipse of the joint interval by scatter, and on the diagonal each with its intervals.

    Args:
        fit: a fit; unknowns that the data do not determine are left out.
        ax: axes of the caller, row by row, or a figure, to draw into; None: a new figure.

    Raises:
        InputError: no unknown is determined.
    """
    shown = [i for i, one in enumerate(fit.estimates) if one.determined]
    if not shown:
        raise InputError("the data determine no unknown: there is nothing to draw")
    count = len(shown)
    fig = style.new_figure(1.9 * count + 1.0, 1.9 * count + 0.6)
    grid = np.atleast_2d(fig.subplots(count, count, squeeze=False))
    for row, i in enumerate(shown):
        for column, j in enumerate(shown):
            axes = grid[row, column]
            if column > row:
                axes.set_axis_off()
                continue
            if i == j:
                _one(axes, fit.estimates[i])
            else:
                _two(axes, fit, i, j)
            _outer_labels(axes, fit, i, j, row == count - 1, column == 0 and row > 0)
    return fig


def _scale(one: Estimate) -> Scale:
    return (
        si(max(abs(one.low), abs(one.high), 1e-300), one.unit) if one.unit in ("Pa", "m") else Scale(1.0, "", one.unit)
    )


def _limits(one: Estimate) -> tuple[float, float]:
    """A range with the whole interval and the scatter."""
    low, high = min(one.low, one.data_low), max(one.high, one.data_high)
    width = max(high - low, 1e-6 * max(abs(one.value), 1e-300))
    size = _scale(one).size
    return (low - 0.25 * width) / size, (high + 0.25 * width) / size


def _one(axes: Axes, one: Estimate) -> None:
    size = _scale(one).size
    axes.axvspan(one.low / size, one.high / size, color="#cfe3f3", lw=0.0)
    axes.axvspan(one.data_low / size, one.data_high / size, color="#8fbfe0", lw=0.0)
    axes.axvline(one.value / size, color=style.LOWER)
    axes.set_yticks([])
    axes.set_xlim(*_limits(one))


def _two(axes: Axes, fit: Fit, i: int, j: int) -> None:
    """Row i, column j: ellipse that holds both with the probability of the intervals, by scatter."""
    x, y = fit.estimates[j], fit.estimates[i]
    sizes = _scale(x).size, _scale(y).size
    half = np.array([(x.data_high - x.data_low) / sizes[0], (y.data_high - y.data_low) / sizes[1]]) / 2.0
    wider = np.sqrt(-2.0 * np.log(1.0 - fit.confidence)) / 1.96
    correlation = float(np.clip(fit.correlation[i, j], -1.0, 1.0))
    turn = np.linspace(0.0, 2.0 * np.pi, 200)
    outline = np.stack(
        [np.cos(turn), correlation * np.cos(turn) + np.sqrt(1.0 - correlation**2) * np.sin(turn)], axis=1
    )
    outline *= wider * half
    axes.fill(
        x.value / sizes[0] + outline[:, 0], y.value / sizes[1] + outline[:, 1], color="#8fbfe0", ec=style.LOWER, lw=1.0
    )
    axes.plot(x.value / sizes[0], y.value / sizes[1], ".", color=style.LOWER)
    axes.text(0.95, 0.95, style.number(correlation, 2), transform=axes.transAxes, ha="right", va="top", fontsize=8)
    axes.set_xlim(*_limits(x))
    axes.set_ylim(*_limits(y))


def _outer_labels(axes: Axes, fit: Fit, i: int, j: int, bottom: bool, left: bool) -> None:
    axes.tick_params(labelbottom=bottom, labelleft=left)
    axes.locator_params(axis="x", nbins=3)
    if bottom:
        axes.set_xlabel(_label(fit.estimates[j].name, _scale(fit.estimates[j])))
    if left:
        axes.set_ylabel(_label(fit.estimates[i].name, _scale(fit.estimates[i])))


@style.figure
def fit_profiles(fit: Fit, *, ax: style.Target | None = None) -> Figure:
    """Distance of the best fit with one unknown held, for each unknown whose profile was computed.

    Args:
        fit: a fit.
        ax: axes of the caller, one per profile, or a figure, to draw into; None: a new figure.

    Raises:
        InputError: no profile was computed.
    """
    shown = [one for one in fit.estimates if one.profile[0]]
    if not shown:
        raise InputError("the fit has no profiles; allowed: fit(..., profiles=True)")
    fig = style.new_figure(3.2 * len(shown), 2.8)
    for axes, one in zip(np.ravel(fig.subplots(1, len(shown), squeeze=False)), shown, strict=True):
        scale = _scale(one)
        axes.plot(np.array(one.profile[0]) / scale.size, np.abs(one.profile[1]), ".-", color=style.LOWER)
        axes.axhline(1.96, color=style.REFERENCE, lw=0.8)
        axes.axvspan(one.data_low / scale.size, one.data_high / scale.size, color="#cfe3f3", lw=0.0)
        axes.set_xlabel(_label(one.name, scale))
        axes.set_ylim(bottom=0.0)
    fig.axes[0].set_ylabel("distance  [σ]")
    return fig


@style.figure
def fit_depth_profile(fit: Fit, *, ax: style.Target | None = None) -> Figure:
    """Fitted points of a profile over the depth (yield stress, initial stress), with their intervals.

    Args:
        fit: a fit.
        ax: axes of the caller, one per profile, or a figure, to draw into; None: a new figure.

    Raises:
        InputError: no unknown is a point of a profile.
    """
    parts = sorted({one.key.rpartition(".")[0] for one in fit.estimates if any(kind in one.key for kind in _PROFILES)})
    if not parts:
        raise InputError("no unknown is a point of a profile over the depth")
    fig = style.new_figure(3.6 * len(parts), 3.6)
    table = tomllib.loads(fit.case.to_toml())
    for axes, part in zip(np.ravel(fig.subplots(1, len(parts), squeeze=False)), parts, strict=True):
        entry = table
        for word in part.split(".")[:-1]:
            entry = entry[word]
        depth, values = np.array(entry["depth"], dtype=float), np.array(entry[part.rpartition(".")[2]], dtype=float)
        is_stress = part.endswith("value")
        scale = si(float(np.abs(values).max()), "Pa") if is_stress else Scale(1.0, "", "")
        along = si(float(depth.max()) or 1e-6, "m")
        axes.plot(values / scale.size, depth / along.size, "-", color=style.LOWER, gid="profile")
        for one in fit.estimates:
            if one.key.rpartition(".")[0] == part and one.determined:
                at = depth[int(one.key.rpartition(".")[2])] / along.size
                axes.plot(
                    np.array([one.low, one.high]) / scale.size, [at, at], color="#8fbfe0", lw=4.0, solid_capstyle="butt"
                )
                axes.plot(np.array([one.data_low, one.data_high]) / scale.size, [at, at], color=style.LOWER, lw=2.0)
                axes.plot(one.value / scale.size, at, "o", color=style.LOWER, gid="point")
        axes.invert_yaxis()
        axes.set_ylabel(f"depth  [{along.unit}]")
        axes.set_xlabel(f"initial stress  [{scale.unit}]" if is_stress else "factor on the yield stress")
    return fig
