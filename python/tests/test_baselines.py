# SPDX-License-Identifier: BSD-3-Clause
"""Pictures compared with those of tests/baseline, drawn from synthetic results: what structural tests do not see.

Text is taken off, since each version of matplotlib sets it a little differently. After a change of the look that is
meant, look at the new pictures and write them with

    BRINELL_WRITE_BASELINES=1 python -m pytest tests/test_baselines.py
"""

import os
from collections.abc import Callable
from pathlib import Path

import matplotlib
import pytest
from matplotlib.figure import Figure
from matplotlib.testing.compare import compare_images
from matplotlib.testing.decorators import remove_ticks_and_titles

from brinell.plot import fields, rolling, section, style
from brinell.results import open_run

MakeRun = Callable[..., Path]
BASELINE = Path(__file__).parent / "baseline"

# Root mean square over all pixels and channels, of 255. Versions of matplotlib differ by shades along curves and edges
# of patches: some percent of the pixels by some tens. A missing curve, or another colour map, makes more.
TOLERANCE = 6.0


def without_text(fig: Figure) -> Figure:
    remove_ticks_and_titles(fig)
    for text in fig.findobj(matplotlib.text.Text):
        text.set_text("")
    return fig


@pytest.fixture
def figures(make_run: MakeRun, make_rolling: MakeRun) -> dict[str, Callable[[], Figure]]:
    tugging = open_run(make_run(9.0))
    passes = open_run(make_rolling())
    return {
        "pressure": lambda: fields.pressure_map(tugging, tugging.snapshot("aligned")),
        "section": lambda: section(
            tugging, tugging.snapshot(6, tensors=True), field=["von_mises_stress", "stress_xz"], plane="y = 2 mm"
        ),
        "residual-surfaces": lambda: fields.residual_surfaces(passes, passes.snapshot("final")),
        "passes": lambda: rolling.pass_by_pass([passes]),
    }


@pytest.mark.parametrize("name", ["pressure", "section", "residual-surfaces", "passes"])
def test_looks_as_before(name: str, figures: dict[str, Callable[[], Figure]], tmp_path: Path) -> None:
    writes = os.environ.get("BRINELL_WRITE_BASELINES") == "1"
    (path,) = style.save(without_text(figures[name]()), BASELINE if writes else tmp_path, name)
    if writes:
        pytest.skip(f"{path} written, nothing compared")
    difference = compare_images(str(BASELINE / path.name), str(path), TOLERANCE)
    assert difference is None, difference
