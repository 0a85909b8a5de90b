# SPDX-License-Identifier: BSD-3-Clause
"""The creep curve of several rollings: steady forces along the surface over friction times load against creepage.

The forces are those of the last pass, means over the last quarter of the track, on the lower body.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any, Literal

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.ticker import MaxNLocator
from numpy.typing import NDArray

from brinell.plot import style
from brinell.plot.differences import flat_case, told
from brinell.plot.overlay import Look, legend_beside, looks, of_runs, require_scenario, zero_line
from brinell.plot.rolling import creeps, rolled
from brinell.plot.scales import PERCENT, Scale, si
from brinell.results import Run

__all__ = ["creep_curve"]

FloatArray = NDArray[np.float64]
Cause = Literal["longitudinal", "lateral", "spin"]
_CAUSES: tuple[Cause, ...] = ("longitudinal", "lateral", "spin")

_SYMBOLS: Mapping[Cause, tuple[str, str]] = {
    "longitudinal": ("longitudinal creepage", r"\xi"),
    "lateral": ("lateral creepage", r"\eta"),
    "spin": ("spin", r"\varphi"),
}
"""Name and symbol."""


@dataclass(frozen=True, eq=False)
class _Point:
    """The end of one run."""

    run: Run
    creepage: Mapping[Cause, float]
    """[-]; spin [rad/m]."""
    bound: float
    """Friction times load [N]."""
    force: tuple[float, float]
    """Along and across, over that [-]."""
    steady: bool
    others: tuple[tuple[str, Any], ...]
    """All keys of the case but creepage and spin and what is of no matter to steady forces."""


def _point(run: Run) -> _Point:
    longitudinal, lateral = (*(run.case("rolling", "creepage") or []), 0.0, 0.0)[:2]  # what is not given is 0
    spin = run.case("rolling", "spin") or 0.0
    creepage = dict(zip(_CAUSES, (float(longitudinal), float(lateral), float(spin)), strict=True))
    part = rolled(run.history.passes()[-1])
    quarter = part["x"] >= part["x"][-1] - 0.25 * (part["x"][-1] - part["x"][0])
    bound = float(run.case("interface", "friction")) * float(part["F_n"][quarter].mean())
    last = run.passes[-1]
    force = (last.F_x / bound, last.F_y / bound) if bound > 0.0 else (0.0, 0.0)
    others = tuple(
        (key, value) for key, value in flat_case((run.summary or {})["case"]) if not key.startswith(_NO_MATTER)
    )
    return _Point(run, creepage, bound, force, last.creep_steady, others)


_NO_MATTER = (
    "title",
    "grid.",
    "solver.",
    "output.",
    "rolling.creepage",
    "rolling.spin",
    "rolling.distance",
    "rolling.passes",
    "rolling.load_steps",
    "rolling.shift",
)


def _abscissa(points: Sequence[_Point], own: Cause) -> Cause | None:
    """Abscissa of a force: the creepage along it if it varies, else another one that varies; None if none does."""
    order = (own, *(one for one in _CAUSES if one != own))
    return next((one for one in order if len({point.creepage[one] for point in points}) > 1), None)


_Family = list[_Point]


def _families(points: Sequence[_Point], over: Cause) -> dict[str, _Family]:
    """Curves by their labels. The points of a curve differ only in their abscissa and in properties without influence.

    Other creepages may vary along a curve, unless there are several points at the same place.
    """
    by_others: dict[Any, _Family] = {}
    for point in points:
        by_others.setdefault(point.others, []).append(point)
    split = any(len({p.creepage[over] for p in family}) < len(family) for family in by_others.values())
    found: dict[Any, _Family] = {}
    for point in points:
        beside = [(one, point.creepage[one]) for one in _CAUSES if one != over] if split else []
        found.setdefault((*point.others, *beside), []).append(point)
    shared = set.intersection(*(set(key) for key in found))
    named: dict[str, _Family] = {}
    for key, family in found.items():
        known = [told(name, value) for name, value in key if (name, value) not in shared]
        label = ",  ".join(known[:_MOST_TOLD]) + (",  ..." if len(known) > _MOST_TOLD else "")
        label = label or "computed"
        named[label if label not in named else f"{label} ({len(named) + 1})"] = sorted(
            family, key=lambda point: point.creepage[over]
        )
    return named


_MOST_TOLD = 3

# --- Linear theory ----------------------------------------------------------------------------------------------------

_POISSON = (0.0, 0.25, 0.5)
_C11, _C22, _C23 = (3.40, 4.12, 5.20), (3.40, 3.67, 3.98), (1.33, 1.47, 1.63)
"""Kalker's coefficients of a circular contact (Kalker 1967; Johnson 1985, table 8.1), three digits."""


def _linear_force(point: _Point) -> tuple[float, float] | None:
    """Forces of vanishing slip over friction times load: F_x = C11 G a^2 xi, F_y = C22 G a^2 eta + C23 G a^3 phi.

    None unless smooth balls of the same elastic constants touch in a circle; its radius a is that of Hertz. Between
    the Poisson's ratios of the table the coefficients are interpolated, to about 0.5 %.
    """
    run = point.run
    bodies = [(run.case(body, "shape", "type"), run.case(body, "texture", "type")) for body in ("lower", "upper")]
    constants = [
        (run.case(body, "material", "young_modulus"), run.case(body, "material", "poisson_ratio"))
        for body in ("lower", "upper")
    ]
    round_and_smooth = all(shape in ("sphere", "flat") and texture == "smooth" for shape, texture in bodies)
    if not round_and_smooth or constants[0] != constants[1] or None in constants[0] or point.bound <= 0.0:
        return None
    if run.case("grid", "boundary") != "open":
        return None
    E, nu = (float(one) for one in constants[0])
    load = point.bound / float(run.case("interface", "friction"))
    a = (0.75 * load * run.equivalent_radius * 2.0 * (1.0 - nu**2) / E) ** (1.0 / 3.0)
    C11, C22, C23 = (float(np.interp(nu, _POISSON, row)) for row in (_C11, _C22, _C23))
    stiffness = E / (2.0 * (1.0 + nu)) * a**2 / point.bound
    along, across = C11 * point.creepage["longitudinal"], C22 * point.creepage["lateral"]
    return stiffness * along, stiffness * (across + C23 * a * point.creepage["spin"])


# --- The figure -------------------------------------------------------------------------------------------------------


@style.figure
@of_runs
def creep_curve(runs: Sequence[Run], *, ax: style.Target | None = None) -> Figure | None:
    """Steady forces along and across the motion over friction times load, against creepage, a point for each run.

    Runs that differ in more than creepage and spin have a curve each. Each force is drawn over the creepage along it
    if that varies, else over the creepage or the spin that does; one that is never more than a thousandth of friction
    times load has no panel. Dashed, the linear theory of Kalker where smooth balls of the same elastic constants
    touch; grey, friction times load. Open points: not yet steady.

    Args:
        runs: rollings with creepage, or a sweep of them; others among them are left out.

    Returns:
        None if there are no two of them that differ in creepage or spin.

    Raises:
        RunError: a run is of another scenario.
        ValueError: there is no run.
    """
    require_scenario(runs, "rolling")
    points = [_point(run) for run in runs if creeps(run) and run.complete]
    own: tuple[Cause, Cause] = ("longitudinal", "lateral")
    panels = [
        (which, over)
        for which in (0, 1)
        if (over := _abscissa(points, own[which])) is not None
        and max(abs(point.force[which]) for point in points) > 1e-3
    ]
    if not panels:
        return None
    fig = style.new_figure(1.6 + 4.2 * len(panels), 3.9)
    axes = np.atleast_1d(fig.subplots(1, len(panels)))
    curves: dict[str, Look] = {}
    references: dict[str, Look] = {}
    for ax, (which, over), letter in zip(axes, panels, "ab", strict=False):
        families, scale = _families(points, over), _scale(points, over)
        for look, family in zip(_looks(list(families)), families.values(), strict=True):
            place = np.array([point.creepage[over] for point in family]) / scale.size
            _draw_family(ax, family, place, which, look)
            curves.setdefault(look["label"], look)
            if _draw_linear(ax, family, place, which, look["color"] if len(families) > 1 else style.REFERENCE):
                references["linear theory (Kalker)"] = _LINEAR
        if _draw_limits(ax, [point.force[which] for point in points]):
            references[r"friction $\times$ load"] = _LIMIT
        ax.set_xlabel(scale.label(*_SYMBOLS[over]))
        ax.xaxis.set_major_locator(MaxNLocator(nbins=6))
        ax.set_ylabel(f"{('longitudinal', 'lateral')[which]} force  $F_{'xy'[which]}/(fP)$")
        if len(panels) > 1:
            ax.set_title(f"({letter})  {('along', 'across')[which]} the motion")
    shown = list(curves.values())
    if not all(point.steady for point in points):
        shown.append({"color": "0.3", "linestyle": "", "marker": "o", "markerfacecolor": "white", "label": _UNSTEADY})
    legend_beside(axes[-1], [*shown, *(look | {"label": label} for label, look in references.items())])
    return fig


_MARKERS = ("o", "s", "^", "D", "v", "P")
_LINEAR: Look = {"color": style.REFERENCE, "linestyle": "--", "linewidth": 1.0}
_LIMIT: Look = {"color": style.REFERENCE, "linewidth": 0.8}
_UNSTEADY = "not yet steady"


def _looks(labels: Sequence[str]) -> list[Look]:
    """Colours and markers of the curves; dashes are reserved for the linear theory."""
    markers = [_MARKERS[i % len(_MARKERS)] for i in range(len(labels))]
    return [
        look | {"linestyle": "-", "marker": marker, "markersize": 4.5}
        for look, marker in zip(looks(labels), markers, strict=True)
    ]


def _scale(points: Sequence[_Point], over: Cause) -> Scale:
    largest = max(abs(point.creepage[over]) for point in points)
    return si(largest, "rad/m") if over == "spin" else PERCENT


def _draw_family(ax: Axes, family: _Family, place: FloatArray, which: int, look: Look) -> None:
    """Draws one curve; points are open where the force was not yet steady."""
    force = np.array([point.force[which] for point in family])
    steady = np.array([point.steady for point in family])
    ax.plot(place, force, **look | {"marker": ""})
    for chosen, face in ((steady, look["color"]), (~steady, "white")):
        dots: Look = {"linestyle": "", "label": "_", "markerfacecolor": face, "zorder": 3}
        ax.plot(place[chosen], force[chosen], **look | dots)


def _draw_linear(ax: Axes, family: _Family, place: FloatArray, which: int, colour: str) -> bool:
    """Draws the linear theory up to friction times load. Returns whether there is one.

    It goes from point to point where it is not a straight line because other creepages vary along the curve.
    """
    found = [_linear_force(point) for point in family]
    force = np.array([one[which] for one in found if one is not None])
    if force.size < place.size or np.ptp(place) == 0.0:
        return False
    slope, start = np.polyfit(place, force, 1)
    if np.allclose(slope * place + start, force, atol=1e-6 * max(1.0, float(np.abs(force).max()))):
        place = np.array([min(place.min(), 0.0), max(place.max(), 0.0)])
        if slope != 0.0:
            place = np.clip(place, *sorted(((-1.0 - start) / slope, (1.0 - start) / slope)))
        force = slope * place + start
    else:
        place, force = place[np.abs(force) <= 1.0], force[np.abs(force) <= 1.0]
    ax.plot(place, force, **_LINEAR | {"color": colour}, label="_", zorder=1)
    return True


def _draw_limits(ax: Axes, force: Sequence[float]) -> bool:
    """Draws friction times load on the sides where a force comes near it. Returns whether it was drawn.

    Small forces need the height of the axes for themselves.
    """
    zero_line(ax)
    ax.axvline(0.0, color="0.8", linewidth=0.8, zorder=0.5)
    signs = [sign for sign in (1.0, -1.0) if any(sign * one > 0.25 for one in force)]
    for sign in signs:
        ax.axhline(sign, **_LIMIT, zorder=0.6, label="_")
    return bool(signs)
