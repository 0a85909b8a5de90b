# SPDX-License-Identifier: BSD-3-Clause
"""Tugging: all that Python knows of it alone."""

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
    """Two asperities slide past each other and push each other aside."""

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
        """Describes a tugging.

        Args:
            lower: the body at rest; its shape is a `Sphere`, `Ellipsoid` or `Cylinder`.
            upper: the body that passes over it, of such a shape.
            interference: overlap of the undeformed bodies in height, without textures, when their centres are aligned
                along x; in critical interferences alpha_c, or a length if not normalised. The largest overlap unless
                there is an offset.
            offset: of the upper centre from the lower one along y: the bodies pass beside each other and overlap less,
                by offset^2 / (2 (R1 + R2)); in contact radii a_c at first yield, or a length if not normalised.
                Not with a load.
            load: instead, a normal force that is kept; in critical loads P_c, or a force if not normalised.
            normalised: whether these three are in their values at first yield.
            passes: how often the upper body passes.
            shift: arc by which the contact moves on each body per step.
            kinematics: "exact" or "paper".
            speed: of the upper surface over the lower one, such as "1 m/s"; needed where friction heats.
            interface: friction, `brinell.Interface` or a dictionary.
            thermal: what its heat does, `brinell.Heating` or a dictionary.
            title: copied into the results.
            grid: its cells, `brinell.Grid` or a dictionary.
            solver: `brinell.Solver` or a dictionary.
            output: what is stored, `brinell.Output` or a dictionary.

        Raises:
            InputError: with all problems found.
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
    """What only a tugging has in its summary."""

    @property
    def lower_radius(self) -> float:
        """R1 of a tugging [m]."""
        return self._number("geometry", "lower_radius_m")

    @property
    def upper_radius(self) -> float:
        """R2 of a tugging [m]."""
        return self._number("geometry", "upper_radius_m")

    @property
    def interference(self) -> float:
        """Overlap in height of the rigid bodies of a tugging at alignment [m]."""
        return self._number("geometry", "interference_m")

    @property
    def offset(self) -> float:
        """Of the upper centre from the lower one along y, in a tugging [m]."""
        return self._number("geometry", "offset_m")

    @property
    def closest_interference(self) -> float:
        """Largest interference of a tugging along the line of centres [m]; with an offset less than `interference`."""
        return self._number("geometry", "closest_interference_m")

    @property
    def normalised_interference(self) -> float:
        """alpha* = alpha / alpha_c of a tugging [-]."""
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
        "Figures 11 to 15 of Boucly, Nelias, Green (2006) and an overview, from one run per interference.",
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
