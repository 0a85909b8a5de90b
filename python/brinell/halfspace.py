# SPDX-License-Identifier: BSD-3-Clause
"""Elastic half spaces on a regular grid: stress and displacement of a pressure, a shear traction and a plastic strain.

Arrays on a grid are [y, x] or [z, y, x]; a tensor field is [component, z, y, x] with the six components xx, yy, zz, yz,
xz, xy (tensor components, not engineering shear). z points into the body, pressure is positive in compression, stress
in tension; a shear is the traction on the body along x or y. Values are those at the centre of a cell. There are
periodic images only along axes that are `periodic`. Each call returns a new array. An operator is set up once and may
be applied by several threads.

    grid = VolumeGrid(SurfaceGrid(64, 64, 1e-6, 1e-6), nz=32, dz=1e-6)
    body = HalfSpace(grid, Material("210 GPa", 0.3))
    stress = body.pressure_to_stress(pressure)
"""

from __future__ import annotations

import operator
import sys
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from brinell import _core
from brinell._arguments import explain_argument_errors
from brinell._arrays import Array, contiguous, number
from brinell._reprs import cells
from brinell.errors import InputError
from brinell.materials import RIGID, Material

__all__ = ["HalfSpace", "Layer", "SurfaceCompliance", "SurfaceGrid", "VolumeGrid"]


_SMALLEST, _LARGEST = 1e-30, 1e30
"""Allowed sizes of cells [m]: beyond these limits the product of three sizes underflows or overflows."""
_BYTES_OF_SURFACE, _BYTES_OF_VOLUME = 110, 380
"""Memory per cell [B] to set up an operator and apply it once, without the arrays of the caller."""


def require_memory(cells: int, bytes_per_cell: float, subject: str) -> None:
    """Raises InputError if a grid needs more memory than the machine has: the setup would take minutes before it fails.

    Args:
        cells: number of cells.
        bytes_per_cell: memory per cell [B].
        subject: noun for the error message, such as "a surface".
    """
    needed, available = cells * bytes_per_cell, _core.machine_memory()
    if needed > available:
        raise InputError(
            f"{subject} of {cells:.1e} cells needs some {needed / 1e9:.0f} GB, "
            f"this machine has {available / 1e9:.0f} GB; allowed: fewer cells"
        )


@dataclass(frozen=True)
class SurfaceGrid:
    """Regular grid of rectangular cells on a surface, with the origin of x and y in the middle of the grid.

    Attributes:
        nx: number of cells along x, the direction of rolling or sliding.
        ny: number of cells along y.
        dx: cell size along x [m].
        dy: cell size along y [m].
        boundary: "open" (no traction beyond the grid) or "periodic" (the grid repeats), for both axes or as a pair for
            x and y. It is stored as a pair.

    Raises:
        InputError: a count that is not a whole number from 1 to 100000, a size out of range, or an unknown boundary.
    """

    nx: int
    ny: int
    dx: float
    dy: float
    boundary: str | tuple[str, str] = "open"

    def __post_init__(self) -> None:
        _check_cells(self, counts=("nx", "ny"), sizes=("dx", "dy"))
        pair = (self.boundary, self.boundary) if isinstance(self.boundary, str) else tuple(self.boundary)
        if len(pair) != 2 or not set(pair) <= {"open", "periodic"}:
            raise InputError(
                f"boundary = {self.boundary!r} of a grid; allowed: 'open', 'periodic', or a pair of them for x and y"
            )
        object.__setattr__(self, "boundary", pair)

    @property
    def is_periodic(self) -> tuple[bool, bool]:
        """Whether the grid is periodic along x, and along y."""
        return self.boundary[0] == "periodic", self.boundary[1] == "periodic"

    @property
    def shape(self) -> tuple[int, int]:
        """Shape (ny, nx) of an array on this grid."""
        return self.ny, self.nx

    @property
    def x(self) -> Array:
        """(nx,) coordinates of the cell centres along x [m]."""
        return _middles(self.nx, self.dx)

    @property
    def y(self) -> Array:
        """(ny, 1) coordinates of the cell centres along y [m]; an expression of x and y broadcasts to (ny, nx)."""
        return _middles(self.ny, self.dy)[:, None]

    @property
    def cell_area(self) -> float:
        """Area dx dy of a cell [m^2]."""
        return self.dx * self.dy

    @property
    def _engine(self) -> _core.SurfaceGrid:
        return _core.SurfaceGrid(self.nx, self.ny, self.dx, self.dy, *self.is_periodic)


@dataclass(frozen=True)
class VolumeGrid:
    """Regular grid of cuboid cells under a surface; layer k spans the depths from k dz to (k + 1) dz.

    Attributes:
        surface: grid of the cells of each layer.
        nz: number of layers.
        dz: thickness of a layer [m].

    Raises:
        InputError: `nz` is not a whole number from 1 to 100000, or `dz` is out of range.
    """

    surface: SurfaceGrid
    nz: int
    dz: float

    def __post_init__(self) -> None:
        _check_cells(self, counts=("nz",), sizes=("dz",))

    @property
    def shape(self) -> tuple[int, int, int]:
        """Shape (nz, ny, nx) of an array on this grid."""
        return self.nz, *self.surface.shape

    @property
    def z(self) -> Array:
        """(nz, 1, 1) depths of the middles of the layers [m]."""
        return np.asarray((np.arange(self.nz) + 0.5) * self.dz, dtype=np.float64)[:, None, None]

    @property
    def cell_volume(self) -> float:
        """Volume dx dy dz of a cell [m^3]."""
        return self.surface.cell_area * self.dz

    @property
    def _engine(self) -> _core.VolumeGrid:
        return _core.VolumeGrid(self.surface._engine, self.nz, self.dz)


@dataclass(frozen=True)
class Layer:
    """A layer of a coated body, bonded to the layers beside it or to the body beneath.

    Attributes:
        thickness: thickness of the layer [m].
        material: its material; only the elastic constants are used, and in `brinell.heat` the thermal ones.

    Raises:
        InputError: the thickness is not above 0, or the material is rigid.
    """

    thickness: float
    material: Material

    def __post_init__(self) -> None:
        if not 0.0 < number(self.thickness, "thickness") < float("inf"):
            raise InputError(f"thickness = {self.thickness} of a layer; allowed: a length above 0")
        if self.material.is_rigid:
            raise InputError("material of a layer is rigid; allowed: an elastic material, on a rigid body if need be")

    @property
    def _constants(self) -> tuple[float, float, float]:
        material = self.material
        return number(self.thickness, "thickness"), material._engine.young_modulus, material.poisson_ratio


class SurfaceCompliance:
    """Elastic displacement of the surfaces of two bodies under pressure (Love 1929) and shear traction (Cerruti).

    The operator is symmetric and positive definite. On a grid that is periodic along both axes a uniform pressure gives
    no displacement: displacements are measured from the mean plane.
    """

    def __init__(
        self,
        grid: SurfaceGrid,
        lower: Material,
        upper: Material = RIGID,
        *,
        reference: float | None = None,
        lower_layers: Sequence[Layer] = (),
        upper_layers: Sequence[Layer] = (),
    ):
        """Sets up the operator.

        Args:
            grid: grid of pressure and displacement.
            lower: material of the lower body; only its elastic constants are used.
            upper: material of the upper body; only its elastic constants are used.
            reference: only on a grid that is periodic along exactly one axis: distance from a line load at which its
                displacement in any direction is set to zero [m]. It must exceed the size of the surface. It is needed
                because the displacement of a line load grows with the logarithm of the distance without bound.
            lower_layers: layers on the lower body, from the surface down (docs/theory/stacks.md); `lower` is the body
                beneath them and may then be rigid.
            upper_layers: layers on the upper body, from its surface.

        Raises:
            InputError: both bodies are rigid, a material is invalid, `reference` is missing or not applicable, or the
                grid needs more memory than the machine has.
        """
        require_memory(grid.nx * grid.ny, _BYTES_OF_SURFACE, "a surface")
        if (sum(grid.is_periodic) == 1) != (reference is not None):
            raise InputError(
                f"reference = {reference} with the boundary {grid.boundary}; allowed: a length if one axis is "
                "periodic, otherwise None"
            )
        if reference is not None and not number(reference, "reference") > 0.0:
            raise InputError(f"reference = {reference}; allowed: a length above 0")
        self.grid = grid
        at_lower = lower_layers[0].material if lower_layers else lower
        at_upper = upper_layers[0].material if upper_layers else upper
        self.contact_modulus = _core.contact_modulus(at_lower._engine, at_upper._engine)
        """Contact modulus E' of the materials at the surfaces [Pa], 1/E' = (1 - nu1^2)/E1 + (1 - nu2^2)/E2."""
        self._engine = _core.SurfaceCompliance(
            grid._engine,
            lower._engine,
            upper._engine,
            reference or 0.0,
            [layer._constants for layer in lower_layers],
            [layer._constants for layer in upper_layers],
        )

    def __repr__(self) -> str:
        return f"<SurfaceCompliance {cells(self.grid.shape)}>"

    def pressure_to_displacement(self, pressure: ArrayLike) -> Array:
        """Normal displacement u = 1/(pi E') integral of p/r, summed over both bodies.

        Args:
            pressure: (ny, nx) pressure [Pa].

        Returns:
            (ny, nx) displacement, each body's positive into that body, so that it widens the gap [m].
        """
        return self._engine.displacement(contiguous(pressure, "pressure"))

    def displacement(
        self,
        pressure: ArrayLike | None = None,
        shear_x: ArrayLike | None = None,
        shear_y: ArrayLike | None = None,
    ) -> Array:
        """Displacement along x, y and z (docs/theory/half-space.md).

        The shear acts on the lower body, and with the opposite sign on the upper one. The displacement along z is the
        sum of both bodies' displacements, each positive into its own body. Along x and y it is the displacement of the
        lower body minus that of the upper one. The operator is symmetric. If both bodies have the same elastic
        constants, pressure and shear are uncoupled.

        Args:
            pressure: (ny, nx) pressure [Pa]; None: zero.
            shear_x: (ny, nx) shear on the lower body along x [Pa]; None: zero.
            shear_y: (ny, nx) shear on the lower body along y [Pa]; None: zero.

        Returns:
            (3, ny, nx) displacement along x, y and z [m].
        """
        return self._engine.displacements(
            _optional(pressure, "pressure"), _optional(shear_x, "shear_x"), _optional(shear_y, "shear_y")
        )


class HalfSpace:
    """Elastic half space with a traction on its surface and a plastic strain inside.

    The class has three operators: B maps a pressure to stress; its transpose B' maps a plastic strain to the normal
    displacement of the surface; H, which is symmetric, maps a plastic strain to the residual stress. B and B' use the
    same coefficients, so that Betti's theorem holds to rounding: the sum of B p : eps dV equals that of p B' eps dA,
    and the sum of H eps1 : eps2 equals that of H eps2 : eps1. The same holds for shear and the displacement along x and
    y; the operators of the shear are set up on first use.
    """

    def __init__(self, grid: VolumeGrid, material: Material, *, layers: Sequence[Layer] = ()):
        """Sets up the operators.

        Args:
            grid: grid of stress and strain; the pressure is on its surface grid.
            material: material of the body; only its elastic constants are used.
            layers: layers on the body, from the surface down (docs/theory/stacks.md). The stress in a cell that an
                interface cuts is the mean over both layers. With plastic strain no interface may cut cells.

        Raises:
            InputError: the material is rigid or invalid, or the grid needs more memory than the machine has.
        """
        if material.is_rigid and not layers:
            raise InputError("a rigid body has no stress; allowed: an elastic material")
        require_memory(grid.nz * grid.surface.nx * grid.surface.ny, _BYTES_OF_VOLUME, "a half space")
        self.grid = grid
        self.material = material
        self.layers = tuple(layers)
        self._engine = _core.HalfSpace(grid._engine, material._engine, [layer._constants for layer in layers])

    def __repr__(self) -> str:
        return f"<HalfSpace {cells(self.grid.shape)}>"

    def stress(
        self,
        pressure: ArrayLike | None = None,
        eigenstrain: ArrayLike | None = None,
        *,
        shear_x: ArrayLike | None = None,
        shear_y: ArrayLike | None = None,
    ) -> Array:
        """Total stress of the surface traction and the plastic strain.

        Args:
            pressure: (ny, nx) pressure [Pa]; None: zero.
            eigenstrain: (6, nz, ny, nx) plastic strain, xx + yy + zz = 0 [-]; None: zero.
            shear_x: (ny, nx) traction on the body along x [Pa]; None: zero.
            shear_y: (ny, nx) traction on the body along y [Pa]; None: zero.

        Returns:
            (6, nz, ny, nx) stress, averaged over the thickness of a layer, at the middle of a cell in x and y [Pa].
        """
        return self._engine.stress(
            _optional(pressure, "pressure"),
            _optional(eigenstrain, "eigenstrain"),
            _optional(shear_x, "shear_x"),
            _optional(shear_y, "shear_y"),
        )

    def pressure_to_stress(self, pressure: ArrayLike) -> Array:
        """Stress under a pressure (Love 1929), operator B.

        Args:
            pressure: (ny, nx) pressure [Pa].

        Returns:
            (6, nz, ny, nx) stress [Pa].
        """
        return self.stress(pressure, None)

    def eigenstrain_to_stress(self, eigenstrain: ArrayLike) -> Array:
        """Residual stress of a plastic strain in a body with a free surface, operator H (docs/theory/half-space.md).

        Args:
            eigenstrain: (6, nz, ny, nx) plastic strain, xx + yy + zz = 0 [-].

        Returns:
            (6, nz, ny, nx) residual stress [Pa].
        """
        return self.stress(None, eigenstrain)

    def eigenstrain_to_displacement(self, eigenstrain: ArrayLike, axis: str = "z") -> Array:
        """Residual displacement of the surface by a plastic strain, operator B' (by Betti's theorem).

        Args:
            eigenstrain: (6, nz, ny, nx) plastic strain, xx + yy + zz = 0 [-].
            axis: "z" for the normal displacement, or "x" or "y".

        Returns:
            (ny, nx) displacement [m]; along z positive into the body.

        Raises:
            InputError: a wrong shape, an unknown axis, or strain in a body whose interfaces lie within cells.
        """
        if axis not in ("x", "y", "z"):
            raise InputError(f"axis = {axis!r} of a displacement; allowed: 'x', 'y', 'z'")
        return self._engine.residual_displacement(contiguous(eigenstrain, "eigenstrain"), axis)


def _optional(values: ArrayLike | None, name: str) -> Array | None:
    return None if values is None else contiguous(values, name)


def _middles(count: int, size: float) -> Array:
    return np.asarray((np.arange(count) - 0.5 * (count - 1)) * size, dtype=np.float64)


def _check_cells(grid: SurfaceGrid | VolumeGrid, counts: tuple[str, ...], sizes: tuple[str, ...]) -> None:
    for name in counts:
        count = getattr(grid, name)
        try:
            whole = operator.index(count)
        except TypeError:
            whole = 0
        if not 1 <= whole <= 100_000:
            raise InputError(f"{name} = {count} of a grid; allowed: a whole number of cells from 1 to 100000")
        object.__setattr__(grid, name, whole)
    for name in sizes:
        size = getattr(grid, name)
        if not _SMALLEST <= number(size, name) <= _LARGEST:
            raise InputError(f"{name} = {size} of a grid; allowed: a length from {_SMALLEST:g} to {_LARGEST:g} m")


explain_argument_errors(sys.modules[__name__])
