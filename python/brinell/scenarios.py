# SPDX-License-Identifier: BSD-3-Clause
"""The scenarios as Python classes: each makes a `Case`.

    steel = brinell.Material("210 GPa", 0.3, brinell.Linear("600 MPa", "2 GPa"))
    ball = brinell.Body(brinell.Sphere("10 um"), steel)
    run = brinell.Tugging(lower=ball, upper=ball, interference=4).run(progress=True)

What is None is left to the case file's defaults, as docs/reference/case-file.md has them.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

import tomli_w

from brinell.bodies import Body, Quantity
from brinell.case import Case, HeightMaps, in_arguments, plain
from brinell.errors import InputError
from brinell.settings import Grid, Interface, Output, Solver

__all__ = ["Indentation", "Rolling", "Tugging"]


class _Scenario(Case):
    """A case whose text is made of arguments."""

    _table: str

    def __init__(
        self,
        lower: Body,
        upper: Body,
        table: Mapping[str, Any],
        *,
        title: str | None,
        grid: Grid | Mapping[str, Any] | None,
        solver: Solver | Mapping[str, Any] | None,
        output: Output | Mapping[str, Any] | None,
        interface: Interface | Mapping[str, Any] | None = None,
    ):
        for name, body in (("lower", lower), ("upper", upper)):
            if not isinstance(body, Body):
                raise InputError(f"{name} = {body!r}; allowed: a brinell.Body")
        parts = (
            ("interface", interface, Interface),
            ("grid", grid, Grid),
            ("solver", solver, Solver),
            ("output", output, Output),
        )
        for name, part, kind in parts:
            if not (part is None or isinstance(part, kind | Mapping)):
                raise InputError(f"{name} = {part!r}; allowed: a brinell.{kind.__name__}, a dictionary, or None")
        values = {
            "scenario": self._table,
            "title": title,
            "lower": lower.parts(),
            "upper": upper.parts(),
            self._table: table,
            "interface": interface,
            "grid": grid,
            "solver": solver,
            "output": output,
        }
        try:
            maps: HeightMaps = {}
            text = tomli_w.dumps(plain(values, maps))
            super().__init__(text, file=Path(f"{self._table}.toml"), names_lines=False, maps=maps)
        except InputError as error:  # the keys of the scenario's own table are arguments
            raise type(error)(in_arguments(str(error), self._table)) from None


class Tugging(_Scenario):
    """Two asperities slide past each other and push each other aside."""

    _table = "tugging"

    def __init__(
        self,
        lower: Body,
        upper: Body,
        interference: Quantity | None = None,
        *,
        load: Quantity | None = None,
        normalised: bool = True,
        passes: int | None = None,
        shift: Quantity | None = None,
        kinematics: str | None = None,
        interface: Interface | Mapping[str, Any] | None = None,
        title: str | None = None,
        grid: Grid | Mapping[str, Any] | None = None,
        solver: Solver | Mapping[str, Any] | None = None,
        output: Output | Mapping[str, Any] | None = None,
    ):
        """Describes a tugging.

        Args:
            lower: the body at rest; its shape is a `Sphere`, `Ellipsoid` or `Cylinder`.
            upper: the body that passes over it, of such a shape.
            interference: largest overlap of the undeformed bodies, without textures, when their centres are aligned; in
                critical interferences alpha_c, or a length if not normalised.
            load: instead, a normal force that is kept; in critical loads P_c, or a force if not normalised.
            normalised: whether these are in their values at first yield.
            passes: how often the upper body passes.
            shift: arc by which the contact moves on each body per step.
            kinematics: "exact" or "paper".
            interface: friction, `brinell.Interface` or a dictionary.
            title: copied into the results.
            grid: its cells, `brinell.Grid` or a dictionary.
            solver: `brinell.Solver` or a dictionary.
            output: what is stored, `brinell.Output` or a dictionary.

        Raises:
            InputError: with all problems found.
        """
        table = {
            "interference": interference,
            "load": load,
            "normalised": normalised,
            "passes": passes,
            "shift": shift,
            "kinematics": kinematics,
        }
        super().__init__(lower, upper, table, title=title, grid=grid, solver=solver, output=output, interface=interface)


class Indentation(_Scenario):
    """The upper body is pressed into the lower one and lifted off again, at one place or at several."""

    _table = "indentation"

    def __init__(
        self,
        lower: Body,
        upper: Body,
        *,
        load: Sequence[Quantity] | None = None,
        approach: Sequence[Quantity] | None = None,
        pressure: Sequence[Quantity] | None = None,
        mean_gap: Sequence[Quantity] | None = None,
        normalised: bool = False,
        steps: int | None = None,
        cycles: int | None = None,
        places: Sequence[Quantity] | None = None,
        title: str | None = None,
        grid: Grid | Mapping[str, Any] | None = None,
        solver: Solver | Mapping[str, Any] | None = None,
        output: Output | Mapping[str, Any] | None = None,
    ):
        """Describes an indentation.

        Args:
            lower: the body that is indented.
            upper: the indenter.
            load: loads to be reached one after the other, from none: ["10 N", 0] presses and lifts off.
            approach: instead, approaches of the bodies from the touch of the undeformed ones.
            pressure: instead, means over the period of a grid that is periodic along both axes.
            mean_gap: instead, means of the gap over that period: the smaller, the more they are pressed.
            normalised: whether loads or approaches are in their values at first yield, P_c and alpha_c.
            steps: from one entry of the list to the next.
            cycles: how often the list is gone through at each place.
            places: along x, indented one after the other.
            title: copied into the results.
            grid: its cells, `brinell.Grid` or a dictionary.
            solver: `brinell.Solver` or a dictionary.
            output: what is stored, `brinell.Output` or a dictionary.

        Raises:
            InputError: with all problems found.
        """
        table = {
            "load": load,
            "approach": approach,
            "pressure": pressure,
            "mean_gap": mean_gap,
            "normalised": normalised,
            "steps": steps,
            "cycles": cycles,
            "places": places,
        }
        super().__init__(lower, upper, table, title=title, grid=grid, solver=solver, output=output)


class Rolling(_Scenario):
    """The upper body, pressed on the lower one, rolls over it along x, pass after pass."""

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
        passes: int | None = None,
        slide_to_roll: float | None = None,
        shift: Quantity | None = None,
        load_steps: int | None = None,
        interface: Interface | Mapping[str, Any] | None = None,
        title: str | None = None,
        grid: Grid | Mapping[str, Any] | None = None,
        solver: Solver | Mapping[str, Any] | None = None,
        output: Output | Mapping[str, Any] | None = None,
    ):
        """Describes a rolling; one of load, hertz_pressure and approach is given.

        Args:
            lower: the body that is rolled over.
            upper: the body that rolls.
            distance: length of the track on the lower body.
            load: kept while rolling.
            hertz_pressure: the load by the peak pressure that it would have in elastic contact.
            approach: kept while rolling, instead of a load.
            passes: how often the track is rolled over.
            slide_to_roll: difference over mean of the speeds of both surfaces; 0: pure rolling.
            shift: by which the contact moves on the lower body per step.
            load_steps: in which the upper body is pressed on before a pass and lifted off after it.
            interface: friction, `brinell.Interface` or a dictionary.
            title: copied into the results.
            grid: its cells, `brinell.Grid` or a dictionary.
            solver: `brinell.Solver` or a dictionary.
            output: what is stored, `brinell.Output` or a dictionary.

        Raises:
            InputError: with all problems found.
        """
        table = {
            "distance": distance,
            "load": load,
            "hertz_pressure": hertz_pressure,
            "approach": approach,
            "passes": passes,
            "slide_to_roll": slide_to_roll,
            "shift": shift,
            "load_steps": load_steps,
        }
        super().__init__(lower, upper, table, title=title, grid=grid, solver=solver, output=output, interface=interface)
