# SPDX-License-Identifier: BSD-3-Clause
"""What the commands of plots and reports share: how an error is told, and where to write beside a result."""

from __future__ import annotations

import functools
from collections.abc import Callable
from pathlib import Path
from typing import IO, Any, ParamSpec, TypeVar

import click

from brinell.errors import BrinellError, InputError

__all__ = ["CommandError", "folder_of", "tells_errors"]

_P = ParamSpec("_P")
_R = TypeVar("_R")


class CommandError(click.ClickException):
    """An error in one line on the standard error stream; exit code 1: a file cannot be written."""

    exit_code = 1

    def show(self, file: IO[Any] | None = None) -> None:
        """Writes the line."""
        click.echo(f"brinell: error: {self.message}", file=file, err=file is None)


class RequestError(CommandError):
    """Something about the request or a result is wrong."""

    exit_code = 2


def tells_errors(command: Callable[_P, _R]) -> Callable[_P, _R]:
    """Decorator of a command: what the user can mend is told in one line, without a traceback."""

    @functools.wraps(command)
    def wrapper(*args: _P.args, **kwargs: _P.kwargs) -> _R:
        try:
            return command(*args, **kwargs)
        except (BrinellError, OSError) as error:
            raise (RequestError if isinstance(error, InputError) else CommandError)(str(error)) from error

    return wrapper


def folder_of(run: Path) -> Path:
    """The folder of a result, which may be given by its file."""
    return run.parent if run.is_file() else run
