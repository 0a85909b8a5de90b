# SPDX-License-Identifier: BSD-3-Clause
"""Materials to choose from: those of standards, with their sources, and the user's own ones.

The user's are in ``materials.toml`` in the user's folder of settings, one table per material.
"""

from __future__ import annotations

import os
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import tomli_w

from brinell._toml import tomllib
from brinell.app.case_text import values_of
from brinell.app.folder import write_whole
from brinell.errors import InputError, IoError
from brinell.materials import PRESETS, preset

__all__ = ["Materials", "user_file"]

_LONGEST_NAME = 60
_MOST = 500


def user_file() -> Path:
    """File of the user's own materials."""
    settings = os.environ.get("XDG_CONFIG_HOME") or Path.home() / ".config"
    return Path(settings) / "brinell" / "materials.toml"


class Materials:
    """Presets and the user's materials."""

    def __init__(self, file: Path):
        """Reads nothing yet.

        Args:
            file: file of the user's materials, which need not exist.
        """
        self._file = file

    def all(self) -> list[dict[str, Any]]:
        """The materials: name, source, whether it is the user's, and values by key below `material`."""
        found = []
        for one in PRESETS.values():
            for thermal in (False, True) if one.material.thermal is not None else (False,):
                name = f"{one.name}, with heat" if thermal else one.name
                values = _below(preset(one.name, thermal).to_case())
                found.append({"name": name, "source": one.source, "own": False, "values": values})
        for name, content in self._own().items():
            values = _below(content.get("material", {}))
            found.append({"name": name, "source": content.get("source", ""), "own": True, "values": values})
        return found

    def _own(self) -> dict[str, dict[str, Any]]:
        try:
            content = tomllib.loads(self._file.read_text(encoding="utf-8"))
        except FileNotFoundError:
            return {}
        except (OSError, ValueError) as error:
            raise IoError(f"{self._file}: cannot be read: {error}") from error
        return {name: one for name, one in content.items() if isinstance(one, dict)}

    def store(self, name: str, source: str, values: Mapping[str, Any]) -> None:
        """Stores a material of the user; one of the same name is replaced.

        Args:
            name: any text of one line.
            source: where the constants come from.
            values: values by key below `material`.

        Raises:
            InputError: the name or the values are not allowed.
            IoError: the file cannot be read or written.
        """
        if not name.strip() or len(name) > _LONGEST_NAME or not name.isprintable():
            raise InputError(
                f"{name[:100]!r} is no name of a material; allowed: a line of up to {_LONGEST_NAME} letters"
            )
        if name in {one["name"] for one in self.all() if not one["own"]}:
            raise InputError(f"{name!r} is the material of a standard; choose another name")
        if not values:
            raise InputError("a material without constants cannot be stored")
        own = self._own()
        if len(own) >= _MOST and name not in own:
            raise InputError(f"there are {_MOST} own materials already")
        self._write({**own, name: {"source": source[:500], "material": _nested(values)}})

    def remove(self, name: str) -> None:
        """Removes a material of the user.

        Raises:
            InputError: there is none of that name.
            IoError: the file cannot be written.
        """
        own = self._own()
        if name not in own:
            raise InputError(f"{name[:100]!r} is none of the own materials")
        self._write({key: one for key, one in own.items() if key != name})

    def _write(self, content: Mapping[str, Any]) -> None:
        try:
            self._file.parent.mkdir(parents=True, exist_ok=True)
            write_whole(self._file, tomli_w.dumps(content))
        except OSError as error:
            raise IoError(f"{self._file}: could not be written: {error.strerror or error}") from error


_BODY = "lower.material."


def _below(material: Mapping[str, Any]) -> dict[str, Any]:
    """Values of the table of a material by key below it: hardening.law, hardening.back_stresses[0].modulus."""
    values = values_of(tomli_w.dumps({"lower": {"material": material}}))
    return {key.removeprefix(_BODY): value for key, value in values.items()}


def _nested(values: Mapping[str, Any]) -> Any:
    """The inverse of `_below`."""
    from brinell.app.case_text import text_of

    text = text_of({f"{_BODY}{key}": value for key, value in values.items()}).text
    return tomllib.loads(text)["lower"]["material"]
