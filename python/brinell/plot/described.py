# SPDX-License-Identifier: BSD-3-Clause
"""What figures have in common in their descriptions."""

from __future__ import annotations

import inspect
import re
from collections.abc import Callable
from typing import Any

__all__ = ["described"]

_ARGUMENTS = {
    "runs": "results, or a sweep.",
    "run": "result to draw.",
    "snapshot": "the state to draw.",
    "cells": "show each cell as a rectangle of one colour instead of interpolating between their centres.",
    "ax": "axes of the caller, one per panel, or a figure, to draw into; None: a new figure.",
}
_SECTION = re.compile(r"(?:^|\n)Args:\n((?:    .*(?:\n|$))+)")
_ENTRY = re.compile(r"^    (\w+): .*(?:\n {5,}.*)*", re.MULTILINE)


def described(draw: Callable[..., Any]) -> str:
    """The docstring of a figure with all of its arguments, its own and those that figures have in common."""
    text = inspect.cleandoc(draw.__doc__ or "")
    section = _SECTION.search(text)
    entries = {entry[1]: entry[0] for entry in _ENTRY.finditer(section[1])} if section else {}
    for name, meaning in _ARGUMENTS.items():
        entries.setdefault(name, f"    {name}: {meaning}")
    arguments = "\n".join(entries[name] for name in inspect.signature(draw).parameters if name in entries)
    if section:
        return text[: section.start(1)] + arguments + "\n" + text[section.end(1) :]
    others = re.search(r"\n\n(?:Raises|Returns):\n", text)
    end = others.start() if others else len(text)
    return f"{text[:end]}\n\nArgs:\n{arguments}\n{text[end:]}" if arguments else text
