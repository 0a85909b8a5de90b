# SPDX-License-Identifier: BSD-3-Clause
"""Sliding in Python: the class, waves against their closed form, strokes, and figures."""

from __future__ import annotations

import matplotlib.pyplot as plt
import numpy as np
import pytest

import brinell
from brinell import InputError
from brinell.results import Run, RunError
from brinell.scenarios.sliding import TRAITS

WAVELENGTH = 1e-3
ELASTIC = brinell.Material("200 GPa", 0.3)
STEEL = brinell.Material("200 GPa", 0.3, brinell.Linear("600 MPa", "20 GPa"))


def waves(material: brinell.Material, amplitude: float, **more: object) -> brinell.Body:
    return brinell.Body(brinell.Flat(), material, brinell.Sinusoid(amplitude, wavelength_x=WAVELENGTH, **more))


def sliding(**arguments: object) -> brinell.Sliding:
    given = {"distance": WAVELENGTH, "pressure": "60 MPa", "press_steps": 3, "strokes": 2, "to_and_fro": True}
    grid = {"boundary": "periodic", "size": [WAVELENGTH, WAVELENGTH], "cells": [16, 16]}
    body = waves(STEEL, 3e-6, wavelength_y=WAVELENGTH)
    return brinell.Sliding(body, body, **(given | {"grid": grid} | arguments))


@pytest.fixture(scope="module")
def run() -> Run:
    return sliding(interface={"friction": 0.1}, title="with friction").run(in_memory=True)


@pytest.fixture(scope="module")
def smooth() -> Run:
    return sliding(title="without").run(in_memory=True)


def test_waves_pressed_flat_resist_as_their_energy_grows() -> None:
    """Westergaard (1939): E' k^2 A1 A2/4 sin ks per area, read with differences over two of 32 cells."""
    grid = {"boundary": "periodic", "size": [WAVELENGTH, WAVELENGTH], "cells": [32, 1]}
    lower, upper = waves(ELASTIC, 1e-6), waves(ELASTIC, 0.5e-6)
    run = brinell.Sliding(lower, upper, WAVELENGTH, pressure="800 MPa", press_steps=1, grid=grid).run(in_memory=True)
    moving = np.diff(run.history["way"], prepend=0.0) > 0.0
    k = 2.0 * np.pi / WAVELENGTH
    largest = 0.25 * 200e9 / 1.82 * k**2 * 0.5e-12 * WAVELENGTH**2
    assert run.history["contact_fraction"][moving] == pytest.approx(1.0)
    force = run.history["F_X"][moving]
    assert force == pytest.approx(-largest * np.sin(k * run.history["slid"][moving]), abs=0.01 * largest)


def test_strokes(run: Run) -> None:
    first, second = run.strokes
    assert (first.stroke, second.stroke) == (1, 2)
    assert second.friction_interfacial == pytest.approx(0.1)
    assert second.friction == pytest.approx(second.friction_ploughing + 0.1)
    assert first.dissipation_plastic > second.dissipation_plastic >= 0.0
    assert run.history["slid"][-1] == pytest.approx(0.0, abs=1e-12)
    assert run.history["way"][-1] == pytest.approx(2.0 * WAVELENGTH)
    assert second.rms_height_lower < 1.5e-6  # of the waves as they were


def test_only_a_sliding_has_strokes(run: Run) -> None:
    flat = brinell.Body(brinell.Flat(), STEEL)
    ball = brinell.Body(brinell.Sphere("1 mm"), ELASTIC)
    other = brinell.Indentation(flat, ball, load=["1 N"], steps=2, grid={"resolution": 4}).run(in_memory=True)
    with pytest.raises(RunError, match="is of scenario 'indentation'; strokes are of 'sliding'"):
        _ = other.strokes
    assert len(run.strokes) == 2


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        ({"pressure": None}, "one is needed"),
        ({"load": "1 N"}, "more than one"),
        ({"distance": 0}, "distance"),
        ({"strokes": 0}, "strokes"),
        ({"pressure": None, "mean_gap": "1 mm"}, "first touch"),
        ({"grid": {"resolution": 5}}, "mean over a period"),
    ],
)
def test_what_has_no_solution_is_refused(arguments: dict[str, object], message: str) -> None:
    with pytest.raises(InputError, match=message):
        sliding(**arguments).run(in_memory=True)


def test_figures(run: Run, smooth: Run) -> None:
    drawings = TRAITS.drawings()
    for runs in ([run], [smooth], [run, smooth]):
        for drawing in drawings.figures.values():
            fig = drawing.draw(runs)
            assert fig is not None
            assert len(fig.axes) == 4
            plt.close(fig)
    fig = brinell.plot.along_way([run])
    line = fig.axes[0].lines[1]  # after that at zero
    moving = np.diff(run.history["way"], prepend=0.0) > 0.0
    assert line.get_ydata() == pytest.approx(run.history["friction"][moving])
    assert brinell.plot.stroke_by_stroke([sliding(strokes=1).run(in_memory=True)]) is None
