# SPDX-License-Identifier: BSD-3-Clause
"""Figures that are drawn into axes of the caller (keyword `ax` of the figure functions)."""

from __future__ import annotations

import contextlib
from collections.abc import Iterator, Mapping, Sequence
from contextvars import ContextVar
from typing import Any, TypeAlias

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure, FigureBase

from brinell.errors import InputError

__all__ = ["Target", "draws_into", "target"]

Target: TypeAlias = Any
"""Where to draw: `Axes`, or several, one per panel of the figure, row by row from the top; or a figure or subfigure."""

_TARGET: ContextVar[FigureBase | Placed | None] = ContextVar("target", default=None)


class Placed:
    """Axes of the caller in place of a new figure; the rest is that of the figure they are in."""

    def __init__(self, axes: Sequence[Axes]):
        self._axes = list(axes)
        found = self._axes[0].get_figure(root=True)
        assert found is not None
        self.root: Figure = found

    def subplots(self, nrows: int = 1, ncols: int = 1, *, squeeze: bool = True, **_layout: Any) -> Any:
        """The caller's axes, in the shape in which a figure would return its own."""
        if nrows * ncols != len(self._axes):
            panels = f"{nrows} x {ncols} panels" if nrows * ncols > 1 else "one panel"
            raise InputError(
                f"ax has {len(self._axes)} axes, but the figure has {panels}; allowed: as many axes as panels, as "
                f"ax=figure.subplots({nrows}, {ncols}), or a figure or subfigure, which gets axes of its own"
            )
        grid = np.array(self._axes, dtype=object).reshape(nrows, ncols)
        if not squeeze:
            return grid
        return grid.item() if grid.size == 1 else grid.squeeze()

    def suptitle(self, text: str, **_place: Any) -> Any:
        """A title of the only panel; several panels of the caller get none, because they may be part of more."""
        return self._axes[0].set_title(text) if len(self._axes) == 1 else None

    def legend(self, *args: Any, loc: str = "best", **kwargs: Any) -> Any:
        """A legend in the last panel, because what is around the axes is the caller's."""
        axes: Any = self._axes[-1]
        return axes.legend(*args, loc="best" if "outside" in loc else loc, **kwargs)

    def set_layout_engine(self, *_args: Any, **_kwargs: Any) -> None:
        """Nothing: the layout is the caller's."""

    def add_gridspec(self, *_args: Any, **_kwargs: Any) -> Any:
        """Refused: a figure with panels of different sizes does not fit into given axes."""
        raise InputError("this figure has panels of different sizes; allowed as ax: a figure or subfigure")

    def __getattr__(self, name: str) -> Any:
        return getattr(self.root, name)


def _placed(ax: Any) -> FigureBase | Placed:
    if isinstance(ax, FigureBase):
        return ax
    given = [ax] if isinstance(ax, Axes) else list(ax.values()) if isinstance(ax, Mapping) else ax
    try:
        axes = list(np.asarray(given, dtype=object).ravel())
    except (TypeError, ValueError):
        axes = []
    if not axes or not all(isinstance(one, Axes) for one in axes):
        raise InputError(f"ax = {ax!r}; allowed: matplotlib's axes, one per panel, or a figure or subfigure")
    return Placed(axes)


@contextlib.contextmanager
def draws_into(ax: Target | None) -> Iterator[None]:
    """Context in which `style.new_figure` returns what `ax` says; None: a new figure."""
    token = _TARGET.set(None if ax is None else _placed(ax))
    try:
        yield
    finally:
        _TARGET.reset(token)


def target() -> FigureBase | Placed | None:
    """Where to draw; None: into a new figure."""
    return _TARGET.get()
