# SPDX-License-Identifier: BSD-3-Clause
"""Result folders in the format of docs/reference/results-format.md, made of closed formulas.

Forces are those of elastic spheres, made lop-sided to look like plasticity; fields are smooth bumps. Nothing here is
mechanics: the tests check that what is in the files arrives in the figures.
"""

from __future__ import annotations

import functools
import json
import shutil
import sys
from collections.abc import Callable
from pathlib import Path
from typing import Any

import h5py
import matplotlib
import numpy as np
import pytest

from brinell.plot import style

matplotlib.use("Agg")

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
HEADER = (
    "step,X,theta,interference,contact_area,max_pressure,F_n,F_X,F_Y,F_Z,F_X_macro,F_Z_macro,work,dissipation_lower,"
    "dissipation_upper,energy_residual,max_residual_lower,max_residual_upper,max_equivalent_plastic_strain,iterations"
)
UNITS = {"pressure": "Pa", "gap": "m", "residual_displacement": "m", "von_mises_stress": "Pa", "stress": "Pa"}
COMPONENTS = ("xx", "yy", "zz", "yz", "xz", "xy")


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
                    "max_residual_lower": 0.2 * (1.0 - 1.0 / alpha) * interference * done,
                    "max_residual_upper": 0.2 * (1.0 - 1.0 / alpha) * interference * done,
                    "max_equivalent_plastic_strain": 0.004 * alpha * done,
                    "iterations": 8 + i % 5,
                }
            )
    return rows


def summary_of(alpha: float, rows: list[dict[str, float]]) -> dict[str, Any]:
    """The part of summary.json that is read, and a little more."""
    return {
        "format": "brinell-summary",
        "format_version": 1,
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
    }


def _dataset(group: h5py.Group, name: str, values: np.ndarray, unit: str = "1") -> None:
    data = group.create_dataset(name, data=values, compression="gzip", shuffle=True)
    data.attrs["units"] = unit
    data.attrs["long_name"] = name.replace("_", " ")


def write_state(group: h5py.Group, row: dict[str, float], alpha: float, *, final: bool, elastic_upper: bool) -> None:
    """One group of result.h5."""
    a_c = CRITICAL["contact_radius_m"]
    for name in ("step", "X", "theta", "interference", "F_X", "F_Y", "F_Z"):
        group.attrs[name] = int(row[name]) if name == "step" else row[name]
    group.attrs["pass"] = 0
    touching = row["F_n"] > 0.0 and not final
    radius = a_c * np.sqrt(max(row["interference"], 0.0) / CRITICAL["interference_m"])

    nx, ny, dx, dy = 41, 21, 0.15 * a_c * np.sqrt(alpha), 0.3 * a_c * np.sqrt(alpha)
    origin = np.array([-0.5 * (nx - 1) * dx, -0.5 * (ny - 1) * dy])
    contact = group.create_group("contact")
    contact.attrs["spacing"], contact.attrs["origin"] = [dx, dy], origin
    x, y = origin[0] + dx * np.arange(nx), origin[1] + dy * np.arange(ny)
    r2 = (x[None, :] ** 2 + y[:, None] ** 2) / max(radius, 1e-12) ** 2
    peak = row["max_pressure"]
    pressure = peak * np.sqrt(np.clip(1.0 - r2, 0.0, None)) if touching else np.zeros_like(r2)
    gap = np.clip(r2 - 1.0, 0.0, None) ** 1.5 * 1e-5 if touching else np.full_like(r2, 1e-5)
    _dataset(contact, "pressure", pressure, "Pa")
    _dataset(contact, "gap", gap, "m")

    moved = 0.5 * row["X"]
    for name, sign in (("lower", 1.0), ("upper", -1.0)):
        body = group.create_group(name)
        bx, by, nz, dz = 61, 15, 20, 0.15 * a_c * np.sqrt(alpha)
        start = np.array([-0.5 * (bx - 1) * dx, -0.5 * (by - 1) * dy, 0.5 * dz])
        body.attrs["spacing"], body.attrs["origin"], body.attrs["contact_x"] = [dx, dy, dz], start, sign * moved
        X = start[0] + dx * np.arange(bx)
        Y = start[1] + dy * np.arange(by)
        Z = start[2] + dz * np.arange(nz)
        size = a_c * np.sqrt(alpha)
        x_in = (X - sign * moved) / size
        depth = 1e-3 + row["max_residual_lower"]
        lateral = Y[:, None] / (0.6 * size)
        dent = (1.0 - 0.4 * lateral**2) * np.exp(-(lateral**2)) * np.exp(-((X[None, :] / (1.2 * size)) ** 2))
        shape = np.exp(-(x_in[None, None, :] ** 2) - (Y[None, :, None] / size) ** 2)
        under = np.exp(-(((Z[:, None, None] / size - 0.48) / 0.35) ** 2))
        strain = np.clip(shape * under - 0.2, 0.0, None) * row["max_equivalent_plastic_strain"]
        von_mises = (0.95 if touching else 0.3) * 0.9115e9 * shape * under
        if name == "upper" and elastic_upper:
            _dataset(body, "von_mises_stress", von_mises, "Pa")
            _dataset(body, "residual_displacement", np.zeros((by, bx)), "m")
            continue
        _dataset(body, "residual_displacement", depth * dent, "m")
        _dataset(body, "equivalent_plastic_strain", strain)
        _dataset(body, "von_mises_stress", von_mises, "Pa")
        for kind, unit in (("plastic_strain", "1"), ("stress", "Pa")):
            tensor = body.create_group(kind)
            for index, component in enumerate(COMPONENTS):
                _dataset(tensor, component, (index + 1.0) * strain, unit)


def write_run(
    folder: Path,
    alpha: float = 9.0,
    *,
    passes: int = 1,
    steps: int = 25,
    finished: bool = True,
    elastic_upper: bool = False,
) -> Path:
    """A whole result folder; without summary.json and final state if it is not finished."""
    folder.mkdir(parents=True)
    rows = history_rows(alpha, passes, steps)
    names = HEADER.split(",")
    lines = [
        HEADER,
        *(
            ",".join(repr(float(row[n])) if n not in ("step", "iterations") else str(int(row[n])) for n in names)
            for row in rows
        ),
    ]
    (folder / "history.csv").write_text("\n".join(lines) + "\n", encoding="utf-8")
    with h5py.File(folder / "result.h5", "w") as file:
        file.attrs["format"], file.attrs["format_version"] = "brinell-result", 1
        group = file.create_group("steps")
        for index in (steps // 4, steps // 2):
            state = group.create_group(f"{index:06d}")
            write_state(state, rows[index], alpha, final=False, elastic_upper=elastic_upper)
        if finished:
            write_state(file.create_group("final"), rows[-1], alpha, final=True, elastic_upper=elastic_upper)
    if finished:
        text = json.dumps(summary_of(alpha, rows), indent=2)
        (folder / "summary.json").write_text(text, encoding="utf-8")
    return folder


@pytest.fixture(autouse=True)
def coarse_pixels(monkeypatch: pytest.MonkeyPatch) -> None:
    """Nobody looks at the pictures of a test: write few pixels."""
    monkeypatch.setitem(style._RC, "savefig.dpi", 40)


@pytest.fixture(scope="session")
def written_runs(tmp_path_factory: pytest.TempPathFactory) -> Callable[..., Path]:
    """Writes each kind of result folder once."""

    @functools.cache
    def written(alpha: float, **options: Any) -> Path:
        return write_run(tmp_path_factory.mktemp("runs") / "run", alpha, **options)

    return written


@pytest.fixture
def make_run(tmp_path: Path, written_runs: Callable[..., Path]) -> Callable[..., Path]:
    """Puts a result folder under the test's own folder and returns its path."""

    def make(alpha: float = 9.0, name: str | None = None, **options: Any) -> Path:
        return shutil.copytree(written_runs(alpha, **options), tmp_path / (name or f"alpha{alpha:g}"))

    return make


if __name__ == "__main__":  # python tests/conftest.py DIR: a set to look at
    for value in (1.0, 2.0, 4.0, 6.0, 9.0):
        print(write_run(Path(sys.argv[1]) / f"alpha{value:g}", value))
