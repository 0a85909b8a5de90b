# SPDX-License-Identifier: BSD-3-Clause
"""What commands share: how errors and warnings are told, and where to write beside a result."""

from __future__ import annotations

import contextlib
import functools
import warnings
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import IO, Any, ParamSpec, TextIO, TypeVar

import click

from brinell.case import CaseWarning
from brinell.errors import BrinellError, InputError

__all__ = ["CommandError", "folder_of", "tells_errors", "tells_warnings"]

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


@contextlib.contextmanager
def tells_warnings(about: object = None, words: Callable[[str], str] = str) -> Iterator[None]:
    """What is warned of within is told in lines as those of the C++ program; the same thing once.

    Args:
        about: the file that comes before the warning; None: it names one itself.
        words: makes those of the command line of a text.
    """
    told: set[str] = set()

    def tell(
        message: Warning | str,
        category: type[Warning],
        filename: str,
        lineno: int,
        file: TextIO | None = None,
        line: str | None = None,
    ) -> None:
        prefix = "brinell: warning" if issubclass(category, CaseWarning | FutureWarning) else category.__name__
        said = words(str(message))
        text = f"{prefix}: {said}" if about is None else f"{prefix}: {about}: {said}"
        if text not in told:
            click.echo(text, err=True)
        told.add(text)

    with warnings.catch_warnings():
        warnings.showwarning = tell
        yield


def folder_of(run: Path) -> Path:
    """The folder of a result, which may be given by its file."""
    return run.parent if run.is_file() else run
