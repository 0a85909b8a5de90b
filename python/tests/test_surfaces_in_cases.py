# SPDX-License-Identifier: BSD-3-Clause
"""Large height maps as textures of a case: without text, with binary files beside the resolved case."""

import pickle
import re
import shutil
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import brinell
from brinell import Body, Case, Flat, InputError, Material, Rolling, Sphere
from brinell.surfaces import HeightMap


def rough_case(texture: Any) -> Rolling:
    steel = Material("210 GPa", 0.3)
    return Rolling(
        Body(Flat(), steel, texture),
        Body(Sphere("2 mm"), steel),
        distance="60 um",
        load="5 N",
        grid={"resolution": 4},
        output={"snapshots": "none"},
    )


def large(seed: int = 1) -> HeightMap:
    heights = np.random.default_rng(seed).normal(scale=1e-8, size=(40, 50))
    return HeightMap(heights, (2e-5, 3e-5), x=1e-6)


def test_a_large_map_is_no_text_in_python_and_a_binary_file_in_the_results(tmp_path: Path) -> None:
    case = rough_case(large())
    assert len(case._text) < 2000  # a line per height before
    run = case.run(tmp_path / "run")
    resolved = tmp_path / "run" / "resolved.toml"
    assert resolved.stat().st_size < 3000
    (file,) = (tmp_path / "run").glob("*.npy")
    assert f'file = "{file.name}"' in resolved.read_text()
    np.testing.assert_array_equal(np.load(file), large().heights)
    # The folder is a case, and so is the text within the result, without any file.
    assert Case.from_file(resolved).to_toml() == case.to_toml() == run.case_text == Case(run.case_text).to_toml()
    assert brinell.open(shutil.copy(run.file, tmp_path / "alone.vtkhdf")).case_text == run.case_text
    # Another map in the same folder leaves no file of this one.
    rough_case(large(2)).run(tmp_path / "run")
    (other,) = (tmp_path / "run").glob("*.npy")
    assert other.name != file.name
    rough_case(None).run(tmp_path / "run")
    assert list((tmp_path / "run").glob("*.npy")) == []


def test_a_run_with_a_large_map_is_resumed_with_that_map_only(tmp_path: Path) -> None:
    def stop(step: int, *_: object) -> None:
        if step == 3:
            raise KeyboardInterrupt

    case = rough_case(large()).with_values({"output.checkpoint_interval": 0})
    with pytest.raises(KeyboardInterrupt):
        case.run(tmp_path / "run", progress=stop)
    other = rough_case(large(2)).with_values({"output.checkpoint_interval": 0})
    with pytest.raises(InputError, match="is of another case"):
        other.run(tmp_path / "run", resume=True)
    resumed = case.run(tmp_path / "run", resume=True)
    np.testing.assert_array_equal(resumed.history["F_n"], case.run(in_memory=True).history["F_n"])


def test_a_case_with_a_large_map_is_copied_changed_and_written(tmp_path: Path) -> None:
    case = rough_case(large())
    again = pickle.loads(pickle.dumps(case))
    assert again.to_toml() == case.to_toml()
    changed = case.with_values({"rolling.load": "6 N"}).with_values({"upper.texture": large(2)})
    assert len(changed._text) + sum(map(len, changed._overrides)) < 2000
    assert Case(changed.to_toml()).to_toml() == changed.to_toml()
    changed.to_toml(tmp_path / "case.toml")
    assert sorted(path.suffix for path in tmp_path.iterdir()) == [".npy", ".npy", ".toml"]
    assert Case.from_file(tmp_path / "case.toml").to_toml() == changed.to_toml()


@pytest.mark.parametrize("kind", ["float64", "float32", "fortran"])
def test_a_case_names_a_file_of_numpy(kind: str, tmp_path: Path) -> None:
    heights = np.random.default_rng(4).normal(0.0, 1e-6, (5, 7)).astype(np.float32).astype(np.float64)
    stored = {"float64": heights, "float32": heights.astype(np.float32), "fortran": np.asfortranarray(heights)}[kind]
    np.save(tmp_path / "map.npy", stored)
    keys = {"type": "height_map", "file": str(tmp_path / "map.npy"), "spacing": [2e-5, 3e-5], "x": 1e-5, "y": -2e-5}
    of_file = rough_case(None).with_values({"lower.texture": keys})
    assert of_file.to_toml() == rough_case(HeightMap(heights, (2e-5, 3e-5), 1e-5, -2e-5)).to_toml()


def test_files_of_numpy_that_are_no_maps(tmp_path: Path) -> None:
    path = tmp_path / "map.npy"
    keys = {"type": "height_map", "file": str(path), "spacing": [2e-5, 3e-5]}
    for heights, wrong in (
        (np.arange(6), 'type "<i8"; allowed: float64 or float32'),
        (np.arange(6.0), "no rows and columns"),
        (np.array([[1.0, np.nan]]), "has in row 1, column 2 a height that is not finite; fill what was not measured"),
        (
            np.array([[1.0, 2, 3], [1, np.inf, np.nan]]),
            "has in row 2, column 2 a height that is not finite, the first of 2;",
        ),
        (np.array([[1.0, 2, 3], [np.nan, 2, 3]], order="F"), "in row 2, column 1"),
    ):
        np.save(path, heights)
        with pytest.raises(InputError, match=re.escape(wrong)):
            rough_case(None).with_values({"lower.texture": keys})
    path.write_text("1 2\n")
    with pytest.raises(InputError, match="is not a .npy file of NumPy"):
        rough_case(None).with_values({"lower.texture": keys})
