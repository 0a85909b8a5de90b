# SPDX-License-Identifier: BSD-3-Clause
"""Settings of a case as classes, one for each of the tables `grid`, `interface`, `thermal`, `solver`, `output`.

    run = brinell.Indentation(lower, upper, load=["10 N", 0], grid=brinell.Grid(resolution=12)).run()

A field that is None takes the default of the case file (docs/reference/case-file.md). A dictionary with the same keys
can be used instead of an object.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, fields
from pathlib import Path
from typing import Any, Literal

from brinell.bodies import Quantity

__all__ = ["Grid", "HeatSource", "Heating", "Interface", "Output", "Solver", "Wear"]


class _Table:
    """A table of the case file: the fields of a dataclass that are not None."""

    def to_case(self) -> dict[str, Any]:
        """The table as a dictionary."""
        values = {field.name: getattr(self, field.name) for field in fields(self)}  # type: ignore[arg-type]
        return {name: value for name, value in values.items() if value is not None}


@dataclass(frozen=True, kw_only=True)
class Grid(_Table):
    """The grid. Lengths are in m, or text with a unit.

    Attributes:
        spacing: cell size [dx, dy, dz]: along the motion, across it, in depth. It is an alternative to `resolution`.
        resolution: number of cells per contact radius along x.
        extent: factor on the initial extent of the grids, which grow where that is not enough.
        boundary: "open" or "periodic", for both axes or as a pair; periodic along y alone, with one row of cells, is
            plane strain.
        size: period along each periodic axis.
        cells: number of cells per period along each periodic axis.
        layer: thickness of the layers of cells in depth.
        reference: with exactly one periodic axis: distance from a line load at which its displacement is set to zero.
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
    """Friction, frictional heat and wear of the interface, in tugging, sliding, rolling with slip and fretting.

    Attributes:
        friction: friction coefficient, shear over pressure [-].
        shear_limit: largest shear that the interface can transmit [Pa], for instance a film; a surface never carries
            more than its current shear yield stress.
        coupling: whether the shear changes the gap if the two materials differ.
        heat_fraction: fraction of the friction power that heats bodies with thermal constants [-].
        wear: wear of the surfaces where they slip, `brinell.Wear` or a dictionary.
    """

    friction: float | None = None
    shear_limit: Quantity | None = None
    coupling: bool | None = None
    heat_fraction: float | None = None
    wear: Wear | Mapping[str, Any] | None = None


@dataclass(frozen=True, kw_only=True)
class Wear(_Table):
    """Wear of both surfaces where they slip.

    Attributes:
        lower: wear coefficient of the lower surface: depth per pressure and slip path [1/Pa], or text,
            "1e-6 mm^3/(N m)".
        upper: wear coefficient of the upper surface.
        law: "archard": wear proportional to pressure times slip path; "energy": proportional to the friction work,
            shear times slip path.
    """

    lower: Quantity | None = None
    upper: Quantity | None = None
    law: Literal["archard", "energy"] | None = None


@dataclass(frozen=True, kw_only=True)
class HeatSource(_Table):
    """Heat that is supplied from outside at a constant power and moves with the contact, with or without friction.

    Attributes:
        shape: "disc" or "rectangle": uniform flux into the surface of one body; "contact": heat that arises between
            the surfaces in proportion to the pressure, as that of an electric current.
        on: the body whose surface a disc or rectangle heats.
        power: total power [W]; on a periodic grid that of one period.
        flux: flux of a disc or rectangle [W/m²], instead of the power.
        radius: radius of a disc [m].
        length: length of a rectangle along x [m].
        width: width of a rectangle along y [m]; None, along a periodic axis: the whole period.
        offset: position of a disc or rectangle along x, from the middle of the contact grid [m].
    """

    shape: Literal["none", "disc", "rectangle", "contact"]
    on: Literal["lower", "upper"] | None = None
    power: Quantity | None = None
    flux: Quantity | None = None
    radius: Quantity | None = None
    length: Quantity | None = None
    width: Quantity | None = None
    offset: Quantity | None = None


@dataclass(frozen=True, kw_only=True)
class Heating(_Table):
    """Effects of heat on bodies with thermal constants, in tugging, rolling, sliding and fretting.

    Attributes:
        partition: fraction of the frictional heat that enters the lower body [-]; None: both surfaces have the same
            temperature where they touch.
        conductance: thermal conductance of the contact [W/(m² K)]. None: there is no thermal resistance or, if
            `partition` is given, no exchange of heat between the bodies.
        regime: "transient": all heat since the start counts; "steady": the heat flux of each step is taken to have
            always acted (bodies that yield then need heat_of_plastic_work=0; not where surfaces may stick).
        reference: distance at which the displacement of a body at rest under a steady flux is set to zero [m].
        heat_of_plastic_work: fraction of the plastic work that becomes heat at the point where it is done [-]; 0: none.
        displacement: whether thermal expansion of the surfaces changes the gap.
        stress: whether the thermal stress contributes to yielding.
        at_melting: whether a run goes on or stops when a surface reaches the melting temperature of its softening.
        source: heat from outside, `brinell.HeatSource` or a dictionary.
    """

    partition: float | None = None
    conductance: Quantity | None = None
    regime: Literal["transient", "steady"] | None = None
    reference: Quantity | None = None
    heat_of_plastic_work: float | None = None
    displacement: bool | None = None
    stress: bool | None = None
    at_melting: Literal["go_on", "stop"] | None = None
    source: HeatSource | Mapping[str, Any] | None = None


@dataclass(frozen=True, kw_only=True)
class Solver(_Table):
    """Tolerances and methods of the solver.

    Attributes:
        accuracy: largest accepted relative error of the key numbers, 0.01 or "1 %"; a series of runs with finer and
            finer cells is then computed.
        yield_tolerance: largest violation of the yield condition, relative to the yield stress [-].
        displacement_tolerance: largest change of the residual displacement in the last evaluation, relative to the
            approach at first yield, or to its change in the increment if that is larger [-].
        contact_tolerance: largest gap under pressure, relative to the largest approach [-]. At most a thousandth of
            `yield_tolerance` and a hundredth of `displacement_tolerance` is used, or 1e-12 if that is more.
        max_evaluations: largest number of evaluations of an increment before it is split; with friction, and in deep
            indents of soft bodies, it is multiplied by four.
        anderson_depth: number of earlier iterates in the Anderson acceleration, in deep indents of soft bodies four
            times as many; 0: plain fixed-point iteration.
        integration: time integration of the plastic strain in a step, "path" or "backward_euler".
        mirror: whether only one of two bodies that are mirror images is solved.
        symmetry: whether only one side of the plane y = 0 is solved if the problem is symmetric to it.
        shortcuts: whether, within an increment, the stress is computed only in the layers near yield and the heat only
            approximately.
        windows: with `shortcuts`, whether only the columns near the contact are computed within an increment.
        onset_increments: where sliding begins or reverses, number of increments at rest in which friction is raised by
            the shear yield stress; 0: friction is raised in one increment, together with the first motion.
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
    onset_increments: int | None = None


@dataclass(frozen=True, kw_only=True)
class Point(_Table):
    """A point within a body at which each step records stress, plastic strain and temperature.

    Attributes:
        depth: depth below the surface [m].
        x: coordinate on the surface of the body along the motion [m]; None: 0.
        y: coordinate across [m]; None: 0.
        body: "lower" or "upper"; None: the lower one.
    """

    depth: Quantity
    x: Quantity | None = None
    y: Quantity | None = None
    body: Literal["lower", "upper"] | None = None


@dataclass(frozen=True, kw_only=True)
class Output(_Table):
    """Storage of results.

    Attributes:
        snapshots: steps whose fields are stored in addition to the final state: "none", "aligned", "all", "every 5", or
            a list of step numbers.
        fields: fields of the stored states: "all"; "surface", all fields on surfaces; names such as "von_mises_stress";
            or a list of these. None: all, as far as the result stays below 200 MB.
        bodies: bodies whose fields are stored: "both", "lower" or "upper".
        depth: depth down to which layers are stored [m].
        region_x: first and last x of the stored columns, on the surface of each body [m]; equal numbers store one.
        region_y: first and last y of the stored rows [m]; (0, 0) stores the plane y = 0.
        stride: distance between stored columns, and between stored rows, in cells.
        points: points at which each step records stress and strain, a list of `brinell.Point`.
        precision: "double" or "single"; None: single if the result would exceed 200 MB.
        directory: folder of the results for the command line; `Case.run` has an argument of its own for it.
        checkpoint_interval: time between two checkpoints of a run [s].
    """

    snapshots: str | Sequence[int] | None = None
    fields: str | Sequence[str] | None = None
    bodies: Literal["both", "lower", "upper"] | None = None
    depth: Quantity | None = None
    region_x: tuple[Quantity, Quantity] | None = None
    region_y: tuple[Quantity, Quantity] | None = None
    stride: int | None = None
    precision: Literal["double", "single"] | None = None
    points: Sequence[Point | Mapping[str, Any]] | None = None
    directory: str | Path | None = None
    checkpoint_interval: Quantity | None = None
