# SPDX-License-Identifier: BSD-3-Clause
"""The server of `brinell app`: whom it refuses, what it keeps, and that no run is lost."""

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
import pytest

import brinell
from app_server import SMALL, Server, served
from brinell.app.case_text import text_of, values_of
from brinell.app.folder import Folder
from brinell.app.guard import LARGEST_BODY
from brinell.results import open_run

VALUES = values_of(SMALL)
SECRET = "the secret of another folder"


@pytest.fixture(scope="module")
def home(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A folder with a case and links that lead outside, beside a secret."""
    around = tmp_path_factory.mktemp("around")
    (around / "secret.toml").write_text(f'scenario = "{SECRET}"\n')
    run = around / "outer-run"
    brinell.Case(SMALL, overrides=["grid.resolution=6"]).run(run)
    folder = around / "home"
    folder.mkdir()
    (folder / "ball.toml").write_text(SMALL)
    (folder / "link.toml").symlink_to(around / "secret.toml")
    (folder / "link").symlink_to(around)
    (folder / "half").mkdir()
    for file in run.iterdir():
        (folder / "half" / file.name).symlink_to(file)
    return folder


@pytest.fixture(scope="module")
def server(home: Path, tmp_path_factory: pytest.TempPathFactory) -> Iterator[Server]:
    with served(home, tmp_path_factory.mktemp("settings")) as server:
        yield server


def tree(folder: Path) -> dict[str, Any]:
    """Everything in a folder, with sizes and contents of small files."""
    return {
        str(path.relative_to(folder)): path.read_bytes() if path.is_file() and path.stat().st_size < 10_000 else None
        for path in sorted(folder.rglob("*"))
    }


def request_text(
    server: Server,
    method: str = "GET",
    path: str = "/api/files",
    *,
    body: bytes = b"",
    without: tuple[str, ...] = (),
    **headers: str,
) -> bytes:
    """A request as bytes, as the page would say it but for what is given."""
    all_headers = {"Host": f"127.0.0.1:{server.port}", "X-Brinell-Token": server.token}
    if body:
        all_headers |= {"Content-Type": "application/json", "Content-Length": str(len(body))}
    all_headers |= {name.replace("_", "-"): value for name, value in headers.items()}
    lines = [f"{name}: {value}" for name, value in all_headers.items() if name not in without]
    return "\r\n".join([f"{method} {path} HTTP/1.1", *lines, "Connection: close", "", ""]).encode("latin-1") + body


def hostile(server: Server) -> Iterator[tuple[str, bytes]]:
    """Requests that the page never makes."""
    port = server.port
    check = json.dumps({"values": VALUES, "park": False}).encode()
    hosts = ("", "evil.example", f"evil.example:{port}", "127.0.0.1", "127.0.0.1:1", f"127.0.0.1.evil.example:{port}")
    for host in (
        *hosts,
        f"0.0.0.0:{port}",
        f"[::1]:{port}",
        f"2130706433:{port}",
        f"127.1:{port}",
        f"a@127.0.0.1:{port}",
    ):
        yield f"host {host}", request_text(server, Host=host)
    yield "no host", request_text(server, without=("Host",))
    yield "two hosts", request_text(server).replace(b"\r\n", b"\r\nHost: evil.example\r\n", 1)
    origins = ("null", "http://evil.example", "https://127.0.0.1", f"https://127.0.0.1:{port}", "http://127.0.0.1:1")
    for origin in (*origins, f"http://127.0.0.1:{port}.evil.example", f"http://localhost:{port}/x", "file://", ""):
        yield f"origin {origin}", request_text(server, Origin=origin)
        yield f"post of {origin}", request_text(server, "POST", "/api/check", body=check, Origin=origin)
    for site in ("cross-site", "same-site", "", "else"):
        yield f"site {site}", request_text(server, Sec_Fetch_Site=site)
        yield f"page for {site}", request_text(server, path=f"/?token={server.token}", Sec_Fetch_Site=site)
    for path, mode, kind in (
        ("/", "cors", "empty"),
        ("/", "navigate", "iframe"),
        ("/api/files", "navigate", "document"),
    ):
        text = request_text(
            server,
            path=f"{path}?token={server.token}",
            Sec_Fetch_Site="cross-site",
            Sec_Fetch_Mode=mode,
            Sec_Fetch_Dest=kind,
        )
        yield f"{mode} of another site to {path} for {kind}", text
    for token in ("", "x", server.token[:-1], server.token + "x", server.token.swapcase(), "é", "0" * 3000):
        yield f"token {token[:10]}", request_text(server, X_Brinell_Token=token)
        yield f"page with {token[:10]}", request_text(server, path=f"/?token={token}".replace("é", "%C3%A9"))
    yield "no token", request_text(server, without=("X-Brinell-Token",))
    yield (
        "token of the address for the interface",
        request_text(server, path=f"/api/files?token={server.token}", without=("X-Brinell-Token",)),
    )
    yield "two tokens", request_text(server).replace(b"\r\n", b"\r\nX-Brinell-Token: x\r\n", 1)
    for path in ("/static/plotly.js", "/static/app.js", "/"):
        yield f"{path} without token", request_text(server, path=path)
    for method in ("HEAD", "OPTIONS", "TRACE", "PATCH", "CONNECT", "PROPFIND", "BREW", "get"):
        yield f"method {method}", request_text(server, method)
    for path in ("/api/check", "/api/run", "/api/stop", "/api/preview"):
        yield f"GET of {path}", request_text(server, path=path)
    for path in ("/api/start", "/api/files", "/api/history"):
        yield f"POST to {path}", request_text(server, "POST", path, body=b"{}")
    token = f"token={server.token}"
    names = ("../app.py", "..%2fcli.py", "%2e%2e/cli.py", "..\\cli.py", "cli.py", "/etc/passwd", "app.js%00", "")
    for name in names:
        yield f"static {name}", request_text(server, path=f"/static/{name}?{token}")
    for path in (
        "/../../etc/passwd",
        "//etc/passwd",
        "/api/../api/files",
        "/api/./files",
        "/etc/passwd",
        "/api/nothing",
    ):
        yield f"path {path}", request_text(server, path=f"{path}?{token}")
    yield "absolute address", request_text(server, path="http://evil.example/api/files")
    yield "long address", request_text(server, path="/api/files?" + "x" * 5000)
    yield "very long address", request_text(server, path="/api/files?" + "x" * 200_000)
    yield "many headers", request_text(server, **{f"X_{i}": "y" * 500 for i in range(200)})
    cases = ("../secret.toml", "link.toml", "link/secret.toml", "/etc/passwd", "half/../../secret.toml", "x\0.toml")
    for name in (*cases, ".hidden.toml", "a\\..\\..\\secret.toml", "ball.toml/", "", "x" * 3000 + ".toml", "results"):
        quoted = "".join(f"%{byte:02x}" for byte in name.encode())
        yield f"case {name[:20]!r}", request_text(server, path=f"/api/case?name={quoted}")
        body = json.dumps({"name": name, "values": VALUES, "replace": True}).encode()
        yield f"writing {name[:20]!r}", request_text(server, "PUT", "/api/case", body=body)
    for name in ("../outer-run", "link/outer-run", "half", "/tmp", "nothing", "..", ".", "link"):
        yield f"history of {name}", request_text(server, path=f"/api/history?name={name}")
        yield f"outline of {name}", request_text(server, path=f"/api/outline?name={name}")
        yield f"figures of {name}", request_text(server, path=f"/api/figures?name={name}")
        body = json.dumps({"name": name, "state": "final", "shown": {}}).encode()
        yield f"picture of {name}", request_text(server, "POST", "/api/picture", body=body)
        yield f"stop {name}", request_text(server, "POST", "/api/stop", body=json.dumps({"name": name}).encode())
    for name in ("../x", "/tmp/x", "a/b", "..", "link/x", "", ".x", "x\0"):
        body = json.dumps({"name": name, "values": VALUES}).encode()
        yield f"run to {name!r}", request_text(server, "POST", "/api/run", body=body)
    for key in ("lower.texture[0].file", "lower.material.hardening.file", "output.directory"):
        values = {**VALUES, "lower.texture[0].type": "height_map", key: "../secret.toml"}
        body = json.dumps({"name": "x", "values": values}).encode()
        yield f"run with {key}", request_text(server, "POST", "/api/run", body=body)
    for kind in ("text/plain", "application/x-www-form-urlencoded", "multipart/form-data", ""):
        yield f"type {kind}", request_text(server, "POST", "/api/check", body=check, Content_Type=kind)
    for body in (
        b"x",
        b"[]",
        b"3",
        b"{}",
        b'{"values": 3}',
        b"[" * 100_000,
        b'{"values": {"a": NaN}, "park": true}',
        b"\xff",
    ):
        yield f"body {body[:20]!r}", request_text(server, "POST", "/api/check", body=body)
    yield "large body", request_text(server, "POST", "/api/check", body=b" " * (LARGEST_BODY + 1))
    yield "said to be large", request_text(server, "POST", "/api/check", body=b"{}", Content_Length=str(10**12))
    yield "negative length", request_text(server, "POST", "/api/check", body=b"{}", Content_Length="-1")
    part = b"20000\r\n" + b" " * 0x20000 + b"\r\n"
    chunked = request_text(server, "POST", "/api/check", Content_Type="application/json", Transfer_Encoding="chunked")
    yield "large in parts", chunked + part * 12 + b"0\r\n\r\n"
    yield (
        "socket of the web",
        request_text(
            server,
            Connection="Upgrade",
            Upgrade="websocket",
            Sec_WebSocket_Key="dGhlIHNhbXBsZSBub25jZQ==",
            Sec_WebSocket_Version="13",
            Origin="http://evil.example",
        ),
    )
    yield "no HTTP", b"\x16\x03\x01\x02\x00\x01" * 20
    yield "an old one", b"GET /api/files\r\n\r\n"
    yield "folded header", request_text(server).replace(b"Connection", b" Connection", 1)


def test_hostile_requests_are_refused(server: Server, home: Path) -> None:
    before, jobs = tree(home.parent), server.asked("GET", "/api/files")["jobs"]
    tried = 0
    for what, text in hostile(server):
        status, answer = server.raw(text)
        assert status == 0 or 400 <= status < 500, (what, status, answer[:300])
        assert SECRET.encode() not in answer, what
        assert b"root:" not in answer, what
        assert server.token.encode() not in answer, what
        tried += 1
    assert tried >= 150
    assert tree(home.parent) == before
    assert server.asked("GET", "/api/files")["jobs"] == jobs  # and it still answers the page


def test_only_this_machine_is_listened_to(server: Server) -> None:
    listening = Path("/proc/net/tcp").read_text() + Path("/proc/net/tcp6").read_text()
    addresses = {
        line.split()[1] for line in listening.splitlines() if f":{server.port:04X} " in line and " 0A " in line
    }
    assert addresses == {f"0100007F:{server.port:04X}"}
    others = {one[4][0] for one in socket.getaddrinfo(socket.gethostname(), None, socket.AF_INET)} - {"127.0.0.1"}
    for address in others:
        with pytest.raises(OSError, match="refused|unreachable|timed out"):
            socket.create_connection((address, server.port), timeout=2).close()


def test_answers_keep_to_the_page(server: Server) -> None:
    status, answer = server.raw(request_text(server, path=f"/?token={server.token}", Sec_Fetch_Site="none"))
    assert status == 200
    head = answer.split(b"\r\n\r\n")[0].decode().lower()
    for header in (
        "content-security-policy: default-src 'none'",
        "x-frame-options: deny",
        "referrer-policy: no-referrer",
    ):
        assert header in head
    assert "access-control" not in head
    assert "http://" not in answer.split(b"\r\n\r\n", 1)[1].decode().replace("http://www.w3.org/", "")


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
    def preview(values: dict[str, Any]) -> list[Any]:
        body = {"values": values, "shown": {}, "tab": "slider"}
        return [json.loads(line) for line in server.asked("POST", "/api/preview", body).splitlines()]

    with ThreadPoolExecutor(2) as pool:
        first = pool.submit(preview, long_case())
        server.wait_until(lambda: first.running(), "the first run")
        second = pool.submit(preview, VALUES)
        assert "picture" in second.result()[-1]
        assert not any("picture" in line for line in first.result())


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


def test_a_large_tree_is_not_looked_through_to_its_end(tmp_path: Path) -> None:
    for i in range(60):
        for j in range(60):
            (tmp_path / f"{i}" / f"{j}").mkdir(parents=True)
    (tmp_path / "ball.toml").write_text(SMALL)
    (tmp_path / "0" / "first.toml").write_text(SMALL)
    (tmp_path / "59" / "59" / "last.toml").write_text(SMALL)  # behind more folders than are looked at
    assert {one.name for one in Folder(tmp_path).entries()} == {"ball.toml", "0/first.toml"}


def test_names_of_the_folder(tmp_path: Path) -> None:
    folder = Folder(tmp_path)
    assert folder.inside("a/b.toml") == tmp_path.resolve() / "a" / "b.toml"
    assert folder.new_results("a").name == "a"
    assert folder.new_results("a").name == "a-2"
    with pytest.raises(brinell.InputError, match="no such folder"):
        Folder(tmp_path / "nothing")
    (tmp_path / "loop").symlink_to(tmp_path / "loop")
    for name in ("loop", "loop/x", "..", "a/../../b", "~root/../..", ".git/config"):
        with pytest.raises(brinell.InputError):
            folder.inside(name if name != "~root/../.." else "~root/../../..")


def test_browser_is_led_by_a_file_of_this_user(tmp_path: Path) -> None:
    """Its arguments, which other users can read, do not tell the secret."""
    browser = tmp_path / "browser"
    lines = (
        "#!/bin/sh",
        f"cd {tmp_path}",
        'echo "$@" > told',
        'ls -l "${1#file://}" > rights',
        'cp "${1#file://}" page',
    )
    browser.write_text("\n".join(lines) + "\n")
    browser.chmod(0o755)
    with subprocess.Popen(
        [sys.executable, "-m", "brinell", "app", str(tmp_path)],
        stdout=subprocess.PIPE,
        text=True,
        env={**os.environ, "BROWSER": f"{browser} %s"},
    ) as process:
        assert process.stdout is not None
        address = process.stdout.readline().split(": ", 1)[1].strip()
        while not (tmp_path / "page").exists() or not (tmp_path / "page").read_text():
            assert process.poll() is None
        process.send_signal(signal.SIGINT)
    told = (tmp_path / "told").read_text().strip()
    assert "token" not in told
    assert address in (tmp_path / "page").read_text()
    assert (tmp_path / "rights").read_text().startswith("-rw------- ")
    assert not Path(told.removeprefix("file://")).exists()  # it ends with the server


def test_command_says_what_is_missing(tmp_path: Path) -> None:
    hidden = "import sys; sys.modules['uvicorn'] = None; from brinell.cli import main; main(['app'])"
    done = subprocess.run([sys.executable, "-c", hidden], capture_output=True, text=True, cwd=tmp_path, check=False)
    assert done.returncode == 2
    assert (
        done.stderr == 'brinell: error: brinell app needs uvicorn, which is not installed: pip install "brinell[app]"\n'
    )
    done = subprocess.run(
        [sys.executable, "-m", "brinell", "app", "nothing"], capture_output=True, text=True, cwd=tmp_path, check=False
    )
    assert (done.returncode, done.stderr) == (2, "brinell: error: nothing: no such folder\n")
