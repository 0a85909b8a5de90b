# SPDX-License-Identifier: BSD-3-Clause
"""Computation of the nodes of a map by a sweep of tugging runs."""

from __future__ import annotations

import contextlib
import tempfile
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from brinell.asperities.pairs import QUANTITIES, UnitRadius
from brinell.bodies import Body, Sphere
from brinell.errors import BrinellError, InputError
from brinell.materials import Material
from brinell.results import Run
from brinell.scenarios import Tugging
from brinell.settings import Interface
from brinell.sweeps import Sweep, sweep

__all__ = ["computed_nodes", "of_run"]

FloatArray = NDArray[np.float64]

_RADIUS = 1e-5
"""Equivalent radius of the runs [m]; the results are independent of it."""
_ORDER = 1.5
"""Lower bound of the order of convergence with the cell size: the lowest order in docs/verification/accuracy.md."""


def of_run(run: Run) -> dict[str, float]:
    """Results of a tugging run of one pass by the names of `QUANTITIES`, in SI units."""
    history = run.history
    X = history["X"]
    last = {name: float(history[name][-1]) for name in ("work", "energy_residual")}
    losses = ("dissipation_lower", "dissipation_upper", "dissipation_friction")
    final = run.snapshot("final")
    dents = {name: getattr(final, name) for name in ("lower", "upper")}
    return {
        "work": last["work"],
        "normal": _integral(history["F_Z"], X),
        "dissipation": float(sum(history[name][-1] for name in losses)),
        "locked_in": last["energy_residual"],
        "area": _integral(history["contact_area"], X),
        **{f"dent_{name}": _volume(body) for name, body in dents.items()},
        **{f"depth_{name}": float(max(0.0, history[f"max_residual_{name}"][-1])) for name in dents},
        "peak_F_X": float(history["F_X"].max()),
        "peak_F_Z": float(history["F_Z"].max()),
    }


def _integral(values: FloatArray, x: FloatArray) -> float:
    """Integral by the trapezoidal rule, which the engine also uses for the work in the history."""
    return float((0.5 * (values[1:] + values[:-1]) * np.diff(x)).sum())


def _volume(body: Any) -> float:
    """Volume of the dent below the original surface [m^3]."""
    if body.is_rigid:
        return 0.0
    cell = abs((body.x[1] - body.x[0]) * (body.y[1] - body.y[0]))
    return float(np.maximum(body.residual_displacement, 0.0).sum() * cell)


def computed_nodes(
    lower: Material,
    upper: Material,
    interferences: FloatArray,
    ratios: FloatArray,
    interface: Interface | Mapping[str, Any] | None,
    resolutions: tuple[float, float],
    output: str | Path | None,
    options: Mapping[str, Any],
) -> tuple[str, UnitRadius, FloatArray, FloatArray, dict[str, FloatArray], dict[str, FloatArray], tuple[float, float]]:
    """Computes the nodes; returns the fields of `AsperityMap` in their order.

    Raises:
        InputError: resolutions, interferences or materials are not suitable.
        BrinellError: a run has failed.
    """
    coarse, fine = (float(one) for one in resolutions)
    if not 0.0 < coarse < fine:
        raise InputError(f"resolutions = {resolutions}; allowed: two numbers > 0, the finer mesh second")
    if interferences[0] > 1.0:
        raise InputError(f"interferences begin at {interferences[0]:g}; allowed: at 1 or less, where nothing yields")
    for material in (lower, upper):
        _require_no_length(material)
    points = [(k, a, cells) for k in ratios for a in interferences for cells in (coarse, fine)]
    first = _case(lower, upper, interface, points[0])
    over = {
        "lower.shape.radius": [_radii(k)[0] for k, _, _ in points],
        "upper.shape.radius": [_radii(k)[1] for k, _, _ in points],
        "tugging.interference": [float(a) for _, a, _ in points],
        "grid.resolution": [cells for _, _, cells in points],
    }
    with _folder(output) as folder:
        result = sweep(first, over, output=folder, design="list", **options)
        _require_all(result, len(points))
        found = [of_run(result.runs[index]) for index in range(len(points))]
        pair = _unit_radius(result.runs[0])
    values = {name: np.array([one[name] for one in found]).reshape(len(ratios), -1, 2) for name in QUANTITIES}
    nodes, errors = {}, {}
    for name, of in QUANTITIES.items():
        unit = np.array([of.unit(pair, *_radii(k)) for k in ratios])[:, None]
        scaled = values[name] / (unit * interferences**of.power)[..., None]
        nodes[name] = scaled[..., 1]
        errors[name] = np.abs(scaled[..., 1] - scaled[..., 0]) / ((fine / coarse) ** _ORDER - 1.0)
    return first.to_toml(), pair, interferences, ratios, nodes, errors, (coarse, fine)


def _radii(ratio: float) -> tuple[float, float]:
    """Radii of a pair with the ratio R1/R2 and the equivalent radius of the runs [m]."""
    lower = _RADIUS * (1.0 + float(ratio))
    return lower, lower / float(ratio)


def _case(
    lower: Material, upper: Material, interface: Interface | Mapping[str, Any] | None, point: tuple[float, float, float]
) -> Tugging:
    ratio, interference, cells = point
    of_lower, of_upper = (Sphere(radius) for radius in _radii(ratio))
    return Tugging(
        Body(of_lower, lower),
        Body(of_upper, upper),
        float(interference),
        interface=interface,
        grid={"resolution": cells},
        output={"snapshots": "none"},
        title="Node of a map of asperities",
    )


def _require_no_length(material: Material) -> None:
    """Refuses materials with profiles over depth, whose results could not be scaled to asperities of other sizes."""
    for name in ("yield_profile", "initial_stress"):
        if getattr(material, name) is not None:
            raise InputError(f"{name} of a material is over a depth in m, and a map is for asperities of all sizes")


def _unit_radius(run: Run) -> UnitRadius:
    geometry = (run.summary or {})["geometry"]
    radius = float(geometry["equivalent_radius_m"])
    critical = run.critical
    return UnitRadius(
        critical.interference / radius,
        critical.load / radius**2,
        critical.contact_radius / radius,
        float(geometry["contact_modulus_Pa"]),
    )


def _require_all(result: Sweep, count: int) -> None:
    if len(result.runs) == count:
        return
    reasons = "; ".join(dict.fromkeys(map(str, result.failures["reason"])))
    raise BrinellError(f"{len(result.failures)} of {count} nodes could not be computed: {reasons}")


@contextlib.contextmanager
def _folder(output: str | Path | None) -> Iterator[Path]:
    if output is not None:
        yield Path(output)
        return
    with tempfile.TemporaryDirectory(prefix="brinell-asperities-") as folder:
        try:
            yield Path(folder)
        except KeyboardInterrupt:
            raise KeyboardInterrupt("interrupted; nothing is kept of a map without output") from None
