// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "foundation/complex_number.hpp"
#include "foundation/fft.hpp"

#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

namespace brinell::device
{

/// Executor of kernels on the processor: the twin of the one for CUDA, so that all that is computed on a device, but for the device
/// itself, is tested without one. An executor has
///   Memory<Value>             an array where the kernels run, with data() and size();
///   allocate<Value>(count)    such an array of zeros;
///   write(from, to), read(from, to)   copies to and from the beginning of such an array, as many values as there are here;
///   run(name, count, kernel)  calls kernel(n) for all n < count, in any order;
///   transform(grid, px, py, planes)   Transform of planes of the grid, one after the other in memory and padded with zeros to px times py:
///                             forward(fields, spectra), and inverse(spectra, fields), which may destroy the spectra. Neither scales.
///                             A spectrum has py rows of px / 2 + 1 values.
class HostExecutor
{
public:
  template <typename Value>
  using Memory = std::vector<Value>;

  template <typename Value>
  [[nodiscard]] Memory<Value> allocate(std::size_t count) const
  {
    return Memory<Value>(count);
  }
  template <typename Value>
  void write(std::span<const Value> from, Memory<Value>& to) const
  {
    std::copy(from.begin(), from.end(), to.begin());
  }
  template <typename Value>
  void read(const Memory<Value>& from, std::span<Value> to) const
  {
    std::copy_n(from.begin(), to.size(), to.begin());
  }
  template <typename Kernel>
  void run(const char* /*name*/, std::size_t count, const Kernel& kernel) const
  {
    for (std::size_t n = 0; n < count; ++n)
      kernel(n);
  }

  class Transform
  {
  public:
    Transform(const SurfaceGrid& grid, int px, int py, int planes)
        : fft_(grid, px, py), planes_(planes), work_(fft_.plane())
    {
    }
    void forward(const double* fields, ComplexNumber* spectra)
    {
      const std::size_t cells = fft_.grid().size(), waves = this->waves();
      for (int plane = 0; plane < planes_; ++plane, fields += cells, spectra += waves)
      {
        fft_.forward({fields, cells}, work_.data());
        for (std::size_t n = 0; n < waves; ++n)
          spectra[n] = {work_[n].real(), work_[n].imag()};
      }
    }
    void inverse(const ComplexNumber* spectra, double* fields)
    {
      const std::size_t cells = fft_.grid().size(), waves = this->waves();
      for (int plane = 0; plane < planes_; ++plane, fields += cells, spectra += waves)
      {
        for (std::size_t n = 0; n < waves; ++n)
          work_[n] = {spectra[n].re, spectra[n].im};
        fft_.inverse(work_.data(), {fields, cells});
        for (std::size_t n = 0; n < cells; ++n)
          fields[n] *= static_cast<double>(fft_.px()) * fft_.py();
      }
    }

  private:
    [[nodiscard]] std::size_t waves() const
    {
      return static_cast<std::size_t>(fft_.kx()) * static_cast<std::size_t>(fft_.py());
    }

    PaddedFft fft_;
    int planes_;
    AlignedVector<Complex> work_;
  };
  [[nodiscard]] Transform transform(const SurfaceGrid& grid, int px, int py, int planes) const
  {
    return {grid, px, py, planes};
  }
};

} // namespace brinell::device
