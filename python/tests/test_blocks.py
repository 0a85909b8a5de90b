# SPDX-License-Identifier: BSD-3-Clause
"""A state as datasets of pyvista, upright."""

from __future__ import annotations

import sys
from pathlib import Path

import numpy as np
import pytest

import brinell
from brinell.results import Run


@pytest.fixture(scope="module")
def run(real_folder: Path) -> Run:
    return brinell.open(real_folder)


def test_the_bodies_lie_where_they_are(run: Run) -> None:
    pytest.importorskip("pyvista")
    blocks = run.to_pyvista(fields=["von_mises_stress", "stress_xz", "residual_displacement", "pressure"])
    assert set(blocks.keys()) == {"lower_volume", "lower_surface", "upper_volume", "upper_surface", "contact"}
    lower, upper = blocks["lower_volume"], blocks["upper_volume"]
    assert lower.bounds[5] == pytest.approx(0.0)
    assert lower.bounds[4] < 0.0
    assert upper.bounds[4] == pytest.approx(0.0, abs=1e-18)
    assert upper.bounds[5] > 0.0
    assert blocks["contact"].point_data.keys() == ["pressure"]
    # Both touch in the contact, around x = 0.
    for body in (lower, upper):
        stress = body.cell_data["von_mises_stress"]
        centres = body.cell_centers().points
        peak = centres[np.argmax(stress)]
        assert abs(peak[0]) < 0.5 * run.critical.contact_radius * 3
        assert abs(peak[2]) < run.critical.contact_radius * 3


@pytest.mark.parametrize("body", ["lower", "upper"])
def test_each_cell_has_its_value(run: Run, body: str) -> None:
    pytest.importorskip("pyvista")
    snapshot = run.snapshot("aligned")
    fields = getattr(snapshot, body)
    block = run.to_pyvista(fields=["stress", "residual_displacement"])
    volume, surface = block[f"{body}_volume"], block[f"{body}_surface"]
    up = -1.0 if body == "lower" else 1.0
    for k, j, i in ((0, 0, 0), (2, 1, 5), (len(fields.z) - 1, len(fields.y) - 1, len(fields.x) - 1)):
        place = (fields.x[i] - fields.contact_x, fields.y[j], up * fields.z[k])
        cell = volume.find_containing_cell(place)
        for component in ("xx", "yz"):
            assert volume.cell_data[f"stress_{component}"][cell] == fields.stress[component][k, j, i]
        point = surface.find_closest_point((*place[:2], 0.0))
        assert surface.point_data["residual_displacement"][point] == fields.residual_displacement[j, i]
    warped = surface.warp_by_scalar("residual_displacement", factor=up * 1000.0)
    expected = up * 1000.0 * fields.residual_displacement.max()
    assert (warped.points[:, 2].min() if body == "lower" else warped.points[:, 2].max()) == pytest.approx(expected)


def test_the_final_state_has_the_axes_of_each_body_and_no_contact(run: Run) -> None:
    pytest.importorskip("pyvista")
    blocks = run.to_pyvista("final", fields=["equivalent_plastic_strain", "gap"])
    assert blocks.keys() == ["lower_volume", "upper_volume"]
    lower = run.snapshot("final").lower
    assert blocks["lower_volume"].bounds[0] == pytest.approx(lower.x[0] - 0.5 * (lower.x[1] - lower.x[0]))


def test_all_fields_by_default(run: Run) -> None:
    pytest.importorskip("pyvista")
    block = run.to_pyvista(run.steps[1])["lower_volume"]
    assert len(block.cell_data) == 14  # two of them no tensors


def test_a_field_that_is_none(run: Run) -> None:
    pytest.importorskip("pyvista")
    with pytest.raises(brinell.InputError, match="no field 'mises'; allowed: a list out of von_mises_stress"):
        run.to_pyvista(fields=["mises"])
    with pytest.raises(brinell.InputError, match="'stress_xx' is no list"):
        run.to_pyvista(fields="stress_xx")
    with pytest.raises(brinell.InputError, match="nothing is stored of pressure .*in which the bodies do not touch"):
        run.to_pyvista("final", fields=["pressure"])


def test_without_pyvista(run: Run, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "pyvista", None)
    with pytest.raises(ImportError, match=r'pip install "brinell\[pyvista\]"'):
        run.to_pyvista()
