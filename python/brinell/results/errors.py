# SPDX-License-Identifier: BSD-3-Clause
"""The error `RunError` of this package, and the version of the results format that it reads."""

from __future__ import annotations

import contextlib
from collections.abc import Iterator, Sequence

from brinell import _core
from brinell.summary import RunError

__all__ = ["FORMAT_VERSION", "RunError", "listed", "one_line", "other_version", "reports_damage"]

FORMAT_VERSION: int = _core.FORMAT_VERSION
"""Version of the results format that this package reads."""


def one_line(error: BaseException) -> str:
    """An exception's message on one line."""
    return " ".join(str(error.args[0] if error.args else error).split())


@contextlib.contextmanager
def reports_damage(path: object, part: str = "it") -> Iterator[None]:
    """Converts exceptions of h5py and NumPy while a damaged file is read to a `RunError` that names the file.

    Args:
        path: path of the file.
        part: part of the file that is read.
    """
    try:
        yield
    except RunError:
        raise
    except (ArithmeticError, AttributeError, LookupError, OSError, RuntimeError, TypeError, ValueError) as error:
        raise RunError(f"{path}: {part} is damaged ({one_line(error)})") from error


def listed(names: Sequence[object]) -> str:
    """Names for a message, separated by commas; "none" if there is none."""
    return ", ".join(map(str, names)) if names else "none"


def other_version(place: object, version: object) -> RunError:
    """Error of a result whose format version is not the one that this package reads."""
    return RunError(
        f"{place}: has format version {version}, but this brinell reads version {FORMAT_VERSION}; compute the run "
        "again, or open it with the brinell that wrote it"
    )
