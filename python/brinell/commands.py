# SPDX-License-Identifier: BSD-3-Clause
"""Helpers of the commands: reporting of errors and warnings, and the folder of a result."""

from __future__ import annotations

import contextlib
import functools
import warnings
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import IO, Any, ParamSpec, TextIO, TypeVar

import click

from brinell.case import CaseWarning, ResolutionWarning
from brinell.errors import BrinellError, InputError

__all__ = ["CommandError", "folder_of", "reports_errors", "reports_warnings"]

_P = ParamSpec("_P")
_R = TypeVar("_R")


class CommandError(click.ClickException):
    """Error that is printed as one line on stderr; exit code 1, for example if a file cannot be written."""

    exit_code = 1

    def show(self, file: IO[Any] | None = None) -> None:
        """Prints the error."""
        click.echo(f"brinell: error: {self.message}", file=file, err=file is None)


class RequestError(CommandError):
    """Error in the request or in a result; exit code 2."""

    exit_code = 2


def reports_errors(command: Callable[_P, _R]) -> Callable[_P, _R]:
    """Decorates a command so that errors that the user can fix are printed as one line, without a traceback."""

    @functools.wraps(command)
    def wrapper(*args: _P.args, **kwargs: _P.kwargs) -> _R:
        try:
            return command(*args, **kwargs)
        except (BrinellError, OSError) as error:
            raise (RequestError if isinstance(error, InputError) else CommandError)(str(error)) from error

    return wrapper


_OF_THE_PROGRAM = (CaseWarning, ResolutionWarning, FutureWarning)
"""Warnings that are printed like those of the C++ program."""


@contextlib.contextmanager
def reports_warnings(about: object = None, words: Callable[[str], str] = str) -> Iterator[None]:
    """Prints warnings as lines in the style of the C++ program, each text only once.

    Args:
        about: file that is named in front of the warning; None: the text names its file itself.
        words: function that translates a text to the terms of the command line.
    """
    printed: set[str] = set()

    def print_once(
        message: Warning | str,
        category: type[Warning],
        filename: str,
        lineno: int,
        file: TextIO | None = None,
        line: str | None = None,
    ) -> None:
        prefix = "brinell: warning" if issubclass(category, _OF_THE_PROGRAM) else category.__name__
        translated = words(str(message))
        text = f"{prefix}: {translated}" if about is None else f"{prefix}: {about}: {translated}"
        if text not in printed:
            click.echo(text, err=True)
        printed.add(text)

    with warnings.catch_warnings():
        warnings.showwarning = print_once
        yield


def folder_of(run: Path) -> Path:
    """Folder of a result that is given by its folder or its file."""
    return run.parent if run.is_file() else run
