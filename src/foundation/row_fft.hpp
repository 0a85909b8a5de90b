// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "foundation/aligned.hpp"
#include "foundation/lane_fft.hpp"
#include "foundation/lanes.hpp"
#include "foundation/series_fft.hpp"

#include <cstddef>

namespace brinell
{

/// Real Fourier transforms of neighbouring rows of a field, zero-padded, between the field and blocks of `lane_count`
/// neighbouring wavenumbers.
///
/// `lane_count` rows are the real parts and as many the imaginary parts of complex series, one in each lane of LaneFft: the
/// spectra of the two real series are the even and the odd part of that of the complex one. If only a few rows are left, most
/// lanes would be empty, so SeriesFft transforms them one by one: of an even length L = 2 n, the values with even index j are the
/// real and those with odd index the imaginary parts of a series of length n, and from its transform Z
///   X_k = (Z_k + Z*_{n-k})/2 + f_k (Z_k - Z*_{n-k}),  f_k = -i/2 e^{-2 pi i k / L}
/// (Cooley, Lewis, Welch 1970). An odd length is transformed with n = L, zero imaginary parts and f = 0. Planned once; every
/// function is const and may be called from several threads, each with its own Work.
class RowFft
{
public:
  /// @param given   number of values of a row; the rest is zero padding
  /// @param length  of the transform, >= given
  RowFft(int given, int length);

  static constexpr int most_rows = 2 * lane_count; ///< largest number of rows that are transformed together

  [[nodiscard]] int length() const { return lanes_.length(); }
  [[nodiscard]] int wavenumbers() const { return length() / 2 + 1; }
  [[nodiscard]] int blocks() const { return (wavenumbers() + lane_count - 1) / lane_count; }

  struct Work
  {
    AlignedVector<ComplexLanes> series, spectrum, lanes; ///< of rows together
    struct One
    {
      SeriesFft::Work fft;
      AlignedVector<double> pairs;                    ///< values of odd length, imaginary parts between them
      AlignedVector<double> re, im, half_re, half_im; ///< of Z and X, with margins of `lane_count`
    } one;                                            ///< of one row
  };
  [[nodiscard]] Work make_work() const;

  /// Layout: block b of the spectrum of row j is spectra[b * apart + j]; lanes beyond the last wavenumber are zero.
  struct Spectra
  {
    std::ptrdiff_t apart;
    bool past_caches;
  };
  /// @param count  rows, <= most_rows
  void forward(const double* field, int count, ComplexLanes* spectra, const Spectra& layout, Work& work) const;
  /// Inverse transform, multiplied by `scale`.
  void inverse(const ComplexLanes* spectra, const Spectra& layout, int count, double scale, double* field,
               Work& work) const;

private:
  [[nodiscard]] bool is_even() const { return length() % 2 == 0; }
  [[nodiscard]] bool is_worth_together(int count) const;
  void forward_together(const double* field, int count, ComplexLanes* spectra, const Spectra& layout, Work& work) const;
  void inverse_together(const ComplexLanes* spectra, const Spectra& layout, int count, double scale, double* field,
                        Work& work) const;
  void separate(int block, int count, ComplexLanes* spectra, bool past_caches, const Work& work) const;
  void unite(int block, int count, const ComplexLanes* spectra, Work& work) const;
  [[nodiscard]] ComplexLanes folded(const double* re, const double* im, std::ptrdiff_t k, bool inverse) const;
  void forward_one(const double* field, ComplexLanes* spectra, const Spectra& layout, Work& work) const;
  void inverse_one(const ComplexLanes* spectra, const Spectra& layout, double scale, double* field, Work& work) const;

  int given_;
  LaneFft lanes_;
  SeriesFft series_;                    ///< of a single row
  AlignedVector<ComplexLanes> factors_; ///< f
};

} // namespace brinell
