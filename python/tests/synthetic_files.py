# SPDX-License-Identifier: BSD-3-Clause
"""Result folders of made-up runs, in the format of docs/reference/results-format.md; fields are smooth bumps."""

from __future__ import annotations

import json
from collections.abc import Callable, Iterable
from pathlib import Path
from typing import Any

import h5py
import numpy as np

from synthetic_histories import (
    CRITICAL,
    general_summary,
    history_rows,
    indentation_rows,
    indents_of,
    rolling_results,
    rolling_rows,
    summary_of,
)

ENERGIES = (
    "work,dissipation_lower,dissipation_upper,energy_residual,energy_elastic,max_residual_lower,max_residual_upper,"
    "max_equivalent_plastic_strain,evaluations"
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
INTEGERS = ("step", "pass", "place", "evaluations")
COMPONENTS = ("xx", "yy", "zz", "yz", "xz", "xy")


def _dataset(group: h5py.Group, name: str, values: np.ndarray, unit: str = "1") -> None:
    data = group.create_dataset(name, data=values, compression="gzip", shuffle=True)
    data.attrs["units"] = unit
    data.attrs["long_name"] = name.replace("_", " ")


def write_state(
    group: h5py.Group, row: dict[str, float], *, size: float, dents: tuple[str, ...], rigid_upper: bool
) -> None:
    """One group of result.vtkhdf: a round patch of pressure, and around it a bump of plastic strain in each body.

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
    with h5py.File(folder / "result.vtkhdf", "w") as file:
        file.attrs["format"], file.attrs["format_version"] = "brinell-result", 3
        file.attrs["scenario"] = summary["scenario"]
        for name in names:
            integer = name in INTEGERS
            file[f"history/{name}"] = np.array([row[name] for row in rows], dtype=np.int32 if integer else np.float64)
        file["case"] = f'scenario = "{summary["scenario"]}"\n'
        group = file.create_group("steps")
        for step in stored:
            write_state(group.create_group(f"{step:06d}"), rows[step], **look)
        if finished:
            write_state(file.create_group("final"), rows[-1] | {"F_n": 0.0}, **look)
            file["summary"] = json.dumps(summary)
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
        general_summary("indentation", indents=indents_of(rows), run={"steps": len(rows)}, **options),
        range(steps - 1, len(rows), steps),
        size=3.0 * CRITICAL["contact_radius_m"],
        finished=finished,
        dents=("lower",) if yields else (),
        rigid_upper=True,
    )


def write_rolling(
    folder: Path, load: float = 3e6, *, passes: int = 3, finished: bool = True, yields: bool = True, **options: Any
) -> Path:
    """Rolling of an elastic body over one that yields, with the middle of each pass stored."""
    load_steps, rolling_steps = 3, 10
    rows = rolling_rows(load, passes, load_steps, rolling_steps)
    per_pass = 2 * load_steps + rolling_steps
    summary = general_summary("rolling", run={"steps": len(rows)}, **rolling_results(passes))
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


WRITERS: dict[str, Callable[..., Path]] = {
    "tugging": write_run,
    "indentation": write_indentation,
    "rolling": write_rolling,
}
