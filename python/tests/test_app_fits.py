# SPDX-License-Identifier: BSD-3-Clause
"""Fits of `brinell app`: they are those of the command, and none that has finished is lost."""

import json
import os
import shutil
import signal
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import brinell
from app_server import Server, served, tree
from brinell.app.case_text import values_of
from test_fit import measured

pytest.importorskip("scipy")

CASE = """scenario = "indentation"
title = "a ball"
[lower]
shape = { type = "flat" }
[lower.material]
young_modulus = "210 GPa"
poisson_ratio = 0.3
hardening = { law = "linear", yield_stress = "1.2 GPa", modulus = "5 GPa" }
[upper]
shape = { type = "sphere", radius = "1 mm" }
material = { rigid = true }
[indentation]
load = ["600 N", 0]
steps = 5
[grid]
resolution = 4
"""
VALUES = values_of(CASE)
YIELD = "lower.material.hardening.yield_stress"
TRUTH = 900e6


def measured_curve() -> str:
    """A curve of a softer steel in um and N, with 1 % of noise."""
    depth, load = measured(brinell.Case(CASE).with_values({YIELD: TRUTH}))
    noise = 0.01 * np.maximum(load, 0.05 * load.max()) * np.random.default_rng(1).standard_normal(load.size)
    lines = [f"{1e6 * x:.5f}; {y:.4f}" for x, y in zip(depth, load + noise, strict=True)]
    return "\n".join(["depth in um; load in N", *lines]) + "\n"


def asked(**changes: Any) -> dict[str, Any]:
    """A fit of the yield stress, as the page asks for it."""
    return {
        "unknowns": [{"key": YIELD, "low": "300 MPa", "high": "3 GPa"}],
        "file": "ball.csv",
        "text": "",
        "name": "ball.csv",
        "columns": ["approach", "F_n"],
        "x": 1,
        "y": 2,
        "units": {"x": "um", "y": "N"},
        "reverse": [],
        "noise": "1 %",
        "loss": "linear",
        "method_error": "1 %",
        **changes,
    }


@pytest.fixture(scope="module")
def server(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Server]:
    folder = tmp_path_factory.mktemp("fits")
    (folder / "ball.csv").write_text(measured_curve())
    with served(folder, tmp_path_factory.mktemp("settings")) as server:
        yield server


def begun(server: Server, **changes: Any) -> str:
    """The name of a fit that has begun."""
    body = {"values": VALUES, "name": "ball-fit", "fit": asked(**changes)}
    name: str = server.asked("POST", "/api/fit", body)["name"]
    return name


def told(server: Server, name: str) -> Any:
    """What is known of a fit."""
    return server.asked("GET", f"/api/fit?name={name}")


def slow() -> dict[str, Any]:
    """A case of which a fit takes long."""
    return {**VALUES, "grid.resolution": 12, "indentation.steps": 40}


def test_a_fit_is_that_of_the_command(server: Server, tmp_path: Path) -> None:
    name = begun(server)
    stages = set()

    def ended() -> bool:
        seen = told(server, name)
        if not seen["complete"]:
            stages.add(seen.get("stage"))
        job = server.job(name)
        assert job["kind"] == "fit"
        return job["state"] not in ("waiting", "running")

    server.wait_until(ended, "the fit has ended")
    assert server.job(name)["state"] == "finished", server.job(name)
    assert len(stages) > 2  # its progress is told
    result = told(server, name)
    assert result["complete"]
    ((key, sizes),) = [(one["key"], one["sizes"]) for one in result["values"]]
    assert key == YIELD
    (found,) = json.loads((server.folder / name / "fit.json").read_text())["unknowns"]
    assert found["low"] < TRUTH < found["high"]
    assert sizes["MPa"] == pytest.approx(found["value"] / 1e6, rel=1e-5)
    assert sizes[""] == pytest.approx(1e6 * sizes["MPa"], rel=1e-5)

    folder = server.folder / name
    assert not (folder / "progress.json").exists()
    shutil.copytree(folder, tmp_path / "again", ignore=shutil.ignore_patterns("*.json", "figures", "report.html"))
    command = [sys.executable, "-m", "brinell", "fit", "again/fit.toml", "-o", "results", "--no-figures"]
    printed = subprocess.run(command, cwd=tmp_path, check=True, capture_output=True, text=True).stdout
    here, there = (json.loads((one / "fit.json").read_text()) for one in (folder, tmp_path / "results"))
    for varies in ("wall_time_s", "versions"):
        del here[varies], there[varies]
    assert here == there  # to the last digit
    for row in result["rows"]:
        for cell in row:
            assert cell in printed
    assert result["text"] == (folder / "fit.toml").read_text()
    assert [one["name"] for one in server.asked("GET", f"/api/figures?name={name}")]


def test_what_is_wrong_stands_at_its_field(server: Server) -> None:
    def wrong(values: dict[str, Any] | None = None, **changes: Any) -> list[tuple[str, str]]:
        body = {"values": values or VALUES, "fit": asked(**changes)}
        return [(one["field"], one["text"]) for one in server.asked("POST", "/api/fit-check", body)["errors"]]

    def unknown(low: Any, high: Any, key: str = YIELD) -> list[Any]:
        return [{"key": key, "low": low, "high": high}]

    assert wrong() == []
    cases: list[tuple[str, str, dict[str, Any]]] = [
        ("unknowns[0].low", "is a mass", {"unknowns": unknown("3 kg", "3 GPa")}),
        ("unknowns[0].high", "is not above", {"unknowns": unknown("3 GPa", "1 GPa")}),
        ("unknowns[0].low", "", {"unknowns": unknown("", "1 GPa")}),
        ("unknowns[0].key", "no such key", {"unknowns": unknown(1, 2, "lower.material.yeild")}),
        ("unknowns[0].key", "belongs to the computation", {"unknowns": unknown(1, 2, "grid.resolution")}),
        ("add", "add a key", {"unknowns": []}),
        ("y", "column 3", {"y": 3}),
        ("units.x", "kg", {"units": {"x": "kg", "y": "N"}}),
        ("reverse.y", "negative", {"reverse": ["y"]}),
        ("noise", "above 0", {"noise": "-1 %"}),
        ("noise", "3 s", {"noise": "3 s"}),
        ("method_error", "allowed", {"method_error": "80 %"}),
        ("file", "is no file", {"file": "missing.csv"}),
        ("file", "no line with two numbers", {"file": "", "text": "no numbers\n"}),
        ("file", "there is no measured curve", {"file": ""}),
        ("", "loss", {"loss": "quadratic"}),
        ("", "machine.drift", {"unknowns": unknown("-1 um/s", "1 um/s", "machine.drift")}),
    ]
    for place, text, changes in cases:
        found = wrong(**changes)
        assert [one[0] for one in found] == [place], (changes, found)
        assert text in found[0][1], found
        assert str(server.folder) not in found[0][1] or place == "file", found  # names of files, no paths
    assert [one[0] for one in wrong({**VALUES, "lower.material.poisson_ratio": 0.7})] == ["case"]
    two = wrong(unknowns=[*unknown("3 kg", "3 GPa"), *unknown(2, 1, "machine.compliance")], noise="0 %")
    assert [one[0] for one in two] == ["noise", "unknowns[0].low", "unknowns[1].high"]  # all at once
    before = tree(server.folder)
    for changes in ({"noise": "-1 %"}, {"unknowns": [{"key": 3, "low": 1, "high": 2}]}, {"x": True}, {"more": 1}):
        body = {"values": VALUES, "name": "wrong", "fit": asked(**changes)}
        assert server.request("POST", "/api/fit", body)[0] == 422, changes
    assert tree(server.folder) == before


def test_a_fit_reads_nothing_outside_the_folder(server: Server) -> None:
    (server.folder.parent / "secret.csv").write_text("1 2\n3 4\n5 6\n")
    (server.folder / "link.csv").symlink_to(server.folder.parent / "secret.csv")
    for file in ("../secret.csv", "link.csv", "/etc/hostname", "a/../../secret.csv"):
        body = {"values": VALUES, "fit": asked(file=file)}
        (error,) = server.asked("POST", "/api/fit-check", body)["errors"]
        assert error["field"] == "file", file
        assert server.request("GET", f"/api/curve?name={file}")[0] == 422, file
    (server.folder / "link.csv").unlink()
    told = server.asked("POST", "/api/fit-check", {"values": VALUES, "fit": asked(name='../"x".csv')})
    assert 'file = "measured-ball.csv"' in told["text"]


def test_a_case_with_files_is_fitted_where_it_lies(server: Server) -> None:
    """The case of a fit lies in the folder of its results, and names files from there."""
    np.save(server.folder / "heights.npy", np.full((8, 8), 1e-9))
    values = {
        **VALUES,
        "lower.texture[0].type": "height_map",
        "lower.texture[0].file": "heights.npy",
        "lower.texture[0].spacing": ["10 mm", "10 mm"],
    }
    name = server.asked("POST", "/api/fit", {"values": values, "name": "map", "fit": asked()})["name"]
    assert server.ended(name)["state"] == "finished", server.job(name)
    assert 'file = "../../heights.npy"' in (server.folder / name / "case.toml").read_text()
    assert brinell.Case.from_file(server.folder / name / "fitted.toml").scenario == "indentation"


def test_columns_of_the_history_are_fitted(server: Server) -> None:
    changes = {"columns": ["step", "dissipation_lower"], "file": "", "name": "work.csv", "units": {"x": "", "y": "mJ"}}
    rows = list(brinell.Case(CASE).with_values({YIELD: TRUTH}).steps(threads=1))
    text = "\n".join(f"{row['step']} {row['dissipation_lower'] * 1e3:.6g}" for row in rows)
    name = begun(server, **changes, text=text)
    assert server.ended(name)["state"] == "finished", server.job(name)
    result = told(server, name)
    assert result["values"][0]["sizes"]["MPa"] == pytest.approx(900.0, rel=0.01)
    assert result["curves"][0]["columns"] == ["step", "dissipation_lower"]


def test_a_fit_stops_at_once_and_begins_again(server: Server) -> None:
    name = server.asked("POST", "/api/fit", {"values": slow(), "name": "slow", "fit": asked()})["name"]
    server.wait_until(lambda: told(server, name).get("runs"), "a run has ended")
    status, answer = server.request("POST", "/api/resume", {"name": name})
    assert (status, "still being computed" in answer["error"]) == (422, True)
    server.asked("POST", "/api/stop", {"name": name})
    assert server.ended(name)["state"] == "stopped"
    left = told(server, name)
    assert (left["complete"], left["running"]) == (False, False)
    assert left["runs"] > 0  # what was known of it stays
    entry = next(one for one in server.asked("GET", "/api/files")["entries"] if one["name"] == name)
    assert (entry["kind"], entry["complete"]) == ("fit", False)
    server.asked("POST", "/api/resume", {"name": name})
    server.wait_until(lambda: told(server, name)["running"], "it is computed again")
    server.asked("POST", "/api/stop", {"name": name})
    server.ended(name)


def test_a_killed_server_loses_no_fit(tmp_path: Path) -> None:
    (tmp_path / "ball.csv").write_text(measured_curve())
    with served(tmp_path, tmp_path / "settings") as server:
        finished = begun(server)
        assert server.ended(finished)["state"] == "finished"
        before = tree(tmp_path / finished)
        running = begun(server)
        server.wait_until(lambda: told(server, running)["running"], "the fit has begun")
        os.kill(server.process.pid, signal.SIGKILL)
        server.process.wait()
    with served(tmp_path, tmp_path / "settings") as server:
        server.wait_until(lambda: told(server, running)["complete"], "the fit goes on to its end")
        assert tree(tmp_path / finished) == before
        assert told(server, finished)["rows"] == told(server, running)["rows"]
