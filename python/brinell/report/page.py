# SPDX-License-Identifier: BSD-3-Clause
"""Generation of the report page: collects the data of a run and fills the template."""

from __future__ import annotations

import base64
import io
import json
from collections.abc import Mapping
from dataclasses import dataclass
from importlib.resources import files
from pathlib import Path
from typing import Any

import matplotlib
from jinja2 import Environment, PackageLoader, StrictUndefined
from markupsafe import Markup
from matplotlib.figure import Figure

import brinell
from brinell.plot import style
from brinell.plot.standard import Named, standard_figures
from brinell.report.findings import findings_of
from brinell.report.inputs import inputs_of
from brinell.report.numbers import accuracies_of, cost_of, energies_of, key_numbers
from brinell.report.volumes import pictures_of
from brinell.results import Run, Snapshot

__all__ = ["Shown", "environment", "shown", "write_report"]

_GROUPS: Mapping[str, str] = {
    "result": "Results",
    "loaded": "Under load",
    "end": "At the end, under load",
    "residual": "After unloading",
    "course": "Course of the run",
    "energy": "Energy balance",
}
"""Headings of the figures by `Named.group`."""


@dataclass(frozen=True)
class Shown:
    """A figure as part of the page."""

    name: str
    caption: str
    source: str
    """Address that holds the picture itself."""


def write_report(run: Run, path: str | Path) -> Path:
    """Writes a run as one HTML page that needs no other file and no network.

    Args:
        run: finished or not; of one that is not, what there is.
        path: of the page; its folder is made if it is not there.

    Returns:
        The path.

    Raises:
        RunError: a file of the run is damaged.
    """
    path = Path(path)
    page = environment().get_template("report.html.j2").render(**_content(run))
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(page, encoding="utf-8")
    return path


def environment() -> Environment:
    """Templates of pages."""
    environment = Environment(
        loader=PackageLoader("brinell.report"),
        autoescape=True,
        undefined=StrictUndefined,
        trim_blocks=True,
        lstrip_blocks=True,
    )
    environment.filters["symbols"] = _symbols
    return environment


def _symbols(label: str) -> Markup:
    """A text with its symbols set as mathematics: F_X, P_c, p0_c.

    >>> _symbols("7.32 P_c")
    Markup('7.32 <i>P</i><sub>c</sub>')
    >>> _symbols("go_on")
    Markup('go_on')
    """
    words = []
    for word in label.split(" "):
        letter, mark, index = word.partition("_")
        is_symbol = mark and len(index) <= 2 and (len(letter) == 1 or (letter[1:].isdecimal() and len(letter) == 2))
        words.append(Markup("<i>{}</i><sub>{}</sub>").format(letter, index) if is_symbol else Markup.escape(word))
    return Markup(" ").join(words)


def _content(run: Run) -> dict[str, Any]:
    """Values of all variables of the template."""
    # Reading plotly takes time that other commands should not spend.
    from plotly.offline import get_plotlyjs, get_plotlyjs_version

    loaded, final = _states(run)
    pictures = pictures_of(loaded, final)
    templates = files("brinell.report") / "templates"
    tools = {"brinell": brinell.__version__, "matplotlib": matplotlib.__version__, "plotly.js": get_plotlyjs_version()}
    return {
        "title": run.title or run.path.resolve().name,
        "folder": run.path.resolve().name,
        "scenario": run.scenario,
        "complete": run.complete,
        "findings": findings_of(run),
        "resolution": (run.summary or {}).get("resolution", {}).get("text", ""),
        "accuracies": accuracies_of(run),
        "numbers": key_numbers(run),
        "energies": energies_of(run),
        "cost": cost_of(run),
        "inputs": inputs_of(run) if run.complete else {},
        "sources": run.sources,
        "groups": _groups(run),
        "has_surfaces": bool(pictures.surfaces),
        "has_volumes": bool(pictures.volumes),
        "bodies": list(dict.fromkeys(one["body"] for one in pictures.volumes)),
        "note": pictures.note,
        "data": Markup(json.dumps(pictures.as_json(), separators=(",", ":")).replace("</", "<\\/")),
        "style": Markup((templates / "report.css").read_text(encoding="utf-8")),
        "script": Markup((templates / "report.js").read_text(encoding="utf-8")),
        "plotly": Markup(get_plotlyjs()),
        "versions": (run.summary or {}).get("versions", {}),
        "tools": {name: version for name, version in tools.items() if version != "unknown"},
    }


def _states(run: Run) -> tuple[Snapshot | None, Snapshot | None]:
    """The states under load and at the end, if they are stored and have data."""
    aligned = run.snapshot("aligned") if run.steps else None
    loaded = aligned if aligned is not None and aligned.in_contact else None
    return loaded, run.snapshot("final", tensors=True) if run.complete else None


def _groups(run: Run) -> dict[str, list[Shown]]:
    """The figures under their headings, in the order of the headings."""
    groups: dict[str, list[Shown]] = {heading: [] for heading in _GROUPS.values()}
    for named in standard_figures(run):
        groups[_GROUPS[named.group]].append(shown(named))
    return {heading: figures for heading, figures in groups.items() if figures}


def shown(named: Named) -> Shown:
    """A figure as part of a page."""
    return Shown(named.name, named.caption, _address(named.figure))


def _address(figure: Figure) -> str:
    """A figure as a data address: a vector drawing with its text as curves."""
    buffer = io.BytesIO()
    with style.look():
        figure.savefig(buffer, format="svg", metadata={"Date": None})
    return "data:image/svg+xml;base64," + base64.b64encode(buffer.getvalue()).decode("ascii")
