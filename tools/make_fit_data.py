# SPDX-License-Identifier: BSD-3-Clause
"""Writes the curves of fits/: runs of brinell for a material that the fits are to find, with 1 % of noise, seed 1."""

from __future__ import annotations

import sys
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import numpy as np

import brinell
from brinell.fits.model import load_at

FITS = Path(__file__).resolve().parents[1] / "fits"
STEEL = {"lower.material.hardening.yield_stress": 1.25e9, "lower.material.hardening.coefficient": 1.5e9}
LAYER = {
    "lower.material.hardening.yield_stress": 900e6,
    "lower.material.yield_profile": {"depth": [0.0, 40e-6, 120e-6], "factor": [2.2, 1.6, 1.0]},
}
CURVES: Mapping[str, tuple[str, Mapping[str, Any], str, str]] = {
    "sphere-berkovich/sphere.csv": ("sphere-berkovich/sphere.toml", STEEL, "um", "mN"),
    "sphere-berkovich/berkovich.csv": (
        "sphere-berkovich/berkovich.toml",
        {**STEEL, "upper.shape.tip_radius": 0.25e-6},
        "um",
        "mN",
    ),
    "nitrided-steel/5N.csv": ("nitrided-steel/case.toml", {**LAYER, "indentation.load": [5.0, 0.0]}, "um", "N"),
    "nitrided-steel/20N.csv": ("nitrided-steel/case.toml", {**LAYER, "indentation.load": [20.0, 0.0]}, "um", "N"),
    "nitrided-steel/60N.csv": ("nitrided-steel/case.toml", LAYER, "um", "N"),
}
SCALES = {"um": 1e6, "mN": 1e3, "N": 1.0}


def main() -> None:
    """Computes the curves and writes them."""
    scatter = np.random.default_rng(1)
    for name, (case, values, *units) in CURVES.items():
        rows = list(brinell.Case.from_file(FITS / case).with_values(values).steps(threads=1))
        depth, load = (np.array([0.0, *(row[column] for row in rows)]) for column in ("approach", "F_n"))
        top = int(np.argmax(load))
        up, down = np.linspace(0.03, 1.0, 50) * depth[top], np.linspace(depth[top], depth[-1], 31)[1:]
        x = np.concatenate([up, down])
        y = np.concatenate([load_at(depth[: top + 1], load[: top + 1], up), load_at(depth[top:], load[top:], down)])
        y *= 1.0 + 0.01 * scatter.standard_normal(y.size)
        lines = [f"# computed by tools/make_fit_data.py, with 1 % of noise\ndepth [{units[0]}],load [{units[1]}]"]
        lines += [f"{a * SCALES[units[0]]:.6g},{b * SCALES[units[1]]:.6g}" for a, b in zip(x, y, strict=True)]
        (FITS / name).write_text("\n".join(lines) + "\n", encoding="utf-8")
        print(FITS / name, file=sys.stderr)


if __name__ == "__main__":
    main()
