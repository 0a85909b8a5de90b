# SPDX-License-Identifier: BSD-3-Clause
"""The part of `sweeps.py` within the processes that compute: when the engine was called, and its processor time."""

import os
import time
from typing import Any

import brinell

_TIMES: dict[str, float] = {}


def _wrap() -> None:
    """Lets the calls of the engine in this process note their times."""
    original = brinell.Case._with_progress

    def timed(*arguments: Any) -> Any:
        began, processor = time.time(), time.thread_time()
        try:
            return original(*arguments)
        finally:
            _TIMES.update(processor=time.thread_time() - processor, began=began, ended=time.time())

    brinell.Case._with_progress = timed  # type: ignore[method-assign,assignment]


def times(run: brinell.Run) -> dict[str, float]:
    """Times of the engine's call of a run; none for the first run of a process, which finds it not yet wrapped."""
    if "wrapped" not in _TIMES:
        _wrap()
        _TIMES["wrapped"] = 1.0
        return {"process": os.getpid()}
    return {"process": os.getpid()} | {name: _TIMES[name] for name in ("processor", "began", "ended")}
