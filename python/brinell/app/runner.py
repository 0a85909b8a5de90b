# SPDX-License-Identifier: BSD-3-Clause
"""A run, or a sweep, of the page in a process of its own: ``python -m brinell.app.runner``.

Its task comes as JSON over the standard input; its course goes as lines of JSON over the standard output. It goes on
when nobody listens any more, so that a server that was killed loses no run. SIGINT stops it after the current step.
"""

from __future__ import annotations

import contextlib
import json
import sys
import time
import warnings
from pathlib import Path
from typing import Any

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


def main() -> int:
    """Does the task; the exit code is that of the command that does the same."""
    listener = _Listener()
    task = json.loads(sys.stdin.read())
    output = Path(task["output"])
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            case = Case(task["text"], file=task["file"])
            if task["kind"] == "sweep":
                from brinell.sweeps import sweep

                sweep(case, {task["key"]: task["values"]}, output=output, design="list", workers=task["workers"])
            else:
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
