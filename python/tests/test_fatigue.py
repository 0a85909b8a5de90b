# SPDX-License-Identifier: BSD-3-Clause
"""Fatigue of a rolling contact from Python: the numbers of the summary are those of the fields."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from click.testing import CliRunner

import brinell
from brinell.plot import fatigue_under_surface
from brinell.plot.cli import plot as command
from brinell.results import Run

pytestmark = pytest.mark.filterwarnings("ignore::brinell.ResolutionWarning", "ignore::brinell.CaseWarning")

CONSTANTS = brinell.FatigueConstants("crossland", torsion_limit="400 MPa", bending_limit="600 MPa")


def case(fatigue: brinell.FatigueConstants | None = CONSTANTS) -> brinell.Rolling:
    steel = brinell.Material("210 GPa", 0.3, fatigue=fatigue)
    return brinell.Rolling(
        brinell.Body(brinell.Flat(), steel),
        brinell.Body(brinell.Sphere("10 mm"), brinell.Material("210 GPa", 0.3)),
        distance="0.6 mm",
        hertz_pressure="1 GPa",
        load_steps=1,
        grid={"resolution": 4},
    )


@pytest.fixture(scope="module")
def run(tmp_path_factory: pytest.TempPathFactory) -> Run:
    return case().run(tmp_path_factory.mktemp("fatigue") / "run")


def test_worst_point_is_that_of_the_map(run: Run) -> None:
    fatigue = run.fatigue("lower")
    assert fatigue.criterion == "crossland"
    assert fatigue.shakedown == "elastic"
    assert fatigue.orthogonal_shear.value == pytest.approx(0.21389e9, rel=0.05)
    worst = fatigue.utilisation
    assert worst is not None
    field = fatigue.field("utilisation")
    there = field.sel(x=worst.x, y=worst.y, z=worst.depth, method="nearest").values
    assert float(there) == pytest.approx(worst.value, rel=1e-6)
    depths, profile = fatigue.depth_profile()
    assert profile.max() == pytest.approx(worst.value, rel=1e-6)
    assert depths[int(np.argmax(profile))] == pytest.approx(worst.depth)
    assert fatigue.map().shape == field.shape[1:]


def test_smooth_track_has_its_own_life(run: Run) -> None:
    assert run.fatigue().life == pytest.approx(1.0, abs=0.05)
    reference = brinell.FatigueConstants("none", reference=2.0 * run.fatigue().stress_volume)
    longer = case(reference).run().fatigue()
    assert longer.utilisation is None
    assert longer.life == pytest.approx(2.0**0.9, rel=1e-6)


def test_draws_map_and_profile(run: Run, tmp_path: Path) -> None:
    figure = fatigue_under_surface(run, run.fatigue())
    assert len(figure.axes) == 3  # with the colour bar
    result = CliRunner().invoke(command, ["fatigue", str(run.path), "-o", str(tmp_path)])
    assert result.exit_code == 0, result.output
    assert (tmp_path / "fatigue-lower.png").is_file()


def test_says_what_is_missing(run: Run) -> None:
    with pytest.raises(brinell.RunError, match=r"upper\.material\.fatigue\.criterion"):
        run.fatigue("upper")
    with pytest.raises(brinell.RunError, match="did you mean utilisation"):
        run.fatigue().field("utilization")
    with pytest.raises(brinell.InputError, match="FatigueConstants"):
        brinell.Material("210 GPa", 0.3, fatigue={"criterion": "none"})  # type: ignore[arg-type]
