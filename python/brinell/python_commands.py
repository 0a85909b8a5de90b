# SPDX-License-Identifier: BSD-3-Clause
"""The commands of the Python package as click commands, with the engine's commands beside them for shell completion."""

from __future__ import annotations

import importlib
from collections.abc import Callable
from typing import Any

import click
from click.shell_completion import CompletionItem

from brinell import _core, completion
from brinell.cli import BAD_INPUT, COMMANDS, INTERRUPTED, report
from brinell.errors import BrinellError, ConvergenceError, GridError, InputError, InternalError, MissingExtraError

__all__ = ["guarded", "root"]


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
        report(error.format_message())
        click.echo(f"Run {error.ctx.command_path if error.ctx else 'brinell'} --help for more information.", err=True)
        return BAD_INPUT
    except click.ClickException as error:
        return report(error.format_message(), error.exit_code)
    except (click.Abort, KeyboardInterrupt):
        return INTERRUPTED
    except GridError as error:  # a computation could not continue, although the input is valid
        return report(str(error))
    except (InputError, MissingExtraError) as error:
        return report(str(error), BAD_INPUT)
    except ConvergenceError as error:
        return report(f"no convergence: {error}")
    except InternalError as error:
        return report(f"internal error, a bug of brinell, please report it: {error}")
    except (BrinellError, OSError) as error:
        return report(str(error))
    return code if isinstance(code, int) else 0
