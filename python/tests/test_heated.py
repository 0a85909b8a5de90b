# SPDX-License-Identifier: BSD-3-Clause
"""Heat of friction in Python: keys, columns, fields, figures, softening."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np
import pytest
from click.testing import CliRunner
from matplotlib.colors import Normalize

import brinell
from brinell import InputError
from brinell.plot import fields, style, surface_temperature_maps, surface_temperatures
from brinell.plot.cli import plot
from brinell.plot.energy import balance_error
from brinell.report.volumes import pictures_of
from brinell.results import Run, RunError, Snapshot
from figure_parts import curve, legend_of, texts

THERMAL = brinell.Thermal.carbon_steel()

MELTED = brinell.Material(
    "200 GPa",
    0.3,
    brinell.Linear("900 MPa", "20 GPa"),
    thermal=brinell.Thermal.carbon_steel(700.0),
    softening=brinell.JohnsonCook(melting_temperature=600.0, exponent=1.0),
)


def tugging(**arguments: object) -> brinell.Tugging:
    given: dict = {"speed": "1 m/s", "interface": {"friction": 0.1}, "grid": {"resolution": 4}, "normalised": False}
    plastic = brinell.Linear("900 MPa", "20 GPa")
    material = arguments.pop("material", brinell.Material("200 GPa", 0.3, plastic, thermal=THERMAL))
    ball = brinell.Body(brinell.Sphere("10 mm"), material)
    return brinell.Tugging(ball, ball, "10 um", **(given | arguments))


@pytest.fixture(scope="module")
def run(tmp_path_factory: pytest.TempPathFactory) -> Run:
    return tugging().run(tmp_path_factory.mktemp("heated"))


@pytest.mark.filterwarnings("ignore::brinell.ResolutionWarning")
def test_equal_bodies_take_half_of_the_heat_each(run: Run) -> None:
    history = run.history
    assert history["max_temperature_lower"].max() > 60.0  # from 20 degC
    assert history["heat_lower"] == pytest.approx(history["heat_upper"], rel=1e-6, abs=1e-12)
    heat = history["heat_lower"][-1] + history["heat_upper"][-1]
    assert heat == pytest.approx(history["dissipation_friction"][-1], rel=5e-3)
    assert abs(balance_error(history)[-1]) < 0.02


@pytest.mark.filterwarnings("ignore::brinell.ResolutionWarning")
def test_heat_between_unequally_warm_bodies_is_balanced_by_what_passes() -> None:
    """With next to no friction: what is lost of the heat counts relative to what passes, not to what friction gives."""
    elastic = {t: brinell.Material("200 GPa", 0.3, thermal=brinell.Thermal.carbon_steel(t)) for t in (20.0, 120.0)}
    cold, warm = (brinell.Body(brinell.Sphere("10 mm"), material) for material in elastic.values())
    run = brinell.Tugging(
        cold, warm, "10 um", speed="1 m/s", interface={"friction": 1e-9}, grid={"resolution": 4}, normalised=False
    ).run(in_memory=True)
    assert run.summary is not None
    heat = run.summary["heat"]
    assert heat["lower_J"] > 1e3 * run.history["dissipation_friction"][-1]
    assert abs(heat["balance_error"]) < 0.02


@pytest.mark.filterwarnings("ignore::brinell.ResolutionWarning")
def test_fields(run: Run) -> None:
    contact = run.snapshot("aligned").contact
    assert contact.temperature_lower is not None
    assert contact.heat_flux_lower is not None
    assert contact.temperature_lower.shape == contact.pressure.shape
    hot = np.unravel_index(np.argmax(contact.temperature_lower), contact.pressure.shape)
    assert contact.pressure[hot] > 0.0
    touching = contact.pressure > 0.05 * contact.pressure.max()
    both = contact.temperature_lower[touching], contact.temperature_upper[touching]
    np.testing.assert_allclose(*both, rtol=1e-3)


@pytest.mark.filterwarnings("ignore::brinell.ResolutionWarning")
def test_temperature_in_the_bodies(run: Run) -> None:
    lower = run.snapshot("aligned").lower
    assert lower.temperature is not None
    assert lower.temperature is lower["temperature"]
    layers = lower.temperature.max(axis=(1, 2))
    assert layers[0] > layers[1] > layers[-1] > 19.9
    assert np.asarray(run.field("lower", "temperature"))[-1].shape == lower.temperature.shape


@pytest.mark.filterwarnings("ignore::brinell.ResolutionWarning")
def test_temperatures_in_pyvista(run: Run) -> None:
    pytest.importorskip("pyvista")
    snapshot = run.snapshot("aligned")
    blocks = run.to_pyvista(fields=["temperature", "temperature_lower", "heat_flux_upper"])
    assert set(blocks.keys()) == {"lower_volume", "upper_volume", "contact"}
    for name, body in (("lower", snapshot.lower), ("upper", snapshot.upper)):
        assert blocks[f"{name}_volume"].cell_data["temperature"].max() == body.temperature.max()
    assert blocks["contact"].point_data["temperature_lower"].max() == snapshot.contact.temperature_lower.max()


@pytest.mark.filterwarnings("ignore::brinell.ResolutionWarning")
def test_temperatures_in_paraview(run: Run) -> None:
    """Its reader finds those that are stored, where they are."""
    pytest.importorskip("vtk")
    from vtk_images import VtkhdfFile

    step = run.steps[0]
    snapshot = run.snapshot(step)
    blocks = VtkhdfFile(run.file).blocks(float(step))
    for name, body in (("lower", snapshot.lower), ("upper", snapshot.upper)):
        np.testing.assert_array_equal(blocks[f"{name}_volume"].cell_data["temperature"], body.temperature)
    surface = blocks["lower_surface"].point_data
    for name in ("temperature_lower", "temperature_upper", "heat_flux_lower", "heat_flux_upper"):
        assert np.nanmax(surface[name]) == getattr(snapshot.contact, name).max()


@pytest.mark.filterwarnings("ignore::brinell.ResolutionWarning")
def test_a_steady_source_and_a_conductance() -> None:
    elastic = brinell.Material("200 GPa", 0.3, thermal=THERMAL)
    output = brinell.Output(fields=["surface", "temperature"])  # of elastic bodies only if it is asked for
    rises = []
    for conductance in (0.0, "1 kW/(mm^2 K)"):
        heating = brinell.Heating(regime="steady", displacement=False, partition=1.0, conductance=conductance)
        run = tugging(material=elastic, thermal=heating, output=output).run(in_memory=True)
        rises.append([run.history[f"max_temperature_{side}"].max() - 20.0 for side in ("lower", "upper")])
        below = run.snapshot("aligned").lower.temperature
        assert below is not None
        assert 20.0 < below.max() < rises[-1][0] + 20.0
    assert rises[0][1] == 0.0  # all of it goes into the lower body
    assert rises[1][0] == pytest.approx(rises[1][1], rel=0.05)  # nearly at one temperature
    assert rises[0][0] > 1.5 * rises[1][0]


@pytest.mark.filterwarnings("ignore::brinell.ResolutionWarning")
def test_figures(run: Run) -> None:
    fig = brinell.plot.surface_temperatures(run)
    assert fig is not None
    lines = fig.axes[0].lines[:2]  # and one at alignment
    assert [line.get_label() for line in lines] == ["lower", "upper"]
    assert lines[0].get_ydata() == pytest.approx(run.history["max_temperature_lower"])
    assert lines[0].get_xdata() == pytest.approx(run.history["X"] / run.equivalent_radius)
    assert fig.axes[1].get_xlabel() == brinell.plot.run_history(run).axes[-1].get_xlabel()
    names = [named.name for named in brinell.plot.standard_figures(run)]
    assert {"surface-temperatures", "surface-temperature-maps", "loaded-temperature"} <= set(names)
    plt.close("all")


@pytest.fixture(scope="module")
def cold() -> Run:
    return tugging(speed=None, material=brinell.Material("200 GPa", 0.3)).run(in_memory=True)


@pytest.mark.filterwarnings("ignore::brinell.ResolutionWarning")
def test_a_run_without_heat_has_no_figures_of_it(cold: Run) -> None:
    assert surface_temperatures(cold) is None
    snapshot = cold.snapshot("aligned")
    assert not fields.suits("temperature", snapshot)
    assert not fields.suits("surface-temperature-maps", snapshot)
    assert not [named.name for named in brinell.plot.standard_figures(cold) if "temperature" in named.name]
    with pytest.raises(RunError, match="temperature is not stored"):
        brinell.plot.section(cold, snapshot, field="temperature")
    with pytest.raises(RunError, match="no heat in the state"):
        surface_temperature_maps(cold, snapshot)


def cylinder_that_skids(**arguments: object) -> brinell.Rolling:
    """A rigid cylinder, which takes no heat, in plane strain."""
    elastic = brinell.Material("200 GPa", 0.3, thermal=THERMAL)
    given: dict = {"hertz_pressure": "1 GPa", "distance": "0.4 mm", "slide_to_roll": 1.0, "speed": "1 m/s"}
    given |= {"interface": {"friction": 0.1}, "grid": {"resolution": 4, "boundary": ["open", "periodic"]}}
    roller = brinell.Body(brinell.Cylinder("10 mm"), brinell.RIGID)
    return brinell.Rolling(brinell.Body(brinell.Flat(), elastic), roller, **(given | arguments))


@pytest.mark.filterwarnings("ignore::brinell.ResolutionWarning")
def test_surface_temperatures_of_rolling_are_drawn_over_the_distance() -> None:
    """Pass after pass, without the steps that press on and lift off, which have no distance."""
    run = cylinder_that_skids(passes=2).run(in_memory=True)
    fig = surface_temperatures(run)
    assert fig is not None
    first, second = (line for line in fig.axes[0].lines[:2])
    x = np.concatenate([np.asarray(line.get_xdata(), dtype=float) for line in (first, second)])
    assert x[0] == 0.0
    assert second.get_xdata()[0] == first.get_xdata()[-1]
    one = run.history.passes()[0]
    rolled = np.ptp(one["x"])
    assert x[-1] == pytest.approx(2.0 * rolled * 1e6, rel=1e-12)  # in µm
    steps = len(np.unique(one["x"]))
    assert len(first.get_xdata()) == len(second.get_xdata()) == steps < len(one["x"])
    assert fig.axes[0].get_xlabel() == "distance rolled  $s$  [µm]"
    assert legend_of(fig.axes[0]) == ["lower", "upper"]


@pytest.mark.filterwarnings("ignore::brinell.ResolutionWarning")
@pytest.mark.parametrize("cells", [False, True])
def test_heat_of_a_row_of_cells_is_drawn_as_lines(cells: bool) -> None:
    """In plane strain; of the body that takes heat."""
    run = cylinder_that_skids().run(in_memory=True)
    snapshot = run.snapshot("aligned")
    warm, taken = surface_temperature_maps(run, snapshot, cells=cells).axes
    assert legend_of(warm) == ["lower", "contact"]
    temperature, flux = curve(warm, "lower").get_ydata(), curve(taken, "lower").get_ydata()
    np.testing.assert_array_equal(temperature, snapshot.contact.temperature_lower[0])
    np.testing.assert_allclose(1e6 * np.asarray(flux), snapshot.contact.heat_flux_lower[0])
    assert taken.get_ylabel() == "$q$  [MW/m²]"


@pytest.mark.filterwarnings("ignore::brinell.ResolutionWarning")
def test_temperature_on_a_plane(run: Run, tmp_path: Path) -> None:
    """From the coldest place to the hottest of both bodies, in degrees, under load and after."""
    for state in ("aligned", "final"):
        snapshot = run.snapshot(state)
        bodies = (snapshot.lower, snapshot.upper)
        fig = brinell.plot.section(run, snapshot, field="temperature")
        middle = bodies[0].y.size // 2
        shown = [body.temperature[:, middle] for body in bodies]
        for image, values in zip(fig.axes[0].images, shown, strict=True):
            np.testing.assert_array_equal(image.get_array(), values)
            assert (image.norm.vmin, image.norm.vmax) == (np.min(shown), np.max(shown))
            assert image.get_cmap().name == style.TEMPERATURE_MAP
        assert "Temperature" in texts(fig)
        assert "$T$  [°C]" in texts(fig)
    done = CliRunner().invoke(plot, ["section", str(run.path), "--field", "temperature", "-o", str(tmp_path)])
    assert done.exit_code == 0, done.output
    assert [path.name for path in tmp_path.iterdir()] == ["aligned-section-y-0um-temperature.png"]


def test_a_body_that_is_warm_all_over_has_a_range_of_colours() -> None:
    _, norm = brinell.plot.QUANTITIES["temperature"].colours(20.0, 20.0)
    assert (norm.vmin, norm.vmax) == (20.0, 21.0)


@pytest.mark.filterwarnings("ignore::brinell.ResolutionWarning")
def test_an_elastic_body_shows_its_temperature_without_its_stress(run: Run) -> None:
    """Its other fields may be zero, or not stored."""
    final = run.snapshot("final")
    strain = np.zeros_like(final.upper.equivalent_plastic_strain)
    elastic = replace(final.upper, von_mises_stress=None, equivalent_plastic_strain=strain)
    state = replace(final, upper=elastic)
    for field, bodies in (("temperature", 2), ("equivalent_plastic_strain", 1)):
        assert len(brinell.plot.section(run, state, field=field).axes[0].images) == bodies


@pytest.mark.filterwarnings("ignore::brinell.ResolutionWarning")
@pytest.mark.parametrize("cells", [False, True])
def test_maps_of_the_surfaces(run: Run, cells: bool) -> None:
    snapshot = run.snapshot("aligned")
    contact = snapshot.contact
    fig = surface_temperature_maps(run, snapshot, cells=cells)
    maps = [ax for ax in fig.axes if ax.images]
    assert [ax.get_title(loc="left") for ax in maps] == [
        "(a)  temperature of the lower surface",
        "(b)  temperature of the upper surface",
        "(c)  heat flux into the lower body",
        "(d)  heat flux into the upper body",
    ]
    for ax, values in zip(maps, (contact.temperature_lower, contact.temperature_upper), strict=False):
        np.testing.assert_array_equal(ax.images[0].get_array(), values)
    assert {"$T$  [°C]", "$q$  [MW/m²]"} <= set(texts(fig))
    for left, right in (maps[:2], maps[2:]):  # equal colours mean equal values
        norms: list[Normalize] = [left.images[0].norm, right.images[0].norm]
        assert (norms[0].vmin, norms[0].vmax) == (norms[1].vmin, norms[1].vmax)
    flux = maps[2].images[0]
    assert flux.norm.vmin == -flux.norm.vmax  # hot material gives heat back to cold that comes
    assert contact.heat_flux_lower.min() < 0.0
    assert all(ax.collections for ax in maps[:2])  # the edge of contact
    if cells:
        np.testing.assert_array_equal(flux.get_array().mask, contact.pressure == 0.0)
        inside = contact.pressure > 0.0
        np.testing.assert_allclose(1e6 * flux.get_array()[inside], contact.heat_flux_lower[inside])
    else:
        assert all(ax.collections for ax in maps[2:])


@pytest.mark.filterwarnings("ignore::brinell.ResolutionWarning")
def test_maps_of_surfaces_that_have_parted_show_temperatures_only(run: Run) -> None:
    final = run.snapshot("final")
    assert not final.in_contact
    maps = [ax for ax in surface_temperature_maps(run, final).axes if ax.images]
    assert [ax.get_title(loc="left")[5:] for ax in maps] == [
        f"temperature of the {side} surface" for side in ("lower", "upper")
    ]
    assert not any(ax.collections for ax in maps)


@pytest.mark.filterwarnings("ignore::brinell.ResolutionWarning")
def test_a_body_without_thermal_constants_has_no_map() -> None:
    elastic = brinell.Material("200 GPa", 0.3, thermal=THERMAL)
    ball = brinell.Body(brinell.Sphere("10 mm"), brinell.RIGID)
    case = brinell.Rolling(
        brinell.Body(brinell.Flat(), elastic),
        ball,
        load="20 N",
        distance="0.3 mm",
        slide_to_roll=2.0,
        speed="1 m/s",
        interface={"friction": 0.1},
        grid={"resolution": 4},
    )
    run = case.run(in_memory=True)
    maps = [ax for ax in surface_temperature_maps(run, "aligned").axes if ax.images]
    assert [ax.get_title(loc="left") for ax in maps] == [
        "(a)  temperature of the lower surface",
        "(b)  heat flux into the lower body",
    ]
    assert maps[1].images[0].norm.vmin == 0.0  # no heat comes out


@pytest.mark.filterwarnings("ignore::brinell.ResolutionWarning")
def test_heat_of_one_state_on_the_command_line(run: Run, tmp_path: Path) -> None:
    done = CliRunner().invoke(plot, ["fields", str(run.path), "-o", str(tmp_path)])
    assert done.exit_code == 0, done.output
    written = {path.name for path in tmp_path.iterdir()}
    assert {"aligned-temperature.png", "aligned-surface-temperature-maps.png"} <= written


@pytest.mark.filterwarnings("ignore::brinell.ResolutionWarning")
def test_a_report_shows_the_temperature_in_the_bodies(run: Run, tmp_path: Path) -> None:
    loaded: Snapshot = run.snapshot("aligned")
    for volume in pictures_of(loaded, None).volumes:
        (found,) = [one for one in volume["fields"] if one["title"] == "Temperature"]
        body = loaded.lower if volume["body"] == "lower body" else loaded.upper
        assert found["unit"] == "°C"
        assert found["high"] == body.temperature.max()
        assert 19.0 < found["low"] < 25.0
    page = brinell.report.write_report(run, tmp_path / "report.html").read_text(encoding="utf-8")
    assert "Temperatures of both surfaces and heat flux into each body" in page
    assert "Temperature in the plane y = 0" in page


@pytest.mark.filterwarnings("ignore::brinell.ResolutionWarning")
def test_plastic_work_heats(run: Run) -> None:
    history = run.history
    work = history["dissipation_lower"] + history["dissipation_upper"]
    assert history["heat_of_plastic_work"] == pytest.approx(0.9 * work, rel=1e-9, abs=1e-15)
    off = tugging(thermal=brinell.Heating(heat_of_plastic_work=0.0)).run(in_memory=True)
    assert not off.history["heat_of_plastic_work"].any()
    assert off.history["max_temperature_lower"].max() < history["max_temperature_lower"].max()


@pytest.mark.filterwarnings("ignore::brinell.ResolutionWarning")
def test_a_source_heats_without_friction_and_its_heat_is_in_the_bodies() -> None:
    """A spot on the upper body passes heat to the lower one where they touch; nothing is lost."""
    source = brinell.HeatSource(shape="disc", on="upper", power="2 W", radius="1 mm")
    run = tugging(interface=None, thermal=brinell.Heating(source=source)).run(in_memory=True)
    history = run.history
    given = history["heat_of_source"]
    assert given[-1] > 0.0
    assert history["heat_lower"] + history["heat_upper"] == pytest.approx(given, rel=1e-8, abs=1e-15)
    assert run.summary["heat"]["of_source_J"] == pytest.approx(given[-1])
    figure = surface_temperatures(run)
    assert figure is not None
    assert "of the source" in legend_of(figure.axes[1])
    # The spot is wider than the contact and drawn where it is; the other body takes heat in the contact only.
    contact = run.snapshot("aligned").contact
    assert contact.heat_flux_upper[contact.pressure == 0.0].any()
    maps = [ax for ax in surface_temperature_maps(run, "aligned", cells=True).axes if ax.images]
    lower, upper = (ax.images[0].get_array() for ax in maps[2:])
    np.testing.assert_allclose(1e6 * np.asarray(upper), contact.heat_flux_upper, atol=1e-3)
    np.testing.assert_array_equal(lower.mask, contact.pressure == 0.0)


def test_hot_bodies_are_softer(run: Run) -> None:
    softening = brinell.JohnsonCook(melting_temperature="600 degC", exponent=1.0)
    plastic = brinell.Linear("900 MPa", "20 GPa")
    material = brinell.Material("200 GPa", 0.3, plastic, thermal=THERMAL, softening=softening)
    soft = tugging(material=material).run(in_memory=True)
    assert soft.history["dissipation_lower"][-1] > 1.05 * run.history["dissipation_lower"][-1]


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        ({"speed": None}, "tugging.speed is missing|speed"),
        ({"speed": 0}, "speed"),
        ({"thermal": brinell.Heating(partition=1.5)}, "partition"),
        ({"thermal": brinell.Heating(conductance=-1.0)}, "conductance"),
        ({"thermal": brinell.Heating(heat_of_plastic_work=1.1)}, "heat_of_plastic_work"),
        ({"thermal": brinell.Heating(regime="steady")}, "thermal.heat_of_plastic_work = 0"),
        ({"thermal": brinell.Heating(reference=-1.0)}, "reference"),
        ({"material": MELTED}, "lower.material.thermal.temperature = 700 degC.*melts at 600 degC"),
    ],
)
def test_what_cannot_be_is_refused(arguments: dict[str, object], message: str) -> None:
    with pytest.raises(InputError, match=message):
        tugging(**arguments).run(in_memory=True)


@pytest.mark.filterwarnings("ignore::brinell.ResolutionWarning")
def test_rough_flats_that_slide_grow_warm() -> None:
    material = brinell.Material("200 GPa", 0.3, brinell.Linear("900 MPa", "20 GPa"), thermal=THERMAL)
    case = brinell.Sliding(
        brinell.Body(brinell.Flat(), material, brinell.Sinusoid("0.2 um", "20 um", "20 um")),
        brinell.Body(brinell.Flat(), material, brinell.Sinusoid("0.1 um", "10 um", "20 um")),
        "5 um",
        pressure="200 MPa",
        press_steps=2,
        speed="1 m/s",
        interface={"friction": 0.1},
        thermal=brinell.Heating(partition=0.25),
        grid=brinell.Grid(boundary="periodic", size=("20 um", "20 um"), cells=(16, 16)),
    )
    history = case.run(in_memory=True).history
    heat = history["heat_lower"] + history["heat_upper"]
    assert history["max_temperature_lower"].max() > 21.0
    assert heat[-1] == pytest.approx(history["dissipation_friction"][-1], rel=1e-3)
    assert history["heat_lower"][-1] == pytest.approx(0.25 * heat[-1], rel=1e-9)
