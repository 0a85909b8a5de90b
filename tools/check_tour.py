#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Fails if a program does not print what docs/developer shows of it. Usage: tools/check_tour.py PROGRAM [--write].

A page shows the output of tests/tour/NAME.cpp in the block of code after the line `<!-- output of NAME -->`. Words must be the
same; numbers may differ by one in their last digit, since processors round differently. --write puts the output on the page.
"""

import re
import subprocess
import sys
from pathlib import Path

PAGES = Path(__file__).resolve().parent.parent / "docs" / "developer"
NUMBER = re.compile(r"-?\d+(?:\.\d+)?(?:e[-+]\d+)?")


def block_of(name: str) -> re.Pattern[str]:
    """The block of code after the mark of a program: what precedes its text, its text, what follows."""
    return re.compile(rf"(<!-- output of {name} -->\n+```text\n)(.*?)(^```$)", re.DOTALL | re.MULTILINE)


def last_digit(number: str) -> float:
    """The weight of the last digit of a number as it is written."""
    mantissa, _, exponent = number.partition("e")
    return 10.0 ** (int(exponent or 0) - len(mantissa.partition(".")[2]))


def differences(shown: str, printed: str) -> list[str]:
    """Lines that differ by more than the last digit of a number."""
    found = []
    lines = [text.splitlines() for text in (shown, printed)]
    if len(lines[0]) != len(lines[1]):
        return [f"{len(lines[0])} lines are shown, {len(lines[1])} are printed"]
    for one, other in zip(*lines, strict=True):
        words = [NUMBER.sub("#", line).split() for line in (one, other)]
        numbers = zip(NUMBER.findall(one), NUMBER.findall(other), strict=False)
        close = all(abs(float(a) - float(b)) < 1.5 * max(last_digit(a), last_digit(b)) for a, b in numbers)
        if words[0] != words[1] or not close:
            found.append(f"shown:   {one}\nprinted: {other}")
    return found


def main() -> int:
    program = Path(sys.argv[1])
    block = block_of(program.name.removeprefix("brinell_tour_"))
    pages = [page for page in sorted(PAGES.glob("*.md")) if block.search(page.read_text(encoding="utf-8"))]
    if len(pages) != 1:
        sys.exit(f"tour: {len(pages)} pages of {PAGES} show the output of {program.name}")
    text = pages[0].read_text(encoding="utf-8")
    printed = subprocess.run([program], check=True, capture_output=True, text=True).stdout.rstrip("\n") + "\n"
    if "--write" in sys.argv:
        pages[0].write_text(block.sub(lambda match: match[1] + printed + match[3], text), encoding="utf-8")
        return 0
    found = differences(block.search(text)[2], printed)
    for difference in found:
        print(difference)
    print(f"tour: {program.name}, {len(printed.splitlines())} lines, {len(found)} differ from {pages[0].name}")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
