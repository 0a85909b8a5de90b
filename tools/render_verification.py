#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Numbers of the pages on verification, from what the verification tests measured.

    tools/render_verification.py build/release/verification.json         # all tables, to standard output
    tools/render_verification.py build/release/verification.json docs    # docs/verification.md, docs/verification/

The tests write the JSON file (tests/support/record.hpp). A page of docs/verification names the suites whose tables it has in
its mark BEGIN; the text from there to END is replaced, the rest is kept. The front page has the HEADLINES below between its
marks. Tests that have left no number, numbers of tests that are no more, and suites on no page or on two are told; nothing is
written then, since the pages are to show the tests as they are.
"""

import json
import re
import sys
from pathlib import Path
from typing import NamedTuple

TESTS = Path(__file__).resolve().parents[1] / "tests" / "verification"
BEGIN = re.compile(r"<!-- measured: begin \(tools/render_verification\.py\): ([\w,\s]+?) -->")
FRONT = "<!-- headlines: begin (tools/render_verification.py) -->"
END = "<!-- measured: end -->"
UNBOUNDED = 1e9  # what the tests write for no upper bound


class Headline(NamedTuple):
    """A number of the front page: its words, and where the record has it."""

    what: str
    suite: str
    test: str
    entry: str


HEADLINES = [
    Headline(
        "first yield of two balls: interference over that of the closed form",
        "NormalLoading", "FirstYieldIsWhereHuberHasIt",
        "interference of first yield / alpha_c, 16 cells per radius",
    ),
    Headline(
        "first yield of cylinders: von Mises stress over yield stress at the critical load",
        "CylinderTugging", "FirstYieldIsWhereTheClosedFormHasIt",
        "nu = 0.32: largest von Mises stress / S_y at P_c",
    ),
    Headline(
        "first yield of a sliding ball, friction 0.2: p0 over yield stress",
        "Friction", "FirstYieldIsHamiltons",
        "first yield, friction 0.2: p0 / S_y",
    ),
    Headline(
        "elastic spheres pass each other at nine critical interferences: peak F_X over P_c",
        "ElasticTuggingTable", "FollowsTheClosedForm",
        "alpha* = 9: peak F_X / P_c",
    ),
    Headline(
        "elastic cone: load over that of the closed form",
        "Indentation", "ElasticConeIsSneddons",
        "load of an elastic cone",
    ),
    Headline(
        "waves across, light load: contact fraction over that of Hertz",
        "WavesInAPeriod", "TwoAcrossAreThoseOfJohnsonGreenwoodAndHigginson",
        "waves across, pressure to zero: fraction over that of Hertz",
    ),
    Headline(
        "rough surfaces: contact fraction over p/(E' rms slope)",
        "RoughInAPeriod", "AreaOverPressureLiesBetweenPerssonAndGreenwood",
        "rough surfaces: contact fraction over p/(E' rms slope) at 0.020000",
    ),
    Headline(
        "waves that touch everywhere slide: error of the force over its largest value",
        "Sliding", "OfWavesThatTouchEverywhereHasTheClosedForm",
        "waves that touch everywhere, 64 cells: error of the force over the largest",
    ),
    Headline(
        "flat punch that sticks, Poisson's ratio 0: load over that without friction",
        "Coupling", "PunchThatSticksIsStifferByTheFactorOfMossakovskii",
        "flat punch that sticks, nu = 0: load over that without friction",
    ),
    Headline(
        "balls that stick and slip: stick radius over that of the closed form",
        "CattaneoMindlin", "StickRadiusShearAndShiftOfTwoBalls",
        "balls: stick radius, share of the exact one",
    ),
    Headline(
        "fretting of elastic balls: energy per cycle over that of the closed form",
        "Fretting", "ElasticLoopIsThatOfMindlin",
        "elastic balls, 32 cells: energy per cycle, share of the exact one",
    ),
    Headline(
        "creep coefficient C11 of balls, Poisson's ratio 0.25",
        "RollingCreepage", "BallsFollowKalker",
        "balls that roll with creepage: C11, nu = 0.25",
    ),
    Headline(
        "creep force of cylinders over that of the closed form",
        "RollingCreepage", "CylindersFollowCarter",
        "cylinders that roll with creepage, 32 cells: force, share of the exact one",
    ),
    Headline(
        "two elastic-plastic balls at 9 critical interferences: load over P_c",
        "NormalLoading", "LoadAgreesWithFiniteElements",
        "alpha* = 9: P / P_c against Jackson & Green",
    ),
    Headline(
        "the same at 25, against one fit to finite elements",
        "Indentation", "LoadingTo25AgreesWithFiniteElements",
        "alpha* = 25: P / P_c against Jackson & Green",
    ),
    Headline(
        "the same at 25, against the other",
        "Indentation", "LoadingTo25AgreesWithFiniteElements",
        "alpha* = 25: P / P_c against Kogut & Etsion",
    ),
    Headline(
        "the same unloaded: residual over largest interference",
        "Indentation", "UnloadingAgreesWithFiniteElements",
        "residual over largest interference at alpha* = 25",
    ),
    Headline(
        "elastic-plastic cone: unloading stiffness over 2 E' sqrt(A/pi)",
        "Indentation", "UnloadingStiffnessIsThatOfTheContactArea",
        "unloading stiffness / (2 E' sqrt(A / pi)), cone",
    ),
    Headline(
        "the paper's tugging: F_X over F_Z at the end of contact",
        "PaperTugging", "LoadRatioTendsToTheSlopeOfTheLastContact",
        "alpha* = 9: F_X / F_Z at the end of contact",
    ),
    Headline(
        "the paper's tugging: largest permanent displacement over interference",
        "PaperTugging", "LargestPermanentDisplacementIsAQuarterOfTheInterference",
        "alpha* = 9: largest residual displacement / interference",
    ),
    Headline(
        "the paper's tugging on the default mesh: net work over that of fine meshes",
        "PaperTugging", "DefaultMeshIsRightToOnePercent",
        "default mesh: net work",
    ),
    Headline(
        "the paper's tugging: work that is neither dissipated nor stored, over the largest work",
        "PaperTugging", "WorkIsDissipationPlusLockedInEnergy",
        "alpha* = 9: energy balance over the largest work",
    ),
    Headline(
        "order of the net work in the step of the motion",
        "ShiftStep", "PathIsSecondOrderAndBackwardEulerFirst",
        "net work: order of the path in the shift",
    ),
    Headline(
        "long roller: largest von Mises stress over pressure",
        "Rolling", "LongRollerIsPlaneStrain",
        "largest von Mises stress / pressure",
    ),
    Headline(
        "rolling at p0/k = 4.2: growth of plastic strain in pass 6 over that in pass 1",
        "Rolling", "ShakesDownBelowTheLimitOnly",
        "p0 / k = 4.2: growth of strain in pass 6 / pass 1",
    ),
    Headline(
        "wear of a pass of two balls: worn volume over that of the closed form",
        "TuggingWear", "OfLittleIsThatOfHertzOnTheWay",
        "worn volume of a pass over k int P ds, 12 cells per radius",
    ),
    Headline(
        "flash temperature of a moving contact, Peclet number 10: rise over the exact one",
        "FlashTemperature", "MovingContactOfHertz",
        "contact, Pe = 10, 16 cells: largest rise / exact",
    ),
    Headline(
        "rail under a sliding wheel: rise in K",
        "BlokPartition", "RailUnderASlidingWheel",
        "rail of Ertz and Knothe, 16 cells to the half-width: rise in K, one temperature",
    ),
    Headline(
        "disc of steady heat: curvature of the bulge over that of the closed form",
        "ThermoelasticDisc", "SteadyBulge",
        "16 cells to the radius: curvature of the bulge / ((1 + nu) alpha q/2 K)",
    ),
    Headline(
        "cylinders with creepage heat up, Peclet number 5: largest temperature over the exact one",
        "StickSlipHeat", "CylindersWithCreepageFollowCarterAndJaeger",
        "largest temperature, 0.4 of the contact slips at Peclet 5, 32 cells / exact",
    ),
]


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
        (suite, name): re.search(r"\b(expect_(close|within)|sweep)\(", body) is not None
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


def part(record: dict, suites: set[str]) -> dict:
    """The record of some suites."""
    return {suite: of_suite for suite, of_suite in record.items() if in_source(suite, "")[0] in suites}


def difference(entry: dict) -> str:
    """How far an entry is from its reference, by the digits that the tables show."""
    if "expected" not in entry:
        return "inside"
    measured, expected = (float(number(entry[key])) for key in ("measured", "expected"))
    if expected == 0.0:
        return f"{measured:.2g}"
    share = measured / expected - 1.0
    return "< 0.01 %" if abs(share) < 5e-5 else f"{100 * share:+.2g} %"


def front(record: dict, places: dict[str, str]) -> str:
    """The table of the front page; places has the page of each suite."""
    entries: dict[tuple[str, str], dict] = {}
    for suite, of_suite in record.items():
        for test, of_test in of_suite.items():
            entries.setdefault(in_source(suite, test), {}).update(of_test)
    lines = ["| what | brinell | reference | difference | source | test |", "| --- | --- | --- | --- | --- | --- |"]
    for what, suite, test, name in HEADLINES:
        entry = entries[suite, test][name]
        reference, _ = bounds(entry)
        link = f"{places[suite]}#{words(suite).lower().replace(' ', '-')}"
        source = re.sub(r"^(?:exact|analytic|literature|table): ", "", entry["origin"])
        cells = [what, number(entry["measured"]), reference, difference(entry), source, f"[{suite}.{test}]({link})"]
        lines.append("| " + " | ".join(cells) + " |")
    return "\n".join(lines) + "\n"


def suites_of(page: str) -> list[str]:
    """Suites that a page names in its marks."""
    return [suite for names in BEGIN.findall(page) for suite in re.split(r",\s*", names)]


def places_of(pages: dict[Path, str]) -> tuple[dict[str, str], list[str]]:
    """The page of each suite, as a link from the front page, and what is wrong with the marks."""
    places: dict[str, str] = {}
    wrong = []
    for path, text in pages.items():
        for suite in suites_of(text):
            if suite in places:
                wrong.append(f"{suite} is on two pages: {places[suite]} and {path.name}")
            places[suite] = f"verification/{path.name}"
        if not suites_of(text) and "<!-- measured: begin" in text:
            wrong.append(f"{path.name}: the mark names no suites")
    return places, wrong


def with_tables(page: str, record: dict, tests: dict[tuple[str, str], bool]) -> str:
    """A page with new tables between its marks."""

    def tables(mark: re.Match[str]) -> str:
        suites = set(re.split(r",\s*", mark[2]))
        return f"{mark['begin']}\n\n{rendered(part(record, suites), tests)}\n{END}"

    return re.sub(f"(?P<begin>{BEGIN.pattern}).*?{re.escape(END)}", tables, page, flags=re.DOTALL)


def with_headlines(page: str, record: dict, places: dict[str, str]) -> str:
    """The front page with a new table between its marks."""
    head, rest = page.split(FRONT, 1)
    return f"{head}{FRONT}\n\n{front(record, places)}\n{END}" + rest.split(END, 1)[1]


def main() -> int:
    if len(sys.argv) not in (2, 3):
        print(__doc__, file=sys.stderr)
        return 2
    record = json.loads(Path(sys.argv[1]).read_text(encoding="utf-8"))
    tests = tests_of(TESTS)
    unlike = differences(record, tests)
    if len(sys.argv) == 2:
        print(*unlike, sep="\n", file=sys.stderr)
        print(rendered(record, tests))
        return 0
    docs = Path(sys.argv[2])
    pages = {path: path.read_text(encoding="utf-8") for path in sorted((docs / "verification").glob("*.md"))}
    places, wrong = places_of(pages)
    unlike += wrong
    unlike += sorted(f"{suite} is on no page of {docs / 'verification'}: name it in a mark there"
                     for suite in {in_source(suite, "")[0] for suite in record} - places.keys())
    if unlike:
        print(*unlike, f"{docs} is left as it is", sep="\n", file=sys.stderr)
        return 1
    for path, text in pages.items():
        path.write_text(with_tables(text, record, tests), encoding="utf-8")
    page = docs / "verification.md"
    page.write_text(with_headlines(page.read_text(encoding="utf-8"), record, places), encoding="utf-8")
    return 0


if __name__ == "__main__":
    sys.exit(main())
