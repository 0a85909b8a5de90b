// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/contact/tangential_contact.hpp"
#include "friction_discs.hpp"
#include "own_compliance.hpp"

#include <vector>

namespace brinell::contact
{

/// Fields and iteration steps of `TangentialContact`. The fields contain only the cells that can carry shear (bound > 0). The
/// displacement is the one added in this step, i.e. by the change of the shears from those of the previous step.
class TangentialContact::Iteration
{
public:
  explicit Iteration(const halfspace::SurfaceCompliance& compliance);

  [[nodiscard]] const SurfaceGrid& grid() const { return compliance_.grid(); }
  /// Reads a step; `shear` is a guess.
  void start(const TangentialStep& step, const AlongSurface& shear);
  /// Begins again with another guess of the shears.
  void restart(const ConstAlongSurface& shear);
  /// Computes the displacement from the shears by a product with the compliance.
  void displace();
  /// Computes zones, shift and slip from the current displacement, and the errors of the report.
  void evaluate(TangentialReport& report);
  /// Saves the shears and their displacement.
  void save();
  /// Whether the energy has not increased since `save`.
  [[nodiscard]] bool has_descended() const;
  /// Restores the saved shears and displacement.
  void restore_saved();
  /// Computes the next search direction and its image. @returns the step along it that minimises the energy
  [[nodiscard]] double find_direction();
  /// Takes the step, along the tangents of the discs where the surfaces slip, and updates the displacement.
  /// @param error  current slip error [m]: the effect of shears beyond their bound must stay well below it
  /// @returns whether no shear exceeds its bound by more than that allows
  [[nodiscard]] bool advance(double step, double error);
  /// Projects shears that exceed their bound back on it.
  void restore_bounds();
  /// Returns part of the way towards the saved shears, to the point of lowest energy; the displacement is updated, too.
  /// @returns whether there is a point between both with a lower energy than that of the saved shears
  [[nodiscard]] bool retreat();
  /// From the saved shears, moves all cells along their slip by a step so small that the energy decreases.
  void follow_gradient();
  /// From the saved shears, moves the cells with the largest slip errors to where their slip would be right without interaction
  /// between the cells.
  void move_worst();
  void finish(TangentialReport& report, const AlongSurface& shear, const AlongSurface& slip) const;

private:
  /// Sums over the directions in which the cells are free.
  struct Unbalanced
  {
    Along slip;       ///< sum of the slip in these directions
    AlongMatrix free; ///< sum of the projectors on these directions
    Unbalanced& operator+=(const Unbalanced& other)
    {
      slip += other.slip;
      free += other.free;
      return *this;
    }
  };
  [[nodiscard]] std::size_t cells() const { return cells_.size(); }
  void resize();
  void read_targets(const TangentialStep& step);
  [[nodiscard]] Along shift_of_sticking() const;
  /// The part of a vector along the free directions of a cell: the whole vector, or its component tangential to the disc.
  [[nodiscard]] Along free_part(std::size_t i, const Along& a) const
  {
    const Along n = normal_.at(i);
    return a - dot(a, n) * n;
  }
  void classify();
  void find_preconditioner_weights();
  void precondition();
  void combine(double beta);
  void bound_shears(bool of_slip);
  [[nodiscard]] double excess_allowed(double error) const;
  /// Writes values of the cells to `grid_field_`, with zero in all other cells.
  template <typename Value>
  void scatter(const Value& value)
  {
    grid_field_.clear();
    for (std::size_t i = 0; i < cells(); ++i)
      grid_field_.set(cells_[i], value(i));
  }
  /// Reads values of the cells from `grid_field_`.
  template <typename Use>
  void gather(const Use& use)
  {
    for (std::size_t i = 0; i < cells(); ++i)
      use(i, grid_field_.at(cells_[i]));
  }
  void multiply();

  const halfspace::SurfaceCompliance& compliance_;
  halfspace::SurfaceCompliance::Scratch scratch_;
  AlongField grid_field_;          ///< input and output of the operators, in all cells of the grid
  AlongField before_;              ///< shears of the step before, in all cells
  bool has_before_ = false;        ///< whether there are any
  std::vector<std::size_t> cells_; ///< cells that can carry shear
  std::vector<double> bound_;
  double largest_bound_ = 0.0;
  OwnCompliance own_;
  std::vector<Zone> zone_;
  AlongField target_; ///< displacement for zero slip, without the part of the shift that an imposed force determines
  AlongField shear_, displacement_, slip_;
  AlongField normal_; ///< of the disc where a cell slips, zero where it sticks
  std::vector<double>
      bound_compliance_; ///< compliance that the bound adds along the tangent: slip along the shear, divided by the shear [m/Pa]
  std::vector<double> soft_, stiff_; ///< weights of both parts of the preconditioner
  bool slips_ = false;               ///< whether any cell slips
  AlongField direction_, image_;
  AlongField gradient_; ///< slip in the free directions
  AlongField saved_shear_, saved_displacement_;
  double mean_compliance_; ///< geometric mean of the smallest and the largest compliance of a wave [m/Pa]
  Forced forced_;
  Along sum_;     ///< of the shears where it is forced [Pa]
  Along shift_;   ///< shift that the force takes, found [m]
  Along imposed_; ///< the rest of the shift [m]
  Unbalanced unbalanced_;
  double threshold_ = 0.0; ///< fraction of the bound from which on a shear counts as being at its bound
  double slope_ = 0.0;     ///< of the last direction, without the ones before it; 0 to begin anew
  int products_ = 0;
};

} // namespace brinell::contact
