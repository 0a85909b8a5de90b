# SPDX-License-Identifier: BSD-3-Clause
"""Reads what ``brinell run`` wrote: ``history.csv``, ``summary.json``, ``result.h5`` of one folder.

The format is docs/reference/results-format.md, version 1. All numbers are SI, angles in radians, depths into the body,
stresses positive in tension, pressure in compression. Everything that is wrong with a folder is one `RunError` that
says where and what.

    run = open_run("results/alpha9")                     # run.scenario: "tugging"
    run.history["F_X"] / run.critical.load
    run.snapshot("aligned").lower.von_mises_stress

    open_run("results/vickers").indents[0].hardness      # "indentation"
    open_run("results/raceway").passes[-1].rut_depth     # "rolling"; also .profile.residual_xx over .profile.depth

Modules: `run` (the folder and its summary), `history`, `snapshots` (the fields), `scenarios` (what differs between
them).
"""

from brinell.results.errors import FORMAT_VERSION, RunError
from brinell.results.history import History
from brinell.results.run import CriticalValues, Run, open_run
from brinell.results.scenarios import HISTORY_COLUMNS, Indent, RollingPass, Scenario, TrackProfile
from brinell.results.snapshots import COMPONENTS, BodyFields, ContactFields, Snapshot

__all__ = [
    "COMPONENTS",
    "FORMAT_VERSION",
    "HISTORY_COLUMNS",
    "BodyFields",
    "ContactFields",
    "CriticalValues",
    "History",
    "Indent",
    "RollingPass",
    "Run",
    "RunError",
    "Scenario",
    "Snapshot",
    "TrackProfile",
    "open_run",
]
