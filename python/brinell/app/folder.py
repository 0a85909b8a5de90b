# SPDX-License-Identifier: BSD-3-Clause
"""The folder of a page: nothing outside it is read or written."""

from __future__ import annotations

import fcntl
import json
import os
import tempfile
import time
from collections import deque
from dataclasses import dataclass
from pathlib import Path, PurePosixPath
from typing import IO

from brinell.errors import InputError, IoError

__all__ = ["PROGRESS", "Entry", "Folder", "is_locked", "json_of", "lock", "write_whole"]

PROGRESS = "progress.json"
"""How far a fit is, in its folder until it has finished."""

_DEPTH = 4
_DATA = (".npy", ".csv", ".txt", ".dat", ".xyz", ".asc")
_TEXTS = (".csv", ".txt", ".dat", ".asc")
_MOST = 500
_MOST_FOLDERS = 2000
_TRIES = 20
_LARGEST_CASE = 4_000_000  # bytes
_LARGEST_DATA = 20_000_000  # bytes


@dataclass(frozen=True)
class Entry:
    """Something that the folder holds."""

    kind: str
    """case, run, sweep, fit, or data: a file that a case may read."""
    name: str
    """Path from the folder, with slashes."""
    changed: float
    """Time of the last change [s since 1970]."""
    complete: bool = True
    """Of a run or a fit: whether it has finished."""


class Folder:
    """A folder with cases and results."""

    def __init__(self, root: Path):
        """Opens the folder.

        Args:
            root: the folder; it must exist.

        Raises:
            InputError: it is no folder.
        """
        if not root.is_dir():
            raise InputError(f"{root}: no such folder")
        self.root = root.resolve()

    def inside(self, name: str) -> Path:
        """Path of something in the folder.

        Args:
            name: path from the folder, with slashes.

        Raises:
            InputError: the name leads outside, also over a link, or names something hidden.
        """
        parts = PurePosixPath(name).parts if name and "\0" not in name and "\\" not in name else ()
        if not parts or len(name) > 1000 or name.startswith("/") or any(part.startswith(".") for part in parts):
            raise InputError(
                f"{name[:200]!r} is no name in the folder; allowed: names and slashes, none with a dot first"
            )
        path = self.root.joinpath(*parts)
        try:
            inside = path.resolve().is_relative_to(self.root)
        except (OSError, RuntimeError) as error:
            raise InputError(f"{name[:200]!r} cannot be reached: {error}") from error
        if not inside:
            raise InputError(f"{name!r} leads outside the folder {self.root}")
        return path

    def result(self, name: str) -> Path:
        """Folder of a result, none of whose files is a link that leads outside.

        Raises:
            InputError: the name is not allowed, or there is no such folder.
        """
        path = self.inside(name)
        if not path.is_dir():
            raise InputError(f"{name[:200]!r} is no result")
        for file in path.iterdir():
            if file.is_symlink() and not file.resolve().is_relative_to(self.root):
                raise InputError(f"{self.name_of(file)} leads outside the folder {self.root}")
        return path

    def name_of(self, path: Path) -> str:
        """Path from the folder, with slashes."""
        return path.relative_to(self.root).as_posix()

    def entries(self) -> list[Entry]:
        """What there is, changed last first; of a large tree what is not deep in it."""
        found: list[Entry] = []
        folders = deque([(self.root, 0)])
        for _ in range(_MOST_FOLDERS):
            if not folders or len(found) >= _MOST:
                break
            path, depth = folders.popleft()
            entries, below = self._looked_at(path, depth)
            found += entries
            if depth < _DEPTH:
                folders.extend((one, depth + 1) for one in below)
        return sorted(found, key=lambda one: -one.changed)

    def _looked_at(self, folder: Path, depth: int) -> tuple[list[Entry], list[Path]]:
        """What a folder holds, and the folders in it that are looked at, too."""
        try:
            here = sorted(os.scandir(folder), key=lambda one: one.name)
        except OSError:
            return [], []
        names = {one.name: one for one in here if one.is_file(follow_symlinks=False)}
        if depth and "history.csv" in names:
            return [self._entry("run", folder, names["history.csv"], "summary.json" in names)], []
        if depth and "fit.toml" in names and PROGRESS in names and "fit.json" not in names:
            return [self._entry("fit", folder, names[PROGRESS], complete=False)], []
        kind = "sweep" if "sweep.json" in names else "fit" if "fit.json" in names else ""
        found = [self._entry(kind, folder, names[f"{kind}.json"])] if depth and kind else []
        if found and kind == "fit":
            return found, []
        found += [
            self._entry("case", Path(one.path), one)
            for one in names.values()
            if one.name.endswith(".toml") and not one.name.startswith(".") and _is_case(one)
        ]
        found += [self._entry("data", Path(one.path), one) for one in names.values() if Path(one.name).suffix in _DATA]
        below = [Path(one.path) for one in here if one.is_dir(follow_symlinks=False) and not one.name.startswith(".")]
        return found, below

    def _entry(self, kind: str, path: Path, file: os.DirEntry[str], complete: bool = True) -> Entry:
        return Entry(kind, self.name_of(path), file.stat(follow_symlinks=False).st_mtime, complete)

    def read_case(self, name: str) -> str:
        """Text of a case file.

        Raises:
            InputError: it is no case file in the folder.
        """
        path = self._case_path(name)
        try:
            if not path.is_file() or path.stat().st_size > _LARGEST_CASE:
                raise InputError(f"{name!r} is no case file")
            return path.read_text(encoding="utf-8")
        except (OSError, UnicodeDecodeError) as error:
            raise InputError(f"{name!r} cannot be read: {error}") from error

    def data_file(self, name: str) -> Path:
        """A file of the folder with numbers as text.

        Raises:
            InputError: there is none of this name, or it is too large.
        """
        path = self.inside(name)
        if path.suffix not in _TEXTS or not path.is_file() or path.stat().st_size > _LARGEST_DATA:
            raise InputError(
                f"{name[:200]!r} is no file of numbers as text, or larger than {_LARGEST_DATA // 10**6} MB"
            )
        return path

    def read_data(self, name: str) -> str:
        """Text of a file with numbers.

        Raises:
            InputError: there is none of this name, or it is too large.
        """
        content = self.data_file(name).read_bytes()
        if content[:2] in (b"\xff\xfe", b"\xfe\xff"):
            return content.decode("utf-16", errors="replace")
        try:
            return content.decode("utf-8-sig")
        except UnicodeDecodeError:
            return content.decode("latin-1")

    def write_case(self, name: str, text: str, *, replace: bool) -> Path:
        """Writes a case file, as a whole or not at all.

        Args:
            name: path from the folder; it ends in .toml.
            text: text of the case.
            replace: whether an earlier file of that name is replaced.

        Raises:
            InputError: the name is not allowed, or the file exists and is to be kept.
            IoError: the file cannot be written; an earlier one is then as before.
        """
        path = self._case_path(name)
        if path.exists() and not replace:
            raise InputError(f"{name} exists already")
        try:
            path.parent.mkdir(parents=True, exist_ok=True)
            write_whole(path, text)
        except OSError as error:
            raise IoError(f"{name} could not be written: {error.strerror or error}") from error
        return path

    def _case_path(self, name: str) -> Path:
        if not name.endswith(".toml"):
            raise InputError(f"{name[:200]!r} is no case file; allowed: names that end in .toml")
        return self.inside(name)

    def new_results(self, name: str) -> Path:
        """Makes an empty folder for results, results/NAME or one with a number after it.

        Raises:
            InputError: the name is not allowed.
            IoError: the folder cannot be made.
        """
        base = self.inside(f"results/{name}")
        if len(PurePosixPath(name).parts) != 1:
            raise InputError(f"{name!r} is no name of results; allowed: one without a slash")
        try:
            base.parent.mkdir(exist_ok=True)
            for number in range(1, 10_000):
                path = base if number == 1 else base.with_name(f"{base.name}-{number}")
                try:
                    path.mkdir()
                except FileExistsError:
                    continue
                return path
        except OSError as error:
            raise IoError(f"results/{name} could not be made: {error.strerror or error}") from error
        raise IoError(f"results/{name} could not be made: there are too many of this name")


def _is_case(file: os.DirEntry[str]) -> bool:
    """Whether a TOML file is a case: it begins with a scenario, and is no resolved case of a run."""
    if file.name == "resolved.toml" or file.stat(follow_symlinks=False).st_size > _LARGEST_CASE:
        return False
    try:
        with open(file.path, encoding="utf-8") as text:
            return any(line.lstrip().startswith("scenario") for line in text)
    except (OSError, UnicodeDecodeError):
        return False


def lock(file: IO[bytes]) -> None:
    """Takes the lock of a file, as the process of a fit does for as long as it lives.

    Raises:
        IoError: another process has it.
    """
    for _ in range(_TRIES):
        try:
            fcntl.flock(file, fcntl.LOCK_EX | fcntl.LOCK_NB)
            return
        except BlockingIOError:  # perhaps only of one that looks whether it is free
            time.sleep(0.05)
    raise IoError(f"{file.name} is used by another process, which computes it already")


def is_locked(path: Path) -> bool:
    """Whether a process holds the lock of a file, whichever server has begun it."""
    try:
        with open(path, "rb") as file:
            fcntl.flock(file, fcntl.LOCK_SH | fcntl.LOCK_NB)
    except BlockingIOError:
        return True
    except OSError:
        return False
    return False


def write_whole(path: Path, text: str) -> None:
    """Writes a file as a whole or not at all, also where the disk is full.

    Raises:
        OSError: it could not be written; an earlier file is then as before.
    """
    descriptor, temporary = tempfile.mkstemp(dir=path.parent, prefix=".", suffix=".part")
    try:
        with open(descriptor, "w", encoding="utf-8") as file:
            file.write(text)
            file.flush()
            os.fsync(file.fileno())
        os.chmod(temporary, 0o644)
        os.replace(temporary, path)
    except BaseException:
        os.unlink(temporary)
        raise


def json_of(path: Path) -> dict[str, object]:
    """Content of a JSON file; empty if it cannot be read."""
    try:
        content = json.loads(path.read_text(encoding="utf-8"))
    except (OSError, ValueError):
        return {}
    return content if isinstance(content, dict) else {}
