# SPDX-License-Identifier: BSD-3-Clause
"""Figures of results; each function returns a matplotlib Figure, `style.save` writes it.

With `ax` a function draws into axes of the caller: as many as the figure has panels, or a figure or subfigure.
Settings of matplotlib (`matplotlib.rcParams`) that the caller has changed are respected. A figure of several runs names
them by their titles, or by what differs between their cases.

Modules: `paper` (Figs. 11-15 of Boucly, Nelias, Green 2006), `indentation`, `rolling`, `fretting`, `sliding` (several
runs of these scenarios), `track_depth` (depth profiles after rolling), `patches` and `run_in` (contact and surfaces of
a sliding), `rough` (several rough surfaces over a period), `creepage` (steady rolling at several creepages), `fields`,
`sections` and `depth` (one state of any scenario), `slip` and `friction_heat` (stick and slip, and the heat of
friction, in one state), `current` (electric contact), `history`, `energy` and `wear` (one run step by step), `points`
(histories at points within the bodies), `interfaces` (tractions between the layers of coated bodies), `residual` (the
permanent shape of the surfaces), `temperature` (step by step, and in one state), `animation` and `pressure` (one pass
as a moving picture), `asperities` (maps and sums of passing asperities), `standard` (what suits a run), `surfaces` (a
height map), `curves` (a measured stress-strain curve), `sweeps` (key numbers over what varies), `fits` (curves, joint
intervals and profiles of a fit), `cli` (`brinell plot`).
Below them: `style` (the look of all figures), `placing` (figures in axes of the caller), `scales` (what each quantity
is divided by), `quantities` (the fields by name), `planes` and `cuts` (fields on a plane), `overlay` (several results
in one figure), `differences` (their names), `states` (which state and which bodies), `where` (where bodies are cut
unless told), `cells` (cell values as pictures), `sheets` (maps that are long).
"""

from brinell.plot.animation import animate, save_animation
from brinell.plot.asperities import friction_over_load, passes_map
from brinell.plot.creepage import creep_curve
from brinell.plot.current import (
    contact_resistance,
    contact_spots,
    current_density_map,
    resistance_characteristic,
    resistance_course,
)
from brinell.plot.curves import measured_curve
from brinell.plot.depth import stress_over_depth
from brinell.plot.energy import energy_balance
from brinell.plot.fatigue import fatigue_under_surface
from brinell.plot.fields import gap_map, pressure_map, residual_surfaces
from brinell.plot.fits import fit_corner, fit_curve, fit_depth_profile, fit_profiles
from brinell.plot.fretting import (
    contact_heat,
    contact_maps,
    contact_profiles,
    cycle_by_cycle,
    force_loops,
    fretting_course,
)
from brinell.plot.friction_heat import friction_heat_map
from brinell.plot.history import run_history
from brinell.plot.indentation import contact_pressure, imprint, load_depth
from brinell.plot.interfaces import interface_tractions
from brinell.plot.paper import fig11, fig12, fig13, fig14, fig15, overview
from brinell.plot.patches import contact_patches
from brinell.plot.planes import Plane
from brinell.plot.points import point_histories
from brinell.plot.quantities import QUANTITIES
from brinell.plot.rolling import (
    along_track,
    creep_forces,
    creep_heat,
    creep_maps,
    creep_profiles,
    depth_profiles,
    pass_by_pass,
    track_profile,
)
from brinell.plot.rough import contact_fraction
from brinell.plot.run_in import surfaces_before_and_after
from brinell.plot.scales import in_si
from brinell.plot.sections import section
from brinell.plot.sliding import along_way, stroke_by_stroke
from brinell.plot.slip import stick_slip_maps, stick_slip_profiles
from brinell.plot.standard import standard_figures
from brinell.plot.style import save
from brinell.plot.surfaces import surface
from brinell.plot.sweeps import sweep_numbers
from brinell.plot.temperature import surface_temperature_maps, surface_temperatures
from brinell.plot.wear import worn_course, worn_profiles

__all__ = [
    "QUANTITIES",
    "Plane",
    "along_track",
    "along_way",
    "animate",
    "contact_fraction",
    "contact_heat",
    "contact_maps",
    "contact_patches",
    "contact_pressure",
    "contact_profiles",
    "contact_resistance",
    "contact_spots",
    "creep_curve",
    "creep_forces",
    "creep_heat",
    "creep_maps",
    "creep_profiles",
    "current_density_map",
    "cycle_by_cycle",
    "depth_profiles",
    "energy_balance",
    "fatigue_under_surface",
    "fig11",
    "fig12",
    "fig13",
    "fig14",
    "fig15",
    "fit_corner",
    "fit_curve",
    "fit_depth_profile",
    "fit_profiles",
    "force_loops",
    "fretting_course",
    "friction_heat_map",
    "friction_over_load",
    "gap_map",
    "imprint",
    "in_si",
    "interface_tractions",
    "load_depth",
    "measured_curve",
    "overview",
    "pass_by_pass",
    "passes_map",
    "point_histories",
    "pressure_map",
    "residual_surfaces",
    "resistance_characteristic",
    "resistance_course",
    "run_history",
    "save",
    "save_animation",
    "section",
    "standard_figures",
    "stick_slip_maps",
    "stick_slip_profiles",
    "stress_over_depth",
    "stroke_by_stroke",
    "surface",
    "surface_temperature_maps",
    "surface_temperatures",
    "surfaces_before_and_after",
    "sweep_numbers",
    "track_profile",
    "worn_course",
    "worn_profiles",
]
