# SPDX-License-Identifier: BSD-3-Clause
"""Tractions on the interfaces of coated bodies, and their figure."""

from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np
import pytest

import brinell
from brinell import reference
from brinell.plot import interface_tractions, standard_figures
from brinell.results import Run, RunError

STEEL = {"law": "linear", "yield_stress": "2 GPa", "modulus": "20 GPa"}

pytestmark = pytest.mark.filterwarnings("ignore::brinell.ResolutionWarning")


def indent(folder: Path, layers: list[dict[str, object]], load: str, resolution: int, **more: object) -> Run:
    material = {"young_modulus": "210 GPa", "poisson_ratio": 0.3, "hardening": STEEL, "layers": layers}
    case = {
        "scenario": "indentation",
        "lower": {"shape": {"type": "flat"}, "material": material},
        "upper": {"shape": {"type": "sphere", "radius": "50 um"}, "material": {"rigid": True}},
        "indentation": {"load": [load, 0], "steps": 2},
        "grid": {"resolution": resolution},
        "output": {"snapshots": "all", "fields": "all", **more},
    }
    return brinell.Case.from_values(case).run(folder)


def test_tractions_are_those_of_hertz_where_the_layer_is_of_the_substrate(tmp_path: Path) -> None:
    layer = {"thickness": "0.5 um", "young_modulus": "210 GPa", "poisson_ratio": 0.3, "hardening": STEEL}
    for resolution, within in ((8, 0.002), (16, 0.0005)):
        run = indent(tmp_path / f"run-{resolution}", [layer], "5 mN", resolution)
        assert run.interface_depths("lower") == [0.5e-6]
        assert run.interface_depths("upper") == []
        (interface,) = run.interfaces("lower", 1)
        hertz = reference.point_contact(50e-6, run.summary["geometry"]["contact_modulus_Pa"], load=0.005)
        x, y = np.meshgrid(interface.x, interface.y)
        exact = reference.point_contact_stress(x, y, 0.5e-6, hertz.contact_radius, hertz.peak_pressure, 0.3)
        for found, component in ((interface.normal, 2), (interface.shear_x, 4), (interface.shear_y, 3)):
            np.testing.assert_allclose(found, exact[component], atol=within * hertz.peak_pressure)
        assert interface.difference < within * hertz.peak_pressure
        np.testing.assert_array_equal(interface.shear, np.hypot(interface.shear_x, interface.shear_y))


def test_normal_tractions_bear_the_load(tmp_path: Path) -> None:
    stiff = {"thickness": "0.5 um", "young_modulus": "400 GPa", "poisson_ratio": 0.2}
    soft = {"thickness": "0.5 um", "young_modulus": "80 GPa", "poisson_ratio": 0.35, "hardening": STEEL}
    run = indent(tmp_path / "run", [stiff, soft], "200 mN", 8)
    loaded, unloaded = run.interfaces("lower", 1), run.interfaces("lower", "final")
    assert [round(one.depth, 12) for one in loaded] == [0.5e-6, 1e-6]
    cell = (loaded[0].x[1] - loaded[0].x[0]) * (loaded[0].y[1] - loaded[0].y[0])
    for one in loaded:
        assert -one.normal.sum() * cell == pytest.approx(0.2, rel=0.03)
        assert one.difference < 0.15 * np.abs(one.normal).max()
    for one in unloaded:
        assert one.normal.sum() * cell == pytest.approx(0.0, abs=0.002)
        assert one.normal.max() > 0.0  # what has yielded pulls at the coat
    figure = interface_tractions(run, 1)
    assert figure is not None
    curves = [line for line in figure.axes[1].get_lines() if len(line.get_xdata()) == len(loaded[0].x)]
    row = len(loaded[0].y) // 2
    np.testing.assert_allclose(1e9 * np.asarray(curves[0].get_ydata()), loaded[0].normal[row])
    np.testing.assert_allclose(
        1e9 * np.asarray(curves[1].get_ydata()),
        np.max([run.interfaces("lower", step)[0].normal[row] for step in run.steps], axis=0),
    )
    assert "loaded-interfaces-lower" in {named.name for named in standard_figures(run)}
    plt.close("all")


def test_bodies_without_interfaces_or_stress_have_no_tractions(tmp_path: Path) -> None:
    plain = indent(tmp_path / "plain", [], "20 mN", 4)
    assert plain.interfaces("lower") == []
    assert interface_tractions(plain, 1) is None
    layer = {"thickness": "0.5 um", "young_modulus": "400 GPa", "poisson_ratio": 0.2}
    shallow = indent(tmp_path / "shallow", [layer], "20 mN", 4, fields=["surface"])
    with pytest.raises(KeyError, match="nothing is stored of the stress"):
        shallow.interfaces("lower")
    with pytest.raises(RunError, match="no stress components of the lower body are stored at step 0.*output.fields"):
        interface_tractions(shallow, 0)
    assert "loaded-interfaces-lower" not in {named.name for named in standard_figures(shallow)}


def test_interfaces_between_the_faces_of_cells_are_found_or_left_out(tmp_path: Path) -> None:
    elastic = {"thickness": "0.5 um", "young_modulus": "210 GPa", "poisson_ratio": 0.3}
    thin = {**elastic, "thickness": "0.05 um"}

    def run(layers: list[dict[str, object]], thickness: str, name: str) -> Run:
        material = {"young_modulus": "210 GPa", "poisson_ratio": 0.3, "layers": layers}
        case = {
            "scenario": "indentation",
            "lower": {"shape": {"type": "flat"}, "material": material},
            "upper": {"shape": {"type": "sphere", "radius": "50 um"}, "material": {"rigid": True}},
            "indentation": {"load": ["5 mN"], "steps": 2},
            "grid": {"spacing": ["0.11 um", "0.11 um", thickness]},
            "output": {"snapshots": "all", "fields": "all"},
        }
        return brinell.Case.from_values(case).run(tmp_path / name)

    uneven = run([elastic], "0.065 um", "uneven")  # 7.7 layers of cells
    (interface,) = uneven.interfaces("lower", 1)
    hertz = reference.point_contact(50e-6, uneven.summary["geometry"]["contact_modulus_Pa"], load=0.005)
    x, y = np.meshgrid(interface.x, interface.y)
    exact = reference.point_contact_stress(x, y, 0.5e-6, hertz.contact_radius, hertz.peak_pressure, 0.3)
    np.testing.assert_allclose(interface.normal, exact[2], atol=0.005 * hertz.peak_pressure)
    np.testing.assert_allclose(interface.shear_x, exact[4], atol=0.005 * hertz.peak_pressure)
    both = run([thin, elastic], "0.065 um", "both")
    with pytest.warns(brinell.ResolutionWarning, match="5e-08 m is left out"):
        found = both.interfaces("lower", 1)
    assert [one.depth for one in found] == pytest.approx([0.55e-6])
