# SPDX-License-Identifier: BSD-3-Clause
import numpy as np
import pytest

from brinell.reference import elastic_tugging_forces, elastic_tugging_reach

ALPHA_C = 2.214290e-4  # R1 = R2 = 1 m, E = 200 GPa, nu = 0.32, S_y = 0.9115 GPa


@pytest.mark.parametrize(
    ("alpha", "slope", "peak", "position", "aligned"),
    [
        (1, 0.01488, 0.00483, -0.02976, 1.000),
        (4, 0.02977, 0.07733, -0.05951, 8.000),
        (9, 0.04467, 0.39156, -0.08923, 27.000),
        (15, 0.05770, 1.08790, -0.11516, 58.095),
    ],
)
def test_elastic_limit(alpha: float, slope: float, peak: float, position: float, aligned: float) -> None:
    """Exact values, given to five digits: half a unit of the last one is the tolerance."""
    geometry = (1.0, 1.0, alpha * ALPHA_C)
    reach = elastic_tugging_reach(*geometry)
    assert reach / (2.0 - alpha * ALPHA_C) == pytest.approx(slope, abs=0.6e-5)
    X = np.linspace(-reach, reach, 200001)
    f_x, f_z = elastic_tugging_forces(X, *geometry, ALPHA_C)
    assert f_x.max() == pytest.approx(peak, abs=0.6e-5)
    assert X[f_x.argmax()] / 0.5 == pytest.approx(position, abs=1e-5)
    assert f_z[100000] == pytest.approx(aligned, abs=0.6e-3)
    np.testing.assert_allclose(f_x, -f_x[::-1], atol=1e-12 * aligned)  # nothing is lost
    np.testing.assert_allclose(f_z, f_z[::-1], atol=1e-12 * aligned)


def test_no_force_without_overlap() -> None:
    reach = elastic_tugging_reach(1.0, 2.0, 1e-3)
    f_x, f_z = elastic_tugging_forces([-1.1 * reach, 1.1 * reach], 1.0, 2.0, 1e-3, 1e-4)
    assert not np.any(f_x)
    assert not np.any(f_z)
