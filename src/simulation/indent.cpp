// SPDX-License-Identifier: BSD-3-Clause
#include "indent.hpp"

#include "brinell/foundation/error.hpp"
#include "records.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace brinell::simulation
{

namespace
{

/// Loads that differ by less than this share of the largest one are the same load.
constexpr double same_load = 1e-9;

} // namespace

IndentReader::IndentReader(double x, int place, int cycle, double touch) : approach_(1, touch), load_(1, 0.0)
{
  indent_.x = x;
  indent_.place = place;
  indent_.cycle = cycle;
  indent_.final_approach = std::numeric_limits<double>::quiet_NaN();
}

double IndentReader::add(const IndentationRecord& r, double opening)
{
  // Without load the curve stays at the approach where the surfaces touch, so that no work is counted.
  const bool was_closed = load_.back() > 0.0;
  const bool closed = r.F_n > 0.0;
  const double approach = closed ? r.approach : opening;
  const double work = 0.5 * (r.F_n + load_.back()) * (approach - approach_.back());
  approach_.push_back(approach);
  load_.push_back(r.F_n);
  if (closed && r.F_n >= (1.0 - same_load) * indent_.max_load) // of several, the last one
  {
    peak_ = static_cast<int>(load_.size()) - 1;
    indent_.max_load = std::max(indent_.max_load, r.F_n);
    indent_.max_approach = r.approach;
    indent_.contact_area = r.contact_area;
    indent_.contact_fraction = r.contact_fraction;
    indent_.mean_gap = r.mean_gap;
    indent_.contact_stiffness = r.contact_stiffness;
    indent_.hardness = r.mean_pressure;
  }
  if (!closed && was_closed)
  {
    indent_.final_approach = opening;
    indent_.residual_depth = r.residual_depth;
    indent_.pile_up = r.pile_up;
  }
  indent_.work += work;
  return work;
}

/// The next point under another load; -1 if there is none, or none under load.
int IndentReader::neighbour(int point, int direction) const
{
  const double here = load_[static_cast<std::size_t>(point)];
  for (int i = point + direction; i >= 0 && i < static_cast<int>(load_.size()); i += direction)
  {
    const double there = load_[static_cast<std::size_t>(i)];
    if (std::abs(there - here) > same_load * indent_.max_load)
      return there > 0.0 ? i : -1;
  }
  return -1;
}

/// dF/d approach at the largest load, of the parabola through it and the two points before or after it.
double IndentReader::slope_at_peak(int direction) const
{
  const int one = neighbour(peak_, direction);
  if (one < 0)
    return 0.0;
  const auto at = [&](int i) { return approach_[static_cast<std::size_t>(i)]; };
  const auto secant = [&](int i, int j)
  { return (load_[static_cast<std::size_t>(i)] - load_[static_cast<std::size_t>(j)]) / (at(i) - at(j)); };
  const double near = secant(peak_, one);
  const int two = neighbour(one, direction);
  return two < 0 ? near : near + (near - secant(one, two)) / (at(peak_) - at(two)) * (at(peak_) - at(one));
}

Indent IndentReader::result() const
{
  Indent indent = indent_;
  indent.loading_stiffness = slope_at_peak(-1);
  indent.unloading_stiffness = slope_at_peak(1);
  return indent;
}

void IndentReader::exchange(Archive& archive)
{
  archive("indent", indent_);
  archive.list("approach", approach_);
  archive.list("load", load_);
  if (archive.gives() && (load_.empty() || load_.size() != approach_.size()))
    throw InputError("the stored state has a load-depth curve without points, or of as many loads as approaches");
  archive("peak", peak_, 0, static_cast<int>(load_.size()) - 1);
}

void Indent::exchange(Archive& archive)
{
  exchange_columns(*this, archive);
}

} // namespace brinell::simulation
