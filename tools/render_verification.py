#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Tables of docs/verification.md from what the verification tests measured.

    tools/render_verification.py build/release/verification.json                        # to standard output
    tools/render_verification.py build/release/verification.json docs/verification.md   # between the two marks there

The tests write the JSON file (tests/support/record.hpp). In the page, the text between the lines BEGIN and END below is
replaced; the rest is kept. Each suite has a section. Tests that have left no number, and numbers of tests that are no more,
are told; the page is not written then, since it is to show the tests as they are.
"""

import json
import re
import sys
from pathlib import Path

TESTS = Path(__file__).resolve().parents[1] / "tests" / "verification"
BEGIN = "<!-- measured: begin (tools/render_verification.py) -->"
END = "<!-- measured: end -->"
UNBOUNDED = 1e9  # what the tests write for no upper bound


def in_source(suite: str, test: str) -> tuple[str, str]:
    """Names of suite and test in the source; parametrised ones are Prefix/Suite and Test/parameter in the record."""
    return suite.split("/")[-1], test.split("/")[0]


PEOPLE = {"Blok", "Carter", "Cattaneo", "Coulomb", "Greenwood", "Hamilton", "Hertz", "Higginson", "Huber", "Jaeger", "Johnson",
          "Kalker", "Mindlin", "Persson", "Vermeulen", "Westergaard"}


def words(name: str) -> str:
    """A name as words: 'PaperTugging' -> 'Paper tugging'."""
    text = re.sub(r"(?<=[a-z0-9])(?=[A-Z])|(?<=[A-Z])(?=[A-Z][a-z])", " ", name)
    return text[:1] + re.sub(r"\b[A-Z][a-z]*", lambda m: m[0] if m[0] in PEOPLE else m[0].lower(), text[1:])


def tests_of(folder: Path) -> dict[tuple[str, str], bool]:
    """Suite and name of each test in the sources of a folder, and whether it records a number itself."""
    test = re.compile(r"^TEST(?:_[FP])?\((\w+),\s*(\w+)\)\n(.*?)^}", re.MULTILINE | re.DOTALL)
    return {
        (suite, name): re.search(r"\bexpect_(close|within)\(", body) is not None
        for source in sorted(folder.glob("*_test.cpp"))
        for suite, name, body in test.findall(source.read_text(encoding="utf-8"))
    }


def differences(record: dict, tests: dict[tuple[str, str], bool]) -> list[str]:
    """Tests that the record lacks, and recorded tests that do not exist."""
    recorded = {in_source(suite, test) for suite, of_suite in record.items() for test in of_suite}
    missing = [f"{s}.{t} has left no number: run it" for (s, t), records in tests.items()
               if records and (s, t) not in recorded]
    others = [f"{s}.{t} is in the record, but is no test: delete the record and run the tests again"
              for s, t in sorted(recorded - tests.keys())]
    return missing + others


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


def rendered(record: dict, tests: dict[tuple[str, str], bool]) -> str:
    place = {test: i for i, test in enumerate(tests)}

    def as_in_source(recorded: tuple[str, str, dict]) -> tuple:
        suite, test, _ = recorded
        parameter = test.partition("/")[2]
        return place.get(in_source(suite, test), len(place)), int(parameter) if parameter.isdigit() else 0, parameter

    # The parameters of one test share its table. The record has the order in which the tests have ended.
    suites: dict[str, dict[str, dict]] = {}
    all_tests = [(suite, test, entries) for suite, of_suite in record.items() for test, entries in of_suite.items()]
    for suite, test, entries in sorted(all_tests, key=as_in_source):
        section, table = map(words, in_source(suite, test))
        suites.setdefault(section, {}).setdefault(table, {}).update(entries)
    lines = []
    for suite, of_suite in sorted(suites.items()):
        lines += [f"### {suite}", ""]
        for test, entries in of_suite.items():
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
    record = json.loads(Path(sys.argv[1]).read_text(encoding="utf-8"))
    tests = tests_of(TESTS)
    tables = rendered(record, tests)
    unlike = differences(record, tests)
    for line in unlike:
        print(line, file=sys.stderr)
    if unlike and len(sys.argv) == 3:
        print(f"{sys.argv[2]} is left as it is", file=sys.stderr)
        return 1
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
