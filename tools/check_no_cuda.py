#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Fails on a library or program with a symbol of CUDA: only brinell_cuda may have them, so that the engine runs everywhere.

Usage: tools/check_no_cuda.py NM FILE...
"""

import re
import subprocess
import sys

OF_CUDA = re.compile(r"\b_{0,2}(cuda[A-Z]\w*|cufft\w*|cu[A-Z]\w*|fatbin\w*)")


def main() -> int:
    nm, *files = sys.argv[1:]
    found = []
    for file in files:
        symbols = subprocess.run([nm, file], capture_output=True, text=True, check=True).stdout.split("\n")
        names = [line.split()[-1] for line in symbols if line.strip() and not line.endswith(":")]
        if not names:
            found.append(f"{file}: no symbols at all")
        found += [f"{file}: {name}" for name in sorted(set(names)) if OF_CUDA.match(name)]
    for message in found:
        print(message)
    print(f"symbols of CUDA: {len(found)} in {len(files)} files")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
