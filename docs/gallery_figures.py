# SPDX-License-Identifier: BSD-3-Clause
"""Shows the figures of `brinell.plot` on the pages of the tutorials; pyplot, which the gallery asks, has none."""

from __future__ import annotations

from typing import Any
from weakref import WeakSet

from matplotlib.figure import Figure
from sphinx_gallery.scrapers import figure_rst

_shown: WeakSet[Figure] = WeakSet()  # not their ids, which a later figure may be given again


def figures_of_brinell(_block: Any, block_vars: dict[str, Any], gallery_conf: dict[str, Any]) -> str:
    """The figure that a block of a tutorial has made under the name `figure`."""
    figure = block_vars["example_globals"].get("figure")
    if not isinstance(figure, Figure) or not hasattr(figure, "_repr_png_") or figure in _shown:  # pyplot's have none
        return ""
    _shown.add(figure)
    path = next(block_vars["image_path_iterator"])
    figure.savefig(path)
    return str(figure_rst([path], gallery_conf["src_dir"]))


def _get_sg_image_scraper() -> Any:
    return figures_of_brinell
