#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Fails on a comment whose first word points to something else. Usage: tools/check_comments.py [ROOT]

A reader comes to a declaration from anywhere, so its comment stands alone: it begins with a noun phrase, or with a verb
if it describes a function. Public headers, sources, the program and the bindings are read.
"""

import re
import sys
from pathlib import Path

FOLDERS = ("include", "src", "apps", "python/bindings")
POINTING = "the same|same|that|those|this|these|such|what|likewise|also|ditto|it|its"
# A comment after a declaration goes on in lower case; "Which of ..." at the head of a comment is a question.
AFTER = re.compile(rf"///<\s*(?P<word>(?i:{POINTING})|which|and|or|but)\b")
HEAD = re.compile(rf"^\s*///?\s*(?P<word>(?i:{POINTING}))\b")
COMMENT = re.compile(r"^\s*//")


def pointing(text: str) -> list[tuple[int, str]]:
    """Numbers of the lines whose comment begins with such a word, and the words."""
    found, was_comment = [], False
    for number, line in enumerate(text.splitlines(), start=1):
        match = AFTER.search(line) or (None if was_comment else HEAD.match(line))
        if match:
            found.append((number, match["word"]))
        was_comment = COMMENT.match(line) is not None and not AFTER.search(line)
    return found


def main() -> int:
    root = Path(sys.argv[1] if len(sys.argv) > 1 else Path(__file__).resolve().parent.parent)
    files = [path for folder in FOLDERS for path in sorted((root / folder).rglob("*.[ch]pp"))]
    found = [(path, *where) for path in files for where in pointing(path.read_text(encoding="utf-8"))]
    for path, number, word in found:
        print(f'{path.relative_to(root)}:{number}: the comment begins with "{word}"; begin with a noun or a verb')
    print(f"comments: {len(files)} files, {len(found)} that do not stand alone")
    return 1 if found or not files else 0


if __name__ == "__main__":
    sys.exit(main())
