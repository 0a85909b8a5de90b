// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <complex>
#include <cstddef>
#include <new>
#include <vector>

namespace brinell
{

/// Allocator that aligns every array to a cache line, for SIMD transforms.
template <typename T>
struct CacheLineAllocator
{
  using value_type = T;
  static constexpr std::align_val_t alignment{64};

  CacheLineAllocator() = default;
  template <typename U>
  CacheLineAllocator(const CacheLineAllocator<U>& /*other*/)
  {
  }
  T* allocate(std::size_t n) { return static_cast<T*>(::operator new(n * sizeof(T), alignment)); }
  void deallocate(T* p, std::size_t /*n*/) { ::operator delete(p, alignment); }
  template <typename U>
  bool operator==(const CacheLineAllocator<U>& /*other*/) const
  {
    return true;
  }
};

template <typename T>
using AlignedVector = std::vector<T, CacheLineAllocator<T>>;

/// One value of a Fourier spectrum.
using Complex = std::complex<double>;

} // namespace brinell
