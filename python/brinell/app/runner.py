# SPDX-License-Identifier: BSD-3-Clause
"""A run, a sweep or a fit of the page in a process of its own: ``python -m brinell.app.runner``.

Its task comes as JSON over the standard input; its course goes as lines of JSON over the standard output. It goes on
when nobody listens any more, so that a server that was killed loses no run. SIGINT stops a run after the current step,
and a fit at once: of its runs nothing is kept.
"""

from __future__ import annotations

import contextlib
import json
import os
import signal
import sys
import time
import warnings
from pathlib import Path
from typing import Any

from brinell.app.folder import PROGRESS, lock, write_whole
from brinell.case import Case
from brinell.errors import BrinellError

__all__ = ["main"]

_SECONDS_BETWEEN = 0.1


class _Listener:
    """The server, as long as it listens."""

    def __init__(self) -> None:
        self._told = 0.0

    def tell(self, message: dict[str, Any]) -> None:
        """Sends a message."""
        with contextlib.suppress(OSError, ValueError):
            print(json.dumps(message), flush=True)

    def progress(self, step: int, count: int, place: str, evaluations: int) -> None:
        """Sends how far the run is, not too often."""
        if time.monotonic() - self._told >= _SECONDS_BETWEEN:
            self._told = time.monotonic()
            self.tell({"done": step + 1, "of": count, "place": place})


def _fit(task: dict[str, Any], folder: Path, listener: _Listener) -> None:
    """A fit, of which progress.json tells how far it is until its results are written."""
    import matplotlib

    from brinell.fits import Course, fit
    from brinell.fits.text import as_text

    matplotlib.use("Agg")
    told = 0.0

    def watch(course: Course) -> None:
        nonlocal told
        if time.monotonic() - told < _SECONDS_BETWEEN:
            return
        told = time.monotonic()
        values = {name: as_text(*value) for name, value in course.values.items()}
        curves = [
            {
                "name": one.name,
                "columns": list(one.columns),
                "x": one.x.tolist(),
                "measured": one.y.tolist(),
                "fitted": fitted.tolist(),
            }
            for one, fitted in zip(course.data, course.fitted, strict=False)
        ]
        known = {"stage": course.stage, "runs": course.runs, "misfit": course.misfit}
        with contextlib.suppress(OSError):
            write_whole(folder / PROGRESS, json.dumps({**known, "values": values, "curves": curves}))
        listener.tell({"done": course.runs, "of": 0, "place": course.stage})

    def stop(*_: object) -> None:
        listener.tell({"stopped": True})
        os._exit(130)  # runs in other threads are not waited for

    with open(folder / "fit.toml", "rb") as file:
        lock(file)  # tells other servers that it is being computed
        write_whole(folder / PROGRESS, json.dumps({"stage": "begins", "runs": 0}))
        signal.signal(signal.SIGINT, stop)
        result = fit(folder / "fit.toml", workers=task["workers"], watch=watch)
        signal.signal(signal.SIGINT, signal.SIG_IGN)
        result.write(folder)
        (folder / PROGRESS).unlink(missing_ok=True)


def main() -> int:
    """Does the task; the exit code is that of the command that does the same."""
    listener = _Listener()
    task = json.loads(sys.stdin.read())
    output = Path(task["output"])
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            if task["kind"] == "fit":
                _fit(task, output, listener)
            elif task["kind"] == "sweep":
                from brinell.sweeps import sweep

                case = Case(task["text"], file=task["file"])
                sweep(case, {task["key"]: task["values"]}, output=output, design="list", workers=task["workers"])
            else:
                case = Case(task["text"], file=task["file"])
                case.run(output, progress=listener.progress, resume=task["resume"], threads=task["threads"])
    except KeyboardInterrupt:
        listener.tell({"stopped": True})
        return 130
    except (BrinellError, OSError, MemoryError) as error:
        listener.tell({"error": str(error) or "not enough memory"})
        return 1
    except Exception as error:
        listener.tell({"error": f"a bug of brinell, please report it: {type(error).__name__}: {error}"})
        return 1
    listener.tell({"finished": True})
    return 0


if __name__ == "__main__":
    sys.exit(main())
