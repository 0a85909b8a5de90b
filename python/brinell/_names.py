# SPDX-License-Identifier: BSD-3-Clause
"""Suggestions for misspelt names, and renamed arguments, attributes and columns.

An old name is accepted for one more version, with a `FutureWarning`. Keys of the case file are renamed in the engine
(`_core.old_names`). The table for users is in docs/user-guide.md, "Names that have changed".
"""

from __future__ import annotations

import difflib
import functools
import inspect
import warnings
from collections.abc import Callable, Iterable
from pathlib import Path
from typing import Any, TypeVar

from brinell.errors import InputError

__all__ = ["did_you_mean", "level_of_caller", "renamed", "warn_of_old_name"]

_T = TypeVar("_T")


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


def warn_of_old_name(old: str, new: str) -> None:
    """Issues a `FutureWarning` at the line outside this package that uses an old name."""
    text = f"{old} is now called {new}: the old name is understood in this version still, not in the next one"
    warnings.warn(text, FutureWarning, stacklevel=level_of_caller())


def renamed(**names: str) -> Callable[[type[_T]], type[_T]]:
    """Decorates a class so that it accepts old names of its arguments and of the corresponding attributes.

    Args:
        names: new names by old name.
    """

    def decorate(kind: type[_T]) -> type[_T]:
        original: Callable[..., None] = vars(kind)["__init__"]

        @functools.wraps(original)
        def initialise(self: _T, *args: Any, **given: Any) -> None:
            for old, new in names.items():
                if old in given and new in given:
                    raise InputError(f"{old} is an old name of {new}, which is given, too; keep {new}")
                if old in given:
                    warn_of_old_name(old, new)
                    given[new] = given.pop(old)
            original(self, *args, **given)

        initialise.old_names = names  # type: ignore[attr-defined]
        kind.__init__ = initialise  # type: ignore[method-assign,assignment]
        for old, new in names.items():
            setattr(kind, old, property(functools.partial(_attribute, old, new), doc=f"The old name of `{new}`."))
        return kind

    return decorate


def _attribute(old: str, new: str, owner: object) -> Any:
    warn_of_old_name(old, new)
    return getattr(owner, new)


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
