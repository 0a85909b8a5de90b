# SPDX-License-Identifier: BSD-3-Clause
"""The server of `brinell app`: what it does, and that no run is lost."""

import base64
import json
import os
import signal
import socket
import subprocess
import sys
from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from typing import Any

import numpy as np
import psutil
import pytest

import brinell
from app_server import SMALL, Server, request_text, served, tree
from brinell.app.case_text import text_of, values_of
from brinell.results import open_run

VALUES = values_of(SMALL)


@pytest.fixture(scope="module")
def home(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A folder with a case."""
    folder = tmp_path_factory.mktemp("home")
    (folder / "ball.toml").write_text(SMALL)
    return folder


@pytest.fixture(scope="module")
def server(home: Path, tmp_path_factory: pytest.TempPathFactory) -> Iterator[Server]:
    with served(home, tmp_path_factory.mktemp("settings")) as server:
        yield server


def test_a_case_is_saved_and_opened(server: Server, home: Path) -> None:
    server.asked("PUT", "/api/case", {"name": "new/one.toml", "values": VALUES, "replace": False})
    assert server.asked("GET", "/api/case?name=new/one.toml")["values"] == VALUES
    status, told = server.request("PUT", "/api/case", {"name": "new/one.toml", "values": {}, "replace": False})
    assert (status, told) == (422, {"error": "new/one.toml exists already"})
    assert values_of((home / "new" / "one.toml").read_text()) == VALUES


def test_a_run_is_that_of_the_command(server: Server, home: Path, tmp_path: Path) -> None:
    name = server.asked("POST", "/api/run", {"values": VALUES, "name": "ball"})["name"]
    assert server.ended(name)["state"] == "finished"
    here = server.asked("GET", f"/api/history?name={name}&from=0")
    assert here["complete"]
    subprocess.run(
        [sys.executable, "-m", "brinell", "run", "-q", str(home / "ball.toml"), "-o", str(tmp_path / "run")], check=True
    )
    there = open_run(tmp_path / "run").history
    assert set(here["columns"]) == set(there)
    for column, values in here["columns"].items():
        told = np.array([float("nan") if value is None else value for value in values])
        assert np.array_equal(told, there[column], equal_nan=True), column  # the same program, the same case
    outline = server.asked("GET", f"/api/outline?name={name}")
    assert brinell.Case(text_of(outline["values"]).text).to_toml() == brinell.Case(SMALL).to_toml()
    assert outline["complete"]
    later = server.asked("GET", f"/api/history?name={name}&from=4")
    assert later["columns"]["step"] == here["columns"]["step"][4:]
    status, told = server.request("POST", "/api/resume", {"name": name})
    assert (status, told["error"]) == (422, f"{name} has finished already")


def test_a_wrong_case_is_not_run(server: Server, home: Path) -> None:
    before = tree(home)
    status, told = server.request(
        "POST", "/api/run", {"values": {**VALUES, "lower.material.poisson_ratio": 0.7}, "name": "wrong"}
    )
    assert status == 422
    assert "lower.material.poisson_ratio = 0.7 is out of range" in told["error"]
    assert tree(home) == before


def long_case() -> dict[str, Any]:
    """A case that takes some seconds."""
    return {**VALUES, "indentation.steps": 60, "grid.resolution": 8}


def test_a_run_stops_and_goes_on(server: Server, home: Path) -> None:
    name = server.asked("POST", "/api/run", {"values": long_case(), "name": "long"})["name"]
    server.wait_until(lambda: server.job(name)["done"] >= 2, "two steps are done")
    server.asked("POST", "/api/stop", {"name": name})
    assert server.ended(name)["state"] == "stopped"
    history = server.asked("GET", f"/api/history?name={name}&from=0")
    assert not history["complete"]
    assert len(history["columns"]["step"]) >= 2
    server.asked("POST", "/api/resume", {"name": name})
    assert server.ended(name)["state"] == "finished"
    assert open_run(home / name).complete


def test_ten_tabs_work_at_once(server: Server) -> None:
    def tab(number: int) -> tuple[int, int]:
        values = {**VALUES, "indentation.load": [f"{10 + number} N", 0]}
        checked = server.asked("POST", "/api/check", {"values": values, "park": True})
        assert checked["errors"] == []
        body = {"values": values, "shown": {"kind": "map", "name": "pressure"}, "tab": str(number)}
        lines = [json.loads(line) for line in server.asked("POST", "/api/preview", body).splitlines()]
        assert not any("error" in line for line in lines)
        run = server.asked("POST", "/api/run", {"values": values, "name": "tab"})["name"]
        assert server.ended(run)["state"] == "finished"
        steps = sum(len(line["columns"]["step"]) for line in lines if line.get("columns"))
        columns = server.asked("GET", f"/api/history?name={run}&from=0")["columns"]
        assert max(columns["F_n"]) == pytest.approx(10 + number, rel=1e-4)
        return steps, len(columns["step"])

    with ThreadPoolExecutor(10) as pool:
        counts = list(pool.map(tab, range(10)))
    assert all(steps == rows > 5 for steps, rows in counts)


def test_a_closed_tab_harms_no_other(server: Server) -> None:
    body = json.dumps({"values": long_case(), "shown": {}, "tab": "closed"}).encode()
    with socket.create_connection(("127.0.0.1", server.port)) as connection:
        connection.sendall(request_text(server, "POST", "/api/preview", body=body))
        assert connection.recv(20)
    with socket.create_connection(("127.0.0.1", server.port)) as connection:  # not even its request is whole
        connection.sendall(request_text(server, "POST", "/api/check", body=body)[:-40])
    again = {"values": VALUES, "shown": {}, "tab": "other"}
    lines = server.asked("POST", "/api/preview", again).splitlines()
    assert "picture" in json.loads(lines[-1])


def test_a_slider_that_moves_on_gives_up_its_run(server: Server) -> None:
    body = {"values": long_case(), "shown": {}, "tab": "slider"}
    with socket.create_connection(("127.0.0.1", server.port), timeout=60) as connection:
        connection.sendall(request_text(server, "POST", "/api/preview", body=json.dumps(body).encode()))
        first = connection.recv(20)  # the server has its request
        lines = server.asked("POST", "/api/preview", {**body, "values": VALUES}).splitlines()
        assert "picture" in json.loads(lines[-1])
        while part := connection.recv(65536):
            first += part
    assert b"200" in first
    assert b"picture" not in first


def test_a_case_that_takes_long_is_no_preview(server: Server) -> None:
    values = {**VALUES, "grid.resolution": 60, "indentation.steps": 500}
    lines = server.asked("POST", "/api/preview", {"values": values, "shown": {}, "tab": "t"}).splitlines()
    assert "run it instead" in json.loads(lines[-1])["error"]


def test_a_sweep_has_its_figure(server: Server) -> None:
    body = {
        "values": VALUES,
        "name": "sweep",
        "key": "lower.material.hardening.yield_stress",
        "over": ["1 GPa", "2 GPa"],
    }
    name = server.asked("POST", "/api/sweep", body)["name"]
    job = server.ended(name)
    assert (job["state"], job["done"]) == ("finished", 2)
    figures = server.asked("GET", f"/api/figures?name={name}")
    assert [one["name"] for one in figures] == ["sweep"]
    assert figures[0]["source"].startswith("data:image/svg+xml;base64,")
    status, told = server.request("POST", "/api/sweep", {**body, "over": ["1 GPa", "2 kg"]})
    assert status == 422
    assert "is a mass" in told["error"]


def test_a_sweep_stops_with_all_its_processes(server: Server) -> None:
    def runner() -> psutil.Process | None:
        children = psutil.Process(server.process.pid).children()
        return next((one for one in children if "brinell.app.runner" in one.cmdline()), None)

    body = {"values": long_case(), "name": "stopped", "key": "lower.material.hardening.yield_stress"}
    name = server.asked("POST", "/api/sweep", {**body, "over": [f"{900 + i} MPa" for i in range(40)]})["name"]
    server.wait_until(lambda: (server.folder / name / "sweep.json").exists(), "the sweep has begun")
    process = runner()
    assert process is not None
    working = server.wait_until(lambda: process.children(recursive=True), "its processes have begun")
    server.asked("POST", "/api/stop", {"name": name})
    assert server.ended(name)["state"] == "stopped"
    server.wait_until(lambda: not any(one.is_running() for one in (process, *working)), "all its processes have ended")


def test_a_fit_of_the_folder_is_shown(server: Server, home: Path) -> None:
    """As `brinell fit` leaves it: fit.json, and pictures."""
    folder = home / "results" / "fit" / "figures"
    folder.mkdir(parents=True)
    (folder.parent / "fit.json").write_text("{}")
    picture = b"\x89PNG\r\n\x1a\n and so on"
    (folder / "curve.png").write_bytes(picture)
    (folder / "secret.png").symlink_to(home.parent / "secret.toml")
    assert {"kind": "fit", "name": "results/fit"}.items() <= next(
        one for one in server.asked("GET", "/api/files")["entries"] if one["kind"] == "fit"
    ).items()
    (figure,) = server.asked("GET", "/api/figures?name=results/fit")
    assert figure["name"] == "curve"
    assert base64.b64decode(figure["source"].partition("base64,")[2]) == picture


def test_own_materials_are_kept_in_the_settings(server: Server, tmp_path: Path) -> None:
    values = {"young_modulus": "190 GPa", "poisson_ratio": 0.28, "hardening.law": "perfect"}
    stored = server.asked("PUT", "/api/material", {"name": "our steel", "source": "measured", "values": values})
    mine = [one for one in stored["materials"] if one["own"]]
    assert mine == [{"name": "our steel", "source": "measured", "own": True, "values": values}]
    assert all(one["source"] for one in stored["materials"])
    for name in ("", "S235", "a\nb", "x" * 100):
        status, _ = server.request("PUT", "/api/material", {"name": name, "source": "", "values": values})
        assert status == 422, name
    left = server.asked("DELETE", "/api/material", {"name": "our steel"})["materials"]
    assert not any(one["own"] for one in left)


def test_a_killed_server_loses_no_run(tmp_path: Path) -> None:
    with served(tmp_path, tmp_path / "settings") as server:
        finished = server.asked("POST", "/api/run", {"values": VALUES, "name": "first"})["name"]
        assert server.ended(finished)["state"] == "finished"
        running = server.asked("POST", "/api/run", {"values": long_case(), "name": "second"})["name"]
        server.wait_until(lambda: server.job(running)["done"] >= 2, "two steps are done")
        os.kill(server.process.pid, signal.SIGKILL)
        server.process.wait()
        server.wait_until(lambda: (tmp_path / running / "summary.json").is_file(), "the run goes on to its end")
    with served(tmp_path, tmp_path / "settings") as server:
        runs = {one["name"]: one["complete"] for one in server.asked("GET", "/api/files")["entries"]}
        assert runs == {finished: True, running: True}
        for name in runs:
            assert server.asked("GET", f"/api/outline?name={name}")["complete"]


def test_a_run_of_a_killed_server_is_followed_and_stopped(tmp_path: Path) -> None:
    with served(tmp_path, tmp_path / "settings") as server:
        name = server.asked("POST", "/api/run", {"values": {**long_case(), "indentation.steps": 600}, "name": "left"})[
            "name"
        ]
        server.wait_until(lambda: server.job(name)["done"] >= 2, "two steps are done")
        os.kill(server.process.pid, signal.SIGKILL)
        server.process.wait()
    with served(tmp_path, tmp_path / "settings") as server:
        job = server.wait_until(lambda: server.job(name), "the run is seen")
        assert (job["state"], job["elsewhere"]) == ("running", True)
        assert job["done"] >= 2
        status, told = server.request("POST", "/api/resume", {"name": name})
        assert (status, told["error"]) == (422, f"{name} is still being computed")
        server.asked("POST", "/api/stop", {"name": name})
        server.wait_until(lambda: server.job(name) is None, "its process has ended")
        assert server.asked("POST", "/api/resume", {"name": name})["state"] == "waiting"
        server.wait_until(lambda: server.job(name)["done"] > job["done"], "it goes on")
        server.asked("POST", "/api/stop", {"name": name})
        assert server.ended(name)["state"] == "stopped"
        assert server.job(name)["seconds"] > 0


def test_an_ended_server_stops_its_run_at_a_step(tmp_path: Path) -> None:
    with served(tmp_path, tmp_path / "settings") as server:
        name = server.asked("POST", "/api/run", {"values": long_case(), "name": "long"})["name"]
        server.wait_until(lambda: server.job(name)["done"] >= 2, "two steps are done")
        assert server.close() == 0
    history = open_run(tmp_path / name, allow_unfinished=True).history
    assert history.steps >= 2
    with served(tmp_path, tmp_path / "settings") as server:
        server.asked("POST", "/api/resume", {"name": name})
        assert server.ended(name)["state"] == "finished"


def test_a_full_disk_loses_no_finished_run(tmp_path: Path) -> None:
    """A limit on the size of files refuses to write as a full disk does."""
    with served(tmp_path, tmp_path / "settings") as server:
        finished = server.asked("POST", "/api/run", {"values": VALUES, "name": "first"})["name"]
        assert server.ended(finished)["state"] == "finished"
        server.asked("PUT", "/api/case", {"name": "ball.toml", "values": VALUES, "replace": False})
    before = tree(tmp_path / finished)
    with served(tmp_path, tmp_path / "settings", largest_file=2000) as server:
        failed = server.asked("POST", "/api/run", {"values": VALUES, "name": "first"})["name"]
        job = server.ended(failed)
        assert job["state"] == "failed"
        assert "cannot be written" in job["error"] or "could not" in job["error"] or "File too large" in job["error"]
        larger = {**VALUES, "title": "x" * 5000}
        status, told = server.request("PUT", "/api/case", {"name": "ball.toml", "values": larger, "replace": True})
        assert (status, told) == (422, {"error": "ball.toml could not be written: File too large"})
        assert server.asked("GET", f"/api/outline?name={finished}")["complete"]
    assert tree(tmp_path / finished) == before
    assert values_of((tmp_path / "ball.toml").read_text()) == VALUES
    assert not list(tmp_path.glob(".*.part"))
