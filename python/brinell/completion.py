# SPDX-License-Identifier: BSD-3-Clause
"""Completion of commands, options, case files and keys in bash, zsh and fish: ``brinell completion``.

When a shell calls ``brinell`` with an environment variable set, click answers with the completions. Those for the
engine's commands are generated from the declaration of their options in C++.
"""

from __future__ import annotations

import glob
import os
import sys

import click
from click.shell_completion import (
    BashComplete,
    CompletionItem,
    add_completion_class,
    get_completion_class,
    shell_complete,
)

from brinell import _core
from brinell.cli import COMPLETING

__all__ = ["answer", "case_files", "command", "engine_command", "schema_keys"]

PLACES = {
    "bash": "~/.local/share/bash-completion/completions/brinell",
    "zsh": "a folder of $fpath, under the name _brinell",
    "fish": "~/.config/fish/completions/brinell.fish",
}
"""Where each shell looks for its completion script."""


@add_completion_class
class _Bash(BashComplete):
    """click's completion for bash, but without a space after ``--set key=``."""

    source_template = BashComplete.source_template.replace(
        "    return 0\n", "    if [[ ${COMPREPLY[0]} == *= ]]; then compopt -o nospace; fi\n\n    return 0\n"
    )


_CASE_PATTERNS = ("*.toml", "*/*.toml", "*/*/*.toml")
"""Patterns of case files below a folder, deep enough to find cases/NAME/case.toml from the parent of cases/."""

_MOST_FILES = 100


def answer(root: click.Command) -> None:
    """Prints the completions and ends the process if a shell asks for them; otherwise returns."""
    instruction = os.environ.get(COMPLETING)
    if instruction:
        sys.exit(shell_complete(root, {}, "brinell", COMPLETING, instruction))


def case_files(_ctx: click.Context, _param: click.Parameter, incomplete: str) -> list[CompletionItem]:
    """Case files whose path begins with `incomplete`, also in subfolders; any file if there is no case file."""
    folder = incomplete.rpartition("/")[0]
    start = f"{glob.escape(incomplete)}*"
    patterns = [f"{start}.toml", *(f"{start}/{pattern}" for pattern in _CASE_PATTERNS[:2])]
    if incomplete.endswith("/") or not incomplete:
        patterns = [f"{glob.escape(folder)}/{p}" if folder else p for p in _CASE_PATTERNS]
    found = sorted({path for pattern in patterns for path in glob.glob(pattern)}, key=lambda p: (p.count("/"), p))
    if not found:
        return [CompletionItem(incomplete, type="file")]
    return [CompletionItem(path) for path in found[:_MOST_FILES]]


def schema_keys(_ctx: click.Context, _param: click.Parameter, incomplete: str) -> list[CompletionItem]:
    """Keys of the case file with an equals sign; after the sign, the allowed values of a key that has a fixed set."""
    key, equals, value = incomplete.partition("=")
    if not equals:
        return [CompletionItem(f"{k.key}=", help=k.text) for k in _core.schema_keys() if k.key.startswith(key)]
    choices = [choice for k in _core.schema_keys() if k.key == key for choice in k.choices]
    return [CompletionItem(f"{key}={choice}") for choice in choices if choice.startswith(value)]


def _scenarios(_ctx: click.Context, _param: click.Parameter, incomplete: str) -> list[CompletionItem]:
    choices = next(k.choices for k in _core.schema_keys() if k.key == "scenario")
    return [CompletionItem(choice) for choice in choices if choice.startswith(incomplete)]


def _folders(_ctx: click.Context, _param: click.Parameter, incomplete: str) -> list[CompletionItem]:
    return [CompletionItem(incomplete, type="dir")]


_BY_VALUE = {"CASE.toml": case_files, "KEY=VALUE": schema_keys, "SCENARIO": _scenarios, "DIR": _folders}
"""Completion functions by the placeholder of a value in the help."""


def engine_command(info: _core.CommandInfo) -> click.Command:
    """Description of an engine command as a click command, for the completion of its options; click never runs it."""
    parameters: list[click.Parameter] = []
    for option in info.options:
        complete = _BY_VALUE.get(option.value)
        if not option.flags:
            parameters.append(click.Argument([option.value.lower().replace(".", "_")], shell_complete=complete))
        else:
            parameters.append(
                click.Option(
                    option.flags,
                    help=option.help,
                    is_flag=not option.value,
                    multiple=option.value == "KEY=VALUE",
                    shell_complete=complete,
                )
            )
    return click.Command(info.name, params=parameters, help=info.help, add_help_option=False)


@click.command()
@click.argument("shell", type=click.Choice(list(PLACES)))
def command(shell: str) -> None:
    """Print the script with which SHELL completes commands, options and keys.

    The script says at its end where to put it.
    """
    completion_class = get_completion_class(shell)
    assert completion_class is not None  # click has all of PLACES
    click.echo(completion_class(click.Command("brinell"), {}, "brinell", COMPLETING).source().strip())
    # The remark is at the end because zsh requires its own first line.
    click.echo(f"\n# To have this in every new shell, write it into\n#   {PLACES[shell]}")
