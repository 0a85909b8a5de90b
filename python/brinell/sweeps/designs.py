# SPDX-License-Identifier: BSD-3-Clause
"""Designs: choice of the points of a sweep in the space of its axes."""

from __future__ import annotations

import itertools
from collections.abc import Mapping
from typing import Literal, TypeAlias, get_args

from brinell.errors import InputError
from brinell.sweeps.axes import Axis, Value

__all__ = ["Design", "Point", "points_of"]

Design: TypeAlias = Literal["grid", "list", "latin_hypercube"]
Point: TypeAlias = dict[str, Value]
"""Values of one run by key."""


def points_of(axes: Mapping[str, Axis], design: Design, samples: int | None = None, seed: int = 0) -> list[Point]:
    """Points of a design, in the order of the runs.

    Args:
        axes: axes by key of the case.
        design: "grid": all combinations, the last axis fastest; "list": the i-th values of all axes together;
            "latin_hypercube": random points that cover each axis evenly.
        samples: number of points of a Latin hypercube.
        seed: seed of a Latin hypercube.

    Raises:
        InputError: the axes are not suitable for the design.
    """
    if not axes:
        raise InputError("a sweep needs at least one axis, as in tugging.interference=1:15:15")
    if design not in get_args(Design):
        raise InputError(f"the design {design!r} is not known; allowed: {', '.join(get_args(Design))}")
    if design == "latin_hypercube":
        return _drawn(axes, samples, seed)
    if samples is not None:
        raise InputError(f"samples = {samples} has no meaning with the design {design}; it goes with latin_hypercube")
    columns = {key: _values(key, axis) for key, axis in axes.items()}
    if design == "grid":
        return [dict(zip(columns, values, strict=True)) for values in itertools.product(*columns.values())]
    lengths = {key: len(values) for key, values in columns.items()}
    if len(set(lengths.values())) > 1:
        counts = ", ".join(f"{key} has {length}" for key, length in lengths.items())
        raise InputError(f"the axes of a list need as many values each; {counts}")
    return [dict(zip(columns, values, strict=True)) for values in zip(*columns.values(), strict=True)]


def _values(key: str, axis: Axis) -> list[Value]:
    try:
        return axis.values()
    except InputError as error:
        raise InputError(f"{key}: {error}") from error


def _drawn(axes: Mapping[str, Axis], samples: int | None, seed: int) -> list[Point]:
    from scipy.stats import qmc  # slow to import

    if samples is None:
        raise InputError("samples is missing; a Latin hypercube needs 1 or more")
    if samples < 1:
        raise InputError(f"samples = {samples}; a Latin hypercube needs 1 or more")
    for key, axis in axes.items():
        count = getattr(axis, "count", None)
        if count is not None:
            raise InputError(f"{key}: a range of a Latin hypercube has no count (here {count}); samples tells it")
    fractions = qmc.LatinHypercube(len(axes), seed=seed).random(samples)
    return [{key: axis.at(u) for (key, axis), u in zip(axes.items(), row, strict=True)} for row in fractions]
