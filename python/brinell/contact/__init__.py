# SPDX-License-Identifier: BSD-3-Clause
"""Non-adhesive contact of two elastic bodies, without and with friction.

grid = SurfaceGrid(65, 65, 1e-6, 1e-6)
ball = (grid.x**2 + grid.y**2) / (2 * 0.01)
result = ElasticContact(grid, Material("210 GPa", 0.3)).solve(ball, load=0.5)

`FrictionalContact` solves contact with Coulomb friction step by step, `TangentialContact` stick and slip under a given
bound of the shear. Periodic surfaces need SurfaceGrid(..., boundary="periodic").
"""

import sys

from brinell._arguments import explain_argument_errors
from brinell.contact.areas import Patches, contact_area, patches
from brinell.contact.friction import FrictionalContact, FrictionResult
from brinell.contact.normal import ContactResult, ElasticContact
from brinell.contact.tangential import TangentialContact, TangentialResult

__all__ = [
    "ContactResult",
    "ElasticContact",
    "FrictionResult",
    "FrictionalContact",
    "Patches",
    "TangentialContact",
    "TangentialResult",
    "contact_area",
    "patches",
]

explain_argument_errors(sys.modules[__name__])
