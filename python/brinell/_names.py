# SPDX-License-Identifier: BSD-3-Clause
"""Suggestions for misspelt names, and the line of the caller that a warning is about."""

from __future__ import annotations

import difflib
import inspect
from collections.abc import Iterable
from pathlib import Path

__all__ = ["did_you_mean", "level_of_caller"]


def did_you_mean(name: object, known: Iterable[str], most: int = 1, alike: float = 0.6) -> str:
    """Suggestion for an unknown name, such as "did you mean stress_xx? "; empty if no name is similar.

    Args:
        name: the unknown name.
        known: names that exist.
        most: largest number of suggestions.
        alike: least similarity of a suggestion, from 0 to 1.
    """
    near = difflib.get_close_matches(str(name), list(known), n=most, cutoff=alike)
    return f"did you mean {' or '.join(near)}? " if near else ""


def level_of_caller() -> int:
    """Stack level (for `warnings.warn` in the calling function) of the nearest code outside this package."""
    package = str(Path(__file__).parent)
    level = 1
    frame = inspect.currentframe()
    # The generated __init__ of a dataclass has "<string>" as its file name.
    while frame is not None and frame.f_code.co_filename.startswith((package, "<string>")):
        frame = frame.f_back
        level += 1
    return max(1, level - 1)
