# SPDX-License-Identifier: BSD-3-Clause
"""Numbers that users compute of each run of a sweep: further columns of its table.

Workers import this module, so pandas is imported where it is needed.
"""

from __future__ import annotations

import functools
import importlib.util
from collections.abc import Callable, Iterable, Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any, TypeAlias

import numpy as np

from brinell.errors import InputError
from brinell.results import Run

if TYPE_CHECKING:
    import pandas as pd

__all__ = [
    "Numbers",
    "function_of",
    "functions_of",
    "numbers_of",
    "own_columns",
    "packed",
    "residual_stress",
    "with_numbers",
]

Numbers: TypeAlias = Callable[[Run], Mapping[str, Any]]
"""Function of a finished run that returns numbers (or words) by the names of their columns."""


def residual_stress(run: Run) -> dict[str, float]:
    """Largest and smallest normal stresses along x and y in each body that has yielded, and their depths.

    They are those of the final state, which is unloaded in most scenarios: `residual.lower.max_xx_Pa`,
    `residual.lower.max_xx_depth_m`, `residual.lower.min_xx_Pa`, ... Positive in tension.
    """
    final = run.snapshot("final")
    yields = bool(np.any(run.history["max_equivalent_plastic_strain"]))
    found: dict[str, float] = {}
    for name, body in (("lower", final.lower), ("upper", final.upper)):
        has_yielded = body.has_yielded if body.has("equivalent_plastic_strain") else yields
        if body.is_rigid or not has_yielded:
            continue
        for component in ("xx", "yy"):
            stress = np.asarray(body.stress[component])
            for kind, index in (("max", int(np.argmax(stress))), ("min", int(np.argmin(stress)))):
                head = f"residual.{name}.{kind}_{component}"
                found[f"{head}_Pa"] = float(stress.flat[index])
                found[f"{head}_depth_m"] = float(body.z[np.unravel_index(index, stress.shape)[0]])
    return found


_BUILT_IN: Mapping[str, Numbers] = {"residual_stress": residual_stress}


def functions_of(numbers: Numbers | str | Iterable[Numbers | str] | None) -> list[Numbers]:
    """The functions that a user gives, one or several, also by words of the command line.

    Raises:
        InputError: one of them is no function.
    """
    given: list[Any]
    given = [] if numbers is None else [numbers] if callable(numbers) or isinstance(numbers, str) else list(numbers)
    functions = [function_of(one) if isinstance(one, str) else one for one in given]
    for one in functions:
        if not callable(one):
            raise InputError(f"numbers = {one!r}; allowed: a function of a run that returns numbers by their names")
    return functions


def function_of(text: str) -> Numbers:
    """The function of a word of the command line: "residual_stress", or "FILE.py:FUNCTION".

    Raises:
        InputError: there is no such file or function.
    """
    if text in _BUILT_IN:
        return _BUILT_IN[text]
    # The functions of a file are known by their words to other processes, too, which have not imported the file.
    file, colon, name = text.rpartition(":")
    path = Path(file)
    if not colon or path.suffix != ".py" or not path.is_file():
        known = ", ".join(_BUILT_IN)
        raise InputError(f"--numbers {text}: allowed: {known}, or FILE.py:FUNCTION with a file that exists")
    spec = importlib.util.spec_from_file_location(path.stem, path)
    assert spec is not None
    assert spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    try:
        spec.loader.exec_module(module)
    except Exception as error:  # of the user's file, whatever it is
        raise InputError(f"--numbers {text}: {path} cannot be run: {type(error).__name__}: {error}") from error
    function = getattr(module, name, None)
    if not callable(function):
        raise InputError(f"--numbers {text}: {path} has no function {name!r}")
    found: Numbers = functools.wraps(function)(functools.partial(function))
    found.words = f"{path.absolute()}:{name}"  # type: ignore[attr-defined]
    return found


def packed(functions: Iterable[Numbers]) -> tuple[str | bytes, ...]:
    """Functions in a form that other processes can call: words of the command line, or bytes of cloudpickle.

    Raises:
        InputError: a function cannot be taken to another process.
    """
    import cloudpickle

    found: list[str | bytes] = []
    for function in functions:
        words = next((name for name, one in _BUILT_IN.items() if one is function), getattr(function, "words", None))
        if words is not None:
            found.append(words)
            continue
        try:
            found.append(cloudpickle.dumps(function))
        except Exception as error:
            raise InputError(f"numbers: {_name(function)} cannot be taken to another process: {error}") from error
    return tuple(found)


@functools.lru_cache(maxsize=32)
def _unpacked(function: str | bytes) -> Numbers:
    if isinstance(function, str):
        return function_of(function)
    import cloudpickle

    found: Numbers = cloudpickle.loads(function)
    return found


def numbers_of(run: Run, functions: Iterable[str | bytes], index: int) -> dict[str, dict[str, Any]]:
    """Numbers of a run by the names of the functions, which are as `packed` returns them.

    Raises:
        InputError: a function fails or returns something else.
    """
    return {_name(function): _numbers_of(function, run, index) for function in map(_unpacked, functions)}


def _numbers_of(function: Numbers, run: Run, index: int) -> dict[str, Any]:
    what = f"numbers: {_name(function)} of run {index}"
    try:
        found = function(run)
    except Exception as error:  # of the user's function, whatever it is
        raise InputError(f"{what}: {type(error).__name__}: {error}") from error
    return _checked(found, what)


def _name(function: Numbers) -> str:
    return str(getattr(function, "__name__", repr(function)))


def with_numbers(
    table: pd.DataFrame,
    runs: Mapping[int, Run],
    functions: Sequence[Numbers],
    known: Mapping[int, Mapping[str, Mapping[str, Any]]] | None = None,
) -> pd.DataFrame:
    """The table with a column for each number; empty for runs without it.

    Args:
        table: table of a sweep.
        runs: runs whose folders are kept.
        functions: functions of a run.
        known: numbers of the other runs, by index and name of the function.

    Raises:
        InputError: a function fails, returns something else than numbers by their names, or the name of a column that
            the table has already; or neither the folder nor these numbers of a run are kept.
    """
    import pandas as pd

    done = table["index"][table["status"] == "done"].tolist()
    own: dict[int, dict[str, Any]] = {index: {} for index in done}
    for function in functions:
        for index in done:
            if index in runs:
                own[index] |= _numbers_of(function, runs[index], index)
                continue
            numbers = (known or {}).get(index, {})
            if _name(function) not in numbers:
                raise InputError(
                    f"numbers: {_name(function)} needs the folder of run {index}, which is not kept; allowed: the same "
                    "functions as when the run was computed, or a sweep in another folder"
                )
            own[index] |= numbers[_name(function)]
    columns = list(dict.fromkeys(column for numbers in own.values() for column in numbers))
    if taken := [column for column in columns if column in table.columns]:
        raise InputError(f"numbers: the table has a column {taken[0]} already; allowed: another name")
    further = pd.DataFrame([own.get(index, {}) for index in table["index"]], columns=columns, index=table.index)
    return pd.concat([table, further], axis=1)


def own_columns(table: pd.DataFrame, runs: Mapping[int, Run]) -> list[str]:
    """Columns of a table that are neither its own nor from the summaries of the runs."""
    from brinell.plot.differences import flat_case  # matplotlib is only for reports
    from brinell.sweeps.folder import flattened

    known = {"index", "status", "reason", "wall_time_s", "folder"}
    for run in runs.values():
        known |= flattened(run.summary or {}).keys() | dict(flat_case((run.summary or {}).get("case", {}))).keys()
    return [name for name in table.columns if name not in known and not _is_of_case(name, known)]


def _is_of_case(name: str, known: set[str]) -> bool:
    """Whether a column is an entry of a list of the case, such as indentation.load.2."""
    head, _, last = name.rpartition(".")
    return last.isdecimal() and head in known


def _checked(found: Any, what: str) -> dict[str, Any]:
    if not isinstance(found, Mapping):
        raise InputError(f"{what} returns {found!r}; allowed: numbers by their names, as {{'depth_um': 1.2}}")
    checked = {}
    for key, value in found.items():
        plain = value.item() if isinstance(value, (np.generic, np.ndarray)) and np.size(value) == 1 else value
        if not isinstance(key, str) or not isinstance(plain, (bool, int, float, str)):
            raise InputError(f"{what} returns {key!r}: {value!r}; allowed: a name, and a number or a word")
        checked[key] = plain
    return checked
