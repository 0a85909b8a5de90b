// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/contact/tangential_contact.hpp"
#include "friction_discs.hpp"

#include <vector>

namespace brinell::contact
{

/// The fields of `TangentialContact`, and what one iteration does to them. They are those of the cells that can carry shear, one
/// after the other; shears and displacements are those of the step, what it adds to the shears before.
class TangentialContact::Iteration
{
public:
  explicit Iteration(const halfspace::TractionCompliance& compliance);

  [[nodiscard]] const SurfaceGrid& grid() const { return compliance_.grid(); }
  /// Reads a step; `shear` is a guess.
  void start(const TangentialStep& step, const AlongSurface& shear);
  /// Another guess.
  void restart(const ConstAlongSurface& shear);
  /// Displacement of the shears.
  void displace();
  /// Zones, shift and slip of the displacement that is known; the report's errors.
  void settle(TangentialReport& report);
  /// Notes shears whose displacement is known,
  void keep();
  /// and whether the energy has become smaller since.
  [[nodiscard]] bool has_descended() const;
  /// Puts them back.
  void take_back();
  /// Next direction, and its image. @returns the step along it that makes the energy smallest
  [[nodiscard]] double aim();
  /// Takes the step, straight along the tangents where the surfaces slip; the displacement follows.
  /// @param error  of the slip [m], which shears beyond their bound must not come near
  /// @returns whether no shear exceeds its bound by more than that
  [[nodiscard]] bool advance(double step, double error);
  /// Cuts what exceeds its bound.
  void restore_bounds();
  /// Back towards what was kept, so far that the energy is less than there; the displacement stays known.
  /// @returns whether there is such a place on the way
  [[nodiscard]] bool retreat();
  /// From what was kept, all cells a little along their slip: the energy becomes smaller.
  void follow_gradient();
  /// From what was kept, those cells whose slip is most wrong to where it is right if they are far apart.
  void move_worst();
  void finish(TangentialReport& report, const AlongSurface& shear, const AlongSurface& slip) const;

private:
  /// Sums over the cells that are not bound to a shear.
  struct Unbalanced
  {
    Along slip;       ///< that is left
    AlongMatrix free; ///< directions that are free
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
  /// The part of a vector that a cell is free to move along: all of it, or the tangent of its disc.
  [[nodiscard]] Along free_part(std::size_t i, const Along& a) const
  {
    const Along n = normal_.at(i);
    return a - dot(a, n) * n;
  }
  void classify();
  void weigh_zones();
  void want();
  void combine(double beta);
  void bound_shears(bool of_slip);
  [[nodiscard]] double excess_allowed(double error) const;
  /// Lays values of the cells on the grid, with nothing in the others.
  template <typename Value>
  void lay_out(const Value& value)
  {
    all_.clear();
    for (std::size_t i = 0; i < cells(); ++i)
      all_.set(cells_[i], value(i));
  }
  /// Takes values of the cells from the grid.
  template <typename Use>
  void take_in(const Use& use)
  {
    for (std::size_t i = 0; i < cells(); ++i)
      use(i, all_.at(cells_[i]));
  }
  void multiply();

  const halfspace::TractionCompliance& compliance_;
  halfspace::TractionCompliance::Scratch scratch_;
  AlongField all_;                 ///< of all cells: what an operator takes and gives
  AlongField before_;              ///< shears of the step before, in all cells
  bool has_before_ = false;        ///< whether there are any
  std::vector<std::size_t> cells_; ///< that can carry shear
  std::vector<double> bound_;
  double largest_bound_ = 0.0;
  std::vector<Zone> zone_;
  AlongField target_; ///< displacement without slip and without what a force finds of the shift
  AlongField shear_, displacement_, slip_;
  AlongField normal_; ///< of the disc where a cell slips, zero where it sticks
  std::vector<double>
      added_; ///< stiffness that the bound gives to the tangent: slip along the shear over its size [m/Pa]
  std::vector<double> soft_, stiff_; ///< weights of both parts of the preconditioner
  bool slips_ = false;               ///< somewhere
  AlongField direction_, image_;
  AlongField gradient_; ///< slip, as far as the bound leaves it free
  AlongField kept_shear_, kept_displacement_;
  double between_; ///< the mean, of logarithms, of the smallest and the largest compliance of a wave [m/Pa]
  Forced forced_;
  Along sum_;     ///< of the shears where it is forced [Pa]
  Along shift_;   ///< that it takes, found [m]
  Along imposed_; ///< the rest of the shift [m]
  Unbalanced unbalanced_;
  double threshold_ = 0.0; ///< share of its bound from which on a shear counts as bound
  double slope_ = 0.0;     ///< of the last direction, without the ones before it; 0 to begin anew
  int products_ = 0;
};

} // namespace brinell::contact
