# SPDX-License-Identifier: BSD-3-Clause
"""The one error of this package, and the version of the format that it reads."""

from __future__ import annotations

from collections.abc import Sequence

__all__ = ["FORMAT_VERSION", "RunError", "listed", "one_line"]

FORMAT_VERSION = 1
"""Version of the results format that this package reads."""


class RunError(Exception):
    """A folder is not a readable result; the text is one line for the user."""


def one_line(error: BaseException) -> str:
    """An exception's message on one line."""
    return " ".join(str(error.args[0] if error.args else error).split())


def listed(names: Sequence[object]) -> str:
    """Names for a message, separated by commas; "none" if there is none."""
    return ", ".join(map(str, names)) if names else "none"
