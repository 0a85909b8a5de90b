# SPDX-License-Identifier: BSD-3-Clause
"""Check that the processor supports the compiled instructions; otherwise Linux would kill Python without a message."""

from __future__ import annotations

import os
import sys
from typing import TYPE_CHECKING

from brinell._built_for import ARCH, FEATURES

if TYPE_CHECKING:
    from collections.abc import Set

__all__ = ["require_processor"]

_INFO = "/proc/cpuinfo"
_HOW = "docs/install.md#wheels"


def require_processor(features: Set[str] = FEATURES, info: str | os.PathLike[str] = _INFO) -> None:
    """Checks the processor; must be called before the extension is loaded.

    Args:
        features: names of the processor features that the extension needs.
        info: file in which Linux lists the features of the processor; without this file nothing is checked.

    Raises:
        ImportError: a feature is missing.
        SystemExit: a feature is missing, and the program is the command ``brinell``; the message is one line.
    """
    available = _flags(info) if features else None
    missing = sorted(features - available) if available is not None else []
    if not missing:
        return
    kind = "the processor of another machine" if ARCH == "native" else f"processors of the kind {ARCH}"
    text = (
        f"this brinell is compiled for {kind}; this one has no {', '.join(missing)}. Install the "
        f"baseline wheel, or compile here by pip install . in the sources ({_HOW})"
    )
    if os.path.basename(sys.argv[0]) == "brinell":
        sys.exit(f"brinell: error: {text}")
    raise ImportError(text)


def _flags(info: str | os.PathLike[str]) -> Set[str] | None:
    """Features of the first processor; None if the file is missing or lists none."""
    try:
        # Read only as far as needed: Linux generates the file line by line.
        with open(info, encoding="ascii", errors="replace") as lines:
            flags = next((line for line in lines if line.startswith("flags")), None)
    except OSError:
        return None
    return None if flags is None else frozenset(flags.partition(":")[2].split())


require_processor()
