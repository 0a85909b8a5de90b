# SPDX-License-Identifier: BSD-3-Clause
"""A package for other processors says so before it ends in an illegal instruction."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import pytest

from brinell._built_for import FEATURES
from brinell._processor import require_processor

OLD = (
    "processor\t: 0\nmodel name\t: Nehalem\nflags\t\t: fpu sse sse2 pni ssse3 sse4_1 sse4_2 popcnt\n\nprocessor\t: 1\n"
)
V3 = {"avx", "avx2", "bmi1", "bmi2", "f16c", "fma", "abm", "movbe"}


@pytest.fixture
def old(tmp_path: Path) -> Path:
    path = tmp_path / "cpuinfo"
    path.write_text(OLD)
    return path


def test_a_processor_that_lacks_something_is_told_in_one_line(old: Path) -> None:
    with pytest.raises(
        ImportError, match=r"^this brinell is compiled for .*; this one has no abm, avx, avx2, .* baseline"
    ) as told:
        require_processor(V3, old)
    assert "\n" not in str(told.value)


def test_the_command_says_one_line_and_no_traceback(old: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(sys, "argv", ["/usr/bin/brinell", "run"])
    with pytest.raises(SystemExit, match=r"^brinell: error: this brinell is compiled for"):
        require_processor(V3, old)


def test_what_it_has_is_enough(old: Path, tmp_path: Path) -> None:
    require_processor({"sse4_2", "popcnt"}, old)
    require_processor(V3, tmp_path / "nowhere")  # another system: nothing is known
    require_processor(set(), old)


def test_this_one_has_what_it_was_compiled_for() -> None:
    """The names of the features are those of Linux: a wrong one would refuse every machine."""
    flags = Path("/proc/cpuinfo").read_text().split("flags", 1)[1].split("\n", 1)[0].split()
    assert set(flags) >= FEATURES


def test_the_features_of_v3_are_those_of_its_definition(tmp_path: Path) -> None:
    """System V ABI for x86-64: v3 has AVX, AVX2, BMI1, BMI2, F16C, FMA, LZCNT, MOVBE and all of v2."""
    root = Path(__file__).resolve().parents[2]
    script = tmp_path / "features.cmake"
    script.write_text(
        f"set(CMAKE_CXX_COMPILER c++)\ninclude({root}/cmake/processor_features.cmake)\n"
        "foreach(arch x86-64 x86-64-v2 x86-64-v3)\n"
        '  processor_features(found ${arch})\n  message("is;${found}")\n'
        "endforeach()\n"
    )
    told = subprocess.run(["cmake", "-P", script], check=True, capture_output=True, text=True).stderr
    baseline, v2, v3 = (set(line.split(";")) - {"is", ""} for line in told.splitlines())
    assert baseline == set()
    assert v2 == {"pni", "ssse3", "sse4_1", "sse4_2", "popcnt"}
    assert v3 == v2 | V3
