# SPDX-License-Identifier: BSD-3-Clause
"""Warnings of a run as sentences, for reports and notebooks."""

from __future__ import annotations

import warnings
from collections.abc import Iterator

from brinell.case import Case, CaseWarning
from brinell.errors import InputError
from brinell.results import Run, RunError, RunWarning

__all__ = ["findings_of"]


def findings_of(run: Run) -> list[str]:
    """Warnings as sentences, for an unfinished run those of its case; an empty list if there are none."""
    return [*_of_state(run), *(_sentence(warning.text) for warning in _warnings(run))]


def _of_state(run: Run) -> Iterator[str]:
    if not run.complete:
        yield f"The run has not finished: there are {run.history.steps} steps, and no final state."
    elif run.summary is not None and "warnings" not in run.summary:
        yield "An older brinell has computed this run, which did not judge its results: compute it again."


def _warnings(run: Run) -> list[RunWarning]:
    if run.complete:
        return run.warnings
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore", CaseWarning)
            return Case(run.case_text).warnings
    except (RunError, InputError):  # an unfinished run may not have come to write its case
        return []


def _sentence(text: str) -> str:
    """A warning as a sentence.

    >>> _sentence("nothing has yielded")
    'Nothing has yielded.'
    """
    return text[:1].upper() + text[1:] + ("" if text.endswith(("?", ".")) else ".")
