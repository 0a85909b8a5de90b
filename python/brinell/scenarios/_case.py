# SPDX-License-Identifier: BSD-3-Clause
"""Base class of the scenario classes: a case whose text is generated from Python arguments."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import Any, ClassVar

import tomli_w

from brinell._values import HeightMaps, plain
from brinell.bodies import Body
from brinell.case import Case, in_arguments
from brinell.errors import InputError
from brinell.settings import Grid, Heating, Interface, Output, Solver

__all__ = ["ScenarioCase"]


class ScenarioCase(Case):
    """A case whose text is generated from Python arguments."""

    _table: str
    _parts: ClassVar[dict[str, type]] = {
        "interface": Interface,
        "thermal": Heating,
        "grid": Grid,
        "solver": Solver,
        "output": Output,
    }

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
        thermal: Heating | Mapping[str, Any] | None = None,
    ):
        for name, body in (("lower", lower), ("upper", upper)):
            if not isinstance(body, Body):
                raise InputError(f"{name} = {body!r}; allowed: a brinell.Body")
        parts = {"interface": interface, "thermal": thermal, "grid": grid, "solver": solver, "output": output}
        for name, part in parts.items():
            kind = self._parts[name]
            if not (part is None or isinstance(part, kind | Mapping)):
                raise InputError(f"{name} = {part!r}; allowed: a brinell.{kind.__name__}, a dictionary, or None")
        values = {
            "scenario": self._table,
            "title": title,
            "lower": lower.parts(),
            "upper": upper.parts(),
            self._table: table,
            **parts,
        }
        try:
            maps: HeightMaps = {}
            text = tomli_w.dumps(plain(values, maps))
            super().__init__(text, file=Path(f"{self._table}.toml"), names_lines=False, maps=maps)
        except InputError as error:  # the keys of the scenario's own table are arguments here
            raise type(error)(in_arguments(str(error), self._table)) from None
