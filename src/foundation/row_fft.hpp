// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "foundation/aligned.hpp"
#include "foundation/lane_fft.hpp"
#include "foundation/lanes.hpp"

#include <cstddef>
#include <memory>

namespace brinell
{

/// Real Fourier transforms of neighbouring rows of a field, zero-padded, between the field and blocks of `lane_count`
/// neighbouring wavenumbers.
///
/// `lane_count` rows are the real parts and as many the imaginary parts of complex series, one in each lane of LaneFft: the
/// spectra of the two real series are the even and the odd part of that of the complex one. If only a few rows are left, most
/// lanes would be empty, so FFTW transforms them one by one. Planned once; every function is const and may be called from several
/// threads, each with its own Work.
class RowFft
{
public:
  /// @param given   number of values of a row; the rest is zero padding
  /// @param length  of the transform, >= given
  RowFft(int given, int length);
  ~RowFft();
  RowFft(const RowFft&) = delete;
  RowFft& operator=(const RowFft&) = delete;

  static constexpr int most_rows = 2 * lane_count; ///< largest number of rows that are transformed together

  [[nodiscard]] int length() const { return lanes_.length(); }
  [[nodiscard]] int wavenumbers() const { return length() / 2 + 1; }
  [[nodiscard]] int blocks() const { return (wavenumbers() + lane_count - 1) / lane_count; }

  struct Work
  {
    AlignedVector<ComplexLanes> series, spectrum, lanes; ///< of rows together
    AlignedVector<double> real;                          ///< of one row
    AlignedVector<Complex> half;
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
  struct Plans;
  void forward_together(const double* field, int count, ComplexLanes* spectra, const Spectra& layout, Work& work) const;
  void inverse_together(const ComplexLanes* spectra, const Spectra& layout, int count, double scale, double* field,
                        Work& work) const;
  void separate(int block, int count, ComplexLanes* spectra, bool past_caches, const Work& work) const;
  void unite(int block, int count, const ComplexLanes* spectra, Work& work) const;
  void forward_one(const double* field, ComplexLanes* spectra, const Spectra& layout, Work& work) const;
  void inverse_one(const ComplexLanes* spectra, const Spectra& layout, double scale, double* field, Work& work) const;

  int given_;
  LaneFft lanes_;
  std::unique_ptr<Plans> plans_; ///< FFTW plans for a single row
};

} // namespace brinell
