# SPDX-License-Identifier: BSD-3-Clause
"""A run as one page: HTML that opens from disk, needs no network, and can be printed or sent to a colleague.

Modules: `page` (puts it together), `numbers` (key results, energies, cost), `inputs` (the case with its units),
`findings` (what to be wary of), `volumes` (what the interactive pictures show, thinned to a size that travels), `text`
(numbers as plain text), `cli` (the command `brinell report`); templates/ holds the page, its style and its script.
"""

from brinell.report.page import write_report

__all__ = ["write_report"]
