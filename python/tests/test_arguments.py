# SPDX-License-Identifier: BSD-3-Clause
"""Wrong arguments of the public classes are told with what was meant."""

from __future__ import annotations

import copy
import dataclasses
import functools
import inspect
import pickle
from collections.abc import Callable, Iterator
from types import ModuleType
from typing import Any

import numpy as np
import pytest

import brinell
import brinell.asperities
from brinell._arguments import explain_argument_errors

STEEL = brinell.Material("210 GPa", 0.3, brinell.Perfect("600 MPa"))
BALL = brinell.Body(brinell.Sphere("10 um"), STEEL)
untyped: Any = brinell
"""What a type checker would find is wanted here."""


@pytest.mark.parametrize(
    ("make", "text"),
    [
        (
            lambda: untyped.Solver(tolerence=1e-4),
            r"brinell\.Solver: unknown argument tolerence = 0\.0001; did you mean .*yield_tolerance.*\? allowed: "
            r"accuracy, yield_tolerance,",
        ),
        (lambda: untyped.Grid(resolutin=8), r"did you mean resolution\? allowed: spacing, resolution,"),
        (lambda: untyped.Sphere(radios=1e-3), r"brinell\.Sphere: .*did you mean radius\? allowed: radius$"),
        (lambda: untyped.Sphere(), r"brinell\.Sphere: missing radius; allowed: radius$"),
        (lambda: untyped.Flat("1 mm"), r"1 argument without a name; allowed, by name: none"),
        (lambda: untyped.Grid(8), r"brinell\.Grid: 1 argument without a name; allowed, by name: spacing, resol"),
        (
            lambda: untyped.Body(brinell.Flat(), STEEL, matrial=STEEL),
            r"unknown argument matrial = Material\(.*did you mean material\?",
        ),
        (
            lambda: untyped.Body(brinell.Flat(), STEEL, shape=brinell.Flat()),
            r"brinell\.Body: shape given twice",
        ),
        (
            lambda: untyped.Tugging(BALL, BALL, 4, 1e-6),
            r"4 arguments without a name; allowed: lower, upper, interference; by name: offset, load,",
        ),
        (lambda: untyped.Tugging(BALL, BALL, interferense=4), r"did you mean interference\?"),
        (lambda: untyped.Indentation(BALL, BALL, laod=[1.0]), r"brinell\.Indentation: .*did you mean load\?"),
        (lambda: untyped.Rolling(BALL, BALL, load=1.0, slide_roll=1.0), r"did you mean slide_to_roll\?"),
        (lambda: untyped.Fretting(BALL, BALL, load=1.0, cycle=1.0), r"did you mean cycles.*\?"),
        (lambda: untyped.Sliding(BALL, BALL, load=1.0, stroke=2), r"did you mean strokes\?"),
        (
            lambda: untyped.Tugging(BALL, BALL, 4, resolution=8, friction=0.1),
            r"unknown arguments resolution = 8, friction = 0\.1; resolution belongs into grid = brinell\.Grid\("
            r"resolution=\.\.\.\); friction belongs into interface = brinell\.Interface\(friction=\.\.\.\); allowed",
        ),
        (lambda: untyped.Case(txt=""), r"brinell\.Case: .*did you mean text\?"),
        (lambda: untyped.HeightMap([[0.0]], (1e-6, 1e-6), units="um"), r"brinell\.HeightMap: .*did you mean unit\?"),
        (
            lambda: untyped.halfspace.SurfaceGrid(8, 8, dz=1.0),
            r"brinell\.halfspace\.SurfaceGrid: .*allowed: nx, ny, dx, dy",
        ),
        (
            lambda: untyped.asperities.Population(height=1.0),
            r"brinell\.asperities\.Population: .*did you mean heights\?",
        ),
    ],
)
def test_wrong_arguments_are_told_with_what_was_meant(make: Callable[[], object], text: str) -> None:
    with pytest.raises(brinell.ArgumentError, match=text) as raised:
        make()
    assert isinstance(raised.value, TypeError)
    assert isinstance(raised.value, brinell.InputError)


def public_classes(package: ModuleType) -> Iterator[type]:
    for name in package.__all__:
        found = getattr(package, name)
        if isinstance(found, ModuleType) and hasattr(found, "__all__"):
            yield from public_classes(found)
        elif isinstance(found, type) and inspect.isfunction(vars(found).get("__init__")):
            yield found


def test_every_public_class_that_users_make_tells() -> None:
    """Also those that a later version adds: what a package offers is found by its list."""
    results = ("brinell.plot", "brinell.report", "brinell.results", "brinell.sweeps", "brinell.export")
    kinds = {kind for kind in public_classes(brinell) if not kind.__module__.startswith(results)}
    assert len(kinds) > 50
    kind: Any
    for kind in kinds:
        if issubclass(kind, Exception):
            continue
        with pytest.raises(brinell.ArgumentError, match=r"unknown argument no_such_argument = 1"):
            kind(no_such_argument=1)


def test_errors_from_inside_are_left_alone() -> None:
    class Picky:
        def __init__(self, one: int):
            raise TypeError("from inside")

    module = ModuleType("module")
    module.__dict__.update(Picky=Picky, __all__=["Picky"])
    explain_argument_errors(module)
    with pytest.raises(TypeError, match="from inside") as raised:
        Picky(1)
    assert not isinstance(raised.value, brinell.ArgumentError)
    untyped_picky: Any = Picky
    with pytest.raises(brinell.ArgumentError, match=r"module\.Picky: missing one; allowed: one"):
        untyped_picky()


def test_what_tells_is_still_the_class_that_it_was() -> None:
    grid = brinell.Grid(resolution=8)
    assert list(inspect.signature(brinell.Sphere).parameters) == ["radius"]
    assert copy.deepcopy(grid) == pickle.loads(pickle.dumps(grid)) == dataclasses.replace(grid) == grid
    with pytest.raises(brinell.ArgumentError, match=r"did you mean extent\?"):
        dataclasses.replace(grid, exent=2.0)  # type: ignore[call-arg]


def test_a_misspelt_name_of_the_package_is_told() -> None:
    with pytest.raises(AttributeError, match=r"module 'brinell' has no attribute 'Gird'; did you mean Grid\?$"):
        brinell.Gird  # noqa: B018 (asked for)
    with pytest.raises(AttributeError, match=r"no attribute 'zzzz'$"):
        brinell.zzzz  # noqa: B018


def test_one_value_stands_for_a_list_as_in_a_case_file() -> None:
    flat, elastic = brinell.Body(brinell.Flat(), STEEL), brinell.Material("210 GPa", 0.3)
    roll = functools.partial(
        brinell.Rolling, flat, brinell.Body(brinell.Sphere("10 mm"), elastic), "1 mm", hertz_pressure="2 GPa"
    )
    sliding = brinell.Interface(friction=0.3)
    for creepage in (0.002, "0.2 %", [0.002], (0.002, 0.0), np.array([0.002])):
        assert "creepage = [0.002" in roll(creepage=creepage, interface=sliding).to_toml()
    for load in ("20 uN", 20e-6, ["20 uN"]):
        assert "load = [2e-05]" in brinell.Indentation(flat, BALL, load=load, places="1 um").to_toml().replace(
            "2.0e", "2e"
        )


def test_what_is_no_value_is_told_with_its_argument() -> None:
    flat = brinell.Body(brinell.Flat(), STEEL)
    with pytest.raises(brinell.InputError, match=r"^load\[1\] = None is no value of a case; allowed: numbers,"):
        untyped.Indentation(flat, BALL, load=["5 N", None])
    with pytest.raises(brinell.InputError, match=r"^grid\.resolution = <object .* is no value of a case"):
        untyped.Indentation(flat, BALL, load="5 N", grid={"resolution": object()})


@pytest.mark.parametrize(
    ("call", "text"),
    [
        (
            lambda: untyped.reference.point_contact("1 mm", 1e11, load=10.0),
            "radius = '1 mm' is text; allowed",
        ),
        (lambda: untyped.reference.point_contact(1e-3, 1e11, load="10 N"), "load = '10 N' is text; allowed: .* in N"),
        (lambda: untyped.reference.elliptical_contact(1e-3, [1.0, 2.0], 1e11, load=1.0), "radius_y has 2 values"),
        (lambda: untyped.reference.line_contact(1e-3, 1e11, "1 N/mm"), "load_per_length = '1 N/mm' is text; .* N/m"),
        (lambda: untyped.reference.first_yield("0.3"), "poisson_ratio = '0.3' is text"),
        (lambda: untyped.reference.critical_values("1 mm", 1e11, 1e9, C=1.6), "radius = '1 mm' is text"),
        (lambda: untyped.reference.ElasticTugging(1e-3, 1e-3, 1e11, "1 um"), "interference = '1 um' is text"),
    ],
)
def test_closed_forms_say_which_argument_is_no_number(call: Callable[[], object], text: str) -> None:
    with pytest.raises(brinell.InputError, match=text):
        call()


def test_figures_of_several_runs_take_one() -> None:
    figures = [getattr(brinell.plot, name) for name in brinell.plot.__all__]
    several = [
        draw for draw in figures if callable(draw) and next(iter(inspect.signature(draw).parameters), "") == "runs"
    ]
    assert len(several) > 20
    assert [draw.__name__ for draw in several if not hasattr(draw, "takes_one_run")] == []
