# SPDX-License-Identifier: BSD-3-Clause
"""The coarse case of the sweep tests, and how they watch its runs."""

import time
from collections.abc import Callable
from pathlib import Path

from brinell import BrinellError, RunError
from brinell import open as open_run

_BALL = """
shape = { type = "sphere", radius = "10 um" }
[BODY.material]
young_modulus = "200 GPa"
poisson_ratio = 0.3
hardening = { law = "linear", yield_stress = "600 MPa", modulus = "2 GPa" }
"""

CASE = "\n".join(
    [
        'scenario = "tugging"',
        *(f"[{body}]{_BALL.replace('BODY', body)}" for body in ("lower", "upper")),
        "[tugging]\ninterference = 2",
        "[grid]\nresolution = 2",
        '[output]\nsnapshots = "none"',
    ]
)
"""A few steps, a tenth of a second."""

LONG = ["grid.resolution=6", "tugging.passes=4", "output.checkpoint_interval=0"]
"""Overrides that make it take seconds: long enough to be killed in the midst."""


def wait_for(condition: Callable[[], object], what: str, timeout: float = 60.0) -> None:
    """Waits until the condition holds."""
    end = time.monotonic() + timeout
    while not condition():
        assert time.monotonic() < end, f"waited {timeout} s for {what}"
        time.sleep(0.01)


def is_under_way(folder: Path) -> bool:
    """Whether a run has some steps, but has not finished."""
    try:
        run = open_run(folder, allow_unfinished=True)
    except (RunError, BrinellError, OSError):
        return False
    return run.history.steps >= 3 and not run.complete
