# SPDX-License-Identifier: BSD-3-Clause
"""Whether this machine's processor can run what was compiled: otherwise Linux would end Python without a word."""

from __future__ import annotations

import sys
from collections.abc import Set
from pathlib import Path

from brinell._built_for import ARCH, FEATURES

__all__ = ["require_processor"]

_INFO = Path("/proc/cpuinfo")
_HOW = "docs/install.md#wheels"


def require_processor(features: Set[str] = FEATURES, info: Path = _INFO) -> None:
    """Looks at this machine before the extension is loaded.

    Args:
        features: what the processor must have.
        info: where Linux says what it has; without such a file nothing is required.

    Raises:
        ImportError: it has not got all of it; in the command SystemExit with one line.
    """
    there = _flags(info) if features else None
    missing = sorted(features - there) if there is not None else []
    if not missing:
        return
    kind = "the processor of another machine" if ARCH == "native" else f"processors of the kind {ARCH}"
    text = (
        f"this brinell is compiled for {kind}; this one has no {', '.join(missing)}. Install the "
        f"baseline wheel, or compile here by pip install . in the sources ({_HOW})"
    )
    if Path(sys.argv[0]).name == "brinell":
        sys.exit(f"brinell: error: {text}")
    raise ImportError(text)


def _flags(info: Path) -> Set[str] | None:
    """Of the first processor; None if nothing is told."""
    try:
        with info.open(encoding="ascii", errors="replace") as lines:  # Linux writes it line by line
            flags = next((line for line in lines if line.startswith("flags")), None)
    except OSError:
        return None
    return None if flags is None else frozenset(flags.partition(":")[2].split())


require_processor()
