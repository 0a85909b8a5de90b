# SPDX-License-Identifier: BSD-3-Clause
"""Exceptions of brinell, with the same kinds as in the engine."""

__all__ = [
    "ArgumentError",
    "BrinellError",
    "ConvergenceError",
    "DeviceError",
    "GridError",
    "InputError",
    "InternalError",
    "IoError",
    "MissingExtraError",
]


class BrinellError(Exception):
    """Base class of all errors of brinell; the text is written for the user."""


class InputError(BrinellError, ValueError):
    """Invalid input: a wrong key, value, unit or combination. The text says where, and what is allowed."""


class ArgumentError(InputError, TypeError):
    """Unknown or missing argument of a class. The text names it, suggests a similar name and lists what is allowed."""


class GridError(InputError):
    """The given or automatic grid is not suitable for the case, for example too small or too large."""


class ConvergenceError(BrinellError, RuntimeError):
    """An increment did not reach its tolerance, even after it was split; finished steps are kept."""


class IoError(BrinellError, OSError):
    """A file could not be read or written."""


class DeviceError(BrinellError, RuntimeError):
    """A GPU is missing, does not suit or has failed; finished steps are kept."""


class InternalError(BrinellError):
    """A bug in brinell; please report it."""


class MissingExtraError(BrinellError, ImportError):
    """A function needs an optional package that is not installed."""

    def __init__(self, what: str, package: str, extra: str):
        """Makes the message, with the command that installs the package.

        Args:
            what: function or feature that needs the package.
            package: name of the package.
            extra: extra of brinell that installs the package.
        """
        super().__init__(f'{what} needs {package}, which is not installed: pip install "brinell[{extra}]"')
