# SPDX-License-Identifier: BSD-3-Clause
"""One field over all stored states of a run, as a labelled array."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from dataclasses import replace
from functools import partial
from typing import Any, Literal, get_args

import h5py
import numpy as np
from numpy.typing import NDArray

from brinell._names import did_you_mean
from brinell.results.errors import RunError, listed, reports_damage
from brinell.results.labelled import Axis, Labelled
from brinell.results.result_file import ResultFile, Source
from brinell.results.snapshots import COMPONENTS, CONTACT_FIELDS, TENSORS, component_of, counts_of, how_to_store
from brinell.results.surface_fields import LOWERING

__all__ = ["CONTACT_FIELDS", "field_names", "labelled_field"]

FloatArray = NDArray[np.float64]

Body = Literal["lower", "upper"]
Grid = tuple[FloatArray, ...]
"""Cell centres along [z,] y and x."""

_UNKNOWN_OUTSIDE = ("gap", "temperature_lower", "temperature_upper")
"""Contact fields that are not zero outside the contact grid; they are NaN there, as in ParaView."""


def field_names(path: Source, body: Body) -> list[str]:
    """Names of the stored fields of a body, for the lower body with those of the contact.

    Raises:
        RunError: there is no such body, or no state is stored.
    """
    if body not in get_args(Body):
        raise RunError(f"{path}: no body {body!r}; allowed: {listed(get_args(Body))}")
    with ResultFile(path) as file:
        states = file.states()
        if not states:
            raise RunError(f"{path}: no stored step; [output] of the case chooses them")
        group = file.group(next(iter(states.values())))
        with reports_damage(path, str(group.name)):
            of_contact = [one for one in CONTACT_FIELDS if one in group["contact"]] if body == "lower" else []
            # The last state, of which most is stored, has the fields of all states.
            last = file.group(list(states.values())[-1])
            return [*last[body], *of_contact]


def labelled_field(path: Source, body: Body, name: str) -> Labelled:
    """One field of a body in all stored states, as described in `Run.field`."""
    names = field_names(path, body)
    if name not in names:
        found = component_of(name)
        if found is not None and found[0] in names:
            tensor = labelled_field(path, body, found[0])
            return replace(tensor.sel(component=found[1]), name=name, long_name=f"{tensor.long_name}, {found[1]}")
        how = "" if _is_rigid(path, body) else how_to_store(name)
        raise RunError(f"{path}: the {body} body has no field {name!r}{how}; {_alternatives(name, names)}")
    with ResultFile(path) as file:
        states = file.states()
        last = file.group(list(states.values())[-1])  # grids only grow, so the last one contains those of all states
        with reports_damage(path, str(last.name)):
            data = _first_dataset(last, body, name)
            coords = _coords(last, body, name, data.ndim)
            units, long_name = str(data.attrs["units"]), str(data.attrs["long_name"])
        of_contact = partial(_part_of_contact, goes_round=_goes_round(file.text("case") or ""))
    part = of_contact if name in CONTACT_FIELDS else _part_of_tensor if "component" in coords else _part
    grid = tuple(axis for key, axis in coords.items() if key != "component")

    def read(taken: tuple[Axis, ...]) -> FloatArray:
        groups = list(states.values())
        steps, inside = taken[0], taken[1:]
        with ResultFile(path) as opened:

            def at(step: int) -> FloatArray:
                with reports_damage(path, f"/{groups[step]}"):
                    return part(opened.group(groups[step]), body, name, inside, grid)

            if isinstance(steps, int):
                return at(steps)
            shape = tuple(len(axis) for axis in inside if not isinstance(axis, int))
            return np.array([at(step) for step in steps]).reshape(len(steps), *shape)

    all_coords: dict[str, NDArray[Any]] = {"step": np.array(list(states)), **coords}
    taken = tuple(range(len(axis)) for axis in all_coords.values())
    return Labelled(name, units, long_name.removesuffix(", xx"), all_coords, read, taken)


def _is_rigid(path: Source, body: Body) -> bool:
    with ResultFile(path) as file:
        last = file.group(list(file.states().values())[-1])
        with reports_damage(path, str(last.name)):
            return bool(last[body].attrs.get("is_rigid", 0))


def _alternatives(name: str, names: Sequence[str]) -> str:
    """Text with a suggestion for an unknown name and the names of the stored fields."""
    components = [f"{tensor}_{c}" for tensor in names if tensor in TENSORS for c in COMPONENTS]
    tensors = f"; components as {components[-len(COMPONENTS)]}" if components else ""
    return f"{did_you_mean(name, [*names, *components])}stored are {listed(names)}{tensors}"


def _first_dataset(state: h5py.Group, body: str, name: str) -> h5py.Dataset:
    if name in CONTACT_FIELDS:
        return state["contact"][name]
    entry = state[body][name]
    return entry[COMPONENTS[0]] if isinstance(entry, h5py.Group) else entry


def _coords(state: h5py.Group, body: str, name: str, dimensions: int) -> Mapping[str, NDArray[Any]]:
    """Coordinates along all axes except the steps; contact fields have those of the lower body's surface."""
    group = state[body]
    spacing, origin = group.attrs["spacing"], group.attrs["origin"]
    counts = counts_of(state, body)
    axes = {
        axis: origin[i] + spacing[i] * np.arange(counts[2 - i])
        for i, axis in reversed(list(enumerate("xyz"[:dimensions])))
    }
    components = {"component": np.array(COMPONENTS)} if isinstance(group.get(name), h5py.Group) else {}
    return components | axes


def _selected(data: Any, taken: tuple[Axis, ...]) -> FloatArray:
    """Part of a dataset; HDF5 reads only ascending slices, so others are selected from them after reading."""
    shape = tuple(len(axis) for axis in taken if not isinstance(axis, int))
    if 0 in shape:
        return np.empty(shape)
    ascending: list[int | slice] = []
    after: list[slice | NDArray[np.int64]] = []
    for axis in taken:
        if isinstance(axis, int):
            ascending.append(axis)
            continue
        first, last = min(axis[0], axis[-1]) if isinstance(axis, range) else min(axis), max(axis)
        if isinstance(axis, range):
            ascending.append(slice(first, last + 1, abs(axis.step)))
            after.append(slice(None, None, -1 if axis.step < 0 else 1))
        else:
            ascending.append(slice(first, last + 1))
            after.append(np.array(axis) - first)
    values = np.asarray(data[tuple(ascending)], dtype=np.float64)
    for i, one in enumerate(after):
        values = values[(slice(None),) * i + (one,)]
    return values


def _on_grid(state: h5py.Group, body: str, name: str, data: h5py.Dataset, grid: Grid) -> h5py.Dataset | FloatArray:
    """Extends a field to a larger grid: outside, plastic strain and wear are zero, and other fields are NaN."""
    if data.shape == tuple(len(axis) for axis in grid):
        return data
    spacing, origin = state[body].attrs["spacing"], state[body].attrs["origin"]
    first = [round((origin[i] - axis[0]) / spacing[i]) for i, axis in enumerate(reversed(grid))][::-1]
    is_none = "plastic_strain" in name or name in LOWERING
    whole = np.full([len(axis) for axis in grid], 0.0 if is_none else np.nan)
    part = tuple(slice(start, start + count) for start, count in zip(first, data.shape, strict=True))
    # A region beyond a grid that had not grown yet is the nearest cell of that one, and not of this one.
    if all(one.start >= 0 and one.stop <= count for one, count in zip(part, whole.shape, strict=True)):
        whole[part] = data[()]
    return whole


def _part(state: h5py.Group, body: str, name: str, taken: tuple[Axis, ...], grid: Grid) -> FloatArray:
    if name not in state[body]:
        return _unknown(taken)
    return _selected(_on_grid(state, body, name, state[body][name], grid), taken)


def _unknown(taken: tuple[Axis, ...]) -> FloatArray:
    """Values of a field that is not stored of a state."""
    return np.full([len(axis) for axis in taken if isinstance(axis, range)], np.nan)


def _part_of_tensor(state: h5py.Group, body: str, name: str, taken: tuple[Axis, ...], grid: Grid) -> FloatArray:
    component, inside = taken[0], taken[1:]
    tensor = state[body].get(name)
    if tensor is None:
        return _unknown(taken)
    if isinstance(component, int):
        return _selected(_on_grid(state, body, name, tensor[COMPONENTS[component]], grid), inside)
    return np.array([_selected(_on_grid(state, body, name, tensor[COMPONENTS[c]], grid), inside) for c in component])


def _goes_round(case: str) -> bool:
    """Whether the grid is a period along x, by the resolved case."""
    return re.search(r'^boundary = "periodic(_x)?"$', case, re.MULTILINE) is not None


def _part_of_contact(
    state: h5py.Group, body: str, name: str, taken: tuple[Axis, ...], grid: Grid, *, goes_round: bool
) -> FloatArray:
    """Part of a contact field on the lower body's surface grid; see `Run.field` for the values outside the contact."""
    surface, contact = state[body], state["contact"]
    if name not in contact:
        return _unknown(taken)
    values = np.asarray(contact[name][()], dtype=np.float64)
    origin = contact.attrs["origin"] + [surface.attrs["contact_x"], 0.0]
    column, row = np.rint((origin - [grid[-1][0], grid[-2][0]]) / contact.attrs["spacing"]).astype(int)
    ny, nx = len(grid[-2]), len(grid[-1])
    if goes_round:
        values, column = np.roll(values, column, axis=1), 0
    whole = np.full((ny, nx), np.nan if name in _UNKNOWN_OUTSIDE else 0.0)
    to_row, to_column = max(row, 0), max(column, 0)
    inside = values[to_row - row : max(ny - row, 0), to_column - column : max(nx - column, 0)]
    whole[to_row : to_row + inside.shape[0], to_column : to_column + inside.shape[1]] = inside
    return _selected(whole, taken)
