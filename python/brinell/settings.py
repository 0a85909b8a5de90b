# SPDX-License-Identifier: BSD-3-Clause
"""How a case is computed and what is stored: the tables `grid`, `solver` and `output` of the case file, as classes.

    run = brinell.Indentation(lower, upper, load=["10 N", 0], grid=brinell.Grid(resolution=12)).run()

What is None is left to the case file's defaults, as docs/reference/case-file.md has them. A dictionary with the same
keys does as well.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, fields
from pathlib import Path
from typing import Any, Literal

from brinell._names import renamed
from brinell.bodies import Quantity

__all__ = ["Grid", "Heating", "Interface", "Output", "Solver", "Wear"]


class _Table:
    """A table of the case file: the fields of a dataclass that are not None."""

    def to_case(self) -> dict[str, Any]:
        """As a dictionary."""
        values = {field.name: getattr(self, field.name) for field in fields(self)}  # type: ignore[arg-type]
        return {name: value for name, value in values.items() if value is not None}


@dataclass(frozen=True, kw_only=True)
class Grid(_Table):
    """The cells.

    Attributes:
        spacing: their size [dx, dy, dz]: along the motion, across it, in depth; or
        resolution: how many of them there are per contact radius along x.
        extent: factor on the first extent of the grids, which grow where that is not enough.
        boundary: what lies beyond the grids, "open" or "periodic", for both axes or as a pair; periodic along y alone,
            with one row, is plane strain.
        size: the period along each axis that is periodic.
        cells: how many of them make it.
        layer: thickness of their layers.
        reference: with one periodic axis, the distance from a line load at which its displacement counts as zero.
    """

    spacing: Sequence[Quantity] | None = None
    resolution: float | None = None
    extent: float | None = None
    boundary: str | Sequence[str] | None = None
    size: Sequence[Quantity] | None = None
    cells: Sequence[int] | None = None
    layer: Quantity | None = None
    reference: Quantity | None = None


@dataclass(frozen=True, kw_only=True)
class Interface(_Table):
    """What is between the surfaces where they slide on each other: in tugging, sliding, rolling with slip, fretting.

    Attributes:
        friction: shear over pressure.
        shear_limit: largest shear that a surface can carry; the shear yield stress of the softer one if it is None.
        coupling: whether the shear moves the gap where the two materials differ.
        heat_fraction: share of the friction power that warms bodies with thermal constants.
        wear: what the surfaces lose where they slip, `brinell.Wear` or a dictionary; in sliding, rolling and fretting.
    """

    friction: float | None = None
    shear_limit: Quantity | None = None
    coupling: bool | None = None
    heat_fraction: float | None = None
    wear: Wear | Mapping[str, Any] | None = None


@dataclass(frozen=True, kw_only=True)
class Wear(_Table):
    """How much both surfaces lose where they slip on each other.

    Attributes:
        lower: depth that the lower surface loses per pressure and length slipped [1/Pa], or text, "1e-6 mm^3/(N m)".
        upper: the same of the upper surface.
        law: whether that goes with the pressure ("archard") or with the shear, as the friction work does ("energy").
    """

    lower: Quantity | None = None
    upper: Quantity | None = None
    law: Literal["archard", "energy"] | None = None


@dataclass(frozen=True, kw_only=True)
class Heating(_Table):
    """What the heat of friction does to bodies with thermal constants, in tugging, rolling and sliding.

    Attributes:
        partition: share of the lower body in it; both surfaces have one temperature where they touch if it is None.
        conductance: of the contact [W/(m² K)]; if it is None nothing resists the heat, or with a partition none passes.
        regime: all heat since the start, or that of a step as if it had always been there ("steady": of bodies that
            yield with heat_of_plastic_work=0).
        reference: distance at which a body that rests under a steady flux counts as not displaced [m].
        heat_of_plastic_work: share of the plastic work that becomes heat where it is done; 0: none.
        displacement: whether the surfaces swell into the gap.
        stress: whether thermal stress counts when the material yields.
        at_melting: whether a run goes on or stops when a surface reaches the melting temperature of its softening.
    """

    partition: float | None = None
    conductance: Quantity | None = None
    regime: Literal["transient", "steady"] | None = None
    reference: Quantity | None = None
    heat_of_plastic_work: float | None = None
    displacement: bool | None = None
    stress: bool | None = None
    at_melting: Literal["go_on", "stop"] | None = None


@renamed(max_iterations="max_evaluations")
@dataclass(frozen=True, kw_only=True)
class Solver(_Table):
    """When an increment counts as solved, and how it is.

    Attributes:
        accuracy: largest relative error of the key numbers that is accepted, 0.01 or "1 %": a series of runs.
        yield_tolerance: largest violation of the yield condition, relative to the yield stress.
        displacement_tolerance: largest change of the residual displacement in the last evaluation, relative to the
            approach at first yield.
        contact_tolerance: largest gap under pressure, relative to the largest approach.
        max_evaluations: of an increment before it is split.
        anderson_depth: earlier iterates used to accelerate the iteration; 0: plain fixed point.
        integration: of the plastic strain in a step.
        mirror: whether bodies that are mirror images are solved once.
        symmetry: whether one side of the plane y = 0 is solved where both are the same.
        shortcuts: whether the stress is computed only in the layers near yield within an increment, and heat roughly.
        windows: with shortcuts, whether only the columns near the contact are computed within an increment.
    """

    accuracy: float | str | None = None
    yield_tolerance: float | None = None
    displacement_tolerance: float | None = None
    contact_tolerance: float | None = None
    max_evaluations: int | None = None
    anderson_depth: int | None = None
    integration: Literal["path", "backward_euler"] | None = None
    mirror: bool | None = None
    symmetry: bool | None = None
    shortcuts: bool | None = None
    windows: bool | None = None


@dataclass(frozen=True, kw_only=True)
class Output(_Table):
    """What is stored.

    Attributes:
        snapshots: steps whose fields are stored beside the final state: "none", "aligned", "all", "every 5", or their
            numbers.
        directory: folder of the results of the command line; `Case.run` is told its own.
        checkpoint_interval: time after which the state is stored again while the run goes on [s].
    """

    snapshots: str | Sequence[int] | None = None
    directory: str | Path | None = None
    checkpoint_interval: Quantity | None = None
