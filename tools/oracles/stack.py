# SPDX-License-Identifier: BSD-3-Clause
"""Oracle of green/stack: waves and point loads on layered bodies with 30 digits, by mpmath.

Writes tests/data/stack_oracle.csv.  Run:  python tools/oracles/stack.py
Needs mpmath. In each layer the displacements are written with cosh and sinh of the depth, so that all waves of all layers
are the unknowns of one linear system, which is solved with digits enough for their growth: neither the decaying waves nor
the reflections of brinell are used. Burmister (1945) has the same integrals for a layer on a half space.
"""

import csv
from pathlib import Path

import mpmath as mp

mp.mp.dps = 60
DIGITS = 30
OUTPUT = Path(__file__).resolve().parents[2] / "tests" / "data" / "stack_oracle.csv"

# Layers as (thickness, E, nu) from the surface down, and the substrate as (E, nu); E = inf is a rigid base.
STACKS = {
    "soft_on_hard": ([("1", "1", "0.4")], ("10", "0.3")),
    "hard_on_soft": ([("0.5", "4", "0.2")], ("1", "0.3")),
    "on_rigid": ([("1", "1", "0.3")], ("inf", "0")),
    "three_layers": ([("0.2", "3", "0.25"), ("0.7", "0.5", "0.45"), ("0.1", "8", "0.1")], ("2", "0.3")),
}
WAVENUMBERS = ("0.001", "0.1", "1", "3", "20")


def elastic_rows(nu, mu, k, z):
    """u_l / i, u_z, sigma_lz / i, sigma_zz, sigma_ll of four waves at the depth z.

    2 mu u = grad(phi + z psi) - 4 (1 - nu) psi e_z with harmonic phi and psi (Papkovich, Neuber): a cosh or a sinh.
    """
    c, s, q = mp.cosh(k * z), mp.sinh(k * z), 3 - 4 * nu
    waves = (
        (k * c, k * s, k * k * s, k * k * c),
        (k * s, k * c, k * k * c, k * k * s),
        (k * z * c, k * z * s - q * c, k * (c + k * z * s), k * s + k * k * z * c - q * k * s),
        (k * z * s, k * z * c - q * s, k * (s + k * z * c), k * c + k * k * z * s - q * k * c),
    )
    rows = []
    for U, V, dU, dV in waves:
        trace = dV - k * U  # with u_l = i U the strain ll is -k U, and 2 eps_lz = i (U' + k V)
        lame = 2 * mu * nu / (1 - 2 * nu)
        rows.append((U, V, mu * (dU + k * V), lame * trace + 2 * mu * dV, lame * trace - 2 * mu * k * U))
    return rows


def across_rows(mu, k, z):
    """u_t, sigma_tz, sigma_lt / i of the two waves across the wavevector."""
    c, s = mp.cosh(k * z), mp.sinh(k * z)
    return [(c, mu * k * s, mu * k * c), (s, mu * k * c, mu * k * s)]


def decaying(columns):
    """Waves that vanish at infinite depth: cosh - sinh in pairs."""
    half = len(columns) // 2
    pairs = [(0, 1)] if half == 1 else [(0, 1), (2, 3)]
    return [tuple(a - b for a, b in zip(columns[i], columns[j], strict=True)) for i, j in pairs]


def solve(stack, k, traction):
    """Function of layer and depth in it: displacement and stress of a wave of traction on the surface.

    traction: (sigma_lz / i, sigma_zz) at the surface, or sigma_tz alone.
    """
    layers, (E0, nu0) = stack
    plane = len(traction) == 2
    media = [(mp.mpf(h), mp.mpf(E), mp.mpf(nu)) for h, E, nu in layers] + [(mp.inf, mp.mpf(E0), mp.mpf(nu0))]
    rigid = mp.isinf(media[-1][1])

    def columns(j, z):
        _, E, nu = media[j]
        mu = E / (2 * (1 + nu))
        found = elastic_rows(nu, mu, k, z) if plane else across_rows(mu, k, z)
        return decaying(found) if j == len(media) - 1 else found

    used = media[:-1] if rigid else media
    sizes = [len(columns(j, mp.mpf(0))) for j in range(len(used))]
    starts = [sum(sizes[:j]) for j in range(len(used))]
    n = sum(sizes)
    A, b = mp.zeros(n, n), mp.zeros(n, 1)
    states = 4 if plane else 2
    row = 0
    for t, value in enumerate(traction):
        for w, wave in enumerate(columns(0, mp.mpf(0))):
            A[row, w] = wave[(2 if plane else 1) + t]
        b[row] = value
        row += 1
    for j in range(len(media) - 1):
        above = columns(j, media[j][0])
        below = [] if rigid and j == len(media) - 2 else columns(j + 1, mp.mpf(0))
        for s in range(states if below else states // 2):
            for w, wave in enumerate(above):
                A[row, starts[j] + w] = wave[s]
            for w, wave in enumerate(below):
                A[row, starts[j + 1] + w] = -wave[s]
            row += 1
    x = mp.lu_solve(A, b)

    def at(j, z):
        waves = columns(j, mp.mpf(z))
        return [sum(x[starts[j] + w] * wave[i] for w, wave in enumerate(waves)) for i in range(len(waves[0]))]

    return at


def main():
    """Write all waves of all stacks."""
    rows = []
    for name, stack in STACKS.items():
        count = len(stack[0])
        for k in WAVENUMBERS:
            for load, traction in (("pressure", (0, -1)), ("along", (1, 0)), ("across", (-1,))):
                with mp.workdps(60 + int(20 * float(k))):
                    at = solve(stack, mp.mpf(k), traction)
                    # In the middle of each layer, and in the substrate as deep as the first layer is thick.
                    places = [(j, mp.mpf(stack[0][j][0]) / 2) for j in range(count)]
                    if stack[1][0] != "inf":
                        places.append((count, mp.mpf(stack[0][0][0])))
                    for j, z in [(0, mp.mpf(0)), *places]:
                        values = [mp.nstr(v, DIGITS) for v in at(j, z)]
                        rows.append([name, load, k, j, mp.nstr(z, 10), *values, *[""] * (5 - len(values))])
    with OUTPUT.open("w", newline="") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(["stack", "load", "k", "layer", "depth_in_layer", "v0", "v1", "v2", "v3", "v4"])
        writer.writerows(rows)


if __name__ == "__main__":
    main()
