# SPDX-License-Identifier: BSD-3-Clause
"""The hardening law that is a table of points: given as points, read from a file, or sampled from a function."""

from __future__ import annotations

import math
import warnings
from collections.abc import Sequence
from dataclasses import InitVar, dataclass
from pathlib import Path
from typing import Any, ClassVar, Literal

from brinell._names import level_of_caller
from brinell._tables import Hardening, Quantity
from brinell._toml import tomllib
from brinell._values import plain
from brinell.case import CaseWarning
from brinell.errors import InputError
from brinell.materials.checking import case_of
from brinell.materials.sampling import Law, sampled

__all__ = ["Table"]


@dataclass(frozen=True)
class Table(Hardening):
    """Tabulated hardening law: linear between points, constant after the last one.

    `file` or `from_file` reads a table from a file, `of` samples a function.

    Attributes:
        plastic_strain: equivalent plastic strains, ascending from 0 [-].
        stress: yield stresses at these strains, not decreasing [Pa].
        monotone: whether a stress below an earlier one, as from scatter of a measurement, is raised to the earlier one.
        file: file with the points instead of `plastic_strain` and `stress`, as in the case file (argument only); see
            `from_file`.
        stress_unit: unit of the stresses in the file (argument only).
        strain_unit: unit of the strains in the file, "1" or "%" (argument only).

    Raises:
        InputError: neither points nor a file are given, or both.
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
        cls,
        path: str | Path,
        *,
        unit: str = "Pa",
        strain: Literal["1", "%"] = "1",
        monotone: bool = False,
        young_modulus: Quantity | None = None,
        **how: Any,
    ) -> Table:
        """Reads a measured curve from a text file with strain and stress of one point per line.

        Columns are separated by commas, semicolons, tabs or blanks. If the separator is not a comma, commas are decimal
        commas. Title lines may come first; comments start with #. Without further keywords the strains are plastic. Of
        total strains or engineering values `MeasuredCurve.from_file` tells and draws what became of them.

        Args:
            path: path of the file.
            unit: unit of the stresses in the file, such as "MPa".
            strain: unit of the strains in the file, "1" or "%".
            monotone: raise a stress below an earlier one to the earlier one; otherwise a decreasing curve is an error.
            young_modulus: Young's modulus, for the elastic part of total strains and of engineering values.
            how: further keys of `material.hardening` in a case file: strain_type="total", measure="engineering", test,
                yield_from, yield_offset, elastic_slope.

        Raises:
            InputError: the file or one of its lines is invalid, the unit is unknown, or the curve is not a hardening
                law.
        """
        is_elastic = how.get("strain_type") == "total" or how.get("measure") == "engineering"
        if is_elastic and young_modulus is None and how.get("elastic_slope") != "curve":
            raise InputError(
                f"{path} has elastic strains, which need young_modulus; allowed: young_modulus='210 GPa', or "
                "elastic_slope='curve' for the slope of the curve itself"
            )
        table = {
            "law": cls.law,
            "file": str(Path(path).absolute()),
            "stress_unit": unit,
            "strain_unit": strain,
            "monotone": monotone,
        } | how
        modulus = 1e12 if young_modulus is None else young_modulus
        try:
            case = case_of({"young_modulus": modulus, "poisson_ratio": 0.3, "hardening": table})
        except InputError as error:
            text = str(error).replace("material.hardening.", "").replace("stress_unit", "unit")
            raise InputError(text.replace("strain_unit", "strain")) from None
        for key, text in case.warnings:
            if key.startswith("curve_"):
                warnings.warn(text.replace("lower.material.hardening.", ""), CaseWarning, stacklevel=level_of_caller())
        hardening = tomllib.loads(case.resolved_text())["lower"]["material"]["hardening"]
        return cls(hardening["plastic_strain"], hardening["stress"])

    def to_case(self) -> dict[str, Any]:
        """The table `material.hardening` of the case file."""
        table = super().to_case()
        return table if self.monotone else {key: value for key, value in table.items() if key != "monotone"}

    @classmethod
    def of(cls, law: Law, max_strain: float = 1.0) -> Table:
        """Samples a function so finely that the table differs from it by less than 1e-4 of its value.

        Args:
            law: function sigma_y(e) [Pa], > 0, continuous and not decreasing. It is called with one strain (a NumPy
                scalar) at a time.
            max_strain: last strain of the table [-]; the yield stress is constant beyond it.

        Raises:
            InputError: the function returns an invalid value, decreases or jumps; the text says where.
        """
        if not (math.isfinite(max_strain) and max_strain > 0):
            raise InputError(f"max_strain = {max_strain} of a hardening law; allowed: above 0")
        strain, stress = sampled(law, max_strain)
        return cls(strain, stress)
