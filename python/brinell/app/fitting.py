# SPDX-License-Identifier: BSD-3-Clause
"""Fits of the page: what is asked for, checked field by field, as the file of a fit; and what is known of a fit.

A fit has a folder with the case, the curve and the file of the fit, from which `brinell fit` computes the same; it gets
the results, too. While it is computed, and if it was stopped, progress.json there has how far it is.
"""

from __future__ import annotations

import re
import tempfile
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from brinell.app.case_text import Values, inline, text_of
from brinell.app.checking import checked
from brinell.app.folder import Folder, json_of
from brinell.app.forms import field_of, units_of
from brinell.case import Case
from brinell.errors import BrinellError, InputError

__all__ = ["check_fit", "fit_files", "fit_result"]

_MOST_POINTS = 2000
_MOST_UNKNOWNS = 20
_MEMBERS: Mapping[str, tuple[type, ...]] = {
    "unknowns": (list,),
    "file": (str,),
    "text": (str,),
    "name": (str,),
    "columns": (list,),
    "x": (int,),
    "y": (int,),
    "units": (dict,),
    "reverse": (list,),
    "noise": (str, int, float),
    "pass": (int,),
    "loss": (str,),
    "method_error": (str, int, float),
}
_OPTIONAL = ("pass",)


@dataclass
class _Found:
    """What is known of a fit before it begins."""

    errors: list[dict[str, str]] = field(default_factory=list)
    """Field and text of each."""
    x: list[float] = field(default_factory=list)
    """The measured points in SI units, some of them if they are many."""
    y: list[float] = field(default_factory=list)

    def fails(self, where: str, error: BaseException | str) -> None:
        """Adds an error at a field."""
        self.errors.append({"field": where, "text": str(error)})


def check_fit(_stop: Any, values: Values, root: str, asked: Mapping[str, Any]) -> Iterator[dict[str, Any]]:
    """What is wrong with a fit, field by field, what its file has, and its points; computes no run.

    Raises:
        InputError: what is asked for is no fit.
    """
    _require_members(asked)
    found = _Found()
    with tempfile.TemporaryDirectory() as place:
        try:
            curve = _curve_file(Folder(Path(root)), asked, Path(place))
        except InputError as error:
            found.fails("file", error)
            curve = None
        if curve is not None:
            try:
                _check(found, values, Path(root), asked, curve)
            except (BrinellError, OSError) as error:
                found.fails("", str(error).replace(str(curve), curve.name))
    yield {"errors": found.errors, "x": found.x, "y": found.y, "text": _fit_text(values, asked)}


def _require_members(asked: Mapping[str, Any]) -> None:
    if unknown := sorted(set(asked) - set(_MEMBERS)):
        raise InputError(f"{unknown[0]!r} belongs to no fit; allowed: {', '.join(_MEMBERS)}")
    for name, kinds in _MEMBERS.items():
        if name in _OPTIONAL and name not in asked:
            continue
        if not isinstance(asked.get(name), kinds) or isinstance(asked[name], bool):
            raise InputError(f"{name} is missing, or not of its type")
    words = [*asked["columns"], *asked["reverse"], *asked["units"].values()]
    if len(asked["columns"]) != 2 or not all(isinstance(one, str) for one in words):
        raise InputError("columns are two names, units and reverse are texts")
    for one in asked["unknowns"]:
        if not isinstance(one, dict) or set(one) != {"key", "low", "high"} or not isinstance(one["key"], str):
            raise InputError("an unknown has key, low and high")
        if not all(isinstance(one[end], int | float | str) for end in ("low", "high")):
            raise InputError("low and high are numbers, or texts with a unit")
    if len(asked["unknowns"]) > _MOST_UNKNOWNS:
        raise InputError(f"{len(asked['unknowns'])} unknowns; allowed: up to {_MOST_UNKNOWNS}")


def _curve_file(folder: Folder, asked: Mapping[str, Any], place: Path) -> Path:
    """The measured curve as a file: of the folder, or the text that the browser has sent, written to a place.

    Raises:
        InputError: there is none, or it is too large.
    """
    if asked["file"]:
        return folder.data_file(asked["file"])
    if not asked["text"]:
        raise InputError("there is no measured curve; load one, or choose a file of the folder")
    path = place / _file_name(asked)
    path.write_text(asked["text"], encoding="utf-8")
    return path


def _file_name(asked: Mapping[str, Any]) -> str:
    """Name of the curve in the folder of the fit: that of the file, of plain letters."""
    name = re.sub(r"[^\w.-]", "_", Path(asked["file"] or asked["name"]).name, flags=re.ASCII).lstrip(".")
    return f"measured-{name[-60:]}"


def _is_load_depth(values: Values, asked: Mapping[str, Any]) -> bool:
    """Whether the columns are those of a load-depth curve, which a fit knows better than any two columns."""
    return values.get("scenario") == "indentation" and list(asked["columns"]) == ["approach", "F_n"]


def _check(found: _Found, values: Values, root: Path, asked: Mapping[str, Any], curve: Path) -> None:
    from brinell.fits.fitting import check_request
    from brinell.fits.problem import experiments_of
    from brinell.fits.unknowns import Parameter, Unknown

    data = _data(found, values, asked, curve)
    state = checked(values, root)
    if state.errors:
        found.fails("case", f"the case has problems: {state.errors[0].text}")
        return
    case = Case(state.text, file=root / "case.toml")
    unknowns, parameters = [], []
    for i, one in enumerate(asked["unknowns"]):
        unknown = Unknown(**one, places={end: f"unknowns[{i}].{end}: " for end in ("", "key", "low", "high")})
        try:
            parameters.append(Parameter.of(unknown, case, ["data"], several=False))
            unknowns.append(unknown)
        except InputError as error:
            where, _, said = str(error).partition(": ")
            said = said.removeprefix(f"unknown {one['key']}: ").replace(f"{root / 'case.toml'}", "the case")
            found.fails(where, said)
    if not asked["unknowns"]:
        found.fails("add", "a fit needs unknowns: add a key")
    method = _share(found, asked["method_error"])
    if data is not None and not found.errors:
        check_request([data], unknowns, asked["loss"], 0.95, method)
        experiments_of(case, [data], parameters)


def _data(found: _Found, values: Values, asked: Mapping[str, Any], curve: Path) -> Any:
    """The measured data, what is wrong with them at its field; None if something is."""
    from brinell.fits.checks import checked_sign
    from brinell.fits.columns import TextTable
    from brinell.fits.data import Data
    from brinell.fits.data import units_of as units_of_data

    def named(error: BaseException) -> str:
        return re.sub(r"^data '[^']*': ", "", str(error).replace(str(curve), curve.name.removeprefix("measured-")))

    kind: Any = "load-depth" if _is_load_depth(values, asked) else "history"
    columns = [] if kind == "load-depth" else asked["columns"]
    before = len(found.errors)
    try:
        table = TextTable.read(curve)
    except InputError as error:
        found.fails("file", named(error))
        return None
    measured: dict[str, Any] = {}
    for axis, unit in zip(("x", "y"), units_of_data(kind, columns), strict=True):
        try:
            measured[axis] = table.column(asked[axis], asked["units"].get(axis) or None, unit)
        except InputError as error:
            found.fails(f"units.{axis}" if ": unit of " in str(error) else axis, named(error))
        if axis in asked["reverse"] and axis in measured:
            measured[axis] = -measured[axis]
    if len(found.errors) > before:
        return None
    every = -(-len(measured["x"]) // _MOST_POINTS)
    found.x, found.y = measured["x"][::every].tolist(), measured["y"][::every].tolist()
    try:
        data = Data(kind=kind, columns=columns, passed=asked.get("pass"), **measured)
        checked_sign(data)
    except InputError as error:
        turned = re.search(r'reverse = \["([xy])"\]', str(error))
        found.fails(f"reverse.{turned[1]}" if turned else "pass" if "pass" in str(error) else "file", named(error))
        return None
    try:
        return Data(kind=kind, columns=columns, passed=asked.get("pass"), noise=asked["noise"] or None, **measured)
    except InputError as error:
        found.fails("noise", named(error))
        return None


def _share(found: _Found, given: float | str) -> float:
    from brinell import _core

    try:
        share = float(_core.quantity_like(given, "")) if isinstance(given, str) else float(given)
        if not 0.0 <= share <= 0.5:
            raise InputError(f"{given} is out of range; allowed: from 0 to 0.5, as 0.01 or '1 %'")
    except InputError as error:
        found.fails("method_error", error)
        return 0.0
    return share


def _fit_text(values: Values, asked: Mapping[str, Any]) -> str:
    """The file of the fit."""
    lines = ['case = "case.toml"', f"loss = {inline(asked['loss'])}", f"method_error = {inline(asked['method_error'])}"]
    for one in asked["unknowns"]:
        lines += ["", "[[unknown]]", *(f"{name} = {inline(one[name])}" for name in ("key", "low", "high"))]
    lines += ["", "[[data]]", f"file = {inline(_file_name(asked))}", f"name = {inline(Path(asked['name']).stem)}"]
    if not _is_load_depth(values, asked):
        lines += ['kind = "history"', f"columns = {inline(asked['columns'])}"]
        lines += [f"pass = {asked['pass']}"] if "pass" in asked else []
    units = {axis: unit for axis, unit in asked["units"].items() if unit}
    lines += [f"x = {asked['x']}", f"y = {asked['y']}"]
    lines += [f"units = {inline(units)}"] if units else []
    lines += [f"reverse = {inline(asked['reverse'])}"] if asked["reverse"] else []
    lines += [f"noise = {inline(asked['noise'])}"] if asked["noise"] else []
    return "\n".join(lines) + "\n"


def fit_files(_stop: Any, values: Values, root: str, asked: Mapping[str, Any]) -> Iterator[dict[str, bytes]]:
    """The files of a fit by their names: the case, the curve, the file of the fit. It lies two folders deep.

    Raises:
        InputError: something is wrong with it; the message has all.
    """
    (told,) = check_fit(_stop, values, root, asked)
    if told["errors"]:
        raise InputError("\n".join(one["text"] for one in told["errors"]))
    with tempfile.TemporaryDirectory() as place:
        curve = _curve_file(Folder(Path(root)), asked, Path(place)).read_bytes()
    moved = {key: f"../../{value}" if _is_file(key, value) else value for key, value in values.items()}
    yield {"case.toml": text_of(moved).text.encode(), _file_name(asked): curve, "fit.toml": told["text"].encode()}


def _is_file(key: str, value: Any) -> bool:
    """Whether a value is a path from the folder of the page."""
    found = field_of(key)
    return found is not None and found.is_file and isinstance(value, str) and not Path(value).is_absolute()


def fit_result(_stop: Any, root: str, name: str) -> Iterator[dict[str, Any]]:
    """A fit that has ended: its table and what is to be known as `brinell fit` tells it, its curves, its values.

    Raises:
        InputError: there is no such result.
    """
    from brinell.fits.result import Estimate, rows_of

    path = Folder(Path(root)).result(name)
    content: dict[str, Any] = json_of(path / "fit.json")
    try:
        estimates = [Estimate(**one) for one in content["unknowns"]]
        yield {
            "complete": True,
            "title": content["title"],
            "rows": rows_of(estimates, content["confidence"]),
            "findings": content["findings"],
            "runs": content["runs"],
            "misfit": content["misfit"],
            "seconds": content["wall_time_s"],
            "values": [{"key": one.key, "sizes": _in_units(one.value, one.unit)} for one in estimates],
            "curves": [
                {**{key: one[key] for key in ("name", "x", "measured", "fitted")}, "columns": one.get("columns", [])}
                for one in content["data"]
            ],
        }
    except (KeyError, TypeError) as error:
        raise InputError(f"{name} is no result of brinell fit, or of another version: {error}") from error


def _in_units(value: float, unit: str) -> dict[str, float]:
    """A value in the units that its field offers, with six digits; "" is a bare number."""
    from brinell import _core

    found = {"": float(f"{value:.6g}")}
    for one in units_of(unit):
        try:
            size, twice = (_core.quantity_like(f"{number} {one}", unit) for number in (1, 2))
        except InputError:
            continue
        if size and abs(twice - 2.0 * size) < 1e-9 * abs(size):  # not so of degrees Celsius
            found[one] = float(f"{value / size:.6g}")
    return found
