// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/contact/tangential_contact.hpp"

#include <vector>

namespace brinell::contact
{

using Field = std::vector<double>;

/// Shears or displacements along both axes.
struct Fields
{
  Field x, y;
  explicit Fields(std::size_t cells) : x(cells), y(cells) {}
  [[nodiscard]] AlongSurface out() { return {x, y}; }
  [[nodiscard]] ConstAlongSurface in() const { return {x, y}; }
};

inline double total(const Field& f, double area)
{
  double sum = 0.0;
  for (const double value : f)
    sum += value * area;
  return sum;
}

} // namespace brinell::contact
