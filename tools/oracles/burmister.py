# SPDX-License-Identifier: BSD-3-Clause
"""Oracle of layered half spaces under a round load: Burmister's integrals (1945) with 16 digits, by mpmath.

Writes tests/data/burmister_oracle.csv.  Run:  python tools/oracles/burmister.py
Needs mpmath. One bonded layer on a half space or on a rigid base carries the pressure (1 - r^2)^2 on the circle r < 1, whose Hankel
transform is 8 J3(k) / k^3. The waves are those of tools/oracles/stack.py, from all unknowns at once; they are integrated by
Gauss on intervals of half a period, once more with more points for the error. Poisson's ratios are 0.25 (layer) and 0.35, Young's
modulus of the substrate is 1. Displacement of the surface on the axis and at r = 1.5, and the stress on the axis as the mean over a
quarter of the layer's thickness above and beneath the interface.
"""

import csv
import itertools
from pathlib import Path

import mpmath as mp
import stack

DIGITS = 16
OUTPUT = Path(__file__).resolve().parents[2] / "tests" / "data" / "burmister_oracle.csv"
CONTRASTS = ("0.01", "0.1", "10", "100")
THICKNESSES = ("0.1", "1", "10")
COLUMNS = ("u_0", "u_15", "zz_above", "rr_above", "zz_below", "rr_below")
DEPTH_POINTS = 10


def gauss(points):
    """Points and weights on [0, 1]."""
    rule = []
    for i in range(points):
        x = mp.cos(mp.pi * (i + mp.mpf(3) / 4) / (points + mp.mpf(1) / 2))
        for _ in range(8):  # Newton on Legendre's polynomial
            slope = points * (x * mp.legendre(points, x) - mp.legendre(points - 1, x)) / (x * x - 1)
            x -= mp.legendre(points, x) / slope
        rule.append(((1 + x) / 2, 1 / ((1 - x * x) * slope * slope)))
    return rule


def axis_stress(at, layer, z0, z1, nu, depths):
    """Mean zz and rr on the axis; tt = nu (ll + zz), and rr is the mean of ll and tt over all directions of the wavevector."""
    zz = rr = mp.mpf(0)
    for t, w in depths:
        _, _, _, szz, sll = at(layer, z0 + t * (z1 - z0))
        zz += w * szz
        rr += w * (sll + nu * (sll + szz)) / 2
    return zz, rr


def integrand(body, h, nu1, nu2, compliance, k, depths):
    """All columns for one wavenumber, times the transform of the pressure and k. The displacement is less that of the layer's material."""
    with mp.workdps(30 + int(k * h)):
        at = stack.solve(body, k, (0, -1))
        u = +at(0, mp.mpf(0))[1] - compliance / k
        values = [*axis_stress(at, 0, h * 3 / 4, h, nu1, depths)]
        values += [mp.mpf(0)] * 2 if body[1][0] == "inf" else axis_stress(at, 1, mp.mpf(0), h / 4, nu2, depths)
    load = 8 * mp.besselj(3, k) / k**3 * k
    return [load * v for v in (u, u * mp.besselj(0, k * mp.mpf(3) / 2), *values)]


def of_half_space(compliance, r):
    """Displacement of a homogeneous surface: the integral of 8 J3(k) J0(k r) / k^3 (Sonine, Schafheitlin: hypergeometric)."""
    half = mp.mpf(1) / 2
    if r <= 1:
        return compliance * 8 * mp.gamma(half) / (8 * mp.gamma(mp.mpf(7) / 2)) * mp.hyp2f1(half, -5 * half, 1, r * r)
    return compliance * 8 / r * mp.gamma(half) / (2**3 * mp.gamma(half) * mp.gamma(4)) * mp.hyp2f1(half, half, 4, 1 / (r * r))


def integrals(base, contrast, thickness, points):
    """The columns, with `points` points an interval."""
    h, nu1, nu2 = mp.mpf(thickness), mp.mpf(1) / 4, mp.mpf("0.35")
    E1 = mp.mpf(contrast)
    body = ([(thickness, contrast, "0.25")], ("inf", "0") if base == "rigid" else ("1", "0.35"))
    compliance = 2 * (1 - nu1 * nu1) / E1
    rule, depths = gauss(points), gauss(DEPTH_POINTS)
    end = 42 / h  # e^{-42 3/4} above the interface of the mean at 3/4 h, times a load that falls as k^-2.5
    total = [mp.mpf(0)] * len(COLUMNS)
    low, high = mp.mpf(0), mp.mpf("1e-3") / max(h * max(E1, 1 / E1), 1)
    while low < end:
        for t, w in rule:
            values = integrand(body, h, nu1, nu2, compliance, low + t * (high - low), depths)
            total = [s + w * (high - low) * v for s, v in zip(total, values, strict=True)]
        low, high = high, high + min(high, mp.pi / 2, 2 / h)
    for column, r in ((0, mp.mpf(0)), (1, mp.mpf(3) / 2)):
        total[column] += of_half_space(compliance, r)
    return total


def main():
    """Write all bodies."""
    mp.mp.dps = 25
    rows = []
    bodies = [("half_space", c, h) for c, h in itertools.product(CONTRASTS, THICKNESSES)]
    bodies += [("rigid", "1", h) for h in THICKNESSES]
    for base, contrast, thickness in bodies:
        coarse, fine = (integrals(base, contrast, thickness, points) for points in (8, 12))
        error = max(abs(a - b) / (abs(b) + mp.mpf("1e-6")) for a, b in zip(coarse, fine, strict=True))
        print(base, contrast, thickness, "error", mp.nstr(error, 3), flush=True)
        rows.append([base, contrast, thickness, *(mp.nstr(v, DIGITS) for v in fine)])
    with OUTPUT.open("w", newline="") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(["base", "contrast", "thickness", *COLUMNS])
        writer.writerows(rows)


if __name__ == "__main__":
    main()
