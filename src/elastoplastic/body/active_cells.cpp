// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/elastoplastic/active_cells.hpp"

#include <algorithm>
#include <utility>

namespace brinell::elastoplastic
{

void ActiveCells::clear()
{
  for (const std::size_t cell : cells_)
    is_active_[cell] = 0;
  cells_.clear();
  q_.clear();
  g_.clear();
  start_.clear();
  flow_.clear();
  equivalent_.clear();
  dissipation_.clear();
  copies_.clear();
  backstress_.clear();
}

void ActiveCells::add(std::size_t cell, const Deviator& q, const Deviator& start, int copies)
{
  is_active_[cell] = 1;
  cells_.push_back(cell);
  q_.insert(q_.end(), q.v.begin(), q.v.end());
  g_.insert(g_.end(), q.v.begin(), q.v.end());
  start_.insert(start_.end(), start.v.begin(), start.v.end());
  flow_.resize(flow_.size() + Deviator::size, 0.0);
  equivalent_.push_back(0.0);
  dissipation_.push_back(0.0);
  copies_.push_back(copies);
  backstress_.resize(backstress_.size() + terms_);
}

void ActiveCells::assign(std::vector<std::size_t> cells, const SurfaceGrid& grid)
{
  clear();
  cells_ = std::move(cells);
  for (std::vector<double>* deviators : {&q_, &g_, &start_, &flow_})
    deviators->resize(Deviator::size * cells_.size());
  equivalent_.resize(cells_.size());
  dissipation_.resize(cells_.size());
  backstress_.resize(terms_ * cells_.size());
  copies_.reserve(cells_.size());
  for (const std::size_t cell : cells_)
  {
    is_active_[cell] = 1;
    copies_.push_back(grid.copies_of_row(static_cast<int>(cell % grid.size()) / grid.nx));
  }
}

void ActiveCells::assign_backstresses(std::span<const double> packed)
{
  for (std::size_t n = 0; n < packed.size(); ++n)
    backstress_[n / Deviator::size].v[n % Deviator::size] = packed[n];
}

std::size_t ActiveCells::deepest() const
{
  return *std::max_element(cells_.begin(), cells_.end());
}

void ActiveCells::set_flow(std::size_t a, const constitutive::PlasticIncrement& increment)
{
  equivalent_[a] = increment.equivalent;
  dissipation_[a] = increment.dissipation;
  const Deviator& d = increment.strain;
  Deviator factors = 2.0 * d;
  factors[Deviator::xx] += d[Deviator::yy]; // from the product of the zz components, zz = -(xx + yy)
  factors[Deviator::yy] += d[Deviator::xx];
  set(flow_, a, copies_[a] * factors);
}

} // namespace brinell::elastoplastic
