# SPDX-License-Identifier: BSD-3-Clause
"""The TOML parser: tomllib of the standard library from Python 3.11 on, before that tomli with the same interface."""

import sys

if sys.version_info >= (3, 11):
    import tomllib
else:
    import tomli as tomllib

__all__ = ["tomllib"]
