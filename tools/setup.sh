#!/bin/bash
# Installs what is missing to build, test and plot on Debian 12.
# Usage: tools/setup.sh packages|python|extras|test|mpi|cuda|tidy|ccache|arm64|count|list
# Safe to repeat: packages that are there are left alone, and without missing ones no network is used.
set -euo pipefail
cd "$(dirname "$0")/.."

# What compiles the engine; README.md, docs/install.md and Dockerfile name the same ones.
engine_packages=(build-essential cmake ninja-build pkg-config python3-dev python3-venv
  libeigen3-dev libtomlplusplus-dev libcli11-dev libfmt-dev libhdf5-dev zlib1g-dev libxxhash-dev nlohmann-json3-dev)
build_packages=("${engine_packages[@]}" git clang-format libgtest-dev libbenchmark-dev)
test_packages=(chromium chromium-driver) # the HTML report and the page of `brinell app` are looked at in a browser
mpi_packages=(libopenmpi-dev openmpi-bin) # several processes for one case
# The compiler of CUDA 13 is whole in wheels, unlike that of 12.
cuda_wheels=('nvidia-cuda-nvcc>=13.0,<14' 'nvidia-cuda-crt>=13.0,<14' 'nvidia-nvvm>=13.0,<14'
  'nvidia-cuda-runtime>=13.0,<14' 'nvidia-cuda-cccl>=13.0,<14' 'nvidia-cufft>=12.0,<13')
tidy_packages=(clang-tidy clang-tools libomp-dev)

fail() { echo "setup: $*" >&2; exit 1; }

# Python compiles the modules that are used when they are first imported: half of pip's time would go into all others.
pip=(.venv/bin/pip install --no-compile --quiet --disable-pip-version-check)
mirror="It needs the Python package index or a mirror set in pip's own configuration; then say 'make setup' again."

is_installed() { [[ "$(dpkg-query -W -f='${db:Status-Status}' "$1" 2>/dev/null)" == installed ]]; }

install_packages() {
  command -v dpkg-query >/dev/null || fail "this is not Debian or a relative; install by hand the equivalents of: $*"
  local missing=() as_root=() package
  for package in "$@"; do is_installed "$package" || missing+=("$package"); done
  (( ${#missing[@]} )) || return 0
  if (( EUID != 0 )); then
    command -v sudo >/dev/null || fail "run this as root or install sudo; missing packages: ${missing[*]}"
    as_root=(sudo)
  fi
  echo "setup: installing ${missing[*]}"
  "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get update -qq
  "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install -qq --no-install-recommends "${missing[@]}" >/dev/null
}

# The virtual environment .venv with the Python package: its Python files are used where they are. The extension is built in
# build/release, of the same objects as the program and the tests, which are configured here, too, so that nothing changes when
# they are built.
make_venv() {
  local python=/usr/bin/python3
  [[ -x $python ]] || python=$(command -v python3) || fail "no python3"
  [[ -x .venv/bin/pip ]] || "$python" -m venv --clear .venv || fail "cannot make .venv with $python"
  "${pip[@]}" 'scikit-build-core>=0.11' 'nanobind>=2.7' || fail "pip could not install the build tools. $mirror"
  echo "setup: compiling the engine and its Python package into .venv, which takes some minutes the first time"
  mkdir -p build
  local log=build/setup-python.log
  .venv/bin/pip install --no-compile --verbose --disable-pip-version-check --no-build-isolation --config-settings=editable.mode=redirect \
    --config-settings=build-dir=build/release --config-settings=build.targets=brinell_core \
    --config-settings=cmake.define.BRINELL_TESTS=ON --config-settings=cmake.define.BRINELL_BENCHMARKS=ON -e . 2>&1 |
    tee "$log" | show_progress || fail "the package could not be compiled or installed into .venv; the end of $log:
$(tail -n 40 "$log")"
}

# What tests and static checks need beside the package.
add_extras() {
  "${pip[@]}" 'brinell[test,lint]' || fail "pip could not install what the tests need. $mirror"
}

# Python's way to MPI, of which the package itself needs nothing.
add_mpi4py() {
  "${pip[@]}" 'brinell[mpi]' || fail "pip could not install mpi4py. $mirror"
}

# A compiler for CUDA with its libraries, as wheels: 300 MB to fetch, 580 MB unpacked. No GPU is needed to compile. What lies in
# build/cuda/nvidia/cu13 is laid out as an installed CUDA. cmake/cuda.cmake finds it there.
add_cuda() {
  local root=build/cuda/nvidia/cu13 python=/usr/bin/python3
  [[ -x $root/bin/nvcc && -e $root/lib/libcufft.so ]] && return 0
  [[ $(uname -m) == x86_64 ]] || fail "the wheels of CUDA are fetched for x86-64 only; install CUDA 13 and set CUDACXX to its nvcc"
  [[ -x $python ]] || python=$(command -v python3) || fail "no python3"
  [[ -x .venv/bin/pip ]] || "$python" -m venv --clear .venv || fail "cannot make .venv with $python"
  rm -rf build/cuda
  mkdir -p build/cuda
  "${pip[@]}" --no-deps --target build/cuda "${cuda_wheels[@]}" || fail "pip could not fetch CUDA. ${mirror/make setup/tools\/setup.sh cuda}"
  chmod +x $root/bin/* $root/nvvm/bin/*
  ln -s libcufft.so.12 $root/lib/libcufft.so # the linker looks for this name
}

# Of what ninja says the files done so far, in one line; nothing where nobody looks.
show_progress() {
  if [[ ! -t 1 ]]; then cat >/dev/null; return; fi
  stdbuf -oL grep -oE '\[[0-9]+/[0-9]+\]' | while read -r done; do printf '\rsetup: %s ' "$done"; done || true
  printf '\r%20s\r' ''
}

case "${1:-}" in
  packages) install_packages "${build_packages[@]}" ;;
  python) make_venv ;;
  extras) add_extras ;;
  test) install_packages "${test_packages[@]}" ;;
  mpi) install_packages "${mpi_packages[@]}"; add_mpi4py ;;
  cuda) add_cuda ;;
  tidy) install_packages "${tidy_packages[@]}" ;;
  ccache) install_packages ccache ;;
  arm64) install_packages g++-aarch64-linux-gnu qemu-user ;;
  count) install_packages valgrind binutils ;;
  list) echo "${engine_packages[*]}" ;;
  *) fail "usage: tools/setup.sh packages|python|extras|test|mpi|cuda|tidy|ccache|arm64|count|list" ;;
esac
