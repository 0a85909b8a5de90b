# SPDX-License-Identifier: BSD-3-Clause
"""Pictures of the cases on the page `cases.md`: the build of the pages runs each case and draws what it is about."""

from __future__ import annotations

import warnings
from collections.abc import Callable, Mapping
from functools import partial
from pathlib import Path

from matplotlib.figure import Figure

import brinell
from brinell import plot
from brinell._toml import tomllib

__all__ = ["MARK", "PICTURES", "draw", "markdown"]

ROOT = Path(__file__).resolve().parents[1]

MARK = "<!-- gallery -->"
"""Where the pictures stand on the page; the code host shows nothing there."""

Draw = Callable[[brinell.Run], Figure | None]


def _of_state(function: Callable[..., Figure], state: str = "aligned", **options: object) -> Draw:
    return lambda run: function(run, state, **options)


_LOADED = _of_state(plot.section)
_RESIDUAL = _of_state(plot.residual_surfaces, "final")

PICTURES: Mapping[str, Draw] = {
    "flash-temperature": _of_state(plot.surface_temperature_maps),
    "electrical-ball": plot.contact_resistance,
    "connector-plated": plot.contact_resistance,
    "electrical-connector": _of_state(plot.current_density_map),
    "electrical-fretting": plot.resistance_course,
    "electrical-rolling": _of_state(plot.current_density_map),
    "fretting": plot.contact_maps,
    "fretting-heat": plot.contact_heat,
    "fretting-sphere": plot.force_loops,
    "fretting-wear": plot.worn_profiles,
    "indentation": _LOADED,
    "indentation-coated": _RESIDUAL,
    "indentation-sphere": plot.load_depth,
    "indentation-vickers": _RESIDUAL,
    "rolling": _RESIDUAL,
    "rolling-creepage": plot.creep_maps,
    "rolling-dent": _RESIDUAL,
    "rolling-fatigue": lambda run: plot.fatigue_under_surface(run, run.fatigue()),
    "rolling-friction": plot.depth_profiles,
    "rolling-heat": _of_state(plot.section, field="temperature"),
    "rolling-inclusion": _of_state(plot.section, "final", bodies="lower"),
    "rolling-passes": plot.pass_by_pass,
    "rolling-sliding": _LOADED,
    "rough-periodic": _of_state(plot.pressure_map),
    "rough-plastic": _of_state(plot.pressure_map),
    "sliding": plot.along_way,
    "sliding-rough": plot.surfaces_before_and_after,
    "tugging": _LOADED,
    "tugging-cylinders": _LOADED,
    "tugging-friction": _LOADED,
    "tugging-hardening": plot.run_history,
    "tugging-heat": _of_state(plot.section, field="temperature"),
    "tugging-paper": partial(plot.section, snapshot="final"),
    "tugging-rough": _LOADED,
    "tugging-wear": plot.worn_course,
}
"""The picture of each case."""


def draw(name: str, folder: Path) -> Path:
    """Runs a case and writes its picture, unless the picture is newer than all files of the case.

    Args:
        name: folder of the case in cases/.
        folder: of the picture.

    Returns:
        The file of the picture.

    Raises:
        ValueError: the figure of the case has nothing to draw.
    """
    source, path = ROOT / "cases" / name, folder / f"{name}.png"
    if path.is_file() and all(path.stat().st_mtime > file.stat().st_mtime for file in source.iterdir()):
        return path
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", brinell.ResolutionWarning)  # the pages of the cases discuss them
        run = brinell.Case.from_file(source / "case.toml").run(in_memory=True)
    figure = PICTURES[name](run)
    if figure is None:
        raise ValueError(f"cases/{name}: its figure has nothing to draw")
    return plot.save(figure, folder, name)[0]


def markdown(folder: str) -> str:
    """The pictures as Markdown, each leading to the page of its case.

    Args:
        folder: of the pictures, relative to the page.
    """
    parts = []
    for name in PICTURES:
        title = tomllib.loads((ROOT / "cases" / name / "case.toml").read_text(encoding="utf-8")).get("title", name)
        page = f"../cases/{name}/README.md"
        parts.append(f"**[{name}]({page})** – {title}\n\n[![{title}]({folder}/{name}.png)]({page})")
    return "## Pictures\n\n" + "\n\n".join(parts) + "\n"
