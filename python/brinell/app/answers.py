# SPDX-License-Identifier: BSD-3-Clause
"""What requests have, and what is answered: bodies, errors, and rows of a history that is being written."""

from __future__ import annotations

import csv
import json
from collections.abc import Awaitable, Callable, Mapping
from pathlib import Path
from typing import Any, cast

from starlette.requests import ClientDisconnect, Request
from starlette.responses import JSONResponse, Response

from brinell.app.guard import RefusedError
from brinell.app.workers import WorkerLostError
from brinell.errors import BrinellError, InputError

__all__ = ["body_of", "by_method", "handlers", "rows_of", "text_of_file"]


def by_method(methods: Mapping[str, Callable[[Request], Awaitable[Response]]]) -> Any:
    """What answers an address, made of what answers each of its methods."""

    async def do(request: Request) -> Response:
        method = "GET" if request.method == "HEAD" else request.method
        return await methods[method](request)

    return do


async def body_of(request: Request, **members: type) -> dict[str, Any]:
    """The body of a request.

    Raises:
        InputError: it is no JSON object with these members.
    """
    try:
        body = json.loads(await request.body(), parse_constant=_refuse_constant)
    except (ValueError, RecursionError) as error:
        raise InputError("the body is not JSON") from error
    if not isinstance(body, dict) or set(body) - set(members):
        raise InputError(f"the body is not an object with {', '.join(members)}")
    for name, kind in members.items():
        if not isinstance(body.get(name), kind):
            raise InputError(f"{name} is missing, or not of its type")
    return body


def _refuse_constant(name: str) -> Any:
    raise ValueError(name)


def text_of_file(path: Path) -> str:
    """Text of a file; empty if there is none."""
    try:
        return path.read_text(encoding="utf-8")
    except (OSError, UnicodeDecodeError):
        return ""


def rows_of(path: Path, first: int) -> dict[str, list[float | None]]:
    """Columns of a history from a row on, also of one that is being written."""
    try:
        text = path.read_text(encoding="utf-8")
    except OSError:
        return {}
    lines = text[: text.rfind("\n") + 1].splitlines()
    if not lines:
        return {}
    names = next(csv.reader(lines[:1]))
    rows = [row for row in csv.reader(lines[1 + first :]) if len(row) == len(names)]
    return {name: [_number(row[i]) for row in rows] for i, name in enumerate(names)}


def _number(text: str) -> float | None:
    value = float(text) if text else float("nan")
    return value if value - value == 0.0 else None


def handlers() -> dict[Any, Any]:
    """Answers to requests that raise, by the kind of error."""

    async def wrong(_request: Request, error: Exception) -> Response:
        status = 503 if isinstance(error, WorkerLostError) else 422
        return JSONResponse({"error": str(error)}, status_code=status)

    async def refused(_request: Request, error: Exception) -> Response:
        return JSONResponse({"error": str(error)}, status_code=cast(RefusedError, error).status)

    async def gone(_request: Request, _error: Exception) -> Response:
        return Response(status_code=499)

    return {BrinellError: wrong, OSError: wrong, RefusedError: refused, ClientDisconnect: gone}
