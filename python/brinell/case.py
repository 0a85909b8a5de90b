# SPDX-License-Identifier: BSD-3-Clause
"""A case: the definition of a computation, from a TOML file, from text, or from Python (`brinell.scenarios`)."""

from __future__ import annotations

import shutil
import sys
import tempfile
import warnings
import weakref
from collections.abc import Callable, Iterable, Mapping
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Any, TypeAlias, TypeVar

import tomli_w

from brinell import _core
from brinell._names import level_of_caller
from brinell._values import HeightMaps, overrides_of, plain
from brinell.errors import InputError
from brinell.forecast import Forecast
from brinell.stepping import Stepping

with warnings.catch_warnings():  # in a notebook without ipywidgets tqdm warns and shows the bar of a terminal
    warnings.simplefilter("ignore")
    from tqdm.auto import tqdm

if TYPE_CHECKING:
    from typing import Self

    from mpi4py import MPI

    from brinell.results import Run, RunWarning

__all__ = ["Case", "CaseWarning", "HeightMaps", "Progress", "ReplacementWarning", "ResolutionWarning"]

_T = TypeVar("_T")

Progress: TypeAlias = Callable[[int, int, str, int], None]
"""Function called after each step with the step's number from 0, the estimated number of steps, the position in the
run as text, and the number of evaluations of the step."""


class CaseWarning(UserWarning):
    """A case can be computed but has a setting that should be checked."""


class ReplacementWarning(UserWarning):
    """A run replaces the earlier result in its folder, as nothing was said about it."""


class ResolutionWarning(UserWarning):
    """A result should be checked before its numbers are used: too few cells, no yield, large strains and so on."""


class Case:
    """One case, checked and ready to run. It is immutable; `with_values` returns a modified copy.

    Keys and error messages are those of the case file (docs/reference/case-file.md).

        case = Case.from_file("cases/tugging/case.toml", ["tugging.interference=4"])
        run = case.run(progress=True)
    """

    def __init__(
        self,
        text: str,
        *,
        file: str | Path = "case.toml",
        overrides: Iterable[str] = (),
        names_lines: bool = True,
        maps: HeightMaps | None = None,
    ):
        """Reads a case from the text of a case file.

        Args:
            text: text of a case file (TOML).
            file: name of the case file in messages; relative paths in the text refer to its folder.
            overrides: replaced values as "key=value", as for --set.
            names_lines: whether messages name file and line; False for a generated text that the user does not see.
            maps: height maps [y, x] in m by the names that texture.file uses for them instead of a file.

        Raises:
            InputError: the case is invalid; the message lists all problems found, one per line.
        """
        self._text = text
        self._file = Path(file)
        self._overrides = (overrides,) if isinstance(overrides, str) else tuple(overrides)
        self._names_lines = names_lines
        self._maps = dict(maps or {})
        self._core = _core.parse_case(text, self._file, list(self._overrides), self._maps, names_lines)
        place = f"{self._file}: " if names_lines else ""
        for _, text in self._core.warnings:
            warnings.warn(f"{place}{text}", CaseWarning, stacklevel=level_of_caller())

    def __reduce__(self) -> tuple[Any, ...]:
        """Copies and other processes parse the case again, without repeating its warnings."""
        file = self._file.absolute()
        return _read_again, (type(self), self._text, file, self._overrides, self._names_lines, self._maps)

    @classmethod
    def from_file(cls, path: str | Path, overrides: Iterable[str] = ()) -> Case:
        """Reads a case file.

        Args:
            path: path of the case file.
            overrides: replaced values as "key=value", as for --set.

        Raises:
            InputError: the file is missing or not a regular file, or the case is invalid; the message then lists all
                problems found, one per line.
            IoError: the file cannot be read.
        """
        try:
            text = _core.case_file_text(Path(path))
        except UnicodeDecodeError:
            _core.read_case(Path(path), [])  # raises the error with the message of the engine
            raise
        return Case(text, file=path, overrides=overrides)

    @classmethod
    def from_values(cls, values: Mapping[str, Any], *, file: str | Path = "case.toml") -> Case:
        """Makes a case from nested dictionaries with the structure of a case file.

        Args:
            values: tables and keys of the case file.
            file: name of the case file in messages; relative paths in the values refer to its folder.

        Raises:
            InputError: the case is invalid; the message lists all problems found, one per line.
        """
        maps: HeightMaps = {}
        return Case(tomli_w.dumps(plain(values, maps)), file=file, names_lines=False, maps=maps)

    @property
    def scenario(self) -> str:
        """Name of the scenario, as in the case file."""
        return self._core.scenario

    @property
    def name(self) -> str:
        """Name of the case: that of the file, or that of its folder if the file is called case.toml."""
        return self._core.name

    @property
    def title(self) -> str:
        """Title of the case; it may be empty."""
        return self._core.title

    def with_values(self, values: Mapping[str, Any] | Iterable[str]) -> Self:
        """Returns a copy of the case with some keys replaced or added.

        Args:
            values: new values by dotted key, {"tugging.interference": 4}, where a table is a dictionary; or a list of
                "key=value", as for --set.

        Raises:
            InputError: the new case is invalid.
        """
        if isinstance(values, str):
            values = [values]
        maps = dict(self._maps)
        added = overrides_of(values, maps) if isinstance(values, Mapping) else list(values)
        case = object.__new__(type(self))
        overrides = [*self._overrides, *added]
        try:
            Case.__init__(
                case, self._text, file=self._file, overrides=overrides, names_lines=self._names_lines, maps=maps
            )
        except InputError as error:
            if not isinstance(values, Mapping):
                raise
            text = str(error)
            for override in overrides:  # the message names the key anyway
                text = text.replace(f"--set {override}: ", "").replace(f" (--set {override})", "")
            raise type(error)(text) from None
        return case

    def to_toml(self, path: str | Path | None = None) -> str:
        """Returns the case with all defaults filled in, in SI units, as the text of a case file.

        Args:
            path: file to which the text is also written; None: no file. Height maps of more than a thousand points are
                then written to .npy files in the same folder, which the written text refers to.

        Returns:
            The text with all values of the case, including the heights of height maps.

        Raises:
            IoError: the file cannot be written.
        """
        if path is not None:
            self._core.write_resolved(Path(path))
        return self._core.resolved_text()

    def check(self) -> str:
        """Text that ``brinell check`` prints: the resolved case, critical values, grids, steps, memory, cost.

        Raises:
            InputError: the grid does not fit this machine.
        """
        return self._core.check_report()

    @property
    def warnings(self) -> list[RunWarning]:
        """Warnings about the result that are known before the run; ``brinell check`` prints them, too.

        Raises:
            InputError: the grid does not fit this machine.
        """
        from brinell.results import RunWarning  # results know the scenarios, which are cases

        return [RunWarning(key, text) for key, text in self._core.expected_warnings]

    @property
    def result_size(self) -> int:
        """Size of the stored fields before compression, an estimate [bytes]; `output` of the case changes it.

        Raises:
            InputError: the grid does not fit this machine.
        """
        return round(self._core.result_bytes)

    @property
    def forecast(self) -> Forecast:
        """Time and memory of a run, as ``brinell check`` tells them before it.

        Raises:
            InputError: the grid does not fit this machine.
        """
        told = self._core.forecast
        return Forecast(told.seconds, (told.shortest, told.longest), round(told.memory), told.text)

    def citations(self) -> list[str]:
        """References to cite: brinell and the papers behind the models of this case, one a line (``brinell cite``)."""
        return self._core.citation_lines()

    def run(
        self,
        output: str | Path | None = None,
        *,
        progress: bool | Progress | None = None,
        threads: int | None = None,
        resume: bool = False,
        replace: bool | None = None,
        accuracy: float | str | None = None,
        device: str | None = None,
        in_memory: bool = False,
        comm: MPI.Comm | None = None,
    ) -> Run:
        """Computes the case. Warnings about the result are issued as `ResolutionWarning` and stored in `Run.warnings`.

        Ctrl-C stops the run at the end of the current step, or at once if the step takes long; the text of the
        KeyboardInterrupt says which results are kept, and where. A temporary folder is then kept if at least one step
        was finished.

        Args:
            output: folder of the results. None: a temporary folder, which is deleted together with the returned object.
            progress: True shows a progress bar, also of a run in memory; False shows none; None shows one in a terminal
                or notebook if the run takes longer than two seconds. A function is called after each step.
            threads: number of threads; None: as OpenMP decides.
            resume: resume a stopped run of this case in the folder `output`.
            replace: whether an earlier result in the folder `output` is replaced. False: it is an error. None: it is
                replaced with a `ReplacementWarning`.
            accuracy: largest accepted relative error of the key numbers, 0.01 or "1 %". The case is run with coarse
                cells first, and with finer cells as long as needed; `Run.accuracy` has the error interval of each
                number.
            device: where the bodies are computed, "cpu", "cuda" (a GPU), "auto" or "host" (docs/howto/gpu.md); None: as
                `Solver.device` says.
            in_memory: write nothing to disk, for loops of small runs. The result is lost with the returned object, and
                a run that does not finish leaves no result.
            comm: processes of mpi4py that compute this case together, each with a part of the bodies
                (docs/howto/ranks.md); None: this process alone. All call `run` with the same case and the same
                arguments. The first one writes the folder, issues the warnings and shows the progress or calls
                `progress`; an error, or Ctrl-C, of one is raised by all. All return the same results, which each of
                them reads from the folder.

        Returns:
            The results; with `accuracy`, those of the finest cells.

        Raises:
            InputError: a grid does not fit or turned out to be too small, the folder to resume holds another case, the
                folder holds a result that is to be kept, in_memory is combined with output, resume or accuracy,
                replace with resume or without a folder, or comm with in_memory or accuracy or without a folder.
            ConvergenceError: a step did not converge; the steps before are in the folder.
            IoError: the results cannot be written.
            DeviceError: there is no GPU, or it does not suit or has failed; the steps before are in the folder.
        """
        from brinell.results.opening import open_run, run_of_image

        if device is not None:
            return self.with_values({"solver.device": device}).run(
                output,
                progress=progress,
                threads=threads,
                resume=resume,
                replace=replace,
                accuracy=accuracy,
                in_memory=in_memory,
                comm=comm,
            )

        if in_memory and (output is not None or resume or accuracy is not None):
            rival = "a folder" if output is not None else "resume" if resume else "accuracy"
            raise InputError(f"run(in_memory=True) cannot stand together with {rival}; allowed: one of both")
        if replace is not None and (output is None or resume):
            where = "without a folder" if output is None else "together with resume"
            raise InputError(
                f"run(replace={replace}) has no effect {where}; allowed: with a folder in which a run begins"
            )
        if comm is not None and comm.Get_size() > 1:
            if output is None or accuracy is not None:
                rival = "accuracy" if accuracy is not None else "in_memory" if in_memory else "no folder"
                raise InputError(
                    f"run(comm=...) of several processes cannot stand together with {rival}; allowed: a folder"
                )
            return self._run_together(comm, Path(output), progress, threads, resume, replace)
        if accuracy is not None:
            case = self.with_values({"solver.accuracy": accuracy})
            return case.run(output, progress=progress, threads=threads, resume=resume, replace=replace)
        told = [text for key, text in self._core.result_warnings if key == "large_result"]
        for text in told:  # before it is written
            warnings.warn(text, ResolutionWarning, stacklevel=level_of_caller())
        if in_memory:
            count = _thread_count(threads)
            try:
                image = self._with_progress(progress, partial(self._core.run_in_memory, count))
            except KeyboardInterrupt:
                raise KeyboardInterrupt("interrupted; nothing is kept of a run in memory") from None
            return self._with_warnings_issued(run_of_image(image), told)
        if output is not None:
            mode = _core.Mode.resume if resume else _core.Mode.keep if replace is False else _core.Mode.replace
            self._compute(Path(output), progress, threads, mode, warns=replace is None)
            return self._with_warnings_issued(open_run(output), told)
        mode = _core.Mode.resume if resume else _core.Mode.replace
        return self._with_warnings_issued(self._run_in_temporary_folder(progress, threads, mode), told)

    def _run_together(
        self,
        comm: MPI.Comm,
        folder: Path,
        progress: bool | Progress | None,
        threads: int | None,
        resume: bool,
        replace: bool | None,
    ) -> Run:
        """Computes the case as one of several processes, of which the first one speaks and writes."""
        from brinell._ranks import done_together
        from brinell.results.opening import open_run

        is_first = comm.Get_rank() == 0
        mode = _core.Mode.resume if resume else _core.Mode.keep if replace is False else _core.Mode.replace
        told = [text for key, text in self._core.result_warnings if key == "large_result"]
        for text in told if is_first else ():
            warnings.warn(text, ResolutionWarning, stacklevel=level_of_caller())
        shown = progress if is_first else False
        warns = replace is None and is_first
        done_together(comm, lambda own: self._compute(folder, shown, threads, mode, warns, own))
        run = open_run(folder)
        return self._with_warnings_issued(run, told) if is_first else run

    def _run_in_temporary_folder(self, progress: bool | Progress | None, threads: int | None, mode: _core.Mode) -> Run:
        """Runs the case in a temporary folder, deleted together with the result; finished steps survive Ctrl-C."""
        from brinell.results.opening import kept_results, open_run

        folder = Path(tempfile.mkdtemp(prefix="brinell-"))
        try:
            self._compute(folder, progress, threads, mode)
            run = open_run(folder)
        except BaseException as error:
            if not (isinstance(error, KeyboardInterrupt) and kept_results(folder)):
                shutil.rmtree(folder, ignore_errors=True)
            raise
        weakref.finalize(run, shutil.rmtree, folder, ignore_errors=True)
        return run

    def steps(self, *, threads: int | None = None) -> Stepping:
        """Computes the case step by step, ``for record in case.steps(): ...``, and writes no files.

        Several cases may be computed at once, each in a thread of Python of its own.

        Args:
            threads: number of threads of each step; None: as OpenMP decides.

        Returns:
            An iterator over the rows of the history, with access to the fields after each step.

        Raises:
            InputError: the grid does not fit this machine.
        """
        return Stepping(self, _thread_count(threads))

    def _with_warnings_issued(self, run: Run, told: Iterable[str]) -> Run:
        """Issues the warnings of a run, except those of the case, issued when it was read, and those told before."""
        already_issued = {*(text for _, text in self._core.warnings), *told}
        for warning in run.warnings:
            if warning.text not in already_issued:
                warnings.warn(warning.text, ResolutionWarning, stacklevel=level_of_caller())
        return run

    def _compute(
        self,
        folder: Path,
        progress: bool | Progress | None,
        threads: int | None,
        mode: _core.Mode,
        warns: bool = False,
        comm: MPI.Comm | None = None,
    ) -> None:
        from brinell.results.opening import kept_results

        def on_replaced() -> None:
            text = f"the earlier result in {folder} is replaced; replace = True says so, replace = False keeps it"
            warnings.warn(text, ReplacementWarning, stacklevel=level_of_caller())

        def run(on_step: Progress | None) -> str:
            return self._core.run(folder, mode, _thread_count(threads), on_step, on_replaced if warns else None, comm)

        try:
            self._with_progress(progress, run)
        except KeyboardInterrupt:
            raise KeyboardInterrupt(f"interrupted; {kept_results(folder) or 'nothing has been finished'}") from None

    def _with_progress(self, progress: bool | Progress | None, run: Callable[[Progress | None], _T]) -> _T:
        """Calls `run` with the function that is to be called after each step: the user's, or that of a progress bar."""
        if callable(progress) or progress is False or (progress is None and not _someone_looks()):
            return run(progress or None)
        with tqdm(unit="step", desc=self.title or self.name, delay=0.0 if progress else _PATIENCE) as bar:

            def show(step: int, count: int, where: str, _: int) -> None:
                bar.total = max(count, step + 1)
                bar.set_postfix_str(where, refresh=False)
                bar.update(step + 1 - bar.n)

            return run(show)

    def __repr__(self) -> str:
        return f"<brinell.{type(self).__name__} {self.scenario} {self.title or self.name!r}>"


_PATIENCE = 2.0
"""Time [s] after which a run shows its progress without being asked to."""


def _someone_looks() -> bool:
    """Whether this is a terminal or a notebook."""
    return sys.stderr.isatty() or "ipykernel" in sys.modules


def _thread_count(threads: int | None) -> int:
    """Checks a number of threads and returns it for the engine, where 0 leaves the choice to OpenMP."""
    if threads is not None and (not isinstance(threads, int) or threads < 1):
        raise InputError(f"threads = {threads!r}; allowed: a whole number, 1 or more, or None")
    return threads or 0


def _read_again(
    kind: type[Case], text: str, file: Path, overrides: tuple[str, ...], names_lines: bool, maps: HeightMaps
) -> Case:
    case = object.__new__(kind)
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", CaseWarning)
        Case.__init__(case, text, file=file, overrides=overrides, names_lines=names_lines, maps=maps)
    return case


def in_arguments(text: str, scenario: str = "") -> str:
    """Replaces keys of the case file in a message by the Python arguments where these differ.

    Args:
        text: the message.
        scenario: scenario whose table corresponds to the class: "load = ..." instead of "indentation.load = ...".
    """
    if scenario:
        text = text.replace(f"{scenario}.", "")
    return text.replace("hardening.back_stresses", "back_stresses")
