# SPDX-License-Identifier: BSD-3-Clause
"""Runs in which neither body can yield compute the fields within the bodies only if the case asks for them."""

from __future__ import annotations

import itertools
import subprocess
import sys
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from click.testing import CliRunner

import brinell
from brinell.export import export_vti
from brinell.plot.cli import plot
from brinell.report import write_report
from brinell.results import Run
from brinell.scenarios import SCENARIOS
from brinell.sweeps.numbers import residual_stress
from kinds_of_runs import DOMAINS, INTERFACES, Kind
from vtk_images import VtkhdfFile

pytestmark = pytest.mark.filterwarnings("ignore::brinell.ResolutionWarning", "ignore::brinell.CaseWarning")

WITHIN = {"stress", "von_mises_stress", "plastic_strain", "equivalent_plastic_strain", "temperature"}
PAIRS = (("elastic", "elastic"), ("elastic", "rigid"), ("rigid", "elastic"))


def elastic_kinds() -> list[Kind]:
    """Kinds without a body that can yield: each scenario with each boundary and interface, the pairs by turns."""
    pairs = itertools.cycle(PAIRS)
    every = (
        Kind(scenario, *next(pairs), domain, interface)
        for scenario, domain, interface in itertools.product(SCENARIOS, DOMAINS, INTERFACES)
    )
    return [kind for kind in every if kind.is_possible]


KINDS = elastic_kinds()


def run_of(kind: Kind, folder: Path, threads: int = 1, **output: Any) -> Run:
    return kind.case(output={"snapshots": "every 3", **output}).run(folder, threads=threads)


def numbers_of(summary: Any, place: str = "") -> dict[str, Any]:
    """The numbers of a summary by their places."""
    if isinstance(summary, dict):
        items = summary.items()
    elif isinstance(summary, list):
        items = {str(i): one for i, one in enumerate(summary)}.items()
    else:
        return {place: summary}
    return {k: v for key, value in items for k, v in numbers_of(value, f"{place}.{key}").items()}


def assert_same_but_within(part: Run, whole: Run) -> None:
    """Compares histories, summaries and the fields on surfaces digit by digit."""
    for name, column in whole.history.items():
        np.testing.assert_array_equal(part.history[name], column, err_msg=name)
    for body in ("lower", "upper"):
        names = [name for name in whole.field_names(body) if name not in WITHIN]  # type: ignore[arg-type]
        assert [name for name in part.field_names(body) if name in names] == names  # type: ignore[arg-type]
        for name in names:
            ours, expected = (run.field(body, name) for run in (part, whole))  # type: ignore[arg-type]
            np.testing.assert_array_equal(ours.values, expected.values, err_msg=name)
    ours, expected = (numbers_of(run.summary) for run in (part, whole))
    # What differs: time, fields that were asked for, and layers and depth profiles of bodies without fields within.
    other = (
        ".run.",
        ".case.output.",
        ".grid.lower_cells.2",
        ".grid.upper_cells.2",
        ".grid.memory",
        ".grid.surfaces",
        ".profile.",
    )
    same = {key: value for key, value in expected.items() if not key.startswith(other)}
    assert {key: value for key, value in ours.items() if not key.startswith(other)} == same


@pytest.mark.parametrize("kind", KINDS, ids=" ".join)
def test_histories_and_surfaces_have_the_same_digits(kind: Kind, tmp_path: Path) -> None:
    whole = run_of(kind, tmp_path / "whole", fields="all")
    for threads in (1, 2):
        part = run_of(kind, tmp_path / f"part-{threads}", threads)
        assert_same_but_within(part, whole)
        for body in ("lower", "upper"):
            assert not WITHIN & set(part.field_names(body))  # type: ignore[arg-type]


@pytest.mark.parametrize("threads", [1, 2])
def test_so_they_have_under_steady_heat(threads: int, tmp_path: Path) -> None:
    kind = Kind("rolling", "elastic", "elastic", "open", "heat")

    def run(name: str, threads: int, **fields: str) -> Run:
        case = kind.case(output={"snapshots": "every 3", **fields}, thermal={"regime": "steady"})
        return case.run(tmp_path / name, threads=threads)

    assert_same_but_within(run("part", threads), run("whole", 1, fields="all"))


@pytest.mark.parametrize("kind", KINDS[::7], ids=" ".join)
def test_figures_reports_and_exports_do_without(kind: Kind, tmp_path: Path) -> None:
    run = run_of(kind, tmp_path / "run")
    for step in (*run.steps, run.history.steps):
        assert not any(name.endswith("volume") for name in VtkhdfFile(run.file).blocks(float(step)))
    assert export_vti(run, tmp_path / "vti")
    assert run.to_pyvista("final").n_blocks
    commands = [["fields", "--step", "final"], ["history"]]
    for command in commands:
        result = CliRunner().invoke(plot, [*command, str(run.path), "-o", str(tmp_path / "figures")])
        assert result.exit_code == 0, result.output
    page = write_report(run, tmp_path / "report.html").read_text(encoding="utf-8")
    assert "not computed: neither can yield; output.fields asks for them" in page
    assert residual_stress(run) == {}
    memory = kind.case(output={"snapshots": "every 3"}).run(in_memory=True)
    assert_same_but_within(memory, run)


ASKED: dict[str, dict[str, Any]] = {
    "all": {"fields": "all"},
    "one": {"fields": ["surface", "von_mises_stress"]},
    "depth": {"depth": "20 um"},
    "plane": {"region_y": [0, 0]},
    "section across": {"region_x": ["1 um", "1 um"]},
    "point": {"points": [{"depth": "20 um"}]},
}
NOT_ASKED: dict[str, dict[str, Any]] = {
    "nothing": {},
    "surface": {"fields": "surface"},
    "surface of a plane": {"fields": "surface", "region_y": [0, 0], "depth": "20 um"},
    "names on surfaces": {"fields": ["residual_displacement", "shear"]},
    "region": {"region_y": ["-20 um", "20 um"]},
    "stride": {"stride": 2, "precision": "single", "bodies": "lower"},
}
SMOOTH = Kind("indentation", "elastic", "elastic", "open", "smooth")
YIELDING = Kind("indentation", "plastic", "elastic", "open", "smooth")


@pytest.mark.parametrize("name", ASKED)
def test_what_asks_for_fields_within(name: str, tmp_path: Path) -> None:
    case = SMOOTH.case(output=ASKED[name])
    assert "von_mises_stress" in case.run(tmp_path / "run").field_names("lower")
    assert "none within the bodies" not in case.check()


@pytest.mark.parametrize("name", NOT_ASKED)
def test_what_does_not(name: str, tmp_path: Path) -> None:
    case = SMOOTH.case(output=NOT_ASKED[name])
    run = case.run(tmp_path / "run")
    assert not WITHIN & set(run.field_names("lower"))
    told = "# Neither body can yield: fields on the surfaces are computed and stored, none within the bodies"
    assert (told in case.check()) == ("fields" not in NOT_ASKED[name])
    assert "of its surface" in case.check()
    assert not {"reduced_result"} & {warning.key for warning in (*case.warnings, *run.warnings)}
    yielding = YIELDING.case(output=NOT_ASKED[name])
    assert "none within the bodies" not in yielding.check()


@pytest.mark.parametrize(("fields", "is_told"), [(None, True), ("surface", False), ("all", False)])
def test_the_console_tells_it(fields: str | None, is_told: bool, tmp_path: Path) -> None:
    file = tmp_path / "case.toml"
    SMOOTH.case().to_toml(file)
    chosen = ["--set", f"output.fields={fields}"] if fields else []
    command = [sys.executable, "-m", "brinell", "run", str(file), *chosen, "-o", str(tmp_path / "run")]
    printed = subprocess.run(command, check=True, capture_output=True, text=True)
    told = "neither body can yield: fields on the surfaces are computed and stored, none within the bodies"
    assert (told in printed.stdout) == is_told
    assert "kept small" not in printed.stderr


def test_absent_fields_tell_how_to_get_them(tmp_path: Path) -> None:
    run = run_of(SMOOTH, tmp_path / "run", snapshots="all")
    how = r'output.fields = \["surface", "stress"\] of the case stores it'
    with pytest.raises(brinell.RunError, match=f"the lower body has no field 'stress'; {how}.*; stored are"):
        run.field("lower", "stress")
    with pytest.raises(brinell.RunError, match=f"no field 'stress_xx'; {how}"):
        run.field("upper", "stress_xx")
    with pytest.raises(brinell.RunError, match="no field 'strss'; stored are"):
        run.field("lower", "strss")
    state = run.snapshot(0)
    with pytest.raises(KeyError, match=how):
        state.lower["stress_zz"]
    with pytest.raises(KeyError, match=how):
        state.lower.stress["zz"]
    how = how.replace("stress", "von_mises_stress")
    with pytest.raises(KeyError, match=how):
        state.lower["von_mises_stress"]
    with pytest.raises(brinell.RunError, match=how):
        brinell.plot.section(run, state, field="von_mises_stress")
    with pytest.raises(brinell.RunError, match=how):
        brinell.plot.animate(run)
    with pytest.raises(brinell.RunError, match='"stress"'):
        brinell.plot.stress_over_depth(run, state)
    with pytest.raises(brinell.InputError, match=how):
        run.to_pyvista(fields=["von_mises_stress"])
    rigid = run_of(Kind("indentation", "elastic", "rigid", "open", "smooth"), tmp_path / "rigid", fields="all")
    with pytest.raises(brinell.RunError, match="the upper body has no field 'stress'; stored are"):
        rigid.field("upper", "stress")
    with pytest.raises(KeyError, match="it is rigid"):
        rigid.snapshot("final").upper.stress["zz"]


def test_stepping_gives_what_the_case_asks_for() -> None:
    for output, is_there in (({}, False), ({"fields": "all"}, True)):
        steps = SMOOTH.case(output=output).steps()
        next(steps)
        fields = steps.fields()
        assert ("stress" in fields["lower"]) == is_there
        assert fields["pressure"].max() > 0.0


def test_the_forecast_follows() -> None:
    part, whole = (SMOOTH.case(output=output) for output in ({}, {"fields": "all"}))
    assert part.result_size < 0.2 * whole.result_size
    assert part.forecast.memory < whole.forecast.memory
    assert part.forecast.seconds <= whole.forecast.seconds


def test_a_stopped_run_and_its_resume(tmp_path: Path) -> None:
    kind = Kind("sliding", "elastic", "elastic", "periodic", "friction")

    def stop(step: int, *_: object) -> None:
        if step == 4:
            raise KeyboardInterrupt

    case = kind.case(output={"snapshots": "every 3", "checkpoint_interval": 0})
    with pytest.raises(KeyboardInterrupt):
        case.run(tmp_path / "stopped", progress=stop)
    resumed = case.run(tmp_path / "stopped", resume=True)
    assert_same_but_within(resumed, run_of(kind, tmp_path / "whole", fields="all"))
