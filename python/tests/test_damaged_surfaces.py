# SPDX-License-Identifier: BSD-3-Clause
"""Reading of damaged and renamed files of surfaces, in a process of its own with a limit of memory."""

from __future__ import annotations

import datetime
import json
import os
import resource
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

import damaged_surfaces
from brinell import surfaces

pytest.importorskip("SurfaceTopography")

CASES = 10_000
PARTS = 7
MEMORY = 8 << 30  # far more than any of the files needs; a header may announce terabytes


def share() -> tuple[int, int, int]:
    """First, last and step of the cases: a seventieth of them, others each day; more with BRINELL_SWEEP."""
    named = os.environ.get("BRINELL_SWEEP", "")
    if named == "all":
        return 0, CASES, 1
    if named:
        return int(named) % PARTS, CASES, PARTS
    steps = 10 * PARTS
    return datetime.datetime.now(datetime.timezone.utc).date().toordinal() % steps, CASES, steps


@pytest.mark.filterwarnings("ignore")
def test_files_in_order_are_read_by_all_names(tmp_path: Path) -> None:
    expected = 1e-6 * damaged_surfaces.heights()
    for name, seed in damaged_surfaces.seeds().items():
        if name == "no surface":
            continue
        for ending in (seed.ending, ".dat", ".TXT", ""):
            file = tmp_path / f"map{ending}"
            file.write_bytes(seed.content)
            read = surfaces.read(file, **seed.options)
            scale = 1e-3 if name == "wyko" else 1.0  # its heights are in nm
            # Single precision of one format; the others have the digits of the numbers.
            np.testing.assert_allclose(read.heights, scale * expected, rtol=1e-6, err_msg=f"{name} as {ending}")
            if name != "wyko":
                assert read.spacing == pytest.approx((2e-6, 3e-6), rel=1e-9)
            file.unlink()


def test_damaged_files_are_read_whole_or_refused() -> None:
    first, last, step = share()
    print(f"case {first} of {CASES} and every {step}th after it: BRINELL_SWEEP=0 ... 6 or =all computes more")
    script = Path(__file__).with_name("damaged_surfaces.py")
    done = subprocess.run(
        [sys.executable, script, str(first), str(last), str(step)],
        capture_output=True,
        text=True,
        timeout=3600,
        preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_AS, (MEMORY, MEMORY)),
    )
    assert done.returncode == 0, done.stderr[-2000:]
    result = json.loads(done.stdout)
    assert result["wrong"] == []
    # Neither is everything refused, nor does the damage do nothing.
    count = result["count"]
    assert count["read"] > 0.1 * sum(count.values())
    assert count["refused"] > 0.3 * sum(count.values())
