#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Fails on a source that does not compile alone, includes a header twice or brings in a name that it does not use.

Usage: tools/check_files.py BUILD [JOBS [--only SOURCE...]], where BUILD holds a compile_commands.json of src and apps,
file by file. With --only these sources alone are compiled; the text of all is read.

The builds compile several sources at a time, where one may live on what another one includes. Headers of other libraries
that many sources include would take most of the time: they are compiled once and given to all, so that a source which
forgets one of them is not found.
"""

import json
import re
import shlex
import subprocess
import sys
import tempfile
from collections import Counter, defaultdict
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
WITH_MPI = ROOT / "apps/brinell/mpi"  # compiled with BRINELL_MPI only
INCLUDE = re.compile(r'^\s*#\s*include\s*([<"][^">]+[">])', re.MULTILINE)
BROUGHT_IN = re.compile(r"^\s*(?:using (?:[\w:]+::)?(\w+)|namespace (\w+) = [\w:]+);", re.MULTILINE)
COMMENT = re.compile(r"//.*")
OTHERS_SHARED_BY = 5  # sources: headers of other libraries that fewer include are not worth compiling for all


def untidy(path: Path) -> list[str]:
    """What is wrong with the text of a source or header."""
    text = COMMENT.sub("", path.read_text(encoding="utf-8"))
    twice = [header for header, count in Counter(INCLUDE.findall(text)).items() if count > 1]
    found = [f"includes {header} twice" for header in twice]
    found += [f"includes the source {header}" for header in INCLUDE.findall(text) if header[1:-1].endswith(".cpp")]
    for match in BROUGHT_IN.finditer(text) if path.suffix == ".cpp" else []:
        name = match[1] or match[2]
        if len(re.findall(rf"\b{name}\b", text)) == len(re.findall(rf"\b{name}\b", match[0])):
            found.append(f"does not use {name}")
    return [f"{path.relative_to(ROOT)}: {what}" for what in found]


def syntax_only(entry: dict) -> list[str]:
    """The command of a source without launcher, source and output, as one that writes nothing."""
    words = shlex.split(entry["command"])
    words = words[next(i for i, word in enumerate(words) if "ccache" not in word) :]
    output = words.index("-o")
    del words[output : output + 2]
    return [word for word in words if word not in ("-c", entry["file"])] + ["-Werror"]


def shared_headers(sources: list[Path]) -> list[str]:
    """Headers of other libraries that several of the sources or headers include."""
    headers = [*sources, *(ROOT / "src").rglob("*.hpp"), *(ROOT / "include").rglob("*.hpp")]
    counts = Counter(header for path in headers for header in set(INCLUDE.findall(path.read_text(encoding="utf-8"))))
    return sorted(h for h, n in counts.items() if h[0] == "<" and n >= OTHERS_SHARED_BY)


def compile_alone(commands: dict[Path, list[str]], jobs: int) -> list[str]:
    """Messages of the compiler."""
    with tempfile.TemporaryDirectory() as folder, ThreadPoolExecutor(jobs) as pool:
        groups = defaultdict(list)
        for source, command in commands.items():
            groups[tuple(command)].append(source)
        alone = []
        for number, (command, sources) in enumerate(groups.items()):
            others = Path(folder) / f"others{number}.hpp"
            others.write_text("".join(f"#include {header}\n" for header in shared_headers(list(commands))))
            compiler = [word for word in command if word != "-Werror"]
            subprocess.run([*compiler, "-x", "c++-header", str(others), "-o", f"{others}.gch"], check=True)
            others.write_text("#error the compiled header does not fit\n")
            alone += [[*command, "-fsyntax-only", "-include", str(others), str(source)] for source in sources]
        results = pool.map(lambda words: subprocess.run(words, capture_output=True, text=True, check=False), alone)
        return [result.stderr for result in results if result.returncode]


def main() -> int:
    build, jobs = Path(sys.argv[1]), int(sys.argv[2]) if len(sys.argv) > 2 else 1
    entries = json.loads((build / "compile_commands.json").read_text(encoding="utf-8"))
    checked = (ROOT / "src", ROOT / "apps")
    commands = {
        Path(entry["file"]): syntax_only(entry)
        for entry in entries
        if any(Path(entry["file"]).is_relative_to(folder) for folder in checked)
    }
    if "--only" in sys.argv:
        wanted = {ROOT / source for source in sys.argv[sys.argv.index("--only") + 1 :]}
        unknown = sorted(str(source) for source in wanted - commands.keys() if not source.is_relative_to(WITH_MPI))
        if unknown:
            sys.exit(f"files: not in {build}: {' '.join(unknown)}")
        wanted &= commands.keys()
    else:
        wanted = set(commands)
    texts = [path for folder in (*checked, ROOT / "include") for path in sorted(folder.rglob("*.[ch]pp"))]
    found = [message for path in texts for message in untidy(path)] + compile_alone(
        {source: command for source, command in commands.items() if source in wanted}, jobs
    )
    for message in found:
        print(message)
    compiled = f"{len(wanted)} of {len(commands)} sources compiled alone"
    print(f"files: {compiled}, {len(texts)} files read, {len(found)} findings")
    return 1 if found or not commands else 0


if __name__ == "__main__":
    sys.exit(main())
