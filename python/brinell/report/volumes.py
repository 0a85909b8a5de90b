# SPDX-License-Identifier: BSD-3-Clause
"""Data of the interactive pictures of a report: surfaces and fields of the bodies, thinned to a suitable size.

Volumes are cut down to where there is something to see, then, if they are still too large, to every second or third
cell along their longest directions. Cells that are kept keep their values.
"""

from __future__ import annotations

import base64
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import matplotlib
import numpy as np
from matplotlib.colors import to_hex
from numpy.typing import NDArray

from brinell.plot import style
from brinell.plot.quantities import QUANTITIES, Quantity
from brinell.plot.scales import DEGREES, PERCENT, Scale, si
from brinell.plot.states import Side, sides
from brinell.plot.where import cutting_of
from brinell.results import Snapshot

__all__ = ["FIELD_BYTES", "Pictures", "pictures_of"]

FloatArray = NDArray[np.float64]

FIELD_BYTES = 2_000_000
"""Most that all fields together may take, as 32-bit floats, before they are written as text."""

_SURFACE_POINTS = 160  # along each direction, at most
_WORTH_SEEING = 0.02  # of the largest value of a field
_LOADED = ("von_mises_stress", "temperature")
_FINAL = ("equivalent_plastic_strain", "von_mises_stress", "stress_xx", "stress_yy", "stress_zz", "stress_xz")


@dataclass(frozen=True, eq=False)
class Pictures:
    """Data of the interactive pictures, to be written as JSON."""

    surfaces: list[dict[str, Any]]
    volumes: list[dict[str, Any]]
    note: str
    """How the fields were thinned, a sentence; empty if they were not."""

    def as_json(self) -> dict[str, Any]:
        """The data as JSON for the script of the page."""
        return {"surfaces": self.surfaces, "volumes": self.volumes}


@dataclass(frozen=True, eq=False)
class _Volume:
    """One body in one state: a part of its cells."""

    side: Side
    state: str
    in_contact: bool
    quantities: list[Quantity]
    kept: tuple[NDArray[np.intp], NDArray[np.intp], NDArray[np.intp]]
    """Cells along z, y, x."""
    stride: int
    """Largest, over the directions."""
    y: float
    """Of the plane along x that is shown first [m]."""


def pictures_of(loaded: Snapshot | None, final: Snapshot | None) -> Pictures:
    """Surfaces of the last state and fields of both.

    Args:
        loaded: under load, if any such state is stored.
        final: after the run, with tensors, if there is one; some runs leave the bodies pressed together.
    """
    last = final if final is not None else loaded
    surfaces = [_surface(side) for side in (sides(last) if last is not None else [])]
    chosen = [
        (side, snapshot, quantities)
        for snapshot, names in ((loaded, _LOADED), (final, _FINAL))
        if snapshot is not None
        for side in sides(snapshot)
        if (quantities := _present(side, names))
    ]
    count = sum(len(quantities) for *_, quantities in chosen)
    volumes = [_volume(side, snapshot, quantities, FIELD_BYTES // (4 * count)) for side, snapshot, quantities in chosen]
    return Pictures([one for one in surfaces if one], [_written(one) for one in volumes], _note(volumes))


def _present(side: Side, names: Sequence[str]) -> list[Quantity]:
    """Those of the fields that are stored and not zero; for temperature, not uniform."""
    values = {name: QUANTITIES[name].values(side.body) for name in names}
    return [
        QUANTITIES[name]
        for name, value in values.items()
        if value is not None and bool(np.any(_over_bulk(QUANTITIES[name], value)))
    ]


def _over_bulk(quantity: Quantity, values: FloatArray) -> FloatArray:
    """The values to be shown of a field: for temperature the rise above the coldest place."""
    return values - values.min() if quantity.kind == "temperature" else values


def _volume(side: Side, snapshot: Snapshot, quantities: list[Quantity], cells: int) -> _Volume:
    """The part of a body with values to show, thinned to a number of cells."""
    fields = [_over_bulk(one, value) for one in quantities if (value := one.values(side.body)) is not None]
    worth = np.any([np.abs(field) > _WORTH_SEEING * np.abs(field).max() for field in fields], axis=0)
    ranges = [_range(np.any(worth, axis=tuple({0, 1, 2} - {axis}))) for axis in range(3)]
    first = cutting_of(snapshot).plane.value
    middles = (
        0,
        int(np.argmin(np.abs(side.body.y - first))),
        int(np.argmin(np.abs(side.body.x - side.body.contact_x))),
    )
    strides = [1, 1, 1]

    def kept(axis: int) -> NDArray[np.intp]:
        inside = np.arange(ranges[axis][0], ranges[axis][1], dtype=np.intp)
        chosen: NDArray[np.intp] = inside[(inside - middles[axis]) % strides[axis] == 0]
        return chosen

    while np.prod([len(kept(axis)) for axis in range(3)]) > cells:
        strides[int(np.argmax([len(kept(axis)) for axis in range(3)]))] += 1
    cells_kept = (kept(0), kept(1), kept(2))
    return _Volume(side, _state_of(snapshot), snapshot.in_contact, quantities, cells_kept, max(strides), first)


def _state_of(snapshot: Snapshot) -> str:
    """Description of a state."""
    if not snapshot.in_contact:
        return "after unloading"
    return "at the end, under load" if snapshot.is_final else "under load"


def _range(worth: NDArray[np.bool_]) -> tuple[int, int]:
    """First and last + 1 of the layers with values to show, with one more on each side."""
    found = np.flatnonzero(worth)
    return max(0, int(found[0]) - 1), min(len(worth), int(found[-1]) + 2)


def _note(volumes: Sequence[_Volume]) -> str:
    strides = [one.stride for one in volumes]
    if not strides or max(strides) == 1:
        return ""
    most = max(strides)
    which = "every second cell" if most == 2 else f"every {most}th cell" if most > 3 else "every third cell"
    return f"To keep this page small, the pictures show down to {which} along the longest directions; results hold all."


def _encoded(values: NDArray[Any]) -> str:
    """32-bit floats, little endian, as text."""
    return base64.b64encode(np.ascontiguousarray(values, dtype="<f4").tobytes()).decode("ascii")


def _over(values: FloatArray, scale: Scale) -> list[float]:
    """Coordinates with the significant digits."""
    return [float(f"{value / scale.size:.5g}") for value in values]


def _written(volume: _Volume) -> dict[str, Any]:
    body = volume.side.body
    z, y, x = volume.kept
    length = si(max(float(np.abs(c).max()) for c in (body.x[x], body.y[y], body.z[z])), "m")
    values = [(one, one.values(body)) for one in volume.quantities]
    return {
        "body": volume.side.name,
        "state": volume.state,
        "unit": length.unit,
        "x": _over(body.x[x], length),
        "y": _over(body.y[y], length),
        "z": _over(body.z[z], length),
        "first_y": volume.y / length.size,
        "fields": [_field(one, v[np.ix_(z, y, x)], volume.in_contact) for one, v in values if v is not None],
    }


def _field(quantity: Quantity, values: FloatArray, in_contact: bool) -> dict[str, Any]:
    lowest, highest = float(values.min()), float(values.max())
    scales = {"stress": si(max(-lowest, highest), "Pa"), "strain": PERCENT, "temperature": DEGREES}
    scale = scales[quantity.kind]
    colour_map, norm = quantity.colours(lowest / scale.size, highest / scale.size)
    return {
        "title": quantity.title_in(in_contact=in_contact).replace("$", ""),
        "unit": scale.unit,
        "low": norm.vmin,
        "high": norm.vmax,
        "colours": _colours(colour_map),
        "values": _encoded(values / scale.size),
    }


def _colours(name: str, middle: float = 0.5) -> list[tuple[float, str]]:
    """A colour map in the form of the script, with its middle colour at a place in [0, 1]."""
    places = np.linspace(0.0, 1.0, 33)
    moved = np.interp(places, [0.0, 0.5, 1.0], [0.0, middle, 1.0])
    return [(float(at), to_hex(matplotlib.colormaps[name](place))) for at, place in zip(moved, places, strict=True)]


def _surface(side: Side) -> dict[str, Any] | None:
    """Heights of a residual surface; None if the surface is not deformed."""
    body = side.body
    if not body.is_dented:
        return None
    height = -body.residual_displacement
    rows, columns = (np.arange(0, n, -(-n // _SURFACE_POINTS)) for n in height.shape)
    shown, x, y = height[np.ix_(rows, columns)], body.x[columns], body.y[rows]
    up, along = si(float(np.abs(shown).max()), "m"), si(float(np.abs(x).max()), "m")
    lowest, highest = min(float(shown.min()), 0.0), max(float(shown.max()), 0.0)
    middle = min(max(-lowest / (highest - lowest), 1e-3), 1.0 - 1e-3)
    return {
        "body": side.name,
        "x": _over(x, along),
        "y": _over(y, along),
        "unit": along.unit,
        "heightUnit": up.unit,
        "heightOverLength": up.size / along.size,
        "heights": _encoded(shown / up.size),
        "colours": _colours(style.RESIDUAL_MAP, middle),
    }
