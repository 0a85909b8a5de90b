# SPDX-License-Identifier: BSD-3-Clause
"""A case: what is to be computed, from a TOML file, from text, or from Python (`brinell.scenarios`)."""

from __future__ import annotations

import shutil
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
from brinell.stepping import Stepping

with warnings.catch_warnings():  # a notebook without ipywidgets gets the bar of a terminal, without a word
    warnings.simplefilter("ignore")
    from tqdm.auto import tqdm

if TYPE_CHECKING:
    from typing import Self

    from brinell.results import Run, RunWarning

__all__ = ["Case", "CaseWarning", "HeightMaps", "OldNameWarning", "Progress", "ResolutionWarning"]

_T = TypeVar("_T")

Progress: TypeAlias = Callable[[int, int, str, int], None]
"""Called after each step: its number from 0, an estimate of their count, where it was, evaluations that it took."""


class CaseWarning(UserWarning):
    """Something in a case that can be computed, but should be looked at."""


class OldNameWarning(CaseWarning, FutureWarning):
    """A key of a case has a new name; the old one is understood for a version."""


class ResolutionWarning(UserWarning):
    """A result that should be looked at before its numbers are used: too few cells, no yield, large strains, ..."""


class Case:
    """One case, checked and ready to run. It does not change; `with_values` gives another one.

    All keys are those of the case file (docs/reference/case-file.md), and so are the errors.

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
            text: TOML.
            file: its name in messages; the paths that it holds begin in its folder.
            overrides: "key=value", as behind --set.
            names_lines: whether messages name file and line; False for a text that nobody sees.
            maps: heights [y, x] in m that texture.file may name as if they were files.

        Raises:
            InputError: with all problems found, one per line.
        """
        self._text = text
        self._file = Path(file)
        self._overrides = (overrides,) if isinstance(overrides, str) else tuple(overrides)
        self._names_lines = names_lines
        self._maps = dict(maps or {})
        self._core = _core.parse_case(text, self._file, list(self._overrides), self._maps, names_lines)
        place = f"{self._file}: " if names_lines else ""
        for key, text in self._core.warnings:
            category = OldNameWarning if key == "old_name" else CaseWarning
            warnings.warn(f"{place}{text}", category, stacklevel=level_of_caller())

    def __reduce__(self) -> tuple[Any, ...]:
        """Copies and other processes read the case again; its warnings have been told."""
        file = self._file.absolute()
        return _read_again, (type(self), self._text, file, self._overrides, self._names_lines, self._maps)

    @classmethod
    def from_file(cls, path: str | Path, overrides: Iterable[str] = ()) -> Case:
        """Reads a case file.

        Args:
            path: of the file.
            overrides: "key=value", as behind --set.

        Raises:
            InputError: the file is missing or no regular one, or with all problems found, one per line.
            IoError: it cannot be read.
        """
        try:
            text = _core.case_file_text(Path(path))
        except UnicodeDecodeError:
            _core.read_case(Path(path), [])  # has the message
            raise
        return Case(text, file=path, overrides=overrides)

    @classmethod
    def from_values(cls, values: Mapping[str, Any], *, file: str | Path = "case.toml") -> Case:
        """A case from nested dictionaries, as a TOML parser would give them."""
        maps: HeightMaps = {}
        return Case(tomli_w.dumps(plain(values, maps)), file=file, names_lines=False, maps=maps)

    @property
    def scenario(self) -> str:
        """Its name, as in the case file."""
        return self._core.scenario

    @property
    def name(self) -> str:
        """Of the file, or of its folder if it is called case.toml."""
        return self._core.name

    @property
    def title(self) -> str:
        """May be empty."""
        return self._core.title

    def with_values(self, values: Mapping[str, Any] | Iterable[str]) -> Self:
        """The same case with some keys replaced or added.

        Args:
            values: by their dotted keys, {"tugging.interference": 4}, a table as a dictionary; or "key=value", as
                behind --set.

        Raises:
            InputError: as for a case file.
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
            for override in overrides:  # the key is named behind it
                text = text.replace(f"--set {override}: ", "").replace(f" (--set {override})", "")
            raise type(error)(text) from None
        return case

    def to_toml(self, path: str | Path | None = None) -> str:
        """The case with all its defaults filled in, in SI, as a case file.

        Args:
            path: where to write it, if at all; height maps of more than a thousand points become files beside it, .npy,
                which the written text names.

        Returns:
            The text, which holds all of the case.

        Raises:
            IoError: it cannot be written.
        """
        if path is not None:
            self._core.write_resolved(Path(path))
        return self._core.resolved_text()

    def check(self) -> str:
        """What ``brinell check`` prints: the resolved case, critical values, grids, steps, memory, cost.

        Raises:
            InputError: the grid does not fit this machine.
        """
        return self._core.check_report()

    @property
    def warnings(self) -> list[RunWarning]:
        """What is known before a run to be wary of; ``brinell check`` tells it, too.

        Raises:
            InputError: the grid does not fit this machine.
        """
        from brinell.results import RunWarning  # results know the scenarios, which are cases

        return [RunWarning(key, text) for key, text in self._core.expected_warnings]

    def citations(self) -> list[str]:
        """The papers behind the models of this case, brinell first, one line each (``brinell cite``)."""
        return self._core.citation_lines()

    def run(
        self,
        output: str | Path | None = None,
        *,
        progress: bool | Progress = False,
        threads: int | None = None,
        resume: bool = False,
        accuracy: float | str | None = None,
        in_memory: bool = False,
    ) -> Run:
        """Computes the case. What to be wary of in the result is told as `ResolutionWarning`, and is in `Run.warnings`.

        Ctrl-C ends it after the step, or within a moment if a step takes long; the text of the KeyboardInterrupt says
        what is kept, and where. A temporary folder stays then, if a step had been finished.

        Args:
            output: folder of the results, which replaces an earlier result there; a temporary one, that goes with the
                run object, if None.
            progress: show a bar, or call this function after each step.
            threads: how many; None: as OpenMP decides.
            resume: go on with a run of this case that was stopped in that folder.
            accuracy: largest relative error of the key numbers that is accepted, 0.01 or "1 %": runs the case with
                coarser cells first, and with finer ones as long as needed; `Run.accuracy` then tells the interval of
                each number.
            in_memory: write nothing to a disk, for loops of small runs: the result is lost with the run object, and so
                is what a run has done that does not reach its end.

        Returns:
            The results; with an accuracy, those of the finest cells.

        Raises:
            InputError: a grid does not fit or turned out too small, or the folder holds another case to resume.
            ConvergenceError: a step did not converge; those before are in the folder.
            IoError: the results cannot be written.
        """
        from brinell.results.opening import open_run, run_of_image

        if in_memory and (output is not None or resume or accuracy is not None):
            rival = "a folder" if output is not None else "resume" if resume else "accuracy"
            raise InputError(f"run(in_memory=True) cannot stand together with {rival}; allowed: one of both")
        if accuracy is not None:
            case = self.with_values({"solver.accuracy": accuracy})
            return case.run(output, progress=progress, threads=threads, resume=resume)
        if in_memory:
            count = _thread_count(threads)
            try:
                image = self._watched(progress, partial(self._core.run_in_memory, count))
            except KeyboardInterrupt:
                raise KeyboardInterrupt("interrupted; nothing is kept of a run in memory") from None
            return self._told(run_of_image(image))
        if output is not None:
            self._compute(Path(output), progress, threads, resume)
            return self._told(open_run(output))
        return self._told(self._run_in_passing(progress, threads, resume))

    def _run_in_passing(self, progress: bool | Progress, threads: int | None, resume: bool) -> Run:
        """In a temporary folder, which goes with the result; it stays if the user stops the run half-way."""
        from brinell.results.opening import kept_of, open_run

        folder = Path(tempfile.mkdtemp(prefix="brinell-"))
        try:
            self._compute(folder, progress, threads, resume)
            run = open_run(folder)
        except BaseException as error:
            if not (isinstance(error, KeyboardInterrupt) and kept_of(folder)):
                shutil.rmtree(folder, ignore_errors=True)
            raise
        weakref.finalize(run, shutil.rmtree, folder, ignore_errors=True)
        return run

    def steps(self) -> Stepping:
        """Computes the case step by step: ``for record in case.steps(): ...``. Nothing is written.

        Returns:
            An iterator over the rows of the history, which can show the fields after each of them.

        Raises:
            InputError: the grid does not fit this machine.
        """
        return Stepping(self)

    def _told(self, run: Run) -> Run:
        """Warns of what the run has found; what the case itself is warned of has been told when it was read."""
        told = {text for _, text in self._core.warnings}
        for warning in run.warnings:
            if warning.text not in told:
                warnings.warn(warning.text, ResolutionWarning, stacklevel=level_of_caller())
        return run

    def _compute(self, folder: Path, progress: bool | Progress, threads: int | None, resume: bool) -> None:
        from brinell.results.opening import kept_of

        try:
            self._watched(progress, partial(self._core.run, folder, resume, _thread_count(threads)))
        except KeyboardInterrupt:
            raise KeyboardInterrupt(f"interrupted; {kept_of(folder) or 'nothing has been finished'}") from None

    def _watched(self, progress: bool | Progress, run: Callable[[Progress | None], _T]) -> _T:
        """Calls what runs the case, with a function that is to be called after each step."""
        if progress is not True:
            return run(progress or None)
        with tqdm(unit="step", desc=self.title or self.name) as bar:

            def show(step: int, count: int, where: str, _: int) -> None:
                bar.total = max(count, step + 1)
                bar.set_postfix_str(where, refresh=False)
                bar.update(step + 1 - bar.n)

            return run(show)

    def __repr__(self) -> str:
        return f"<brinell.{type(self).__name__} {self.scenario} {self.title or self.name!r}>"


def _thread_count(threads: int | None) -> int:
    """As the engine wants it: 0 for as OpenMP decides."""
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
    """A message about keys of the case file in the words of Python's arguments, where these differ.

    Args:
        text: the message.
        scenario: its table is the class itself: "load = ..." instead of "indentation.load = ...".
    """
    if scenario:
        text = text.replace(f"{scenario}.", "")
    return text.replace("hardening.back_stresses", "back_stresses")
