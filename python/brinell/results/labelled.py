# SPDX-License-Identifier: BSD-3-Clause
"""Arrays with named axes and coordinates, which read only the requested part from the file."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from functools import cached_property
from types import MappingProxyType
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from brinell.errors import InputError, MissingExtraError
from brinell.results.errors import listed

if TYPE_CHECKING:
    import xarray

__all__ = ["Labelled"]

Axis = range | int
"""Selection along an axis: a range of indices, or one index, which removes the axis."""


@dataclass(frozen=True, eq=False)
class Labelled:
    """An array with named axes, made by `Run.field`. The values are read from the file when `values` is first used.

    Example:
        >>> stress = run.field("lower", "stress")                # step, component, z, y, x
        >>> stress.sel(step=12, component="xx", y=0.0, method="nearest").values  # [z][x]

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
        return tuple(dim for dim, axis in zip(self.all_coords, self.taken, strict=True) if isinstance(axis, range))

    @property
    def shape(self) -> tuple[int, ...]:
        """Length of each axis."""
        return tuple(len(axis) for axis in self.taken if isinstance(axis, range))

    @cached_property
    def coords(self) -> Mapping[str, NDArray[Any]]:
        """Coordinates along each axis; for a removed axis the coordinate of the cut."""
        return MappingProxyType(
            {
                dim: whole[np.asarray(axis)]
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

    def isel(self, **indices: int | slice) -> Labelled:
        """Selects a part by indices.

        Args:
            indices: by axis, an index, which removes the axis, or a slice.

        Raises:
            InputError: there is no such axis or index.
        """
        taken = dict(zip(self.all_coords, self.taken, strict=True))
        for dim, index in indices.items():
            axis = taken[self._checked(dim)]
            assert isinstance(axis, range)
            try:
                taken[dim] = axis[index]
            except IndexError as error:
                raise InputError(f"{self.name}: {dim} has {len(axis)} entries, there is no index {index}") from error
        return replace(self, taken=tuple(taken.values()))

    def sel(self, *, method: str | None = None, **labels: float | str | slice) -> Labelled:
        """Selects a part by coordinates.

        Args:
            method: "nearest": the entry closest to a coordinate; None: the entry that is equal to it.
            labels: by axis, a coordinate, which removes the axis, or a slice of coordinates, with both ends included.

        Raises:
            InputError: there is no such axis or coordinate.
        """
        if method not in (None, "nearest"):
            raise InputError(f"{self.name}: method = {method!r} is not known; allowed: None, 'nearest'")
        return self.isel(**{dim: self._index(self._checked(dim), label, method) for dim, label in labels.items()})

    def _checked(self, dim: str) -> str:
        if dim not in self.dims:
            raise InputError(f"{self.name}: has no axis {dim!r}; allowed: {listed(self.dims)}")
        return dim

    def _index(self, dim: str, label: float | str | slice, method: str | None) -> int | slice:
        coords = self.coords[dim]
        if isinstance(label, slice):
            first = 0 if label.start is None else int(np.searchsorted(coords, label.start, side="left"))
            last = len(coords) if label.stop is None else int(np.searchsorted(coords, label.stop, side="right"))
            return slice(first, last, label.step)
        if method == "nearest" and not isinstance(label, str) and len(coords) > 0:
            return int(np.argmin(np.abs(coords - label)))
        found = np.flatnonzero(coords == label)
        if len(found) == 0:
            known = listed(coords.tolist()) if len(coords) < 20 else f"{coords[0]} to {coords[-1]}, or method='nearest'"
            raise InputError(f"{self.name}: {dim} = {label!r} is not there; allowed: {known}")
        return int(found[0])

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
