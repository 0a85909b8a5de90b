# SPDX-License-Identifier: BSD-3-Clause
"""Height maps of surfaces: generation, reading, preparation, roughness parameters, and use as textures of bodies.

    dent = brinell.surfaces.read("dent.xyz").levelled().cropped(x=(-1e-4, 1e-4))
    case = brinell.Case.from_file("case.toml").with_values({"lower.texture": dent})

    rough = brinell.surfaces.random("1 mm", 512, rms_height="0.5 um", rolloff="200 um", cutoff="16 um")
    print(rough.Sq, rough.Sdq, rough.Sku)

Reading files of measuring instruments needs SurfaceTopography (pip install "brinell[surfaces]").
"""

from __future__ import annotations

import sys

from brinell._arguments import explain_argument_errors, explain_errors_of
from brinell.surfaces.files import read, write
from brinell.surfaces.filling import filled
from brinell.surfaces.heightmap import HeightMap, PowerSpectrum
from brinell.surfaces.making import random, sampled

__all__ = ["HeightMap", "PowerSpectrum", "filled", "random", "read", "sampled", "write"]

explain_errors_of(HeightMap, "brinell.HeightMap")  # as users call it
explain_argument_errors(sys.modules[__name__])
