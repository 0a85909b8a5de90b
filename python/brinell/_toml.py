# SPDX-License-Identifier: BSD-3-Clause
"""The TOML parser: tomllib of the standard library from Python 3.11 on, before that tomli with the same interface.

Neither tells where a key stands; `line_of` looks for it.
"""

import re
import sys

if sys.version_info >= (3, 11):
    import tomllib
else:
    import tomli as tomllib

__all__ = ["line_of", "tomllib"]


def line_of(text: str, *keys: str) -> int:
    """Number of the line of a key or table, from 1.

    Args:
        text: a file as TOML.
        keys: names of the tables that lead to the key, and the key.

    Returns:
        The line of the key; where it is written in an unusual way, that of its table, or 1.
    """
    whole = list(keys)
    above: list[str] = []
    for number, line in enumerate(text.splitlines(), start=1):
        if header := re.match(r"\s*\[\[?(.*?)\]\]?\s*(#.*)?$", line):
            above = _parts(header[1])
            if above[: len(whole)] == whole:
                return number
        elif "=" in line and (above + _parts(line.partition("=")[0]))[: len(whole)] == whole:
            return number
    return line_of(text, *keys[:-1]) if len(keys) > 1 else 1


def _parts(text: str) -> list[str]:
    """Parts of a dotted key, without quotation marks."""
    return [one.strip().strip("\"'") for one in re.findall(r'"[^"]*"|\'[^\']*\'|[^."\'\s]+', text)]
