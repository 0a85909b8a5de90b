# SPDX-License-Identifier: BSD-3-Clause
"""The page of a run: what stands in it. How it behaves in a browser is tested in test_report_browser.py."""

import base64
import json
import re
from collections.abc import Callable
from html.parser import HTMLParser
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from brinell.plot.energy import sinks_of
from brinell.report import findings, volumes, write_report
from brinell.report.cli import report
from brinell.report.inputs import inputs_of
from brinell.report.numbers import energies_of, key_numbers
from brinell.report.text import number, quantity
from brinell.results import History, Run, open_run
from brinell.results.key_units import UNITS, key_unit

MakeRun = Callable[..., Path]
CASE_FILE = Path(__file__).parents[2] / "docs" / "reference" / "case-file.md"


class Page(HTMLParser):
    """What the tests ask of a page: tags with their attributes, visible text, contents of scripts."""

    def __init__(self, path: Path) -> None:
        super().__init__()
        self.tags: list[tuple[str, dict[str, str | None]]] = []
        self.scripts: list[str] = []
        self.text = ""
        self._inside = ""
        self.feed(path.read_text(encoding="utf-8"))

    def handle_starttag(self, tag: str, attributes: list[tuple[str, str | None]]) -> None:
        self.tags.append((tag, dict(attributes)))
        self._inside = tag
        if tag == "script":
            self.scripts.append("")

    def handle_endtag(self, _: str) -> None:
        self._inside = ""

    def handle_data(self, data: str) -> None:
        if self._inside == "script":
            self.scripts[-1] += data
        elif self._inside != "style":
            self.text += data

    def all(self, tag: str) -> list[dict[str, Any]]:
        return [attributes for name, attributes in self.tags if name == tag]

    @property
    def data(self) -> dict[str, Any]:
        return dict(json.loads(self.scripts[0]))


def page_of(folder: Path, tmp_path: Path) -> Page:
    return Page(write_report(open_run(folder, allow_unfinished=True), tmp_path / "new" / "page.html"))


@pytest.fixture
def page(make_run: MakeRun, tmp_path: Path) -> Page:
    return page_of(make_run(9.0), tmp_path)


def test_a_page_needs_nothing_but_itself(page: Page) -> None:
    assert page.all("html") == [{"lang": "en"}]
    for attributes in page.all("img"):
        assert attributes["src"].startswith("data:image/svg+xml;base64,")
        assert len(attributes["alt"]) > 20
    assert all(attributes["href"].startswith(("#", "data:")) for tag in ("a", "link") for attributes in page.all(tag))
    assert not any("src" in attributes for attributes in page.all("script"))
    assert sum("plotly.js v" in script[:200] for script in page.scripts) == 1
    ids = {attributes["id"] for _, attributes in page.tags if "id" in attributes}
    assert all(attributes["href"][1:] in ids for attributes in page.all("a"))


def test_a_page_tells_what_it_should(page: Page) -> None:
    for text in ("synthetic", "Key results", "Energy balance", "Inputs", "Under load", "After unloading"):
        assert text in page.text
    assert "1.99 mm9 " in page.text.replace("\n", "")  # the interference, and alpha* beside it
    figures = [attributes["id"] for attributes in page.all("figure")]
    assert {"figure-loaded-pressure", "figure-residual-surfaces", "figure-energy-balance"} <= set(figures)


def test_numbers_are_those_of_the_run(make_indentation: MakeRun, make_rolling: MakeRun) -> None:
    indentation, rolling = open_run(make_indentation()), open_run(make_rolling())
    found = {one.name: one for one in [*key_numbers(indentation), *key_numbers(rolling)]}
    assert found["Hardness, first indent"].value == quantity(indentation.indents[0].hardness, "Pa")
    assert found["Rut depth after the last pass"].value == quantity(rolling.passes[-1].rut_depth, "m")
    assert found["Largest load"].normalised == "8.67 P_c"
    energies = {one.name: one.value for one in energies_of(rolling)}
    assert energies["work of the drive"] == quantity(rolling.history["work"][-1], "J")
    assert set(energies) >= {"dissipated, lower body", "locked in", "recoverable", "unaccounted for"}


# --- Interactive pictures ---------------------------------------------------------------------------------------------


def decoded(text: str) -> np.ndarray:
    return np.frombuffer(base64.b64decode(text), dtype="<f4")


def test_fields_arrive_in_the_page(make_run: MakeRun, tmp_path: Path) -> None:
    folder = make_run(9.0)
    data = page_of(folder, tmp_path).data
    assert [(one["body"], one["state"]) for one in data["volumes"]] == [
        ("lower body", "under load"),
        ("upper body", "under load"),
        ("lower body", "after unloading"),
        ("upper body", "after unloading"),
    ]
    body = open_run(folder).snapshot("final").lower
    volume = data["volumes"][2]
    (field,) = [one for one in volume["fields"] if one["title"] == "Equivalent plastic strain"]
    values = decoded(field["values"]).reshape(len(volume["z"]), len(volume["y"]), len(volume["x"]))
    assert volume["unit"] == "mm"
    where = [
        np.argmin(np.abs(axis[:, None] - 1e-3 * np.array(shown)), axis=0)
        for axis, shown in zip((body.z, body.y, body.x), (volume["z"], volume["y"], volume["x"]), strict=True)
    ]
    np.testing.assert_allclose(values, 100.0 * body.equivalent_plastic_strain[np.ix_(*where)], rtol=1e-6)
    assert values.max() == pytest.approx(100.0 * body.equivalent_plastic_strain.max(), rel=1e-6)
    surface = data["surfaces"][0]
    heights = decoded(surface["heights"]).reshape(len(surface["y"]), len(surface["x"]))
    assert surface["heightUnit"] == "µm"
    np.testing.assert_allclose(heights, -1e6 * body.residual_displacement, rtol=1e-6)


def test_large_fields_are_thinned_and_the_page_says_so(
    make_run: MakeRun, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(volumes, "FIELD_BYTES", 60_000)
    page = page_of(make_run(9.0), tmp_path)
    fields = [field["values"] for volume in page.data["volumes"] for field in volume["fields"]]
    assert 20_000 < sum(decoded(text).nbytes for text in fields) <= 60_000
    assert "To keep this page small" in page.text
    assert all(0.0 in volume["y"] for volume in page.data["volumes"])  # the plane of symmetry stays


def test_a_rigid_or_elastic_body_has_no_pictures(
    make_indentation: MakeRun, make_rolling: MakeRun, tmp_path: Path
) -> None:
    rigid = page_of(make_indentation(), tmp_path).data
    assert {one["body"] for one in rigid["volumes"]} == {"lower body"}
    elastic = page_of(make_rolling(yields=False), tmp_path)
    assert elastic.data["surfaces"] == []
    assert "3-D" not in elastic.text


# --- Inputs -----------------------------------------------------------------------------------------------------------


def test_each_key_of_a_case_has_its_unit() -> None:
    """As the reference of the case file tells it."""
    rows = [line.split(" | ") for line in CASE_FILE.read_text(encoding="utf-8").splitlines() if line.startswith("| `")]
    told = {}
    for key, value, *_ in rows:
        found = re.search(r" in (ohm m\^?2?|\S+(?: K\))?) or with a unit|(in degrees)", value + "".join(_))
        if found:
            unit = "°" if found[2] or found[1] == "degrees" else found[1]
            told[key.strip("| `").split(".")[-1]] = unit.replace("^2", "²").replace("^3", "³").replace("degC", "°C")
    assert len(told) > 25
    assert dict(UNITS) == told


@pytest.mark.parametrize(
    ("key", "case", "unit"),
    [
        ("lower.material.hardening.offset", None, ""),  # a strain; that of a tugging is a length
        ("thermal.source.flux", None, "W/m²"),
        ("lower.texture[0].depth", None, "m"),
        ("indentation.load.2", None, "N"),
        ("indentation.load", {"indentation.normalised": True}, ""),
        ("tugging.interference", None, ""),  # in critical interferences
        ("tugging.interference", {"tugging.normalised": False}, "m"),
        ("lower.texture[1].radius", None, "m"),  # of dents of an earlier version
        ("grid.no_such_key", None, ""),
    ],
)
def test_units_are_those_of_whole_keys(key: str, case: dict[str, Any] | None, unit: str) -> None:
    assert key_unit(key, case) == unit


def test_inputs_have_units(make_rolling: MakeRun) -> None:
    run = open_run(make_rolling())
    assert run.summary is not None
    case = run.summary["case"]
    case["lower"] = {"material": {"hardening": {"law": "swift", "offset": 4e-3}}}
    assert {one.key: one.value for one in inputs_of(run)["lower"]}["material.hardening.offset"] == "0.004"
    case["rolling"] = {"load": 2e3, "places": [0.0, -1e-4], "normalised": False, "stress": [], "title": None}
    rows = {one.key: one.value for one in inputs_of(run)["rolling"]}
    assert rows == {
        "load": "2 kN",
        "places": "0 m, −100 µm",
        "normalised": "no",
        "stress": "none",
        "title": "none",
    }
    case["rolling"] = {"load": 20.0, "normalised": True}
    assert inputs_of(run)["rolling"][0].value == "20 P_c"
    case["rolling"] = {"heights": np.linspace(-1e-6, 2e-6, 900).tolist()}
    assert inputs_of(run)["rolling"][0].value == "900 values from −1 µm to 2 µm"


@pytest.mark.parametrize(
    ("value", "text"), [(0.0, "0"), (2.5e-7, "2.5 × 10⁻⁷"), (-1.5, "−1.5"), (123456.0, "1.23 × 10⁵")]
)
def test_numbers_in_plain_text(value: float, text: str) -> None:
    assert number(value) == text


# --- Warnings ---------------------------------------------------------------------------------------------------------


def changed(run: Run, **columns: float) -> Run:
    """The run with its energy balance closed, and then the last value of some columns multiplied."""
    values = {name: np.array(column) for name, column in run.history.items()}
    values["energy_elastic"] = values["work"] - sum(values[sink.column] for sink in sinks_of(run.history)[:-1])
    for name, factor in columns.items():
        values[name][-1] *= factor
    return Run(run.path, History(values), run.summary)


def test_warnings_are_those_of_the_run(make_run: MakeRun) -> None:
    run = open_run(make_run(9.0))
    assert run.summary is not None
    run.summary["warnings"] = []
    assert findings.findings_of(run) == []
    told = Run(run.path, run.history, run.summary | {"warnings": [{"key": "no_yield", "text": "nothing has yielded"}]})
    assert findings.findings_of(told) == ["Nothing has yielded."]


def test_an_older_run_was_not_judged(make_run: MakeRun) -> None:
    run = open_run(make_run(9.0))
    assert run.summary is not None
    run.summary.pop("warnings", None)
    assert "did not judge" in findings.findings_of(run)[0]


def test_unfinished_run(make_run: MakeRun, tmp_path: Path) -> None:
    page = page_of(make_run(9.0, finished=False), tmp_path)
    assert "The run has not finished: there are 25 steps" in page.text
    assert "told here when the run has finished" in page.text
    assert {one["state"] for one in page.data["volumes"]} == {"under load"}


# --- Command ----------------------------------------------------------------------------------------------------------


def main(*arguments: str | Path) -> int:
    with pytest.raises(SystemExit) as end:
        report([str(one) for one in arguments], prog_name="brinell report")
    return int(end.value.code or 0)


def test_command(make_rolling: MakeRun, capsys: pytest.CaptureFixture[str]) -> None:
    folder = make_rolling()
    assert main(folder) == 0
    assert capsys.readouterr().out == f"{folder / 'report.html'}\n"
    assert (folder / "report.html").stat().st_size > 1_000_000


def test_command_on_what_is_no_run(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(tmp_path / "nowhere") == 2
    assert capsys.readouterr().err == f"brinell: error: {tmp_path / 'nowhere'}: no such folder\n"
