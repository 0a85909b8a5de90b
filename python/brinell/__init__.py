# SPDX-License-Identifier: BSD-3-Clause
"""brinell: contact of elastic-plastic bodies by the semi-analytical method.

Example:
    >>> import brinell
    >>> run = brinell.Case.from_file("cases/tugging/case.toml").run()
    >>> run.history["F_X"].max()

"""

from __future__ import annotations

import os
import sys
from importlib import import_module
from importlib.metadata import version
from typing import TYPE_CHECKING, Any

from brinell import _processor  # noqa: F401 (checks the processor before the extension is loaded)

# Waiting threads spin for a short time before they sleep; apps/brinell/main.cpp does the same and says why.
# OpenMP reads these variables when the extension is loaded. A value that the user has set is kept.
if "OMP_WAIT_POLICY" not in os.environ:
    os.environ.setdefault("GOMP_SPINCOUNT", "1000")
    os.environ["OMP_WAIT_POLICY"] = "passive"

from brinell import _core, constitutive, contact, elastoplastic, green, halfspace, heat, reference, scenarios, surfaces
from brinell._arguments import explain_argument_errors
from brinell._names import did_you_mean
from brinell.bodies import (
    Berkovich,
    Body,
    Bump,
    Cone,
    Cylinder,
    Dent,
    Ellipsoid,
    Flat,
    RandomSurface,
    Sinusoid,
    Sphere,
    Vickers,
)
from brinell.case import Case, CaseWarning, ResolutionWarning
from brinell.errors import (
    ArgumentError,
    BrinellError,
    ConvergenceError,
    GridError,
    InputError,
    InternalError,
    IoError,
    MissingExtraError,
)
from brinell.materials import (
    RIGID,
    Hollomon,
    JohnsonCook,
    Linear,
    LinearSoftening,
    Ludwik,
    Material,
    Perfect,
    SofteningTable,
    Swift,
    SwiftMicrostrain,
    Table,
    Thermal,
    Voce,
)
from brinell.results import Accuracy, Run, RunError, RunWarning
from brinell.results import open_run as open
from brinell.scenarios import *  # noqa: F403 (a class for each)
from brinell.settings import Grid, Heating, HeatSource, Interface, Output, Solver, Wear
from brinell.stepping import Stepping
from brinell.surfaces import HeightMap

if TYPE_CHECKING:
    from brinell import asperities, export, plot, report, sweeps
    from brinell.sweeps import sweep

# After a fork by multiprocessing the child process has only the thread that called fork: the engine's threads are gone.
os.register_at_fork(before=_core.before_fork)

__version__ = version("brinell")

__all__ = [
    "RIGID",
    "Accuracy",
    "ArgumentError",
    "Berkovich",
    "Body",
    "BrinellError",
    "Bump",
    "Case",
    "CaseWarning",
    "Cone",
    "ConvergenceError",
    "Cylinder",
    "Dent",
    "Ellipsoid",
    "Flat",
    "Grid",
    "GridError",
    "HeatSource",
    "Heating",
    "HeightMap",
    "Hollomon",
    "InputError",
    "Interface",
    "InternalError",
    "IoError",
    "JohnsonCook",
    "Linear",
    "LinearSoftening",
    "Ludwik",
    "Material",
    "MissingExtraError",
    "Output",
    "Perfect",
    "RandomSurface",
    "ResolutionWarning",
    "Run",
    "RunError",
    "RunWarning",
    "Sinusoid",
    "SofteningTable",
    "Solver",
    "Sphere",
    "Stepping",
    "Swift",
    "SwiftMicrostrain",
    "Table",
    "Thermal",
    "Vickers",
    "Voce",
    "Wear",
    "__version__",
    "asperities",
    "constitutive",
    "contact",
    "elastoplastic",
    "export",
    "green",
    "halfspace",
    "heat",
    "open",
    "plot",
    "reference",
    "report",
    "surfaces",
    "sweep",
    "sweeps",
]
__all__ += scenarios.__all__
explain_argument_errors(sys.modules[__name__])


def __getattr__(name: str) -> Any:
    """Imports the slow modules (those that need pandas and matplotlib) when they are first used."""
    if name == "sweep":
        return import_module("brinell.sweeps").sweep
    if name in ("asperities", "export", "plot", "report", "sweeps"):
        return import_module(f"brinell.{name}")
    hint = "" if name.startswith("_") else did_you_mean(name, __all__)  # tools, not users, look up private names
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}{'; ' if hint else ''}{hint.strip()}")


def __dir__() -> list[str]:
    return sorted(__all__)
