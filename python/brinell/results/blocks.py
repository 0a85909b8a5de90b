# SPDX-License-Identifier: BSD-3-Clause
"""One state of a run as pyvista datasets in one frame: the lower body below z = 0, the upper one above it."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from brinell.errors import InputError, MissingExtraError
from brinell.results.errors import listed
from brinell.results.snapshots import (
    COMPONENTS,
    CONTACT_FIELDS,
    ON_BODY,
    TENSORS,
    BodyFields,
    ContactFields,
    Snapshot,
    how_to_store,
)

if TYPE_CHECKING:
    import pyvista

__all__ = ["blocks_of"]

FloatArray = NDArray[np.float64]


def blocks_of(snapshot: Snapshot, fields: Sequence[str] | None) -> pyvista.MultiBlock:
    """See `Run.to_pyvista`.

    Raises:
        MissingExtraError: pyvista is not installed.
        InputError: there is no such field, or none of the requested fields is stored.
    """
    try:
        import pyvista
    except ImportError as error:
        raise MissingExtraError("to_pyvista", "pyvista", "pyvista") from error
    _require_known(fields)
    blocks = pyvista.MultiBlock()
    for name, body, below in (("lower", snapshot.lower, True), ("upper", snapshot.upper, False)):
        if body.is_rigid and not any(_of_surface(body, name).size for name in (*ON_BODY, "height")):
            continue
        left = body.x[0] - (body.contact_x if snapshot.in_contact else 0.0)
        volume = {} if body.is_rigid else dict(_volume_fields(body, fields))
        if volume:
            blocks[f"{name}_volume"] = _volume(pyvista, body, left, volume, below=below)
        sheet = {
            name: values for name in _SURFACE if _wanted(name, fields) and (values := _of_surface(body, name)).size
        }
        if sheet:
            blocks[f"{name}_surface"] = _sheet(pyvista, (left, body.y[0]), _spacing(body), sheet)
    found = {name: getattr(snapshot.contact, name) for name in CONTACT_FIELDS if _wanted(name, fields)}
    contact = {name: values for name, values in found.items() if values is not None}
    if snapshot.in_contact and contact:
        corner = (snapshot.contact.x[0], snapshot.contact.y[0])
        blocks["contact"] = _sheet(pyvista, corner, _spacing(snapshot.contact), contact)
    if fields and not blocks.n_blocks:
        apart = "" if snapshot.in_contact else ", in which the bodies do not touch"
        raise InputError(
            f"nothing is stored of {listed(list(fields))} in this state{apart}{how_to_store(fields[0])}; "
            "fields = None takes all that is"
        )
    return blocks


_SURFACE = ("residual_displacement", "height", *ON_BODY)
_VOLUME = (
    "von_mises_stress",
    "equivalent_plastic_strain",
    "temperature",
    "inclusion",
    *(f"{tensor}_{component}" for tensor in TENSORS for component in COMPONENTS),
)


def _of_surface(body: BodyFields, name: str) -> FloatArray:
    """A surface field; an empty array if it is not stored."""
    values: FloatArray | None = getattr(body, name)
    return values if values is not None else np.empty(0)


def _wanted(name: str, fields: Sequence[str] | None) -> bool:
    """Whether a field is requested, itself or as a component of a tensor."""
    return fields is None or name in fields or name.rpartition("_")[0] in (set(fields) & set(TENSORS))


def _require_known(fields: Sequence[str] | None) -> None:
    known = (*_VOLUME, *TENSORS, *_SURFACE, *CONTACT_FIELDS)
    for name in (fields,) if isinstance(fields, str) else fields or ():
        if isinstance(fields, str) or name not in known:
            wrong = f"fields = {fields!r} is no list" if isinstance(fields, str) else f"no field {name!r}"
            raise InputError(f"{wrong}; allowed: a list out of {listed(known)}")


def _volume_fields(body: BodyFields, fields: Sequence[str] | None) -> Iterator[tuple[str, FloatArray]]:
    for name in _VOLUME:
        if _wanted(name, fields):
            try:
                yield name, body[name]
            except KeyError:  # an elastic body has no plastic strain
                continue


def _spacing(grid: BodyFields | ContactFields) -> tuple[float, float]:
    """Cell sizes along x and y [m]; that of a single row is unknown and only affects how the row is drawn."""
    dx = grid.x[1] - grid.x[0] if len(grid.x) > 1 else 1.0
    return float(dx), float(grid.y[1] - grid.y[0] if len(grid.y) > 1 else dx)


def layer_thickness(z: FloatArray, dx: float) -> float:
    """Distance of the layers [m]; a single one, of unknown thickness, is drawn no thicker than its cells are long."""
    return float(z[1] - z[0]) if len(z) > 1 else min(2.0 * float(z[0]), dx)


def _volume(pyvista: Any, body: BodyFields, left: float, arrays: dict[str, FloatArray], *, below: bool) -> Any:
    """Image data with one value per cell, x fastest; layers of the lower body are reversed as its depth points down."""
    dx, dy = _spacing(body)
    dz = layer_thickness(body.z, dx)
    nz, ny, nx = len(body.z), len(body.y), len(body.x)
    image = pyvista.ImageData(
        dimensions=(nx + 1, ny + 1, nz + 1),
        spacing=(dx, dy, dz),
        origin=(
            left - 0.5 * dx,
            body.y[0] - 0.5 * dy,
            -float(body.z[-1]) - 0.5 * dz if below else float(body.z[0]) - 0.5 * dz,
        ),
    )
    for name, values in arrays.items():
        image.cell_data[name] = (values[::-1] if below else values).reshape(-1)
    return image


def _sheet(pyvista: Any, corner: tuple[float, float], spacing: tuple[float, float], arrays: dict[str, Any]) -> Any:
    """Image data with points at the centres of the surface's cells, so that the sheet can be warped."""
    ny, nx = next(iter(arrays.values())).shape
    image = pyvista.ImageData(dimensions=(nx, ny, 1), spacing=(*spacing, 1.0), origin=(*corner, 0.0))
    for name, values in arrays.items():
        image.point_data[name] = values.reshape(-1)
    return image
