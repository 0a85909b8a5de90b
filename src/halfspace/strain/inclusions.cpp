// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/halfspace/inclusions.hpp"

#include "inclusion_cells.hpp"
#include "inclusion_fields.hpp"
#include "inclusion_matrix.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace brinell::halfspace
{

namespace
{

/// A box of this share of the columns and rows of the grid, or a larger one, is no saving.
constexpr double largest_box = 0.5;
/// Of the solution in the box: its stress is that of the whole body to some percent, so that a closer solution gains nothing.
constexpr double closest = 0.01;
/// Corrections by the box, after which the body itself is to solve the rest.
constexpr int most_corrections = 6;
/// Part of the tolerance that a solution aims at, and part of the rest that is left at most.
constexpr double margin = 0.3, least = 0.1;

/// The columns, rows and layers around the inclusions as a body of its own.
struct Box
{
  HalfSpace body;
  InclusionCells cells;
  InclusionFields fields;

  Box(const HalfSpace& whole, InclusionCells own)
      : body(own.grid, whole.elastic(), whole.grid().surface), cells(std::move(own)), fields(body)
  {
  }
};

} // namespace

struct Inclusions::Parts
{
  const HalfSpace& body;
  InclusionCells cells;
  InclusionFields fields;
  bool is_prepared = false; ///< for corrections
  std::optional<InclusionMatrix> matrix;
  std::unique_ptr<Box> box; ///< nullptr: none

  Parts(const HalfSpace& of, const std::vector<Inclusion>& inclusions)
      : body(of), cells(of.grid(), of.elastic(), inclusions), fields(of)
  {
  }
  void prepare();
  [[nodiscard]] std::vector<double> rest(const std::vector<double>& right, const Solution& solution) const;
  Report correct(std::span<const double> rest, double tolerance, int most_iterations, bool in_box,
                 InclusionField& change);
};

/// Plans what corrections take: without them it is not needed.
void Inclusions::Parts::prepare()
{
  if (std::exchange(is_prepared, true))
    return;
  const SurfaceGrid& s = body.grid().surface;
  const CellBox around = cells.box();
  if (InclusionMatrix::is_possible(cells) && !s.is_mirrored_y)
    matrix.emplace(fields, cells);
  else if (InclusionMatrix::is_possible(cells))
  {
    const HalfSpace both_sides({s.whole(), cells.layers, body.grid().dz}, body.elastic());
    InclusionFields of_both(both_sides);
    matrix.emplace(of_both, cells);
  }
  else if (static_cast<double>(around.nx) * around.ny <= largest_box * static_cast<double>(s.size()))
    box = std::make_unique<Box>(body, cells.on(around));
}

Inclusions::Inclusions(const HalfSpace& body, const std::vector<Inclusion>& inclusions)
    : parts_(std::make_unique<Parts>(body, inclusions))
{
}
Inclusions::~Inclusions() = default;
Inclusions::Inclusions(Inclusions&&) noexcept = default;
Inclusions& Inclusions::operator=(Inclusions&&) noexcept = default;

const std::vector<std::size_t>& Inclusions::cells() const
{
  return parts_->cells.cells;
}

int Inclusions::layers() const
{
  return parts_->cells.layers;
}

InclusionField Inclusions::make_field() const
{
  return parts_->cells.make_field();
}

const InclusionField& Inclusions::own_strain() const
{
  return parts_->cells.own;
}

bool Inclusions::has_own_strain() const
{
  const auto acts = [](double strain) { return strain != 0.0; };
  const InclusionField& own = own_strain();
  return std::any_of(own.deviator.begin(), own.deviator.end(), acts) ||
         std::any_of(own.volumetric.begin(), own.volumetric.end(), acts);
}

void Inclusions::stress(const InclusionField& equivalent, InclusionField& out)
{
  parts_->fields.stress(parts_->cells, equivalent, out);
}

void Inclusions::gather(std::span<const double> deviator, std::span<const double> trace, InclusionField& out) const
{
  parts_->fields.gather(parts_->cells, deviator, trace, out);
}

double Inclusions::work(const InclusionField& stress, const InclusionField& strain) const
{
  const InclusionCells& cells = parts_->cells;
  const std::size_t n = cells.size();
  double sum = 0.0;
  for (std::size_t i = 0; i < n; ++i)
    sum += cells.copies[i] * (contract(deviator_at(stress.deviator, n, i), deviator_at(strain.deviator, n, i)) +
                              stress.volumetric[i] * strain.volumetric[i]);
  return sum * cells.grid.cell_volume();
}

Inclusions::Report Inclusions::solve(const InclusionField& stress, InclusionField& equivalent, double tolerance,
                                     int most_iterations)
{
  Parts& p = *parts_;
  std::vector<double> right(p.cells.unknowns()), w(right.size());
  p.cells.to_right_side(stress, right);
  p.cells.to_unknown(equivalent, w);
  const Report report =
      p.cells.solve([&](const InclusionField& of, InclusionField& out) { p.fields.stress(p.cells, of, out); }, right, w,
                    tolerance, most_iterations);
  p.cells.to_strain(w, equivalent);
  return report;
}

/// Right side of the equations less their left side.
std::vector<double> Inclusions::Parts::rest(const std::vector<double>& right, const Solution& solution) const
{
  std::vector<double> w(right.size()), left(right.size());
  cells.to_unknown(solution.equivalent, w);
  cells.to_left_side(w, solution.caused, left);
  for (std::size_t i = 0; i < left.size(); ++i)
    left[i] = right[i] - left[i];
  return left;
}

/// Change of the equivalent strain that removes a rest, to a tolerance relative to it: in the box, or in the whole body.
Inclusions::Report Inclusions::Parts::correct(std::span<const double> rest, double tolerance, int most_iterations,
                                              bool in_box, InclusionField& change)
{
  std::vector<double> w(rest.size());
  if (matrix)
  {
    std::copy(rest.begin(), rest.end(), w.begin());
    matrix->solve(w);
    cells.to_strain(w, change);
    return {};
  }
  InclusionFields& of = in_box ? box->fields : fields;
  const InclusionCells& in = in_box ? box->cells : cells;
  const Report report =
      cells.solve([&](const InclusionField& strain, InclusionField& out) { of.stress(in, strain, out); }, rest, w,
                  in_box ? std::max(tolerance, closest) : tolerance, most_iterations);
  cells.to_strain(w, change);
  return report;
}

namespace
{

void add_to(const InclusionField& part, InclusionField& sum)
{
  for (std::size_t i = 0; i < part.deviator.size(); ++i)
    sum.deviator[i] += part.deviator[i];
  for (std::size_t i = 0; i < part.volumetric.size(); ++i)
    sum.volumetric[i] += part.volumetric[i];
}

} // namespace

Inclusions::Solution Inclusions::make_solution() const
{
  return {make_field(), make_field()};
}

Inclusions::Report Inclusions::update(const InclusionField& stress, Solution& solution, double tolerance,
                                      int most_iterations, int layers, const HalfSpace::Dilated& to)
{
  Parts& p = *parts_;
  p.prepare();
  std::vector<double> right(p.cells.unknowns());
  p.cells.to_right_side(stress, right);
  const double of_right = std::sqrt(p.cells.dot(right, right));
  if (of_right == 0.0)
  {
    solution = make_solution();
    return {};
  }
  Report report;
  std::vector<double> rest = p.rest(right, solution);
  const auto residual = [&] { return std::sqrt(p.cells.dot(rest, rest)) / of_right; };
  report.residual = residual();
  InclusionField change = make_field(), caused = make_field();
  // A first correction in any case: were the strain left as it is wherever the rest is small, differences of later results would not tell anything of
  // their causes, on which accelerated fixed points rely.
  for (report.corrections = 1;; ++report.corrections)
  {
    const double reduction = report.residual > 0.0 ? std::min(margin * tolerance / report.residual, least) : least;
    const bool in_box = p.box && report.corrections <= most_corrections;
    report.iterations += p.correct(rest, reduction, most_iterations, in_box, change).iterations;
    add_to(change, solution.equivalent);
    if (report.corrections == 1)
      p.fields.add(p.cells, solution.equivalent, layers, to, &solution.caused);
    else
    {
      p.fields.add(p.cells, change, layers, to, &caused);
      add_to(caused, solution.caused);
    }
    rest = p.rest(right, solution);
    report.residual = residual();
    if (!(report.residual > tolerance) || report.corrections > most_corrections)
      return report;
  }
}

void Inclusions::add(const InclusionField& equivalent, int layers, const HalfSpace::Dilated& to)
{
  parts_->fields.add(parts_->cells, equivalent, layers, to, nullptr);
}

} // namespace brinell::halfspace
