# SPDX-License-Identifier: BSD-3-Clause
"""Figures of results; each function returns a matplotlib Figure, `style.save` writes it.

Modules: `paper` (Figs. 11-15 of Boucly, Nelias, Green 2006), `indentation`, `rolling` (several runs of these
scenarios), `fields` and `sections` (one state of any scenario), `history` (one run step by step), `cli` (the command
brinell-plot). Below them: `style` (the look of all figures), `scales` (what each quantity is divided by), `overlay`
(several results in one figure), `states` (which state and which bodies), `cells` (cell values as pictures).
"""

from brinell.plot.fields import pressure_map, residual_surfaces, section
from brinell.plot.history import run_history
from brinell.plot.indentation import contact_pressure, imprint, load_depth
from brinell.plot.paper import fig11, fig12, fig13, fig14, fig15, overview
from brinell.plot.rolling import along_track, depth_profiles, pass_by_pass, track_profile
from brinell.plot.style import save

__all__ = [
    "along_track",
    "contact_pressure",
    "depth_profiles",
    "fig11",
    "fig12",
    "fig13",
    "fig14",
    "fig15",
    "imprint",
    "load_depth",
    "overview",
    "pass_by_pass",
    "pressure_map",
    "residual_surfaces",
    "run_history",
    "save",
    "section",
    "track_profile",
]
