# SPDX-License-Identifier: BSD-3-Clause
"""Histories and summaries of made-up runs, out of closed formulas.

Forces are those of elastic spheres, made lop-sided to look like plasticity. Nothing here is mechanics: the tests check
that what is in the files arrives in the figures.
"""

from __future__ import annotations

from typing import Any

import numpy as np

CRITICAL = {
    "C": 1.637468,
    "interference_m": 2.214290e-4,
    "load_N": 3.460928e5,
    "energy_J": 30.65398,
    "contact_radius_m": 1.052209e-2,
    "peak_pressure_Pa": 1.637468 * 0.9115e9,
    "yields_first": "both",
}
RADIUS = 1.0


def history_rows(alpha: float, passes: int, steps: int) -> list[dict[str, float]]:
    """Rows of history.csv for one interference alpha* = alpha / alpha_c."""
    alpha_c, P_c, a_c = (CRITICAL[k] for k in ("interference_m", "load_N", "contact_radius_m"))
    interference = alpha * alpha_c
    omega = 2.0 * RADIUS - interference
    reach = np.sqrt(4.0 * RADIUS**2 - omega**2)
    rows: list[dict[str, float]] = []
    work = 0.0
    for index in range(passes):
        X = np.linspace(-reach, reach, steps)
        soft = 1.0 / (1.0 + 0.03 * alpha * (1.0 + np.tanh(2.0 * X / reach)))
        force_before = 0.0
        for i, x in enumerate(X):
            separation = np.hypot(omega, x)
            local = 2.0 * RADIUS - separation
            load = P_c * (max(local, 0.0) / alpha_c) ** 1.5 * soft[i]
            force = -load * x / separation + 0.002 * alpha * load
            if i > 0:
                work += 0.5 * (force + force_before) * (X[i] - X[i - 1])
            force_before = force
            done = (index + (i + 1) / steps) / passes
            rows.append(
                {
                    "step": len(rows),
                    "pass": index + 1,
                    "X": x,
                    "theta": np.arctan(x / omega),
                    "interference": local,
                    "contact_area": np.pi * a_c**2 * max(local, 0.0) / alpha_c if load > 0.0 else 0.0,
                    "max_pressure": min(1.6, (max(local, 0.0) / alpha_c) ** 0.5) * CRITICAL["peak_pressure_Pa"],
                    "F_n": load,
                    "F_X": force,
                    "F_Y": 0.0,
                    "F_Z": load * omega / separation,
                    "F_X_macro": -load * x / separation,
                    "F_Z_macro": load * omega / separation,
                    "work": work,
                    "dissipation_lower": 0.4 * work * done,
                    "dissipation_upper": 0.5 * work * done,
                    "energy_residual": 0.1 * work * done,
                    "energy_elastic": 0.4 * load * max(local, 0.0),
                    "max_residual_lower": 0.2 * (1.0 - 1.0 / alpha) * interference * done,
                    "max_residual_upper": 0.2 * (1.0 - 1.0 / alpha) * interference * done,
                    "max_equivalent_plastic_strain": 0.004 * alpha * done,
                    "evaluations": 8 + i % 5,
                }
            )
    return rows


def summary_of(alpha: float, rows: list[dict[str, float]]) -> dict[str, Any]:
    """The part of summary.json that is read, and a little more."""
    return {
        "format": "brinell-summary",
        "format_version": 3,
        "complete": True,
        "scenario": "tugging",
        "title": "synthetic",
        "critical": dict(CRITICAL),
        "geometry": {
            "lower_radius_m": RADIUS,
            "upper_radius_m": RADIUS,
            "equivalent_radius_m": 0.5 * RADIUS,
            "contact_modulus_Pa": 1.114082e11,
            "interference_m": alpha * CRITICAL["interference_m"],
        },
        "normalised": {"interference": alpha, "net_energy": rows[-1]["work"] / CRITICAL["energy_J"]},
        "run": {"steps": len(rows)},
        "case": {},
    }


# --- Indentation and rolling ------------------------------------------------------------------------------------------


def common_columns(step: int, depth: float, work: float) -> dict[str, float]:
    """What all scenarios tell, for a residual depth and a work so far."""
    return {
        "step": step,
        "work": work,
        "dissipation_lower": 0.8 * work,
        "dissipation_upper": 0.0,
        "energy_residual": 0.1 * work,
        "energy_elastic": 0.1 * work,
        "max_residual_lower": depth,
        "max_residual_upper": 0.0,
        "max_equivalent_plastic_strain": 0.02,
        "evaluations": 6 + step % 4,
    }


def general_summary(scenario: str, *, texture: str = "smooth", upper: str = "sphere", **more: Any) -> dict[str, Any]:
    """What both scenarios have in summary.json; no first yield unless the indenter is a sphere."""
    return {
        "format": "brinell-summary",
        "format_version": 3,
        "complete": True,
        "scenario": scenario,
        "title": "",
        "critical": dict(CRITICAL) if upper == "sphere" else dict.fromkeys(CRITICAL),
        "geometry": {"equivalent_radius_m": RADIUS if upper == "sphere" else None, "contact_modulus_Pa": 1.1e11},
        "case": {
            "lower": {"shape": {"type": "flat"}, "texture": {"type": "smooth"}},
            "upper": {"shape": {"type": upper}, "texture": {"type": texture}},
        },
        **more,
    }


def indentation_rows(load: float, cycles: int, places: tuple[float, ...], steps: int) -> list[dict[str, float]]:
    """Up to a load and back, in so many steps each: power 3/2 up, steeper down."""
    rows: list[dict[str, float]] = []
    deepest = 2.0 * CRITICAL["interference_m"] * (load / CRITICAL["load_N"]) ** (2.0 / 3.0)
    for index in range(len(places) * cycles):
        shares = np.concatenate([np.arange(1, steps + 1), np.arange(steps - 1, -1, -1)]) / steps
        for i, share in enumerate(shares):
            first_loading = index % cycles == 0 and i < steps
            area = np.pi * (CRITICAL["contact_radius_m"] * 3.0) ** 2 * share
            approach = deepest * (share ** (2.0 / 3.0) if first_loading else 0.6 + 0.4 * share ** (2.0 / 3.0))
            rows.append(
                common_columns(len(rows), 0.6 * deepest, load * approach)
                | {
                    "pass": index + 1,
                    "place": index // cycles + 1,
                    "x": places[index // cycles],
                    "approach": approach,
                    "F_n": load * share,
                    "contact_area": area,
                    "contact_radius": np.sqrt(area / np.pi),
                    "max_pressure": 3e9 * share,
                    "mean_pressure": 2.5e9 * share,
                    "residual_depth": 0.6 * deepest,
                    "pile_up": 0.05 * deepest,
                }
            )
    return rows


def indents_of(rows: list[dict[str, float]]) -> list[dict[str, Any]]:
    """The list in summary.json."""
    indents = []
    for index in range(1, int(rows[-1]["pass"]) + 1):
        top = max((row for row in rows if row["pass"] == index), key=lambda row: row["F_n"])
        indents.append(
            {
                "place": top["place"],
                "cycle": sum(one["place"] == top["place"] for one in indents) + 1,
                "x_m": top["x"],
                "max_load_N": top["F_n"],
                "max_approach_m": top["approach"],
                "contact_area_m2": top["contact_area"],
                "hardness_Pa": top["mean_pressure"],
                "loading_stiffness_N_per_m": 1.5 * top["F_n"] / top["approach"],
                "unloading_stiffness_N_per_m": 4.0 * top["F_n"] / top["approach"],
                "final_approach_m": None if index > 1 else 0.6 * top["approach"],
                "residual_depth_m": top["max_residual_lower"],
                "pile_up_m": top["pile_up"],
                "work_J": top["work"],
            }
        )
    return indents


def rolling_rows(load: float, passes: int, load_steps: int, rolling_steps: int) -> list[dict[str, float]]:
    """Press, roll, lift: F_X falls with every pass."""
    rows: list[dict[str, float]] = []
    half = 0.05
    for index in range(passes):
        up = np.arange(1, load_steps + 1) / load_steps
        drive = np.concatenate([up, np.ones(rolling_steps), 1.0 - up])
        ends = np.full(load_steps, half)
        x = np.concatenate([-ends, np.linspace(-half, half, rolling_steps + 1)[1:], ends])
        for share, place in zip(drive, x, strict=True):
            rows.append(
                common_columns(len(rows), 1e-4 * (1.0 - 0.5 ** (index + 1)), 1.0 + len(rows))
                | {
                    "pass": index + 1,
                    "x": place,
                    "approach": 1e-4 * share + 1e-6 * index,
                    "F_n": load * share,
                    "F_X": 0.01 * load * share / 3.0**index * (1.2 + place / half),
                    "contact_area": np.pi * (CRITICAL["contact_radius_m"] * 2.0) ** 2 * share,
                    "max_pressure": 2.5e9 * share,
                }
            )
    return rows


def rolling_results(passes: int) -> dict[str, Any]:
    """The lists in summary.json."""
    each = [
        {
            "pass": n,
            "rut_depth_m": 1e-4 * (1.0 - 0.5**n),
            "shoulder_height_m": 1e-5 * (1.0 - 0.5**n),
            "max_equivalent_plastic_strain": 0.02,
            "track_plastic_strain": 0.015 * (1.0 - 0.1**n),
            "track_plastic_increment": 0.015 * 0.1 ** (n - 1),
            "dissipation_J": 2.0 * 0.1 ** (n - 1),
            "resistance_N": 50.0 / n,
            "steady": True,
            "unsteadiness": 0.01,
            "mean_F_X_N": 60.0 / n,
            "max_pressure_Pa": 2.5e9,
        }
        for n in range(1, passes + 1)
    ]
    depth = np.linspace(1e-3, 2e-2, 12)
    profile = {
        "depth_m": depth.tolist(),
        "residual_xx_Pa": (-4e8 * np.cos(200.0 * depth)).tolist(),
        "residual_yy_Pa": (-3e8 * np.cos(200.0 * depth)).tolist(),
        "equivalent_plastic_strain": (0.015 * np.exp(-100.0 * depth)).tolist(),
    }
    return {"passes": each, "profile": profile}
