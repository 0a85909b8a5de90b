# SPDX-License-Identifier: BSD-3-Clause
"""Parameter sweeps: one case for many values of some of its keys, on this machine or on a Dask cluster.

    result = brinell.sweep("case.toml", {"tugging.interference": "1:15:15"}, output="results/alpha")
    result.table.plot("tugging.interference", "energy.net_J")

Modules, from the bottom up: `axes` (varied keys), `designs` (points), `lists` (axes over entries of lists), `point`
(one run in a worker), `pools` (processes), `loop` (keeps a pool busy), `journal` (what became of each run, line by
line), `jobs`, `clusters` (workers of Dask), `slurm`, `arrays`, `task`, `submission` (job arrays: Slurm's commands,
their folders, a task on a node, the process that waits), `site` (a site's options for both), `kept` (folders that are
asked for), `folder`, `ledger` (files and table of a sweep), `numbers` (further columns), `result` (a finished sweep),
`driver` (the function `sweep`), `cli` (the command).
"""

from importlib import import_module
from typing import TYPE_CHECKING, Any

# What a user asks for is imported then (PEP 562): workers on a cluster start without the packages of tables.
if TYPE_CHECKING:
    from brinell.sweeps.axes import Axis, Choices, Range
    from brinell.sweeps.clusters import Cluster
    from brinell.sweeps.designs import Design
    from brinell.sweeps.driver import sweep
    from brinell.sweeps.numbers import residual_stress
    from brinell.sweeps.result import Sweep, open_sweep
    from brinell.sweeps.site import Site, read_site
    from brinell.sweeps.slurm import Slurm

__all__ = [
    "Axis",
    "Choices",
    "Cluster",
    "Design",
    "Range",
    "Site",
    "Slurm",
    "Sweep",
    "open_sweep",
    "read_site",
    "residual_stress",
    "sweep",
]

_MODULES = {
    "axes": "Axis Choices Range",
    "clusters": "Cluster",
    "designs": "Design",
    "driver": "sweep",
    "numbers": "residual_stress",
    "result": "Sweep open_sweep",
    "site": "Site read_site",
    "slurm": "Slurm",
}
"""Public names by the module that they are from."""


def __getattr__(name: str) -> Any:
    """Imports what a public name stands for when it is first used."""
    module = next((module for module, names in _MODULES.items() if name in names.split()), None)
    if module is None:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    _require_extra()
    found = getattr(import_module(f"brinell.sweeps.{module}"), name)
    globals()[name] = found
    return found


def __dir__() -> list[str]:
    return sorted(__all__)


def _require_extra() -> None:
    for package in ("pandas", "pyarrow", "scipy"):
        try:
            import_module(package)
        except ModuleNotFoundError as error:
            from brinell.errors import MissingExtraError

            raise MissingExtraError("a sweep", str(error.name), "sweep") from error
