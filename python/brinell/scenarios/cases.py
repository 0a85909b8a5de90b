# SPDX-License-Identifier: BSD-3-Clause
# Written by tools/render_python.py from the engine's schema; do not edit.
"""The scenarios as classes: cases whose text is generated from arguments."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any, Literal

from brinell._tables import Quantity
from brinell.bodies import Body
from brinell.scenarios._case import ScenarioCase
from brinell.settings import Grid, Heating, Interface, Output, Solver

__all__ = ["Fretting", "Indentation", "Rolling", "Sliding", "Tugging"]


class Tugging(ScenarioCase):
    """The upper body is carried along x past the lower one at constant height or under a load."""

    _table = "tugging"

    def __init__(
        self,
        lower: Body,
        upper: Body,
        interference: Quantity | None = None,
        *,
        offset: Quantity | None = None,
        load: Quantity | None = None,
        normalised: bool | None = None,
        shift: Quantity | None = None,
        kinematics: Literal["exact", "paper"] | None = None,
        passes: int | None = None,
        speed: Quantity | None = None,
        title: str | None = None,
        interface: Interface | Mapping[str, Any] | None = None,
        thermal: Heating | Mapping[str, Any] | None = None,
        grid: Grid | Mapping[str, Any] | None = None,
        solver: Solver | Mapping[str, Any] | None = None,
        output: Output | Mapping[str, Any] | None = None,
    ):
        """Makes a case.

        Args:
            lower: The body at rest; its shape is a `Sphere`, `Ellipsoid` or `Cylinder`.
            upper: The moving body, with one of the same shapes.
            interference: Overlap in height of the undeformed bodies, without textures, when their centres are aligned
                along x; the height of the centres is constant. Without an offset this is the largest overlap. In m (a
                pure number if normalised), > 0; default: load; not together with load.
            offset: Offset of the upper centre from the lower one along y, so that the bodies pass beside each other. It
                reduces the overlap along the line of centres by offset^2 / (2 (R1 + R2)), to second order. If
                normalised, in units of the contact radius a_c at first yield. Not allowed with a load. In m (a pure
                number if normalised); default: 0.0.
            load: Normal force that is kept constant while the upper body rides over the lower one, instead of an
                interference; in units of the critical load P_c if normalised. It is applied in the first eighth of a
                pass and removed in the last. Only with exact kinematics. In N (a pure number if normalised), > 0;
                default: interference; not together with interference.
            normalised: Whether the interference is given in units of the critical interference alpha_c at first yield,
                and the load in units of the critical load P_c; needs a body that can yield, and bodies whose relative
                curvature is the same along x and y, or cylinders in plane strain. Default: True.
            shift: Arc by which the contact moves on each body per step (mean of both bodies). Preferably a whole
                multiple of dx / 2; otherwise the surfaces are interpolated between cells. Under a load dx, or a shift
                that is not a multiple of it, is made to fit the way on which the bodies touch. In m, > 0; default: one
                cell, dx.
            kinematics: Relation of arc and sliding distance. exact: X = omega tan(theta); paper: Eqs. 9-13 of Boucly,
                Nelias, Green (2006). Default: "exact".
            passes: Number of passes of the upper body; after each pass it returns to the start, and both bodies keep
                their deformation. Allowed: in [1, 10000]; default: 1.
            speed: Speed of the upper surface over the lower one, taken as the sum of the speeds at which the contact
                moves over both bodies. The heat of friction depends on it. The way back from pass to pass takes as long
                as a pass. In m/s, > 0; default: none; needed where friction heats.
            title: Free text, copied into the results.
            interface: Friction, wear and current, `brinell.Interface` or a dictionary.
            thermal: Effects of heat, `brinell.Heating` or a dictionary.
            grid: Grid settings, `brinell.Grid` or a dictionary.
            solver: Solver settings, `brinell.Solver` or a dictionary.
            output: Stored results, `brinell.Output` or a dictionary.

        Raises:
            InputError: the case is invalid; the message lists all problems found.
        """
        ScenarioCase.__init__(self, locals())


class Indentation(ScenarioCase):
    """The upper body is pressed into the lower one and lifted off again, at one place or at several."""

    _table = "indentation"

    def __init__(
        self,
        lower: Body,
        upper: Body,
        *,
        normalised: bool | None = None,
        load: Quantity | Sequence[Quantity] | None = None,
        approach: Quantity | Sequence[Quantity] | None = None,
        pressure: Quantity | Sequence[Quantity] | None = None,
        mean_gap: Quantity | Sequence[Quantity] | None = None,
        steps: int | None = None,
        cycles: int | None = None,
        places: Quantity | Sequence[Quantity] | None = None,
        title: str | None = None,
        interface: Interface | Mapping[str, Any] | None = None,
        grid: Grid | Mapping[str, Any] | None = None,
        solver: Solver | Mapping[str, Any] | None = None,
        output: Output | Mapping[str, Any] | None = None,
    ):
        """Makes a case; exactly one of load, approach, pressure and mean_gap is given.

        Args:
            lower: The body that is indented.
            upper: The indenter.
            normalised: Whether load and approach are given in units of their values at first yield, P_c and alpha_c;
                needs round bodies, or cylinders in plane strain, at least one of which can yield. Default: False.
            load: Sequence of loads, starting from zero: ["10 N", 0] presses and lifts off. In N (a pure number if
                normalised), >= 0.
            approach: Sequence of approaches, counted from the first touch of the undeformed bodies without their
                textures, instead of loads. In m (a pure number if normalised), >= 0.
            pressure: Sequence of mean pressures over the period, instead of loads; with grid.boundary = "periodic". In
                Pa, >= 0.
            mean_gap: Sequence of mean gaps of the deformed surfaces over the period, instead of loads; with
                grid.boundary = "periodic". The mean gap decreases as the bodies are pressed together; a gap larger than
                that of first touch lifts off: ["0.1 um", "5 um"] presses and lifts off. In m, > 0.
            steps: Number of steps from one entry of the list to the next, with equal increments of approach or mean
                gap, or of load^(2/3) if the load is imposed. Allowed: in [1, 100000]; default: 20.
            cycles: Number of times that the list is applied at each place. Allowed: in [1, 10000]; default: 1.
            places: Places along x on the lower body that are indented one after the other. In m; default: [0.0].
            title: Free text, copied into the results.
            interface: Friction, wear and current, `brinell.Interface` or a dictionary.
            grid: Grid settings, `brinell.Grid` or a dictionary.
            solver: Solver settings, `brinell.Solver` or a dictionary.
            output: Stored results, `brinell.Output` or a dictionary.

        Raises:
            InputError: the case is invalid; the message lists all problems found.
        """
        ScenarioCase.__init__(self, locals())


class Rolling(ScenarioCase):
    """The upper body is pressed on the lower one and rolls over it along x, pass after pass."""

    _table = "rolling"

    def __init__(
        self,
        lower: Body,
        upper: Body,
        distance: Quantity,
        *,
        load: Quantity | None = None,
        hertz_pressure: Quantity | None = None,
        approach: Quantity | None = None,
        shift: Quantity | None = None,
        slide_to_roll: float | None = None,
        creepage: Quantity | Sequence[Quantity] | None = None,
        spin: Quantity | None = None,
        passes: int | None = None,
        load_steps: int | None = None,
        speed: Quantity | None = None,
        title: str | None = None,
        interface: Interface | Mapping[str, Any] | None = None,
        thermal: Heating | Mapping[str, Any] | None = None,
        grid: Grid | Mapping[str, Any] | None = None,
        solver: Solver | Mapping[str, Any] | None = None,
        output: Output | Mapping[str, Any] | None = None,
    ):
        """Makes a case; exactly one of load, hertz_pressure and approach is given.

        Args:
            lower: The body that is rolled over.
            upper: The rolling body.
            distance: Length of the track on the lower body, from -distance/2 to distance/2, in an even number of steps
                that dx is made to fit. Where cells or a shift that the case gives do not fit, a warning names the
                length that is rolled. In m, > 0.
            load: Load kept while rolling. In N, > 0.
            hertz_pressure: Peak pressure of the elastic contact (Hertz) that defines the load, instead of a load. In
                Pa, > 0.
            approach: Approach kept while rolling, instead of a load. In m, > 0.
            shift: Distance that the contact moves on the lower body per step. With creepage a whole number of cells: dx
                is made to fit it, unless the case gives the cells or it is less than half of one. In m, > 0; default:
                one cell, dx.
            slide_to_roll: Slide-to-roll ratio: difference (lower minus upper) over mean of the speeds at which the
                surfaces pass the contact. 0: pure rolling; 2: the upper body slides without rotation. Friction acts
                only if interface.friction is given. Allowed: in (-2, 2]; default: 0.0.
            creepage: Creepages [longitudinal, lateral], or the longitudinal one alone: velocities of the upper surface
                relative to the lower one, towards +x and +y, over the mean speed at which the surfaces pass the
                contact. With creepage the surfaces stick in places and slip in others, and rolling develops from rest
                to the steady state. Needs interface.friction, and slide_to_roll = 0, which is for surfaces that slide
                everywhere. A number or as "1 %", in [-0.1, 0.1]; default: no stick: the surfaces slide everywhere, by
                slide_to_roll.
            spin: Spin creepage: rotation of the upper body relative to the lower one about the normal of the contact,
                from x to y, per distance rolled. With stick and slip, like creepage. In rad/m; default: none.
            passes: Number of passes over the track. Each pass begins at the same place on both bodies. Allowed:
                in [1, 100000]; default: 1.
            load_steps: Steps in which the upper body is pressed on before a pass and lifted off after it. Allowed:
                in [1, 100000]; default: 6.
            speed: Speed of the contact over the lower body, on which the heat of friction depends; with slide_to_roll
                it determines the sliding speed. A step of pressing on or lifting off takes as long as one of rolling,
                with creepage all of them at least as long as the contact takes to roll over its own length; the way
                back from pass to pass takes as long as a pass. In m/s, > 0; default: none; needed where friction heats.
            title: Free text, copied into the results.
            interface: Friction, wear and current, `brinell.Interface` or a dictionary.
            thermal: Effects of heat, `brinell.Heating` or a dictionary.
            grid: Grid settings, `brinell.Grid` or a dictionary.
            solver: Solver settings, `brinell.Solver` or a dictionary.
            output: Stored results, `brinell.Output` or a dictionary.

        Raises:
            InputError: the case is invalid; the message lists all problems found.
        """
        ScenarioCase.__init__(self, locals())


class Fretting(ScenarioCase):
    """The upper body is pressed on the lower one and oscillates along the surface, on which it sticks in places."""

    _table = "fretting"

    def __init__(
        self,
        lower: Body,
        upper: Body,
        *,
        load: Quantity | None = None,
        approach: Quantity | None = None,
        pressure: Quantity | None = None,
        displacement: Quantity | None = None,
        force: Quantity | None = None,
        direction: Quantity | None = None,
        cycles: int | None = None,
        steps_per_cycle: int | None = None,
        press_steps: int | None = None,
        frequency: Quantity | None = None,
        title: str | None = None,
        interface: Interface | Mapping[str, Any] | None = None,
        thermal: Heating | Mapping[str, Any] | None = None,
        grid: Grid | Mapping[str, Any] | None = None,
        solver: Solver | Mapping[str, Any] | None = None,
        output: Output | Mapping[str, Any] | None = None,
    ):
        """Makes a case; exactly one of load, approach and pressure, and one of displacement and force is given.

        Args:
            lower: The body at rest.
            upper: The body that is pressed on the lower one and oscillates.
            load: Load that is applied first and then kept. In N, > 0.
            approach: Approach of the bodies that is imposed first and then kept, instead of a load. In m, > 0.
            pressure: Mean pressure over the period, instead of a load; with grid.boundary = "periodic". In Pa, > 0.
            displacement: Amplitude of the displacement of distant points of the upper body relative to those of the
                lower one; each cycle goes from the middle to the amplitude, to its opposite and back to the middle. Up
                to the radius of the contact. In m, >= 0.
            force: Amplitude of the tangential force, instead of a displacement; it must be less than friction times
                load. In N, >= 0.
            direction: Direction of the motion, from x towards y, in degrees. Allowed: in [-360, 360]; default: 0.0.
            cycles: Number of cycles of the oscillation. Allowed: in [0, 100000]; default: 1.
            steps_per_cycle: Number of steps in a cycle, a multiple of 4, so that steps end at the middle and at both
                reversals. Allowed: in [4, 100000]; default: 40.
            press_steps: Number of steps in which load or approach is applied. Allowed: in [1, 100000]; default: 10.
            frequency: Cycles per second, on which the heat of friction depends. Each step of pressing takes as long as
                one of a cycle. In Hz, > 0; default: none; needed where friction heats.
            title: Free text, copied into the results.
            interface: Friction, wear and current, `brinell.Interface` or a dictionary.
            thermal: Effects of heat, `brinell.Heating` or a dictionary.
            grid: Grid settings, `brinell.Grid` or a dictionary.
            solver: Solver settings, `brinell.Solver` or a dictionary.
            output: Stored results, `brinell.Output` or a dictionary.

        Raises:
            InputError: the case is invalid; the message lists all problems found.
        """
        ScenarioCase.__init__(self, locals())


class Sliding(ScenarioCase):
    """The upper body is pressed on the lower one and slides over it along x, in strokes or to and fro."""

    _table = "sliding"

    def __init__(
        self,
        lower: Body,
        upper: Body,
        distance: Quantity,
        *,
        load: Quantity | None = None,
        pressure: Quantity | None = None,
        mean_gap: Quantity | None = None,
        approach: Quantity | None = None,
        press_steps: int | None = None,
        shift: Quantity | None = None,
        strokes: int | None = None,
        to_and_fro: bool | None = None,
        speed: Quantity | None = None,
        title: str | None = None,
        interface: Interface | Mapping[str, Any] | None = None,
        thermal: Heating | Mapping[str, Any] | None = None,
        grid: Grid | Mapping[str, Any] | None = None,
        solver: Solver | Mapping[str, Any] | None = None,
        output: Output | Mapping[str, Any] | None = None,
    ):
        """Makes a case; exactly one of load, pressure, mean_gap and approach is given.

        Args:
            lower: The body at rest: a `Flat`, with or without a texture.
            upper: The sliding body: also a `Flat`, on a grid that is periodic along both axes, or a ball or roller.
            distance: Sliding distance of the upper body along x over the lower one in each stroke, in whole steps that
                dx is made to fit. Where a period, or cells or a shift that the case gives do not fit, a warning names
                the distance that is slid. In m, > 0.
            load: Load that is applied first and kept while sliding. In N, > 0.
            pressure: Mean pressure over the period, instead of a load; with grid.boundary = "periodic". In Pa, > 0.
            mean_gap: Mean gap of the deformed surfaces over the period, instead of a load; with grid.boundary =
                "periodic". In m, > 0.
            approach: Approach of the bodies, instead of a load. It may be negative if peaks meet on the way. In m.
            press_steps: Number of steps in which the bodies are pressed together before sliding, and lifted off
                afterwards. Allowed: in [1, 100000]; default: 10.
            shift: Sliding distance in a step. In m, > 0; default: one cell, dx.
            strokes: Number of strokes. Allowed: in [1, 100000]; default: 1.
            to_and_fro: Whether every second stroke goes back. Otherwise each stroke continues where the previous one
                ended, which needs a period along x. Default: False.
            speed: Speed of the upper body over the lower one, on which the heat of friction depends. A step of pressing
                or lifting off takes as long as one of sliding. In m/s, > 0; default: none; needed where friction heats.
            title: Free text, copied into the results.
            interface: Friction, wear and current, `brinell.Interface` or a dictionary.
            thermal: Effects of heat, `brinell.Heating` or a dictionary.
            grid: Grid settings, `brinell.Grid` or a dictionary.
            solver: Solver settings, `brinell.Solver` or a dictionary.
            output: Stored results, `brinell.Output` or a dictionary.

        Raises:
            InputError: the case is invalid; the message lists all problems found.
        """
        ScenarioCase.__init__(self, locals())
