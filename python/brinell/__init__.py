# SPDX-License-Identifier: BSD-3-Clause
"""brinell: contact of elastic-plastic bodies by the semi-analytical method.

This package reads the results of the program (`brinell.results`) and draws them (`brinell.plot`).
"""

from importlib.metadata import PackageNotFoundError, version

from brinell.results import Run, RunError, open_run

try:
    __version__ = version("brinell")
except PackageNotFoundError:  # used from the source tree without installation
    __version__ = "unknown"

__all__ = ["Run", "RunError", "__version__", "open_run"]
