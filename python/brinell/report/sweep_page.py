# SPDX-License-Identifier: BSD-3-Clause
"""The report page of a sweep: warnings, key numbers over what varies, and a table of the runs."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from importlib.resources import files
from pathlib import Path
from typing import TYPE_CHECKING, Any

from markupsafe import Markup

import brinell
from brinell.plot import style
from brinell.plot.differences import case_of
from brinell.plot.standard import Named
from brinell.plot.sweeps import KeyNumbers, key_numbers_of, sweep_numbers
from brinell.report.page import Shown, environment, shown
from brinell.results import Run
from brinell.results.key_units import key_unit
from brinell.scenarios import SCENARIOS

if TYPE_CHECKING:
    from brinell.sweeps import Sweep

__all__ = ["write_sweep_report"]

_MOST_OVERLAID = 6
"""Runs up to which the figures of several runs are legible."""


@dataclass(frozen=True)
class _Row:
    """A run in the table."""

    index: int
    link: str
    """To the report of the run; empty if there is none."""
    cells: list[str]


def write_sweep_report(sweep: Sweep, path: str | Path) -> Path:
    """Writes a sweep as one HTML page that needs no other file and no network.

    Args:
        sweep: with or without further columns of `Sweep.with_numbers`.
        path: of the page; its folder is made if it is not there.

    Returns:
        The path.

    Raises:
        RunError: a file of a run is damaged.
    """
    path = Path(path)
    page = environment().get_template("sweep.html.j2").render(**_content(sweep, path.parent))
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(page, encoding="utf-8")
    return path


def _content(sweep: Sweep, folder: Path) -> dict[str, Any]:
    runs = dict(sweep.runs)
    numbers = key_numbers_of(runs)
    first = next(iter(runs.values()), None)
    own = _own_columns(sweep)
    return {
        "title": (first.title if first else "") or sweep.path.resolve().name,
        "folder": sweep.path.resolve().name,
        "scenario": first.scenario if first else "no finished run",
        "findings": _findings(sweep, sweep.done),
        "count": sweep.done,
        "figures": _figures(runs),
        "columns": ["run", *(_heading(key, first) for key in numbers.varied), *numbers.numbers, *own],
        "rows": [_row(sweep, folder, numbers, i, own) for i in range(len(runs))],
        "style": Markup((files("brinell.report") / "templates" / "report.css").read_text(encoding="utf-8")),
        "tools": f"brinell {brinell.__version__}",
    }


def _findings(sweep: Sweep, done: int) -> list[str]:
    """Failures, and how many runs have which warning."""
    found = [f"Run {row['index']} failed: {row['reason']}" for _, row in sweep.failures.iterrows()]
    for key, indices in sweep.warnings.items():
        which = (
            "all runs"
            if len(indices) == done
            else f"{'run' if len(indices) == 1 else 'runs'} " + ", ".join(map(str, indices))
        )
        text = next(
            (
                one.text
                for index in indices
                if index in sweep.runs
                for one in sweep.runs[index].warnings
                if one.key == key
            ),
            "see table.csv",
        )
        found.append(f"{key} ({which}): {text}")
    return found


def _figures(runs: dict[int, Run]) -> list[Shown]:
    """Key numbers over what varies, and the figures of several runs of the scenario if these are few."""
    figures: list[Named] = []
    if (drawn := sweep_numbers(runs)) is not None:
        figures.append(Named("numbers", "Key numbers over what varies between the runs.", "result", drawn))
    drawings = SCENARIOS[next(iter(runs.values())).scenario].drawings if runs else None
    if drawings is not None and 1 < len(runs) <= _MOST_OVERLAID:
        for name, drawing in drawings().figures.items():
            draw: Callable[[list[Run]], Any] = drawing.draw
            if (figure := draw(list(runs.values()))) is not None:
                figures.append(Named(name, drawing.caption or name.replace("-", " "), "result", figure))
    return [shown(one) for one in figures]


def _own_columns(sweep: Sweep) -> list[str]:
    """Columns that the user's functions have added."""
    from brinell.sweeps.numbers import own_columns

    return own_columns(sweep.table, dict(sweep.runs))


def _heading(key: str, run: Run | None) -> str:
    unit = key_unit(key, case_of(run) if run else None)
    return f"{key} [{unit}]" if unit else key


def _row(sweep: Sweep, folder: Path, numbers: KeyNumbers, i: int, own: list[str]) -> _Row:
    index = numbers.index[i]
    page = sweep.runs[index].path / "report.html"
    cells = [_plain(values[i]) for values in numbers.varied.values()]
    for unit, values in numbers.numbers.values():
        value = values[i]
        if value != value:  # NaN
            cells.append("–")
        elif unit == "%":
            cells.append(f"{100 * value:.4g} %")
        else:
            cells.append(style.quantity(value, unit) if unit else f"{value:.6g}")
    row = sweep.table.loc[sweep.table["index"] == index].iloc[0]
    cells += [_plain(row[name]) for name in own]
    link = page.resolve().relative_to(folder.resolve()).as_posix() if _is_below(page, folder) else ""
    return _Row(index, link, [cell.replace("$\\times 10^{", "·10^").replace("}$", "") for cell in cells])


def _is_below(page: Path, folder: Path) -> bool:
    return page.is_file() and page.resolve().is_relative_to(folder.resolve())


def _plain(value: Any) -> str:
    if isinstance(value, tuple):
        return ", ".join(map(_plain, value))
    return f"{value:.6g}" if isinstance(value, float) else str(value)
