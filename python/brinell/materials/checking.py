# SPDX-License-Identifier: BSD-3-Clause
"""Validation of materials by the engine's reader of case files."""

from __future__ import annotations

from typing import Any

import tomli_w

from brinell import _core
from brinell._values import plain
from brinell.case import in_arguments
from brinell.errors import InputError

__all__ = ["case_of"]


def case_of(material: dict[str, Any]) -> _core.Case:
    """Parsed case whose lower body has the material; the rest of the case is arbitrary.

    Raises:
        InputError: a value, unit or combination that the case file does not allow; the text names the material's keys.
    """
    ball = {"type": "sphere", "radius": 1.0}
    values = {
        "scenario": "indentation",
        "lower": {"shape": ball, "material": material},
        "upper": {"shape": ball, "material": {"rigid": True}},
        "indentation": {"load": [1e-15]},  # a contact that needs few cells for any material
    }
    try:
        return _core.parse_case(tomli_w.dumps(plain(values)), "material", [], {}, names_lines=False)
    except InputError as error:
        raise InputError(in_arguments(str(error)).replace("lower.material", "material")) from None
