# SPDX-License-Identifier: BSD-3-Clause
"""The command ``brinell app``.

Exit code 0: ended by Ctrl-C; 2: an error in the command line, or the libraries of the page are not installed.
"""

from __future__ import annotations

import contextlib
import os
import secrets
import socket
import tempfile
import webbrowser
from collections.abc import Iterator
from pathlib import Path

import click

from brinell.errors import IoError, MissingExtraError

__all__ = ["command"]


@click.command("app")
@click.argument("folder", type=click.Path(path_type=Path), metavar="[DIR]", default=Path("."))
@click.option("--port", type=click.IntRange(1, 65535), help="Port of this machine; default: any that is free.")
@click.option("--no-browser", is_flag=True, help="Print the address only; open no browser.")
def command(folder: Path, port: int | None, no_browser: bool) -> None:
    """Open a page to work on in the browser: cases, runs and results of DIR, by default this folder.

    The page is served to this machine only, under an address with a secret; nothing outside DIR is read or written, but
    for the user's own materials. Ctrl-C ends it: the run that it computes stops after its step and can be resumed.
    """
    try:
        import uvicorn

        from brinell.app.server import application
    except ImportError as error:
        raise MissingExtraError("brinell app", (error.name or "starlette").partition(".")[0], "app") from error
    from brinell.app.materials import user_file

    listening = _listening(port or 0)
    at = listening.getsockname()[1]
    token = secrets.token_urlsafe(32)
    guarded = application(folder, user_file(), token, at)
    address = f"http://127.0.0.1:{at}/?token={token}"
    click.echo(f"{folder.resolve()}: {address}\nCtrl-C ends it.")
    config = uvicorn.Config(
        guarded,
        log_level="critical",
        access_log=False,
        server_header=False,
        limit_concurrency=100,
        timeout_keep_alive=20,
        timeout_graceful_shutdown=3,
        h11_max_incomplete_event_size=32_768,
        http="h11",
        ws="none",
        proxy_headers=False,
        lifespan="on",
    )
    with contextlib.suppress(KeyboardInterrupt), _leading_to(address) as page:
        if not no_browser:
            with contextlib.suppress(webbrowser.Error):
                webbrowser.open(page.as_uri())
        uvicorn.Server(config).run(sockets=[listening])


@contextlib.contextmanager
def _leading_to(address: str) -> Iterator[Path]:
    """A file of this user alone that leads a browser to an address.

    The arguments of a browser can be read by other users of the machine; this file cannot.
    """
    with tempfile.TemporaryDirectory(prefix="brinell-app-") as folder:  # of this user alone, too
        path = Path(folder) / "brinell.html"
        with open(os.open(path, os.O_WRONLY | os.O_CREAT | os.O_EXCL, 0o600), "w", encoding="utf-8") as file:
            file.write(f'<!doctype html><title>brinell</title><meta http-equiv="refresh" content="0;url={address}">\n')
        yield path


def _listening(port: int) -> socket.socket:
    """A socket that only this machine can reach.

    Raises:
        IoError: the port is taken.
    """
    listening = socket.socket(socket.AF_INET, socket.SOCK_STREAM)
    listening.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
    try:
        listening.bind(("127.0.0.1", port))
        listening.listen(100)  # a browser that is faster than the server waits
    except OSError as error:
        listening.close()
        raise IoError(f"port {port} cannot be used: {error.strerror}") from error
    return listening
