# SPDX-License-Identifier: BSD-3-Clause
"""Oracle of green/rectangle: mpmath quadrature of Boussinesq's point load over a uniformly loaded rectangle.

Writes tests/data/rectangle_oracle.csv with 25 digits. Run:  python tools/oracles/rectangle.py
Needs mpmath; takes some minutes. Nothing of brinell's closed forms is used here: the integrand is the stress under a
point load (Boussinesq 1885; Johnson 1985, Eq. 3.20, written without the removable singularity at r = 0).
"""

import csv
from pathlib import Path

import mpmath as mp

mp.mp.dps = 34
DIGITS = 25
OUTPUT = Path(__file__).resolve().parents[2] / "tests" / "data" / "rectangle_oracle.csv"

# x, y, z, dx, dy, nu as decimal strings: inside, edge lines, corner lines, each quadrant, far away, oblong cells.
POINTS = """
0 0 0.5 1 1 0.28
0 0 2.5 1 1 0.28
0.1 -0.2 0.3 1 1 0.3
0.5 0.1 0.4 1 1 0.3
0.5 0.5 0.7 1 1 0.3
-0.5 0.5 0.2 1 1 0.3
0.2 -0.5 0.25 1 1 0
1.3 0.7 0.4 1 1 0.25
-1.3 0.7 0.4 1 1 0.25
-1.3 -0.7 0.4 1 1 0.25
1.3 -0.7 0.4 1 1 0.25
1.5 0.5 0.6 3 1 0.32
-0.7 0.9 1.1 0.5 2 0.5
3.85 7.7 0.9625 3.85 7.7 0.32
20 -13 4 1 1 0.3
0 40 25 1 2 0.3
2 1 0.01 1 1 0.3
0.15 0.05 0.01 1 1 0.3
2 1 0 1 1 0.3
-1 -3 0 1 1 0.1
"""


def point_load(x, y, z, nu):
    """Stress (xx, yy, zz, yz, xz, xy) under a unit normal point load at the origin, tension positive."""
    rho = mp.sqrt(x * x + y * y + z * z)
    b = 1 - 2 * nu
    shared = z / rho**3 - 1 / (rho * (rho + z))
    tail = (2 * rho + z) / (rho**3 * (rho + z) ** 2)
    direct = -3 * z / rho**5
    values = (
        direct * x * x + b * (shared + tail * x * x),
        direct * y * y + b * (shared + tail * y * y),
        direct * z * z,
        direct * y * z,
        direct * x * z,
        direct * x * y + b * tail * x * y,
    )
    return [v / (2 * mp.pi) for v in values]


def breaks(centre, width, depth):
    """Interval [-w/2, w/2] cut geometrically around the nearest point of the peak."""
    low, high = -width / 2, width / 2
    cuts = {low, high}
    step = max(depth, width / 64)
    if depth > 0:
        for factor in (0, 1, 3, 9, 27):
            for sign in (-1, 1):
                cut = centre + sign * factor * step
                if low < cut < high:
                    cuts.add(cut)
    return sorted(cuts)


def integrate(function, x, y, z, dx, dy):
    return mp.quad(function, breaks(x, dx, z), breaks(y, dy, z), method="gauss-legendre")


def rectangle(x, y, z, dx, dy, nu):
    """The six stress components and the integral of 1/rho (only regular points are asked for)."""
    stress = [
        integrate(lambda u, v, c=c: point_load(x - u, y - v, z, nu)[c], x, y, z, dx, dy) for c in range(6)
    ]
    potential = integrate(lambda u, v: 1 / mp.sqrt((x - u) ** 2 + (y - v) ** 2 + z * z), x, y, z, dx, dy)
    return stress + [potential]


def main():
    with OUTPUT.open("w", newline="") as stream:
        writer = csv.writer(stream, lineterminator="\n")
        writer.writerow(["x", "y", "z", "dx", "dy", "nu", "xx", "yy", "zz", "yz", "xz", "xy", "integral_1_over_r"])
        for line in POINTS.strip().splitlines():
            point = line.split()
            values = rectangle(*(mp.mpf(p) for p in point))
            writer.writerow(point + [mp.nstr(mp.chop(v, tol=mp.mpf(10) ** -28), DIGITS) for v in values])
            stream.flush()


if __name__ == "__main__":
    main()
