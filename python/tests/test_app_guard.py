# SPDX-License-Identifier: BSD-3-Clause
"""Whom the server of `brinell app` answers, and what it reads and writes."""

import json
import os
import signal
import socket
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path

import pytest

import brinell
from app_server import SMALL, Server, request_text, served, tree
from brinell.app.case_text import values_of
from brinell.app.folder import Folder
from brinell.app.guard import LARGEST_BODY

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
