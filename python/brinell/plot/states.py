# SPDX-License-Identifier: BSD-3-Clause
"""Parts of every figure of a state: the line that names it, and the bodies that are shown."""

from __future__ import annotations

import functools
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any, Concatenate, Literal, ParamSpec, TypeVar

from brinell.errors import InputError
from brinell.plot import style
from brinell.results import BodyFields, Run, RunError, Snapshot
from brinell.scenarios import SCENARIOS

__all__ = [
    "Bodies",
    "Follow",
    "Side",
    "both_sides",
    "chosen_sides",
    "of_state",
    "sides",
    "state_title",
    "stored_in_pass",
]

_P = ParamSpec("_P")
_R = TypeVar("_R")

Which = int | Literal["aligned", "final"]
"""A stored state, by its number or its name."""

Bodies = Literal["both", "lower", "upper"]
"""Which bodies to draw."""

Follow = Literal["contact", "body"]
"""Whether a moving picture goes with the contact, or stays with the body while the contact passes."""


def of_state(
    draw: Callable[Concatenate[Run, Snapshot, _P], _R],
) -> Callable[Concatenate[Run, Snapshot | Which, _P], _R]:
    """Decorator with which a figure of a state also accepts the number or name of the state, as `Run.snapshot` does."""

    @functools.wraps(draw)
    def drawn(run: Run, snapshot: Snapshot | Which, *args: _P.args, **options: _P.kwargs) -> _R:
        state = snapshot if isinstance(snapshot, Snapshot) else run.snapshot(snapshot)
        return draw(run, state, *args, **options)

    return drawn  # type: ignore[return-value]  # the state may be given by its name, too: snapshot=


@dataclass(frozen=True, eq=False)
class Side:
    """One of the two bodies, and its look."""

    name: str
    body: BodyFields
    colour: str
    dash: Any
    up: float
    """Direction of its depth on a sheet with the surfaces in the middle: -1 or 1."""


def both_sides(snapshot: Snapshot) -> list[Side]:
    """Both bodies, the lower one first."""
    return [
        Side("lower body", snapshot.lower, style.LOWER, "-", -1.0),
        Side("upper body", snapshot.upper, style.UPPER, (0, (4, 2)), 1.0),
    ]


def sides(snapshot: Snapshot) -> list[Side]:
    """The bodies that deform; a rigid body has no fields."""
    return [side for side in both_sides(snapshot) if not side.body.is_rigid]


def chosen_sides(run: Run, snapshot: Snapshot, bodies: Bodies) -> list[Side]:
    """The bodies that deform, or one of them.

    Raises:
        RunError: the one asked for is rigid.
        InputError: `bodies` is not "both", "lower" or "upper".
    """
    if bodies == "both":
        return sides(snapshot)
    if bodies not in ("lower", "upper"):
        raise InputError(f"{bodies!r} is no choice of bodies; allowed: 'both', 'lower', 'upper'")
    chosen = [side for side in sides(snapshot) if side.name == f"{bodies} body"]
    if not chosen:
        raise RunError(f"{run.path}: the {bodies} body is rigid, so it has no fields")
    return chosen


def state_title(run: Run, snapshot: Snapshot) -> str:
    """One line that names the state."""
    parts = ["final state" if snapshot.is_final else f"step {snapshot.step}"]
    own = SCENARIOS[snapshot.scenario].state_text
    if own is not None:
        parts += own(run, snapshot)
    elif not snapshot.is_final:
        parts += _drive(snapshot)
    return ",  ".join(parts)


def _drive(snapshot: Snapshot) -> list[str]:
    """Pass, place and load of a state."""
    return [
        f"pass {snapshot.pass_}",
        f"$x$ = {style.length(snapshot.row['x'])}",
        f"$F_n$ = {style.quantity(snapshot.row['F_n'], 'N') if snapshot.in_contact else 0}",
    ]


def stored_in_pass(run: Run, pass_: int) -> list[int]:
    """Steps of a pass whose fields are stored.

    Raises:
        RunError: fewer than two.
        InputError: no pass has that number.
    """
    if pass_ < 1:
        raise InputError(f"pass_ = {pass_}; allowed: 1 or more, passes count from 1")
    of_pass = set(run.history["step"][run.history["pass"] == pass_].astype(int).tolist())
    steps = [step for step in run.steps if step in of_pass]
    if len(steps) < 2:
        stored = f"{len(steps)} stored {'state' if len(steps) == 1 else 'states'}"
        raise RunError(
            f"{run.path}: {stored} in pass {pass_}, an animation needs two or more; "
            'store more with [output] snapshots = "all" in the case'
        )
    return steps
