# SPDX-License-Identifier: BSD-3-Clause
"""Reads results of ``brinell run``: a folder, or its file ``result.vtkhdf`` alone.

docs/reference/results-format.md describes the format, version 3. All numbers are in SI units (`theta` in radians).
Depths and displacements are positive into the body, stress is positive in tension, pressure in compression. A damaged
result raises a `RunError` that says where the problem is.

    run = brinell.open("results/alpha9")                     # run.scenario: "tugging"
    run.history["F_X"] / run.critical.load
    run.snapshot("aligned").lower.von_mises_stress           # all fields of one state, as NumPy arrays
    run.field("lower", "von_mises_stress").sel(step=12, y=0.0, method="nearest").values   # one field of all states

    brinell.open("results/vickers").indents[0].hardness      # "indentation"
    brinell.open("results/raceway").passes[-1].rut_depth     # "rolling"; also .profile.residual_xx over .profile.depth
    brinell.open("results/fretted").cycles[-1].work          # "fretting"

Modules: `opening`, `run` (the result; `brinell.scenarios` has the parts that are specific to a scenario), `history`,
`result_file` (result.vtkhdf), `snapshots` (the fields of a state), `surface_fields` (those that exist where friction,
heat, wear or a current acts), `fields` and `labelled` (a field over all states), `interfaces` (tractions between
the layers of coated bodies), `points` (histories at points).
"""

from brinell.results.accuracy import Accuracy, RunWarning
from brinell.results.columns import HISTORY_COLUMNS
from brinell.results.errors import FORMAT_VERSION, RunError
from brinell.results.fatigue import Fatigue, FatiguePlace
from brinell.results.history import History
from brinell.results.interfaces import Interface
from brinell.results.labelled import Labelled
from brinell.results.opening import open_run
from brinell.results.points import PointHistory
from brinell.results.run import Run
from brinell.results.snapshots import COMPONENTS, BodyFields, ContactFields, Snapshot
from brinell.results.surface_fields import FieldsOfBody, FieldsOfContact
from brinell.scenarios import Scenario
from brinell.scenarios.lists import FrettingCycle, Indent, RollingPass, SlidingStroke
from brinell.scenarios.rolling import TrackProfile
from brinell.summary import CriticalValues

__all__ = [
    "COMPONENTS",
    "FORMAT_VERSION",
    "HISTORY_COLUMNS",
    "Accuracy",
    "BodyFields",
    "ContactFields",
    "CriticalValues",
    "Fatigue",
    "FatiguePlace",
    "FieldsOfBody",
    "FieldsOfContact",
    "FrettingCycle",
    "History",
    "Indent",
    "Interface",
    "Labelled",
    "PointHistory",
    "RollingPass",
    "Run",
    "RunError",
    "RunWarning",
    "Scenario",
    "SlidingStroke",
    "Snapshot",
    "TrackProfile",
    "open_run",
]
