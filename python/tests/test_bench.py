# SPDX-License-Identifier: BSD-3-Clause
"""The recorded benchmarks: their page is rendered from them, and their growth is that of the theory."""

import importlib.util
import math
import sys
from pathlib import Path
from types import ModuleType
from typing import Any

import pytest

BENCH = Path(__file__).resolve().parents[2] / "bench"


def script(name: str) -> ModuleType:
    """A script of bench/ as a module."""
    spec = importlib.util.spec_from_file_location(f"bench_{name}", BENCH / f"{name}.py")
    assert spec is not None
    assert spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    sys.modules[spec.name] = module
    spec.loader.exec_module(module)
    return module


record = script("record")
render = script("render")


def entry(name: str, time: float, **others: Any) -> dict[str, Any]:
    """A benchmark as Google Benchmark reports it."""
    run = {"name": name, "run_name": name, "run_type": "iteration", "repetitions": 1, "threads": 1}
    return {**run, "iterations": 7, "real_time": time, "cpu_time": time, "time_unit": "us", **others}


def report(*entries: dict[str, Any]) -> dict[str, Any]:
    return {"context": {"date": "2030-01-02T03:04:05", "commit": "abc", "threads": "2"}, "benchmarks": list(entries)}


def test_rows_name_date_commit_machine_threads_and_unit() -> None:
    measured = report(entry("solve/3/manual_time", 123456.0, bytes_per_cell=256.7, iterations_used=9.0))
    cells = [list(row.values()) for row in record.rows(measured, "m")]
    head = ["2030-01-02", "abc", "m", "2", "solve/3"]
    assert cells == [
        [*head, "time", "123", "ms"],
        [*head, "bytes_per_cell", "257", "B"],
        [*head, "iterations_used", "9", "1"],
    ]


def test_of_repeated_runs_the_median_is_taken() -> None:
    runs = [entry("solve", time, repetitions=3) for time in (1.0, 9.0, 2.0)]
    median = entry("solve_median", 2.0, repetitions=3, run_name="solve", run_type="aggregate", aggregate_name="median")
    mean = entry("solve_mean", 4.0, repetitions=3, run_name="solve", run_type="aggregate", aggregate_name="mean")
    assert [(row["benchmark"], row["value"]) for row in record.rows(report(*runs, mean, median), "m")] == [
        ("solve", "2")
    ]


def test_a_benchmark_that_failed_is_no_row() -> None:
    failed = entry("solve", 1.0, error_occurred=True, error_message="not converged")
    with pytest.raises(SystemExit, match="not converged"):
        list(record.rows(report(failed), "m"))


def test_the_page_is_rendered_from_the_results() -> None:
    page = render.PAGE.read_text(encoding="utf-8")
    assert render.updated(page, render.read_rows()) == page, "bench/render.py writes it"


def test_residual_stress_grows_as_n_log_n() -> None:
    times: dict[tuple[str, str, str], dict[int, float]] = {}
    for row in render.read_rows():
        name, _, refinement = row["benchmark"].partition("/")
        if name == "residual_stress" and row["quantity"] == "time":
            seconds = float(row["value"]) * {"us": 1e-6, "ms": 1e-3, "s": 1.0}[row["unit"]]
            times.setdefault((row["commit"], row["machine"], row["threads"]), {})[int(refinement)] = seconds
    latest = list(times.values())[-1]
    coarse, fine = min(latest), max(latest)
    exponent = math.log(latest[fine] / latest[coarse]) / math.log((fine / coarse) ** 3)
    # N log N is 1.08 over these grids, and the fine one leaves the cache; a kernel per pair of layers would be 1.33.
    assert 1.0 < exponent < 1.2
