# SPDX-License-Identifier: BSD-3-Clause
"""What is foretold of a run."""

from __future__ import annotations

from dataclasses import dataclass

__all__ = ["Forecast"]


@dataclass(frozen=True)
class Forecast:
    """Time and memory of a run before it, foretold from measured runs: docs/performance.md.

    Attributes:
        seconds: processor time on one core [s]; several threads take longer together, and are done sooner.
        range: shortest and longest time between which 95 of 100 measured runs like this one were [s].
        memory: largest memory of the process [bytes]; of the program, without what Python itself takes.
    """

    seconds: float
    range: tuple[float, float]
    memory: int
    text: str

    def __str__(self) -> str:
        """As ``brinell check`` says it."""
        return self.text
