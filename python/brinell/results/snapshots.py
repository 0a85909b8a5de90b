# SPDX-License-Identifier: BSD-3-Clause
"""The fields of both bodies at one step."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, field
from functools import partial

import h5py
import numpy as np
from numpy.typing import NDArray

from brinell._names import did_you_mean
from brinell._reprs import cells
from brinell.results.errors import listed
from brinell.scenarios import Scenario

__all__ = [
    "COMPONENTS",
    "CONTACT_FIELDS",
    "TENSORS",
    "BodyFields",
    "ContactFields",
    "Snapshot",
    "TensorField",
    "component_of",
    "row_of",
    "snapshot_of",
]

FloatArray = NDArray[np.float64]

COMPONENTS = ("xx", "yy", "zz", "yz", "xz", "xy")
"""Components of a symmetric tensor, in order."""

_OF_FRICTION = ("shear_x", "shear_y", "slip_x", "slip_y", "slip_path", "friction_heat")
_OF_HEAT = ("temperature_lower", "temperature_upper", "heat_flux_lower", "heat_flux_upper")
CONTACT_FIELDS = ("pressure", "gap", *_OF_FRICTION, *_OF_HEAT)
"""Fields of the contact, which lie on the surface of the lower body; those after the gap only where surfaces stick and
slip, or friction heats."""

TENSORS = ("plastic_strain", "stress")
"""Fields of six components."""


def component_of(name: str) -> tuple[str, str] | None:
    """Tensor and component that a name such as "stress_xx" means; None if it means none."""
    tensor, _, component = name.rpartition("_")
    return (tensor, component) if tensor in TENSORS and component in COMPONENTS else None


class TensorField(Mapping[str, FloatArray]):
    """The components of a tensor by name, "xx" to "xy": arrays [z][y][x], each read when it is first asked for."""

    def __init__(self, name: str, read: Callable[[str], FloatArray] | None):
        """Describes where they come from.

        Args:
            name: "stress" or "plastic_strain".
            read: gives a component; None if the run has not stored them.
        """
        self._name = name
        self._read = read
        self._known: dict[str, FloatArray] = {}

    def __getitem__(self, component: str) -> FloatArray:
        if self._read is None:
            raise KeyError(f"nothing is stored of the {self._name} of this body: it is rigid, or has no such field")
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
class ContactFields:
    """Surface of contact in the local frame that moves with it; cell centres, arrays [y][x]."""

    x: FloatArray
    """Along the motion, 0 at the centre of contact [m]."""
    y: FloatArray
    """Across [m]."""
    pressure: FloatArray
    """Positive in compression [Pa]."""
    gap: FloatArray
    """Zero in contact [m]."""
    shear_x: FloatArray | None = None
    """On the lower body along x [Pa]; this and what follows is None if the run has not stored it."""
    shear_y: FloatArray | None = None
    """On the lower body along y [Pa]."""
    slip_x: FloatArray | None = None
    """Of the upper surface over the lower one since the start, along x [m]."""
    slip_y: FloatArray | None = None
    """The same along y [m]."""
    slip_path: FloatArray | None = None
    """Length of the way slipped since the start [m]."""
    friction_heat: FloatArray | None = None
    """Heat of friction since the start [J/m^2]."""
    temperature_lower: FloatArray | None = None
    """Of the lower surface [deg C]."""
    temperature_upper: FloatArray | None = None
    """Of the upper surface [deg C]."""
    heat_flux_lower: FloatArray | None = None
    """Into the lower body, in this step [W/m^2]."""
    heat_flux_upper: FloatArray | None = None
    """Into the upper body, in this step [W/m^2]."""

    def __repr__(self) -> str:
        return f"<ContactFields {cells(self.pressure.shape)}>"


@dataclass(frozen=True, eq=False)
class BodyFields:
    """One body on its own material grid; cell centres, arrays [z][y][x] or [y][x]. All are empty if it is rigid."""

    x: FloatArray
    """Along the surface; 0 where it is touched at alignment, in the middle of the track or at place 0 [m]."""
    y: FloatArray
    """Across [m]."""
    z: FloatArray
    """Depth into this body, > 0 [m]."""
    contact_x: float
    """Where on this body the centre of contact is now [m]."""
    residual_displacement: FloatArray
    """Of the surface, into the body positive [m]; zero if the body is elastic."""
    equivalent_plastic_strain: FloatArray
    """[-]; zero if the body is elastic."""
    von_mises_stress: FloatArray | None
    """Of contact pressure and plastic strain together [Pa]; None if the run did not store it."""
    worn_depth: FloatArray | None = None
    """That the surface has lost by wear since the start [m]; None without wear. A rigid body has it, too."""
    temperature: FloatArray | None = None
    """[deg C]; None if friction does not heat the body, or its temperature is not known below the surface."""
    height: FloatArray | None = None
    """Of the surface as it is now, with its texture, out of the body positive [m]; None of a smooth rigid body, and in
    results of older versions."""
    plastic_strain: Mapping[str, FloatArray] = field(default_factory=lambda: TensorField("plastic_strain", None))
    """By component, "xx" to "xy" [-]; read when asked for; empty if not stored."""
    stress: Mapping[str, FloatArray] = field(default_factory=lambda: TensorField("stress", None))
    """By component, positive in tension [Pa]; read when asked for; empty if not stored."""

    def __getitem__(self, name: str) -> FloatArray:
        """A field by the name that figures, `Run.field` and the result file have for it, as "stress_xx"."""
        if found := component_of(name):
            tensor: Mapping[str, FloatArray] = getattr(self, found[0])
            return tensor[found[1]]
        known = [*_SCALARS, *(f"{tensor}_{c}" for tensor in TENSORS for c in COMPONENTS)]
        if name not in _SCALARS:
            raise KeyError(f"no field {name!r}; {did_you_mean(name, known)}allowed: {listed(known)}")
        values: FloatArray | None = getattr(self, name)
        if values is None:
            raise KeyError(f"nothing is stored of {name}")
        return values

    @property
    def height_before(self) -> FloatArray | None:
        """Of the surface before the first load, its texture [m]; None where `height` is."""
        if self.height is None:
            return None
        before = self.height if self.is_rigid else self.height + self.residual_displacement
        return before if self.worn_depth is None else before + self.worn_depth

    @property
    def is_rigid(self) -> bool:
        """Whether nothing is stored of this body, because it does not deform."""
        return self.residual_displacement.size == 0

    def __repr__(self) -> str:
        return f"<BodyFields {'rigid' if self.is_rigid else cells((len(self.z), len(self.y), len(self.x)))}>"


@dataclass(frozen=True, eq=False)
class Snapshot:
    """Fields of both bodies at one step."""

    scenario: Scenario
    row: Mapping[str, float]
    """The step's row of the history, SI: `snapshot.row["F_n"]`."""
    is_final: bool
    """State after the last step, over the entire track."""
    contact: ContactFields
    lower: BodyFields
    upper: BodyFields

    def __repr__(self) -> str:
        which = "final state" if self.is_final else f"step {self.step}"
        return f"<Snapshot {self.scenario} {which}, pass {self.pass_}>"

    @property
    def step(self) -> int:
        """Number of the step, from 0: its row of the history."""
        return int(self.row["step"])

    @property
    def pass_(self) -> int:
        """Counts from 1."""
        return int(self.row["pass"])

    @property
    def in_contact(self) -> bool:
        """Whether the bodies touch."""
        return bool(np.any(self.contact.pressure > 0.0))


_SCALARS = (
    "residual_displacement",
    "worn_depth",
    "height",
    "equivalent_plastic_strain",
    "von_mises_stress",
    "temperature",
)
"""Fields of a body that are no tensors."""


def row_of(group: h5py.Group) -> dict[str, float]:
    """A step's row of the history."""
    return {name: float(value) for name, value in group.attrs.items()}


def _axis(origin: float, spacing: float, count: int) -> FloatArray:
    return origin + spacing * np.arange(count, dtype=np.float64)


ReadComponent = Callable[[str, str, str], FloatArray]
"""Of a body ("lower"), a tensor ("stress") and a component ("xx")."""


def snapshot_of(
    group: h5py.Group, row: Mapping[str, float], read: ReadComponent, scenario: Scenario, *, is_final: bool
) -> Snapshot:
    """The fields in a group of the file.

    Args:
        group: of the state.
        row: of the history, of its step.
        read: gives components of tensors later, when the file is closed.
        scenario: of the run.
        is_final: whether it is the state after the last step.

    Raises:
        KeyError, OSError, ValueError and others of h5py: it is damaged.
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
        **{name: np.asarray(group[name][()], dtype=np.float64) for name in (*_OF_FRICTION, *_OF_HEAT) if name in group},
    )


def _body(group: h5py.Group, read_component: Callable[[str, str], FloatArray]) -> BodyFields:
    def read(name: str) -> FloatArray | None:
        return np.asarray(group[name][()], dtype=np.float64) if name in group else None

    def components(name: str) -> TensorField:
        stored = name in group and all(c in group[name] for c in COMPONENTS)
        return TensorField(name, partial(read_component, name) if stored else None)

    residual = read("residual_displacement")
    strain = read("equivalent_plastic_strain")
    von_mises = read("von_mises_stress")
    worn = read("worn_depth")
    height = read("height")
    surface = next((field for field in (residual, worn, height) if field is not None), None)
    nz, ny, nx = _shape(strain if strain is not None else von_mises, surface)
    is_rigid = residual is None and nz == 0
    spacing, origin = group.attrs["spacing"], group.attrs["origin"]
    return BodyFields(
        x=_axis(origin[0], spacing[0], nx),
        y=_axis(origin[1], spacing[1], ny),
        z=_axis(origin[2], spacing[2], nz),
        contact_x=float(group.attrs["contact_x"]),
        residual_displacement=residual if residual is not None else np.zeros((0, 0) if is_rigid else (ny, nx)),
        equivalent_plastic_strain=strain if strain is not None else np.zeros((nz, ny, nx)),
        von_mises_stress=von_mises,
        worn_depth=worn,
        temperature=read("temperature"),
        height=height,
        plastic_strain=components("plastic_strain"),
        stress=components("stress"),
    )


def _shape(volume: FloatArray | None, surface: FloatArray | None) -> tuple[int, int, int]:
    """Cells [nz, ny, nx] of a body, as far as any field of it is stored."""
    if volume is not None:
        nz, ny, nx = volume.shape
        return nz, ny, nx
    if surface is not None:
        ny, nx = surface.shape
        return 0, ny, nx
    return 0, 0, 0
