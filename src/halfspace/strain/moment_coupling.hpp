// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "foundation/aligned.hpp"
#include "foundation/lanes.hpp"
#include "image_samples.hpp"

#include <vector>

namespace brinell::halfspace
{

/// Matrix from moments of the strain to moments of the stress, of a kernel that is a sum of terms (x - x')^a (y - y')^b, a + b at
/// most `degree`, each with a matrix over functions of the depths. By the binomial theorem
///   a'! b'! stress[a', b'] = sum over a'', b'' of  (a' + a'')! (b' + b'')! kernel[a' + a'', b' + b'']
///                                                  (-1)^(a'' + b'') strain[a'', b''] / (a''! b''!)
/// so that only the kernel needs to be stored. It fits into the cache, unlike the matrix, which is several times as large.
class MomentCoupling
{
public:
  /// @param depths  number of functions of depth
  MomentCoupling(int depths, int degree);

  /// Adds a term to the stress component `c` by the strain component `e`. @param value  [function of z][function of z']
  void add(int c, int e, const images::Powers& power, double factor, const Matrix& value);

  struct Work
  {
    std::vector<double> strain;  ///< [component][monomial][depth]
    AlignedVector<Lanes> stress; ///< in the same order, with the depths in lanes
  };
  [[nodiscard]] Work make_work() const;

  /// Moments are [component][depth][monomial].
  /// @param is_mirrored  if the fields are mirror images about y = 0, moments of strain and stress that vanish are skipped
  /// @param components  number of components of the stress that are computed, from the first one
  void multiply(const double* strain, bool is_mirrored, int components, Work& work, double* stress) const;

  /// Index of x^a y^b among the monomials.
  [[nodiscard]] static constexpr int monomial(int a, int b) { return (a + b) * (a + b + 1) / 2 + b; }

private:
  struct Term
  {
    int c, e, a, b;
    std::size_t value; ///< index into `value_` of the matrix [depth of strain][depth of stress, in lanes]
  };
  template <typename Add>
  void for_products(const Term& term, bool is_mirrored, Work& work, const Add& add) const;
  template <std::size_t depths>
  void add_short_term(const Term& term, bool is_mirrored, Work& work) const;
  void add_term(const Term& term, bool is_mirrored, Work& work) const;
  [[nodiscard]] int monomials() const { return static_cast<int>(share_.size()); }
  [[nodiscard]] int parts() const { return (depths_ + lane_count - 1) / lane_count; }

  int depths_;
  std::vector<Term> terms_;
  AlignedVector<Lanes> value_;
  std::vector<double> share_; ///< 1 / (a! b!) of each monomial
  std::vector<double> sign_;  ///< (-1)^(a + b)
};

} // namespace brinell::halfspace
