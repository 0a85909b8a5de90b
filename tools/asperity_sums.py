#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""The numbers and the figure of docs/theory/asperities.md: sums over asperities against what they stand for.

    .venv/bin/python tools/asperity_sums.py [direct] [rough] [--output results/asperities]

direct: the statistical sum over 200 and 200 asperities against a run of its own for every pair that meets, with its
offset and its radii. rough: a rough elastic flat under a smooth one, cell by cell over a period and as a sum over its
summits; writes docs/images/asperities.png.
"""

from __future__ import annotations

import argparse
from dataclasses import replace
from pathlib import Path

import numpy as np
from matplotlib.figure import Figure

import brinell
from brinell import asperities
from brinell.asperities import Population
from brinell.asperities.nodes import of_run
from brinell.plot import style

ROOT = Path(__file__).resolve().parents[1]
STEEL = brinell.Material("200 GPa", 0.32, brinell.Perfect("0.9115 GPa"))
RESOLUTIONS = (4.0, 6.0)
COUNT, DENSITY, SEPARATION = 200, 3e10, 0.0


def asperities_of(seed: int) -> Population:
    """As they are, no sample of others: radii from 7 to 15 um."""
    random = np.random.default_rng(seed)
    found = Population.of(random.normal(0.0, 4e-9, COUNT), 1e-5 * random.uniform(0.7, 1.5, COUNT), DENSITY)
    return replace(found, is_sample=False)


def direct(output: Path) -> None:
    """Prints a table."""
    passes = asperities.AsperityMap.compute(
        STEEL,
        interferences=(0.5, 1.0, 1.5, 2.2, 3.2, 4.5, 6.3, 9.0),
        ratios=(0.5, 1.0, 2.0),
        resolutions=RESOLUTIONS,
        output=output / "map",
    )
    passes.write(output / "map.h5")
    lower, upper = asperities_of(1), asperities_of(2)
    met = asperities.encounters(lower, upper, SEPARATION, seed=1)
    first = brinell.Tugging(
        brinell.Body(brinell.Sphere(1e-5), STEEL),
        brinell.Body(brinell.Sphere(1e-5), STEEL),
        1e-8,
        normalised=False,
        grid={"resolution": RESOLUTIONS[1]},
        output={"snapshots": "none"},
    )
    over = {
        "tugging.interference": met.interference.tolist(),
        "tugging.offset": met.offset.tolist(),
        "lower.shape.radius": met.lower_radius.tolist(),
        "upper.shape.radius": met.upper_radius.tolist(),
    }
    runs = brinell.sweep(first, over, output=output / "direct", design="list").runs
    found = [of_run(runs[index]) for index in range(len(met))]
    expected = asperities.statistical_sum(passes, lower, upper, SEPARATION)
    there = expected.over(met.area, met.way)
    radii = {"lower_radius": met.lower_radius, "upper_radius": met.upper_radius}
    print(f"{len(met)} passes, the deepest of {expected.largest_interference:.2f} alpha_c; coefficient: {there}")
    for name, estimate in (("normal", there.pressure), ("work", there.shear)):
        runs_sum = sum(one[name] for one in found) / (met.area * met.way)
        of_map = passes.at(name, met.interference, met.offset, **radii)
        map_sum = float(of_map.value.sum()) / (met.area * met.way)
        print(
            f"{name}: expected {estimate.value:.5g} Pa, interval {estimate.low:.5g} to {estimate.high:.5g} (scatter "
            f"{estimate.sampling:.2g}, mesh {estimate.mesh:.2g}, interpolation {estimate.interpolation:.2g}); "
            f"direct {runs_sum:.5g}; the same passes from the map {map_sum:.5g}"
        )
    work, normal = (sum(one[name] for one in found) for name in ("work", "normal"))
    print(f"coefficient: expected {there.friction_coefficient}, direct {work / normal:.5g}")


def rough(output: Path) -> None:
    """Prints a table and draws the figure."""
    size, cells = 1e-4, 384
    surface = brinell.RandomSurface(rms_slope=0.05, hurst=0.8, rolloff=size / 6, cutoff=size / 24, size=(size, size))
    material = brinell.Material("210 GPa", 0.3)
    pressures = np.geomspace(1e5, 3e9, 16)
    run = brinell.Indentation(
        brinell.Body(brinell.Flat(), material, surface),
        brinell.Body(brinell.Flat(), brinell.RIGID),
        pressure=[float(one) for one in pressures],
        steps=1,
        grid={"boundary": "periodic", "size": [size, size], "cells": [cells, cells]},
        output={"snapshots": "none"},
    ).run(output / "rough")
    modulus = float(run.summary["geometry"]["contact_modulus_Pa"])
    heights = brinell.surfaces.random(size, cells, rms_slope=0.05, hurst=0.8, rolloff=size / 6, cutoff=size / 24)
    found, moments = Population.from_surface(heights), asperities.SpectralMoments.of(heights)
    print(f"{found}; {moments}; rms height {heights.Sq:.4g} m; Nayak: {Population.from_moments(moments)}")
    gaps = run.history["mean_gap"]
    sums = [
        [asperities.resting_sum(one, gap, modulus) for gap in gaps] for one in (found, Population.from_moments(moments))
    ]
    for gap, pressure, fraction, summed, theory in zip(
        gaps, run.history["nominal_pressure"], run.history["contact_fraction"], *sums, strict=True
    ):
        print(
            f"gap/rms {gap / heights.Sq:6.3f}  p/E' {pressure / modulus:.3e} summits "
            f"{summed.pressure.value / modulus:.3e} +- {summed.pressure.half_width / modulus:.1e} theory "
            f"{theory.pressure.value / modulus:.3e}   contact "
            f"{fraction:.4f} summits {summed.contact_fraction.value:.4f} theory {theory.contact_fraction.value:.4f}"
        )
    style.save(figure(run, modulus, heights.Sq, sums), ROOT / "docs" / "images", "asperities")


@style.figure
def figure(run: brinell.Run, modulus: float, rms: float, sums: list[list[asperities.RestingSum]]) -> Figure:
    """Pressure over the gap, contact over the pressure."""
    fig = style.new_figure(8.6, 3.4)
    over_gap, over_pressure = fig.subplots(1, 2)
    gap, pressure = run.history["mean_gap"] / rms, run.history["nominal_pressure"] / modulus
    fraction = run.history["contact_fraction"]
    over_gap.plot(gap, pressure, color=style.LOWER, label="cell by cell")
    over_pressure.plot(pressure, fraction, color=style.LOWER, label="cell by cell")
    looks = ((style.UPPER, "o", "its summits, summed"), (style.REFERENCE, "", "Nayak, McCool"))
    for of, (colour, marker, label) in zip(sums, looks, strict=True):
        p, half = (np.array([getattr(one.pressure, name) for one in of]) / modulus for name in ("value", "half_width"))
        a = np.array([one.contact_fraction.value for one in of])
        there = p > 0.3 * pressure.min()
        look = {"color": colour, "marker": marker, "linestyle": "--", "linewidth": 0.9}
        over_gap.errorbar(gap[there], p[there], np.minimum(half, 0.99 * p)[there], capsize=2, **look)
        over_pressure.plot(p[there], a[there], label=label, **look)
    for ax, axis in ((over_gap, "y"), (over_pressure, "both")):
        ax.set_yscale("log")
        if axis == "both":
            ax.set_xscale("log")
    over_gap.set_title("(a)  pressure")
    over_gap.set_xlabel(r"mean gap  $\bar g\,/\,S_q$")
    over_gap.set_ylabel(r"mean pressure  $\bar p\,/\,E'$")
    over_pressure.set_title("(b)  real contact")
    over_pressure.set_xlabel(r"mean pressure  $\bar p\,/\,E'$")
    over_pressure.set_ylabel("contact area over nominal")
    over_pressure.set_ylim(top=1.5)
    over_pressure.legend(loc="lower right")
    return fig


def main() -> None:
    """The command."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("parts", nargs="*", default=["direct", "rough"], metavar="PART")
    parser.add_argument("--output", type=Path, default=ROOT / "results" / "asperities")
    options = parser.parse_args()
    for part in options.parts:
        {"direct": direct, "rough": rough}[part](options.output)


if __name__ == "__main__":
    main()
