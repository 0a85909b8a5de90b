#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Fails on a line of tests/long_tests.txt that gives no test its label. Usage: tools/check_long_tests.py CTEST BUILD

CTest passes over names that it does not know, so a renamed test would quietly be neither left out of quick runs nor
begin first. Names of executables that are not built are left alone.
"""

import json
import re
import subprocess
import sys
from pathlib import Path

LIST = Path(__file__).resolve().parents[1] / "tests" / "long_tests.txt"
LINE = re.compile(r"((?:[a-z]+\.)+)\S+ +\d+(?:\.\d+)?")
NOT_BUILT = re.compile(r"brinell_(\w+)_tests_NOT_BUILT")


def unlike(text: str, tests: dict[str, set[str]]) -> list[str]:
    """What is wrong with the list, if these are the tests with their labels."""
    missing = {built[1].replace("_", ".", 1) + "." for name in tests if (built := NOT_BUILT.fullmatch(name))}
    found, seen = [], set()
    for number, line in enumerate(text.splitlines(), start=1):
        if not line.strip() or line.startswith("#"):
            continue
        match, name = LINE.fullmatch(line), line.split()[0]
        if not match:
            found.append(f"{number}: not a name and its seconds: {line}")
        elif name in seen:
            found.append(f"{number}: {name} is there twice")
        elif match[1] not in missing and "long" not in tests.get(name, set()):
            found.append(f"{number}: {name} is no test")
        seen.add(name)
    return found


def main() -> int:
    ctest, build = sys.argv[1:]
    listed = subprocess.run(
        [ctest, "--test-dir", build, "--show-only=json-v1"], capture_output=True, text=True, check=True
    )
    tests = {
        test["name"]: {label for p in test.get("properties", []) if p["name"] == "LABELS" for label in p["value"]}
        for test in json.loads(listed.stdout)["tests"]
    }
    found = unlike(LIST.read_text(encoding="utf-8"), tests)
    for message in found:
        print(f"tests/long_tests.txt:{message}")
    print(f"long tests: {sum('long' in labels for labels in tests.values())} of {len(tests)}, {len(found)} findings")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
