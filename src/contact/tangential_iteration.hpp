// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/contact/tangential_contact.hpp"
#include "friction_discs.hpp"

#include <vector>

namespace brinell::contact
{

/// The fields of `TangentialContact`, and what one iteration does to them.
class TangentialContact::Iteration
{
public:
  explicit Iteration(const halfspace::TractionCompliance& compliance);

  [[nodiscard]] std::size_t cells() const { return bound_.size(); }
  /// Reads a step; `shear` is a guess.
  void start(const TangentialStep& step, const AlongSurface& shear);
  /// Displacement of the shears.
  void displace();
  /// Zones, shift and slip of the displacement that is known; the report's errors.
  void settle(TangentialReport& report);
  /// Notes shears whose displacement is known,
  void keep();
  /// and whether the energy has become smaller since.
  [[nodiscard]] bool has_descended() const;
  /// Next direction, and its image. @returns the step along it that makes the energy smallest
  [[nodiscard]] double aim();
  /// Takes the step, straight along the tangents where the surfaces slip; the displacement follows.
  /// @returns whether no shear exceeds its bound, where the surfaces slip by more than this share
  [[nodiscard]] bool advance(double step, double allowed);
  /// Cuts what exceeds its bound.
  void restore_bounds();
  /// Back towards what was kept, so far that the energy is less than there. @returns whether the displacement is known
  [[nodiscard]] bool retreat();
  /// Under the contact [m].
  [[nodiscard]] double largest_displacement() const { return largest_displacement_; }
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
  [[nodiscard]] Along shift_of_sticking() const;
  void classify();
  void weigh(const AlongField& of, bool stiff, AlongField& weighed) const;
  void want();
  void combine(double beta);
  void bound_shears(bool of_slip);

  const halfspace::TractionCompliance& compliance_;
  halfspace::TractionCompliance::Scratch scratch_;
  std::vector<double> bound_;
  std::vector<Zone> zone_;
  AlongField target_; ///< displacement without slip and without what a force finds of the shift
  AlongField shear_, displacement_, slip_;
  AlongField direction_, image_;
  AlongField gradient_; ///< slip, as far as the bound leaves it free
  AlongField stiff_;    ///< what is wanted where the bound is stiff
  AlongField kept_shear_, kept_displacement_;
  double between_; ///< the mean, of logarithms, of the smallest and the largest compliance of a wave [m/Pa]
  Forced forced_;
  Along sum_;     ///< of the shears where it is forced [Pa]
  Along shift_;   ///< that it takes, found [m]
  Along imposed_; ///< the rest of the shift [m]
  Unbalanced unbalanced_;
  double largest_displacement_ = 0.0;
  double slope_ = 0.0; ///< of the last direction, without the ones before it; 0 to begin anew
};

} // namespace brinell::contact
