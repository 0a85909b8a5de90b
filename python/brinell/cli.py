# SPDX-License-Identifier: BSD-3-Clause
"""The command ``brinell``."""

from __future__ import annotations

import sys

from brinell import _core

__all__ = ["main"]


def main() -> None:
    """Runs the command with the arguments of the process."""
    sys.exit(_core.command_line(sys.argv[1:]))
