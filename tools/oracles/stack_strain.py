# SPDX-License-Identifier: BSD-3-Clause
"""Oracle of green/stack_strain: waves of eigenstrain in layered bodies with 30 digits, by mpmath.

Writes tests/data/stack_strain_oracle.csv.  Run:  python tools/oracles/stack_strain.py
Needs mpmath. The layer with the strain is cut at the ends of the strain. Within the strained part, a displacement
that does not vary with depth balances the forces of the strain; the waves of all parts, cosh and sinh of the depth as
in stack.py, make displacement and traction continuous and the surface free. Neither sheets of strain nor reflections of
brinell are used.
"""

import csv
from pathlib import Path

import mpmath as mp
from stack import STACKS, across_rows, decaying, elastic_rows

mp.mp.dps = 60
DIGITS = 30
TINY = mp.mpf("1e-40")  # rounding where the value is zero
OUTPUT = Path(__file__).resolve().parents[2] / "tests" / "data" / "stack_strain_oracle.csv"
WAVENUMBERS = ("0.01", "0.5", "2", "15")
# Layer, and where in it the strain begins and ends: fractions of its thickness, or depths in the substrate.
SOURCES = {
    "soft_on_hard": [(0, "0", "0.25"), (0, "0.5", "1"), (1, "0.5", "0.75")],
    "hard_on_soft": [(0, "0.25", "0.75"), (1, "0", "0.5")],
    "on_rigid": [(0, "0.25", "0.5"), (0, "0.75", "1")],
    "three_layers": [(0, "0", "1"), (1, "0.25", "0.5"), (2, "0", "0.5"), (3, "0.1", "0.3")],
}
PLANE = ("ll", "tt", "zz", "lz")
ACROSS = ("lt", "tz")


def particular(component, nu, mu, k):
    """Displacement and stress of a strain that is uniform in depth, in the rows of stack.py, and sigma_tt.

    The strain lz, and lt, is times i: then the numbers are real. div(C grad u) = div(C strain).
    """
    lame = 2 * mu * nu / (1 - 2 * nu)
    held = {c: mp.mpf(0) for c in ("ll", "tt", "zz", "lz", "lt", "tz")}  # C : strain
    if component in ("ll", "tt", "zz"):
        for c in ("ll", "tt", "zz"):
            held[c] = lame + (2 * mu if c == component else 0)
    else:
        held[component] = 2 * mu  # lz and lt times i
    if component in ACROSS:
        # -mu k^2 u_t = i k sigma*_lt, sigma*_lt = i held: u_t is real.
        u = held["lt"] / (mu * k)
        return (u, -held["tz"], mu * k * u - held["lt"])
    # -(lame + 2 mu) k^2 u_l = i k sigma*_ll: u_l = i U. -mu k^2 u_z = i k sigma*_lz with sigma*_lz = i held.
    U = -held["ll"] / ((lame + 2 * mu) * k)
    V = held["lz"] / (mu * k)
    ll = -k * U  # strain
    return (
        U,
        V,
        mu * k * V - held["lz"],
        lame * ll - held["zz"],
        (lame + 2 * mu) * ll - held["ll"],
        lame * ll - held["tt"],
    )


def solve(stack, k, source, component):
    """Function of part and depth in it, and the parts as (layer, thickness)."""
    layers, (E0, nu0) = stack
    plane = component in PLANE
    layer, begin, end = source
    media = [(mp.mpf(h), mp.mpf(E), mp.mpf(nu)) for h, E, nu in layers] + [(mp.inf, mp.mpf(E0), mp.mpf(nu0))]
    rigid = mp.isinf(media[-1][1])
    parts = []  # layer, depth of its top in the layer, thickness, whether it is strained
    for j, (h, _, _) in enumerate(media):
        if j != layer:
            parts.append((j, mp.mpf(0), h, False))
            continue
        scale = 1 if mp.isinf(h) else h
        cuts = [mp.mpf(0), mp.mpf(begin) * scale, mp.mpf(end) * scale, h]
        for n in range(3):
            if cuts[n + 1] > cuts[n]:
                parts.append((j, cuts[n], cuts[n + 1] - cuts[n], n == 1))

    def columns(p, z):
        _, E, nu = media[parts[p][0]]
        mu = E / (2 * (1 + nu))
        found = elastic_rows(nu, mu, k, z) if plane else across_rows(mu, k, z)
        return decaying(found) if mp.isinf(parts[p][2]) else found

    def added(p):
        _, E, nu = media[parts[p][0]]
        if not parts[p][3]:
            return (mp.mpf(0),) * 6
        return particular(component, nu, E / (2 * (1 + nu)), k)

    used = parts[:-1] if rigid else parts
    sizes = [len(columns(p, mp.mpf(0))) for p in range(len(used))]
    starts = [sum(sizes[:p]) for p in range(len(used))]
    n, states = sum(sizes), 4 if plane else 2
    A, b = mp.zeros(n, n), mp.zeros(n, 1)
    row = 0
    for t in range(states // 2):
        for w, wave in enumerate(columns(0, mp.mpf(0))):
            A[row, w] = wave[states // 2 + t]
        b[row] = -added(0)[states // 2 + t]
        row += 1
    for p in range(len(parts) - 1):
        above = columns(p, parts[p][2])
        is_base = rigid and p == len(parts) - 2
        below = [] if is_base else columns(p + 1, mp.mpf(0))
        for s in range(states // 2 if is_base else states):
            for w, wave in enumerate(above):
                A[row, starts[p] + w] = wave[s]
            for w, wave in enumerate(below):
                A[row, starts[p + 1] + w] = -wave[s]
            b[row] = -added(p)[s] + (0 if is_base else added(p + 1)[s])
            row += 1
    x = mp.lu_solve(A, b)

    def at(p, z):
        waves = columns(p, mp.mpf(z))
        values = [sum(x[starts[p] + w] * wave[i] for w, wave in enumerate(waves)) for i in range(len(waves[0]))]
        if plane:
            values.append(media[parts[p][0]][2] * (values[3] + values[4]))
        return [v + a for v, a in zip(values, added(p), strict=False)]

    return at, used


def main():
    """Write all waves of all stacks."""
    rows = []
    for name, stack in STACKS.items():
        for source in SOURCES[name]:
            for k in WAVENUMBERS:
                for component in PLANE + ACROSS:
                    with mp.workdps(60 + int(20 * float(k))):
                        at, parts = solve(stack, mp.mpf(k), source, component)
                        for p, (layer, top, thickness, _) in enumerate(parts):
                            z = mp.mpf("0.3") * (mp.mpf("0.5") if mp.isinf(thickness) else thickness)
                            places = [z] if p > 0 else [mp.mpf(0), z]
                            for place in places:
                                values = [mp.nstr(mp.chop(v, TINY), DIGITS) for v in at(p, place)]
                                rows.append(
                                    [
                                        name,
                                        *source,
                                        k,
                                        component,
                                        layer,
                                        mp.nstr(top + place, 20),
                                        *values,
                                        *[""] * (6 - len(values)),
                                    ]
                                )
    with OUTPUT.open("w", newline="") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(
            [
                "stack",
                "source",
                "begin",
                "end",
                "k",
                "component",
                "layer",
                "depth_in_layer",
                *[f"v{i}" for i in range(6)],
            ]
        )
        writer.writerows(rows)


if __name__ == "__main__":
    main()
