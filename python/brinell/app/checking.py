# SPDX-License-Identifier: BSD-3-Clause
"""What `brinell check` says of a case, each sentence at the field that it is about."""

from __future__ import annotations

import re
import warnings
from collections.abc import Mapping
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import Any

from brinell.app.case_text import CaseText, Values, text_of
from brinell.app.forms import applying, field_of, form, plain_key, sections, table_of
from brinell.case import Case
from brinell.errors import BrinellError, InputError

__all__ = ["Checked", "Remark", "checked", "outside", "remark_of"]

_FILE = "case.toml"
_REASON = "the reason may be: "
_LINE = re.compile(r":(\d+)")
_KEY = re.compile(r"[A-Za-z_][\w-]*(?:\[\d+\])?(?:\.[A-Za-z_][\w-]*(?:\[\d+\])?)*")


@dataclass(frozen=True)
class Remark:
    """An error or a warning."""

    key: str
    """Field that it belongs to, or a table; empty: the whole case."""
    line: int
    """Line of the text of the case; 0: none."""
    text: str


@dataclass(frozen=True)
class Checked:
    """A case as the page shows it."""

    text: str
    """As a case file."""
    errors: list[Remark]
    warnings: list[Remark]
    report: str
    """What `brinell check` prints; empty if there are errors."""
    forecast: str
    seconds: float
    """Foretold time on one core [s]; 0 if there are errors."""
    applies: Mapping[str, Mapping[str, bool]]
    """Fields that apply, by key (`forms.applying`)."""

    def as_json(self) -> dict[str, Any]:
        """For the page."""
        return asdict(self)


def checked(values: Values, folder: Path) -> Checked:
    """Checks a case.

    Args:
        values: values by dotted key.
        folder: folder in which the case lies, and which it may read.
    """
    written = text_of(values)
    applies = applying(values)
    errors = [Remark(key, _line_of(key, written), text) for key, text in outside(values, folder)]
    if errors:
        return Checked(written.text, errors, [], "", "", 0.0, applies)
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            case = Case(written.text, file=folder / _FILE)
        report, expected, forecast = case.check(), case.warnings, case.forecast
    except (BrinellError, MemoryError) as error:
        texts = str(error).split("\n") if str(error) else ["not enough memory"]
        found = [remark_of(text, folder / _FILE, written, values) for text in texts]
        found.sort(key=lambda one: one.text.startswith(_REASON))  # what it may be the reason of stands before it
        return Checked(written.text, found, [], "", "", 0.0, applies)
    said = [remark_of(one.text, folder / _FILE, written, values) for one in expected]
    return Checked(written.text, [], said, report, forecast.text, forecast.seconds, applies)


def remark_of(text: str, file: Path, written: CaseText, values: Values) -> Remark:
    """The field and the line of a message of the engine.

    A message names the key that it is about first, after its place; one about a table as a whole has only its line.
    """
    said = text.removeprefix(str(file))
    found = _LINE.match(said) if said != text else None
    line = int(found[1]) if found else 0
    said = said[found.end() if found else 0 :].removeprefix(": ") if said != text else text
    at_line = written.lines.get(line, "")
    tables = {section.table for section in sections()}
    is_unknown = at_line and field_of(at_line) is None and plain_key(at_line) not in tables
    key = at_line if is_unknown else _first_key(said, values) or at_line
    if at_line and plain_key(at_line) == plain_key(key):  # the line knows the number of a repeated table
        key = at_line
    elif at_line and plain_key(key).startswith(f"{plain_key(at_line)}."):
        key = at_line + plain_key(key)[len(plain_key(at_line)) :]
    return Remark(key, line or _line_of(key, written), said)


def _first_key(text: str, values: Values) -> str:
    """The first word that is a key or a table of the case, as the values name it."""
    tables = {section.table for section in sections()} | {name.partition(".")[0] for name in form() if "." in name}
    for word in _KEY.findall(text):
        if word in values:
            return str(word)
        found = field_of(word)
        if found is not None and ("." in word or f"{word} =" in text or text.startswith(word)):
            return _numbered(word, found.list)
        if word in tables and ("." in word or f"[{word}]" in text):
            return str(word)
    return ""


def _numbered(key: str, table: str) -> str:
    """A key of a repeated table with its number, the first one if the message has none."""
    return table + "[0]" + key.removeprefix(table) if table and key.startswith(f"{table}.") else key


def _line_of(key: str, written: CaseText) -> int:
    """Line of a key, or of its table; 0 if the text has neither."""
    by_key = {name: line for line, name in written.lines.items()}
    return by_key.get(key, by_key.get(table_of(key), 0))


def outside(values: Values, folder: Path) -> list[tuple[str, str]]:
    """Texts of the case that would make it read or write outside its folder, by key.

    Every text but the title counts as a path, whatever its key is called, so that a new key cannot lead outside.
    """
    home = folder.resolve()
    found = []
    for key, value in values.items():
        one = field_of(key)
        if one is None or one.kind != "text" or key == "title" or not isinstance(value, str):
            continue
        try:
            inside = (home / value).resolve().is_relative_to(home)
        except (OSError, RuntimeError, ValueError):
            inside = False
        if not inside:
            found.append((key, f'{key} = "{value}" is outside the folder of this page, {home}; put the file there'))
    return found


def values_that_apply(values: Values) -> dict[str, Any]:
    """The values without those of fields that do not apply to the others; unknown keys stay."""
    applies = applying(values)
    return {key: value for key, value in values.items() if key in applies or field_of(key) is None}


def require_valid(values: Values, folder: Path) -> CaseText:
    """The text of a case that may be run.

    Raises:
        InputError: the case has errors; the message has them all.
    """
    result = checked(values, folder)
    if result.errors:
        raise InputError("\n".join(one.text for one in result.errors))
    return text_of(values)
