# SPDX-License-Identifier: BSD-3-Clause
"""Figures of results; each function returns a matplotlib Figure, `style.save` writes it.

Modules: `paper` (Figs. 11-15 of Boucly, Nelias, Green 2006), `fields` (one state), `history` (one run over time),
`style` (the look of all of them), `scales` (what each quantity is divided by), `cli` (the command brinell-plot).
"""

from brinell.plot.fields import pressure_map, residual_surfaces, section
from brinell.plot.history import run_history
from brinell.plot.paper import fig11, fig12, fig13, fig14, fig15, overview
from brinell.plot.style import save

__all__ = [
    "fig11",
    "fig12",
    "fig13",
    "fig14",
    "fig15",
    "overview",
    "pressure_map",
    "residual_surfaces",
    "run_history",
    "save",
    "section",
]
