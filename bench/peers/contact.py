#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Elastic contact of a rough surface: brinell beside tamaas and ContactMechanics, same surface, same accuracy.

    python3 -m venv build/peers
    build/peers/bin/pip install . tamaas ContactMechanics
    OMP_NUM_THREADS=1 build/peers/bin/python bench/peers/contact.py --boundary periodic 1024 2048

The surface is self-affine (Hurst exponent 0.8, wavelengths from a half of the grid to 8 cells, unit root mean square),
E' = 1. The load is a share of E' times root mean square slope times area. Every solution is checked by the same function,
which takes the pressure alone: displacements by numpy's transforms, largest |gap| under pressure and largest penetration
elsewhere. The tolerance of each program is made smaller by tens until that error is below the one asked for; only the last
solution counts. Times are user CPU times, the least of the repetitions, which are taken by turns.
"""

from __future__ import annotations

import argparse
import os
import time
from collections.abc import Callable
from typing import NamedTuple

import numpy as np

Solver = Callable[[float], np.ndarray]
"""Tolerance, relative to the root mean square of the heights -> pressure."""


def surface(n: int, seed: int = 1) -> np.ndarray:
    """(n, n), mean 0, root mean square 1; the length of the grid is 1."""
    k = np.hypot(np.fft.fftfreq(n, 1 / n)[:, None], np.fft.rfftfreq(n, 1 / n)[None])
    waves = np.zeros(k.shape, complex)
    some = (k >= 2) & (k <= n / 8)
    waves[some] = k[some] ** -1.8 * np.exp(2j * np.pi * np.random.default_rng(seed).random(some.sum()))
    heights = np.fft.irfft2(waves, (n, n))
    return (heights - heights.mean()) / heights.std()


def spectrum(n: int, is_open: bool) -> np.ndarray:
    """Of the compliance, E' = 1."""
    if not is_open:
        k = 2 * np.pi * np.hypot(np.fft.fftfreq(n, 1 / n)[:, None], np.fft.rfftfreq(n, 1 / n)[None])
        return np.where(k > 0, 2 / np.where(k > 0, k, 1), 0)
    corner = (np.arange(n + 1) - 0.5) / n
    x, y = corner[None, :], corner[:, None]
    potential = x * np.arcsinh(y / np.abs(x)) + y * np.arcsinh(x / np.abs(y))
    cell = np.diff(np.diff(potential, axis=0), axis=1) / np.pi
    kernel = np.zeros((2 * n, 2 * n))
    kernel[:n, :n] = cell
    kernel[n + 1 :, :n] = cell[:0:-1]
    kernel[:, n + 1 :] = kernel[:, n - 1 : 0 : -1]
    return np.fft.rfft2(kernel).real


def error(pressure: np.ndarray, heights: np.ndarray, compliance: np.ndarray) -> float:
    """Largest |gap| under pressure, or penetration elsewhere; negative pressures count as an error of their own."""
    n = len(heights)
    shape = (2 * (compliance.shape[1] - 1),) * 2
    gap = np.fft.irfft2(np.fft.rfft2(pressure, shape) * compliance, shape)[:n, :n] - heights
    # A trace of pressure, of one part in 1e12 of the mean, is none.
    pressed = pressure > 1e-12 * pressure.mean()
    gap -= gap[pressed].mean()
    return float(max(np.abs(gap[pressed]).max(), -gap[~pressed].min(initial=0.0), -pressure.min()))


def brinell_solver(heights: np.ndarray, load: float, is_open: bool) -> Solver:
    import brinell
    from brinell.contact import ElasticContact
    from brinell.halfspace import SurfaceGrid

    n = len(heights)
    grid = SurfaceGrid(n, n, 1 / n, 1 / n, boundary="open" if is_open else "periodic")
    contact = ElasticContact(grid, brinell.Material(1.0, 0.0))

    def solve(tolerance: float) -> np.ndarray:
        result = contact.solve(heights.max() - heights, load=load, tolerance=tolerance)
        print(f"    brinell: {result.contact_iterations} iterations")
        return result.pressure

    return solve


def tamaas_solver(heights: np.ndarray, load: float, is_open: bool) -> Solver:
    import tamaas

    tamaas.set_log_level(tamaas.LogLevel.error)

    def solve(tolerance: float) -> np.ndarray:
        model = tamaas.ModelFactory.createModel(tamaas.model_type.basic_2d, [1.0, 1.0], list(heights.shape))
        model.E, model.nu = 1.0, 0.0
        solver = tamaas.PolonskyKeerRey(model, heights, tolerance)
        solver.max_iter = 5000
        solver.solve(load)
        return np.array(model.traction)

    return solve


def contact_mechanics_solver(heights: np.ndarray, load: float, is_open: bool) -> Solver:
    import ContactMechanics
    from ContactMechanics.Systems import NonSmoothContactSystem
    from SurfaceTopography import Topography

    kind = ContactMechanics.FreeFFTElasticHalfSpace if is_open else ContactMechanics.PeriodicFFTElasticHalfSpace
    substrate = kind(heights.shape, 1.0, (1.0, 1.0))
    system = NonSmoothContactSystem(substrate, Topography(heights, (1.0, 1.0)))

    def solve(tolerance: float) -> np.ndarray:
        result = system.minimize_proxy(external_force=load, pentol=tolerance, maxiter=5000)
        if not result.success:
            raise RuntimeError(result.message)
        n = len(heights)
        return np.asarray(result.jac)[:n, :n] * heights.size

    return solve


class Program(NamedTuple):
    """A program, and whether it has surfaces with an open boundary."""

    solver: Callable[[np.ndarray, float, bool], Solver]
    has_open: bool


PROGRAMS = {
    "brinell": Program(brinell_solver, has_open=True),
    "tamaas": Program(tamaas_solver, has_open=False),
    "ContactMechanics": Program(contact_mechanics_solver, has_open=True),
}


def installed_solvers(heights: np.ndarray, load: float, is_open: bool) -> dict[str, Solver]:
    """Of the programs that have this boundary and are installed; prints which have not, and are not."""
    solvers = {}
    for name, program in PROGRAMS.items():
        if is_open and not program.has_open:
            print(f"    {name}: periodic boundaries only")
            continue
        try:
            solvers[name] = program.solver(heights, load, is_open)
        except ImportError as missing:
            print(f"    {name}: {missing}")
    return solvers


def timed(solve: Solver, tolerance: float) -> tuple[float, np.ndarray]:
    """User CPU time [s] and pressure."""
    before = os.times().user
    pressure = solve(tolerance)
    return os.times().user - before, pressure


def compare(n: int, is_open: bool, share: float, wanted: float, repetitions: int) -> None:
    """Prints time and error of each program."""
    heights = surface(n)
    if is_open:
        x = (np.arange(n) + 0.5) / n - 0.5
        heights = 0.3 * heights - 10 * (x[:, None] ** 2 + x**2)
    slope = np.sqrt(2 * np.mean(np.diff(surface(n), axis=0) ** 2)) * n
    load, compliance = share * slope / 2 * (0.1 if is_open else 1.0), spectrum(n, is_open)
    ready, least = {}, {}
    for name, solve in installed_solvers(heights, load, is_open).items():
        tolerance = wanted
        for _ in range(6):
            least[name], pressure = timed(solve, tolerance)
            found = error(pressure, heights, compliance)
            area, total = np.mean(pressure > 0), pressure.mean()
            print(f"    {name}: tolerance {tolerance:g}, {least[name]:.2f} s, error {found:.2e}, area {area:.4f}, "
                  f"load {total / load:.12f}", flush=True)  # fmt: skip
            if found <= wanted:
                break
            tolerance /= 10
        ready[name] = (solve, tolerance)
    for _ in range(repetitions - 1):
        for name, (solve, tolerance) in ready.items():
            least[name] = min(least[name], timed(solve, tolerance)[0])
    for name, seconds in least.items():
        print(f"{'open' if is_open else 'periodic'} {n} {share:g} {name} {seconds:.3f} s, {seconds / least.get('brinell', seconds):.1f}",
              flush=True)  # fmt: skip


def main() -> None:
    """Command line."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("cells", nargs="+", type=int, help="along an axis")
    parser.add_argument("--boundary", choices=("open", "periodic"), default="periodic")
    parser.add_argument("--share", type=float, default=0.1, help="load by E' slope area / 2, about the share in contact")
    parser.add_argument("--error", type=float, default=1e-6, help="by the root mean square of the heights")
    parser.add_argument("--repetitions", type=int, default=3)
    options = parser.parse_args()
    print(time.strftime("%Y-%m-%d"))
    for n in options.cells:
        compare(n, options.boundary == "open", options.share, options.error, options.repetitions)


if __name__ == "__main__":
    main()
