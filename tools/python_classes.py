# SPDX-License-Identifier: BSD-3-Clause
"""What tools/render_python.py cannot take from the schema: names of classes, order of arguments, heads of files."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field


@dataclass(frozen=True)
class Part:
    """A table within a table, which is an object of another class or a dictionary."""

    kind: str
    text: str
    is_list: bool = False

    @property
    def type(self) -> str:
        """The annotation without None."""
        either = f"{self.kind} | Mapping[str, Any]"
        return f"Sequence[{either}]" if self.is_list else either


@dataclass(frozen=True)
class Kind:
    """A dataclass whose fields are the keys of a table."""

    name: str
    table: str
    summary: str = ""
    """First line of the docstring; of a choice what the schema says of it follows."""
    base: str = "CaseTable"
    choice: str = ""
    """Value of the key `type` or `law`, if the class has only the keys of that choice."""
    first: tuple[str, ...] = ()
    """Fields in front of the others, which come in the order of the schema."""
    by_place: int | None = 0
    """Number of fields that may be given without a name; None: all."""
    required: tuple[str, ...] = ()
    """Fields without a default besides those that the schema requires."""
    instead: Mapping[str, str] = field(default_factory=dict)
    """Annotations, or annotations with a default, that are not those of the schema."""
    parts: Mapping[str, Part] = field(default_factory=dict)


@dataclass(frozen=True)
class Scenario:
    """The class of a scenario, whose arguments are the keys of its table, bodies and settings."""

    name: str
    lower: str
    upper: str
    by_place: tuple[str, ...] = ()
    first: tuple[str, ...] = ()


@dataclass(frozen=True)
class Listed:
    """A dataclass with the numbers of an entry of a list in the summary."""

    name: str
    key: str
    """The list in the summary."""
    summary: str
    later: tuple[str, ...] = ()
    """Numbers that older results may lack; they are NaN then."""
    derived: Mapping[str, str] = field(default_factory=dict)
    """What the summary says besides, yes or no."""


def shape(name: str, **how: object) -> Kind:
    """A shape or, with another base, a texture; its choice is the name in lower case unless `choice` is given."""
    given = {"table": "lower.shape", "base": "Shape", "choice": name.lower(), "by_place": None} | how
    return Kind(name, **given)  # type: ignore[arg-type]


def law(name: str, choice: str, table: str = "hardening", base: str = "Hardening", **how: object) -> Kind:
    """A law of hardening or softening."""
    return Kind(name, f"lower.material.{table}", base=base, choice=choice, by_place=None, **how)  # type: ignore[arg-type]


TEXTURE = {"table": "lower.texture", "base": "Texture"}
DENT = TEXTURE | {"base": "DentOrBump", "by_place": 1}
SOFTENING = {
    "table": "softening",
    "base": "Softening",
    "instead": {"reference_temperature": "Quantity = 20.0"},
    "summary": "Factor on the yield stress that falls from 1 at the reference to 0 at the melting temperature.",
}

SETTINGS = (
    Kind(
        "Grid",
        "grid",
        "The grid.",
        first=("spacing", "resolution", "extent"),
        instead={"cells": "int | Sequence[int] | None = None"},
    ),
    Kind(
        "Interface",
        "interface",
        "Friction, frictional heat, wear and electric current of the interface.",
        parts={"wear": Part("Wear", "Wear of the surfaces where they slip")},
    ),
    Kind("Wear", "interface.wear", "Wear of both surfaces where they slip."),
    Kind("HeatSource", "thermal.source", "Heat that is supplied from outside.", required=("shape",)),
    Kind(
        "Heating",
        "thermal",
        "Effects of heat on bodies with thermal constants.",
        parts={"source": Part("HeatSource", "Heat from outside")},
    ),
    Kind("Solver", "solver", "Tolerances and methods of the solver.", first=("accuracy",)),
    Kind(
        "Point",
        "output.points",
        "A point within a body at which each step records stress, plastic strain and temperature.",
        first=("depth", "x", "y"),
        required=("depth",),
    ),
    Kind(
        "Output",
        "output",
        "Storage of results.",
        instead={
            "directory": "str | Path | None = None",
            "region_x": "Sequence[Quantity] | None = None",
            "region_y": "Sequence[Quantity] | None = None",
        },
        parts={"points": Part("Point", "Points at which each step records stress and strain", is_list=True)},
    ),
)

SHAPES = (
    shape("Sphere"),
    shape("Ellipsoid"),
    shape("Cylinder"),
    shape("Cone"),
    shape("Vickers"),
    shape("Berkovich"),
    shape("Flat"),
    shape("Dent", **DENT),
    shape("Bump", **DENT),
    shape("Sinusoid", **TEXTURE),
    shape("RandomSurface", choice="random", first=("cutoff", "rms_height", "rms_slope"), **TEXTURE),
)

LAWS = (
    law("Perfect", "perfect"),
    law("Linear", "linear"),
    law("Swift", "swift"),
    law("SwiftMicrostrain", "swift_microstrain"),
    law("Hollomon", "hollomon"),
    law("Ludwik", "ludwik"),
    law("Voce", "voce"),
    law("LinearSoftening", "linear", **SOFTENING),
    law("JohnsonCook", "johnson_cook", first=("melting_temperature", "exponent"), **SOFTENING),
)

FATIGUE = (
    Kind(
        "FatigueConstants",
        "lower.material.fatigue",
        "Criterion of fatigue and constants of the life of a material; they request the fatigue of the body.",
        first=("criterion", "torsion_limit", "bending_limit"),
        by_place=3,
        required=("criterion",),
        instead={"torsion_limit": "Quantity | None = None", "bending_limit": "Quantity | None = None"},
    ),
)

SCENARIOS = (
    Scenario(
        "Tugging",
        lower="The body at rest; its shape is a `Sphere`, `Ellipsoid` or `Cylinder`.",
        upper="The moving body, with one of the same shapes.",
        by_place=("interference",),
        first=("offset", "load"),
    ),
    Scenario("Indentation", lower="The body that is indented.", upper="The indenter."),
    Scenario("Rolling", lower="The body that is rolled over.", upper="The rolling body.", by_place=("distance",)),
    Scenario(
        "Fretting",
        lower="The body at rest.",
        upper="The body that is pressed on the lower one and oscillates.",
    ),
    Scenario(
        "Sliding",
        lower="The body at rest: a `Flat`, with or without a texture.",
        upper="The sliding body: also a `Flat`, on a grid that is periodic along both axes, or a ball or roller.",
        by_place=("distance",),
    ),
)

LISTS = (
    Listed(
        "Indent",
        "indents",
        "Results of one loading and unloading at one place, at the largest load and where the contact opens.",
        later=("contact_fraction", "mean_gap", "contact_stiffness"),
    ),
    Listed(
        "RollingPass",
        "passes",
        "Results of one pass, under and around the middle of the track.",
        later=(
            *("unsteadiness", "mean_F_X", "friction", "contact_area", "F_x", "F_y", "M_z", "stick_share"),
            "creep_unsteadiness",
        ),
        derived={
            "steady": "Whether the resistance is steady, so that it does not depend on the length of the track.",
            "creep_steady": "Whether the forces of the shear are steady, so that they are those of steady rolling.",
        },
    ),
    Listed(
        "FrettingCycle",
        "cycles",
        "Results of one cycle, from the middle through both turning points back to the middle.",
    ),
    Listed(
        "SlidingStroke",
        "strokes",
        "Averages over one stroke, and the state of the surfaces at its end.",
        later=(
            *("contact_fraction", "mean_gap", "patches", "largest_patch"),
            *(
                f"{name}_{body}"
                for name in ("core_height", "peak_height", "valley_depth")
                for body in ("lower", "upper")
            ),
        ),
    ),
)

SHARED = {
    "interface": ("Interface", "Friction, wear and current, `brinell.Interface` or a dictionary."),
    "thermal": ("Heating", "Effects of heat, `brinell.Heating` or a dictionary."),
    "grid": ("Grid", "Grid settings, `brinell.Grid` or a dictionary."),
    "solver": ("Solver", "Solver settings, `brinell.Solver` or a dictionary."),
    "output": ("Output", "Stored results, `brinell.Output` or a dictionary."),
}
"""Settings as arguments of a scenario that knows keys of that table: their class, and what is said of them."""


@dataclass(frozen=True)
class File:
    """A module of the package that is written as a whole."""

    text: str
    kinds: tuple[Kind, ...] | tuple[Scenario, ...] | tuple[Listed, ...]


FILES = {
    "settings.py": File(
        """Settings of a case as classes, one for each of the tables `grid`, `interface`, `thermal`, `solver`, `output`.

    run = brinell.Indentation(lower, upper, load=["10 N", 0], grid=brinell.Grid(resolution=12)).run()

A field that is None takes the default of the case file. A dictionary with the same keys can be used instead of an
object. A quantity is a number in the unit that is given, or text with a unit.
""",
        SETTINGS,
    ),
    "_shapes.py": File("Shapes and textures of bodies.", SHAPES),
    "materials/laws.py": File("Laws of hardening and of thermal softening.", LAWS),
    "materials/fatigue.py": File("Fatigue constants of a material.", FATIGUE),
    "scenarios/cases.py": File("The scenarios as classes: cases whose text is generated from arguments.", SCENARIOS),
    "scenarios/lists.py": File("Entries of the lists in a summary: indents, passes, cycles and strokes.", LISTS),
}
"""The files by their path in the package."""
