# SPDX-License-Identifier: BSD-3-Clause
"""Materials are checked where those of a case file are."""

from __future__ import annotations

from typing import Any

import tomli_w

from brinell import _core
from brinell._values import plain
from brinell.case import in_arguments
from brinell.errors import InputError

__all__ = ["case_of"]


def case_of(material: dict[str, Any]) -> _core.Case:
    """A case of which only the material of the lower body counts.

    Raises:
        InputError: a value, unit or combination that the case file would not allow; names the keys of the material.
    """
    ball = {"type": "sphere", "radius": 1.0}
    values = {
        "scenario": "indentation",
        "lower": {"shape": ball, "material": material},
        "upper": {"shape": ball, "material": {"rigid": True}},
        "indentation": {"load": [1e-15]},  # a contact that needs few cells, however soft the material is
    }
    try:
        return _core.parse_case(tomli_w.dumps(plain(values)), "material", [], {}, names_lines=False)
    except InputError as error:
        raise InputError(in_arguments(str(error)).replace("lower.material", "material")) from None
