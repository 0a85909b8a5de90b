# SPDX-License-Identifier: BSD-3-Clause
"""Half spaces on a regular grid: what a pressure, shears and a plastic strain do to one elastic body.

Arrays on a grid are [y, x] or [z, y, x]; a tensor field is [component, z, y, x] with the six components xx, yy, zz, yz,
xz, xy (tensor components, not engineering shear). z points into the body, pressure is positive in compression, stress
in tension; a shear is the traction on the body along x or y. Values belong to the middle of a cell; there are no
periodic images but along axes that are `periodic`. What comes back is a new array each time. An operator is
planned once and may be applied by several threads.

    grid = VolumeGrid(SurfaceGrid(64, 64, 1e-6, 1e-6), nz=32, dz=1e-6)
    body = HalfSpace(grid, Material("210 GPa", 0.3))
    stress = body.pressure_to_stress(pressure)
"""

from __future__ import annotations

import operator
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from brinell import _core
from brinell._arrays import Array, contiguous, number
from brinell._reprs import cells
from brinell.errors import InputError
from brinell.materials import RIGID, Material

__all__ = ["HalfSpace", "SurfaceCompliance", "SurfaceGrid", "VolumeGrid"]


_SMALLEST, _LARGEST = 1e-30, 1e30
"""Sizes of cells [m]: beyond them products of three underflow or overflow."""
_BYTES_OF_SURFACE, _BYTES_OF_VOLUME = 110, 380
"""Per cell: planning the operator and applying it once, without the arrays that the caller has."""


def require_memory(cells: int, bytes_per_cell: float, what: str) -> None:
    """Raises InputError if a grid cannot fit this machine: planning would take minutes before it fails."""
    needed, available = cells * bytes_per_cell, _core.machine_memory()
    if needed > available:
        raise InputError(
            f"{what} of {cells:.1e} cells needs some {needed / 1e9:.0f} GB, this machine has {available / 1e9:.0f} GB; "
            "allowed: fewer cells"
        )


@dataclass(frozen=True)
class SurfaceGrid:
    """Rectangles dx * dy of a surface, with the origin of x and y in the middle of the grid.

    Attributes:
        nx: cells along x, the direction of rolling or sliding.
        ny: cells along y.
        dx: size along x [m].
        dy: size along y [m].
        boundary: what lies beyond the ends: nothing, "open", or the same again, "periodic"; for both axes, or a pair
            for x and y. It is kept as a pair.
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
        """Whether along x, and along y."""
        return self.boundary[0] == "periodic", self.boundary[1] == "periodic"

    @property
    def shape(self) -> tuple[int, int]:
        """(ny, nx), of an array on this grid."""
        return self.ny, self.nx

    @property
    def x(self) -> Array:
        """(nx,), the middles of the columns [m]."""
        return _middles(self.nx, self.dx)

    @property
    def y(self) -> Array:
        """(ny, 1), the middles of the rows [m]: an expression of x and y is an array on the grid."""
        return _middles(self.ny, self.dy)[:, None]

    @property
    def cell_area(self) -> float:
        """The area dx dy of a cell [m^2]."""
        return self.dx * self.dy

    @property
    def _engine(self) -> _core.SurfaceGrid:
        return _core.SurfaceGrid(self.nx, self.ny, self.dx, self.dy, *self.is_periodic)


@dataclass(frozen=True)
class VolumeGrid:
    """Layers of cuboids under a surface; layer k spans the depths from k dz to (k + 1) dz.

    Attributes:
        surface: cells of each layer.
        nz: layers.
        dz: their thickness [m].
    """

    surface: SurfaceGrid
    nz: int
    dz: float

    def __post_init__(self) -> None:
        _check_cells(self, counts=("nz",), sizes=("dz",))

    @property
    def shape(self) -> tuple[int, int, int]:
        """(nz, ny, nx), of an array on this grid."""
        return self.nz, *self.surface.shape

    @property
    def z(self) -> Array:
        """(nz, 1, 1), the middles of the layers [m]."""
        return np.asarray((np.arange(self.nz) + 0.5) * self.dz, dtype=np.float64)[:, None, None]

    @property
    def cell_volume(self) -> float:
        """The volume dx dy dz of a cell [m^3]."""
        return self.surface.cell_area * self.dz

    @property
    def _engine(self) -> _core.VolumeGrid:
        return _core.VolumeGrid(self.surface._engine, self.nz, self.dz)


class SurfaceCompliance:
    """Pressure -> sum of the elastic normal displacements of two bodies (Love 1929); shears, too (Cerruti).

    The operator is symmetric and positive definite, so it is its own transpose. On a grid that is periodic along both
    axes a uniform pressure gives no displacement: displacements are those from the mean plane.
    """

    def __init__(self, grid: SurfaceGrid, lower: Material, upper: Material = RIGID, *, reference: float | None = None):
        """Plans the operator.

        Args:
            grid: of pressure and displacement.
            lower: one body; of its material only the elastic constants count.
            upper: the other one.
            reference: on a grid that is periodic along one axis, the distance from a line load at which its
                displacement in any direction is counted as zero [m], larger than the surface: it has a logarithm
                without end.

        Raises:
            InputError: both are rigid, a material is impossible, or a reference is missing or of no use.
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
        self.contact_modulus = _core.contact_modulus(lower._engine, upper._engine)
        """E' of the pair [Pa], 1/E' = (1 - nu1^2)/E1 + (1 - nu2^2)/E2."""
        self._engine = _core.SurfaceCompliance(grid._engine, self.contact_modulus, reference or 0.0)
        self._pair = lower, upper, reference
        self._tractions: _core.TractionCompliance | None = None  # planned when it is first needed

    def __repr__(self) -> str:
        return f"<SurfaceCompliance {cells(self.grid.shape)}>"

    def pressure_to_displacement(self, pressure: ArrayLike) -> Array:
        """Normal displacement, u = 1/(pi E') integral of p/r.

        Args:
            pressure: (ny, nx) [Pa].

        Returns:
            (ny, nx) [m], the approach that it takes up.
        """
        return self._engine.displacement(contiguous(pressure, "pressure"))

    def displacement(
        self,
        pressure: ArrayLike | None = None,
        shear_x: ArrayLike | None = None,
        shear_y: ArrayLike | None = None,
    ) -> Array:
        """Displacement along all axes (docs/theory/half-space.md).

        The shears act on the lower body, and on the upper one the other way. The displacement along z is the sum of
        both bodies', each along its own z; along x and y it is that of the lower body less that of the upper one. The
        operator is symmetric. Bodies with equal constants do not couple pressure and shear.

        Args:
            pressure: (ny, nx) [Pa]; None: zero.
            shear_x: (ny, nx) [Pa]; None: zero.
            shear_y: (ny, nx) [Pa]; None: zero.

        Returns:
            (3, ny, nx) [m], along x, y and z.
        """
        return self._traction_engine.displacement(
            _optional(pressure, "pressure"), _optional(shear_x, "shear_x"), _optional(shear_y, "shear_y")
        )

    @property
    def _traction_engine(self) -> _core.TractionCompliance:
        if self._tractions is None:
            lower, upper, reference = self._pair
            self._tractions = _core.TractionCompliance(
                self.grid._engine, lower._engine, upper._engine, reference or 0.0
            )
        return self._tractions


class HalfSpace:
    """One elastic body with a traction on its surface and a plastic strain.

    Three operators: B, pressure -> stress; its transpose B', plastic strain -> normal displacement of the surface; and
    H, plastic strain -> residual stress, which is symmetric. With the same coefficients both ways Betti's theorem holds
    to rounding: the sum of B p : eps dV is that of p B' eps dA, and the sum of H eps1 : eps2 that of H eps2 : eps1. The
    same holds for shears and the displacement along x and y. What shears need is planned when the first one comes.
    """

    def __init__(self, grid: VolumeGrid, material: Material):
        """Plans the operators.

        Args:
            grid: of stress and strain; the pressure is on its surface.
            material: of it only the elastic constants count.

        Raises:
            InputError: the material is rigid or impossible.
        """
        if material.is_rigid:
            raise InputError("a rigid body has no stress; allowed: an elastic material")
        require_memory(grid.nz * grid.surface.nx * grid.surface.ny, _BYTES_OF_VOLUME, "a half space")
        self.grid = grid
        self.material = material
        self._engine = _core.HalfSpace(grid._engine, material._engine)

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
        """Stress of what acts on the surface and of a plastic strain together.

        Args:
            pressure: (ny, nx) [Pa]; None: zero.
            eigenstrain: (6, nz, ny, nx) plastic strain, xx + yy + zz = 0 [-]; None: zero.
            shear_x: (ny, nx) traction on the body along x [Pa]; None: zero.
            shear_y: (ny, nx) [Pa]; None: zero.

        Returns:
            (6, nz, ny, nx) [Pa], mean over the thickness of a layer, at the middle of a cell in x and y.
        """
        return self._engine.stress(
            _optional(pressure, "pressure"),
            _optional(eigenstrain, "eigenstrain"),
            _optional(shear_x, "shear_x"),
            _optional(shear_y, "shear_y"),
        )

    def pressure_to_stress(self, pressure: ArrayLike) -> Array:
        """Stress under a pressure (Love 1929), B.

        Args:
            pressure: (ny, nx) [Pa].

        Returns:
            (6, nz, ny, nx) [Pa].
        """
        return self.stress(pressure, None)

    def eigenstrain_to_stress(self, eigenstrain: ArrayLike) -> Array:
        """Residual stress of a plastic strain in a body with a free surface, H (docs/theory/half-space.md).

        Args:
            eigenstrain: (6, nz, ny, nx), xx + yy + zz = 0 [-].

        Returns:
            (6, nz, ny, nx) [Pa].
        """
        return self.stress(None, eigenstrain)

    def eigenstrain_to_displacement(self, eigenstrain: ArrayLike, axis: str = "z") -> Array:
        """Displacement of the surface of a plastic strain, B' (Betti's theorem).

        Args:
            eigenstrain: (6, nz, ny, nx), xx + yy + zz = 0 [-].
            axis: "z", the normal displacement, "x" or "y".

        Returns:
            (ny, nx) [m], along z into the body positive.
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
