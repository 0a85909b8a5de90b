# SPDX-License-Identifier: BSD-3-Clause
"""A material: elastic constants, yielding, thermal and electrical constants."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, fields
from functools import cached_property
from typing import Any

from brinell import _core
from brinell._tables import Hardening, Quantity, Softening
from brinell._values import plain
from brinell.errors import InputError
from brinell.materials.checking import case_of
from brinell.materials.electrical import Electrical
from brinell.materials.fatigue import FatigueConstants
from brinell.materials.hardening import Table
from brinell.materials.profiles import Profile, columns_of, terms_of
from brinell.materials.sampling import Law
from brinell.materials.thermal import Thermal

__all__ = ["RIGID", "Material"]


@dataclass(frozen=True)
class Material:
    """A linear elastic material, which is elastic-plastic if it has a hardening law.

    Attributes:
        young_modulus: Young's modulus E, > 0 [Pa].
        poisson_ratio: Poisson's ratio nu, in (-1, 0.5) [-].
        hardening: isotropic hardening law, which gives the size of the yield surface; None: the body stays elastic. A
            function sigma_y(e) is converted by `Table.of`, up to a strain of 1.
        back_stresses: kinematic hardening as pairs (modulus C [Pa], recall gamma [-]),
            d alpha = 2/3 C d eps - gamma alpha d e (Armstrong, Frederick 1966; Chaboche 1986; gamma = 0: Prager 1956).
        yield_profile: factors on the yield stress over the depth, linear between the depths, constant beyond: points
            [(depth [m], factor [-]), ...], {"depth": [...], "factor": [...]}, or columns (depths, factors). The
            attribute has columns.
        initial_stress: stresses xx = yy before the first load, positive in tension: points [(depth [m], stress [Pa]),
            ...], {"depth": [...], "value": [...]}, or columns (depths, stresses). The attribute has columns.
        thermal: thermal constants; None: no heat is computed in the body.
        softening: law of thermal softening of the yield stress; None: no softening.
        electrical: electrical constants; None: the body insulates.
        fatigue: criterion and constants of fatigue; None: no fatigue is computed in the body.

    Raises:
        InputError: hardening, thermal, softening, electrical or fatigue is of another type, or a profile can be read
            in two ways. Other values are checked when the material is used.
    """

    young_modulus: Quantity
    poisson_ratio: float
    hardening: Hardening | Law | None = None
    back_stresses: Sequence[tuple[Quantity, float] | Mapping[str, Any]] = ()
    yield_profile: Profile | None = None
    initial_stress: Profile | None = None
    thermal: Thermal | None = None
    softening: Softening | None = None
    electrical: Electrical | None = None
    fatigue: FatigueConstants | None = None

    def __post_init__(self) -> None:
        law = self.hardening
        if isinstance(law, type) or not (law is None or isinstance(law, Hardening) or callable(law)):
            raise InputError(
                f"hardening = {law!r}; allowed: a law, as brinell.Perfect('600 MPa'), a function sigma_y(e), or None"
            )
        if callable(law):
            object.__setattr__(self, "hardening", Table.of(law))
        if not (self.thermal is None or isinstance(self.thermal, Thermal)):
            raise InputError(f"thermal = {self.thermal!r}; allowed: brinell.Thermal(...), or None")
        if not (self.softening is None or isinstance(self.softening, Softening)):
            raise InputError(
                f"softening = {self.softening!r}; allowed: a law, as brinell.JohnsonCook(1500, 1.0), or None"
            )
        if not (self.electrical is None or isinstance(self.electrical, Electrical)):
            raise InputError(f"electrical = {self.electrical!r}; allowed: brinell.Electrical(...), or None")
        if not (self.fatigue is None or isinstance(self.fatigue, FatigueConstants)):
            raise InputError(f"fatigue = {self.fatigue!r}; allowed: brinell.FatigueConstants('dang_van', ...), or None")
        object.__setattr__(self, "back_stresses", terms_of(self.back_stresses))
        for name, value in (("yield_profile", "factor"), ("initial_stress", "value")):
            if (profile := getattr(self, name)) is not None:
                object.__setattr__(self, name, columns_of(profile, name, value))

    @property
    def is_rigid(self) -> bool:
        """Whether the body does not deform at all."""
        return self.young_modulus == math.inf

    def to_case(self) -> dict[str, Any]:
        """The table `material` of the case file, as nested dictionaries."""
        if self.is_rigid:
            return {"rigid": True} | self._tables_of_constants(lambda key, value: key != "expansion" or value != 0.0)
        table = {"young_modulus": plain(self.young_modulus), "poisson_ratio": plain(self.poisson_ratio)}
        if isinstance(self.hardening, Hardening):
            table["hardening"] = self.hardening.to_case()
        if self.back_stresses:
            terms = [{"modulus": modulus, "recall": recall} for modulus, recall in self.back_stresses]
            table.setdefault("hardening", {})["back_stresses"] = terms
        for name, value in (("yield_profile", "factor"), ("initial_stress", "value")):
            if (profile := getattr(self, name)) is not None:
                table[name] = {"depth": list(profile[0]), value: list(profile[1])}
        if self.softening is not None:
            table["softening"] = self.softening.to_case()
        return table | self._tables_of_constants()

    def _tables_of_constants(self, keep: Callable[[str, Any], bool] = lambda key, value: True) -> dict[str, Any]:
        given = {"thermal": self.thermal, "electrical": self.electrical, "fatigue": self.fatigue}
        return {
            name: {key: value for key, value in constants.to_case().items() if keep(key, value)}
            for name, constants in given.items()
            if constants is not None
        }

    @cached_property
    def _engine(self) -> _core.Material:
        """The engine's material, validated and in SI units.

        Raises:
            InputError: a value, unit or combination that the case file does not allow.
        """
        if self.is_rigid:
            return _core.rigid_material()
        return _core.lower_material(case_of(self.to_case()))

    def __getstate__(self) -> dict[str, Any]:
        return {field.name: getattr(self, field.name) for field in fields(self)}  # the engine's object is not pickled


RIGID = Material(math.inf, 0.0)
"""Material of a rigid body."""
