# SPDX-License-Identifier: BSD-3-Clause
"""The server of the page: addresses, and what each of them does."""

from __future__ import annotations

import asyncio
import contextlib
import json
import os
import signal
import time
import uuid
from collections.abc import AsyncIterator, Awaitable, Callable
from dataclasses import asdict
from importlib.resources import files
from pathlib import Path
from typing import Any, cast

from starlette.applications import Starlette
from starlette.requests import Request
from starlette.responses import JSONResponse, Response, StreamingResponse
from starlette.routing import Route

import brinell
from brinell import _core
from brinell.app import fitting, forms, tasks
from brinell.app.answers import body_of, by_method, handlers, rows_of, text_of_file
from brinell.app.case_text import text_of, values_of
from brinell.app.checking import values_that_apply
from brinell.app.folder import PROGRESS, Entry, Folder, is_locked, json_of
from brinell.app.guard import Guard, RefusedError
from brinell.app.materials import Materials
from brinell.app.runs import Job, Jobs, writers_of
from brinell.app.workers import Worker
from brinell.errors import BrinellError, InputError

__all__ = ["Server", "application"]

_SCRIPTS = ("form", "plots", "app", "jobs", "fit", "page")
_STATIC = {f"{name}.js": "text/javascript" for name in _SCRIPTS} | {"app.css": "text/css"}
_MOST_SWEPT = 200
_TIMES_AS_LONG = 5


def application(folder: Path, materials: Path, token: str, port: int) -> Guard:
    """The page of a folder.

    Args:
        folder: folder with cases and results.
        materials: file of the user's own materials.
        token: secret of the page's address.
        port: port of the server.

    Raises:
        InputError: the folder does not exist.
    """
    return Guard(cast(Any, Server(Folder(folder), Materials(materials), token).app), token, port)


class Server:
    """What the page asks for."""

    def __init__(self, folder: Folder, materials: Materials, token: str):
        """Makes the application; its workers begin with it."""
        self._folder = folder
        self._materials = materials
        self._token = token
        self._checker = Worker("brinell-check", "brinell.app.tasks")
        self._previewer = Worker("brinell-preview", "brinell.app.tasks", "brinell.app.pictures")
        self._painter = Worker("brinell-pictures", "brinell.app.pictures")
        self._templates: dict[str, dict[str, Any]] = {}
        self._previews: dict[str, str] = {}
        self._jobs: Jobs | None = None
        self._looked: tuple[float, list[Entry]] = (0.0, [])
        self.app = Starlette(routes=self._routes(), lifespan=self._lifespan, exception_handlers=handlers())

    def _routes(self) -> list[Route]:
        plain: list[tuple[str, str, Callable[[Request], Awaitable[Response]]]] = [
            ("GET", "/", self._page),
            ("GET", "/static/{name}", self._static),
            ("GET", "/api/start", self._start),
            ("GET", "/api/files", self._files),
            ("GET", "/api/template", self._template),
            ("GET", "/api/case", self._read_case),
            ("PUT", "/api/case", self._write_case),
            ("GET", "/api/curve", self._curve),
            ("POST", "/api/parse", self._parse),
            ("POST", "/api/check", self._check),
            ("POST", "/api/run", self._run),
            ("POST", "/api/sweep", self._sweep),
            ("POST", "/api/fit-check", self._check_fit),
            ("POST", "/api/fit", self._fit),
            ("GET", "/api/fit", self._read_fit),
            ("POST", "/api/stop", self._stop),
            ("POST", "/api/resume", self._resume),
            ("POST", "/api/preview", self._preview),
            ("GET", "/api/history", self._history),
            ("GET", "/api/outline", self._outline),
            ("POST", "/api/picture", self._picture),
            ("GET", "/api/figures", self._figures),
            ("PUT", "/api/material", self._store_material),
            ("DELETE", "/api/material", self._remove_material),
        ]
        by_path: dict[str, dict[str, Any]] = {}
        for method, path, do in plain:
            by_path.setdefault(path, {})[method] = do
        return [Route(path, by_method(methods), methods=list(methods)) for path, methods in by_path.items()]

    @contextlib.asynccontextmanager
    async def _lifespan(self, _app: Starlette) -> AsyncIterator[None]:
        self._jobs = Jobs(self._folder)
        for worker in (self._checker, self._previewer):  # the painter begins with the first picture
            await asyncio.to_thread(worker.start)
        yield
        await self._jobs.close()
        for worker in (self._checker, self._previewer, self._painter):
            worker.close()

    @property
    def jobs(self) -> Jobs:
        """Runs that this server has begun."""
        assert self._jobs is not None
        return self._jobs

    # --- The page and its files ---------------------------------------------------------------------------------------
    async def _page(self, _request: Request) -> Response:
        text = _resource("index.html").replace("TOKEN", self._token).replace("VERSION", brinell.__version__)
        return Response(text, media_type="text/html")

    async def _static(self, request: Request) -> Response:
        name = request.path_params["name"]
        if name == "plotly.js":
            return Response(await asyncio.to_thread(_plotly), media_type="text/javascript")
        if name not in _STATIC:
            raise RefusedError(404, "there is no such file")
        return Response(_resource(name), media_type=_STATIC[name])

    async def _start(self, _request: Request) -> Response:
        columns = {
            scenario: [{"name": c.name, "unit": c.unit, "text": c.text} for c in listed]
            for scenario, listed in _core.columns().items()
        }
        units = {one["unit"] for listed in columns.values() for one in listed} | {"m/N", "m/s"}
        from brinell.app.pictures import titles

        return JSONResponse(
            {
                "form": forms.as_json(),
                "columns": columns,
                "units": {unit: forms.units_of(unit) for unit in units},
                "titles": titles(),
                "folder": str(self._folder.root),
                "materials": self._materials.all(),
                "longest_preview": tasks.LONGEST_PREVIEW,
            }
        )

    async def _files(self, _request: Request) -> Response:
        entries = await self._entries()
        busy = {job.name for job in self.jobs.all() if job.state in ("waiting", "running")}
        left = [one.name for one in entries if one.kind == "run" and not one.complete and one.name not in busy]
        elsewhere = await asyncio.to_thread(self._elsewhere, left) if left else {}
        jobs = [self._told(job) for job in self.jobs.all() if job.name not in elsewhere]
        told = [asdict(one) for one in entries]
        return JSONResponse({"entries": told, "jobs": [*jobs, *elsewhere.values()]})

    def _elsewhere(self, names: list[str]) -> dict[str, dict[str, Any]]:
        """Of some unfinished runs those that another process computes, as one of a server that was killed."""
        by_path = {self._folder.inside(name): name for name in names}
        found = {}
        for path in writers_of(by_path):
            done = rows_of(path / "history.csv", 0).get("step", [])
            job = Job(by_path[path], {"kind": "run"}, "running", done=len(done))
            found[job.name] = {**job.as_json(), "kind": "run", "elsewhere": True}
        return found

    async def _entries(self) -> list[Entry]:
        """What the folder holds; a large tree is looked through less often, by the time that this takes."""
        begun = time.monotonic()
        if begun >= self._looked[0]:
            entries = await asyncio.to_thread(self._folder.entries)
            took = time.monotonic() - begun
            self._looked = (time.monotonic() + _TIMES_AS_LONG * took, entries)
        return self._looked[1]

    def _told(self, job: Job) -> dict[str, Any]:
        """A job; of a sweep its finished runs."""
        told = job.as_json()
        if job.task["kind"] == "sweep":
            runs = Path(job.task["output"]) / "runs"
            told["done"] = sum(1 for _ in runs.glob("*/summary.json"))
            told["of"] = len(job.task["values"])
        return {**told, "kind": job.task["kind"]}

    # --- Cases --------------------------------------------------------------------------------------------------------
    async def _template(self, request: Request) -> Response:
        scenario = request.query_params.get("scenario", "")
        if scenario not in forms.form()["scenario"].choices:
            raise InputError(f"{scenario[:50]!r} is no scenario")
        if scenario not in self._templates:
            self._templates[scenario] = values_of(await self._checker.call(tasks.template, scenario))
        return JSONResponse({"values": self._templates[scenario]})

    async def _read_case(self, request: Request) -> Response:
        text = self._folder.read_case(request.query_params.get("name", ""))
        return JSONResponse({"values": values_of(text), "has_comments": "#" in text})

    async def _write_case(self, request: Request) -> Response:
        body = await body_of(request, name=str, values=dict, replace=bool)
        text = text_of(body["values"]).text
        self._folder.write_case(body["name"], text, replace=body["replace"])
        return JSONResponse({"name": body["name"]})

    async def _curve(self, request: Request) -> Response:
        text = await asyncio.to_thread(self._folder.read_data, request.query_params.get("name", ""))
        return JSONResponse({"text": text})

    async def _parse(self, request: Request) -> Response:
        body = await body_of(request, text=str)
        return JSONResponse({"values": values_of(body["text"])})

    async def _check(self, request: Request) -> Response:
        body = await body_of(request, values=dict, park=bool)
        values = values_that_apply(body["values"]) if body["park"] else body["values"]
        result = await self._checker.call(tasks.check, values, str(self._folder.root), timeout=30.0)
        parked = {key: value for key, value in body["values"].items() if key not in values}
        return JSONResponse({**result, "parked": parked})

    # --- Runs ---------------------------------------------------------------------------------------------------------
    async def _run(self, request: Request) -> Response:
        body = await body_of(request, values=dict, name=str)
        text = await self._valid_text([body["values"]])
        path = self._folder.new_results(body["name"])
        task = self._task("run", text)
        return JSONResponse(self.jobs.begin(self._folder.name_of(path), task).as_json())

    async def _valid_text(self, cases: list[dict[str, Any]]) -> str:
        """Text of the first of some cases, which are all valid."""
        text: str = await self._checker.call(tasks.valid_text, cases, str(self._folder.root))
        return text

    def _task(self, kind: str, text: str) -> dict[str, Any]:
        file = str(self._folder.root / "case.toml")
        return {"kind": kind, "text": text, "file": file, "resume": False, "threads": None}

    async def _sweep(self, request: Request) -> Response:
        body = await body_of(request, values=dict, name=str, key=str, over=list)
        if not 2 <= len(body["over"]) <= _MOST_SWEPT:
            raise InputError(f"{len(body['over'])} values; allowed: 2 to {_MOST_SWEPT}")
        text = await self._valid_text(
            [body["values"], *({**body["values"], body["key"]: value} for value in body["over"])]
        )
        path = self._folder.new_results(body["name"])
        workers = max(1, (os.cpu_count() or 2) - 1)
        task = self._task("sweep", text) | {"key": body["key"], "values": body["over"], "workers": workers}
        return JSONResponse(self.jobs.begin(self._folder.name_of(path), task).as_json())

    async def _check_fit(self, request: Request) -> Response:
        body = await body_of(request, values=dict, fit=dict)
        asked = body["values"], str(self._folder.root), body["fit"]
        return JSONResponse(await self._checker.call(fitting.check_fit, *asked))

    async def _fit(self, request: Request) -> Response:
        body = await body_of(request, values=dict, name=str, fit=dict)
        asked = body["values"], str(self._folder.root), body["fit"]
        files = await self._checker.call(fitting.fit_files, *asked)
        path = self._folder.new_results(body["name"])
        for name, content in {**files, PROGRESS: b'{"stage": "waits", "runs": 0}'}.items():
            (path / name).write_bytes(content)
        return JSONResponse(self._begin_fit(self._folder.name_of(path)))

    def _begin_fit(self, name: str) -> dict[str, Any]:
        workers = len(os.sched_getaffinity(0))
        return self.jobs.begin(name, {"kind": "fit", "workers": workers}).as_json()

    async def _read_fit(self, request: Request) -> Response:
        name = request.query_params.get("name", "")
        path = self._folder.result(name)
        text = await asyncio.to_thread(text_of_file, path / "fit.toml")
        running = await asyncio.to_thread(is_locked, path / "fit.toml")
        if (path / "fit.json").is_file() and not running:
            told = await self._painter.call(fitting.fit_result, str(self._folder.root), name)
        else:
            told = {**await asyncio.to_thread(json_of, path / PROGRESS), "complete": False, "running": running}
        return JSONResponse({**told, "name": name, "text": text})

    async def _stop(self, request: Request) -> Response:
        body = await body_of(request, name=str)
        job = self.jobs.get(body["name"])
        if job is None or job.state not in ("waiting", "running"):
            path = self._folder.inside(body["name"])
            if (writer := (await asyncio.to_thread(writers_of, [path])).get(path)) is not None:
                os.kill(writer, signal.SIGINT)
                return JSONResponse({"name": body["name"], "state": "running"})
        return JSONResponse(self.jobs.stop(body["name"]).as_json())

    async def _resume(self, request: Request) -> Response:
        body = await body_of(request, name=str)
        fit = self._folder.inside(body["name"]) / "fit.toml"
        if fit.is_file() and (fit.parent / PROGRESS).is_file():
            if is_locked(fit):
                raise InputError(f"{body['name']} is still being computed")
            return JSONResponse(self._begin_fit(body["name"]))
        if await asyncio.to_thread(writers_of, [fit.parent]):
            raise InputError(f"{body['name']} is still being computed")
        outline = await self._painter.call(tasks.outline, str(self._folder.root), body["name"])
        if outline is None or not outline["values"]:
            raise InputError(f"nothing of {body['name']} is kept that could be resumed")
        if outline["complete"]:
            raise InputError(f"{body['name']} has finished already")
        task = self._task("run", await self._valid_text([outline["values"]])) | {"resume": True}
        return JSONResponse(self.jobs.begin(body["name"], task).as_json())

    async def _preview(self, request: Request) -> Response:
        body = await body_of(request, values=dict, shown=dict, tab=str)
        tab = body["tab"][:50]
        mine = self._previews[tab] = uuid.uuid4().hex
        if len(self._previews) > 1000:
            self._previews = {tab: mine}

        async def lines() -> AsyncIterator[bytes]:
            things = self._previewer.stream(
                tasks.preview, values_that_apply(body["values"]), str(self._folder.root), body["shown"]
            )
            try:
                async for thing in things:
                    if self._previews.get(tab) != mine:  # the slider has moved on
                        break
                    yield json.dumps(thing).encode() + b"\n"
            except BrinellError as error:
                yield json.dumps({"error": str(error)}).encode() + b"\n"
            finally:
                await cast(Any, things).aclose()

        return StreamingResponse(lines(), media_type="application/x-ndjson")

    # --- Results ------------------------------------------------------------------------------------------------------
    async def _history(self, request: Request) -> Response:
        name = request.query_params.get("name", "")
        first = request.query_params.get("from", "0")
        path = self._folder.result(name) / "history.csv"
        job = self.jobs.get(name)
        columns = await asyncio.to_thread(rows_of, path, int(first) if first.isdecimal() else 0)
        complete = (path.parent / "summary.json").is_file()
        return JSONResponse({"columns": columns, "complete": complete, "job": self._told(job) if job else None})

    async def _outline(self, request: Request) -> Response:
        return await self._painted(tasks.outline, request.query_params.get("name", ""))

    async def _painted(self, task: Any, *arguments: Any) -> Response:
        return JSONResponse(await self._painter.call(task, str(self._folder.root), *arguments))

    async def _picture(self, request: Request) -> Response:
        body = await body_of(request, name=str, state=str, shown=dict)
        return await self._painted(tasks.image, body["name"], body["state"], body["shown"])

    async def _figures(self, request: Request) -> Response:
        return await self._painted(tasks.figures, request.query_params.get("name", ""))

    # --- Materials ----------------------------------------------------------------------------------------------------
    async def _store_material(self, request: Request) -> Response:
        body = await body_of(request, name=str, source=str, values=dict)
        self._materials.store(body["name"].strip(), body["source"], body["values"])
        return JSONResponse({"materials": self._materials.all()})

    async def _remove_material(self, request: Request) -> Response:
        body = await body_of(request, name=str)
        self._materials.remove(body["name"])
        return JSONResponse({"materials": self._materials.all()})


def _resource(name: str) -> str:
    return (files("brinell.app") / "static" / name).read_text(encoding="utf-8")


def _plotly() -> str:
    from plotly.offline import get_plotlyjs

    return cast(str, get_plotlyjs())
