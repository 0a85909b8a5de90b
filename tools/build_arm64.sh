#!/bin/bash
# Compiles the program for 64-bit Arm with Debian's cross compiler, build/arm64/bin/brinell, runs a case with it under qemu and compares
# the peak force with that of the program in build/release.
# The libraries come from Debian's packages for arm64, unpacked in build/arm64-root, because some of them cannot be installed beside
# those of this machine.
set -euo pipefail
cd "$(dirname "$0")/.."
tools/setup.sh arm64
root=$PWD/build/arm64-root build=build/arm64

if [[ ! -e $root/.complete ]]; then
  dpkg --print-foreign-architectures | grep -qx arm64 || { dpkg --add-architecture arm64; apt-get update -qq; }
  rm -rf "$root" && mkdir -p "$root/packages"
  mapfile -t packages < <(apt-cache depends --recurse --no-recommends --no-suggests --no-conflicts --no-breaks --no-replaces \
    --no-enhances libhdf5-dev:arm64 libfmt-dev:arm64 libtomlplusplus-dev:arm64 zlib1g-dev:arm64 libxxhash-dev:arm64 \
    libstdc++6:arm64 libgomp1:arm64 | grep -E '^[a-z0-9][^ ]*:arm64$' | sort -u)
  (cd "$root/packages" && apt-get download -qq "${packages[@]}")
  for package in "$root"/packages/*.deb; do dpkg-deb -x "$package" "$root"; done
  rm -rf "$root/packages"
  touch "$root/.complete"
fi

lib=$root/usr/lib/aarch64-linux-gnu
include=$root/usr/include
cmake -S . -B $build -G Ninja -D CMAKE_SYSTEM_NAME=Linux -D CMAKE_SYSTEM_PROCESSOR=aarch64 -D CMAKE_BUILD_TYPE=Release \
  -D CMAKE_C_COMPILER=aarch64-linux-gnu-gcc -D CMAKE_CXX_COMPILER=aarch64-linux-gnu-g++ \
  -D CMAKE_UNITY_BUILD=ON -D CMAKE_UNITY_BUILD_BATCH_SIZE=16 \
  -D CMAKE_FIND_ROOT_PATH="$root" -D CMAKE_PREFIX_PATH="$root/usr;$lib" -D CMAKE_FIND_ROOT_PATH_MODE_PROGRAM=NEVER \
  -D CMAKE_LIBRARY_ARCHITECTURE=aarch64-linux-gnu \
  -D HDF5_C_COMPILER_EXECUTABLE=HDF5_C_COMPILER_EXECUTABLE-NOTFOUND -D HDF5_C_INCLUDE_DIR="$include/hdf5/serial" \
  -D HDF5_hdf5_LIBRARY_RELEASE="$lib/libhdf5_serial.so" -D HDF5_hdf5_LIBRARY_DEBUG="$lib/libhdf5_serial.so" \
  -D CMAKE_EXE_LINKER_FLAGS="-Wl,-rpath-link,$lib -Wl,-rpath-link,$root/lib/aarch64-linux-gnu" >/dev/null
cmake --build $build --parallel "$(nproc)" --target brinell_program

on_arm=(qemu-aarch64 -L "$root" $build/bin/brinell)
"${on_arm[@]}" --version
OMP_WAIT_POLICY=passive "${on_arm[@]}" run cases/tugging/case.toml --set grid.resolution=4 --quiet -o $build/arm
build/release/bin/brinell run cases/tugging/case.toml --set grid.resolution=4 --quiet -o $build/here
python3 - $build/arm/summary.json $build/here/summary.json <<'PYTHON'
import json, math, sys
summaries = [json.load(open(file)) for file in sys.argv[1:]]
forces = [summary["forces"]["peak_F_X_N"] for summary in summaries]
print("peak force on Arm, here:", *forces)
sys.exit(not math.isclose(*forces, rel_tol=1e-9))
PYTHON
