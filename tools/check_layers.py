#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Fails on an #include that a floor or a room must not make. Usage: tools/check_layers.py [ROOT]

The floors from the bottom up; each names the floors it may include besides itself. apps, tests and bench may
include everything. The largest floors have rooms, folders with rules of the same kind among them. Public headers lie
side by side in include/brinell/<floor>: such a header belongs to the room of the source of the same name.
"""

import re
import sys
from pathlib import Path

FLOORS = {
    "foundation": set(),
    "green": {"foundation"},
    "constitutive": {"foundation", "green"},
    "halfspace": {"foundation", "green"},
    "device": {"foundation", "green", "constitutive", "halfspace", "contact", "elastoplastic"},
    "contact": {"foundation", "green", "halfspace"},
    "elastoplastic": {"foundation", "green", "constitutive", "halfspace", "contact"},
    "reference": {"foundation", "green"},
    "simulation": {"foundation", "green", "constitutive", "halfspace", "contact", "elastoplastic", "device", "reference"},
    "quality": {"foundation", "green", "constitutive", "halfspace", "contact", "elastoplastic", "reference", "simulation"},
    "io": {
        "foundation",
        "green",
        "constitutive",
        "halfspace",
        "contact",
        "elastoplastic",
        "device",
        "reference",
        "simulation",
        "quality",
    },
}

ROOMS = {
    "halfspace": {
        "transform": set(),
        "traction": {"transform"},
        "strain": {"transform", "traction"},
        "heat": {"transform"},
    },
    "elastoplastic": {
        "body": set(),
        "interface": set(),
        "heat": {"body", "interface"},
        "increment": {"body", "interface", "heat"},
    },
    "simulation": {
        "surfaces": set(),
        "plan": {"surfaces"},
        "stepping": {"surfaces", "plan"},
        "motion": {"surfaces", "plan", "stepping"},
    },
}

# Rooms of public headers that have no source.
ROOM_OF_HEADER = {
    "halfspace": {"surface_load": "transform"},
    "elastoplastic": {"device": "body", "effects": "interface", "interface": "interface", "settings": "body", "strategy": "increment"},
    "simulation": {"columns": "plan", "forecast": "plan", "scenario": "plan", "surface_fields": "plan", "scenarios": "motion", "run": "motion"},
}

# Single headers, where a floor may use some of another floor but not all: elastic constants, but no kernels.
ONLY_HEADERS = {
    ("constitutive", "green"): {"elastic.hpp", "conductive_stack.hpp", "elastic_stack.hpp", "thermal.hpp", "thermal_stack.hpp"},
    # The waves of layers, which have no closed form; tools/oracles computes them with 30 digits.
    ("reference", "green"): {"elastic.hpp", "elastic_stack.hpp", "stack.hpp"},
}

# The build's version header is for those who write files and messages.
VERSION_HEADER_FLOORS = {"io"}

INCLUDE = re.compile(r'^\s*#\s*include\s*[<"]([^">]+)[">]')
SOURCES = {".hpp", ".h", ".cpp"}

# What a string below quality must not say: keys of case files, options of the command line, names of files and of members
# of the summary. Such a string names members of the case instead (simulation/plan_error.hpp).
STRING = re.compile(r'"((?:[^"\\]|\\.)*)"')
WORD_OF_FILES = re.compile(
    r"\b(?:tugging|rolling|sliding|indentation|fretting|interface|thermal|grid|solver|output)\.[a-z_]{2,}"
    r"|(?:\blower|\bupper|\{\})\.(?:texture|shape|material)"
    r"|\[\*\]|\b(?:energy|forces|residual|wear)\.[a-z_*]+"
    r"|--[a-z]{3,}|\b(?:checkpoint|summary|history|result)\.[a-z]+"
)
SPEAKING = {"quality", "io"}  # floors that speak to users of files


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


class Rooms:
    """Which room a file or an included header of a floor lies in."""

    def __init__(self, root: Path) -> None:
        self.of = {floor: dict(ROOM_OF_HEADER[floor]) for floor in ROOMS}
        for floor, rooms in ROOMS.items():
            for room in rooms:
                self.of[floor].update((path.stem, room) for path in (root / "src" / floor / room).iterdir())

    def reason(self, path: Path, floor: str, target: str) -> str | None:
        """Reason why a file of `floor` may not include `target`; None if it may."""
        parts = Path(target).parts
        if parts[0] == "brinell":
            parts = parts[1:]
        if floor not in ROOMS or Path(target).suffix != ".hpp" or (len(parts) > 1 and parts[0] != floor):
            return None
        mine, other = self.of[floor].get(path.stem), self.of[floor].get(Path(target).stem)
        if mine is None:
            return f"in no room of {floor} ({', '.join(ROOMS[floor])}); ROOM_OF_HEADER has headers without a source"
        if other is None or other == mine or other in ROOMS[floor][mine]:
            return None
        return f"{floor}/{mine} must not include {floor}/{other}"


def violations(root: Path) -> tuple[list[str], int]:
    found, files, rooms = [], 0, Rooms(root)
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
                why = match and (reason(floor, match.group(1)) or rooms.reason(path, floor, match.group(1)))
                if why:
                    found.append(f"{name}:{number}: {why}: {line.strip()}")
    return found, files


def words_of_files(root: Path) -> list[str]:
    """Strings below quality that say words of files."""
    found = []
    for base in (root / "include" / "brinell", root / "src"):
        for path in sorted(path for floor in FLOORS if floor not in SPEAKING for path in (base / floor).rglob("*")):
            if path.suffix not in SOURCES:
                continue
            for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), start=1):
                texts = [] if INCLUDE.match(line) else STRING.findall(line.split("//", 1)[0])
                if any(WORD_OF_FILES.search(text) for text in texts):
                    found.append(f"{path.relative_to(root)}:{number}: says a word of files: {line.strip()}")
    return found


def main() -> int:
    root = Path(sys.argv[1] if len(sys.argv) > 1 else Path(__file__).resolve().parent.parent)
    found, files = violations(root)
    said = words_of_files(root)
    for message in found + said:
        print(message)
    print(f"layers: {files} files, {len(found)} upward includes, {len(said)} words of files below quality")
    return 1 if found or said else 0


if __name__ == "__main__":
    sys.exit(main())
