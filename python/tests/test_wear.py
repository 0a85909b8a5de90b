# SPDX-License-Identifier: BSD-3-Clause
"""Wear in Python: keys, columns, fields, figures."""

from __future__ import annotations

import matplotlib.pyplot as plt
import numpy as np
import pytest

import brinell
from brinell import InputError
from brinell.plot.energy import balance_error
from brinell.results import Run

pytestmark = pytest.mark.filterwarnings("ignore::brinell.ResolutionWarning")

COEFFICIENT = 2e-12  # [1/Pa]


def sliding(**arguments: object) -> brinell.Sliding:
    given: dict = {
        "load": "10 N",
        "distance": "50 um",
        "interface": brinell.Interface(friction=0.2, wear=brinell.Wear(upper="2e-3 mm^3/(N m)")),
        "grid": {"resolution": 4},
    }
    flat = brinell.Body(brinell.Flat(), brinell.Material("200 GPa", 0.3))
    tool = brinell.Body(brinell.Sphere("10 mm"), brinell.RIGID)
    return brinell.Sliding(flat, tool, **(given | arguments))


@pytest.fixture(scope="module")
def run() -> Run:
    return sliding().run(in_memory=True)


def test_a_rigid_tool_loses_coefficient_times_load_times_way(run: Run) -> None:
    history = run.history
    volume = COEFFICIENT * 10.0 * history["way"][-1]
    assert history["worn_volume_upper"][-1] == pytest.approx(volume, rel=1e-9)
    assert not np.any(history["worn_volume_lower"])
    body = run.snapshot("final").upper
    assert body.is_rigid
    assert body.worn_depth is not None
    assert body["worn_depth"].max() == history["max_worn_depth_upper"][-1]
    cell = (body.x[1] - body.x[0]) * (body.y[1] - body.y[0])
    assert body.worn_depth.sum() * cell == pytest.approx(volume, rel=1e-9)
    assert run.summary["wear"]["volume_upper_m3"] == history["worn_volume_upper"][-1]
    assert abs(balance_error(history)[-1]) < 0.02


def test_fields(run: Run) -> None:
    worn = run.field("upper", "worn_depth")
    assert float(np.asarray(worn)[-1].max()) == run.history["max_worn_depth_upper"][-1]


def test_figures(run: Run) -> None:
    profiles, course = brinell.plot.worn_profiles(run), brinell.plot.worn_course(run)
    assert profiles is not None
    assert course is not None
    assert [line.get_label() for line in profiles.axes[0].lines] == ["upper"]
    names = [named.name for named in brinell.plot.standard_figures(run)]
    assert {"worn-profiles", "worn-course"} <= set(names)
    plt.close("all")
    whole = sliding(interface={"friction": 0.2}).run(in_memory=True)
    assert brinell.plot.worn_profiles(whole) is None
    assert brinell.plot.worn_course(whole) is None
    assert whole.snapshot("final").lower.worn_depth is None


def test_of_asperities_that_pass_each_other_twice() -> None:
    steel = brinell.Material("210 GPa", 0.3, brinell.Linear("900 MPa", "4 GPa"))
    ball = brinell.Body(brinell.Sphere("100 um"), steel)
    wear = brinell.Wear(lower=1e-12, upper=2e-12)
    interface = brinell.Interface(friction=0.2, wear=wear)
    run = brinell.Tugging(ball, ball, interference=3, passes=2, interface=interface, grid={"resolution": 4}).run(
        in_memory=True
    )
    history = run.history
    assert history["worn_volume_upper"][-1] == pytest.approx(2.0 * history["worn_volume_lower"][-1], rel=1e-9)
    assert run.summary["wear"]["volume_lower_m3"] == history["worn_volume_lower"][-1]
    first, second = (history["F_n"][history["pass"] == number].max() for number in (1, 2))
    assert second < first
    course = brinell.plot.worn_course(run)
    assert course is not None
    way = course.axes[0].lines[0].get_xdata()
    assert np.all(np.diff(way) >= 0.0)
    assert course.axes[0].get_xlabel().startswith("way slid")
    assert {"worn-profiles", "worn-course"} <= {named.name for named in brinell.plot.standard_figures(run)}
    plt.close("all")


def test_bad_input_is_told() -> None:
    with pytest.raises(InputError, match=r"interface\.wear\.upper"):
        sliding(interface={"wear": {"upper": -1.0}})
    with pytest.raises(InputError, match=r"interface\.friction = 0"):
        sliding(interface={"wear": {"upper": 1e-15, "law": "energy"}})
