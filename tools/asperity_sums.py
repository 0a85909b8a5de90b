#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""The numbers and the figure of docs/theory/asperities.md: sums over asperities against what they stand for.

    .venv/bin/python tools/asperity_sums.py [direct] [rough] [sliding] [--output results/asperities]

direct: the statistical sum over 200 and 200 asperities against a run of its own for every pair that meets, with its
offset and its radii. rough: a rough elastic flat under a smooth one, cell by cell over a period and as a sum over its
summits; writes docs/images/asperities.png. sliding: two rough surfaces that yield and slide past each other, cell by
cell over a period (`brinell.Sliding`) and as the sum of the passes of their summits; writes docs/images/ploughing.png.
"""

from __future__ import annotations

import argparse
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np
from matplotlib.figure import Figure
from numpy.typing import NDArray

import brinell
from brinell import asperities
from brinell.asperities import Population
from brinell.asperities.nodes import of_run
from brinell.plot import style

FloatArray = NDArray[np.float64]
ROOT = Path(__file__).resolve().parents[1]
STEEL = brinell.Material("200 GPa", 0.32, brinell.Perfect("0.9115 GPa"))
RESOLUTIONS = (4.0, 6.0)
COUNT, DENSITY, SEPARATION = 200, 3e10, 0.0


def asperities_of(seed: int) -> Population:
    """A set of asperities that is not a sample of others: radii from 7 to 15 um."""
    random = np.random.default_rng(seed)
    found = Population.of(random.normal(0.0, 4e-9, COUNT), 1e-5 * random.uniform(0.7, 1.5, COUNT), DENSITY)
    return replace(found, is_sample=False)


def direct(output: Path) -> None:
    """Prints the table of the direct sums."""
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
    """Prints the table of rough surfaces and draws the figure."""
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


#: Of each of the two surfaces that slide: 96 cells show the shortest wave by twelve.
SLIDING_SIZE, SLIDING_CELLS = 1e-4, 96
SLIDING_WAVES = {"rms_slope": 0.04, "hurst": 0.8, "rolloff": SLIDING_SIZE / 4, "cutoff": SLIDING_SIZE / 8}
SLIDING_MATERIAL = brinell.Material("200 GPa", 0.32, brinell.Linear("0.9115 GPa", "2 GPa"))
#: Mean gaps, over the standard deviation of both surfaces together.
SLIDING_GAPS = (3.0, 2.5, 2.0, 1.6, 1.2)
#: On half as large cells along x and y, too.
SLIDING_FINER = (3.0, 2.5)


@dataclass
class Slid:
    """Result of sliding once round the period; pressure and plastic work per area and distance in Pa."""

    gap: float
    pressure: float
    friction: float
    lost: float
    contact: float

    def __str__(self) -> str:
        return (
            f"pressure {self.pressure:.3e}, friction {self.friction:.5f}, plastic {self.lost / self.pressure:.5f} p, "
            f"contact {self.contact:.5f}"
        )


def sliding(output: Path) -> None:
    """Prints the table of sliding and draws a figure."""
    passes = sliding_map(output)
    heights = [
        brinell.surfaces.random(SLIDING_SIZE, 4 * SLIDING_CELLS, seed=seed, **SLIDING_WAVES).heights for seed in (1, 2)
    ]
    rms = float(np.hypot(*(h.std() for h in heights)))
    summits = [summits_of(h) for h in heights]
    print(f"rms {rms:.4g} m; summits {[len(one) for one in summits]}, radii {[one[:, 2].mean() for one in summits]} m")
    found = []
    for ratio in SLIDING_GAPS:
        cells, thirds = slid(ratio * rms, SLIDING_CELLS, output / f"sliding-{ratio:g}")
        of_passes, deepest = summed(passes, *summits, ratio * rms)
        found.append((ratio, cells, of_passes))
        print(f"gap {ratio:.2f} rms, cell by cell: {cells}; plastic work by thirds of the way {thirds}")
        print(f"gap {ratio:.2f} rms, its summits:  {of_passes}; up to {deepest:.1f} alpha_c", flush=True)
    style.save(sliding_figure(found), ROOT / "docs" / "images", "ploughing")
    for ratio in SLIDING_FINER:
        cells, thirds = slid(ratio * rms, 2 * SLIDING_CELLS, output / f"sliding-finer-{ratio:g}")
        print(f"gap {ratio:.2f} rms, on half the cells: {cells}; plastic work by thirds of the way {thirds}")


def sliding_map(output: Path) -> asperities.AsperityMap:
    """Map of the passes, computed once."""
    file = output / "sliding-map.h5"
    if not file.exists():
        found = asperities.AsperityMap.compute(
            SLIDING_MATERIAL,
            interferences=(0.5, 1.0, 1.6, 2.5, 4.0, 6.3, 10.0, 16.0, 25.0, 40.0),
            resolutions=RESOLUTIONS,
            output=output / "sliding-map",
        )
        found.write(file)
    return asperities.AsperityMap.read(file)


@style.figure
def sliding_figure(found: list[tuple[float, Slid, Slid]]) -> Figure:
    """Draws pressure over the gap, and ploughing over the contact."""
    fig = style.new_figure(8.6, 3.4)
    over_gap, over_contact = fig.subplots(1, 2)
    gaps = [ratio for ratio, _, _ in found]
    contact = [cells.contact for _, cells, _ in found]
    for place, look, label in (
        (1, {"color": style.LOWER}, "cell by cell"),
        (2, {"color": style.UPPER, "marker": "o", "linestyle": "--", "linewidth": 0.9}, "its summits, summed"),
    ):
        of = [one[place] for one in found]
        over_gap.plot(gaps, [one.pressure for one in of], label=label, **look)
        over_contact.plot(contact, [one.lost / one.pressure for one in of], label=f"plastic work, {label}", **look)
    friction = [cells.friction for _, cells, _ in found]
    over_contact.plot(contact, friction, color=style.LOWER, linestyle=":", label="friction, cell by cell")
    over_gap.set_yscale("log")
    over_contact.set_xscale("log")
    over_gap.set_title("(a)  pressure")
    over_gap.set_xlabel(r"mean gap  $\bar g\,/\,S_q$ of both")
    over_gap.set_ylabel(r"mean pressure  $\bar p$  [Pa]")
    over_gap.legend()
    over_contact.set_title("(b)  ploughing")
    over_contact.set_xlabel("contact area over nominal, cell by cell")
    over_contact.set_ylabel(r"per area and way, over $\bar p$")
    over_contact.legend()
    return fig


def summits_of(heights: FloatArray) -> FloatArray:
    """Place across the motion, height and radius of each summit that `Population.from_surface` finds, row by row."""
    spacing = SLIDING_SIZE / heights.shape[0]
    h = heights - heights.mean()
    top, drops, squares = np.ones(h.shape, dtype=bool), np.zeros(h.shape), 0.0
    for j, i in ((j, i) for j in (-1, 0, 1) for i in (-1, 0, 1) if (j, i) != (0, 0)):
        drop, square = h - np.roll(h, (-j, -i), (0, 1)), (i * i + j * j) * spacing**2
        top &= drop > 0.0
        drops += square * drop
        squares += square**2
    return np.column_stack([np.nonzero(top)[0] * spacing, h[top], squares / (2.0 * drops[top])])


def summed(passes: asperities.AsperityMap, lower: FloatArray, upper: FloatArray, gap: float) -> tuple[Slid, float]:
    """Sum in which each upper summit passes each lower one as if for the first time.

    Returns it with the largest interference, in units of its value at first yield.
    """
    y1, z1, r1 = (column[:, None] for column in lower.T)
    y2, z2, r2 = (column[None, :] for column in upper.T)
    offset = np.abs((y2 - y1 + 0.5 * SLIDING_SIZE) % SLIDING_SIZE - 0.5 * SLIDING_SIZE)
    alpha = z1 + z2 - gap
    meet = alpha - 0.5 * offset**2 / (r1 + r2) > 0.0
    radii = {
        "lower_radius": np.broadcast_to(r1, meet.shape)[meet],
        "upper_radius": np.broadcast_to(r2, meet.shape)[meet],
    }
    of = {
        name: float(passes.at(name, alpha[meet], offset[meet], **radii).value.sum()) / SLIDING_SIZE**3
        for name in ("normal", "work", "dissipation", "area")
    }
    unit = passes.pair.interference * radii["lower_radius"] * radii["upper_radius"]
    deepest = float((alpha[meet] * sum(radii.values()) / unit).max())
    return Slid(gap, of["normal"], of["work"] / of["normal"], of["dissipation"], of["area"]), deepest


def slid(gap: float, count: int, output: Path) -> tuple[Slid, list[float]]:
    """A run once round the period, in which each summit passes all others, and the shares of its plastic work by
    thirds.
    """
    lower, upper = (
        brinell.Body(
            brinell.Flat(),
            SLIDING_MATERIAL,
            brinell.RandomSurface(size=(SLIDING_SIZE, SLIDING_SIZE), seed=seed, **SLIDING_WAVES),
        )
        for seed in (1, 2)
    )
    run = brinell.Sliding(
        lower,
        upper,
        distance=SLIDING_SIZE,
        mean_gap=gap,
        press_steps=4,
        grid={
            "boundary": "periodic",
            "size": SLIDING_SIZE,
            "cells": count,
            "layer": 0.5 * SLIDING_SIZE / SLIDING_CELLS,
        },
        output={"snapshots": "none"},
    ).run(output)
    [stroke] = run.strokes
    moves = np.diff(run.history["way"]) > 0.0
    work = np.diff(run.history["dissipation_lower"] + run.history["dissipation_upper"])[moves]
    shares = [round(float(part.sum() / work.sum()), 2) for part in np.array_split(work, 3)]
    pressure = float(run.history["nominal_pressure"][1:][moves].mean())
    lost = float(work.sum()) / SLIDING_SIZE**3
    return Slid(gap, pressure, stroke.friction_ploughing, lost, stroke.contact_fraction), shares


@style.figure
def figure(run: brinell.Run, modulus: float, rms: float, sums: list[list[asperities.RestingSum]]) -> Figure:
    """Draws pressure over the gap, and contact over the pressure."""
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
    """Runs the parts that the command line names."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("parts", nargs="*", default=["direct", "rough", "sliding"], metavar="PART")
    parser.add_argument("--output", type=Path, default=ROOT / "results" / "asperities")
    options = parser.parse_args()
    for part in options.parts:
        {"direct": direct, "rough": rough, "sliding": sliding}[part](options.output)


if __name__ == "__main__":
    main()
