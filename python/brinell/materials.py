# SPDX-License-Identifier: BSD-3-Clause
"""Materials: elastic constants, hardening laws, what changes with depth, and constants of heat.

    steel = Material("210 GPa", 0.3, Swift(coefficient="2.1 GPa", offset=4e-3, exponent=0.095))
    soft = Material(70e9, 0.33, hardening=lambda e: 250e6 + 180e6 * np.tanh(30 * e))

A number is in SI; a string carries its unit, as in the case file, whose table `material` this module writes. e is the
equivalent plastic strain, sigma_y(e) the yield stress in uniaxial tension.
"""

from __future__ import annotations

import itertools
import math
import tomllib
from collections.abc import Callable, Iterable, Sequence
from dataclasses import InitVar, dataclass, fields
from functools import cached_property
from pathlib import Path
from typing import Any, ClassVar, Literal, TypeAlias

import numpy as np
import tomli_w

from brinell import _core
from brinell._arrays import require_unmasked
from brinell._names import renamed
from brinell.bodies import Quantity
from brinell.case import in_arguments, plain
from brinell.errors import InputError

__all__ = [
    "RIGID",
    "Hardening",
    "Hollomon",
    "JohnsonCook",
    "Law",
    "Linear",
    "LinearSoftening",
    "Ludwik",
    "Material",
    "Perfect",
    "Softening",
    "SofteningTable",
    "Swift",
    "SwiftMicrostrain",
    "Table",
    "Thermal",
    "Voce",
]

Law: TypeAlias = Callable[[Any], Any]
"""A hardening law of one's own: sigma_y(e) [Pa]. Called with one strain at a time."""


class Hardening:
    """A hardening law: the yield stress as a function of the equivalent plastic strain."""

    law: ClassVar[str]

    def to_case(self) -> dict[str, Any]:
        """The table `material.hardening` of the case file."""
        return {"law": self.law} | {field.name: plain(getattr(self, field.name)) for field in fields(self)}  # type: ignore[arg-type]


@dataclass(frozen=True)
class Perfect(Hardening):
    """sigma_y(e) = yield_stress [Pa]."""

    law: ClassVar[str] = "perfect"
    yield_stress: Quantity


@dataclass(frozen=True)
class Linear(Hardening):
    """sigma_y(e) = yield_stress + modulus e, both in Pa."""

    law: ClassVar[str] = "linear"
    yield_stress: Quantity
    modulus: Quantity


@dataclass(frozen=True)
class Swift(Hardening):
    """sigma_y(e) = coefficient (offset + e)^exponent (Swift 1952); coefficient in Pa."""

    law: ClassVar[str] = "swift"
    coefficient: Quantity
    offset: float
    exponent: float


@dataclass(frozen=True)
class SwiftMicrostrain(Hardening):
    """sigma_y(e) = coefficient (offset + 1e6 e)^exponent: Swift's law with strains in millionths; coefficient in Pa."""

    law: ClassVar[str] = "swift_microstrain"
    coefficient: Quantity
    offset: float
    exponent: float


@dataclass(frozen=True)
class Hollomon(Hardening):
    """sigma_y(e) = coefficient (e_0 + e)^exponent, e_0 such that it begins at yield_stress (Hollomon 1945); in Pa."""

    law: ClassVar[str] = "hollomon"
    yield_stress: Quantity
    coefficient: Quantity
    exponent: float


@dataclass(frozen=True)
class Ludwik(Hardening):
    """sigma_y(e) = yield_stress + coefficient e^exponent (Ludwik 1909); both in Pa."""

    law: ClassVar[str] = "ludwik"
    yield_stress: Quantity
    coefficient: Quantity
    exponent: float


@dataclass(frozen=True)
class Voce(Hardening):
    """sigma_y(e) = yield_stress + saturation (1 - exp(-rate e)) (Voce 1948); yield_stress and saturation in Pa."""

    law: ClassVar[str] = "voce"
    yield_stress: Quantity
    saturation: Quantity
    rate: float


@dataclass(frozen=True)
class Table(Hardening):
    """Linear between points, constant after the last one. Of a file: `file` or `from_file`; of a function: `of`.

    Attributes:
        plastic_strain: equivalent plastic strains, ascending from 0 [-].
        stress: yield stresses, as many, not falling [Pa].
        monotone: a stress below an earlier one, as the scatter of a measurement has it, becomes that one.
        file: instead of the points, as in the case file: what `from_file` reads, with `stress_unit` and `strain_unit`.
    """

    law: ClassVar[str] = "table"
    plastic_strain: Sequence[float] = ()
    stress: Sequence[Quantity] = ()
    monotone: bool = False
    file: InitVar[str | Path | None] = None
    stress_unit: InitVar[str] = "Pa"
    strain_unit: InitVar[Literal["1", "%"]] = "1"

    def __post_init__(self, file: str | Path | None, stress_unit: str, strain_unit: Literal["1", "%"]) -> None:
        if file is not None:
            if len(self.plastic_strain) or len(self.stress):
                raise InputError(f"file = {str(file)!r} cannot stand together with plastic_strain and stress")
            read = Table.from_file(file, unit=stress_unit, strain=strain_unit, monotone=self.monotone)
            object.__setattr__(self, "plastic_strain", read.plastic_strain)
            object.__setattr__(self, "stress", read.stress)
            object.__setattr__(self, "monotone", False)
        elif not len(self.plastic_strain) or not len(self.stress):
            raise InputError("a table needs plastic_strain and stress, or a file; Table.from_file reads one, too")
        object.__setattr__(self, "plastic_strain", tuple(plain(self.plastic_strain)))
        object.__setattr__(self, "stress", tuple(plain(self.stress)))

    @classmethod
    def from_file(
        cls, path: str | Path, *, unit: str = "Pa", strain: Literal["1", "%"] = "1", monotone: bool = False
    ) -> Table:
        """A measured curve: a text file with a point per line, plastic strain and stress.

        Columns stand between commas, semicolons, tabs or blanks; where something else than a comma stands between them,
        commas are decimal ones. Lines of titles may come first; comments begin with #.

        Args:
            path: of the file.
            unit: of its stresses, "MPa".
            strain: unit of its plastic strains.
            monotone: a stress below an earlier one becomes that one; without it a curve that falls is refused.

        Raises:
            InputError: the file, a line of it or the unit is not as it should be, or the curve is no hardening law.
        """
        table = {
            "law": cls.law,
            "file": str(Path(path).absolute()),
            "stress_unit": unit,
            "strain_unit": strain,
            "monotone": monotone,
        }
        try:
            case = _case_of({"young_modulus": 1e12, "poisson_ratio": 0.3, "hardening": table})
        except InputError as error:
            text = str(error).replace("material.hardening.", "").replace("stress_unit", "unit")
            raise InputError(text.replace("strain_unit", "strain")) from None
        hardening = tomllib.loads(case.resolved_text())["lower"]["material"]["hardening"]
        return cls(hardening["plastic_strain"], hardening["stress"])

    def to_case(self) -> dict[str, Any]:
        """The table `material.hardening` of the case file."""
        table = super().to_case()
        return table if self.monotone else {key: value for key, value in table.items() if key != "monotone"}

    @classmethod
    def of(cls, law: Law, max_strain: float = 1.0) -> Table:
        """A table of a function, fine enough that it differs from it by less than 1e-4 of its value.

        Args:
            law: sigma_y(e) [Pa], > 0, continuous, not falling. Called with one strain, a NumPy number, at a time.
            max_strain: where the table ends [-]; the yield stress is constant beyond.

        Raises:
            InputError: the function has no such value, falls or jumps; the text says where.
        """
        if not (math.isfinite(max_strain) and max_strain > 0):
            raise InputError(f"max_strain = {max_strain} of a hardening law; allowed: above 0")
        strain, stress = _sampled(_Checked(law), max_strain)
        return cls(strain, stress)


class Softening:
    """A factor on the yield stress by the temperature; at least 0.01, also of what has melted.

    Temperatures are in deg C, or text, "293.15 K". Back stresses are not softened.
    """

    law: ClassVar[str]

    def to_case(self) -> dict[str, Any]:
        """The table `material.softening` of the case file."""
        return {"law": self.law} | {field.name: plain(getattr(self, field.name)) for field in fields(self)}  # type: ignore[arg-type]


@dataclass(frozen=True)
class LinearSoftening(Softening):
    """1 up to the reference temperature, 0 from melting on, straight between."""

    law: ClassVar[str] = "linear"
    melting_temperature: Quantity
    reference_temperature: Quantity = 20.0


@dataclass(frozen=True)
class JohnsonCook(Softening):
    """1 - ((T - T_ref)/(T_melt - T_ref))^exponent (Johnson and Cook 1983); 1 below T_ref."""

    law: ClassVar[str] = "johnson_cook"
    melting_temperature: Quantity
    exponent: float
    reference_temperature: Quantity = 20.0


@dataclass(frozen=True)
class SofteningTable(Softening):
    """Linear between points, constant outside them.

    Attributes:
        temperature: of the points, ascending.
        factor: on the yield stress, as many, > 0.
    """

    law: ClassVar[str] = "table"
    temperature: Sequence[Quantity]
    factor: Sequence[float]

    def __post_init__(self) -> None:
        object.__setattr__(self, "temperature", tuple(plain(self.temperature)))
        object.__setattr__(self, "factor", tuple(plain(self.factor)))


@dataclass(frozen=True)
class Thermal:
    """Constants of a body that conducts heat.

    Attributes:
        conductivity: K [W/(m K)], > 0.
        density: rho [kg/m^3], > 0.
        specific_heat: c [J/(kg K)], > 0.
        expansion: alpha, linear, of the free body [1/K]; temperatures do without it.
        temperature: of the bulk [deg C], or text, "293.15 K".
    """

    conductivity: Quantity
    density: Quantity
    specific_heat: Quantity
    expansion: Quantity = 0.0
    temperature: Quantity = 20.0

    def __post_init__(self) -> None:
        self._engine  # noqa: B018 (checks the values)

    @classmethod
    def carbon_steel(cls, temperature: Quantity = 20.0) -> Thermal:
        """Structural steel at 20 deg C (EN 1993-1-2:2005, section 3.4)."""
        return cls(53.3, 7850.0, 440.0, 12.2e-6, temperature)

    @classmethod
    def stainless_steel(cls, temperature: Quantity = 20.0) -> Thermal:
        """Austenitic steel 1.4301 (AISI 304) at 20 deg C (EN 10088-1:2005, annex E)."""
        return cls(15.0, 7900.0, 500.0, 16.0e-6, temperature)

    @property
    def diffusivity(self) -> float:
        """K/(rho c) [m^2/s]."""
        return self._engine.diffusivity

    def to_case(self) -> dict[str, Any]:
        """The table `material.thermal` of the case file."""
        table: dict[str, Any] = plain({field.name: getattr(self, field.name) for field in fields(self)})
        return table

    @cached_property
    def _engine(self) -> _core.Thermal:
        """The same for the engine, checked and in SI.

        Raises:
            InputError: a value or unit that the case file would not allow either.
        """
        try:
            case = _case_of({"young_modulus": 1e12, "poisson_ratio": 0.3, "thermal": self.to_case()})
        except InputError as error:
            raise InputError(str(error).replace("material.thermal.", "")) from None
        thermal = _core.lower_material(case).thermal
        assert thermal is not None
        return thermal

    def __getstate__(self) -> dict[str, Any]:
        return {field.name: getattr(self, field.name) for field in fields(self)}  # what is pickled: not the engine's


def _tuples(values: Iterable[Any]) -> tuple[tuple[Any, ...], ...]:
    """Pairs or lists as what can be compared and does not change."""
    return tuple(tuple(plain(entry)) for entry in values)


@renamed(kinematic="back_stresses")
@dataclass(frozen=True)
class Material:
    """An elastic material, elastic-plastic if it has a hardening law.

    Attributes:
        young_modulus: E [Pa], > 0.
        poisson_ratio: nu [-], in (-1, 0.5).
        hardening: size of the yield surface; None: stays elastic. Any function sigma_y(e) is one too; it becomes
            `Table.of` it, up to a strain of 1.
        back_stresses: kinematic hardening as pairs (modulus C [Pa], recall gamma [-]),
            d alpha = 2/3 C d eps - gamma alpha d e (Armstrong, Frederick 1966; Chaboche 1986; gamma = 0: Prager 1956).
        yield_profile: (depths [m], factors on the yield stress [-]), linear between, constant beyond.
        initial_stress: (depths [m], stresses xx = yy before the first load [Pa]), tension positive.
        thermal: constants of heat; None: no heat is computed in the body.
        softening: how the yield stress falls with the temperature; None: not at all.
    """

    young_modulus: Quantity
    poisson_ratio: float
    hardening: Hardening | Law | None = None
    back_stresses: Sequence[tuple[Quantity, float]] = ()
    yield_profile: tuple[Sequence[Quantity], Sequence[float]] | None = None
    initial_stress: tuple[Sequence[Quantity], Sequence[Quantity]] | None = None
    thermal: Thermal | None = None
    softening: Softening | None = None

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
        object.__setattr__(self, "back_stresses", _tuples(self.back_stresses))
        for name in ("yield_profile", "initial_stress"):
            if (profile := getattr(self, name)) is not None:
                object.__setattr__(self, name, _tuples(profile))

    @property
    def is_rigid(self) -> bool:
        """Whether the body does not deform at all."""
        return self.young_modulus == math.inf

    def to_case(self) -> dict[str, Any]:
        """The table `material` of the case file, as nested dictionaries."""
        if self.is_rigid:
            return {"rigid": True} | self._thermal_table(lambda key, value: key != "expansion" or value != 0.0)
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
        return table | self._thermal_table()

    def _thermal_table(self, keep: Callable[[str, Any], bool] = lambda key, value: True) -> dict[str, Any]:
        if self.thermal is None:
            return {}
        return {"thermal": {key: value for key, value in self.thermal.to_case().items() if keep(key, value)}}

    @cached_property
    def _engine(self) -> _core.Material:
        """The same for the engine, checked and in SI.

        Raises:
            InputError: a value, unit or combination that the case file would not allow either.
        """
        if self.is_rigid:
            return _core.rigid_material()
        return _core.lower_material(_case_of(self.to_case()))

    def __getstate__(self) -> dict[str, Any]:
        return {field.name: getattr(self, field.name) for field in fields(self)}  # what is pickled: not the engine's


def _case_of(material: dict[str, Any]) -> _core.Case:
    """A case of which only the material of the lower body counts.

    Raises:
        InputError: a value, unit or combination that the case file would not allow; names the keys of the material.
    """
    ball = {"type": "sphere", "radius": 1.0}
    values = {
        "scenario": "indentation",
        "lower": {"shape": ball, "material": material},
        "upper": {"shape": ball, "material": {"rigid": True}},
        "indentation": {"load": [1e-15]},  # a contact that needs few cells, however soft the material is
    }
    try:
        return _core.parse_case(tomli_w.dumps(plain(values)), "material", [], {}, names_lines=False)
    except InputError as error:
        raise InputError(in_arguments(str(error)).replace("lower.material", "material")) from None


RIGID = Material(math.inf, 0.0)
"""A body that does not deform at all."""


class _Checked:
    """A hardening law that is watched: each value is a stress, and none is below one at a smaller strain."""

    def __init__(self, law: Law):
        self._law = law
        self._known: dict[float, float] = {}

    def __call__(self, e: float) -> float:
        if e not in self._known:
            with np.errstate(all="ignore"):
                given = self._law(np.float64(e))
                require_unmasked(given, "what the hardening law gives")
                value = np.asarray(given, dtype=np.float64)
            if value.size != 1 or not (np.isfinite(value).all() and value.item() > 0):
                raise InputError(
                    f"the hardening law gives {value} at a plastic strain of {e:g}; allowed: a stress in Pa"
                )
            self._known[e] = value.item()
        return self._known[e]

    def require_rise(self) -> None:
        """Of all the values so far, but for rounding."""
        rounding = 1e-12
        points = sorted(self._known.items())
        for (_, before), (e, after) in itertools.pairwise(points):
            if after < before * (1 - rounding):
                raise InputError(
                    f"the hardening law falls from {before:g} Pa to {after:g} Pa before a plastic strain of {e:g}; "
                    "softening is not modelled"
                )


def _sampled(law: _Checked, end: float) -> tuple[list[float], list[float]]:
    """Points of a law: intervals are halved until it is straight in them, as far as three points inside tell."""
    tolerance = 1e-4 / 2  # half of what is promised, for what lies between the three points
    coarsest = 32
    todo = [(end * (i - 1) / coarsest, end * i / coarsest) for i in range(coarsest, 0, -1)]
    strain = [0.0]
    while todo:
        left, right = todo.pop()
        straight = True
        for t in (0.25, 0.5, 0.75):
            line = (1 - t) * law(left) + t * law(right)
            straight = straight and abs(law(left + t * (right - left)) - line) <= tolerance * line
        middle = 0.5 * (left + right)
        if straight:
            strain.append(right)
        elif left < middle < right:
            todo += [(middle, right), (left, middle)]
        else:
            law.require_rise()
            raise InputError(
                f"the hardening law jumps from {law(left):g} Pa to {law(right):g} Pa at a plastic strain of {right:g}; "
                "allowed: a continuous one"
            )
    law.require_rise()
    return strain, np.maximum.accumulate([law(e) for e in strain]).tolist()
