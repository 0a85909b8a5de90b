# SPDX-License-Identifier: BSD-3-Clause
"""The kinds of error, the same as in the engine."""

__all__ = [
    "ArgumentError",
    "BrinellError",
    "ConvergenceError",
    "GridError",
    "InputError",
    "InternalError",
    "IoError",
    "MissingExtraError",
]


class BrinellError(Exception):
    """Any error of brinell; its text is for the user."""


class InputError(BrinellError, ValueError):
    """What was given cannot be computed: a bad key, value, unit or combination; says where and what is allowed."""


class ArgumentError(InputError, TypeError):
    """A class has no such argument, or lacks one; says which, what was probably meant and what there is."""


class GridError(InputError):
    """The grid, given or automatic, does not suit the case."""


class ConvergenceError(BrinellError, RuntimeError):
    """An increment did not reach its tolerance, also after splitting; finished steps are kept."""


class IoError(BrinellError, OSError):
    """A file could not be read or written."""


class InternalError(BrinellError):
    """A bug of brinell, please report it."""


class MissingExtraError(BrinellError, ImportError):
    """What was asked for needs a package that is not installed."""

    def __init__(self, what: str, package: str, extra: str):
        """Says how to install it.

        Args:
            what: needs it.
            package: its name.
            extra: of brinell that brings it.
        """
        super().__init__(f'{what} needs {package}, which is not installed: pip install "brinell[{extra}]"')
