// SPDX-License-Identifier: BSD-3-Clause
#include "indent.hpp"

#include <limits>

namespace brinell::simulation
{

IndentReader::IndentReader(double x, int place, int cycle, double work)
{
  indent_.x = x;
  indent_.place = place;
  indent_.cycle = cycle;
  indent_.work = -work;
  indent_.final_approach = std::numeric_limits<double>::quiet_NaN();
}

void IndentReader::start(double approach, double load)
{
  approach_.assign(1, approach);
  load_.assign(1, load);
}

double IndentReader::add(const IndentationRecord& r, double opening)
{
  // Without load the curve stays where the surfaces touch: nothing is worked on the way there.
  const bool was_closed = load_.back() > 0.0;
  const bool closed = r.F_n > 0.0;
  const double approach = closed ? r.approach : opening;
  const double work = 0.5 * (r.F_n + load_.back()) * (approach - approach_.back());
  approach_.push_back(approach);
  load_.push_back(r.F_n);
  if (r.F_n > indent_.max_load)
  {
    peak_ = static_cast<int>(load_.size()) - 1;
    indent_.max_load = r.F_n;
    indent_.max_approach = r.approach;
    indent_.contact_area = r.contact_area;
    indent_.hardness = r.mean_pressure;
  }
  if (!closed && was_closed)
  {
    indent_.final_approach = opening;
    indent_.residual_depth = r.max_residual_lower;
    indent_.pile_up = r.pile_up_lower;
  }
  indent_.work += work;
  return work;
}

/// dF/d approach at the largest load, of the parabola through it and the two points before or after it.
double IndentReader::slope_at_peak(int direction) const
{
  const auto inside = [&](int i) { return i >= 0 && i < static_cast<int>(load_.size()); };
  const int one = peak_ + direction;
  const int two = one + direction;
  if (!inside(one) || load_[static_cast<std::size_t>(one)] <= 0.0)
    return 0.0;
  const auto secant = [&](int a, int b)
  {
    const auto i = static_cast<std::size_t>(a);
    const auto j = static_cast<std::size_t>(b);
    return (load_[i] - load_[j]) / (approach_[i] - approach_[j]);
  };
  const double near = secant(peak_, one);
  if (!inside(two) || load_[static_cast<std::size_t>(two)] <= 0.0)
    return near;
  const double far = secant(one, two);
  const auto at = [&](int i) { return approach_[static_cast<std::size_t>(i)]; };
  return near + (near - far) / (at(peak_) - at(two)) * (at(peak_) - at(one));
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
  archive("peak", peak_);
}

} // namespace brinell::simulation
