# SPDX-License-Identifier: BSD-3-Clause
"""The reader of TOML: Python's own from 3.11 on, and before that tomli, of which it was made."""

import sys

if sys.version_info >= (3, 11):
    import tomllib
else:
    import tomli as tomllib

__all__ = ["tomllib"]
