# SPDX-License-Identifier: BSD-3-Clause
"""The command ``brinell``.

The engine's commands (run, check, schema, new, cite), the help and the messages are those of the C++ program, which
declares the options once; they need no other module of this package. The others are click commands (`python_commands`),
imported when they are called.
"""

from __future__ import annotations

import os
import signal
import sys
from collections.abc import Sequence
from typing import NoReturn

__all__ = ["main"]

COMMANDS = {
    "plot": "brinell.plot.cli:plot",
    "report": "brinell.report.cli:report",
    "sweep": "brinell.sweeps.cli:command",
    "fit": "brinell.fits.cli:command",
    "app": "brinell.app.cli:command",
    "surface": "brinell.surface_commands:surface",
    "material": "brinell.material_commands:material",
    "export": "brinell.export:export",
    "completion": "brinell.completion:command",
}
"""Commands of this package, and where they are."""

FAILURE, BAD_INPUT, INTERRUPTED = 1, 2, 130
"""Exit codes, as in the C++ program."""

COMPLETING = "_BRINELL_COMPLETE"
"""Environment variable that the shell's script sets when it asks for completions."""


def main(arguments: Sequence[str] | None = None) -> NoReturn:
    """Runs the command and ends the process with its exit code.

    Args:
        arguments: command line without the program's name; None: the arguments of the process.
    """
    signal.signal(signal.SIGPIPE, signal.SIG_DFL)  # `brinell schema | head` ends quietly, as the C++ program does
    try:
        from brinell import _core
    except ImportError as error:  # the processor cannot be what BRINELL_PROCESSOR says
        sys.exit(report(str(error), BAD_INPUT))
    if COMPLETING in os.environ:
        from brinell import completion, python_commands

        completion.answer(python_commands.root)
    arguments = sys.argv[1:] if arguments is None else list(arguments)
    not_utf8 = [word for word in arguments if not _is_utf8(word)]
    if not_utf8:
        sys.exit(report(f"the argument {os.fsencode(not_utf8[0])!r} is not UTF-8", BAD_INPUT))
    if arguments and arguments[0] in COMMANDS:
        from brinell import python_commands

        run = python_commands.root.main
        sys.exit(python_commands.guarded(lambda: run(arguments, "brinell", standalone_mode=False)))
    signal.signal(signal.SIGINT, signal.SIG_DFL)  # the engine installs its own handler to stop a run
    sys.exit(_core.command_line(arguments))


def _is_utf8(word: str) -> bool:
    """Whether an argument was valid UTF-8; Python decodes other bytes as surrogates, which cannot be encoded."""
    try:
        word.encode()
    except UnicodeEncodeError:
        return False
    return True


def report(text: str, exit_code: int = FAILURE) -> int:
    """Prints each line of an error message with the name of the program in front, as the C++ program does."""
    for line in text.split("\n"):
        print(f"brinell: error: {line}", file=sys.stderr)
    return exit_code
