// SPDX-License-Identifier: BSD-3-Clause
#include "indent.hpp"

#include "brinell/foundation/error.hpp"
#include "foundation/nan.hpp"
#include "simulation/stepping/records.hpp"

#include <algorithm>
#include <cmath>

namespace brinell::simulation
{

namespace
{

/// Loads that differ by less than this share of the largest one are the same load.
constexpr double same_load = 1e-9;

} // namespace

IndentReader::IndentReader(double x, int place, double touch) : approach_(1, touch), load_(1, 0.0), first_touch_(touch)
{
  indent_.x = x;
  indent_.place = place;
  indent_.cycle = 1;
  indent_.final_approach = nan;
}

IndentReader IndentReader::next_cycle(double touch) const
{
  IndentReader next(indent_.x, indent_.place, touch);
  next.indent_.cycle = indent_.cycle + 1;
  next.first_touch_ = first_touch_;
  next.former_load_ = std::max(former_load_, indent_.max_load);
  return next;
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
  // Of several largest loads the last one; without a load, the largest approach.
  const bool is_peak = closed ? r.F_n >= (1.0 - same_load) * indent_.max_load
                              : indent_.max_load == 0.0 && (load_.size() == 2 || r.approach > indent_.max_approach);
  if (is_peak)
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

/// Points in this direction from the peak, as long as their loads decrease, down to zero; of equal loads, the first one.
std::vector<int> IndentReader::descend(int direction) const
{
  std::vector<int> points;
  double last = indent_.max_load;
  for (int i = peak_ + direction; i >= 0 && i < static_cast<int>(load_.size()) && last > 0.0; i += direction)
  {
    const double load = load_[static_cast<std::size_t>(i)];
    if (load > last + same_load * indent_.max_load)
      break;
    if (load < last - same_load * indent_.max_load)
    {
      points.push_back(i);
      last = load;
    }
  }
  return points;
}

IndentReader::Branch IndentReader::loading() const
{
  Branch branch{descend(-1), first_touch_, 0.0};
  if (branch.points.empty())
    return branch;
  // A contact that was loaded before is elastic up to its former load.
  const auto start = static_cast<std::size_t>(branch.points.back());
  const double former =
      std::max(former_load_, *std::max_element(load_.begin(), load_.begin() + static_cast<std::ptrdiff_t>(start) + 1));
  if (former < (1.0 - same_load) * indent_.max_load)
    branch.lowest = former;
  else
    branch.origin = load_[start] > 0.0 ? nan : approach_[start];
  return branch;
}

IndentReader::Branch IndentReader::unloading() const
{
  Branch branch{descend(1), nan, 0.0};
  if (!branch.points.empty() && !(load_[static_cast<std::size_t>(branch.points.back())] > 0.0))
    branch.origin = approach_[static_cast<std::size_t>(branch.points.back())];
  return branch;
}

/// dF/d approach at the largest load; NaN if the branch has no other point under load.
double IndentReader::slope_at_peak(const Branch& branch) const
{
  if (branch.points.empty() || !(load_[static_cast<std::size_t>(branch.points.front())] > 0.0))
    return nan;
  const bool is_periodic = !std::isnan(indent_.mean_gap);
  return is_periodic || std::isnan(branch.origin) ? slope_of_parabola(branch) : slope_of_power_law(branch);
}

/// Of the power law through the peak, whose exponent is fitted to the points above half of the largest load: cells that
/// join or leave the contact make the load of single steps uneven.
double IndentReader::slope_of_power_law(const Branch& branch) const
{
  const double top = indent_.max_load, depth = approach_[static_cast<std::size_t>(peak_)] - branch.origin;
  double xx = 0.0, xy = 0.0;
  for (const int i : branch.points)
  {
    const double load = load_[static_cast<std::size_t>(i)];
    const bool is_nearest = i == branch.points.front();
    if (!is_nearest && load < (1.0 - same_load) * std::max(0.5 * top, branch.lowest))
      break;
    const double share = (approach_[static_cast<std::size_t>(i)] - branch.origin) / depth;
    if (!(share > 0.0)) // such a point, and with it the law, has another origin
      return slope_of_parabola(branch);
    const double x = std::log(share);
    xx += x * x;
    xy += x * std::log(load / top);
  }
  return xy / xx * top / depth;
}

/// Of the parabola through the peak and the two nearest points, of the line if there is only one.
double IndentReader::slope_of_parabola(const Branch& branch) const
{
  const auto at = [&](int i) { return approach_[static_cast<std::size_t>(i)]; };
  const auto secant = [&](int i, int j)
  { return (load_[static_cast<std::size_t>(i)] - load_[static_cast<std::size_t>(j)]) / (at(i) - at(j)); };
  const int one = branch.points.front();
  const double near = secant(peak_, one);
  if (branch.points.size() < 2 || !(load_[static_cast<std::size_t>(branch.points[1])] > 0.0))
    return near;
  const int two = branch.points[1];
  return near + (near - secant(one, two)) / (at(peak_) - at(two)) * (at(peak_) - at(one));
}

Indent IndentReader::result() const
{
  Indent indent = indent_;
  indent.loading_stiffness = slope_at_peak(loading());
  indent.unloading_stiffness = slope_at_peak(unloading());
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
  archive("first_touch", first_touch_);
  archive("former_load", former_load_);
}

void Indent::exchange(Archive& archive)
{
  exchange_columns(*this, archive);
}

} // namespace brinell::simulation
