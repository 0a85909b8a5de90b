# SPDX-License-Identifier: BSD-3-Clause
"""The scenario tugging: results, key numbers and figures."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from brinell.scenarios.traits import Drawing, Drawings, KeyNumber, Traits
from brinell.summary import RunSummary

if TYPE_CHECKING:
    from brinell.plot.history import Panel
    from brinell.results import Run, Snapshot

__all__ = ["TRAITS", "TuggingResult"]


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
