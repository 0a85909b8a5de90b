# SPDX-License-Identifier: BSD-3-Clause
# Written by tools/render_python.py from the engine's schema; do not edit.
"""Settings of a case as classes, one for each of the tables `grid`, `interface`, `thermal`, `solver`, `output`.

    run = brinell.Indentation(lower, upper, load=["10 N", 0], grid=brinell.Grid(resolution=12)).run()

A field that is None takes the default of the case file. A dictionary with the same keys can be used instead of an
object. A quantity is a number in the unit that is given, or text with a unit.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Literal

from brinell._tables import CaseTable, Quantity

__all__ = ["Grid", "HeatSource", "Heating", "Interface", "Output", "Point", "Solver", "Wear"]


@dataclass(frozen=True, kw_only=True)
class Grid(CaseTable):
    """The grid.

    Attributes:
        spacing: Size of the cells [dx, dy, dz]: along the motion, across it, in depth. In m, > 0; default: from
            resolution; not together with resolution.
        resolution: Cells per contact radius along x, estimated at the largest load; the cell sizes follow from it.
            Tugging: the elastic contact radius at alignment, cells of dx, 2 dx and dx/2. Allowed: in [1, 1000];
            default: 8.0, in tugging 14.0; not together with spacing; only with boundary = "open" or "periodic_x" or
            "periodic_y".
        extent: Factor on the initial extent of the grids around contact and plastic zone; the grids grow if it is not
            enough. Allowed: in [0.5, 10]; default: 1.0.
        boundary: Boundary conditions: open (unloaded half spaces beyond the grids) or periodic. May be a list for x and
            y: ["open", "periodic"]. Periodic along y alone, with one row of cells, is plane strain. Default: "open".
        size: Period along x and along y; a single number is for both, or for the one periodic axis. In m, > 0; default:
            1 m along y; only with boundary = "periodic" or "periodic_x" or "periodic_y".
        cells: Number of cells in a period along x and along y; a single number is for both, or for the one periodic
            axis. Products of small primes are fast. One cell along an axis is for problems that are uniform along it.
            Allowed: in [1, 65536]; default: from spacing; one along y if it alone is periodic; only with boundary =
            "periodic" or "periodic_x" or "periodic_y".
        layer: Thickness of the layers of cells. In m, > 0; default: half of the smaller of dx and dy; only with
            boundary = "periodic" or "periodic_x" or "periodic_y".
        reference: Distance from a line load at which its displacement is taken as zero; in plane strain the
            displacement has no limit but varies with the logarithm of the distance. At least the half-width of the
            contact. In m, > 0; default: 2 R/e for two cylinders, as for the approach of Green (2005); otherwise the
            period; only with boundary = "periodic_x" or "periodic_y".
    """

    spacing: Sequence[Quantity] | None = None
    resolution: float | None = None
    extent: float | None = None
    boundary: str | Sequence[str] | None = None
    size: Quantity | Sequence[Quantity] | None = None
    cells: int | Sequence[int] | None = None
    layer: Quantity | None = None
    reference: Quantity | None = None


@dataclass(frozen=True, kw_only=True)
class Interface(CaseTable):
    """Friction, frictional heat, wear and electric current of the interface.

    Attributes:
        friction: Coefficient of Coulomb friction: where the surfaces slide, the shear is friction x pressure, limited
            by shear_limit, and opposes the relative motion. In rolling friction needs a slide_to_roll other than 0 or
            creepage, and it does not act while the upper body is pressed on or lifted off. In fretting, and in rolling
            with creepage, the surfaces stick where less shear is enough. Allowed: >= 0; default: 0.0.
        shear_limit: Largest shear of the interface, for instance of a film. A surface never carries more than its
            current shear yield stress. In Pa, > 0; default: the current shear yield stress of the softer surface,
            including hardening.
        coupling: Whether the shear changes the gap, as it does if the elastic constants of the two materials differ.
            False: this effect is neglected, as if both surfaces moved equally. Default: True.
        current: Electric current between bodies that both have an electrical resistivity; over a period, that of one
            period. A list: the values at the ends of the steps 0, 1, 2, ..., or of those of current_steps; the last one
            is kept. In A, >= 0; default: no current; not together with voltage.
        voltage: Voltage between points of the two bodies far from the contact, in place of a current; or a list, as for
            a current. In V, >= 0; default: no current; not together with current.
        current_steps: Steps at whose ends the values of a list of currents or voltages hold, ascending; step 0 is the
            first row of the history. In between the drive is linear, before and after them constant. Allowed: >= 0;
            default: 0, 1, 2 and so on.
        film_resistance: Resistance times area of a film between the surfaces, such as an oxide. 0: no film. In ohm m^2,
            >= 0; default: 0.0.
        film_resistivity: Resistivity of the films whose thickness is given by lower.film and upper.film. In ohm m,
            >= 0; default: 0.0.
        film_growth: Growth of the film where the surfaces slip under pressure: film_resistance gained per slip path,
            half of it on each surface. In ohm m, >= 0; default: 0.0.
        film_limit: Resistance times area that a film does not exceed by growing. In ohm m^2, > 0; default: no limit.
        film_wear: Film that wear takes away: film_resistance lost by a surface per worn depth, which is the resistivity
            of the film if it wears like its surface. In ohm m, >= 0; default: 0.0.
        heat_fraction: Share of the friction power that heats the two bodies, if they have thermal constants. Allowed:
            in [0, 1]; default: 1.0.
        wear: Wear of the surfaces where they slip, `brinell.Wear` or a dictionary.
    """

    friction: float | None = None
    shear_limit: Quantity | None = None
    coupling: bool | None = None
    current: Quantity | Sequence[Quantity] | None = None
    voltage: Quantity | Sequence[Quantity] | None = None
    current_steps: float | Sequence[float] | None = None
    film_resistance: Quantity | None = None
    film_resistivity: Quantity | None = None
    film_growth: Quantity | None = None
    film_limit: Quantity | None = None
    film_wear: Quantity | None = None
    heat_fraction: float | None = None
    wear: Wear | Mapping[str, Any] | None = None


@dataclass(frozen=True, kw_only=True)
class Wear(CaseTable):
    """Wear of both surfaces where they slip.

    Attributes:
        lower: Wear coefficient of the lower surface: worn depth per pressure and slip length, in 1/Pa, or as text in
            mm^3/(N m). A rigid body may wear, too. In rolling wear needs a slide_to_roll other than 0, or a creepage.
            Allowed: >= 0; default: 0.0.
        upper: Wear coefficient of the upper surface. In 1/Pa, >= 0; default: 0.0.
        law: Wear law. archard: worn depth = coefficient x pressure x slip length; energy: worn depth = coefficient x
            friction work per area (shear x slip length). Default: "archard".
    """

    lower: Quantity | None = None
    upper: Quantity | None = None
    law: Literal["archard", "energy"] | None = None


@dataclass(frozen=True, kw_only=True)
class HeatSource(CaseTable):
    """Heat that is supplied from outside.

    Attributes:
        shape: Heat that is supplied from outside at a constant power, also without friction, and moves with the
            contact. disc, rectangle: uniform flux into the surface of one body, as by a laser or a heater; contact:
            heat that arises between the surfaces in proportion to the pressure, as by an electric current, and is
            shared as the heat of friction. It acts from the first step on, except on the way back between passes. Needs
            thermal constants and a speed.
        on: Body whose surface the source heats. Default: "lower"; only with shape = "disc" or "rectangle".
        power: Power of the source; over a period or in plane strain, that of one period. In W, > 0; default: the flux
            is given; not together with flux; only with shape = "disc" or "rectangle" or "contact".
        flux: Flux of the source, instead of its power. In W/m^2, > 0; default: the power is given; not together with
            power; only with shape = "disc" or "rectangle".
        radius: Radius of the disc. In m, > 0; only with shape = "disc".
        length: Length of the rectangle along x. In m, > 0; only with shape = "rectangle".
        width: Width of the rectangle along y. In m, > 0; default: along a periodic axis the whole period; otherwise it
            has to be given; only with shape = "rectangle".
        offset: Distance of the middle of the source from the middle of the contact grid, along x. In m; default: 0.0;
            only with shape = "disc" or "rectangle".
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
class Heating(CaseTable):
    """Effects of heat on bodies with thermal constants.

    Attributes:
        partition: Share of the heat of friction that enters the lower body, everywhere in the contact, before heat
            passes between the surfaces by the conductance. For two bodies that conduct heat. Allowed: in [0, 1];
            default: both surfaces have the same temperature where they touch.
        conductance: Thermal contact conductance: heat flux from one surface to the other where they touch, per
            difference of their temperatures. The heat of friction is released on both surfaces, by the partition, or in
            halves. In W/(m^2 K), >= 0; default: no thermal resistance, so that both surfaces have the same temperature
            where they touch; with a partition no heat passes.
        regime: Heat that determines the temperatures. transient: all heat since the start. steady: steady state, as if
            the heat of the present step had always acted and moved with the present speed; needs grids that are open
            along x; bodies that yield need heat_of_plastic_work = 0. Default: "transient".
        reference: Distance from the contact at which the thermal displacement is taken as zero, for a body at rest
            under a steady flux; its thermal displacement has no limit but varies with the logarithm of the distance. An
            imposed approach counts from there; under a given load only the approach depends on it. In m, > 0; default:
            none: a steady flux at rest on a body that expands is refused.
        heat_of_plastic_work: Share of the plastic work that becomes heat, in the cells in which it is done. It acts
            only if the heat of friction is computed. 0: plastic work does not heat. Metals have about 0.9; the rest
            stays in the material. Allowed: in [0, 1]; default: 0.9.
        displacement: Whether thermal expansion of the surfaces changes the gap. False: this effect is neglected.
            Default: True.
        stress: Whether thermal stress contributes to yielding. False: this effect is neglected. Default: True.
        at_melting: What the run does when a surface reaches the melting temperature of its softening. go_on: the melt
            counts as a solid with a hundredth of its yield stress, and the run warns at its end; stop: the run ends
            with an error and keeps the steps before. Default: "go_on".
        source: Heat from outside, `brinell.HeatSource` or a dictionary.
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
class Solver(CaseTable):
    """Tolerances and methods of the solver.

    Attributes:
        accuracy: Largest accepted relative error of the key numbers, for example "1 %" or 0.01. The case is then run
            with coarser cells first, then with the given cells and, if necessary, with finer ones, until the error
            estimated from the differences between these runs is below it; summary.json gives the interval of each
            number. A number or as "1 %", in (0, 0.5]; default: one run, with the cells as given.
        yield_tolerance: Largest violation of the yield condition, relative to the yield stress. Allowed: in (0, 0.1);
            default: 0.0001.
        displacement_tolerance: Largest change of the residual displacement in the last evaluation, relative to the
            approach at first yield, or to its change in the increment if that is larger. Allowed: in (0, 0.1); default:
            1e-05.
        contact_tolerance: Complementarity of the contact: largest gap under pressure, relative to the largest approach.
            At most a thousandth of yield_tolerance and a hundredth of displacement_tolerance is used, or 1e-12 if that
            is more. Allowed: in (0, 0.1); default: 1e-07.
        max_evaluations: Largest number of evaluations of an increment before it is split; with friction, and in deep
            indents of soft bodies, it is multiplied by four. Allowed: in [1, 100000]; default: 60.
        anderson_depth: Earlier iterates used to accelerate the iteration, in deep indents of soft bodies four times as
            many; 0: plain fixed point. Allowed: in [0, 50]; default: 6.
        integration: Integration of the plastic strain over a step. path: along the path of the trial stress, of second
            order in the step; backward_euler: one radial return at the end of the step, of first order, as in the
            paper. Default: "path".
        mirror: Solve only one body where both always have the same fields: two equal asperities, which stay mirror
            images of each other under exact kinematics, or bodies of the same material in pure rolling and indentation.
            False: solve both (a check; the results agree within the tolerances). Default: True.
        symmetry: Solve only one half if both bodies, their textures and the motion are symmetric about the plane y = 0,
            and the surfaces do not stick: half of the work, with the same result except for rounding. `brinell check`
            shows whether symmetry is used. False: solve both halves (a check). Default: True.
        shortcuts: Within an increment compute the stress only in the layers near yield; the last evaluation computes
            all layers, so that no yield is missed. False: all layers and all cells in every evaluation, and heat
            without approximations (a check; the results agree within the tolerances). Default: True.
        windows: If `shortcuts` is true and a body is longer than what an increment changes, compute the stress within
            an increment only in a window of columns around yielding cells and pressure; the last evaluation computes
            the whole body. False: no window (a check; the results agree within the tolerances). Default: True.
        onset_increments: Where surfaces that slide everywhere begin to slide, or reverse, friction is raised before
            they move: in one increment for this part of the shear yield stress of the weaker body, 1/16 by default. 0:
            in one increment together with the first motion, which makes the plastic work of the onset too small.
            Allowed: in [0, 1000]; default: 16.
        device: Where the bodies are computed. cpu: on the processor; cuda: on a GPU, by a program that is built with
            CUDA; auto: on a GPU if there is one that can, otherwise on the processor; host: on the processor as a GPU
            would, which is slow and proves such a run without one. Results agree to about 1e-10, and a run may change
            its device when it is resumed. What a device does not compute (bodies with layers or inclusions, more than
            four back stresses) is refused. Default: "cpu".
    """

    accuracy: Quantity | None = None
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
    device: Literal["cpu", "cuda", "auto", "host"] | None = None


@dataclass(frozen=True, kw_only=True)
class Point(CaseTable):
    """A point within a body at which each step records stress, plastic strain and temperature.

    Attributes:
        depth: Depth of the point below the surface. In m, >= 0.
        x: x of the point on the surface of its body. The values are those of the cell around the point. In m; default:
            0.
        y: y of the point. In m; default: 0.
        body: Body of a point at which each step records stress, plastic strain and temperature in the file points.csv;
            a table, or a list of tables. Default: the lower one.
    """

    depth: Quantity
    x: Quantity | None = None
    y: Quantity | None = None
    body: Literal["lower", "upper"] | None = None


@dataclass(frozen=True, kw_only=True)
class Output(CaseTable):
    """Storage of results.

    Attributes:
        snapshots: Steps whose fields are stored, in addition to the final state, which is always stored. "aligned": the
            step nearest to the middle of each pass; in an indentation the steps that reach an entry of the list; in
            fretting the turns and the ends of the cycles; in sliding when the bodies are pressed together, and in the
            middle of each stroke. Default: "aligned".
        fields: Fields of the stored states. "surface": all fields on surfaces, and none within the bodies. If neither
            body can yield, those within are computed only if they are stored: contact and surfaces do not need them,
            and they cost far more time and memory than everything else. "shear", "slip", "surface_temperature" and
            "heat_flux" are the fields of the contact of these names with all their components. Pressure and gap are
            always stored. Default: all, as far as the result stays below 200 MB; if neither body can yield, "surface"
            unless depth, a plane or points asks for more.
        bodies: Bodies whose fields are stored, on their surfaces and within them. Default: "both".
        depth: Depth down to which layers are stored. In m, > 0; default: the whole grid; not together with region_z.
        region_x: First and last x of the stored columns, on the surface of each body; equal numbers store the nearest
            column, which is a plane. The fields of the contact are stored as a whole. In m; default: the whole grid.
        region_y: First and last y of the stored rows; equal numbers store the nearest row: [0, 0] is the plane y = 0.
            In m; default: the whole grid.
        region_z: First and last depth of the stored layers of both bodies; equal numbers store the nearest layer: ["20
            um", "20 um"] is a plane. In m, >= 0; default: the whole grid; not together with depth.
        stride: Distance between two stored columns, and between two rows, in cells: 2 stores a quarter of all cells,
            unchanged, not means over them. Allowed: in [1, 1000]; default: 1.
        stride_z: Distance between two stored layers, in layers: 2 stores the first, third, fifth, unchanged. Allowed:
            in [1, 1000]; default: 1.
        precision: How the numbers of the fields are stored; single precision has 7 digits and half of the size. All
            computing is in double precision. Default: double, or single if the result would exceed 200 MB.
        directory: Folder of the results, relative to the current directory; -o on the command line has priority. NAME
            is the name of the case file, or of its folder if the file is called case.toml. Default: results/NAME.
        checkpoint_interval: Time between checkpoints, from which brinell run --resume can continue the run. A
            checkpoint is also written when the run is interrupted. In s, >= 0; default: 30.0.
        points: Points at which each step records stress and strain, a list of `brinell.Point` or a dictionary.
    """

    snapshots: str | Sequence[int] | None = None
    fields: str | Sequence[str] | None = None
    bodies: Literal["both", "lower", "upper"] | None = None
    depth: Quantity | None = None
    region_x: Sequence[Quantity] | None = None
    region_y: Sequence[Quantity] | None = None
    region_z: Quantity | Sequence[Quantity] | None = None
    stride: int | None = None
    stride_z: int | None = None
    precision: Literal["double", "single"] | None = None
    directory: str | Path | None = None
    checkpoint_interval: Quantity | None = None
    points: Sequence[Point | Mapping[str, Any]] | None = None
