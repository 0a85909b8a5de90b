#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Fails on an #include that a floor must not make. Usage: tools/check_layers.py [ROOT]

The floors from the bottom up; each names the floors it may include besides itself. apps, tests and bench may
include everything.
"""

import re
import sys
from pathlib import Path

FLOORS = {
    "foundation": set(),
    "green": {"foundation"},
    "constitutive": {"foundation", "green"},
    "halfspace": {"foundation", "green"},
    "contact": {"foundation", "green", "halfspace"},
    "elastoplastic": {"foundation", "green", "constitutive", "halfspace", "contact"},
    "reference": {"foundation", "green"},
    "simulation": {"foundation", "green", "constitutive", "halfspace", "contact", "elastoplastic", "reference"},
    "io": {"foundation", "green", "constitutive", "halfspace", "contact", "elastoplastic", "reference", "simulation"},
}

# Single headers, where a floor may use some of another floor but not all: elastic constants, but no kernels.
ONLY_HEADERS = {
    ("constitutive", "green"): {"elastic.hpp", "thermal.hpp"},
    ("reference", "green"): {"elastic.hpp"},
}

# The build's version header is for those who write files and messages.
VERSION_HEADER_FLOORS = {"io"}

INCLUDE = re.compile(r'^\s*#\s*include\s*[<"]([^">]+)[">]')
SOURCES = {".hpp", ".h", ".cpp"}


def reason(floor: str, target: str) -> str | None:
    """Reason why `floor` may not include `target`; None if it may."""
    parts = Path(target).parts
    if parts[0] == "brinell":
        if parts[1:] == ("version.hpp",):
            return None if floor in VERSION_HEADER_FLOORS else "the version is for io and the program"
        if len(parts) < 3 or parts[1] not in FLOORS:
            return "not a header of a floor"
        parts = parts[1:]
    elif parts[0] not in FLOORS or len(parts) < 2:  # another library, or a private header beside the file
        return f"leaves the folder of {floor}" if parts[0] == ".." else None
    other, header = parts[0], "/".join(parts[1:])
    if other == floor:
        return None
    if other not in FLOORS[floor]:
        return f"{floor} must not include {other}"
    allowed = ONLY_HEADERS.get((floor, other))
    if allowed is not None and header not in allowed:
        return f"{floor} may include of {other} only {', '.join(sorted(allowed))}"
    return None


def violations(root: Path) -> tuple[list[str], int]:
    found, files = [], 0
    for base in (root / "include" / "brinell", root / "src"):
        for path in sorted(base.rglob("*")):
            if path.suffix not in SOURCES:
                continue
            files += 1
            name = path.relative_to(root)
            floor = path.relative_to(base).parts[0]
            if floor not in FLOORS:
                found.append(f"{name}:1: not in the folder of a floor ({', '.join(FLOORS)})")
                continue
            for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), start=1):
                match = INCLUDE.match(line)
                why = match and reason(floor, match.group(1))
                if why:
                    found.append(f"{name}:{number}: {why}: {line.strip()}")
    return found, files


def main() -> int:
    root = Path(sys.argv[1] if len(sys.argv) > 1 else Path(__file__).resolve().parent.parent)
    found, files = violations(root)
    for message in found:
        print(message)
    print(f"layers: {files} files, {len(found)} upward includes")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
