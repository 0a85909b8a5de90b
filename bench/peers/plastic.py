#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Elastic-plastic contact of a wavy surface, periodic: brinell beside tamaas, same surface, cells and load, one step.

    python3 -m venv build/peers
    build/peers/bin/pip install . tamaas
    OMP_NUM_THREADS=1 build/peers/bin/python bench/peers/plastic.py 64 64 25

A rigid flat is pressed on a body with waves of one length along both axes, E = 1, nu = 0.3, linear isotropic hardening, to a
mean pressure at which the summits have yielded. tamaas has linear finite elements over the depth, brinell layers of uniform
strain, so the answers differ by their discretisation: both are printed. Times are user CPU times of the solution alone,
without what is planned before; the tolerances are those of the default of tamaas' EPICSolver (1e-6 here) and brinell's.
"""

from __future__ import annotations

import argparse
import os
import time
from collections.abc import Callable

import numpy as np

MODULUS, RATIO, YIELD, HARDENING = 1.0, 0.3, 0.01, 0.05
AMPLITUDE, DEPTH = 0.01, 0.3
"""Of the waves, and of the grid; over the period, 1."""


def waves(nx: int, ny: int) -> np.ndarray:
    """(ny, nx), heights out of the body."""
    return AMPLITUDE * np.cos(2 * np.pi * np.arange(ny) / ny)[:, None] * np.cos(2 * np.pi * np.arange(nx) / nx)


def brinell_solver(nx: int, ny: int, nz: int, pressure: float) -> Callable[[], tuple[float, float]]:
    import brinell
    from brinell.elastoplastic import CoupledContact
    from brinell.halfspace import SurfaceGrid, VolumeGrid

    surface = SurfaceGrid(nx, ny, 1 / nx, 1 / ny, boundary="periodic")
    volume = VolumeGrid(surface, nz, DEPTH / nz)
    soft = brinell.Material(MODULUS, RATIO, brinell.Linear(YIELD, HARDENING))
    pair = CoupledContact(surface, volume, volume, soft, brinell.RIGID, scale=AMPLITUDE)
    heights = waves(nx, ny)

    def solve() -> tuple[float, float]:
        report = pair.advance(heights.max() - heights, load=pressure, integration="backward_euler")
        print(f"    brinell: {report.evaluations} evaluations")
        return float(np.mean(pair.pressure > 0)), float(pair.lower.equivalent_plastic_strain.max())

    return solve


def tamaas_solver(nx: int, ny: int, nz: int, pressure: float) -> Callable[[], tuple[float, float]]:
    import tamaas
    from tamaas.nonlinear_solvers import DFSANECXXSolver

    tamaas.set_log_level(tamaas.LogLevel.error)
    model = tamaas.ModelFactory.createModel(tamaas.model_type.volume_2d, [DEPTH, 1.0, 1.0], [nz + 1, nx, ny])
    model.E, model.nu = MODULUS, RATIO
    material = tamaas.materials.IsotropicHardening(model, YIELD, HARDENING)
    residual = tamaas.Residual(model, material)
    bodies = DFSANECXXSolver(residual)
    bodies.tolerance = 1e-9
    contact = tamaas.PolonskyKeerRey(model, waves(ny, nx), 1e-9)
    coupled = tamaas.EPICSolver(contact, bodies, 1e-6)

    def solve() -> tuple[float, float]:
        coupled.acceleratedSolve(pressure)
        strain = np.asarray(model["cumulated_plastic_strain"])
        return float(np.mean(model.traction[..., 2] > 0)), float(strain.max())

    return solve


PROGRAMS = {"brinell": brinell_solver, "tamaas": tamaas_solver}


def main() -> None:
    """Command line."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("cells", nargs=3, type=int, help="along x, y and in depth")
    parser.add_argument("--pressure", type=float, default=0.008, help="mean, over E")
    parser.add_argument("--repetitions", type=int, default=2)
    options = parser.parse_args()
    print(time.strftime("%Y-%m-%d"))
    least: dict[str, float] = {}
    for name, program in PROGRAMS.items():
        for _ in range(options.repetitions):
            solve = program(*options.cells, options.pressure)  # from a body without plastic strain
            before = os.times().user
            area, strain = solve()
            seconds = os.times().user - before
            least[name] = min(least.get(name, seconds), seconds)
            print(f"    {name}: {seconds:.3f} s, area {area:.4f}, largest plastic strain {strain:.5f}", flush=True)
    for name, seconds in least.items():
        print(f"{'x'.join(map(str, options.cells))} {name} {seconds:.3f} s, {seconds / least['brinell']:.1f}")


if __name__ == "__main__":
    main()
