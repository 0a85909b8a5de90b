#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Writes docs/reference/command-line.md from the help texts of the program.

    tools/render_command_line.py .venv/bin/brinell                                      # to standard output
    tools/render_command_line.py .venv/bin/brinell docs/reference/command-line.md

The commands of a help text are followed down, whatever wrote it.
"""

import os
import re
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path

HEAD = """<!-- Written by tools/render_command_line.py; do not edit. -->
# Command line

Output of `brinell --help` and of each command with `--help`. The keys of a case are described in [the case file](case-file.md).
"""


def help_text(program: str, commands: tuple[str, ...]) -> str:
    """Output of a command with --help, 100 columns wide and without colour."""
    environment = {**os.environ, "COLUMNS": "100", "NO_COLOR": "1"}
    done = subprocess.run(
        [program, *commands, "--help"], check=True, capture_output=True, text=True, timeout=60, env=environment
    )
    return "\n".join(line.rstrip() for line in done.stdout.strip().splitlines())


def names_of_commands(text: str) -> list[str]:
    """The commands listed in a help text: the indented lines under 'Commands ...:' or 'Subcommands:'."""
    names = []
    for block in re.findall(r"^(?:Subc|C)ommands.*:\n((?:[ \t]+\S.*\n?)+)", text, re.MULTILINE):
        lines = block.splitlines()
        indent = min(len(line) - len(line.lstrip()) for line in lines)
        names += [match.group(1) for line in lines if (match := re.match(rf" {{{indent}}}(\w[\w-]*)", line))]
    return names


def sections(program: str, commands: tuple[str, ...] = (), said: frozenset[str] = frozenset()) -> Iterator[str]:
    """A section per command, a group before its commands. Paragraphs that a group has `said` are not repeated."""
    text = help_text(program, commands)
    paragraphs = [paragraph.strip("\n") for paragraph in text.split("\n\n")]
    own = "\n\n".join(paragraph for paragraph in paragraphs if paragraph and paragraph not in said)
    title = " ".join(("brinell", *commands))
    yield f"{'#' * (2 if len(commands) < 2 else 3)} `{title}`\n\n```text\n{own}\n```\n"
    for name in names_of_commands(text):
        yield from sections(program, (*commands, name), said.union(paragraphs))


def rendered(program: str) -> str:
    """The content of the page."""
    return "\n".join([HEAD, *sections(program)])


def main() -> int:
    """Writes the page to a file or to standard output."""
    if len(sys.argv) not in (2, 3):
        print(__doc__, file=sys.stderr)
        return 2
    page = rendered(sys.argv[1])
    if len(sys.argv) == 2:
        print(page, end="")
    else:
        Path(sys.argv[2]).write_text(page, encoding="utf-8")
    return 0


if __name__ == "__main__":
    sys.exit(main())
