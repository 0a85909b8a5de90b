# SPDX-License-Identifier: BSD-3-Clause
"""How threads wait for each other, as OpenMP tells it when it is asked to by OMP_DISPLAY_ENV."""

from __future__ import annotations

import os
import re
import subprocess
import sys

import pytest


def told(**environment: str) -> dict[str, str]:
    """The settings that OpenMP reads when the extension is loaded."""
    ours = {key: value for key, value in os.environ.items() if key not in ("OMP_WAIT_POLICY", "GOMP_SPINCOUNT")}
    run = subprocess.run(
        [sys.executable, "-c", "import brinell; brinell.Case"],
        env={**ours, "OMP_DISPLAY_ENV": "verbose", **environment},
        check=True,
        capture_output=True,
        text=True,
    )
    return dict(re.findall(r"(OMP_WAIT_POLICY|GOMP_SPINCOUNT) = '(.*)'", run.stderr))


@pytest.mark.parametrize(
    ("environment", "expected"),
    [
        ({}, {"OMP_WAIT_POLICY": "PASSIVE", "GOMP_SPINCOUNT": "1000"}),
        ({"GOMP_SPINCOUNT": "77"}, {"OMP_WAIT_POLICY": "PASSIVE", "GOMP_SPINCOUNT": "77"}),
        ({"OMP_WAIT_POLICY": "passive"}, {"OMP_WAIT_POLICY": "PASSIVE", "GOMP_SPINCOUNT": "0"}),
    ],
)
def test_threads_look_for_a_moment_unless_the_user_says_otherwise(
    environment: dict[str, str], expected: dict[str, str]
) -> None:
    assert told(**environment) == expected
