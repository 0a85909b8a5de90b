# SPDX-License-Identifier: BSD-3-Clause
"""Error messages for wrong arguments of the public classes: allowed arguments and a suggestion instead of a TypeError.

Python 3.13 suggests a name, too, but it neither lists the allowed arguments nor searches the tables of a scenario, and
earlier versions suggest nothing.
"""

from __future__ import annotations

import functools
import inspect
import reprlib
from collections.abc import Callable, Mapping
from dataclasses import fields
from types import ModuleType
from typing import Any

from brinell._names import did_you_mean
from brinell.errors import ArgumentError

__all__ = ["explain_argument_errors", "explain_errors_of"]


def explain_argument_errors(module: ModuleType) -> None:
    """Makes the public classes of a module raise `ArgumentError` for wrong arguments.

    Args:
        module: its `__all__` names the classes; other names are left alone.
    """
    for name in module.__all__:
        explain_errors_of(vars(module).get(name), f"{module.__name__}.{name}")


def explain_errors_of(found: object, name: str) -> None:
    """The same for one class; nothing for what is no class.

    Args:
        found: the class.
        name: what the messages call it.
    """
    if isinstance(found, type) and inspect.isfunction(vars(found).get("__init__")):
        _explain_errors_of(found, name)


def _explain_errors_of(kind: type, name: str) -> None:
    original: Callable[..., None] = vars(kind)["__init__"]
    if issubclass(kind, Exception) or hasattr(original, "explains_argument_errors"):
        return

    @functools.wraps(original)
    def initialise(self: object, *args: Any, **given: Any) -> None:
        try:
            original(self, *args, **given)
        except TypeError:
            if reason := _reason(original, args, given, kind):
                raise ArgumentError(f"{name}: {reason}") from None
            raise

    initialise.explains_argument_errors = True  # type: ignore[attr-defined]
    kind.__init__ = initialise  # type: ignore[method-assign]


def _reason(function: Callable[..., None], args: tuple[Any, ...], given: Mapping[str, Any], kind: type) -> str:
    """Describes what is wrong with the arguments of a method; empty if they fit, so the error came from inside it."""
    _, *parameters = inspect.signature(function).parameters.values()
    known = {parameter.name: parameter for parameter in parameters}
    by_place = [name for name, one in known.items() if one.kind is inspect.Parameter.POSITIONAL_OR_KEYWORD]
    allowed = f"allowed: {', '.join(known) or 'none'}"
    unknown = [name for name in given if name not in known]
    if unknown:
        found = ", ".join(f"{name} = {reprlib.repr(given[name])}" for name in unknown)
        hints = "".join(_hint(name, known, kind) for name in unknown)
        return f"unknown argument{'s' if len(unknown) > 1 else ''} {found}; {hints}{allowed}"
    if len(args) > len(by_place):
        places = f"allowed: {', '.join(by_place)}; by name: " if by_place else "allowed, by name: "
        named = ", ".join(name for name in known if name not in by_place) or "none"
        retired = "".join(f"; {why}" for why in getattr(kind, "_retired", {}).values())
        return f"{len(args)} argument{'s' if len(args) > 1 else ''} without a name; {places}{named}{retired}"
    if twice := [name for name in by_place[: len(args)] if name in given]:
        return f"{', '.join(twice)} given twice, without and with the name; keep one"
    missing = [name for name, one in known.items() if one.default is one.empty and name not in given]
    if missing := [name for name in missing if name not in by_place[: len(args)]]:
        return f"missing {', '.join(missing)}; {allowed}"
    return ""


def _hint(name: str, known: Mapping[str, Any], kind: type) -> str:
    """Hint for an unknown argument: what replaced it, a similar name, or the table of the case to which it belongs."""
    if why := getattr(kind, "_retired", {}).get(name):
        return f"{why}; "
    for part, part_kind in getattr(kind, "_parts", {}).items():
        if part in known and name in [field.name for field in fields(part_kind)]:
            return f"{name} belongs into {part} = brinell.{part_kind.__name__}({name}=...); "
    return did_you_mean(name, known, alike=0.8) or did_you_mean(name, known, most=3)
