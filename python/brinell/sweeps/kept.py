# SPDX-License-Identifier: BSD-3-Clause
"""Which runs of a sweep write folders."""

from __future__ import annotations

import re
from collections.abc import Iterable

from brinell.errors import InputError

__all__ = ["kept_of"]


def kept_of(keep: str | Iterable[int] | None, runs: int, *, otherwise: str) -> frozenset[int]:
    """Indices of the runs whose folders are kept.

    Args:
        keep: "all", "none", or indices, also as text with ranges: "0,10-19".
        runs: number of runs.
        otherwise: what None stands for.

    Raises:
        InputError: this is something else, or there is no such run.
    """
    keep = otherwise if keep is None else keep
    if keep == "all":
        return frozenset(range(runs))
    if keep == "none":
        return frozenset()
    if isinstance(keep, str):
        if not re.fullmatch(r"\s*\d+(\s*-\s*\d+)?(\s*,\s*\d+(\s*-\s*\d+)?)*\s*", keep):
            raise InputError(f"keep = {keep!r}; allowed: all, none, or numbers of runs such as 0,10-19")
        kept: set[int] = set()
        for first, last in re.findall(r"(\d+)(?:\s*-\s*(\d+))?", keep):
            kept |= set(range(int(first), min(int(last or first), runs) + 1))
    else:
        given = list(keep)
        if not all(isinstance(index, int) for index in given):
            raise InputError(f"keep = {given!r}; allowed: all, none, or numbers of runs")
        kept = set(given)
    if wrong := [index for index in sorted(kept) if not 0 <= index < runs]:
        raise InputError(f"keep: there is no run {wrong[0]}; allowed: 0 to {runs - 1}")
    return frozenset(kept)
