# SPDX-License-Identifier: BSD-3-Clause
"""The command ``brinell``.

The engine's commands (run, check, schema, new, cite), the help and the messages are those of the C++ program, which
declares the options once. The others are click commands of this package, imported when they are called.
"""

from __future__ import annotations

import importlib
import os
import signal
import sys
from collections.abc import Callable, Sequence
from typing import Any, NoReturn

import click
from click.shell_completion import CompletionItem

from brinell import _core, completion
from brinell.errors import BrinellError, ConvergenceError, GridError, InputError, InternalError, MissingExtraError

__all__ = ["main", "root"]

COMMANDS = {
    "plot": "brinell.plot.cli:plot",
    "report": "brinell.report.cli:report",
    "sweep": "brinell.sweeps.cli:command",
    "surface": "brinell.surface_commands:surface",
    "export": "brinell.export:export",
    "completion": "brinell.completion:command",
}
"""Commands of this package, and where they are."""

FAILURE, BAD_INPUT, INTERRUPTED = 1, 2, 130
"""Exit codes, as in the C++ program."""


class Commands(click.Group):
    """All commands by name; the engine's commands are in this group only for shell completion."""

    def list_commands(self, ctx: click.Context) -> list[str]:
        """Names of the commands in the order of the help."""
        return [command.name for command in _core.commands()]

    def get_command(self, ctx: click.Context, cmd_name: str) -> click.Command | None:
        """Returns a command by its name; the module of a Python command is imported only here."""
        if cmd_name in COMMANDS:
            module, name = COMMANDS[cmd_name].split(":")
            command: click.Command = getattr(importlib.import_module(module), name)
            return command
        return next((completion.engine_command(c) for c in _core.commands() if c.name == cmd_name), None)

    def shell_complete(self, ctx: click.Context, incomplete: str) -> list[CompletionItem]:
        """Completes names of commands and options, without importing the commands."""
        named = [CompletionItem(c.name, help=c.help) for c in _core.commands() if c.name.startswith(incomplete)]
        return named + click.Command.shell_complete(self, ctx, incomplete)


root = Commands(
    "brinell",
    params=[
        click.Option(["--version"], is_flag=True, help="Display program version information and exit"),
        click.Option(["--licenses"], is_flag=True, help="Display the licences of brinell and its libraries and exit"),
    ],
    context_settings={"help_option_names": ["-h", "--help"]},
)


def main(arguments: Sequence[str] | None = None) -> NoReturn:
    """Runs the command and ends the process with its exit code.

    Args:
        arguments: command line without the program's name; None: the arguments of the process.
    """
    signal.signal(signal.SIGPIPE, signal.SIG_DFL)  # `brinell schema | head` ends quietly, as the C++ program does
    completion.answer(root)
    arguments = sys.argv[1:] if arguments is None else list(arguments)
    not_utf8 = [word for word in arguments if not _is_utf8(word)]
    if not_utf8:
        sys.exit(_report(f"the argument {os.fsencode(not_utf8[0])!r} is not UTF-8", BAD_INPUT))
    if arguments and arguments[0] in COMMANDS:
        sys.exit(guarded(lambda: root.main(arguments, "brinell", standalone_mode=False)))
    signal.signal(signal.SIGINT, signal.SIG_DFL)  # the engine installs its own handler to stop a run
    sys.exit(_core.command_line(arguments))


def _is_utf8(word: str) -> bool:
    """Whether an argument was valid UTF-8; Python decodes other bytes as surrogates, which cannot be encoded."""
    try:
        word.encode()
    except UnicodeEncodeError:
        return False
    return True


def guarded(command: Callable[[], Any]) -> int:
    """Runs a command of this package and prints its errors as lines on stderr.

    Args:
        command: function that returns an exit code; any other value means success.

    Returns:
        The exit code.
    """
    try:
        code = command()
    except click.exceptions.NoArgsIsHelpError as error:
        click.echo(error.format_message(), err=True)
        return BAD_INPUT
    except click.UsageError as error:
        _report(error.format_message())
        click.echo(f"Run {error.ctx.command_path if error.ctx else 'brinell'} --help for more information.", err=True)
        return BAD_INPUT
    except click.ClickException as error:
        return _report(error.format_message(), error.exit_code)
    except (click.Abort, KeyboardInterrupt):
        return INTERRUPTED
    except GridError as error:  # a computation could not continue, although the input is valid
        return _report(str(error))
    except (InputError, MissingExtraError) as error:
        return _report(str(error), BAD_INPUT)
    except ConvergenceError as error:
        return _report(f"no convergence: {error}")
    except InternalError as error:
        return _report(f"internal error, a bug of brinell, please report it: {error}")
    except (BrinellError, OSError) as error:
        return _report(str(error))
    return code if isinstance(code, int) else 0


def _report(text: str, exit_code: int = FAILURE) -> int:
    """Prints each line of an error message with the name of the program in front, as the C++ program does."""
    for line in text.split("\n"):
        click.echo(f"brinell: error: {line}", err=True)
    return exit_code
