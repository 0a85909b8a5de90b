# SPDX-License-Identifier: BSD-3-Clause
"""The result of a fit: estimates with intervals, what the data cannot tell, the fitted cases, files."""

from __future__ import annotations

import json
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from brinell import _core
from brinell.case import Case
from brinell.fits.data import Data, FloatArray
from brinell.fits.text import as_text

if TYPE_CHECKING:
    from matplotlib.figure import Figure

__all__ = ["Curve", "Estimate", "Fit", "rows_of"]


@dataclass(frozen=True)
class Estimate:
    """An unknown and what is known of it now, in the units of the case.

    Attributes:
        key: dotted key.
        name: name in messages and figures.
        unit: unit; empty for plain numbers.
        value: estimate.
        low: lower end of the interval by scatter of the data, error of the method and error of the cells together.
        high: upper end.
        data_low: lower end by the scatter of the data alone.
        data_high: upper end.
        method: standard deviation by the error of the method.
        cells: shift that finer cells would make, an estimate.
        bounds: bounds of the search.
        determined: whether the data determine it; otherwise the value means nothing.
        by_profile: whether the interval of the data is that of a profile, not of the covariance.
        profile: values of the unknown, and distances of the best fits there in standard deviations; empty without one.
    """

    key: str
    name: str
    unit: str
    value: float
    low: float
    high: float
    data_low: float
    data_high: float
    method: float
    cells: float
    bounds: tuple[float, float]
    determined: bool
    by_profile: bool
    profile: tuple[tuple[float, ...], tuple[float, ...]]


@dataclass(frozen=True, eq=False)
class Curve:
    """Measured data with the fitted values.

    Attributes:
        data: the points that were compared.
        fitted: values of the run there.
        sigma: standard deviations of the points.
        line: x and y of the run between the points, branch by branch; empty for a number.
    """

    data: Data
    fitted: FloatArray
    sigma: FloatArray
    line: list[tuple[FloatArray, FloatArray]]

    @property
    def residuals(self) -> FloatArray:
        """Measured minus fitted values in standard deviations."""
        return np.asarray((self.data.y - self.fitted) / self.sigma)


@dataclass(frozen=True, eq=False)
class Fit:
    """The result of `brinell.fit`.

    Attributes:
        title: title.
        estimates: one per unknown.
        correlation: correlations of the estimates by the scatter of the data.
        covariance: covariance of the variables of the search.
        misfit: root mean square of the residuals in standard deviations.
        curves: the data and the fitted values.
        cases: the fitted case of each run.
        findings: what is to be known: keys that the data do not determine, pairs that they cannot tell apart, misfit,
            outliers, holds, bounds that were reached.
        converged: whether the search ended because nothing changed any more.
        runs: number of runs.
        seconds: time [s].
        confidence: probability of the intervals.
        settings: loss, error of the method and so on.
    """

    title: str
    estimates: list[Estimate]
    correlation: FloatArray
    covariance: FloatArray
    misfit: float
    curves: list[Curve]
    cases: list[Case]
    findings: list[str]
    converged: bool
    runs: int
    seconds: float
    confidence: float
    settings: dict[str, Any]

    def __getitem__(self, key: str) -> Estimate:
        """The estimate of a key, or of a name."""
        for one in self.estimates:
            if key in (one.key, one.name):
                return one
        raise KeyError(f"no unknown {key!r}; allowed: {', '.join(one.key for one in self.estimates)}")

    @property
    def case(self) -> Case:
        """The fitted case, of the first run if there are several."""
        return self.cases[0]

    def to_json(self) -> dict[str, Any]:
        """Everything as numbers and text, as in fit.json."""
        return {
            "format": "brinell-fit",
            "format_version": 1,
            "title": self.title,
            "converged": self.converged,
            "confidence": self.confidence,
            "settings": self.settings,
            "unknowns": [_plain(one) for one in self.estimates],
            "correlation": self.correlation.tolist(),
            "misfit": self.misfit,
            "data": [
                {
                    "name": one.data.name,
                    "kind": one.data.kind,
                    "columns": list(one.data.columns),
                    "x": one.data.x.tolist(),
                    "measured": one.data.y.tolist(),
                    "fitted": one.fitted.tolist(),
                    "sigma": one.sigma.tolist(),
                }
                for one in self.curves
            ],
            "findings": self.findings,
            "runs": self.runs,
            "wall_time_s": self.seconds,
            "versions": _core.library_versions(),
        }

    def figures(self) -> dict[str, Figure]:
        """Figures by name: each curve with its residuals, corner plot, profile over depth."""
        from brinell.plot import fits

        return fits.all_figures(self)

    def write(self, folder: str | Path, figures: bool = True) -> list[Path]:
        """Writes fit.json, the fitted cases, figures and the report page.

        Args:
            folder: folder; made if it is not there.
            figures: whether figures and the report are written.

        Returns:
            The files.
        """
        folder = Path(folder)
        folder.mkdir(parents=True, exist_ok=True)
        written = [folder / "fit.json"]
        text = json.dumps(self.to_json(), indent=1, allow_nan=False, default=str)
        written[0].write_text(text + "\n", encoding="utf-8")
        names = ["fitted.toml"] if len(self.cases) == 1 else [f"fitted-{i + 1}.toml" for i in range(len(self.cases))]
        for name, case in zip(names, self.cases, strict=True):
            case.to_toml(folder / name)
            written.append(folder / name)
        if figures:
            from brinell.plot import style
            from brinell.report.fit_page import write_fit_report

            drawn = self.figures()
            for name, figure in drawn.items():
                written += style.save(figure, folder / "figures", name)
            written.append(write_fit_report(self, folder / "report.html", drawn))
        return written

    def table(self) -> str:
        """The estimates as text."""
        rows = rows_of(self.estimates, self.confidence)
        widths = [max(len(row[i]) for row in rows) for i in range(len(rows[0]))]
        return "\n".join("  ".join(cell.ljust(w) for cell, w in zip(r, widths, strict=True)).rstrip() for r in rows)

    def __repr__(self) -> str:
        return f"<brinell.Fit {self.title!r}: {len(self.estimates)} unknowns, {self.runs} runs>\n{self.table()}"


def rows_of(estimates: Sequence[Estimate], confidence: float) -> list[tuple[str, ...]]:
    """The cells of the table of a fit, its head first."""
    rows: list[tuple[str, ...]] = [
        ("", "value", f"{100 * confidence:g} % interval", "by scatter alone", "shift by finer cells")
    ]
    for one in estimates:
        if one.determined:
            within = (f"{_text(one, one.low)} to {_text(one, one.high)}", _range(one), _text(one, one.cells))
        else:
            within = ("not determined by these data", "", "")
        rows.append((one.name, _text(one, one.value), *within))
    return rows


def _text(one: Estimate, value: float) -> str:
    return as_text(value, one.unit)


def _range(one: Estimate) -> str:
    return f"{_text(one, one.data_low)} to {_text(one, one.data_high)}"


def _plain(one: Estimate) -> dict[str, Any]:
    return {name: getattr(one, name) for name in one.__dataclass_fields__}
