# SPDX-License-Identifier: BSD-3-Clause
"""The bodies of a scenario: shape near the contact, texture of the surface, and material.

Lengths are in m, or text with a unit such as "3.85 mm". The fields are the keys of the case file;
docs/reference/case-file.md explains them and lists the allowed values.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any, Protocol

from brinell._shapes import (
    Berkovich,
    Bump,
    Cone,
    Cylinder,
    Dent,
    Ellipsoid,
    Flat,
    RandomSurface,
    Sinusoid,
    Sphere,
    Vickers,
)
from brinell._tables import Quantity, Shape
from brinell.errors import InputError
from brinell.surfaces.heightmap import HeightMap

__all__ = [
    "Berkovich",
    "Body",
    "Bump",
    "Cone",
    "Cylinder",
    "Dent",
    "Ellipsoid",
    "Flat",
    "Quantity",
    "RandomSurface",
    "Shape",
    "Sinusoid",
    "Sphere",
    "Vickers",
]


class Part(Protocol):
    """Object that can be written as a table of a case file."""

    def to_case(self) -> dict[str, Any]:
        """The table as nested dictionaries."""
        ...


@dataclass(frozen=True)
class Body:
    """One of the two bodies.

    Args:
        shape: shape near the point of first contact, such as `Sphere`.
        material: `brinell.Material` or `brinell.RIGID`.
        texture: heights added to the shape: `Dent`, `Bump`, `Sinusoid`, `RandomSurface`, `brinell.HeightMap` or a
            topography of the package SurfaceTopography, or a list of them, which are summed; None: smooth.
        film: thickness of a film that conducts badly, a `brinell.HeightMap` of numbers >= 0; with the
            ``film_resistivity`` of `brinell.Interface`. None: no such film.
        inclusion: inclusion of other elastic constants, or a list of them, each a dictionary with the keys of
            ``lower.inclusion`` in the case file: ``{"type": "ellipsoid", "depth": "20 um", ...}``. None: none.

    Raises:
        InputError: shape, material, texture or film is of another type.
    """

    shape: Shape
    material: Part
    texture: Part | Sequence[Part] | Any | None = None
    film: HeightMap | Any | None = None
    inclusion: Mapping[str, Any] | Sequence[Mapping[str, Any]] | None = None

    def __post_init__(self) -> None:
        if isinstance(self.material, Shape) or hasattr(self.shape, "young_modulus"):
            raise InputError(
                f"shape = {self.shape!r} and material = {self.material!r} of a body: the shape comes first, as in "
                "brinell.Body(brinell.Sphere('1 mm'), steel)"
            )
        texture = self.texture
        if isinstance(texture, list | tuple):
            object.__setattr__(self, "texture", [HeightMap.of_part(part) for part in texture])
        else:
            object.__setattr__(self, "texture", HeightMap.of_part(texture))
        object.__setattr__(self, "film", HeightMap.of_part(self.film))
        if not isinstance(self.film, HeightMap | None):
            raise InputError(f"film = {self.film!r} of a body; allowed: a brinell.HeightMap of its thickness, or None")
        for name, allowed in (
            ("shape", "a shape such as brinell.Sphere('1 mm')"),
            ("material", "a brinell.Material, or brinell.RIGID"),
            (
                "texture",
                "brinell.Dent, Bump, Sinusoid, RandomSurface or HeightMap, a list, a SurfaceTopography, or None",
            ),
        ):
            given = getattr(self, name)
            several = name == "texture" and isinstance(given, list | tuple)
            for part in given if several else [given]:
                is_smooth = name == "texture" and given is None
                if isinstance(part, type) or not (hasattr(part, "to_case") or is_smooth):
                    raise InputError(f"{name} = {part!r} of a body; allowed: {allowed}")

    def to_case(self) -> dict[str, Any]:
        """The tables of the body in the case file, as nested dictionaries."""
        tables: dict[str, Any] = {"shape": self.shape.to_case(), "material": self.material.to_case()}
        if isinstance(self.inclusion, Mapping):
            tables["inclusion"] = dict(self.inclusion)
        elif self.inclusion is not None:
            tables["inclusion"] = [dict(one) for one in self.inclusion]
        if self.film is not None:
            tables["film"] = self.film.to_case()
        if self.texture is None:
            return tables
        if isinstance(self.texture, Sequence):
            return tables | {"texture": [part.to_case() for part in self.texture]}
        return tables | {"texture": self.texture.to_case()}

    def parts(self) -> dict[str, Any]:
        """Parts of the body as objects, so that a case passes the heights of a map on without text."""
        return {
            "shape": self.shape,
            "material": self.material,
            "texture": self.texture,
            "film": self.film,
            "inclusion": self.inclusion,
        }
