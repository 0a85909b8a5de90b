# SPDX-License-Identifier: BSD-3-Clause
"""A report of a run as one HTML page that opens from disk, needs no network, and can be printed or sent.

Modules: `page` (generates the page), `sweep_page` (that of a sweep), `numbers` (key results, energies, cost), `inputs`
(the case with its units), `findings` (warnings), `volumes` (data of the interactive figures, thinned to a suitable
size), `text` (numbers as plain text), `cli` (the command `brinell report`).
"""

from brinell.report.page import write_report
from brinell.report.sweep_page import write_sweep_report

__all__ = ["write_report", "write_sweep_report"]
