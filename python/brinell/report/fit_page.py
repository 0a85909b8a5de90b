# SPDX-License-Identifier: BSD-3-Clause
"""The report page of a fit: estimates with intervals, what the data cannot tell, figures, correlations."""

from __future__ import annotations

from collections.abc import Mapping
from importlib.resources import files
from pathlib import Path
from typing import TYPE_CHECKING, Any

from markupsafe import Markup
from matplotlib.figure import Figure

import brinell
from brinell.fits.text import as_text
from brinell.plot.standard import Named
from brinell.report.page import environment, shown

if TYPE_CHECKING:
    from brinell.fits import Estimate, Fit

__all__ = ["write_fit_report"]

_CAPTIONS = {
    "curve": "Measured points and the fitted curve; below, the residuals in standard deviations.",
    "corner": "Intervals of the unknowns (light: all errors; dark: scatter alone), and joint intervals of two, by "
    "scatter, with their correlation.",
    "profiles": "Distance of the best fit with one unknown held, in standard deviations.",
    "depth-profile": "Fitted profile over the depth, with intervals (light: all errors; dark: scatter alone).",
}


def write_fit_report(fit: Fit, path: str | Path, figures: Mapping[str, Figure] | None = None) -> Path:
    """Writes a fit as one HTML page that needs no other file and no network.

    Args:
        fit: the result of `brinell.fit`.
        path: of the page; its folder is made if it is not there.
        figures: its figures; None: they are drawn.

    Returns:
        The path.
    """
    path = Path(path)
    page = (
        environment().get_template("fit.html.j2").render(**_content(fit, fit.figures() if figures is None else figures))
    )
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(page, encoding="utf-8")
    return path


def _content(fit: Fit, figures: Mapping[str, Figure]) -> dict[str, Any]:
    named = [Named(key, _CAPTIONS[key if key in _CAPTIONS else "curve"], "result", one) for key, one in figures.items()]
    return {
        "title": fit.title,
        "findings": [text[:1].upper() + text[1:] + "." for text in fit.findings],
        "confidence": f"{100 * fit.confidence:g} %",
        "rows": [_row(one) for one in fit.estimates],
        "names": [one.name for one in fit.estimates],
        "correlation": [[f"{value:.3f}" for value in row] for row in fit.correlation],
        "figures": [shown(one) for one in named],
        "misfit": f"{fit.misfit:.3g}",
        "cost": f"{fit.runs} runs, {fit.seconds:.0f} s",
        "method": f"{100 * fit.settings['method_error']:g} %",
        "case": fit.case.to_toml(),
        "style": Markup((files("brinell.report") / "templates" / "report.css").read_text(encoding="utf-8")),
        "tools": f"brinell {brinell.__version__}",
    }


def _row(one: Estimate) -> list[str]:
    def text(value: float) -> str:
        return as_text(value, one.unit)

    if not one.determined:
        return [one.name, one.key, text(one.value), "not determined by these data", "", "", ""]
    within = f"{text(one.low)} to {text(one.high)}"
    scatter = f"{text(one.data_low)} to {text(one.data_high)}{' (profile)' if one.by_profile else ''}"
    return [one.name, one.key, text(one.value), within, scatter, text(one.method), text(one.cells)]
