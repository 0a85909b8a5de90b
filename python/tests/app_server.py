# SPDX-License-Identifier: BSD-3-Clause
"""A server of `brinell app` for tests, and a client that can also say what no browser would."""

from __future__ import annotations

import contextlib
import http.client
import json
import os
import resource
import signal
import socket
import subprocess
import sys
import time
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Any

SMALL = """scenario = "indentation"
title = "a ball"
[lower]
shape = { type = "flat" }
[lower.material]
young_modulus = "210 GPa"
poisson_ratio = 0.3
hardening = { law = "linear", yield_stress = "1 GPa", modulus = "5 GPa" }
[upper]
shape = { type = "sphere", radius = "1 mm" }
material = { rigid = true }
[indentation]
load = ["20 N", 0]
steps = 5
[grid]
resolution = 4
"""
"""A case that takes a moment."""


class Server:
    """A running `brinell app`."""

    def __init__(self, folder: Path, settings: Path, *, largest_file: int | None = None):
        """Starts it, and waits until it answers."""

        def limit() -> None:
            if largest_file is not None:
                resource.setrlimit(resource.RLIMIT_FSIZE, (largest_file, largest_file))

        self.process = subprocess.Popen(
            [sys.executable, "-m", "brinell", "app", str(folder), "--no-browser"],
            stdout=subprocess.PIPE,
            text=True,
            env={**os.environ, "XDG_CONFIG_HOME": str(settings)},
            preexec_fn=limit,
        )
        assert self.process.stdout is not None
        self.address = self.process.stdout.readline().split(": ", 1)[1].strip()
        self.token = self.address.partition("token=")[2]
        self.port = int(self.address.split(":")[2].split("/")[0])
        self.folder = folder
        self.wait_until(lambda: self._answers(), "the server answers")

    def _answers(self) -> bool:
        with contextlib.suppress(OSError):
            return self.request("GET", "/api/start")[0] == 200
        return False

    def request(
        self, method: str, path: str, body: Any = None, *, headers: Mapping[str, str] | None = None
    ) -> tuple[int, Any]:
        """Status and content of the answer to a request of the page."""
        connection = http.client.HTTPConnection("127.0.0.1", self.port, timeout=60)
        sent = {"X-Brinell-Token": self.token, "Content-Type": "application/json", **(headers or {})}
        connection.request(method, path, None if body is None else json.dumps(body), sent)
        answer = connection.getresponse()
        text = answer.read().decode()
        connection.close()
        is_json = answer.headers.get("content-type", "").startswith("application/json")
        return answer.status, json.loads(text) if is_json else text

    def asked(self, method: str, path: str, body: Any = None) -> Any:
        """Content of the answer to a request that succeeds."""
        status, content = self.request(method, path, body)
        assert status == 200, content
        return content

    def raw(self, text: bytes) -> tuple[int, bytes]:
        """Status and the whole answer to bytes as they are; 0 if the connection is closed without an answer."""
        with socket.create_connection(("127.0.0.1", self.port), timeout=30) as connection:
            with contextlib.suppress(OSError):  # it may close before it has heard all
                connection.sendall(text)
                connection.shutdown(socket.SHUT_WR)
            answer = b""
            with contextlib.suppress(OSError):
                while part := connection.recv(65536):
                    answer += part
        return (int(answer.split(b" ")[1]) if answer.startswith(b"HTTP/1.") else 0), answer

    def wait_until(self, condition: Any, what: str, seconds: float = 180.0) -> Any:
        """What a condition is worth once it is true."""
        end = time.monotonic() + seconds
        while time.monotonic() < end:
            if value := condition():
                return value
            time.sleep(0.05)
        raise AssertionError(f"not within {seconds} s: {what}")

    def job(self, name: str) -> Any:
        """A run of this server."""
        return next((job for job in self.asked("GET", "/api/files")["jobs"] if job["name"] == name), None)

    def ended(self, name: str) -> Any:
        """A run of this server, once it has ended."""
        return self.wait_until(
            lambda: job if (job := self.job(name)) and job["state"] not in ("waiting", "running") else None,
            f"{name} has ended",
        )

    def close(self) -> int:
        """Ends it as Ctrl-C does; its exit code."""
        if self.process.poll() is None:
            self.process.send_signal(signal.SIGINT)
        code = self.process.wait(30)
        assert self.process.stdout is not None
        self.process.stdout.close()
        return code


@contextlib.contextmanager
def served(folder: Path, settings: Path, **limits: Any) -> Iterator[Server]:
    """A server for a block."""
    server = Server(folder, settings, **limits)
    try:
        yield server
    finally:
        server.close()


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


def tree(folder: Path) -> dict[str, Any]:
    """Everything in a folder, with sizes and contents of small files."""
    return {
        str(path.relative_to(folder)): path.read_bytes() if path.is_file() and path.stat().st_size < 10_000 else None
        for path in sorted(folder.rglob("*"))
    }
