# SPDX-License-Identifier: BSD-3-Clause
"""What the workers of the page do: checks, runs of small cases for sliders, pictures and figures of results."""

from __future__ import annotations

import base64
import io
import math
import subprocess
import sys
import time
from collections.abc import Callable, Iterator, Mapping
from dataclasses import asdict
from pathlib import Path
from typing import Any, cast

from brinell.app.checking import checked, require_valid
from brinell.app.folder import Folder
from brinell.case import Case
from brinell.errors import BrinellError, InputError

__all__ = ["LONGEST_PREVIEW", "check", "figures", "image", "outline", "preview", "template", "valid_text"]

Stop = Callable[[], bool]

LONGEST_PREVIEW = 30.0
"""Longest foretold time of a case that sliders may run [s]."""

_SECONDS_BETWEEN = 0.1


def check(_stop: Stop, values: Mapping[str, Any], folder: str) -> Iterator[dict[str, Any]]:
    """What `brinell check` says of a case."""
    yield checked(values, Path(folder)).as_json()


def valid_text(_stop: Stop, cases: list[Mapping[str, Any]], folder: str) -> Iterator[str]:
    """The text of the first of some cases.

    Raises:
        InputError: one of them has errors.
    """
    texts = [require_valid(values, Path(folder)).text for values in cases]
    yield texts[0]


def template(_stop: Stop, scenario: str) -> Iterator[str]:
    """The text of the template of a scenario, as `brinell new` writes it."""
    command = [sys.executable, "-m", "brinell", "new", "--", scenario]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    if done.returncode:
        raise InputError(done.stderr.strip())
    yield done.stdout


def preview(stop: Stop, values: Mapping[str, Any], folder: str, shown: Mapping[str, str]) -> Iterator[dict[str, Any]]:
    """Runs a small case without writing anything: rows of the history as they come, at the end a picture.

    Args:
        stop: whether another case is wanted.
        values: the case.
        folder: its folder.
        shown: kind and name of the picture.

    Raises:
        InputError: the case has errors, or would take too long.
    """
    from brinell.scenarios import SCENARIOS

    text = require_valid(values, Path(folder)).text
    case = Case(text, file=Path(folder) / "case.toml")
    if case.forecast.seconds > LONGEST_PREVIEW:
        raise InputError(f"this takes about {case.forecast.seconds:.0f} s; run it instead")
    traits = SCENARIOS[cast(Any, case.scenario)]
    begun = time.monotonic()
    stepping = case.steps()
    rows: list[dict[str, float]] = []
    best, fields, told, sent = float("inf"), None, time.monotonic(), 0
    for row in stepping:
        rows.append(row)
        if stop():
            return
        place = traits.distance_from_middle(row)
        if place < best:
            best = place
            if traits.motion is None or _is_near_middle(row[traits.motion], rows[0][traits.motion]):
                fields = stepping.fields(), int(row["step"])
        if time.monotonic() - told > _SECONDS_BETWEEN:
            yield {"columns": _columns(rows[sent:]), "of": stepping.step_count}
            told, sent = time.monotonic(), len(rows)
    notes = _notes(stepping.summary())
    yield {"columns": _columns(rows[sent:]), "of": len(rows), "seconds": time.monotonic() - begun, "notes": notes}
    if fields is not None:
        yield {"picture": _picture_of_fields(*fields, shown)}


def _notes(summary: Mapping[str, Any]) -> list[str]:
    """What is known about the quality of a result: warnings, and the resolution with its expected errors."""
    texts = [warning["text"] for warning in summary.get("warnings", [])]
    resolution = summary.get("resolution", {}).get("text", "")
    return [*texts, resolution] if resolution else texts


def _is_near_middle(place: float, first: float) -> bool:
    """Whether the contact has come so near to the middle that its fields are worth their time."""
    return abs(place) <= 0.1 * abs(first)


def _columns(rows: list[dict[str, float]]) -> dict[str, list[float | None]]:
    """Rows as columns; JSON has no number that is not finite."""
    names = rows[0] if rows else ()
    return {name: [row[name] if math.isfinite(row[name]) else None for row in rows] for name in names}


def _picture_of_fields(fields: Mapping[str, Any], step: int, shown: Mapping[str, str]) -> dict[str, Any]:
    from brinell.app.pictures import picture, state_of_fields

    return _first_of(state_of_fields(fields, step), shown, picture)


def _first_of(state: Any, shown: Mapping[str, str], picture: Callable[..., dict[str, Any]]) -> dict[str, Any]:
    """The wanted picture of a state, or the first one that has something to show."""
    names, empty = state.names(), state.empty()
    kind = shown.get("kind", "map")
    kind = kind if names.get(kind) else "map"
    name = shown.get("name", "")
    first = next((one for one in names[kind] if one not in empty[kind]), names[kind][0])
    found = picture(state, kind, name if name in names[kind] else first)
    return {**found, "names": names, "empty": empty}


def outline(_stop: Stop, root: str, name: str) -> Iterator[dict[str, Any] | None]:
    """A result: its case, stored steps, key numbers and warnings; None of a run that has hardly begun."""
    from brinell.app.case_text import values_of
    from brinell.app.forms import applying
    from brinell.report.numbers import accuracies_of
    from brinell.results import RunError, open_run
    from brinell.scenarios import SCENARIOS

    path = Folder(Path(root)).result(name)
    try:
        run = open_run(path, allow_unfinished=True)
    except RunError:
        if (path / "summary.json").exists() or not (path / "history.csv").exists():
            raise
        yield None
        return
    numbers = SCENARIOS[run.scenario].key_numbers(run) if run.complete else iter(())
    try:
        values = values_of(run.case_text)
    except (RunError, OSError):  # it may not be written yet
        values = {}
    yield {
        "name": name,
        "scenario": run.scenario,
        "title": run.title if run.complete else str(values.get("title", "")),
        "complete": run.complete,
        "values": values,
        "pure": [key for key, one in applying(values).items() if one["pure"]],
        "steps": [int(step) for step in run.steps] if run.complete else _stored_steps(path),
        "numbers": [{"name": n.name, "value": float(n.value), "unit": n.unit} for n in numbers] + _more_numbers(run),
        "notes": _notes(run.summary or {}),
        "intervals": [asdict(one) for one in accuracies_of(run)] if run.complete else [],
    }


def _more_numbers(run: Any) -> list[dict[str, Any]]:
    """Key numbers of effects that are no scenario's own: fatigue, and the resistance of the contact."""
    found = []
    for side, judged in (run.summary or {}).get("fatigue", {}).items():
        named = (
            ("utilisation", "value", "Utilisation", "1"),
            ("orthogonal_shear", "value_Pa", "Orthogonal shear", "Pa"),
        )
        for key, member, name, unit in named:
            if judged.get(key):
                text = f"{name} by fatigue, {side} body"
                found.append({"name": text, "value": float(judged[key][member]), "unit": unit})
    resistance = run.history.get("contact_resistance", [])
    known = [float(one) for one in resistance if one > 0 and math.isfinite(one)]
    if known and run.complete:
        found.append({"name": "Smallest contact resistance", "value": min(known), "unit": "ohm"})
    return found


def image(_stop: Stop, root: str, name: str, state: str, shown: Mapping[str, str]) -> Iterator[dict[str, Any] | None]:
    """A picture of a stored state of a result; None of a run that has stored none so far."""
    path = Folder(Path(root)).result(name)
    if (path / "summary.json").exists() or not (path / "history.csv").exists():
        yield _image(path, state, shown)
        return
    try:
        yield _image(path, state, shown) if _stored_steps(path) else None
    except (BrinellError, OSError, KeyError):  # the file is being written at this moment
        yield None


def _image(path: Path, state: str, shown: Mapping[str, str]) -> dict[str, Any]:
    """A picture of a stored state."""
    from brinell.app.pictures import picture, state_of_snapshot
    from brinell.results import open_run

    run = open_run(path, allow_unfinished=True)
    which: Any = int(state) if state.isdecimal() else state
    if which not in ("aligned", "final") and which not in run.steps:
        raise InputError(f"{path.name} has no stored step {state[:50]!r}")
    if which == "final" and not run.complete:
        which = run.steps[-1]
    wants_tensor = shown.get("name", "")[-3:-2] == "_"
    return _first_of(state_of_snapshot(run.snapshot(which, tensors=wants_tensor), run), shown, picture)


def _stored_steps(path: Path) -> list[int]:
    """Stored steps of a run that may just begin."""
    from brinell.results import RunError, open_run

    try:
        return [int(step) for step in open_run(path, allow_unfinished=True).steps]
    except RunError:
        return []


def figures(_stop: Stop, root: str, name: str) -> Iterator[list[dict[str, str]]]:
    """The figures of a result: name, caption, and the picture as a data address."""
    drawn = _drawn(Folder(Path(root)).result(name))
    yield [{"name": one, "caption": caption, "source": _address(drawing)} for one, caption, drawing in drawn]


def _address(drawing: Any) -> str:
    """A figure, or a file with a picture, as a data address."""
    from brinell.plot import style

    if isinstance(drawing, Path):
        return "data:image/png;base64," + base64.b64encode(drawing.read_bytes()).decode("ascii")
    buffer = io.BytesIO()
    with style.look():
        drawing.savefig(buffer, format="svg", metadata={"Date": None})
    return "data:image/svg+xml;base64," + base64.b64encode(buffer.getvalue()).decode("ascii")


def _drawn(path: Path) -> Iterator[tuple[str, str, Any]]:
    """Figures of a run, a sweep or a fit: name, caption, drawing."""
    import matplotlib

    matplotlib.use("Agg")
    if (path / "fit.json").is_file():
        for file in sorted((path / "figures").glob("*.png")):
            if not file.is_symlink():
                yield file.stem, f"Figure {file.stem} of the fit.", file
        return
    if (path / "sweep.json").is_file():
        from brinell.plot.sweeps import sweep_numbers
        from brinell.sweeps import open_sweep

        drawing = sweep_numbers(list(open_sweep(path).runs.values()))
        if drawing is not None:
            yield "sweep", "Key numbers of the runs over what varies.", drawing
        return
    from brinell.plot.standard import standard_figures
    from brinell.results import open_run

    for one in standard_figures(open_run(path, allow_unfinished=True)):
        yield one.name, one.caption, one.figure
