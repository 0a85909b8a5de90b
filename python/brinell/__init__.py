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
from typing import TYPE_CHECKING, Any

from brinell import _processor  # noqa: F401 (checks the processor before the extension is loaded)

# Waiting threads spin for a short time before they sleep; apps/brinell/main.cpp does the same and says why.
# OpenMP reads these variables when the extension is loaded. A value that the user has set is kept.
if "OMP_WAIT_POLICY" not in os.environ:
    os.environ.setdefault("GOMP_SPINCOUNT", "1000")
    os.environ["OMP_WAIT_POLICY"] = "passive"

# Modules are imported when they are first used (PEP 562), so that a command of the engine starts at once. Editors and
# type checkers see what is here; `_MODULES` below says the same to Python.
if TYPE_CHECKING:
    from brinell import (
        asperities,
        constitutive,
        contact,
        elastoplastic,
        export,
        fits,
        green,
        halfspace,
        heat,
        plot,
        reference,
        report,
        surfaces,
        sweeps,
    )
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
    from brinell.case import Case, CaseWarning, ReplacementWarning, ResolutionWarning
    from brinell.errors import (
        ArgumentError,
        BrinellError,
        ConvergenceError,
        DeviceError,
        GridError,
        InputError,
        InternalError,
        IoError,
        MissingExtraError,
    )
    from brinell.fits import fit
    from brinell.forecast import Forecast
    from brinell.materials import (
        RIGID,
        Electrical,
        FatigueConstants,
        Hollomon,
        JohnsonCook,
        Linear,
        LinearSoftening,
        Ludwik,
        Material,
        MeasuredCurve,
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
    from brinell.scenarios import Fretting, Indentation, Rolling, Sliding, Tugging
    from brinell.settings import Grid, Heating, HeatSource, Interface, Output, Point, Solver, Wear
    from brinell.stepping import Stepping
    from brinell.surfaces import HeightMap
    from brinell.sweeps import sweep

    __version__: str


def _before_fork() -> None:
    if (engine := sys.modules.get("brinell._core")) is not None:
        engine.before_fork()


# After a fork by multiprocessing the child process has only the thread that called fork: the engine's threads are gone.
os.register_at_fork(before=_before_fork)

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
    "DeviceError",
    "Electrical",
    "Ellipsoid",
    "FatigueConstants",
    "Flat",
    "Forecast",
    "Fretting",
    "Grid",
    "GridError",
    "HeatSource",
    "Heating",
    "HeightMap",
    "Hollomon",
    "Indentation",
    "InputError",
    "Interface",
    "InternalError",
    "IoError",
    "JohnsonCook",
    "Linear",
    "LinearSoftening",
    "Ludwik",
    "Material",
    "MeasuredCurve",
    "MissingExtraError",
    "Output",
    "Perfect",
    "Point",
    "RandomSurface",
    "ReplacementWarning",
    "ResolutionWarning",
    "Rolling",
    "Run",
    "RunError",
    "RunWarning",
    "Sinusoid",
    "Sliding",
    "SofteningTable",
    "Solver",
    "Sphere",
    "Stepping",
    "Swift",
    "SwiftMicrostrain",
    "Table",
    "Thermal",
    "Tugging",
    "Vickers",
    "Voce",
    "Wear",
    "__version__",
    "asperities",
    "constitutive",
    "contact",
    "elastoplastic",
    "export",
    "fit",
    "fits",
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

_MODULES = {
    "bodies": "Berkovich Body Bump Cone Cylinder Dent Ellipsoid Flat RandomSurface Sinusoid Sphere Vickers",
    "case": "Case CaseWarning ReplacementWarning ResolutionWarning",
    "errors": "ArgumentError BrinellError ConvergenceError DeviceError GridError InputError InternalError IoError "
    "MissingExtraError",
    "fits": "fit",
    "forecast": "Forecast",
    "materials": "RIGID Electrical FatigueConstants Hollomon JohnsonCook Linear LinearSoftening Ludwik Material "
    "MeasuredCurve Perfect SofteningTable Swift SwiftMicrostrain Table Thermal Voce",
    "results": "Accuracy Run RunError RunWarning",
    "scenarios": "Fretting Indentation Rolling Sliding Tugging",
    "settings": "Grid HeatSource Heating Interface Output Point Solver Wear",
    "stepping": "Stepping",
    "surfaces": "HeightMap",
    "sweeps": "sweep",
}
"""Public names by the module that they are from; the other names of `__all__` are modules."""

_MODULE_OF = {name: module for module, names in _MODULES.items() for name in names.split()}


def __getattr__(name: str) -> Any:
    """Imports what a public name stands for when it is first used."""
    if name == "__version__":
        found: Any = import_module("importlib.metadata").version("brinell")
    elif name == "open":
        found = import_module("brinell.results").open_run
    elif name in _MODULE_OF:
        found = getattr(import_module(f"brinell.{_MODULE_OF[name]}"), name)
    elif name in __all__ or _is_module(name):
        found = import_module(f"brinell.{name}")
    else:
        raise AttributeError(_unknown(name))
    if name in _MODULE_OF:
        import_module("brinell._arguments").explain_errors_of(found, f"brinell.{name}")
    globals()[name] = found
    return found


def _is_module(name: str) -> bool:
    """Whether a name that is not public is that of a module, as for `brinell.results`."""
    return not name.startswith("__") and import_module("importlib.util").find_spec(f"brinell.{name}") is not None


def _unknown(name: str) -> str:
    # Tools, not users, look up private names.
    hint = "" if name.startswith("_") else import_module("brinell._names").did_you_mean(name, __all__)
    return f"module {__name__!r} has no attribute {name!r}{'; ' if hint else ''}{hint.strip()}"


def __dir__() -> list[str]:
    return sorted(__all__)
