# SPDX-License-Identifier: BSD-3-Clause
"""Checks that an installed package works; tools/package.sh runs it with each Python, away from the sources.

Usage: try_package.py FOLDER WHEEL, the folder with the results of a tugging at resolution 4
"""

import sys
from pathlib import Path

import numpy as np

import brinell


def main(folder: str, wheel: str) -> None:
    """Computes a small case and reads its results and those of the command line; prints one line."""
    steel = brinell.Material("210 GPa", 0.3, brinell.Perfect("600 MPa"))
    ball = brinell.Body(brinell.Sphere("10 um"), steel)
    run = brinell.Tugging(lower=ball, upper=ball, interference=4, grid=brinell.Grid(resolution=4)).run()
    assert run.snapshot("final").lower.equivalent_plastic_strain.max() > 0.0
    assert run.field("lower", "stress_xx").values.ndim == 4
    brinell.plot.run_history(run).savefig("history.png")
    assert Path("history.png").stat().st_size > 10_000
    by_command = brinell.open(folder)
    again = brinell.Case((by_command.path / "resolved.toml").read_text()).run(in_memory=True)
    np.testing.assert_array_equal(again.history["F_X"], by_command.history["F_X"])
    peak = run.history["F_X"].max() / run.critical.load
    print(f"{wheel} works in Python {sys.version.split()[0]}: peak F_X {peak:.4f} P_c")


if __name__ == "__main__":
    main(*sys.argv[1:])
