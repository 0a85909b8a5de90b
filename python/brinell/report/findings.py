# SPDX-License-Identifier: BSD-3-Clause
"""What a reader should be wary of before the numbers of a run are used."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from brinell.plot.energy import balance_error
from brinell.report import text
from brinell.results import BodyFields, Run, Snapshot

__all__ = ["findings_of"]

# The balance errs by the order of the step and of the cells; what is above this share of the work is worth a finer run.
_LARGEST_IMBALANCE = 0.02
# The theory is that of small strains: products of strains, here of a hundredth, are neglected.
_LARGEST_STRAIN = 0.1
# Across the contact; below, its edge moves by more than a tenth of its width from one cell to the next.
_FEWEST_CELLS = 10.0
# Plastic strain at the edge of the grid, over the largest one.
_SHARE_AT_EDGE = 0.01


def findings_of(run: Run, last: Snapshot | None) -> list[str]:
    """Sentences; none if all is well.

    Args:
        run: which.
        last: its last stored state, if any.
    """
    return [*_of_course(run), *_of_sizes(run, last), *(_of_edges(last) if last is not None else ())]


def _of_course(run: Run) -> Iterator[str]:
    if not run.complete:
        yield f"The run has not finished: there are {run.history.steps} steps, and no final state."
    split = (run.summary or {}).get("run", {}).get("split_increments", 0)
    if split:
        yield (
            f"{split} increments did not converge in one piece and were split. The result has converged; smaller "
            "steps would be faster and more accurate."
        )
    error = balance_error(run.history)
    worst = int(np.argmax(np.abs(error)))
    if abs(error[worst]) > _LARGEST_IMBALANCE:
        yield (
            f"The energy balance is off by {text.percent(float(error[worst]))} of the largest work at step "
            f"{int(run.history['step'][worst])}: take smaller steps or cells."
        )


def _of_sizes(run: Run, last: Snapshot | None) -> Iterator[str]:
    strain = float(run.history["max_equivalent_plastic_strain"].max())
    if strain > _LARGEST_STRAIN:
        yield f"Plastic strain reaches {text.percent(strain)}, but the theory is that of small strains."
    area = float(run.history["contact_area"].max())
    if last is not None and area > 0.0 and len(last.contact.x) > 1:
        cell = max(float(last.contact.x[1] - last.contact.x[0]), float(last.contact.y[1] - last.contact.y[0]))
        across = 2.0 * np.sqrt(area / np.pi) / cell
        if across < _FEWEST_CELLS:
            yield f"The largest contact is only about {text.number(float(across), 2)} cells wide."


def _of_edges(last: Snapshot) -> Iterator[str]:
    for name, body in (("lower", last.lower), ("upper", last.upper)):
        reached = _edges_reached(body)
        if reached:
            yield (
                f"Plastic strain of the {name} body has reached {' and '.join(reached)} of its grid: "
                "what lies beyond is missing. Set grid.extent to 1.3 or more."
            )


def _edges_reached(body: BodyFields) -> list[str]:
    strain = body.equivalent_plastic_strain
    if strain.size == 0 or strain.max() <= 0.0:
        return []
    edges = {
        "the bottom": strain[-1:],
        "an end": np.concatenate([strain[:, :, 0], strain[:, :, -1]]),
        "a side": np.concatenate([strain[:, 0], strain[:, -1]]),
    }
    return [name for name, values in edges.items() if values.max() > _SHARE_AT_EDGE * strain.max()]
