# SPDX-License-Identifier: BSD-3-Clause
"""``python -m brinell.plot``, the same as ``brinell-plot``."""

import sys

from brinell.plot.cli import main

sys.exit(main())
