#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Oracle of simulation/random_surface: heights at a few places, for the test RandomSurface.IsTheSameOnEveryMachine.

Written from the definitions alone, without a line of the engine: Matsumoto and Nishimura's mt19937_64, the normal
numbers of Box and Muller, the rings of wavevectors, the spectrum, the sum of cosines. Prints the heights.
Run:  python tools/oracles/random_surface.py
"""

import cmath
import math
from collections.abc import Iterator

SEED = 5
HURST, RMS_HEIGHT = 0.7, 2e-7
ROLLOFF, CUTOFF = 60e-6, 7e-6
SIZE_X, SIZE_Y = 240e-6, 180e-6
PLACES = [(0.0, 0.0), (1e-5, 2e-5), (-7.7e-5, 3.1e-5), (1.2e-4, -9e-5)]

MASK = (1 << 64) - 1


def mt19937_64(seed: int) -> Iterator[int]:
    """The integers of std::mt19937_64."""
    n, m = 312, 156
    state = [seed]
    for i in range(1, n):
        state.append((6364136223846793005 * (state[-1] ^ (state[-1] >> 62)) + i) & MASK)
    while True:
        for i in range(n):
            x = (state[i] & 0xFFFFFFFF80000000) | (state[(i + 1) % n] & 0x7FFFFFFF)
            state[i] = state[(i + m) % n] ^ (x >> 1) ^ (0xB5026F5AA96619E9 if x & 1 else 0)
        for x in state:
            x ^= (x >> 29) & 0x5555555555555555
            x ^= (x << 17) & 0x71D67FFFEDA60000
            x ^= (x << 37) & 0xFFF7EEE000000000
            yield x ^ (x >> 43)


def rings(count: int) -> Iterator[tuple[int, int]]:
    """One of each pair of opposite wavevectors."""
    for r in range(1, count + 1):
        yield from ((i, -r) for i in range(1, r + 1))
        yield from ((r, j) for j in range(1 - r, r))
        yield from ((i, r) for i in range(r + 1))


def main() -> None:
    """Prints the heights [m]."""
    integers = mt19937_64(SEED)

    def uniform() -> float:
        return ((next(integers) >> 11) + 1) * 2.0**-53

    waves = {}
    for i, j in rings(max(int(SIZE_X / CUTOFF), int(SIZE_Y / CUTOFF))):
        radius = math.sqrt(-2.0 * math.log(uniform()))
        drawn = cmath.rect(radius, 2.0 * math.pi * uniform())
        frequency = math.hypot(i / SIZE_X, j / SIZE_Y)
        if frequency <= 1.0 / CUTOFF:
            waves[i, j] = max(frequency, 1.0 / ROLLOFF) ** (-1.0 - HURST) * drawn
    scale = RMS_HEIGHT / math.sqrt(0.5 * math.fsum(abs(c) ** 2 for c in waves.values()))
    for x, y in PLACES:
        terms = [(c * cmath.exp(2j * math.pi * (i * x / SIZE_X + j * y / SIZE_Y))).real for (i, j), c in waves.items()]
        print(f"{scale * math.fsum(terms):.17g}")


if __name__ == "__main__":
    main()
