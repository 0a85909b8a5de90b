# SPDX-License-Identifier: BSD-3-Clause
"""Quadrature shared by the oracles."""

import mpmath as mp


def gauss_legendre(order):
    """Nodes and weights on [-1, 1] as pairs, by Newton's method on the recurrence, with 15 digits to spare."""
    with mp.workdps(mp.mp.dps + 15):
        return _gauss_legendre(order)


def _gauss_legendre(order):
    nodes = []
    for i in range(order):
        t = mp.cos(mp.pi * (i + mp.mpf(3) / 4) / (order + mp.mpf(1) / 2))
        for _ in range(9):  # quadratic from four digits on
            p0, p1 = mp.mpf(1), t
            for n in range(2, order + 1):
                p0, p1 = p1, ((2 * n - 1) * t * p1 - (n - 1) * p0) / n
            slope = order * (t * p1 - p0) / (t * t - 1)
            t -= p1 / slope
        nodes.append((t, 2 / ((1 - t * t) * slope**2)))
    return nodes
