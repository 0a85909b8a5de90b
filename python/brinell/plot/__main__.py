# SPDX-License-Identifier: BSD-3-Clause
"""``python -m brinell.plot``, the same as ``brinell plot``."""

from brinell.plot.cli import plot

plot(prog_name="brinell plot")
