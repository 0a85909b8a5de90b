#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""What a change touches, for the checks that look at nothing else.

    tools/changes.py floors            # that are touched, or may include one that is
    tools/changes.py sources           # of src and apps: those that have changed, or a header that they include has
    tools/changes.py unity BUILD       # the unity files of the library and the program in BUILD that hold one of these

The change is all since $BRINELL_BASE; by default since the commit at which the branch has left origin/main or, on that
itself, since the commit before the last one. Files that are not committed count. All is touched if a file changes that
decides how all is built or checked, and if there is no earlier commit, as in a shallow clone. What is compared is told
on standard error.
"""

import os
import re
import subprocess
import sys
from pathlib import Path

from check_layers import FLOORS, INCLUDE

ROOT = Path(__file__).resolve().parents[1]
FOLDERS = ("include", "src", "apps", "tests")
SEARCHED = ("include", "src", "apps", "tests/support")  # for "..." and <...>, after the folder of the file itself
CONCERNS_ALL = re.compile(
    r"CMakeLists\.txt|CMakePresets\.json|cmake/.*|\.clang-tidy|tools/(changes|check_files)\.py"
)


def git(*arguments: str) -> str | None:
    """What git answers; None if it fails."""
    done = subprocess.run(["git", "-C", str(ROOT), *arguments], capture_output=True, text=True, check=False)
    return done.stdout.strip() if done.returncode == 0 else None


def base() -> str | None:
    """Commit with which the files are compared."""
    if given := os.environ.get("BRINELL_BASE"):
        commit = git("rev-parse", "--verify", "--quiet", given + "^{commit}")
        return commit or sys.exit(f"changes: BRINELL_BASE is {given}, which is no commit here")
    left = git("merge-base", "HEAD", "origin/main")
    return left if left and left != git("rev-parse", "HEAD") else git("rev-parse", "--verify", "--quiet", "HEAD^")


def changed_files() -> set[str] | None:
    """Paths that differ from the base, deleted ones included; None if nobody knows."""
    commit = base()
    if commit is None:
        print("changes: no earlier commit: everything", file=sys.stderr)
        return None
    since = git("diff", "--name-only", "--no-renames", commit)
    others = git("ls-files", "--others", "--exclude-standard")
    if since is None or others is None:
        print(f"changes: {commit} cannot be compared: everything", file=sys.stderr)
        return None
    files = set(since.splitlines()) | set(others.splitlines())
    commits = git("rev-list", "--count", f"{commit}..HEAD")
    print(f"changes: {len(files)} files in {commits} commits since {commit[:8]} and uncommitted", file=sys.stderr)
    return files


def concerns_all(files: set[str] | None) -> bool:
    """Whether everything is touched."""
    return files is None or any(CONCERNS_ALL.fullmatch(file) for file in files)


def includers() -> dict[str, set[str]]:
    """Of each header that a file of ours includes, the files that include it."""
    found: dict[str, set[str]] = {}
    for folder in FOLDERS:
        for path in (ROOT / folder).rglob("*.[ch]pp"):
            for line in path.read_text(encoding="utf-8").splitlines():
                if match := INCLUDE.match(line):
                    for place in (path.parent, *(ROOT / searched for searched in SEARCHED)):
                        header = os.path.normpath(place / match[1])
                        if os.path.isfile(header):
                            found.setdefault(os.path.relpath(header, ROOT), set()).add(str(path.relative_to(ROOT)))
                            break
    return found


def sources(files: set[str] | None) -> list[str]:
    """Sources of src and apps that are touched."""
    everything = {str(p.relative_to(ROOT)) for folder in ("src", "apps") for p in (ROOT / folder).rglob("*.cpp")}
    if files is None or concerns_all(files):
        return sorted(everything)
    by_header = includers()
    touched, rest = set(files), list(files)
    while rest:
        new = by_header.get(rest.pop(), set()) - touched
        touched |= new
        rest += new
    return sorted(touched & everything)


def floors(files: set[str] | None) -> list[str]:
    """Floors whose unit tests may come out otherwise, bottom-up."""
    if files is None or concerns_all(files) or any(file.startswith("tests/support/") for file in files):
        return list(FLOORS)
    touched = set()
    for file in files:
        if match := re.match(r"(?:src|include/brinell|tests/unit)/(\w+)/", file):
            touched.add(match[1])
            if not file.startswith("tests/"):
                touched |= {floor for floor, below in FLOORS.items() if match[1] in below}
    return [floor for floor in FLOORS if floor in touched]


def unity_files(build: Path, touched: set[str]) -> list[str]:
    """Unity files of a build that hold one of the sources."""
    included = re.compile(r'^#include "(.*)"', re.MULTILINE)
    return [
        str(unity)
        for unity in sorted(build.resolve().glob("CMakeFiles/brinell*.dir/Unity/unity_*.cxx"))
        if re.search(r"/brinell_(numerics|processor|simulation|io|app|program)\.dir/", str(unity))
        and touched & {os.path.relpath(source, ROOT) for source in included.findall(unity.read_text(encoding="utf-8"))}
    ]


def main() -> int:
    match sys.argv[1:]:
        case ["floors"]:
            found = floors(changed_files())
        case ["sources"]:
            found = sources(changed_files())
        case ["unity", build]:
            found = unity_files(Path(build), set(sources(changed_files())))
        case _:
            print(__doc__, file=sys.stderr)
            return 2
    print("\n".join(found))
    return 0


if __name__ == "__main__":
    sys.exit(main())
