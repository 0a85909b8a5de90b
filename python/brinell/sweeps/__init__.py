# SPDX-License-Identifier: BSD-3-Clause
"""Parameter sweeps: one case for many values of some of its keys, on this machine or on a Dask cluster.

    result = brinell.sweep("case.toml", {"tugging.interference": "1:15:15"}, output="results/alpha")
    result.table.plot("tugging.interference", "energy.net_J")

Modules: `axes` (varied keys), `designs` (points), `lists` (axes over entries of lists), `point` (one run in a worker),
`pools` (processes or cluster), `folder` (files of a sweep), `numbers`
(further columns), `driver` (the function `sweep`), `cli` (the command).
"""

from brinell.errors import MissingExtraError

try:
    import pandas as _pandas  # noqa: F401 (asked for at the door)
    import pyarrow as _pyarrow  # noqa: F401
    import scipy as _scipy  # noqa: F401
except ModuleNotFoundError as error:
    raise MissingExtraError("a sweep", str(error.name), "sweep") from error

from brinell.sweeps.axes import Axis, Choices, Range
from brinell.sweeps.designs import Design
from brinell.sweeps.driver import Sweep, open_sweep, sweep
from brinell.sweeps.numbers import residual_stress

__all__ = ["Axis", "Choices", "Design", "Range", "Sweep", "open_sweep", "residual_stress", "sweep"]
