# SPDX-License-Identifier: BSD-3-Clause
"""Arrays with named axes and coordinates, which read only the requested part from the file."""

from __future__ import annotations

import operator
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from types import MappingProxyType
from typing import TYPE_CHECKING, Any, TypeAlias

import numpy as np
from numpy.typing import NDArray

from brinell.errors import InputError, MissingExtraError
from brinell.results.errors import listed

if TYPE_CHECKING:
    import xarray

__all__ = ["Labelled"]

Axis: TypeAlias = range | tuple[int, ...] | int
"""Selection along an axis: a range of indices, single indices, or one index, which removes the axis."""

Indices: TypeAlias = int | slice | Sequence[int] | NDArray[Any]
"""Of `isel`: one, which removes the axis; a slice; several in any order; or a boolean for each entry of the axis."""


@dataclass(frozen=True, eq=False)
class Labelled:
    """An array with named axes, made by `Run.field`. The values are read from the file when `values` is first used.

    Example:
        >>> stress = run.field("lower", "stress")                # step, component, z, y, x
        >>> stress.sel(step=12, component="xx", y=0.0, method="nearest").values  # [z][x]
        >>> stress.isel(step=[0, -1]).sel(x=[-1e-5, 0.0, 1e-5], method="nearest").shape

    """

    name: str
    units: str
    """SI unit; "1" for a dimensionless field."""
    long_name: str
    all_coords: Mapping[str, NDArray[Any]]
    """Coordinates of the whole array by axis, in the order of the axes: step numbers, components, positions [m]."""
    read: Callable[[tuple[Axis, ...]], NDArray[np.float64]]
    """Function that reads a selection."""
    taken: tuple[Axis, ...]
    """Selection along each axis of the whole array."""
    owner: object = None
    """Object that must live as long as this array, such as a run whose temporary folder is deleted with it."""

    @property
    def dims(self) -> tuple[str, ...]:
        """Names of the axes, slowest first."""
        return tuple(dim for dim, axis in zip(self.all_coords, self.taken, strict=True) if not isinstance(axis, int))

    @property
    def shape(self) -> tuple[int, ...]:
        """Length of each axis."""
        return tuple(len(axis) for axis in self.taken if not isinstance(axis, int))

    @cached_property
    def coords(self) -> Mapping[str, NDArray[Any]]:
        """Coordinates along each axis; for a removed axis the coordinate of the cut."""
        return MappingProxyType(
            {
                dim: whole[np.asarray(axis, dtype=np.int64)]
                for (dim, whole), axis in zip(self.all_coords.items(), self.taken, strict=True)
            }
        )

    @cached_property
    def values(self) -> NDArray[np.float64]:
        """Values of the selection, read from the file on first use."""
        return self.read(self.taken)

    def __array__(self, dtype: Any = None, copy: bool | None = None) -> NDArray[Any]:
        return np.array(self.values, dtype=dtype, copy=True if copy is None else copy)

    def __repr__(self) -> str:
        axes = ", ".join(f"{dim}: {size}" for dim, size in zip(self.dims, self.shape, strict=True))
        return f"<{self.name} ({axes}) [{self.units}]>"

    def isel(self, indexers: Mapping[str, Indices] | None = None, **indices: Indices) -> Labelled:
        """Selects a part by indices, each axis by itself, as xarray does.

        Args:
            indexers: indices by axis; the same as the keywords.
            indices: by axis, an index, which removes the axis, a slice, a list of indices, or booleans.

        Raises:
            InputError: there is no such axis or index.
        """
        taken = dict(zip(self.all_coords, self.taken, strict=True))
        for dim, index in (dict(indexers or {}) | indices).items():
            axis = taken[self._checked(dim)]
            assert not isinstance(axis, int)
            taken[dim] = self._taken(dim, axis, index)
        return replace(self, taken=tuple(taken.values()))

    def sel(self, labels: Mapping[str, Any] | None = None, *, method: str | None = None, **by_axis: Any) -> Labelled:
        """Selects a part by coordinates, each axis by itself, as xarray does.

        Args:
            labels: coordinates by axis; the same as the keywords.
            method: "nearest": the entry closest to a coordinate; None: the entry that is equal to it.
            by_axis: by axis, a coordinate, which removes the axis, a slice of coordinates, with both ends included, or
                a list of coordinates.

        Raises:
            InputError: there is no such axis or coordinate.
        """
        if method not in (None, "nearest"):
            raise InputError(f"{self.name}: method = {method!r} is not known; allowed: None, 'nearest'")
        wanted = dict(labels or {}) | by_axis
        return self.isel({dim: self._index(self._checked(dim), label, method) for dim, label in wanted.items()})

    def _taken(self, dim: str, axis: range | tuple[int, ...], index: Indices) -> Axis:
        """The part of an axis that indices select."""
        if isinstance(index, slice):
            try:
                return axis[index]
            except TypeError:
                raise self._no_index(dim, index) from None
        if np.ndim(index) == 0:
            return self._one(dim, axis, index)
        array = np.asarray(index)
        if array.dtype == bool:
            if array.shape != (len(axis),):
                raise InputError(
                    f"{self.name}: {dim} has {len(axis)} entries, but {array.size} booleans are given for it"
                )
            array = np.flatnonzero(array)
        if array.ndim != 1:
            raise InputError(f"{self.name}: the indices of {dim} have {array.ndim} axes; allowed: a list with one axis")
        return tuple(self._one(dim, axis, one) for one in array.tolist())

    def _one(self, dim: str, axis: range | tuple[int, ...], index: Any) -> int:
        try:
            return axis[operator.index(index)]
        except TypeError:
            raise self._no_index(dim, index) from None
        except IndexError as error:
            raise InputError(f"{self.name}: {dim} has {len(axis)} entries, there is no index {index}") from error

    def _no_index(self, dim: str, index: object) -> InputError:
        return InputError(
            f"{self.name}: {dim} = {index!r} is no index; allowed: an integer, a slice or a list of integers, or "
            f"booleans; sel({dim}=...) selects by coordinates"
        )

    def _checked(self, dim: str) -> str:
        if dim not in self.dims:
            raise InputError(f"{self.name}: has no axis {dim!r}; allowed: {listed(self.dims)}")
        return dim

    def _index(self, dim: str, label: Any, method: str | None) -> Indices:
        if isinstance(label, slice):
            return self._between(dim, label)
        if np.ndim(label) == 0:
            return self._nearest(dim, label) if method == "nearest" else self._equal(dim, label)
        one = self._nearest if method == "nearest" else self._equal
        if np.ndim(label) != 1:
            raise InputError(
                f"{self.name}: the coordinates of {dim} have {np.ndim(label)} axes; allowed: a list with one"
            )
        return [one(dim, each) for each in (label.tolist() if isinstance(label, np.ndarray) else label)]

    def _between(self, dim: str, ends: slice) -> slice:
        coords = self.coords[dim]
        if coords.dtype.kind == "U":  # components, in an order of their own
            first = 0 if ends.start is None else self._equal(dim, ends.start)
            last = len(coords) if ends.stop is None else self._equal(dim, ends.stop) + 1
            return slice(first, last, ends.step)
        try:
            first = 0 if ends.start is None else int(np.searchsorted(coords, float(ends.start), side="left"))
            last = len(coords) if ends.stop is None else int(np.searchsorted(coords, float(ends.stop), side="right"))
        except (TypeError, ValueError):
            raise self._no_coordinate(dim, ends) from None
        return slice(first, last, ends.step)

    def _nearest(self, dim: str, label: Any) -> int:
        coords = self.coords[dim]
        if isinstance(label, str) or coords.dtype.kind == "U" or len(coords) == 0:
            return self._equal(dim, label)
        try:
            distance = np.abs(coords - float(label))
        except (TypeError, ValueError):
            raise self._no_coordinate(dim, label) from None
        if not np.isfinite(distance).all():
            raise self._no_coordinate(dim, label)
        return int(np.argmin(distance))

    def _equal(self, dim: str, label: Any) -> int:
        found = np.flatnonzero(np.asarray(self.coords[dim] == label))
        if len(found) == 0:
            raise self._no_coordinate(dim, label)
        return int(found[0])

    def _no_coordinate(self, dim: str, label: object) -> InputError:
        coords = self.coords[dim]
        near = "" if coords.dtype.kind == "U" else ", or method='nearest'"
        known = listed(coords.tolist()) if len(coords) < 20 else f"{coords[0]} to {coords[-1]}{near}"
        return InputError(f"{self.name}: {dim} = {label!r} is not there; allowed: {known}")

    def to_xarray(self) -> xarray.DataArray:
        """The selection as an xarray array, with units.

        Raises:
            MissingExtraError: xarray is not installed.
        """
        try:
            import xarray
        except ImportError as error:
            raise MissingExtraError("to_xarray", "xarray", "xarray") from error
        array = xarray.DataArray(
            self.values,
            coords={dim: ((dim,) if dim in self.dims else (), coord) for dim, coord in self.coords.items()},
            dims=self.dims,
            name=self.name,
            attrs={"units": self.units, "long_name": self.long_name},
        )
        for dim in {"x", "y", "z"} & set(self.coords):
            array.coords[dim].attrs["units"] = "m"
        return array
