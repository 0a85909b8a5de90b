# SPDX-License-Identifier: BSD-3-Clause
"""Oracle of green/cuboid: mpmath quadrature of Kelvin's and Mindlin's point forces over the faces of a cuboid.

Writes tests/data/cuboid_oracle.csv with 22 digits. Run:  python tools/oracles/cuboid.py [--check]
Needs mpmath and sympy, and gmpy2 for speed (half an hour then). Independent of brinell's potentials: a uniform
eigenstrain in a region acts like the surface force t_p = C_pqmn eps_mn n_q on its boundary, so

    u_k(x) = integral over the faces of t_p G_kp(x, x') dS',    stress = C : (grad u - inside eps)

with G Kelvin's (1848) or Mindlin's (1936) displacement under a point force. --check verifies G itself: equilibrium,
traction-free surface and symmetry, all exact to working precision.
"""

import csv
import itertools
import sys
from pathlib import Path

import mpmath as mp
import sympy as sp

from quadrature import gauss_legendre

mp.mp.dps = 30
DIGITS = 22
OUTPUT = Path(__file__).resolve().parents[2] / "tests" / "data" / "cuboid_oracle.csv"
COMPONENTS = ("xx", "yy", "zz", "yz", "xz", "xy")
PAIRS = ((0, 0), (1, 1), (2, 2), (1, 2), (0, 2), (0, 1))

# kind, x, y, z, zc, dx, dy, dz, nu as decimal strings. Full space: the cuboid is at the origin (zc = 0).
POINTS = """
full 0 0 0 0 1 1 1 0.3
full 0.1 -0.2 0.15 0 1 1 1 0.3
full 0.2 0.3 -0.1 0 1 2 0.5 0.25
full 0.9 -0.8 0.7 0 1 1 1 0.3
full -1 0 0 0 1 1 1 0.3
full 0.5 1.5 0.5 0 1 1 1 0.32
full -1.2 0.1 -2.3 0 1.5 0.5 1 0.45
full 0 0 3 0 2 1 1 0
half 0.2 0.1 0.4 0.5 1 1 1 0.3
half 0.3 -0.2 1.1 1.5 1 1 2 0.3
half 1.3 0.7 0.4 0.5 1 1 1 0.3
half -1.3 0.7 1.9 0.5 1 1 1 0.32
half -0.8 -0.9 0.6 1.25 1 2 0.5 0.25
half 0 0 0.5 1.5 1 1 1 0.3
half 0 2 3 2 1 1 1 0.45
half 0.5 1.5 2 2 1 1 1 0
half 0.3 -0.4 0 1 1 1 1 0.3
half 1.1 0.2 0 0.75 1 0.5 0.5 0.32
half -2.5 3.5 0 1.5 1 1 1 0.1
"""


def green_tensor(kind):
    """16 pi mu (1 - nu) G_kp(x, x') as sympy expressions of x, y, z, u, v, w (point) and nu."""
    x, y, z, u, v, w, nu = sp.symbols("x y z u v w nu")
    d = (x - u, y - v)
    r2 = d[0] ** 2 + d[1] ** 2
    r = sp.sqrt(r2 + (z - w) ** 2)
    kappa = 3 - 4 * nu
    full = (d[0], d[1], z - w)
    g = sp.Matrix(3, 3, lambda k, p: (kappa if k == p else 0) / r + full[k] * full[p] / r**3)
    if kind == "full":
        return g
    h = z + w
    s = sp.sqrt(r2 + h**2)
    m = 4 * (1 - nu) * (1 - 2 * nu)
    for k, p in itertools.product(range(2), repeat=2):
        delta = 1 if k == p else 0
        g[k, p] += delta / s + kappa * d[k] * d[p] / s**3 + 2 * w * z / s**3 * (delta - 3 * d[k] * d[p] / s**2)
        g[k, p] += m / (s + h) * (delta - d[k] * d[p] / (s * (s + h)))
    for k in range(2):
        g[k, 2] += d[k] * (kappa * (z - w) / s**3 - m / (s * (s + h)) + 6 * w * z * h / s**5)
        g[2, k] += d[k] * (kappa * (z - w) / s**3 + m / (s * (s + h)) - 6 * w * z * h / s**5)
    g[2, 2] += (8 * (1 - nu) ** 2 - kappa) / s + (kappa * h**2 - 2 * w * z) / s**3 + 6 * w * z * h**2 / s**5
    return g


def compiled(kind):
    """Function of (x, y, z, u, v, w, nu): 9 values G_kp, then 27 gradients G_kp,l, times 16 pi mu (1 - nu)."""
    symbols = sp.symbols("x y z u v w nu")
    g = green_tensor(kind)
    values = list(g) + [sp.diff(e, symbols[axis]) for e in g for axis in range(3)]
    return sp.lambdify(symbols, values, "mpmath", cse=True)


def stiffness_times(strain, nu):
    """C : strain per mu, for a 3 x 3 list."""
    dilatation = 2 * nu / (1 - 2 * nu) * (strain[0][0] + strain[1][1] + strain[2][2])
    return [[2 * strain[i][j] + (dilatation if i == j else 0) for j in range(3)] for i in range(3)]


def unit_strain(component):
    i, j = PAIRS[component]
    strain = [[mp.mpf(0)] * 3 for _ in range(3)]
    strain[i][j] = strain[j][i] = mp.mpf(1)
    return strain


def breaks(centre, width, distance):
    """Face interval cut around the point's projection, geometrically in its distance from the face.

    The integrand's singularity then stays outside a Bernstein ellipse of parameter 4, so that a rule of order n errs by
    about 4^(-2n): 1e-29 for n = 24.
    """
    low, high = -width / 2, width / 2
    cuts = {low, high}
    if distance < width:
        for factor in (0, 1, 3, 9):
            cuts |= {c for c in (centre + factor * distance, centre - factor * distance) if low < c < high}
    return sorted(cuts)


def panel_points(cuts, rule):
    for a, b in zip(cuts, cuts[1:]):
        for t, weight in rule:
            yield (a + b) / 2 + (b - a) / 2 * t, weight * (b - a) / 2


def face_integrals(function, point, centre, sides, nu, rule):
    """n_q times the integrals over both faces of normal q of the 36 values of `function`, for q = 0, 1, 2."""
    result = []
    for q in range(3):
        sums = [mp.mpf(0)] * 36
        p, r = [axis for axis in range(3) if axis != q]
        for side in (-1, 1):
            plane = centre[q] + side * sides[q] / 2
            distance = abs(point[q] - plane)
            cuts = [breaks(point[a] - centre[a], sides[a], max(distance, sides[a] / 8)) for a in (p, r)]
            for s, ws in panel_points(cuts[0], rule):
                for t, wt in panel_points(cuts[1], rule):
                    source = [None] * 3
                    source[q], source[p], source[r] = plane, centre[p] + s, centre[r] + t
                    weight = side * ws * wt
                    for index, value in enumerate(function(*point, *source, nu)):
                        sums[index] += weight * value
        result.append(sums)
    return result


def inside(point, centre, sides):
    return all(abs(point[a] - centre[a]) < sides[a] / 2 for a in range(3))


def fields(integrals, component, is_inside, nu):
    """Stress per E (six components) and u_z for a unit eigenstrain component."""
    strain = unit_strain(component)
    force = stiffness_times(strain, nu)  # per mu
    factor = 1 / (16 * mp.pi * (1 - nu))
    gradient = [[mp.mpf(0)] * 3 for _ in range(3)]
    u_z = mp.mpf(0)
    for q, p in itertools.product(range(3), repeat=2):
        u_z += factor * force[p][q] * integrals[q][3 * 2 + p]
        for k, axis in itertools.product(range(3), repeat=2):
            gradient[k][axis] += factor * force[p][q] * integrals[q][9 + 3 * (3 * k + p) + axis]
    elastic = [
        [(gradient[i][j] + gradient[j][i]) / 2 - (strain[i][j] if is_inside else 0) for j in range(3)] for i in range(3)
    ]
    stress = stiffness_times(elastic, nu)
    return [stress[i][j] / (2 * (1 + nu)) for i, j in PAIRS] + [u_z]


def check():
    """Residuals of G: Navier's equation, traction at z = 0, reciprocity."""
    symbols = sp.symbols("x y z u v w nu")
    point = (sp.Rational(3, 10), sp.Rational(-7, 10), sp.Rational(4, 10), 0, 0, sp.Rational(11, 10))
    at = dict(zip(symbols, (*point, sp.Rational(3, 10))))
    for kind in ("full", "half"):
        g = green_tensor(kind)
        nu, axes = symbols[6], symbols[:3]
        worst = 0
        for p in range(3):
            u = [g[k, p] for k in range(3)]
            div = sum(sp.diff(u[k], axes[k]) for k in range(3))
            for k in range(3):
                navier = sum(sp.diff(u[k], a, 2) for a in axes) + sp.diff(div, axes[k]) / (1 - 2 * nu)
                worst = max(worst, abs(navier.subs(at).evalf(30)))
            if kind == "half":
                for k in range(3):
                    traction = sp.diff(u[k], axes[2]) + sp.diff(u[2], axes[k])
                    if k == 2:
                        traction += 2 * nu / (1 - 2 * nu) * div
                    worst = max(worst, abs(traction.subs({**at, axes[2]: 0}).evalf(30)))
        swap = dict(zip(symbols[:6], symbols[3:6] + symbols[:3]))
        for k, p in itertools.product(range(3), repeat=2):
            worst = max(worst, abs((g[k, p] - g[p, k].subs(swap, simultaneous=True)).subs(at).evalf(30)))
        print(kind, "largest residual", worst)


def main():
    if "--check" in sys.argv:
        check()
        return
    functions = {kind: compiled(kind) for kind in ("full", "half")}
    rule = gauss_legendre(24)
    with OUTPUT.open("w", newline="") as stream:
        writer = csv.writer(stream, lineterminator="\n")
        header = ["kind", "x", "y", "z", "zc", "dx", "dy", "dz", "nu", "eigenstrain"]
        writer.writerow(header + [f"{c}_per_E" for c in COMPONENTS] + ["u_z"])
        for line in POINTS.strip().splitlines():
            kind, *numbers = line.split()
            x, y, z, zc, dx, dy, dz, nu = (mp.mpf(n) for n in numbers)
            point, centre, sides = (x, y, z), (mp.mpf(0), mp.mpf(0), zc), (dx, dy, dz)
            integrals = face_integrals(functions[kind], point, centre, sides, nu, rule)
            for component in range(6):
                values = fields(integrals, component, inside(point, centre, sides), nu)
                writer.writerow(
                    [kind, *numbers, COMPONENTS[component]]
                    + [mp.nstr(mp.chop(v, tol=mp.mpf(10) ** -24), DIGITS) for v in values]
                )
            stream.flush()


if __name__ == "__main__":
    main()
