#!/bin/bash
# Applies docs/developer/wear-law.patch to a copy of the sources, compiles the sources and tests that it touches, without making
# code, computes the law that it adds and looks for its column. CTest calls it: wear_law.sh SOURCE C++-COMPILER FOLDER-OF-HEADERS...
set -euo pipefail
source=$1 compiler=$2
shift 2
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cp -r "$source/include" "$source/src" "$work"
mkdir -p "$work/docs" "$work/tests"
cp -r "$source/docs/reference" "$work/docs"
cp -r "$source/tests/unit" "$source/tests/support" "$work/tests"
cd "$work"
patch --strip=0 --forward --no-backup-if-mismatch <"$source/docs/developer/wear-law.patch"

flags=(-std=c++20 -fopenmp -Wall -Wextra -Werror -I include -I src -I tests/support)
for folder in "$@"; do
  flags+=(-idirafter "$folder") # not -isystem, which breaks the order of the compiler if it is one of its own
done
touched=$(sed -n 's/^+++ \([^ ]*\).*/\1/p' "$source/docs/developer/wear-law.patch")
for file in $(grep '\.cpp$' <<<"$touched"); do
  "$compiler" "${flags[@]}" -fsyntax-only "$file"
done

cat >law.cpp <<'END'
#include "brinell/simulation/scenarios.hpp"
#include <algorithm>
using namespace brinell::simulation;
template <typename Record>
bool has_column()
{
  const auto& all = columns<Record>;
  return std::any_of(all.begin(), all.end(), [](const auto& column) { return column.name == "worn_share"; });
}
double brinell::elastoplastic::UserWear::intensity_at(double, double) const { return -1.0; } // not used
int main()
{
  using brinell::elastoplastic::WearLaw;
  const WearLaw law{.lower = 1e-15, .kind = WearLaw::Kind::threshold, .threshold = 1e9};
  const bool is_right = law.intensity(3e9, 0.0) == 2e9 && law.intensity(0.5e9, 0.0) == 0.0;
  const bool is_told = has_column<TuggingRecord>() && has_column<RollingRecord>() && has_column<SlidingRecord>() &&
                       has_column<FrettingRecord>();
  return is_right && is_told ? 0 : 1;
}
END
"$compiler" "${flags[@]}" law.cpp -o law
./law
echo "wear-law.patch: $(wc -w <<<"$touched") files"
