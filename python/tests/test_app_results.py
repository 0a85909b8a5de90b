# SPDX-License-Identifier: BSD-3-Clause
"""What the page of `brinell app` is told of stored results."""

from pathlib import Path
from typing import Any

import numpy as np
import pytest

import brinell
from app_server import SMALL
from brinell.app import tasks

CASES = Path(__file__).parents[2] / "cases"


def outline(folder: Path, name: str) -> Any:
    """What the page shows of a result."""
    (told,) = tasks.outline(lambda: False, str(folder), name)
    return told


def test_numbers_over_their_values_at_first_yield_have_no_unit(tmp_path: Path) -> None:
    brinell.Case.from_file(CASES / "tugging-paper" / "case.toml").run(tmp_path / "tugging")
    brinell.Case(SMALL, overrides=["grid.resolution=6"]).run(tmp_path / "ball")
    assert "tugging.interference" in outline(tmp_path, "tugging")["pure"]
    assert "indentation.load" not in outline(tmp_path, "ball")["pure"]


def picture(folder: Path, name: str, kind: str, field: str, state: str = "aligned") -> Any:
    """A picture of a result as the page draws it."""
    (drawn,) = tasks.image(lambda: False, str(folder), name, state, {"kind": kind, "name": field})
    return drawn


@pytest.mark.filterwarnings("ignore::brinell.ResolutionWarning")
def test_fatigue_is_among_the_fields_and_the_numbers(tmp_path: Path) -> None:
    case = brinell.Case.from_file(CASES / "rolling-fatigue" / "case.toml", ["grid.resolution=3"])
    run = case.run(tmp_path / "fatigue")
    judged = run.fatigue("lower")
    assert judged.utilisation is not None
    drawn = picture(tmp_path, "fatigue", "section", "fatigue_utilisation")
    assert drawn["state"] == "last cycle"
    assert set(drawn["names"]["section"]) >= {f"fatigue_{name}" for name in ("utilisation", "shakedown")}
    field = judged.field("utilisation").values
    body = run.snapshot("aligned").lower
    plane = field[:, np.argmin(np.abs(body.y)), :]
    (part,) = drawn["parts"]
    across, depths = np.round((body.x - body.contact_x) / 1e-3, 6), np.round(body.z / 1e-3, 6)
    size = {"mm": 1e-3, "µm": 1e-6}[drawn["length"]]
    for i in (0, len(part["x"]) // 2):
        for j in (0, len(part["y"]) // 2):
            there = (
                np.argmin(np.abs(depths + part["y"][j] * size / 1e-3)),
                np.argmin(np.abs(across - part["x"][i] * size / 1e-3)),
            )
            value = part["values"][j][i]
            assert (value is None and np.isnan(plane[there])) or value == pytest.approx(plane[there], rel=1e-4)
    numbers = {one["name"]: one["value"] for one in outline(tmp_path, "fatigue")["numbers"]}
    assert numbers["Utilisation by fatigue, lower body"] == judged.utilisation.value
    assert numbers["Orthogonal shear by fatigue, lower body"] == judged.orthogonal_shear.value


@pytest.mark.filterwarnings("ignore::brinell.ResolutionWarning")
def test_a_current_is_among_the_fields_and_the_numbers(tmp_path: Path) -> None:
    metal = [*(f"{body}.material.electrical.resistivity=1e-7" for body in ("lower", "upper")), "interface.voltage=0.01"]
    run = brinell.Case(SMALL, overrides=metal).run(tmp_path / "current")
    drawn = picture(tmp_path, "current", "map", "current_density")
    density = run.snapshot("aligned").contact.current_density
    assert density is not None
    assert drawn["high"] * drawn["size"] == pytest.approx(np.nanmax(density))
    assert drawn["axes"] == ["x from the middle of the contact", "y"]
    numbers = {one["name"]: one["value"] for one in outline(tmp_path, "current")["numbers"]}
    resistance = run.history["contact_resistance"]
    assert numbers["Smallest contact resistance"] == np.min(resistance[resistance > 0])


def test_pictures_say_where_they_are(tmp_path: Path) -> None:
    brinell.Case.from_file(CASES / "tugging-paper" / "case.toml").run(tmp_path / "tugging")
    section = picture(tmp_path, "tugging", "section", "von_mises_stress")
    assert section["axes"][0] == "x from the middle of the contact"
    assert section["plane"].startswith("plane of cells at y = ")
    surface = picture(tmp_path, "tugging", "surface", "upper")
    assert surface["axes"][0] == "x on the upper body"
