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
from collections.abc import Callable, Iterable
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
ENERGIES = (
    "work,dissipation_lower,dissipation_upper,energy_residual,energy_elastic,max_residual_lower,max_residual_upper,"
    "max_equivalent_plastic_strain,iterations"
)
HEADERS = {
    "tugging": (
        "step,pass,X,theta,interference,contact_area,max_pressure,F_n,F_X,F_Y,F_Z,F_X_macro,F_Z_macro," + ENERGIES
    ),
    "indentation": (
        "step,pass,place,x,approach,F_n,contact_area,contact_radius,max_pressure,mean_pressure,residual_depth,pile_up,"
        + ENERGIES
    ),
    "rolling": "step,pass,x,approach,F_n,F_X,contact_area,max_pressure," + ENERGIES,
}
"""As the program writes them."""
INTEGERS = ("step", "pass", "place", "iterations")
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
                    "pass": index,
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
        "case": {},
    }


def _dataset(group: h5py.Group, name: str, values: np.ndarray, unit: str = "1") -> None:
    data = group.create_dataset(name, data=values, compression="gzip", shuffle=True)
    data.attrs["units"] = unit
    data.attrs["long_name"] = name.replace("_", " ")


def write_state(
    group: h5py.Group, row: dict[str, float], *, size: float, dents: tuple[str, ...], rigid_upper: bool
) -> None:
    """One group of result.h5: a round patch of pressure, and around it a bump of plastic strain in each body.

    Args:
        group: empty.
        row: of the history.
        size: contact radius, by which the grids are laid out [m].
        dents: which bodies yield.
        rigid_upper: nothing is stored of the upper body.
    """
    for name, value in row.items():
        group.attrs[name] = int(value) if name in INTEGERS else value
    spacing = np.array([0.15, 0.3]) * size
    write_contact(group.create_group("contact"), row, spacing)
    moved = 0.5 * row["X"] if "X" in row else row["x"]
    for name, sign in (("lower", 1.0), ("upper", -1.0 if "X" in row else 1.0)):
        body = group.create_group(name)
        body.attrs["contact_x"] = sign * moved
        body.attrs["spacing"] = [*spacing, spacing[0]]
        body.attrs["origin"] = [-30.0 * spacing[0], -7.0 * spacing[1], 0.5 * spacing[0]]
        if name == "lower" or not rigid_upper:
            write_body(body, row, size, yields=name in dents)


def write_contact(group: h5py.Group, row: dict[str, float], spacing: np.ndarray) -> None:
    """41 x 21 cells around the middle of the contact."""
    nx, ny = 41, 21
    origin = -0.5 * np.array([nx - 1, ny - 1]) * spacing
    group.attrs["spacing"], group.attrs["origin"] = spacing, origin
    x, y = origin[0] + spacing[0] * np.arange(nx), origin[1] + spacing[1] * np.arange(ny)
    touching = row["F_n"] > 0.0
    radius = np.sqrt(row["contact_area"] / np.pi) if touching else 1.0
    r2 = (x[None, :] ** 2 + y[:, None] ** 2) / radius**2
    pressure = row["max_pressure"] * np.sqrt(np.clip(1.0 - r2, 0.0, None)) if touching else np.zeros_like(r2)
    gap = np.clip(r2 - 1.0, 0.0, None) ** 1.5 * 1e-5 if touching else np.full_like(r2, 1e-5)
    _dataset(group, "pressure", pressure, "Pa")
    _dataset(group, "gap", gap, "m")


def write_body(group: h5py.Group, row: dict[str, float], size: float, *, yields: bool) -> None:
    """20 x 15 x 61 cells; a body that stays elastic has no plastic fields."""
    count = (61, 15, 20)
    x, y, z = (
        o + d * np.arange(n) for o, d, n in zip(group.attrs["origin"], group.attrs["spacing"], count, strict=True)
    )
    lateral = y[:, None] / (0.6 * size)
    dent = (1.0 - 0.4 * lateral**2) * np.exp(-(lateral**2)) * np.exp(-((x[None, :] / (1.2 * size)) ** 2))
    x_in = (x - group.attrs["contact_x"]) / size
    shape = np.exp(-(x_in[None, None, :] ** 2) - (y[None, :, None] / size) ** 2)
    under = np.exp(-(((z[:, None, None] / size - 0.48) / 0.35) ** 2))
    share = 0.95 if row["F_n"] > 0.0 else 0.3 if yields else 0.0
    von_mises = share * 0.9115e9 * shape * under
    _dataset(group, "von_mises_stress", von_mises, "Pa")
    if not yields:
        _dataset(group, "residual_displacement", np.zeros((len(y), len(x))), "m")
        return
    strain = np.clip(shape * under - 0.2, 0.0, None) * row["max_equivalent_plastic_strain"]
    _dataset(group, "residual_displacement", row["max_residual_lower"] * dent, "m")
    _dataset(group, "equivalent_plastic_strain", strain)
    for kind, unit in (("plastic_strain", "1"), ("stress", "Pa")):
        tensor = group.create_group(kind)
        for index, component in enumerate(COMPONENTS):
            _dataset(tensor, component, (index + 1.0) * strain, unit)


def write_folder(
    folder: Path,
    rows: list[dict[str, float]],
    summary: dict[str, Any],
    stored: Iterable[int],
    *,
    size: float,
    finished: bool,
    dents: tuple[str, ...] = ("lower", "upper"),
    rigid_upper: bool = False,
) -> Path:
    """A whole result folder; without summary.json and final state if it is not finished."""
    folder.mkdir(parents=True)
    header = HEADERS[summary["scenario"]]
    names = header.split(",")
    lines = [",".join(str(int(row[n])) if n in INTEGERS else repr(float(row[n])) for n in names) for row in rows]
    (folder / "history.csv").write_text("\n".join([header, *lines]) + "\n", encoding="utf-8")
    look: dict[str, Any] = {"size": size, "dents": dents, "rigid_upper": rigid_upper}
    with h5py.File(folder / "result.h5", "w") as file:
        file.attrs["format"], file.attrs["format_version"] = "brinell-result", 1
        file.attrs["scenario"] = summary["scenario"]
        group = file.create_group("steps")
        for step in stored:
            write_state(group.create_group(f"{step:06d}"), rows[step], **look)
        if finished:
            write_state(file.create_group("final"), rows[-1] | {"F_n": 0.0}, **look)
    if finished:
        (folder / "summary.json").write_text(json.dumps(summary, indent=2), encoding="utf-8")
    return folder


def write_run(
    folder: Path,
    alpha: float = 9.0,
    *,
    passes: int = 1,
    steps: int = 25,
    finished: bool = True,
    elastic_upper: bool = False,
) -> Path:
    """A tugging with two stored steps."""
    rows = history_rows(alpha, passes, steps)
    size = CRITICAL["contact_radius_m"] * np.sqrt(alpha)
    return write_folder(
        folder,
        rows,
        summary_of(alpha, rows),
        (steps // 4, steps // 2),
        size=size,
        finished=finished,
        dents=("lower",) if elastic_upper else ("lower", "upper"),
    )


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
        "iterations": 6 + step % 4,
    }


def general_summary(scenario: str, *, texture: str = "smooth", upper: str = "sphere", **more: Any) -> dict[str, Any]:
    """What both scenarios have in summary.json; no first yield unless the indenter is a sphere."""
    return {
        "format": "brinell-summary",
        "format_version": 1,
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
                    "pass": index,
                    "place": index // cycles,
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
    for index in range(int(rows[-1]["pass"]) + 1):
        top = max((row for row in rows if row["pass"] == index), key=lambda row: row["F_n"])
        indents.append(
            {
                "place": top["place"],
                "cycle": sum(one["place"] == top["place"] for one in indents),
                "x_m": top["x"],
                "max_load_N": top["F_n"],
                "max_approach_m": top["approach"],
                "contact_area_m2": top["contact_area"],
                "hardness_Pa": top["mean_pressure"],
                "loading_stiffness_N_per_m": 1.5 * top["F_n"] / top["approach"],
                "unloading_stiffness_N_per_m": 4.0 * top["F_n"] / top["approach"],
                "final_approach_m": None if index else 0.6 * top["approach"],
                "residual_depth_m": top["max_residual_lower"],
                "pile_up_m": top["pile_up"],
                "work_J": top["work"],
            }
        )
    return indents


def write_indentation(
    folder: Path,
    load: float = 3e6,
    *,
    cycles: int = 1,
    places: tuple[float, ...] = (0.0,),
    steps: int = 8,
    finished: bool = True,
    yields: bool = True,
    **options: str,
) -> Path:
    """An indentation by a rigid body, with the ends of the loads stored."""
    rows = indentation_rows(load, cycles, places, steps)
    return write_folder(
        folder,
        rows,
        general_summary("indentation", indents=indents_of(rows), **options),
        range(steps - 1, len(rows), steps),
        size=3.0 * CRITICAL["contact_radius_m"],
        finished=finished,
        dents=("lower",) if yields else (),
        rigid_upper=True,
    )


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
                    "pass": index,
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
            "rut_depth_m": 1e-4 * (1.0 - 0.5**n),
            "shoulder_height_m": 1e-5 * (1.0 - 0.5**n),
            "max_equivalent_plastic_strain": 0.02,
            "track_plastic_strain": 0.015 * (1.0 - 0.1**n),
            "track_plastic_increment": 0.015 * 0.1 ** (n - 1),
            "dissipation_J": 2.0 * 0.1 ** (n - 1),
            "resistance_N": 50.0 / n,
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


def write_rolling(
    folder: Path, load: float = 3e6, *, passes: int = 3, finished: bool = True, yields: bool = True, **options: Any
) -> Path:
    """Rolling of an elastic body over one that yields, with the middle of each pass stored."""
    load_steps, rolling_steps = 3, 10
    rows = rolling_rows(load, passes, load_steps, rolling_steps)
    per_pass = 2 * load_steps + rolling_steps
    summary = general_summary("rolling", **rolling_results(passes))
    summary["case"]["rolling"] = options or {"load": load}
    return write_folder(
        folder,
        rows,
        summary,
        [n * per_pass + load_steps + rolling_steps // 2 - 1 for n in range(passes)],
        size=2.0 * CRITICAL["contact_radius_m"],
        finished=finished,
        dents=("lower",) if yields else (),
    )


@pytest.fixture(autouse=True)
def coarse_pixels(monkeypatch: pytest.MonkeyPatch) -> None:
    """Nobody looks at the pictures of a test: write few pixels."""
    monkeypatch.setitem(style._RC, "savefig.dpi", 40)


WRITERS: dict[str, Callable[..., Path]] = {
    "tugging": write_run,
    "indentation": write_indentation,
    "rolling": write_rolling,
}


@pytest.fixture(scope="session")
def written_runs(tmp_path_factory: pytest.TempPathFactory) -> Callable[..., Path]:
    """Writes each kind of result folder once."""

    @functools.cache
    def written(scenario: str, drive: float, **options: Any) -> Path:
        return WRITERS[scenario](tmp_path_factory.mktemp("runs") / "run", drive, **options)

    return written


@pytest.fixture
def make_run(tmp_path: Path, written_runs: Callable[..., Path]) -> Callable[..., Path]:
    """Puts the result folder of a tugging under the test's own folder and returns its path."""

    def make(alpha: float = 9.0, name: str | None = None, **options: Any) -> Path:
        return shutil.copytree(written_runs("tugging", alpha, **options), tmp_path / (name or f"alpha{alpha:g}"))

    return make


def _maker(scenario: str, tmp_path: Path, written_runs: Callable[..., Path]) -> Callable[..., Path]:
    def make(load: float = 3e6, name: str = scenario, **options: Any) -> Path:
        return shutil.copytree(written_runs(scenario, load, **options), tmp_path / name)

    return make


@pytest.fixture
def make_indentation(tmp_path: Path, written_runs: Callable[..., Path]) -> Callable[..., Path]:
    """The same of an indentation."""
    return _maker("indentation", tmp_path, written_runs)


@pytest.fixture
def make_rolling(tmp_path: Path, written_runs: Callable[..., Path]) -> Callable[..., Path]:
    """The same of a rolling."""
    return _maker("rolling", tmp_path, written_runs)


if __name__ == "__main__":  # python tests/conftest.py DIR: a set to look at
    for value in (1.0, 2.0, 4.0, 6.0, 9.0):
        print(write_run(Path(sys.argv[1]) / f"alpha{value:g}", value))
    print(write_indentation(Path(sys.argv[1]) / "indentation"), write_rolling(Path(sys.argv[1]) / "rolling"))
