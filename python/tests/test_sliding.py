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
    with pytest.raises(RunError, match="is of scenario 'indentation'; only results of 'sliding' have strokes"):
        _ = other.strokes
    assert len(run.strokes) == 2


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        ({"pressure": None}, "one is needed"),
        ({"load": "1 N"}, "cannot stand together"),
        ({"distance": 0}, "distance"),
        ({"strokes": 0}, "strokes"),
        ({"pressure": None, "mean_gap": "1 mm"}, "first touch"),
        ({"grid": {"resolution": 5}}, "mean over a period"),
    ],
)
def test_what_has_no_solution_is_refused(arguments: dict[str, object], message: str) -> None:
    with pytest.raises(InputError, match=message):
        sliding(**arguments).run(in_memory=True)


def test_patches_add_up_to_the_contact(run: Run) -> None:
    assert run.patch_history.keys() == set(run.steps)
    for step, patches in run.patch_history.items():
        row = run.snapshot(step).row
        assert len(patches) == row["patches"]
        assert patches.area.sum() == pytest.approx(row["contact_area"], rel=1e-12)
        assert patches.area.max() == pytest.approx(row["largest_patch"], rel=1e-12)
        assert patches.load.sum() == pytest.approx(row["F_n"], rel=1e-12)
        assert patches.cells.sum() == (patches.label >= 0).sum()
    assert len(run.patches("final")) == 0
    stroke = run.strokes[0]
    rows = (run.history["pass"] == 1) & (np.diff(run.history["way"], prepend=0.0) > 0.0)
    assert stroke.patches == pytest.approx(run.history["patches"][rows].mean())
    assert stroke.largest_patch == pytest.approx(run.history["largest_patch"][rows].mean())


def test_surfaces_as_they_are(run: Run) -> None:
    final = run.snapshot("final")
    last = run.strokes[-1]
    k = 2 * np.pi / WAVELENGTH
    for body, name in ((final.lower, "lower"), (final.upper, "upper")):
        assert body.height is not None
        assert body.height_before is not None
        assert body.height_before == pytest.approx(3e-6 * np.cos(k * body.x) * np.cos(k * body.y)[:, None], abs=1e-15)
        assert body["height"] == pytest.approx(body.height_before - body.residual_displacement)
        found = brinell.HeightMap(body.height, (1.0, 1.0))
        assert found.Sq == pytest.approx(getattr(last, f"rms_height_{name}"), rel=1e-3)  # parted since then
        assert found.Sk == pytest.approx(getattr(last, f"core_height_{name}"), rel=1e-3)
        assert found.Spk == pytest.approx(getattr(last, f"peak_height_{name}"), rel=1e-2)
        assert found.Svk == pytest.approx(getattr(last, f"valley_depth_{name}"), rel=1e-2)
    assert run.field("lower", "height").sel(step=run.steps[0]).values.shape == (16, 16)


def test_peaks_meet_on_the_way() -> None:
    bump = brinell.Bump("0.5 um", edge_radius="37.5 um")  # tops overlap by 0.2 um: they meet 63 um before the middle
    flat = brinell.Body(brinell.Flat(), ELASTIC, bump)
    ball = brinell.Body(brinell.Sphere("10 mm"), ELASTIC)
    case = brinell.Sliding(flat, ball, "200 um", approach="-0.3 um", press_steps=1, grid={"resolution": 3})
    run = case.run(in_memory=True)
    load = run.history["F_n"]
    assert load[0] == load[1] == 0.0
    assert load.max() > 0.0
    middle = run.history["slid"][load.argmax()]
    assert middle == pytest.approx(100e-6, abs=6e-6)
    with pytest.raises(InputError, match="on their way the undeformed surfaces first touch"):
        brinell.Sliding(flat, ball, "200 um", approach="-0.6 um", grid={"resolution": 3}).run(in_memory=True)


def test_pressure_travels(run: Run) -> None:
    stored = sliding(output={"snapshots": "all"}, press_steps=1, strokes=1).run(in_memory=True)
    for follow in ("body", "contact"):
        animation = brinell.plot.animate(stored, field="pressure", follow=follow)
        image = animation._fig.axes[0].images[0]  # type: ignore[attr-defined]
        for step, frame in zip(stored.steps, animation.new_frame_seq(), strict=False):
            animation._draw_frame(frame)  # type: ignore[attr-defined]
            shown = np.array(image.get_array())
            contact = stored.snapshot(step).contact
            # On the lower surface it goes on with the upper one, round the period.
            cells = round(stored.history["slid"][step] / (WAVELENGTH / 16)) if follow == "body" else 0
            expected = np.roll(contact.pressure, cells, axis=1)
            assert shown / max(shown.max(), 1e-300) == pytest.approx(expected / max(expected.max(), 1e-300))
    plt.close("all")
    with pytest.raises(RunError, match="an animation needs two or more"):
        brinell.plot.animate(run, field="pressure", pass_=9)


def test_figures(run: Run, smooth: Run) -> None:
    drawings = TRAITS.drawings()
    axes = {"along-way": (4, 4), "strokes": (4, 4), "patches": (5, 2), "surfaces": (8, 0)}  # with the colour bars
    assert axes.keys() == drawings.figures.keys()
    for runs in ([run], [smooth], [run, smooth]):
        for name, drawing in drawings.figures.items():
            fig = drawing.draw(runs)
            count = axes[name][len(runs) - 1]
            assert (fig is None) == (count == 0)
            if fig is not None:
                assert len(fig.axes) == count
                plt.close(fig)
    fig = brinell.plot.along_way([run])
    line = fig.axes[0].lines[1]  # after that at zero
    moving = np.diff(run.history["way"], prepend=0.0) > 0.0
    assert line.get_ydata() == pytest.approx(run.history["friction"][moving])
    assert brinell.plot.stroke_by_stroke([sliding(strokes=1).run(in_memory=True)]) is None
