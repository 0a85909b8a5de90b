# SPDX-License-Identifier: BSD-3-Clause
"""Oracle of reference/hertz: mpmath quadrature of Boussinesq's point load over the Hertz pressure sqrt(1 - r^2).

Writes tests/data/hertz_oracle.csv with 20 digits. Run:  python tools/oracles/hertz.py
Contact radius and peak pressure are 1. The circle is covered with r = sin t, which makes the pressure smooth.
"""

import csv
from pathlib import Path

import mpmath as mp

from quadrature import gauss_legendre
from rectangle import point_load

mp.mp.dps = 26
DIGITS = 20
RINGS, ANGLES = 8, 320
OUTPUT = Path(__file__).resolve().parents[2] / "tests" / "data" / "hertz_oracle.csv"

# x, y, z, nu as decimal strings.
POINTS = """
0 0 0.5 0.3
0.3 0.2 0.5 0.3
-0.4 0.9 0.9 0
1.2 -0.5 0.3 0.25
0 1 0.4 0.32
0.6 -0.8 0.25 0.45
-2 -1.5 3 0.5
0.1 0 0.2 0.3
"""


def stress(x, y, z, nu, rule):
    """Gauss-Legendre over eight rings of t, trapezium rule over the angle: its error is about exp(-ANGLES z)."""
    sums = [mp.mpf(0)] * 6
    width = mp.pi / 2 / RINGS
    angles = [2 * mp.pi * k / ANGLES for k in range(ANGLES)]
    directions = [(mp.cos(a), mp.sin(a)) for a in angles]
    for ring in range(RINGS):
        for node, weight in rule:
            t = width * (ring + (1 + node) / 2)
            r = mp.sin(t)
            factor = weight * width / 2 * mp.cos(t) ** 2 * r * 2 * mp.pi / ANGLES
            for c, s in directions:
                for i, value in enumerate(point_load(x - r * c, y - r * s, z, nu)):
                    sums[i] += factor * value
    return sums


def main():
    rule = gauss_legendre(24)
    with OUTPUT.open("w", newline="") as stream:
        writer = csv.writer(stream, lineterminator="\n")
        writer.writerow(["x", "y", "z", "nu", "xx", "yy", "zz", "yz", "xz", "xy"])
        for line in POINTS.strip().splitlines():
            values = stress(*(mp.mpf(p) for p in line.split()), rule)
            writer.writerow(line.split() + [mp.nstr(mp.chop(v, tol=mp.mpf(10) ** -21), DIGITS) for v in values])
            stream.flush()


if __name__ == "__main__":
    main()
