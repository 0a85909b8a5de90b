#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Tables of docs/verification.md from what the verification tests measured.

    tools/render_verification.py build/release/verification.json                        # to standard output
    tools/render_verification.py build/release/verification.json docs/verification.md   # between the two marks there

The tests write the JSON file (tests/support/record.hpp). In the page, the text between the lines BEGIN and END below is
replaced; the rest is kept.
"""

import json
import re
import sys
from pathlib import Path

BEGIN = "<!-- measured: begin (tools/render_verification.py) -->"
END = "<!-- measured: end -->"
UNBOUNDED = 1e9  # what the tests write for no upper bound


def words(name: str) -> str:
    """'PaperTugging' -> 'Paper tugging'; parametrised suites lose their prefix and keep the parameter."""
    parts = [re.sub(r"(?<=[a-z0-9])(?=[A-Z])", " ", part) for part in name.split("/")]
    text = parts[-1] if len(parts) == 1 else parts[1]
    return text[:1] + re.sub(r"\b[A-Z](?=[a-z])", lambda m: m.group().lower(), text[1:])


def number(value: float) -> str:
    return f"{value:.5g}"


def bounds(entry: dict) -> tuple[str, str]:
    """Expected value and tolerance of an entry."""
    if "expected" in entry:
        return number(entry["expected"]), "± " + number(entry["tolerance"])
    low, high = entry["low"], entry["high"]
    if high == UNBOUNDED:
        return f"≥ {number(low)}", ""
    if abs(low) < 1e-300:
        return f"≤ {number(high)}", ""
    return f"{number(low)} … {number(high)}", ""


def rendered(record: dict) -> str:
    # The parameters of one test share its table.
    suites: dict[str, dict[str, dict]] = {}
    for suite, tests in record.items():
        for test, entries in tests.items():
            suites.setdefault(words(suite), {}).setdefault(words(test.split("/")[0]), {}).update(entries)
    lines = []
    for suite, tests in sorted(suites.items()):
        lines += [f"### {suite}", ""]
        for test, entries in tests.items():
            lines += [f"**{test}**", "", "| what | measured | expected | tolerance | origin |",
                      "| --- | --- | --- | --- | --- |"]
            for name, entry in entries.items():
                expected, tolerance = bounds(entry)
                name = name.replace("|", "\\|")
                lines.append(f"| {name} | {number(entry['measured'])} | {expected} | {tolerance} | {entry['origin']} |")
            lines.append("")
    return "\n".join(lines)


def main() -> int:
    if len(sys.argv) not in (2, 3):
        print(__doc__, file=sys.stderr)
        return 2
    tables = rendered(json.loads(Path(sys.argv[1]).read_text(encoding="utf-8")))
    if len(sys.argv) == 2:
        print(tables)
        return 0
    page = Path(sys.argv[2])
    text = page.read_text(encoding="utf-8")
    if BEGIN not in text or END not in text:
        print(f"{page}: the lines\n{BEGIN}\n{END}\nare missing", file=sys.stderr)
        return 1
    head, rest = text.split(BEGIN, 1)
    page.write_text(head + BEGIN + "\n\n" + tables + "\n" + END + rest.split(END, 1)[1], encoding="utf-8")
    return 0


if __name__ == "__main__":
    sys.exit(main())
