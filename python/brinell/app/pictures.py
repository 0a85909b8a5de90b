# SPDX-License-Identifier: BSD-3-Clause
"""Pictures of a state as numbers, for the page to draw: a map of the contact, a section, a surface."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from typing import Any, cast

import matplotlib
import numpy as np
from matplotlib.colors import to_hex
from numpy.typing import NDArray

from brinell.errors import InputError
from brinell.plot import style
from brinell.plot.quantities import QUANTITIES, Quantity
from brinell.plot.scales import DEGREES, PERCENT, Scale, si
from brinell.results import COMPONENTS, Run, Snapshot

__all__ = ["State", "picture", "state_of_fields", "state_of_snapshot"]

FloatArray = NDArray[np.float64]

_FROM_CONTACT = "x from the middle of the contact"
_MOST_POINTS = 240  # along each direction
_WORTH_SEEING = 0.01  # of the largest height
_CONTACT = {
    "pressure": ("Contact pressure", "Pa", style.PRESSURE_MAP),
    "gap": ("Gap", "m", style.GAP_MAP),
    "shear_x": ("Shear on the lower body along x", "Pa", style.SIGNED_MAP),
    "shear_y": ("Shear on the lower body along y", "Pa", style.SIGNED_MAP),
    "slip_x": ("Slip along x", "m", style.SIGNED_MAP),
    "slip_y": ("Slip along y", "m", style.SIGNED_MAP),
    "slip_path": ("Way slipped", "m", style.STRAIN_MAP),
    "friction_heat": ("Heat of friction", "J/m²", style.TEMPERATURE_MAP),
    "temperature_lower": ("Temperature of the lower surface", "°C", style.TEMPERATURE_MAP),
    "temperature_upper": ("Temperature of the upper surface", "°C", style.TEMPERATURE_MAP),
    "heat_flux_lower": ("Heat flux into the lower body", "W/m²", style.TEMPERATURE_MAP),
    "heat_flux_upper": ("Heat flux into the upper body", "W/m²", style.TEMPERATURE_MAP),
    "current_density": ("Density of the current", "A/m²", style.PRESSURE_MAP),
    "film_resistance": ("Resistance of the film", "ohm m²", style.STRAIN_MAP),
}
_FATIGUE = {
    "utilisation": ("Fatigue: utilisation", ""),
    "orthogonal_shear": ("Fatigue: amplitude of the orthogonal shear", "Pa"),
    "principal_shear": ("Fatigue: principal shear", "Pa"),
    "mean_stress": ("Fatigue: mean stress", "Pa"),
    "hydrostatic_stress": ("Fatigue: hydrostatic stress", "Pa"),
    "plastic_strain": ("Fatigue: plastic strain of the cycle", "%"),
    "ratchetting": ("Fatigue: plastic strain that the cycle leaves", "%"),
    "shakedown": ("Fatigue: 0 elastic, 1 and 2 elastic and plastic shakedown, 3 ratchetting", ""),
}
"""Fields of the last cycle: title and unit."""
_PREFIX = "fatigue_"


@dataclass(frozen=True, eq=False)
class _Body:
    x: FloatArray
    y: FloatArray
    z: FloatArray
    contact_x: float
    height: FloatArray | None
    fields: Mapping[str, FloatArray]
    fatigue: Mapping[str, Callable[[], FloatArray]] = field(default_factory=dict)
    """Functions that read fields of the last cycle, by the names of `_FATIGUE`."""


@dataclass(frozen=True, eq=False)
class State:
    """Fields of the contact and of both bodies, from a result or from a run that is computed step by step."""

    title: str
    in_contact: bool
    x: FloatArray
    y: FloatArray
    contact: Mapping[str, FloatArray]
    bodies: Mapping[str, _Body]

    def names(self) -> dict[str, list[str]]:
        """Names of the fields that there are, of each kind of picture."""
        bodies = self.bodies.values()
        inside = [name for name in QUANTITIES if any(name in body.fields for body in bodies)]
        inside += [f"{_PREFIX}{name}" for name in _FATIGUE if any(name in body.fatigue for body in bodies)]
        return {
            "map": [name for name in _CONTACT if name in self.contact],
            "section": inside,
            "surface": [name for name, body in self.bodies.items() if body.height is not None],
        }

    def empty(self) -> dict[str, list[str]]:
        """Those of the names whose field is zero throughout, or has no value."""
        return {
            kind: [name for name in names if not any(np.any(np.nan_to_num(one)) for one in self._values(kind, name))]
            for kind, names in self.names().items()
        }

    def _values(self, kind: str, name: str) -> list[FloatArray]:
        if kind == "map":
            return [self.contact[name]]
        if name.startswith(_PREFIX):
            return [np.ones(1)]  # not read for this alone
        if kind == "section":
            return [body.fields[name] for body in self.bodies.values() if name in body.fields]
        height = self.bodies[name].height
        return [] if height is None else [height]


def state_of_snapshot(snapshot: Snapshot, run: Run | None = None) -> State:
    """The state of a stored step; with its run, fatigue of the last cycle, too."""
    bodies = {}
    for name in ("lower", "upper"):
        body = getattr(snapshot, name)
        if body.is_rigid:
            continue
        fields = {key: v for key, one in QUANTITIES.items() if (v := one.values(body)) is not None and _is_known(v)}
        height = -body.residual_displacement if body.has("residual_displacement") else None
        if height is not None and not _is_known(height):
            height = None
        fatigue = _fatigue(run, name) if run is not None else {}
        bodies[name] = _Body(body.x, body.y, body.z, body.contact_x, height, fields, fatigue)
    contact = {name: values for name in _CONTACT if (values := getattr(snapshot.contact, name)) is not None}
    title = "final state" if snapshot.is_final else f"step {snapshot.step}"
    return State(title, snapshot.in_contact, snapshot.contact.x, snapshot.contact.y, contact, bodies)


def _fatigue(run: Run, side: str) -> dict[str, Callable[[], FloatArray]]:
    """Functions that read the fields of fatigue of a body."""
    if not run.complete or side not in (run.summary or {}).get("fatigue", {}):
        return {}
    found = run.fatigue(cast(Any, side))
    stored = run.field_names(cast(Any, side))

    def reading(name: str) -> Callable[[], FloatArray]:
        return lambda: np.asarray(found.field(name).values)

    return {name: reading(name) for name in _FATIGUE if f"{_PREFIX}{name}" in stored}


def state_of_fields(fields: Mapping[str, Any], step: int) -> State:
    """The state of a run that is computed step by step (`Stepping.fields`)."""
    bodies = {}
    for name in ("lower", "upper"):
        body = fields.get(name, {})
        if "residual_displacement" not in body:
            continue
        found: dict[str, FloatArray] = {}
        if "equivalent_plastic_strain" in body:
            found["equivalent_plastic_strain"] = body["equivalent_plastic_strain"]
        if "stress" in body:
            found["von_mises_stress"] = _von_mises(body["stress"])
            found |= {f"stress_{c}": body["stress"][i] for i, c in enumerate(COMPONENTS)}
        if "temperature" in body:
            found["temperature"] = body["temperature"]
        height = -body["residual_displacement"]
        bodies[name] = _Body(body["x"], body["y"], body["z"], body["contact_x"], height, found)
    contact = {name: fields[name] for name in _CONTACT if name in fields}
    touching = bool(np.any(fields["pressure"] > 0))
    return State(f"step {step}", touching, fields["x"], fields["y"], contact, bodies)


def _is_known(values: FloatArray) -> bool:
    return bool(values.size) and not bool(np.isnan(values).all())


def _von_mises(s: FloatArray) -> FloatArray:
    """Von Mises stress of tensors xx, yy, zz, yz, xz, xy."""
    normal = (s[0] - s[1]) ** 2 + (s[1] - s[2]) ** 2 + (s[2] - s[0]) ** 2
    result: FloatArray = np.sqrt(0.5 * normal + 3.0 * (s[3] ** 2 + s[4] ** 2 + s[5] ** 2))
    return result


def picture(state: State, kind: str, name: str) -> dict[str, Any]:
    """A picture for the page.

    Args:
        state: what it shows.
        kind: "map", "section" or "surface".
        name: field of the contact or within the bodies; for a surface "lower" or "upper".

    Raises:
        InputError: there is no such picture.
    """
    allowed = state.names().get(kind, [])
    if name not in allowed:
        raise InputError(f"there is no {kind} of {name!r} in this state; allowed: {', '.join(allowed) or 'none'}")
    draw = {"map": _map, "section": _section, "surface": _surface}[kind]
    if name.startswith(_PREFIX):
        return {"kind": kind, "name": name, "state": "last cycle", **_section_of_fatigue(state, name)}
    return {"kind": kind, "name": name, "state": state.title, **draw(state, name)}


def _map(state: State, name: str) -> dict[str, Any]:
    title, unit, colours = _CONTACT[name]
    values = state.contact[name]
    reach = _around_contact(state)
    x, y, shown = state.x[reach[1]], state.y[reach[0]], values[np.ix_(reach[0], reach[1])]
    length = si(_largest(x, y), "m")
    known = shown[np.isfinite(shown)]
    lowest, highest = (float(known.min()), float(known.max())) if known.size else (0.0, 0.0)
    largest = max(-lowest, highest)
    size = DEGREES if unit == "°C" else si(largest, unit)
    low, high = (-largest, largest) if colours == style.SIGNED_MAP else (lowest if unit == "°C" else 0.0, highest)
    return {
        "title": title,
        "unit": size.unit,
        "size": size.size,
        "length": length.unit,
        "parts": [_part("", x / length.size, y / length.size, shown / size.size)],
        "axes": [_FROM_CONTACT, "y"],
        "low": low / size.size,
        "high": high / size.size if high > low else low / size.size + 1.0,
        "colours": _colours(colours),
    }


def _around_contact(state: State) -> tuple[NDArray[np.intp], NDArray[np.intp]]:
    """Rows and columns around the cells in contact; all if nothing touches."""
    touching: NDArray[np.bool_] = state.contact["pressure"] > 0
    return _thinned(*_about(touching, 0)), _thinned(*_about(touching, 1))


def _section(state: State, name: str) -> dict[str, Any]:
    quantity = QUANTITIES[name]
    cut = {side: _cut(body, body.fields[name]) for side, body in state.bodies.items() if name in body.fields}
    lowest, highest = _range(cut)
    scale = {"stress": si(max(-lowest, highest), "Pa"), "strain": PERCENT, "temperature": DEGREES}[quantity.kind]
    colours, norm = quantity.colours(lowest / scale.size, highest / scale.size)
    title = _plain(quantity.title_in(in_contact=state.in_contact))
    return _drawn_section(state, cut, scale, (norm.vmin, norm.vmax)) | {"title": title, "colours": _colours(colours)}


def _section_of_fatigue(state: State, name: str) -> dict[str, Any]:
    """A field of the last cycle; for the whole body, as the contact has passed along it."""
    plain = name.removeprefix(_PREFIX)
    cut = {side: _cut(body, body.fatigue[plain]()) for side, body in state.bodies.items() if plain in body.fatigue}
    lowest, highest = _range(cut)
    title, unit = _FATIGUE[plain]
    reach = max(-lowest, highest)
    scale = PERCENT if unit == "%" else si(reach, unit) if unit else Scale(1.0, "", "")
    is_signed = lowest < 0.0
    span = (-reach / scale.size if is_signed else 0.0, reach / scale.size or 1.0)
    colours = style.SIGNED_MAP if is_signed else style.STRESS_MAP
    return _drawn_section(state, cut, scale, span) | {"title": title, "colours": _colours(colours)}


def _cut(body: _Body, values: FloatArray) -> FloatArray:
    """Values of the plane of cells nearest to y = 0."""
    plane: FloatArray = values[:, int(np.argmin(np.abs(body.y))), :]
    return plane


def _range(cut: Mapping[str, FloatArray]) -> tuple[float, float]:
    known = np.concatenate([values[np.isfinite(values)] for values in cut.values()])
    return (float(known.min()), float(known.max())) if known.size else (0.0, 0.0)


def _drawn_section(
    state: State, cut: Mapping[str, FloatArray], scale: Scale, span: tuple[float | None, float | None]
) -> dict[str, Any]:
    """A section of the bodies, all but its title and colours."""
    bodies = {side: state.bodies[side] for side in cut}
    reach = _reach(state, bodies)
    length = si(reach, "m")
    parts = []
    for side, body in bodies.items():
        x = body.x - body.contact_x
        columns = _thinned(*_range_of(np.abs(x) <= reach))
        rows = _thinned(*_range_of(body.z <= reach))
        depth = (body.z[rows] if side == "upper" else -body.z[rows]) / length.size
        parts.append(
            _part(f"{side} body", x[columns] / length.size, depth, cut[side][np.ix_(rows, columns)] / scale.size)
        )
    middles = [float(body.y[int(np.argmin(np.abs(body.y)))]) for body in bodies.values()]
    return {
        "unit": scale.unit,
        "size": scale.size,
        "length": length.unit,
        "parts": parts,
        "axes": [_FROM_CONTACT, "z"],
        "plane": f"plane of cells at y = {style.quantity(middles[0], 'm') if abs(middles[0]) > 1e-15 else '0'}",
        "low": span[0],
        "high": span[1],
    }


def _reach(state: State, bodies: Mapping[str, _Body]) -> float:
    """How far from the centre of contact a section goes: four contact radii, or as far as the bodies are known."""
    touching = state.contact["pressure"] > 0
    radius = float(np.abs(state.x[touching.any(axis=0)]).max()) if touching.any() else 0.0
    widest = max(float(np.abs(body.x - body.contact_x).max()) for body in bodies.values())
    return min(4.0 * radius, widest) if radius > 0 else widest


def _surface(state: State, side: str) -> dict[str, Any]:
    body = state.bodies[side]
    assert body.height is not None
    seen: NDArray[np.bool_] = np.abs(body.height) > _WORTH_SEEING * np.abs(body.height).max()
    rows, columns = _thinned(*_about(seen, 0)), _thinned(*_about(seen, 1))
    x, y, height = body.x[columns], body.y[rows], body.height[np.ix_(rows, columns)]
    length, up = si(_largest(x, y), "m"), si(float(np.abs(height).max()) or 1e-6, "m")
    reach = float(np.abs(height).max() / up.size) or 1.0
    return {
        "title": f"Residual height of the {side} body",
        "unit": up.unit,
        "size": up.size,
        "length": length.unit,
        "parts": [_part(f"{side} body", x / length.size, y / length.size, height / up.size)],
        "axes": [f"x on the {side} body", "y"],
        "low": -reach,
        "high": reach,
        "colours": _colours(style.RESIDUAL_MAP),
    }


def _largest(*axes: FloatArray) -> float:
    return max(float(np.abs(axis).max()) for axis in axes)


def _range_of(wanted: NDArray[np.bool_]) -> tuple[int, int]:
    found = np.flatnonzero(wanted)
    return (int(found[0]), int(found[-1]) + 1) if found.size else (0, len(wanted))


def _about(wanted: NDArray[np.bool_], axis: int) -> tuple[int, int]:
    """First and last + 1 along an axis of the wanted cells, and a quarter as many more on each side."""
    first, last = _range_of(np.asarray(wanted.any(axis=1 - axis)))
    more = max(2, (last - first) // 4)
    return max(0, first - more), min(wanted.shape[axis], last + more)


def _thinned(first: int, last: int) -> NDArray[np.intp]:
    """Cells from `first` to before `last`, every second or third one if they are many."""
    return np.arange(first, last, -(-(last - first) // _MOST_POINTS) or 1, dtype=np.intp)


def _part(name: str, x: FloatArray, y: FloatArray, values: FloatArray) -> dict[str, Any]:
    return {"name": name, "x": _digits(x), "y": _digits(y), "values": [_digits(row) for row in values]}


def _digits(values: FloatArray) -> list[float | None]:
    return [float(f"{value:.5g}") if np.isfinite(value) else None for value in values]


def _plain(title: str) -> str:
    return title.replace("$", "")


def _colours(name: str) -> list[tuple[float, str]]:
    """A colour map as places and colours."""
    return [(float(at), to_hex(matplotlib.colormaps[name](at))) for at in np.linspace(0.0, 1.0, 17)]


def titles() -> dict[str, str]:
    """Titles of all fields by name."""
    inside: Mapping[str, Quantity] = QUANTITIES
    fatigue = {f"{_PREFIX}{key}": one[0] for key, one in _FATIGUE.items()}
    contact = {key: one[0] for key, one in _CONTACT.items()}
    return contact | {key: _plain(one.title) for key, one in inside.items()} | fatigue
