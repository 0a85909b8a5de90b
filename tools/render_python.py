#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Writes the Python classes of settings, shapes, textures, laws and scenarios from the engine's schema of a case.

    .venv/bin/python tools/render_python.py            # writes python/brinell/{settings,_shapes,...}.py
    .venv/bin/python tools/render_python.py --check    # ends with 1 if one of them is not up to date

The schema (src/io/case/schema_*.cpp, src/io/scenarios) declares each key once: its type, unit, range, default, meaning.
tools/python_classes.py adds what only Python has: names of the classes, and which arguments need no name.
"""

from __future__ import annotations

import re
import sys
import textwrap
from collections.abc import Iterator, Mapping
from pathlib import Path

from python_classes import FILES, SHARED, Kind, Listed, Part, Scenario

from brinell import _core

PACKAGE = Path(__file__).resolve().parents[1] / "python" / "brinell"
WIDTH = 120
NO_BREAK = "\u00a0"
"""A blank at which no line ends."""

Key = _core.SchemaKey
KEYS: dict[str, Key] = {key.key: key for key in _core.schema_keys()}


# --- What the schema says of a key ------------------------------------------------------------------------------------


def annotation(key: Key) -> str:
    """Type of a value, without None."""
    if key.kind in ("boolean", "integer"):
        return {"boolean": "bool", "integer": "int"}[key.kind]
    if key.kind == "choice" and not key.per_axis:
        return f"Literal[{', '.join(map(quoted, key.choices))}]"
    if key.kind == "snapshots":
        return "str | Sequence[int]"
    one = ("Quantity" if key.has_unit else "float") if key.kind in ("number", "numbers", "vector3") else "str"
    if key.kind == "vector3":
        return f"Sequence[{one}]"
    return f"{one} | Sequence[{one}]" if key.is_list or key.per_axis else one


def quoted(text: str) -> str:
    """Text as a literal of Python."""
    return f'"{text}"'


def in_python(text: str, table: str) -> str:
    """Text of the schema with the truth values of Python, and with names of the same table instead of whole keys."""
    text = re.sub(rf"\b{re.escape(table)}\.(?=\w)", "", text)
    return re.sub(r"\b(true|false)(?=:)|(?<== )(true|false)\b", lambda found: found.group().capitalize(), text)


def described(key: Key, table: str, choice: str = "", is_required: bool = False) -> str:
    """Meaning of a key, its unit, range and default, and what it cannot stand beside."""
    facts = []
    if key.unit and f"in {key.unit}" not in key.text:
        pure = f" (a pure number if {key.pure_if.rpartition('.')[2]})" if key.pure_if else ""
        facts.append(f"in {key.unit}{pure}")
    elif key.has_unit and not key.unit:
        facts.append('a number or as "1 %"')
    if key.range:
        unbroken = key.range.replace(" ", NO_BREAK)
        facts.append(unbroken if facts else f"allowed: {unbroken}")
    limits = ", ".join(facts)
    rest = (
        [] if key.required or is_required or key.one_of else [f"default: {in_python(python_value(key.default), table)}"]
    )
    if key.excludes and not key.one_of:
        rest.append(f"not together with {key.excludes.removeprefix(f'{table}.')}")
    when, values = key.when
    if when.startswith(f"{table}.") and not choice:
        rest.append(f"only with {when.removeprefix(f'{table}.')} = {' or '.join(map(quoted, values))}")
    end = "; ".join(filter(None, [limits, *rest]))
    return f"{in_python(key.text, table)}{f' {end[0].upper()}{end[1:]}.' if end else ''}"


def python_value(text: str) -> str:
    """A default as Python writes it."""
    return text.capitalize() if text in ("true", "false") else text


def text_of_choice(key: Key, choice: str) -> str:
    """What the text of a key says of one of its choices: "linear: S_y + modulus e; ..." is a list of them."""
    found = re.search(rf"\b{choice}: (.*?)(?=; (?:{'|'.join(key.choices)}): |\.(?: |$))", key.text)
    if found is None:
        raise ValueError(f"the text of {key.key} does not say what {choice} is")
    return found.group(1)


# --- Classes ----------------------------------------------------------------------------------------------------------


def keys_of(table: str, choice: str = "") -> dict[str, Key]:
    """Keys of a table by their name, without those of tables within it; of one choice, only what belongs to it."""
    found = {name.removeprefix(f"{table}."): key for name, key in KEYS.items() if name.startswith(f"{table}.")}
    of_table = {name: key for name, key in found.items() if "." not in name}
    if not choice:
        return of_table
    chooser = next(key.key for name, key in of_table.items() if name in ("type", "law"))
    return {name: key for name, key in of_table.items() if key.when[0] == chooser and choice in key.when[1]}


def paragraph(text: str, indent: str, hanging: str = "") -> list[str]:
    """A text in lines of at most WIDTH letters."""
    lines = textwrap.wrap(
        text, WIDTH, initial_indent=indent, subsequent_indent=indent + hanging, break_on_hyphens=False
    )
    return [line.replace(NO_BREAK, " ") for line in lines]


def section(title: str, texts: Mapping[str, str], indent: str) -> Iterator[str]:
    """A section of a docstring: "Attributes:" or "Args:"."""
    yield f"{indent}{title}:"
    for name, text in texts.items():
        yield from paragraph(f"{name}: {text}", f"{indent}    ", "    ")


def ordered(names: Mapping[str, object], first: tuple[str, ...]) -> list[str]:
    """Names with some of them in front."""
    return [*first, *(name for name in names if name not in first)]


def head_of(kind: Kind) -> list[str]:
    """First paragraphs of the docstring of a class."""
    if not kind.choice:
        return [kind.summary]
    chooser = KEYS.get(f"{kind.table}.type") or KEYS[f"{kind.table}.law"]
    text = in_python(text_of_choice(chooser, kind.choice), kind.table)
    if kind.base == "Hardening":
        text = f"sigma_y(e) = {text}."
    elif kind.base == "Softening":
        return [kind.summary, f"The factor at the temperature T is {text}."]
    else:
        text = f"{re.sub(r'(?<=[a-z])(?=[A-Z])', ' ', kind.name).capitalize()}: {text}."
    if len(text) + 7 <= WIDTH:
        return [text]
    summary, _, rest = text.partition(", ")
    return [f"{summary}.", f"{rest[0].upper()}{rest[1:]}"]


def rendered_kind(kind: Kind) -> Iterator[str]:
    """The lines of a dataclass."""
    keys: dict[str, Key | Part] = {**keys_of(kind.table, kind.choice), **kind.parts}
    required = {name for name, key in keys.items() if kind.choice and isinstance(key, Key) and key.required}
    required |= {*kind.required}
    names = ordered(keys, (*kind.first, *(name for name in keys if name in required and name not in kind.first)))
    yield f"@dataclass(frozen=True{', kw_only=True' if kind.by_place == 0 else ''})"
    yield f"class {kind.name}({kind.base}):"
    summary, *paragraphs = head_of(kind)
    if not paragraphs and not names:
        yield f'    """{summary}"""'
    else:
        yield f'    """{summary}'
        for text in paragraphs:
            yield ""
            yield from paragraph(text, "    ")
        if names:
            yield ""
            yield from section("Attributes", {name: text_of(name, keys[name], kind) for name in names}, "    ")
        yield '    """'
    yield ""
    if kind.choice:
        chooser = "law" if kind.base in ("Hardening", "Softening") else "type"
        yield f'    {chooser}: ClassVar[str] = "{kind.choice}"'
    for place, name in enumerate(names):
        if place == kind.by_place != 0:
            yield "    _: KW_ONLY"
        yield f"    {name}: {annotated(name, keys[name], kind, name in required)}"


def text_of(name: str, key: Key | Part, kind: Kind) -> str:
    """Description of a field."""
    if isinstance(key, Part):
        return f"{key.text}, {'a list of ' if key.is_list else ''}`brinell.{key.kind}` or a dictionary."
    return described(key, kind.table, kind.choice, name in kind.required)


def annotated(name: str, key: Key | Part, kind: Kind, is_required: bool) -> str:
    """Annotation and default of a field."""
    if name in kind.instead:
        return kind.instead[name]
    if isinstance(key, Part):
        return f"{key.type} | None = None"
    if is_required:
        return annotation(key)
    literal = key.default if kind.choice and re.fullmatch(r"-?[\d.]+", key.default) else ""
    return f"{annotation(key)} = {literal}" if literal else f"{annotation(key)} | None = None"


def rendered_scenario(scenario: Scenario) -> Iterator[str]:
    """The lines of the class of a scenario."""
    table = scenario.name.lower()
    keys = keys_of(table)
    names = ordered(keys, (*scenario.by_place, *scenario.first))
    shared = [name for name in SHARED if knows(table, name)]
    text = text_of_choice(KEYS["scenario"], table)
    yield f"class {scenario.name}(ScenarioCase):"
    yield f'    """{text[0].upper()}{text[1:]}."""'
    yield ""
    yield f'    _table = "{table}"'
    yield ""
    yield "    def __init__("
    yield "        self,"
    yield "        lower: Body,"
    yield "        upper: Body,"
    for place, name in enumerate(names):
        if place == len(scenario.by_place):
            yield "        *,"
        yield f"        {name}: {annotation(keys[name])}{'' if keys[name].required else ' | None = None'},"
    yield "        title: str | None = None,"
    for name in shared:
        yield f"        {name}: {SHARED[name][0]} | Mapping[str, Any] | None = None,"
    yield "    ):"
    yield f'        """Makes a case{groups_of(keys)}.'
    yield ""
    texts = {"lower": scenario.lower, "upper": scenario.upper} | {name: described(keys[name], table) for name in names}
    texts |= {"title": KEYS["title"].text} | {name: SHARED[name][1] for name in shared}
    yield from section("Args", texts, "        ")
    yield ""
    yield "        Raises:"
    yield "            InputError: the case is invalid; the message lists all problems found."
    yield '        """'
    yield "        ScenarioCase.__init__(self, locals())"


def knows(scenario: str, table: str) -> bool:
    """Whether some key of a table may be given in a scenario."""
    conditions = [key.when for name, key in KEYS.items() if name.startswith(f"{table}.")]
    return any(when != "scenario" or scenario in values for when, values in conditions if when in ("", "scenario"))


def groups_of(keys: Mapping[str, Key]) -> str:
    """Of which keys exactly one is given."""
    groups: dict[str, list[str]] = {}
    for name, key in keys.items():
        if key.one_of:
            groups.setdefault(key.one_of, []).append(name)
    said = [f"one of {', '.join(names[:-1])} and {names[-1]}" for names in groups.values()]
    return f"; exactly {', and '.join(said)} is given" if said else ""


def rendered_list(listed: Listed) -> Iterator[str]:
    """The lines of the class of an entry of a list in the summary."""
    columns = {column.name: column for column in _core.columns()[listed.key]}
    texts = {name: meaning(column) for name, column in columns.items()} | listed.derived
    always = [name for name in texts if name not in (*listed.later, *listed.derived)]
    names = {name: f"{name}_" if name == "pass" else name for name in (*always, *listed.later, *listed.derived)}
    yield "@dataclass(frozen=True)"
    yield f"class {listed.name}:"
    yield f'    """{listed.summary}'
    yield ""
    yield from section("Attributes", {own: texts[name] for name, own in names.items()}, "    ")
    yield '    """'
    yield ""
    for name, own in names.items():
        if name in listed.derived:
            yield f"    {own}: bool = False"
        else:
            kind = "int" if columns[name].is_integer else "float"
            yield f"    {own}: {kind}{' = math.nan' if name in listed.later else ''}"


def meaning(column: _core.Column) -> str:
    """Text of a number, with its unit in brackets before the first semicolon."""
    first, semicolon, rest = column.text.partition(";")
    unit = "" if column.is_integer else f" [{'-' if column.unit == '1' else column.unit}]"
    return f"{first[0].upper()}{first[1:]}{unit}{semicolon}{rest}."


# --- Files ------------------------------------------------------------------------------------------------------------

MARK = "# Written by tools/render_python.py from the engine's schema; do not edit."


MODULES = {
    "collections.abc": ("Mapping", "Sequence"),
    "dataclasses": ("KW_ONLY", "dataclass"),
    "pathlib": ("Path",),
    "typing": ("Any", "ClassVar", "Literal"),
    "brinell._tables": ("CaseTable", "DentOrBump", "Hardening", "Quantity", "Shape", "Softening", "Texture"),
    "brinell.bodies": ("Body",),
    "brinell.scenarios._case": ("ScenarioCase",),
    "brinell.settings": ("Grid", "Heating", "Interface", "Output", "Solver"),
}
"""Names that a file imports if it uses them."""


def rendered(path: str) -> str:
    """The content of a file of the package."""
    kinds = FILES[path].kinds
    code = "\n\n\n".join("\n".join(lines_of(kind)) for kind in kinds)
    own = {kind.name for kind in kinds}
    words = {*re.findall(r"\w+", re.sub(r'""".*?"""', "", code, flags=re.DOTALL))} - own
    used = {module: [name for name in names if name in words] for module, names in MODULES.items()}
    lines = ["import math"] * ("math" in words)
    lines += [f"from {module} import {', '.join(names)}" for module, names in used.items() if names]
    blocks = ["\n".join(line for line in lines if (" brinell." in line) is ours) for ours in (False, True)]
    names = ", ".join(f'"{name}"' for name in sorted(own))
    if len(names) + 13 > WIDTH:
        names = "\n    " + names.replace(", ", ",\n    ") + ",\n"
    return (
        f'# SPDX-License-Identifier: BSD-3-Clause\n{MARK}\n"""{FILES[path].text}"""\n\n'
        f"from __future__ import annotations\n\n{(2 * chr(10)).join(filter(None, blocks))}\n\n"
        f"__all__ = [{names}]\n\n\n{code}\n"
    )


def lines_of(kind: Kind | Scenario | Listed) -> Iterator[str]:
    """The lines of a class."""
    if isinstance(kind, Scenario):
        return rendered_scenario(kind)
    return rendered_list(kind) if isinstance(kind, Listed) else rendered_kind(kind)


def rendered_surface_fields() -> str:
    """The fields on surfaces that not every run has, as attributes of what Python reads."""
    of_contact = [field for field in _core.contact_fields() if field.needs]
    of_body = [field for field in _core.body_surface_fields() if field.needs not in ("strain", "texture")]
    names = [quoted(field.name) for field in of_body if field.lowers_surface]
    lowering = f"{', '.join(names)}{',' * (len(names) == 1)}"

    def rendered_class(name: str, text: str, fields: list[_core.SurfaceField]) -> Iterator[str]:
        yield from ("@dataclass(frozen=True, eq=False, kw_only=True)", f"class {name}:", f'    """{text}"""', "")
        for field in fields:
            yield f"    {field.name}: FloatArray | None = None"
            yield f'    """{field.text[0].upper()}{field.text[1:]} [{field.unit.replace("degC", "deg C")}]."""'

    lines = [
        "# SPDX-License-Identifier: BSD-3-Clause",
        MARK,
        '"""Fields on surfaces that exist where something acts; None: it does not act, or the field is not stored."""',
        *("", "from __future__ import annotations", "", "from dataclasses import dataclass", ""),
        *("import numpy as np", "from numpy.typing import NDArray", ""),
        '__all__ = ["LOWERING", "FieldsOfBody", "FieldsOfContact"]',
        *("", "FloatArray = NDArray[np.float64]", ""),
        f"LOWERING = ({lowering})",
        '"""Depths by which the surface of a body lies deeper than before."""',
        *("", ""),
        *rendered_class("FieldsOfContact", "Fields on the contact; (ny, nx) arrays.", of_contact),
        *("", ""),
        *rendered_class("FieldsOfBody", "Fields on the surface of a body; (ny, nx) arrays.", of_body),
    ]
    return "\n".join(lines) + "\n"


def main() -> int:
    """Writes the files, or with --check only tells which of them are not up to date."""
    texts = {PACKAGE / path: rendered(path) for path in FILES}
    texts[PACKAGE / "results" / "surface_fields.py"] = rendered_surface_fields()
    outdated = [path for path, text in texts.items() if not path.is_file() or path.read_text(encoding="utf-8") != text]
    is_check = sys.argv[1:] == ["--check"]
    for path in outdated:
        if is_check:
            print(f"{path} is not that of the schema: tools/render_python.py writes it", file=sys.stderr)
        else:
            path.write_text(texts[path], encoding="utf-8")
            print(f"wrote {path}")
    return int(is_check and bool(outdated))


if __name__ == "__main__":
    sys.exit(main())
