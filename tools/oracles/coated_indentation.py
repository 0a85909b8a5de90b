#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Elastic-plastic indentation of a coated half space by a rigid paraboloid, by axisymmetric finite elements.

Usage: python tools/oracles/coated_indentation.py [ELEMENTS_PER_RADIUS] > tests/data/coated_indentation_oracle.csv
Needs NumPy and SciPy. With 40 elements it takes half an hour.

A discretisation of the volume, with nothing of the engine: bilinear quadrilaterals with a mean dilatation (B-bar, Hughes
1980), radial return with the consistent tangent (Simo and Taylor 1985), small strains, frictionless contact of nodes by
an active set within Newton's method. The far boundary, 40 contact radii away, moves as a half space of the substrate
under the same load (Boussinesq); what it leaves out falls with the square of the distance.
"""

import sys
from dataclasses import dataclass

import numpy as np
from scipy.sparse import coo_matrix
from scipy.sparse.linalg import splu

RADIUS = 50e-6
FAR = 40.0  # contact radii


COLUMNS = (
    "load_N",
    "contact_radius_m",
    "depth_m",
    "pile_up_m",
    "strain_coat",
    "strain_substrate",
    "amount_coat_m3",
    "amount_substrate_m3",
)
"""Load and radius of contact at the largest approach; after unloading, the depth and height of the surface, the largest equivalent
plastic strain, and its integral, in the coat and in the substrate."""


@dataclass(frozen=True)
class Solid:
    young: float
    poisson: float
    yield_stress: float = 1e30
    modulus: float = 0.0  # of linear isotropic hardening over the plastic strain


@dataclass(frozen=True)
class Case:
    name: str
    thickness: float
    coat: Solid
    substrate: Solid
    approach: float


STEEL = Solid(210e9, 0.3, 2e9, 20e9)
CASES = (
    Case("plain", 1e-6, STEEL, STEEL, 0.3e-6),
    Case("hard", 1e-6, Solid(400e9, 0.2, 8e9, 20e9), STEEL, 0.3e-6),
    Case("soft", 1e-6, Solid(80e9, 0.35, 0.8e9, 4e9), Solid(210e9, 0.3, 4e9, 20e9), 0.15e-6),
    Case("elastic", 1e-6, Solid(400e9, 0.2), Solid(210e9, 0.3, 1.5e9, 10e9), 0.3e-6),
)


def spacing(fine: float, inner: float, far: float, growth: float = 1.12) -> np.ndarray:
    """Nodes from 0: equal to `inner`, then growing to `far`."""
    count = round(inner / fine)
    nodes = list(np.linspace(0.0, inner, count + 1))
    step = inner / count
    while nodes[-1] < far:
        step *= growth
        nodes.append(nodes[-1] + step)
    return np.array(nodes)


class Mesh:
    """A tensor product of nodes along r and z, with the matrices of strain at the four Gauss points."""

    def __init__(self, case: Case, per_radius: int):
        a = np.sqrt(RADIUS * case.approach)  # of the elastic contact of a homogeneous body
        r = spacing(a / per_radius, 1.6 * a, FAR * a)
        layers = max(1, round(case.thickness * per_radius / a))
        step = case.thickness / layers
        z = spacing(step, step * np.ceil(2.0 * a / step), FAR * a)
        self.r, self.z = np.meshgrid(r, z, indexing="ij")
        self.r, self.z = self.r.ravel(), self.z.ravel()
        nr, nz = len(r), len(z)
        i, j = np.meshgrid(np.arange(nr - 1), np.arange(nz - 1), indexing="ij")
        corner = (i * nz + j).ravel()
        self.nodes = np.stack([corner, corner + nz, corner + nz + 1, corner + 1], axis=1)
        self.surface = np.arange(nr) * nz
        self.far = np.flatnonzero((self.r == r[-1]) | (self.z == z[-1]))
        self.axis = np.flatnonzero(self.r == 0.0)
        middle = self.z[self.nodes].mean(axis=1)
        self.in_coat = middle < case.thickness
        self._strain_matrices()

    def _strain_matrices(self) -> None:
        """B of (rr, zz, tt, rz), with the dilatation of the element's mean; weights are volumes."""
        x, y = self.r[self.nodes], self.z[self.nodes]
        n = len(self.nodes)
        g = 1.0 / np.sqrt(3.0)
        b, volume, dilatation = np.zeros((n, 4, 4, 8)), np.zeros((n, 4)), np.zeros((n, 4, 8))
        for p, (s, t) in enumerate([(-g, -g), (g, -g), (g, g), (-g, g)]):
            shape = 0.25 * np.array([(1 - s) * (1 - t), (1 + s) * (1 - t), (1 + s) * (1 + t), (1 - s) * (1 + t)])
            ds = 0.25 * np.array([-(1 - t), 1 - t, 1 + t, -(1 + t)])
            dt = 0.25 * np.array([-(1 - s), -(1 + s), 1 + s, 1 - s])
            jac = np.stack([np.stack([x @ ds, y @ ds], -1), np.stack([x @ dt, y @ dt], -1)], -2)
            det = np.linalg.det(jac)
            gradient = np.linalg.solve(jac, np.broadcast_to(np.stack([ds, dt]), (n, 2, 4)))
            radius = x @ shape
            b[:, p, 0, 0::2] = gradient[:, 0]
            b[:, p, 1, 1::2] = gradient[:, 1]
            b[:, p, 2, 0::2] = shape / radius[:, None]
            b[:, p, 3, 0::2] = gradient[:, 1]
            b[:, p, 3, 1::2] = gradient[:, 0]
            volume[:, p] = 2.0 * np.pi * radius * det
            dilatation[:, p] = b[:, p, :3].sum(axis=1)
        mean = (volume[:, :, None] * dilatation).sum(axis=1) / volume.sum(axis=1)[:, None]
        b[:, :, :3] += ((mean[:, None] - dilatation) / 3.0)[:, :, None]
        self.b, self.volume = b, volume
        dofs = np.stack([2 * self.nodes, 2 * self.nodes + 1], axis=-1).reshape(n, 8)
        self.dofs = dofs
        self.rows = np.repeat(dofs, 8, axis=1).ravel()
        self.columns = np.tile(dofs, (1, 8)).ravel()


class NotConverged(Exception):
    """A step is too long."""


class Indentation:
    """The coated half space, its plastic strain, and the contact."""

    def __init__(self, case: Case, per_radius: int):
        self.case, self.mesh = case, Mesh(case, per_radius)
        m = self.mesh

        def constant(name: str) -> np.ndarray:
            values = np.where(m.in_coat, getattr(case.coat, name), getattr(case.substrate, name))
            return np.repeat(values[:, None], 4, axis=1)

        young, poisson = constant("young"), constant("poisson")
        self.shear, self.bulk = young / (2 * (1 + poisson)), young / (3 * (1 - 2 * poisson))
        self.yield_stress, self.modulus = constant("yield_stress"), constant("modulus")
        self.size = 2 * len(m.r)
        self.u = np.zeros(self.size)
        self.plastic = np.zeros((len(m.nodes), 4, 4))  # strain; the last component is twice rz
        self.equivalent = np.zeros((len(m.nodes), 4))
        self.active = np.zeros(len(m.surface), dtype=bool)
        self.load = self.approach = 0.0
        self.scale = case.substrate.young * RADIUS * case.approach  # of forces [N]
        e, nu = case.substrate.young, case.substrate.poisson
        r, z = m.r[m.far], m.z[m.far]
        rho = np.hypot(r, z)
        factor = (1 + nu) / (2 * np.pi * e * rho)
        self.far_dofs = np.concatenate([2 * m.far, 2 * m.far + 1])
        self.far_per_load = np.concatenate(
            [factor * (r * z / rho**2 - (1 - 2 * nu) * r / (rho + z)), factor * (z**2 / rho**2 + 2 * (1 - nu))]
        )

    def stress(self, u: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray, np.ndarray]:
        """Stress, tangent, plastic strain and equivalent strain at displacements."""
        m = self.mesh
        strain = np.einsum("npij,nj->npi", m.b, u[m.dofs]) - self.plastic
        trace = strain[..., :3].sum(axis=-1)
        deviator = strain.copy()
        deviator[..., :3] -= trace[..., None] / 3.0
        deviator[..., 3] *= 0.5  # tensor component
        trial = 2.0 * self.shear[..., None] * deviator
        norm = np.sqrt((trial[..., :3] ** 2).sum(axis=-1) + 2.0 * trial[..., 3] ** 2)
        mises = np.sqrt(1.5) * norm
        excess = mises - self.yield_stress - self.modulus * self.equivalent
        flows = excess > 0.0
        added = np.where(flows, excess / (3.0 * self.shear + self.modulus), 0.0)
        safe = np.where(norm > 0.0, norm, 1.0)
        n = trial / safe[..., None]
        share = 1.0 - 3.0 * self.shear * added / np.where(mises > 0.0, mises, 1.0)
        sigma = share[..., None] * trial
        sigma[..., :3] += (self.bulk * trace)[..., None]
        identity = np.diag([1.0, 1.0, 1.0, 0.5])
        identity[:3, :3] -= 1.0 / 3.0
        ones = np.zeros((4, 4))
        ones[:3, :3] = 1.0
        softer = np.where(flows, 1.0 / (1.0 + self.modulus / (3.0 * self.shear)) - (1.0 - share), 0.0)
        tangent = (
            self.bulk[..., None, None] * ones
            + (2.0 * self.shear * share)[..., None, None] * identity
            - (2.0 * self.shear * softer)[..., None, None] * n[..., :, None] * n[..., None, :]
        )
        increment = np.sqrt(1.5) * added[..., None] * n
        increment[..., 3] *= 2.0
        return sigma, tangent, self.plastic + increment, self.equivalent + added

    def go(self, approach: float) -> None:
        """Moves the paraboloid to an approach, in smaller steps where Newton's method needs them."""
        active = self.active
        try:
            self.step(approach)
        except NotConverged:
            self.active = active
            if abs(approach - self.approach) < 1e-4 * self.case.approach:
                raise
            self.go(0.5 * (self.approach + approach))
            self.go(approach)

    def step(self, approach: float) -> None:
        """One step; nodes come into contact or leave it between solutions."""
        m = self.mesh
        target = approach - m.r[m.surface] ** 2 / (2.0 * RADIUS)  # where the surface may not be above, z downwards
        contact_dofs = 2 * m.surface + 1
        if not self.active.any():
            self.active = target > self.u[contact_dofs]
        start = self.u
        for _ in range(100):
            u, reaction, plastic, equivalent = self.solved(start, target)
            active = np.where(self.active, reaction > 0.0, target - u[contact_dofs] > 0.0)
            if (active == self.active).all():
                break
            self.active, start = active, u
        else:
            raise NotConverged(f"{self.case.name}: no contact found at {approach:g} m")
        self.u, self.plastic, self.equivalent, self.approach = u, plastic, equivalent, approach
        self.load = float(reaction[self.active].sum())

    def solved(self, u: np.ndarray, target: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray, np.ndarray]:
        """Displacements with the present nodes in contact, forces on the surface, and strains; by Newton's method."""
        m, contact_dofs = self.mesh, 2 * self.mesh.surface + 1
        u = u.copy()
        for iteration in range(40):
            sigma, tangent, plastic, equivalent = self.stress(u)
            force = np.bincount(
                m.dofs.ravel(), np.einsum("npij,npi,np->nj", m.b, sigma, m.volume).ravel(), minlength=self.size
            )
            reaction = force[contact_dofs]  # of the paraboloid on the nodes, downwards
            fixed = np.concatenate([2 * m.axis, contact_dofs[self.active], self.far_dofs])
            load = float(reaction[self.active].sum())
            values = np.concatenate([np.zeros(len(m.axis)), target[self.active], load * self.far_per_load])
            fixed, first = np.unique(fixed, return_index=True)
            free = np.ones(self.size, dtype=bool)
            free[fixed] = False
            moved = np.zeros(self.size)
            moved[fixed] = values[first] - u[fixed]
            residual = np.abs(force[free]).max() / self.scale
            if iteration and residual < 1e-10 and np.abs(moved).max() < 1e-8 * self.case.approach:
                return u, reaction, plastic, equivalent
            local = np.einsum("npij,npik,npkl,np->njl", m.b, tangent, m.b, m.volume, optimize=True)
            stiffness = coo_matrix((local.ravel(), (m.rows, m.columns)), shape=(self.size, self.size)).tocsc()
            right = -(force + stiffness @ moved)
            moved[free] = splu(stiffness[free][:, free]).solve(right[free])
            u += moved
        raise NotConverged(f"{self.case.name}: Newton's method does not converge, residual {residual:g}")

    def contact_radius(self) -> float:
        """Of the circle with the area that the touching nodes stand for."""
        r = self.mesh.r[self.mesh.surface]
        last = np.flatnonzero(self.active).max(initial=-1)
        return 0.0 if last < 0 else 0.5 * float(r[last] + r[last + 1])


def results(case: Case, per_radius: int, steps: int) -> list[float]:
    """The columns of the table, but for the name."""
    run = Indentation(case, per_radius)
    m = run.mesh
    for approach in np.linspace(0.0, case.approach, steps + 1)[1:]:
        run.go(float(approach))
    load, radius = run.load, run.contact_radius()
    for approach in np.linspace(case.approach, 0.0, steps + 1)[1:]:
        if run.active.any():
            run.go(float(approach))
    surface, coat = run.u[2 * m.surface + 1], m.in_coat
    amount = run.equivalent * m.volume
    return [
        load,
        radius,
        float(surface.max()),
        float(-surface.min()),
        float(run.equivalent[coat].max()),
        float(run.equivalent[~coat].max()),
        float(amount[coat].sum()),
        float(amount[~coat].sum()),
    ]


def main() -> None:
    """Prints the table."""
    per_radius = int(sys.argv[1]) if len(sys.argv) > 1 else 40
    print(",".join(("case", *COLUMNS)), flush=True)
    for case in CASES:
        print(",".join((case.name, *(f"{value:.6e}" for value in results(case, per_radius, 40)))), flush=True)


if __name__ == "__main__":
    main()
