// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/foundation/grid.hpp"
#include "cuda/check.hpp"
#include "device/padding_kernels.hpp"
#include "foundation/complex_number.hpp"

#include <cstddef>
#include <cufft.h>
#include <optional>
#include <span>
#include <utility>

/// Executor of kernels on a GPU (device/host_executor.hpp says what an executor has); for sources that are compiled with CUDA. All of it
/// refers to the device that is selected for this thread: call `open_device` first.
namespace brinell::cuda
{

/// @throws DeviceError
void check(cufftResult result, const char* action);

namespace detail
{

template <typename Kernel>
__global__ void run_each(std::size_t count, const Kernel kernel)
{
  const std::size_t n = static_cast<std::size_t>(blockIdx.x) * blockDim.x + threadIdx.x;
  if (n < count)
    kernel(n);
}

} // namespace detail

/// An array on the device.
template <typename Value>
class DeviceMemory
{
public:
  DeviceMemory() = default;
  explicit DeviceMemory(std::size_t count) : count_(count)
  {
    if (count == 0)
      return;
    check(cudaMalloc(&data_, count * sizeof(Value)), "memory on the device");
    check(cudaMemset(data_, 0, count * sizeof(Value)), "memory on the device");
  }
  DeviceMemory(DeviceMemory&& other) noexcept
      : data_(std::exchange(other.data_, nullptr)), count_(std::exchange(other.count_, 0))
  {
  }
  DeviceMemory& operator=(DeviceMemory&& other) noexcept
  {
    std::swap(data_, other.data_);
    std::swap(count_, other.count_);
    return *this;
  }
  ~DeviceMemory() { cudaFree(data_); }

  [[nodiscard]] Value* data() { return data_; }
  [[nodiscard]] const Value* data() const { return data_; }
  [[nodiscard]] std::size_t size() const { return count_; }

private:
  Value* data_ = nullptr;
  std::size_t count_ = 0;
};

class CudaExecutor
{
public:
  template <typename Value>
  using Memory = DeviceMemory<Value>;

  template <typename Value>
  [[nodiscard]] Memory<Value> allocate(std::size_t count) const
  {
    return Memory<Value>(count);
  }
  template <typename Value>
  void write(std::span<const Value> from, Memory<Value>& to) const
  {
    check(cudaMemcpy(to.data(), from.data(), from.size_bytes(), cudaMemcpyHostToDevice), "copy to the device");
  }
  /// Waits for the kernels, so that what has gone wrong in their course is found here.
  template <typename Value>
  void read(const Memory<Value>& from, std::span<Value> to) const
  {
    check(cudaMemcpy(to.data(), from.data(), to.size_bytes(), cudaMemcpyDeviceToHost), "copy from the device");
  }
  /// @param name  of the kernel in errors
  template <typename Kernel>
  void run(const char* name, std::size_t count, const Kernel& kernel) const
  {
    constexpr std::size_t threads = 128;
    if (count == 0)
      return;
    detail::run_each<<<static_cast<unsigned>((count + threads - 1) / threads), threads>>>(count, kernel);
    check_launch(name);
  }

  /// Real transforms of many planes at once, by cuFFT: in the place of the spectra if planes are padded.
  class Transform
  {
  public:
    Transform(const SurfaceGrid& grid, int px, int py, int planes);
    void forward(const double* fields, ComplexNumber* spectra);
    void inverse(ComplexNumber* spectra, double* fields);

  private:
    /// Owner of a plan of cuFFT.
    class Plan
    {
    public:
      /// @param pitch  numbers from one row of a real plane to the next
      Plan(int px, int py, int pitch, int planes, cufftType type);
      Plan(Plan&& other) noexcept : handle_(std::exchange(other.handle_, std::nullopt)) {}
      Plan& operator=(Plan&&) = delete;
      ~Plan();
      [[nodiscard]] cufftHandle handle() const { return *handle_; }

    private:
      std::optional<cufftHandle> handle_; ///< none once moved from
    };

    device::Padding padding_;
    std::size_t planes_;
    bool is_padded_;
    Plan forward_, inverse_;
  };
  [[nodiscard]] Transform transform(const SurfaceGrid& grid, int px, int py, int planes) const
  {
    return {grid, px, py, planes};
  }
};

} // namespace brinell::cuda
