# SPDX-License-Identifier: BSD-3-Clause
"""The extension: its stub file, and arrays that are not copied on the way to it."""

from __future__ import annotations

import ast
from pathlib import Path

import numpy as np
import pytest

import brinell
from brinell import _core
from brinell._arrays import contiguous, points

STUB = Path(__file__).parents[1] / "brinell" / "_core.pyi"


def test_the_stub_file_is_that_of_the_extension() -> None:
    stubgen = pytest.importorskip("nanobind.stubgen")
    generator = stubgen.StubGen(_core)
    generator.put(_core)
    same = ast.dump(ast.parse(STUB.read_text())) == ast.dump(ast.parse(generator.get()))
    assert same, "python -m nanobind.stubgen -m brinell._core -o python/brinell/_core.pyi"


def test_what_lies_as_the_engine_wants_it_is_not_copied() -> None:
    field = np.zeros((3, 4))
    assert np.shares_memory(contiguous(field, "field"), field)
    (x,) = points(x=field)[1]
    assert np.shares_memory(x, field)
    assert not np.shares_memory(contiguous(field.T, "field"), field)


@pytest.mark.parametrize("values", [1 + 1j, "text", [[1], [1, 2]], None, [np.inf], [np.nan]])
def test_what_is_no_array_of_numbers_is_an_input_error(values: object) -> None:
    with pytest.raises(brinell.InputError, match="^load "):
        contiguous(values, "load")  # type: ignore[arg-type]


def test_integers_and_single_precision_are_converted() -> None:
    for values in (3, np.float32(3), [3], True):
        assert contiguous(values, "values").dtype == np.float64
