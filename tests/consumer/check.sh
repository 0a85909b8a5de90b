#!/bin/bash
# Installs a build tree into a folder of its own and builds the consumer from there: by find_package, and by pkg-config; both
# programs run, and every installed header is compiled alone. CTest calls it: check.sh SOURCE BUILD CONFIGURATION C++-COMPILER GENERATOR.
set -euo pipefail
source=$1 build=$2 configuration=$3 compiler=$4 generator=$5
unset DESTDIR
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
# Moved after it was installed, and away from the sources: no path of either may have stayed in the files.
cmake --install "$build" --config "$configuration" --prefix "$work/first" >"$work/install.log"
prefix=$work/prefix
mv "$work/first" "$prefix"
if grep -rlF -e "$source" -e "$build" -e "$work/first" "$prefix" --include='*.cmake' --include='*.pc' --include='*.hpp'; then
  echo "these installed files name folders of the build" >&2
  exit 1
fi
[[ $("$prefix/bin/brinell" --version) == brinell* ]]

echo "--- find_package"
cmake -S "$source/tests/consumer" -B "$work/consumer" -G "$generator" -D CMAKE_BUILD_TYPE="$configuration" \
  -D CMAKE_CXX_COMPILER="$compiler" -D CMAKE_PREFIX_PATH="$prefix" >"$work/configure.log" || { cat "$work/configure.log"; exit 1; }
cmake --build "$work/consumer" --parallel 2 --target press headers >"$work/build.log" || { cat "$work/build.log"; exit 1; }
"$work/consumer/press"

echo "--- pkg-config"
PKG_CONFIG_PATH=$(dirname "$(find "$prefix" -name brinell.pc)")
export PKG_CONFIG_PATH
"$compiler" -std=c++20 -Wall -Wextra -Wpedantic -Werror "$source/tests/consumer/press.cpp" \
  $(pkg-config --static --cflags --libs brinell) -o "$work/press"
"$work/press"
