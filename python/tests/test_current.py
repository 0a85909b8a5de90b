# SPDX-License-Identifier: BSD-3-Clause
"""Electric contact: resistance, current and temperature from Python, in files and figures."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

import brinell
from brinell.results import Run

COPPER = brinell.Material("120 GPa", 0.34, electrical=brinell.Electrical("1.7e-8 ohm m"))
STEEL = brinell.Material("210 GPa", 0.3, electrical=brinell.Electrical("2e-7 ohm m"))


def pressed(
    lower: brinell.Material = STEEL, upper: brinell.Material = COPPER, **arguments: object
) -> brinell.Indentation:
    flat, ball = brinell.Body(brinell.Flat(), lower), brinell.Body(brinell.Sphere("5 mm"), upper)
    return brinell.Indentation(flat, ball, **({"load": ["20 N", 0], "steps": 5} | arguments))


@pytest.fixture(scope="module")
def run() -> Run:
    return pressed(interface={"voltage": "50 mV"}, title="a current").run(in_memory=True)


def test_resistance_is_that_of_holm(run: Run) -> None:
    rows = run.history
    touching = rows["F_n"] > 0.0
    modulus = 1.0 / ((1 - 0.3**2) / 210e9 + (1 - 0.34**2) / 120e9)
    radius = np.cbrt(0.75 * rows["F_n"][touching] * 5e-3 / modulus)
    np.testing.assert_allclose(rows["contact_resistance"][touching], 2.17e-7 / (4 * radius), rtol=0.03)
    products = rows["contact_resistance"][touching] * rows["current"][touching]
    np.testing.assert_allclose(products, 0.05, rtol=1e-9)
    assert rows["contact_resistance"][~touching] == np.inf
    assert rows["current"][~touching] == 0.0
    kelvin = np.sqrt(293.15**2 + 0.05**2 / (4 * 2.44e-8))
    np.testing.assert_allclose(rows["contact_temperature"][touching], kelvin - 273.15, rtol=1e-9)
    assert run.summary["current"]["min_resistance_ohm"] == rows["contact_resistance"].min()
    assert "contact resistance" in run.summary["resolution"]["expected_errors"]


def test_density_sums_to_the_current(run: Run) -> None:
    state = run.snapshot("aligned")
    contact = state.contact
    assert contact.current_density is not None
    cell = (contact.x[1] - contact.x[0]) * (contact.y[1] - contact.y[0])
    row = run.history["current"][state.step]
    assert contact.current_density.sum() * cell == pytest.approx(row, rel=1e-9)
    assert np.all((contact.current_density > 0.0) == (contact.pressure > 0.0))
    at_edge, inside = (
        contact.current_density[contact.pressure > 0.0].max(),
        contact.current_density[contact.y.size // 2],
    )
    assert at_edge > 1.5 * inside[inside.size // 2]


def test_current_voltage_and_film() -> None:
    by_voltage = pressed(interface={"voltage": "50 mV"}, load="20 N").run(in_memory=True)
    current = by_voltage.summary["current"]["current_A"]
    by_current = pressed(interface={"current": current}, load="20 N").run(in_memory=True)
    assert by_current.summary["current"]["voltage_V"] == pytest.approx(0.05, rel=1e-9)
    film = pressed(interface={"voltage": "50 mV", "film_resistance": "1e-10 ohm m^2"}, load="20 N").run(in_memory=True)
    clean, filmed = by_voltage.summary["current"]["resistance_ohm"], film.summary["current"]["resistance_ohm"]
    area = film.history["contact_area"][-1]
    assert 1e-10 / area + 0.99 * clean < filmed < 1e-10 / area + 1.09 * clean


def test_a_table_over_the_steps() -> None:
    interface = {"current": ["0 A", "0 A", "8 A"], "current_steps": [0, 2, 8]}
    run = pressed(interface=interface, load=["20 N", "20 N"]).run(in_memory=True)
    expected = np.interp(run.history["step"], interface["current_steps"], [0.0, 0.0, 8.0])
    np.testing.assert_allclose(run.history["current"], expected, rtol=1e-12)
    assert "resistance-characteristic" in {named.name for named in brinell.plot.standard_figures(run)}
    figure = brinell.plot.resistance_characteristic(run)
    assert figure is not None
    assert figure.axes[0].get_xlabel().startswith("voltage")


def test_heat_goes_through_the_same_contact() -> None:
    """As the current does, with 1/conductivity in place of the resistivity."""
    thermal = brinell.Thermal.carbon_steel()
    steel = brinell.Material("210 GPa", 0.3, thermal=thermal)
    conductivity = 2.0 / thermal.conductivity
    only_heat = pressed(steel, steel, load="20 N").run(in_memory=True).history
    conducts = brinell.Material("210 GPa", 0.3, thermal=thermal, electrical=brinell.Electrical("2e-7 ohm m"))
    both = pressed(conducts, conducts, load="20 N").run(in_memory=True).history
    np.testing.assert_allclose(
        both["thermal_contact_conductance"] * both["contact_resistance"], 4e-7 / conductivity, rtol=1e-12
    )
    np.testing.assert_allclose(only_heat["thermal_contact_conductance"], both["thermal_contact_conductance"], rtol=1e-6)


def test_a_film_grows_by_fretting() -> None:
    flat, ball = brinell.Body(brinell.Flat(), STEEL), brinell.Body(brinell.Sphere("5 mm"), COPPER)
    interface = {"friction": 0.3, "voltage": "50 mV", "film_growth": "1e-6 ohm m"}
    fretting = brinell.Fretting(
        flat, ball, load="5 N", displacement="5 um", cycles=2, interface=interface, grid={"resolution": 4}
    )
    run = fretting.run(in_memory=True)
    cycle, resistance = run.history["cycle"], run.history["contact_resistance"]
    assert resistance[cycle == 2][-1] > resistance[cycle == 1][-1] > resistance[cycle == 0][-1]
    path = run.history["slip_path"][-1]
    assert 0.5e-6 * path < run.history["film_resistance"][-1] <= 1e-6 * path
    figure = brinell.plot.resistance_course(run)
    assert figure is not None
    assert figure.axes[0].get_xlabel() == "cycles"
    assert brinell.plot.contact_spots(run, run.snapshot("aligned")).axes


def test_without_a_resistivity_nothing_changes() -> None:
    insulating = brinell.Material("120 GPa", 0.34)
    with_, without = (pressed(upper=m).run(in_memory=True) for m in (COPPER, insulating))
    assert "current" not in without.summary
    assert not without.history["contact_resistance"].any()
    np.testing.assert_array_equal(with_.history["approach"], without.history["approach"])


@pytest.mark.parametrize(
    ("upper", "interface", "message"),
    [
        (brinell.Material("120 GPa", 0.34), {"current": 1}, "the upper body insulates"),
        (brinell.RIGID, {"voltage": "1 V"}, "the upper body insulates"),
        (COPPER, {"current": 1, "voltage": "1 V"}, "interface.voltage"),
        (COPPER, {"current": -1}, "interface.current"),
        (COPPER, {"film_resistance": "1 ohm"}, "area resistance"),
        (COPPER, {"current": [1, 2, 3], "current_steps": [0, 1]}, "2 steps, but interface.current .* has 3 values"),
        (COPPER, {"voltage": ["1 mV", "-1 mV"]}, "interface.voltage"),
        (COPPER, {"current_steps": [0, 1]}, "interface.current_steps .* there is no current"),
        (COPPER, {"voltage": [0, "1 mV"], "current_steps": [3, 3]}, "ascending"),
    ],
)
def test_errors_name_the_key(upper: brinell.Material, interface: dict, message: str) -> None:
    with pytest.raises(brinell.InputError, match=message):
        pressed(upper=upper, interface=interface).run(in_memory=True)


@pytest.mark.parametrize(
    ("resistivity", "message"), [(0, "resistivity = 0"), ("1 ohm", "resistivity"), ("-1 ohm m", "resist")]
)
def test_a_resistivity_must_be_one(resistivity: float | str, message: str) -> None:
    with pytest.raises(brinell.InputError, match=message):
        pressed(upper=brinell.Material("120 GPa", 0.34, electrical=brinell.Electrical(resistivity))).run(in_memory=True)


def test_electrical_must_be_constants() -> None:
    with pytest.raises(brinell.InputError, match="Electrical"):
        brinell.Material("120 GPa", 0.34, electrical=1.7e-8)


def test_a_thin_film_changes_little_of_a_hot_contact() -> None:
    copper = brinell.Material("120 GPa", 0.34, electrical=brinell.Electrical("1.7e-8 ohm m", "4e-3 1/K"))
    clean, thin = (
        pressed(upper=copper, interface={"voltage": 0.2, "film_resistance": film}, load="20 N").run(in_memory=True)
        for film in (0.0, 1e-16)
    )
    for column in ("contact_resistance", "contact_temperature", "current"):
        np.testing.assert_allclose(thin.history[column][-2], clean.history[column][-2], rtol=1e-3)


def test_a_map_of_the_thickness_of_a_film_is_that_of_the_field(tmp_path: Path) -> None:
    x = np.linspace(-1e-4, 1e-4, 41)
    thickness = brinell.HeightMap(1e-9 * (1.0 + 0.5 * np.sin(2e4 * x)) * np.ones((41, 1)), (5e-6, 5e-6))
    flat = brinell.Body(brinell.Flat(), STEEL, film=thickness)
    ball = brinell.Body(brinell.Sphere("5 mm"), COPPER)
    interface = brinell.Interface(voltage="50 mV", film_resistivity="1e-2 ohm m", film_resistance="1e-12 ohm m^2")
    run = brinell.Indentation(flat, ball, load="20 N", steps=5, interface=interface).run(tmp_path / "result")
    again = brinell.open(tmp_path / "result")
    for contact in (run.snapshot("aligned").contact, again.snapshot("aligned").contact):
        assert contact.film_resistance is not None
        middle = contact.film_resistance[contact.y.size // 2]
        expected = 1e-12 + 1e-2 * 1e-9 * (1.0 + 0.5 * np.sin(2e4 * contact.x))
        within = np.abs(contact.x) < 0.95e-4  # of the map
        assert np.count_nonzero(within) > 8
        np.testing.assert_allclose(middle[within], expected[within], rtol=4e-3)  # linear between points
    with pytest.raises(brinell.InputError, match=r"film .*brinell\.HeightMap"):
        brinell.Body(brinell.Flat(), STEEL, film=1e-9)
    with pytest.raises(brinell.InputError, match="film_resistivity"):
        brinell.Indentation(flat, ball, load="20 N", steps=5).run(in_memory=True)


def test_more_current_than_a_contact_bears_is_told() -> None:
    copper = brinell.Material("120 GPa", 0.34, electrical=brinell.Electrical("1.7e-8 ohm m", "4e-3 1/K"))
    with pytest.warns(brinell.ResolutionWarning, match="larger than any that the contact bears"):
        run = pressed(copper, copper, interface={"current": "10 kA"}, load="20 N").run(in_memory=True)
    assert np.isnan(run.history["contact_temperature"][-1])


def test_it_is_stored_drawn_and_read(run: Run, tmp_path: Path) -> None:
    figures = {named.name for named in brinell.plot.standard_figures(run)}
    assert "contact-resistance" in figures
    figure = brinell.plot.contact_resistance(run)
    assert figure is not None
    assert next(iter(figure.axes[0].get_lines())).get_label() == "computed"
    assert brinell.plot.current_density_map(run, run.snapshot("aligned")).axes
    stored = pressed(interface={"voltage": "50 mV"}).run(tmp_path / "result")
    again = brinell.open(tmp_path / "result").snapshot("aligned").contact.current_density
    np.testing.assert_array_equal(again, stored.snapshot("aligned").contact.current_density)
    with pytest.raises(brinell.RunError, match="no electric current"):
        brinell.plot.current_density_map(run, run.snapshot("final"))


def test_no_figure_without_a_resistivity() -> None:
    run = pressed(upper=brinell.Material("120 GPa", 0.34)).run(in_memory=True)
    assert brinell.plot.contact_resistance(run) is None
