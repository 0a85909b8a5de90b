# SPDX-License-Identifier: BSD-3-Clause
"""Pictures compared with those of tests/baseline, drawn from synthetic results: what structural tests do not see.

Text is taken off: fonts are not what is tested. After a change of the look that is meant, look at the new pictures and
write them with

    BRINELL_WRITE_BASELINES=1 python -m pytest python/tests/test_baselines.py
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

# Versions of matplotlib lay out a sheet differently by whole pixels: only this one is compared.
MATPLOTLIB = "3.11."

# Root mean square over all pixels and channels, of 255. The same version makes the same picture, but for round-off on
# another processor. A missing curve makes 4.6 or more, another plane of the section 3.
TOLERANCE = 1.0


def written(fig: Figure, path: Path) -> Path:
    """The figure without text, on the whole of its sheet, so that its size in pixels is known."""
    remove_ticks_and_titles(fig)
    for text in fig.findobj(matplotlib.text.Text):
        text.set_text("")
    with style.look(), matplotlib.rc_context({"savefig.bbox": None}):
        fig.savefig(path, dpi=40, metadata={"Software": None})
    return path


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


@pytest.mark.skipif(
    not matplotlib.__version__.startswith(MATPLOTLIB),
    reason=f"pictures are of matplotlib {MATPLOTLIB}*, this is {matplotlib.__version__}",
)
@pytest.mark.parametrize("name", ["pressure", "section", "residual-surfaces", "passes"])
def test_looks_as_before(name: str, figures: dict[str, Callable[[], Figure]], tmp_path: Path) -> None:
    writes = os.environ.get("BRINELL_WRITE_BASELINES") == "1"
    path = written(figures[name](), (BASELINE if writes else tmp_path) / f"{name}.png")
    if writes:
        pytest.skip(f"{path} written, nothing compared")
    difference = compare_images(str(BASELINE / path.name), str(path), TOLERANCE)
    assert difference is None, difference
