# SPDX-License-Identifier: BSD-3-Clause
"""The pictures of the cases on their page."""

from __future__ import annotations

import importlib.util
from pathlib import Path
from types import ModuleType

import matplotlib.image
import pytest

ROOT = Path(__file__).parents[2]


@pytest.fixture(scope="module")
def gallery() -> ModuleType:
    spec = importlib.util.spec_from_file_location("case_gallery", ROOT / "docs" / "case_gallery.py")
    assert spec is not None
    assert spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def test_each_case_has_a_picture_on_the_page(gallery: ModuleType) -> None:
    cases = {path.parent.name for path in (ROOT / "cases").glob("*/case.toml")}
    assert set(gallery.PICTURES) == cases
    text = gallery.markdown("_gallery")
    for name in cases:
        assert f"](_gallery/{name}.png)](../cases/{name}/README.md)" in text
    assert gallery.MARK in (ROOT / "docs" / "cases.md").read_text(encoding="utf-8")


@pytest.mark.parametrize("name", ["indentation", "fretting-sphere", "tugging-cylinders"])
def test_a_picture_is_drawn_once(gallery: ModuleType, tmp_path: Path, name: str) -> None:
    path = gallery.draw(name, tmp_path)
    assert min(matplotlib.image.imread(path).shape[:2]) > 80
    written = path.stat().st_mtime_ns
    assert gallery.draw(name, tmp_path) == path
    assert path.stat().st_mtime_ns == written
