# SPDX-License-Identifier: BSD-3-Clause
"""Names that are misspelt, and names that have changed.

Old names are understood for a version, with a `FutureWarning`.
Keys of the case file are renamed in the engine (`_core.old_names`); this is for arguments, attributes and columns. The
table for users is in docs/user-guide.md, "Names that have changed".
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

__all__ = ["did_you_mean", "level_of_caller", "renamed", "tell_old_name"]

_T = TypeVar("_T")


def did_you_mean(name: object, known: Iterable[str], most: int = 1, alike: float = 0.6) -> str:
    """What may be meant by a name that is none: "did you mean stress_xx? ", or nothing.

    Args:
        name: as it was given.
        known: the names that there are.
        most: of those that are told.
        alike: how much they have to be, from 0 to 1.
    """
    near = difflib.get_close_matches(str(name), list(known), n=most, cutoff=alike)
    return f"did you mean {' or '.join(near)}? " if near else ""


def tell_old_name(old: str, new: str) -> None:
    """Warns the code outside this package that it uses an old name."""
    text = f"{old} is now called {new}: the old name is understood in this version still, not in the next one"
    warnings.warn(text, FutureWarning, stacklevel=level_of_caller())


def renamed(**names: str) -> Callable[[type[_T]], type[_T]]:
    """Lets a class understand old names of its arguments, and of the attributes that hold them.

    Args:
        names: the new name by the old one.
    """

    def decorate(kind: type[_T]) -> type[_T]:
        original: Callable[..., None] = vars(kind)["__init__"]

        @functools.wraps(original)
        def initialise(self: _T, *args: Any, **given: Any) -> None:
            for old, new in names.items():
                if old in given and new in given:
                    raise InputError(f"{old} is an old name of {new}, which is given, too; keep {new}")
                if old in given:
                    tell_old_name(old, new)
                    given[new] = given.pop(old)
            original(self, *args, **given)

        initialise.old_names = names  # type: ignore[attr-defined]
        kind.__init__ = initialise  # type: ignore[method-assign,assignment]
        for old, new in names.items():
            setattr(kind, old, property(functools.partial(_attribute, old, new), doc=f"The old name of `{new}`."))
        return kind

    return decorate


def _attribute(old: str, new: str, owner: object) -> Any:
    tell_old_name(old, new)
    return getattr(owner, new)


def level_of_caller() -> int:
    """How far above the function that calls this one the code is that is not of this package."""
    package = str(Path(__file__).parent)
    level = 1
    frame = inspect.currentframe()
    # The __init__ of a dataclass has no file.
    while frame is not None and frame.f_code.co_filename.startswith((package, "<string>")):
        frame = frame.f_back
        level += 1
    return max(1, level - 1)
