# SPDX-License-Identifier: BSD-3-Clause
"""Descriptions of figures: all of their arguments, though each figure states only its own."""

from __future__ import annotations

import inspect
import re

import pytest

import brinell.plot
from brinell.plot.described import described


def _figures() -> list[str]:
    functions = {name: getattr(brinell.plot, name) for name in brinell.plot.__all__}
    return sorted(name for name, f in functions.items() if callable(f) and "ax" in inspect.signature(f).parameters)


@pytest.mark.parametrize("name", _figures())
def test_every_figure_describes_all_of_its_arguments(name: str) -> None:
    draw = getattr(brinell.plot, name)
    for argument in inspect.signature(draw).parameters:
        assert len(re.findall(rf"^    {argument}: \S", inspect.getdoc(draw) or "", re.MULTILINE)) == 1, argument


def test_arguments_stand_in_the_order_of_the_signature_before_what_may_be_raised() -> None:
    def draw(runs: object, depth: float, ax: object = None) -> None:
        """Draws.

        Args:
            depth: of the section,
                from the surface [m].

        Raises:
            ValueError: never.
        """

    text = described(draw)
    assert text.startswith("Draws.\n\nArgs:\n    runs: results, or a sweep.\n    depth: of the section,\n")
    assert text.index("    ax: axes of the caller") < text.index("\n\nRaises:\n    ValueError: never.")
    assert "\n\nArgs:\n    run: result to draw.\n" in described(lambda run: None)
