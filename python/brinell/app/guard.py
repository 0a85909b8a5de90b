# SPDX-License-Identifier: BSD-3-Clause
"""Who may talk to the page's server: only the page itself, in a browser of this machine.

A page of another site that the same browser shows is refused by the token, which it does not know, by `Origin` and
`Sec-Fetch-Site`, which browsers set, and by the type JSON, which other sites may not send unasked; a site whose name
has been led to this machine (DNS rebinding) is refused by `Host`.
"""

from __future__ import annotations

import hmac
from collections.abc import Awaitable, Callable, Iterable, Mapping, MutableMapping
from typing import Any
from urllib.parse import parse_qs

__all__ = ["HEADERS", "LARGEST_BODY", "Guard", "RefusedError"]

Scope = MutableMapping[str, Any]
Message = MutableMapping[str, Any]
Receive = Callable[[], Awaitable[Message]]
Send = Callable[[Message], Awaitable[None]]
App = Callable[[Scope, Receive, Send], Awaitable[None]]

LARGEST_BODY = 1_000_000
"""Largest body of a request [bytes]."""

_LONGEST_ADDRESS = 4000
_METHODS = ("GET", "POST", "PUT", "DELETE")

HEADERS = (
    (
        b"content-security-policy",
        b"default-src 'none'; script-src 'self'; style-src 'self' 'unsafe-inline'; img-src 'self' data: blob:; "
        b"connect-src 'self'; base-uri 'none'; form-action 'none'; frame-ancestors 'none'",
    ),
    (b"cross-origin-opener-policy", b"same-origin"),
    (b"cross-origin-resource-policy", b"same-origin"),
    (b"referrer-policy", b"no-referrer"),
    (b"x-content-type-options", b"nosniff"),
    (b"x-frame-options", b"DENY"),
    (b"cache-control", b"no-store"),
)
"""Headers of every answer. plotly.js sets styles in the page."""


class RefusedError(Exception):
    """A request that is not answered."""

    def __init__(self, status: int, reason: str):
        """Makes the refusal with its HTTP status."""
        super().__init__(reason)
        self.status = status


class Guard:
    """ASGI application that hands on only what the page itself asks for."""

    def __init__(self, app: App, token: str, port: int):
        """Guards an application.

        Args:
            app: the application.
            token: secret of the page's address.
            port: port of the server.
        """
        self._app = app
        self._token = token.encode()
        self._hosts = {f"{name}:{port}" for name in ("127.0.0.1", "localhost")}
        self._origins = {f"http://{host}" for host in self._hosts}

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        """Answers a request, or refuses it."""
        if scope["type"] == "lifespan":
            await self._app(scope, receive, send)
            return
        if scope["type"] != "http":
            await send({"type": "websocket.close", "code": 1008})
            return
        begun = False

        async def send_guarded(message: Message) -> None:
            nonlocal begun
            if message["type"] == "http.response.start":
                begun = True
                message = {**message, "headers": [*message.get("headers", []), *HEADERS]}
            await send(message)

        try:
            self._check(scope)
            await self._app(scope, _limited(receive), send_guarded)
        except RefusedError as refusal:
            if begun:
                raise
            await _refuse(refusal, send_guarded)

    def _check(self, scope: Scope) -> None:
        """Raises RefusedError for a request that is not the page's."""
        headers = _headers(scope["headers"])
        method, path = scope["method"], scope["path"]
        if (scope.get("client") or ("",))[0] != "127.0.0.1":
            raise RefusedError(403, "only this machine is answered")
        if headers.get("host") not in self._hosts:
            raise RefusedError(403, "this is not the host of the page")
        if "origin" in headers and headers["origin"] not in self._origins:
            raise RefusedError(403, "another site asks")
        if headers.get("sec-fetch-site", "none") not in ("same-origin", "none") and not _is_visit(path, headers):
            raise RefusedError(403, "another site asks")
        if method not in _METHODS:
            raise RefusedError(405, "allowed: GET, POST, PUT, DELETE")
        raw = scope.get("raw_path") or path.encode()
        if len(raw) + len(scope["query_string"]) > _LONGEST_ADDRESS:
            raise RefusedError(414, "the address is too long")
        if any(part in (".", "..") for part in path.split("/")) or b"%" in raw or "\\" in path or "//" in path:
            raise RefusedError(400, "the address is not one of the page's")
        if not hmac.compare_digest(self._given(scope, headers), self._token):
            raise RefusedError(403, "the token is missing or wrong; open the address that brinell app has printed")
        if method in ("POST", "PUT", "DELETE"):
            self._check_body(headers)

    def _given(self, scope: Scope, headers: MutableMapping[str, str]) -> bytes:
        """The token of a request: of the program interface in a header, of the page and its files in the address."""
        if scope["path"].startswith("/api/"):
            return headers.get("x-brinell-token", "").encode()
        query = parse_qs(scope["query_string"].decode("latin-1"), max_num_fields=20)
        given: str = query.get("token", [""])[0]
        return given.encode()

    def _check_body(self, headers: MutableMapping[str, str]) -> None:
        if not headers.get("content-type", "").lower().startswith("application/json"):
            raise RefusedError(415, "allowed: application/json")
        length = headers.get("content-length", "0")
        if not length.isdecimal() or int(length) > LARGEST_BODY:
            raise RefusedError(413, f"allowed: bodies up to {LARGEST_BODY} bytes")


def _is_visit(path: str, headers: Mapping[str, str]) -> bool:
    """Whether a window of the browser is led to the page, as by the file that the command opens."""
    goes = (headers.get("sec-fetch-mode"), headers.get("sec-fetch-dest"))
    return path == "/" and goes == ("navigate", "document")


def _headers(raw: Iterable[tuple[bytes, bytes]]) -> MutableMapping[str, str]:
    """Headers by name; one that decides and stands there twice is refused."""
    found: dict[str, str] = {}
    for name, value in raw:
        key = name.decode("latin-1").lower()
        if key in found and key in ("host", "origin", "content-length", "content-type", "x-brinell-token"):
            raise RefusedError(400, f"{key} stands there twice")
        found[key] = value.decode("latin-1")
    return found


def _limited(receive: Receive) -> Receive:
    """The body of a request, refused as soon as it is too long."""
    taken = 0

    async def receive_limited() -> Message:
        nonlocal taken
        message = await receive()
        taken += len(message.get("body", b""))
        if taken > LARGEST_BODY:
            raise RefusedError(413, f"allowed: bodies up to {LARGEST_BODY} bytes")
        return message

    return receive_limited


async def _refuse(refusal: RefusedError, send: Send) -> None:
    await send(
        {
            "type": "http.response.start",
            "status": refusal.status,
            "headers": [(b"content-type", b"text/plain; charset=utf-8"), (b"connection", b"close")],
        }
    )
    await send({"type": "http.response.body", "body": f"brinell: {refusal}\n".encode()})
