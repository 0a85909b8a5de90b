// SPDX-License-Identifier: BSD-3-Clause
#include "cuda/device.hpp"

#include "cuda/check.hpp"

#include <array>
#include <memory>

namespace brinell::cuda
{

std::string cause_of(cudaError_t error)
{
  const std::string name = std::string(" (") + cudaGetErrorName(error) + ")";
  switch (error)
  {
  case cudaErrorNoDevice:
    return "no GPU is visible; is there one, and does CUDA_VISIBLE_DEVICES hide it?" + name;
  case cudaErrorInsufficientDriver:
    return "no driver of NVIDIA's is installed, or it is older than CUDA 13 needs (580)" + name;
  case cudaErrorInvalidDevice:
    return "there is no GPU of this number" + name;
  case cudaErrorMemoryAllocation:
    return "the memory of the GPU is exhausted; a smaller grid, or a GPU with more" + name;
  case cudaErrorNoKernelImageForDevice:
  case cudaErrorInvalidDeviceFunction:
  case cudaErrorUnsupportedPtxVersion:
    return "the program was compiled for other GPUs; compile it with CMAKE_CUDA_ARCHITECTURES of this one" + name;
  default:
    return cudaGetErrorString(error) + name;
  }
}

void check(cudaError_t error, const char* action)
{
  if (error != cudaSuccess)
    throw DeviceError(std::string(action) + ": " + cause_of(error));
}

void check_launch(const char* kernel)
{
  check(cudaGetLastError(), kernel);
}

namespace
{

constexpr int probes = 64;

__global__ void probe(int* values)
{
  values[threadIdx.x] = static_cast<int>(3 * threadIdx.x + 1);
}

void require_computes()
{
  int* memory = nullptr;
  check(cudaMalloc(&memory, probes * sizeof(int)), "first memory on the device");
  const auto release = [](int* pointer) { cudaFree(pointer); };
  const std::unique_ptr<int, decltype(release)> owner(memory, release);
  check(cudaMemset(memory, 0, probes * sizeof(int)), "first memory on the device");
  probe<<<1, probes>>>(memory);
  check_launch("first kernel on the device");
  std::array<int, probes> values{};
  check(cudaMemcpy(values.data(), memory, sizeof values, cudaMemcpyDeviceToHost), "first kernel on the device");
  for (int i = 0; i < probes; ++i)
    if (values[static_cast<std::size_t>(i)] != 3 * i + 1)
      throw DeviceError("first kernel on the device: it has not computed anything; " +
                        cause_of(cudaErrorNoKernelImageForDevice));
}

} // namespace

Device open_device(int number)
{
  int count = 0;
  check(cudaGetDeviceCount(&count), "looking for GPUs");
  check(cudaSetDevice(number), "selecting a GPU");
  cudaDeviceProp properties{};
  check(cudaGetDeviceProperties(&properties, number), "asking the GPU");
  require_computes();
  Device device{number, properties.name, properties.major, properties.minor};
  check(cudaMemGetInfo(&device.free_memory, &device.memory), "asking the GPU for its memory");
  return device;
}

} // namespace brinell::cuda
