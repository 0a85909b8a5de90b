// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "foundation/aligned.hpp"
#include "foundation/lane_fft.hpp"
#include "foundation/lanes.hpp"

#include <cstddef>
#include <vector>

namespace brinell
{

/// Fourier transform of a single complex series in lanes.
///
/// Of the n = d m values, every d-th belongs to one of d shorter series, which LaneFft transforms side by side, one in each lane,
/// to Y_l (decimation in time: Cooley, Tukey 1965). What remains is, for k < m and r < d,
///   X_{k + m r} = sum over l < d of e^{-2 pi i l r / d} e^{-2 pi i l k / n} Y_{l,k},
/// a butterfly of `lane_count` neighbouring k at a time. The inverse takes these steps backwards. If d is larger than
/// `lane_count`, several groups of series follow one another. Planned once; every function is const and may be called from
/// several threads, each with its own Work.
class SeriesFft
{
public:
  explicit SeriesFft(int length);

  [[nodiscard]] int length() const { return parts_ * lanes_.length(); }

  struct Work
  {
    AlignedVector<ComplexLanes> series, spectra; ///< [group][place or wavenumber]
    AlignedVector<ComplexLanes> lanes;           ///< of LaneFft
  };
  [[nodiscard]] Work make_work() const;

  /// re_k + i im_k = sum of x_j e^{-2 pi i j k / length}, unnormalised.
  /// @param from   the x_j, real and imaginary parts by turns
  /// @param given  number of these parts; those beyond are zero
  void forward(const double* from, int given, double* re, double* im, Work& work) const;
  /// x_j = scale * sum of (re_k + i im_k) e^{2 pi i j k / length}; `re` and `im` are read up to `lane_count` values beyond the
  /// length.
  /// @param wanted  number of the parts that are written
  void inverse(const double* re, const double* im, double scale, double* to, int wanted, Work& work) const;

private:
  [[nodiscard]] int groups() const { return (parts_ + lane_count - 1) / lane_count; }
  /// Values from one group to the next; tiles may reach beyond the last value.
  [[nodiscard]] std::ptrdiff_t apart() const { return lanes_.length() + lane_count; }
  template <std::size_t parts>
  void combine(const ComplexLanes* spectra, double* re, double* im) const;
  template <std::size_t parts>
  void divide(const double* re, const double* im, ComplexLanes* spectra) const;

  int parts_; ///< d
  LaneFft lanes_;
  AlignedVector<ComplexLanes> twiddles_; ///< [tile of k][1 <= l < d], k in lanes
  std::vector<double> roots_;            ///< e^{2 pi i k / d}
};

} // namespace brinell
