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

    def __init__(self, arguments: Mapping[str, Any]):
        """Makes a case.

        Args:
            arguments: those of the constructor of the scenario, which may be all of its local variables: bodies, title,
                settings, and the keys of the scenario's own table.
        """
        for name in ("lower", "upper"):
            if not isinstance(body := arguments[name], Body):
                raise InputError(f"{name} = {body!r}; allowed: a brinell.Body")
        for name, kind in self._parts.items():
            if not isinstance(part := arguments.get(name), kind | Mapping | None):
                raise InputError(f"{name} = {part!r}; allowed: a brinell.{kind.__name__}, a dictionary, or None")
        known = {"self", "title", "lower", "upper", *self._parts}
        values = {
            "scenario": self._table,
            "title": arguments["title"],
            "lower": arguments["lower"].parts(),
            "upper": arguments["upper"].parts(),
            self._table: {name: value for name, value in arguments.items() if name not in known},
            **{name: arguments.get(name) for name in self._parts},
        }
        try:
            maps: HeightMaps = {}
            text = tomli_w.dumps(plain(values, maps))
            super().__init__(text, file=Path(f"{self._table}.toml"), names_lines=False, maps=maps)
        except InputError as error:  # the keys of the scenario's own table are arguments here
            raise type(error)(in_arguments(str(error), self._table)) from None
