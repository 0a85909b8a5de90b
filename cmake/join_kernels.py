#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Puts several compilations of the same sources, for several kinds of processor, into one library.

Usage: join_kernels.py --to FOLDER --nm NM --ld LD --objcopy OBJCOPY --compiler CXX --kind NAME OBJECT... [--kind NAME OBJECT...]...

The objects of each kind become one, in which all names are local but those of the functions that others call; these get the
ending ".NAME". Nothing of one kind can then be taken for another, in particular no inline function of the standard library that
was compiled for a newer processor. A function's own name is a jump by way of the table of addresses in use, which
src/foundation/processor.cpp chooses when the program is loaded. Written: FOLDER/kernels_NAME.o and FOLDER/kernels_jumps.o.
"""

import argparse
import subprocess
import sys
from pathlib import Path


def run(*command: object) -> str:
    return subprocess.run([str(word) for word in command], check=True, stdout=subprocess.PIPE, text=True).stdout


def defined(nm: str, file: Path) -> dict[str, str]:
    """Kinds (letters of nm) of the global symbols that an object defines."""
    lines = run(nm, "--defined-only", "--extern-only", "--format=posix", file).splitlines()
    return {fields[0]: fields[1] for fields in (line.split() for line in lines)}


def joined(arguments: argparse.Namespace, name: str, objects: list[str]) -> Path:
    """One object in which functions that several files contain exist once, and can no longer be replaced by others."""
    whole = arguments.to / f"whole_{name}.o"
    run(arguments.ld, "-r", "--force-group-allocation", "-o", whole, *objects)
    return whole


def rename(arguments: argparse.Namespace, name: str, whole: Path, functions: list[str]) -> None:
    names, kept = arguments.to / f"names_{name}.txt", arguments.to / f"kept_{name}.txt"
    names.write_text("".join(f"{function} {function}.{name}\n" for function in functions))
    kept.write_text("".join(f"{function}.{name}\n" for function in functions))
    renamed = arguments.to / f"renamed_{name}.o"
    run(arguments.objcopy, f"--redefine-syms={names}", whole, renamed)
    run(arguments.objcopy, f"--keep-global-symbols={kept}", renamed, arguments.to / f"kernels_{name}.o")
    for file in (names, kept, renamed, whole):
        file.unlink()


def jumps(functions: list[str], kinds: list[str]) -> str:
    """Assembler: the jumps, and a table of addresses for each kind. r11 is free at a call (System V ABI)."""
    lines = [".hidden brinell_functions", ".text"]
    for number, function in enumerate(functions):
        lines += [f".globl {function}", f".type {function}, @function", ".p2align 4", f"{function}:"]
        lines += ["movq brinell_functions(%rip), %r11", f"jmp *{8 * number}(%r11)", f".size {function}, . - {function}"]
    lines += ['.section .data.rel.ro, "aw"', ".p2align 3"]
    for kind in kinds:
        table = f"brinell_functions_{kind}"
        lines += [f".globl {table}", f".hidden {table}", f"{table}:"]
        lines += [f".quad {function}.{kind}" for function in functions]
    return "\n".join([*lines, '.section .note.GNU-stack, "", @progbits', ""])


def main() -> None:
    parser = argparse.ArgumentParser()
    parser.add_argument("--to", type=Path, required=True)
    for tool in ("nm", "ld", "objcopy", "compiler"):
        parser.add_argument(f"--{tool}", required=True)
    parser.add_argument("--kind", nargs="+", action="append", required=True)
    arguments = parser.parse_args()
    arguments.to.mkdir(parents=True, exist_ok=True)
    wholes = {kind[0]: joined(arguments, kind[0], kind[1:]) for kind in arguments.kind}
    symbols = [defined(arguments.nm, whole) for whole in wholes.values()]
    # Strong functions. Those that take or return vectors of the processor have other names for each kind, and no caller outside.
    functions = sorted(name for name, letter in symbols[0].items() if letter == "T" and all(name in s for s in symbols))
    data = sorted(name for name, letter in symbols[0].items() if letter in "DBRC")
    if data:  # each kind would have its own
        sys.exit(f"join_kernels: these variables must not be global: {', '.join(data)}")
    for name, whole in wholes.items():
        rename(arguments, name, whole, functions)
    assembler = arguments.to / "kernels_jumps.s"
    assembler.write_text(jumps(functions, list(wholes)))
    run(arguments.compiler, "-c", assembler, "-o", arguments.to / "kernels_jumps.o")


if __name__ == "__main__":
    main()
