# SPDX-License-Identifier: BSD-3-Clause
"""A case of every scenario, also of one that is new: that of `brinell new`, on few cells."""

from __future__ import annotations

import subprocess
import sys

import brinell


def template_case(scenario: str) -> brinell.Case:
    arguments = [sys.executable, "-m", "brinell", "new", scenario]
    text = subprocess.run(arguments, check=True, capture_output=True, text=True).stdout
    few_cells = 'grid.spacing=["10 um", "10 um", "5 um"]' if "\nspacing = " in text else "grid.resolution=3"
    return brinell.Case(text, overrides=[few_cells])
