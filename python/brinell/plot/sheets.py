# SPDX-License-Identifier: BSD-3-Clause
"""Sheets for maps that are much longer than wide, such as the contact of a ball in a groove."""

from __future__ import annotations

from dataclasses import dataclass, replace

from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.ticker import MaxNLocator

from brinell.plot import style
from brinell.plot.scales import Scale
from brinell.results import ContactFields, Snapshot
from brinell.results.snapshots import CONTACT_FIELDS
from brinell.scenarios import SCENARIOS

__all__ = ["Range", "Sheet", "enlarged", "few_ticks", "lying", "sheet_of"]

Range = tuple[float, float]

_LONG = 2.5
"""Ratio of the sides above which a map is long."""
_WIDTH, _LEAST_HEIGHT = 6.0, 0.9
"""Of a long map [inch]."""


@dataclass(frozen=True)
class Sheet:
    """How a map of the contact lies on its sheet."""

    is_long: bool
    is_turned: bool
    """Whether y' runs to the right."""
    enlargement: float
    """Of the upward axis; 1 if the map is to scale."""
    height: float
    """Of a long map [inch]."""

    def new_figure(self) -> Figure:
        """The empty figure."""
        if not self.is_long:
            return style.new_figure(5.4, 4.3, to_scale=True)
        return style.new_figure(_WIDTH + 1.0, self.height + 1.7, to_scale=True)

    def finish(self, ax: Axes, length: Scale, snapshot: Snapshot, across: Range, upward: Range) -> None:
        """Sets limits, scale and labels of the axes of the map."""
        ax.set_xlim(*across)
        ax.set_ylim(*upward)
        moves = SCENARIOS[snapshot.scenario].motion is not None
        along = length.label("along the motion" if moves else "", "x'", value=not self.is_turned)
        other = length.label("across" if moves else "", "y'", value=self.is_turned)
        below, beside = (other, along) if self.is_turned else (along, other)
        ax.set_xlabel(below)
        ax.set_ylabel(enlarged(beside, self.enlargement))
        if self.is_long:
            few_ticks(ax, self.height)
            ax.set_aspect(self.enlargement)

    def colour_bar(self, fig: Figure, ax: Axes, image: object, label: str) -> None:
        """Adds a colour bar beside the map, or below a long one."""
        place = {"location": "bottom", "aspect": 45.0, "shrink": 0.75} if self.is_long else {"pad": 0.02}
        fig.colorbar(image, ax=ax, label=label, **place)  # type: ignore[arg-type]


def sheet_of(across: Range, upward: Range) -> Sheet:
    """The sheet for ranges of x' and y'."""
    wide, high = across[1] - across[0], upward[1] - upward[0]
    ratio = max(wide, high) / min(wide, high)
    height = _WIDTH / ratio
    enlargement = _LEAST_HEIGHT / height if height < 0.8 * _LEAST_HEIGHT else 1.0
    is_long = ratio > _LONG
    return Sheet(is_long, is_long and high > wide, enlargement if is_long else 1.0, height * enlargement)


def lying(contact: ContactFields, sheet: Sheet) -> ContactFields:
    """The fields with y' to the right, if the sheet is turned."""
    if not sheet.is_turned:
        return contact
    values = {name: getattr(contact, name) for name in CONTACT_FIELDS}
    turned = {name: field.T for name, field in values.items() if field is not None}
    return replace(contact, x=contact.y, y=contact.x, **turned)


def enlarged(label: str, factor: float) -> str:
    """Label of an axis that is not to the scale of the other one."""
    if factor == 1.0:
        return label
    how = "enlarged" if factor > 1.0 else "reduced"
    return f"{label}\n{how} {style.number(max(factor, 1.0 / factor), 2)} times"


def few_ticks(ax: Axes, height: float) -> None:
    """As many ticks on the upward axis as there is room for."""
    ax.yaxis.set_major_locator(MaxNLocator(nbins=max(2, int(height / 0.35)), steps=[1, 2, 5, 10]))
