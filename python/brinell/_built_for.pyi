# SPDX-License-Identifier: BSD-3-Clause
"""Written by CMake when the extension is compiled."""

ARCH: str
FEATURES: frozenset[str]
