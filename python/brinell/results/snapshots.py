# SPDX-License-Identifier: BSD-3-Clause
"""The fields of both bodies at one step."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, field, fields
from functools import partial

import h5py
import numpy as np
from numpy.typing import NDArray

from brinell._names import did_you_mean
from brinell._reprs import cells
from brinell.results.errors import listed
from brinell.results.surface_fields import LOWERING, FieldsOfBody, FieldsOfContact
from brinell.scenarios import Scenario

__all__ = [
    "COMPONENTS",
    "CONTACT_FIELDS",
    "ON_BODY",
    "TENSORS",
    "BodyFields",
    "ContactFields",
    "Snapshot",
    "TensorField",
    "component_of",
    "counts_of",
    "how_to_store",
    "row_of",
    "snapshot_of",
]

FloatArray = NDArray[np.float64]

COMPONENTS = ("xx", "yy", "zz", "yz", "xz", "xy")
"""Components of a symmetric tensor, in order."""

_IN_CONTACT = tuple(field.name for field in fields(FieldsOfContact))
CONTACT_FIELDS = ("pressure", "gap", *_IN_CONTACT)
"""Fields of the contact, on the surface of the lower body; after the gap those of friction, heat and effects."""

ON_BODY = tuple(field.name for field in fields(FieldsOfBody))
"""Fields of effects on the surface of a body; they also exist for rigid bodies."""

TENSORS = ("plastic_strain", "stress")
"""Tensor fields with six components."""


def how_to_store(name: str) -> str:
    """How the case asks for a field that is not stored; empty for a field that may not exist in a case.

    >>> how_to_store("stress_xx")
    '; output.fields = ["surface", "stress"] of the case stores it, of the bodies in output.bodies'
    """
    found = component_of(name)
    field = found[0] if found else name
    if field not in (*TENSORS, "equivalent_plastic_strain", "von_mises_stress", "temperature", "residual_displacement"):
        return ""
    with_heat = ", if there is heat" if field == "temperature" else ""
    words = f'"{field}"' if field == "residual_displacement" else f'["surface", "{field}"]'
    return f"; output.fields = {words} of the case stores it{with_heat}, of the bodies in output.bodies"


def component_of(name: str) -> tuple[str, str] | None:
    """Tensor and component of a name such as "stress_xx"; None for any other name."""
    tensor, _, component = name.rpartition("_")
    return (tensor, component) if tensor in TENSORS and component in COMPONENTS else None


class TensorField(Mapping[str, FloatArray]):
    """Components of a tensor by name, "xx" to "xy": (nz, ny, nx) arrays, each read when it is first used."""

    def __init__(self, name: str, read: Callable[[str], FloatArray] | None, *, is_rigid: bool = False):
        """Makes the mapping without reading any component.

        Args:
            name: "stress" or "plastic_strain".
            read: function that reads a component; None if the tensor is not stored.
            is_rigid: whether the body is rigid, so that it has no such tensor.
        """
        self._name = name
        self._read = read
        self._how_to_store = ": it is rigid" if is_rigid else how_to_store(name)
        self._known: dict[str, FloatArray] = {}

    def __getitem__(self, component: str) -> FloatArray:
        if self._read is None:
            raise KeyError(f"nothing is stored of the {self._name} of this body{self._how_to_store}")
        if component not in COMPONENTS:
            raise KeyError(f"{self._name} has no component {component!r}; allowed: {listed(COMPONENTS)}")
        if component not in self._known:
            self._known[component] = self._read(component)
        return self._known[component]

    def __iter__(self) -> Iterator[str]:
        return iter(COMPONENTS if self._read is not None else ())

    def __len__(self) -> int:
        return len(COMPONENTS) if self._read is not None else 0

    def __contains__(self, component: object) -> bool:
        return self._read is not None and component in COMPONENTS

    def __repr__(self) -> str:
        return f"<TensorField {self._name} {listed(list(self))}>"


@dataclass(frozen=True, eq=False)
class ContactFields(FieldsOfContact):
    """Contact fields in the frame that moves with the contact, at cell centres; (ny, nx) arrays."""

    x: FloatArray
    """(nx,) coordinates along the motion, 0 at the centre of contact [m]."""
    y: FloatArray
    """(ny,) coordinates across the motion [m]."""
    pressure: FloatArray
    """Contact pressure, positive in compression [Pa]."""
    gap: FloatArray
    """Gap between the deformed surfaces, zero in contact [m]."""

    def __repr__(self) -> str:
        return f"<ContactFields {cells(self.pressure.shape)}>"


@dataclass(frozen=True, eq=False)
class BodyFields(FieldsOfBody):
    """Fields of one body on its own grid, at cell centres; (nz, ny, nx) or (ny, nx) arrays, empty for a rigid body."""

    x: FloatArray
    """(nx,) coordinates along the surface [m]; 0 at the point of contact at alignment, in the middle of the track or at
    place 0."""
    y: FloatArray
    """(ny,) coordinates across [m]."""
    z: FloatArray
    """(nz,) depths into this body, > 0 [m]."""
    contact_x: float
    """Present position of the centre of contact on this body [m]."""
    residual_displacement: FloatArray
    """(ny, nx) residual displacement of the surface, positive into the body [m]; zero for an elastic body, NaN if the
    case did not ask to store it."""
    equivalent_plastic_strain: FloatArray
    """(nz, ny, nx) equivalent plastic strain [-]; zero for an elastic body, NaN if it is not stored, as between bodies
    neither of which can yield unless the case asks for it."""
    von_mises_stress: FloatArray | None
    """(nz, ny, nx) von Mises stress of contact pressure and plastic strain together [Pa]; None if it is not stored."""
    temperature: FloatArray | None = None
    """(nz, ny, nx) temperature [deg C]; None if friction does not heat the body, or it is known at the surface only."""
    inclusion: FloatArray | None = None
    """(nz, ny, nx) number of the inclusion in a cell in the order of the case, 0: none; None without inclusions, or
    if it is not stored."""
    height: FloatArray | None = None
    """(ny, nx) present height of the surface with its texture, positive out of the body [m]; None for a smooth rigid
    body, and in results of older versions."""
    plastic_strain: Mapping[str, FloatArray] = field(default_factory=lambda: TensorField("plastic_strain", None))
    """(nz, ny, nx) plastic strain by component, "xx" to "xy" [-]; read on first use; empty if it is not stored."""
    stored: frozenset[str] | None = None
    """Names of the stored fields; None in results of older versions, which stored all."""
    is_rigid: bool = False
    """Whether the body is rigid, so that it has no displacement and strain."""
    stress: Mapping[str, FloatArray] = field(default_factory=lambda: TensorField("stress", None))
    """(nz, ny, nx) stress by component, positive in tension [Pa]; read on first use; empty if it is not stored."""

    def __getitem__(self, name: str) -> FloatArray:
        """A field by the name used in figures, in `Run.field` and in the result file, such as "stress_xx"."""
        if found := component_of(name):
            tensor: Mapping[str, FloatArray] = getattr(self, found[0])
            return tensor[found[1]]
        known = [*_SCALARS, *(f"{tensor}_{c}" for tensor in TENSORS for c in COMPONENTS)]
        if name not in _SCALARS:
            raise KeyError(f"no field {name!r}; {did_you_mean(name, known)}allowed: {listed(known)}")
        values: FloatArray | None = getattr(self, name)
        if values is None or (not self.is_rigid and not self.has(name)):
            raise KeyError(
                f"nothing is stored of {name}{': the body is rigid' if self.is_rigid else how_to_store(name)}"
            )
        return values

    @property
    def height_before(self) -> FloatArray | None:
        """(ny, nx) height of the surface before the first load, its texture [m]; None if `height` is None."""
        if self.height is None or not (self.is_rigid or self.has("residual_displacement")):
            return None
        before = self.height if self.is_rigid else self.height + self.residual_displacement
        for name in LOWERING:
            lost: FloatArray | None = getattr(self, name)
            if lost is not None:
                before = before + lost
        return before

    def has(self, name: str) -> bool:
        """Whether a field such as "residual_displacement" or "stress" is stored, as far as it exists."""
        return self.stored is None or name in self.stored

    @property
    def is_dented(self) -> bool:
        """Whether a residual displacement is stored that is not zero."""
        return self.has("residual_displacement") and bool(np.any(self.residual_displacement))

    @property
    def has_yielded(self) -> bool:
        """Whether an equivalent plastic strain is stored that is not zero."""
        return self.has("equivalent_plastic_strain") and bool(np.any(self.equivalent_plastic_strain))

    def __repr__(self) -> str:
        return f"<BodyFields {'rigid' if self.is_rigid else cells((len(self.z), len(self.y), len(self.x)))}>"


@dataclass(frozen=True, eq=False)
class Snapshot:
    """Fields of both bodies at one step."""

    scenario: Scenario
    row: Mapping[str, float]
    """The step's row of the history in SI units: `snapshot.row["F_n"]`."""
    is_final: bool
    """Whether this is the state after the last step, over the entire track."""
    contact: ContactFields
    lower: BodyFields
    upper: BodyFields

    def __repr__(self) -> str:
        which = "final state" if self.is_final else f"step {self.step}"
        return f"<Snapshot {self.scenario} {which}, pass {self.pass_}>"

    @property
    def step(self) -> int:
        """Number of the step, from 0, which is its row of the history."""
        return int(self.row["step"])

    @property
    def pass_(self) -> int:
        """Number of the pass, from 1."""
        return int(self.row["pass"])

    @property
    def in_contact(self) -> bool:
        """Whether the bodies touch."""
        return bool(np.any(self.contact.pressure > 0.0))


_SCALARS = (
    "residual_displacement",
    "height",
    *ON_BODY,
    "equivalent_plastic_strain",
    "von_mises_stress",
    "temperature",
    "inclusion",
)
"""Scalar fields of a body."""


def row_of(group: h5py.Group) -> dict[str, float]:
    """Row of the history of a step, from the attributes of its group."""
    return {name: float(value) for name, value in group.attrs.items()}


def _axis(origin: float, spacing: float, count: int) -> FloatArray:
    return origin + spacing * np.arange(count, dtype=np.float64)


ReadComponent = Callable[[str, str, str], FloatArray]
"""Function that reads a field by body ("lower"), tensor ("stress") and component ("xx")."""


def snapshot_of(
    group: h5py.Group, row: Mapping[str, float], read: ReadComponent, scenario: Scenario, *, is_final: bool
) -> Snapshot:
    """Reads the fields of a state.

    Args:
        group: HDF5 group of the state.
        row: row of the history of its step.
        read: function that reads tensor components later, when this file is closed.
        scenario: scenario of the run.
        is_final: whether this is the state after the last step.

    Raises:
        KeyError, OSError, ValueError and others of h5py: the file is damaged.
    """
    return Snapshot(
        scenario=scenario,
        row=row,
        is_final=is_final,
        contact=_contact(group["contact"]),
        lower=_body(group["lower"], partial(read, "lower")),
        upper=_body(group["upper"], partial(read, "upper")),
    )


def _contact(group: h5py.Group) -> ContactFields:
    pressure = np.asarray(group["pressure"][()], dtype=np.float64)
    spacing, origin = group.attrs["spacing"], group.attrs["origin"]
    ny, nx = pressure.shape
    return ContactFields(
        x=_axis(origin[0], spacing[0], nx),
        y=_axis(origin[1], spacing[1], ny),
        pressure=pressure,
        gap=np.asarray(group["gap"][()], dtype=np.float64),
        **{name: np.asarray(group[name][()], dtype=np.float64) for name in _IN_CONTACT if name in group},
    )


def _body(group: h5py.Group, read_component: Callable[[str, str], FloatArray]) -> BodyFields:
    def read(name: str) -> FloatArray | None:
        return np.asarray(group[name][()], dtype=np.float64) if name in group else None

    def components(name: str) -> TensorField:
        stored = name in group and all(c in group[name] for c in COMPONENTS)
        return TensorField(name, partial(read_component, name) if stored else None, is_rigid=is_rigid)

    residual = read("residual_displacement")
    strain = read("equivalent_plastic_strain")
    von_mises = read("von_mises_stress")
    of_effects = {name: read(name) for name in ON_BODY}
    worn = next((values for values in of_effects.values() if values is not None), None)
    height = read("height")
    says = "is_rigid" in group.attrs  # older results store all fields that exist
    if says:
        is_rigid, counts = bool(group.attrs["is_rigid"]), counts_of(group.parent, group.name.rpartition("/")[2])
        nz, ny, nx = (0, *_shape(None, worn if worn is not None else height)[1:]) if is_rigid else counts
    else:
        surface = next((field for field in (residual, worn, height) if field is not None), None)
        nz, ny, nx = _shape(strain if strain is not None else von_mises, surface)
        is_rigid = residual is None and nz == 0
    left_out = np.nan if says and not is_rigid else 0.0
    spacing, origin = group.attrs["spacing"], group.attrs["origin"]
    return BodyFields(
        x=_axis(origin[0], spacing[0], nx),
        y=_axis(origin[1], spacing[1], ny),
        z=_axis(origin[2], spacing[2], nz),
        contact_x=float(group.attrs["contact_x"]),
        residual_displacement=residual if residual is not None else _filled(left_out, (0, 0) if is_rigid else (ny, nx)),
        equivalent_plastic_strain=strain if strain is not None else _filled(left_out, (nz, ny, nx)),
        stored=frozenset(group) if says else None,
        is_rigid=is_rigid,
        von_mises_stress=von_mises,
        **of_effects,
        temperature=read("temperature"),
        inclusion=read("inclusion"),
        height=height,
        plastic_strain=components("plastic_strain"),
        stress=components("stress"),
    )


def _filled(value: float, shape: tuple[int, ...]) -> FloatArray:
    """An array of equal values, which takes no memory if they are unknown."""
    return np.zeros(shape) if value == 0.0 else np.broadcast_to(np.float64(value), shape)


def counts_of(state: h5py.Group, body: str) -> tuple[int, int, int]:
    """Number of cells (nz, ny, nx) of a body's grid, also of a rigid body, which has no fields.

    Raises:
        KeyError, OSError, ValueError and others of h5py: the file is damaged.
    """
    group = state[body]
    if "cells" in group.attrs:
        nx, ny, nz = (int(count) for count in group.attrs["cells"])
        return nz, ny, nx
    stored = (group[name].shape for name in _SCALARS if name in group)
    shape = max(stored, key=len, default=None) or _shape_in_paraview(state.file, body)
    return (*(0,) * (3 - len(shape)), *shape)


def _shape_in_paraview(file: h5py.File, body: str) -> tuple[int, ...]:
    """Number of cells (ny, nx) on a body's surface, from the part for ParaView; older results have it only there."""
    _, nx, _, ny, *_ = (int(last) + 1 for last in file[f"VTKHDF/{body}_surface"].attrs["WholeExtent"])
    return ny, nx


def _shape(volume: FloatArray | None, surface: FloatArray | None) -> tuple[int, int, int]:
    """Number of cells (nz, ny, nx) of a body, from the stored fields; zeros if none is stored."""
    if volume is not None:
        nz, ny, nx = volume.shape
        return nz, ny, nx
    if surface is not None:
        ny, nx = surface.shape
        return 0, ny, nx
    return 0, 0, 0
