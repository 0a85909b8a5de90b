# SPDX-License-Identifier: BSD-3-Clause
"""The scenario tugging: case class, results, key numbers and figures."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import TYPE_CHECKING, Any

from brinell.bodies import Body, Quantity
from brinell.scenarios._case import ScenarioCase
from brinell.scenarios.traits import Drawing, Drawings, KeyNumber, Traits
from brinell.settings import Grid, Heating, Interface, Output, Solver
from brinell.summary import RunSummary

if TYPE_CHECKING:
    from brinell.plot.history import Panel
    from brinell.results import Run, Snapshot

__all__ = ["TRAITS", "Tugging", "TuggingResult"]


class Tugging(ScenarioCase):
    """Two asperities slide past each other with interference and deform each other."""

    _table = "tugging"

    def __init__(
        self,
        lower: Body,
        upper: Body,
        interference: Quantity | None = None,
        *,
        offset: Quantity | None = None,
        load: Quantity | None = None,
        normalised: bool = True,
        passes: int | None = None,
        shift: Quantity | None = None,
        kinematics: str | None = None,
        speed: Quantity | None = None,
        interface: Interface | Mapping[str, Any] | None = None,
        thermal: Heating | Mapping[str, Any] | None = None,
        title: str | None = None,
        grid: Grid | Mapping[str, Any] | None = None,
        solver: Solver | Mapping[str, Any] | None = None,
        output: Output | Mapping[str, Any] | None = None,
    ):
        """Makes a case; either an interference or a load is given.

        Args:
            lower: the body at rest; its shape is a `Sphere`, `Ellipsoid` or `Cylinder`.
            upper: the moving body, with one of the same shapes.
            interference: overlap in height of the undeformed bodies, without textures, when their centres are aligned
                along x; as a multiple of the critical interference alpha_c, or a length if not normalised. Without an
                offset it is the largest overlap.
            offset: distance along y of the upper centre from the lower one, which reduces the overlap by
                offset^2 / (2 (R1 + R2)); as a multiple of the contact radius a_c at first yield, or a length if not
                normalised. Not allowed with a load.
            load: constant normal force instead of an interference; as a multiple of the critical load P_c, or a force
                if not normalised.
            normalised: whether interference, offset and load are relative to their values at first yield.
            passes: number of passes of the upper body.
            shift: arc length by which the contact moves on each body per step [m].
            kinematics: "exact" or "paper".
            speed: speed of the upper surface relative to the lower one, such as "1 m/s"; required if friction heats the
                bodies.
            interface: friction, `brinell.Interface` or a dictionary.
            thermal: effects of frictional heat, `brinell.Heating` or a dictionary.
            title: title of the case, copied into the results.
            grid: grid settings, `brinell.Grid` or a dictionary.
            solver: solver settings, `brinell.Solver` or a dictionary.
            output: stored results, `brinell.Output` or a dictionary.

        Raises:
            InputError: the case is invalid; the message lists all problems found.
        """
        table = {
            "interference": interference,
            "offset": offset,
            "load": load,
            "normalised": normalised,
            "passes": passes,
            "shift": shift,
            "kinematics": kinematics,
            "speed": speed,
        }
        super().__init__(
            lower,
            upper,
            table,
            title=title,
            grid=grid,
            solver=solver,
            output=output,
            interface=interface,
            thermal=thermal,
        )


class TuggingResult(RunSummary):
    """Summary results that are specific to tugging."""

    @property
    def lower_radius(self) -> float:
        """Radius R1 of the lower body in a tugging [m]."""
        return self._number_of("tugging", "lower_radius", "geometry", "lower_radius_m")

    @property
    def upper_radius(self) -> float:
        """Radius R2 of the upper body in a tugging [m]."""
        return self._number_of("tugging", "upper_radius", "geometry", "upper_radius_m")

    @property
    def interference(self) -> float:
        """Overlap in height of the undeformed bodies of a tugging at alignment [m]."""
        return self._number_of("tugging", "interference", "geometry", "interference_m")

    @property
    def offset(self) -> float:
        """Distance along y of the upper centre from the lower one in a tugging [m]."""
        return self._number_of("tugging", "offset", "geometry", "offset_m")

    @property
    def closest_interference(self) -> float:
        """Largest interference along the line of centres in a tugging [m]; less than `interference` with an offset."""
        return self._number_of("tugging", "closest_interference", "geometry", "closest_interference_m")

    @property
    def normalised_interference(self) -> float:
        """alpha* = alpha / alpha_c of a tugging [-]."""
        self._require("tugging", "normalised_interference")
        return self.interference / self.critical.interference


def _key_numbers(run: Run) -> Iterator[KeyNumber]:
    history = run.history
    if run.complete and run.case("tugging", "load") is None:
        yield KeyNumber("Interference", run.interference, "m", "interference")
    yield KeyNumber("Largest resistance F_X", float(history["F_X"].max()), "N", "load")
    yield KeyNumber("Smallest F_X", float(history["F_X"].min()), "N", "load")
    yield KeyNumber("Largest normal force F_Z", float(history["F_Z"].max()), "N", "load")
    yield KeyNumber("Net work", float(history["work"][-1]), "J", "energy")


def _state_text(run: Run, snapshot: Snapshot) -> list[str]:
    from brinell.plot import style
    from brinell.plot.scales import Scales

    X = snapshot.row["X"]
    scales = Scales(run)
    position = scales.radius(abs(X) or 1.0)
    parts = [rf"$\alpha^*$ = {style.number(run.normalised_interference)}"] if scales.normalised else []
    if position.symbol:
        return [*parts, f"$X/{position.symbol}$ = {style.number(X / position.size)}"]
    return [*parts, f"$X$ = {style.length(X)}"]


def _panels() -> tuple[Panel, Panel]:
    from brinell.plot import history

    return history.tangential_force_and_slopes, history.force_across_and_slopes


def _drawings() -> Drawings:
    from brinell.plot import paper

    return Drawings(
        "paper",
        "Draw Figures 11 to 15 of Boucly, Nelias, Green (2006) and an overview from runs of different interferences.",
        {
            "fig11-tangential-force": Drawing(paper.fig11),
            "fig12-normal-force": Drawing(paper.fig12),
            "fig13-net-energy": Drawing(paper.fig13),
            "fig14-load-ratio": Drawing(paper.fig14),
            "fig15-residual-displacement": Drawing(paper.fig15),
            "overview": Drawing(paper.overview),
        },
    )


TRAITS = Traits(
    name="tugging",
    motion="X",
    abscissa="X",
    key_numbers=_key_numbers,
    panels=_panels,
    drawings=_drawings,
    state_text=_state_text,
)
