// SPDX-License-Identifier: BSD-3-Clause
#include "cuda/check.hpp"
#include "cuda/device.hpp"
#include "visible_device.hpp"

#include <gtest/gtest.h>
#include <string>

namespace brinell::cuda::device_test
{
namespace
{

using test::has_device;

TEST(CudaDevice, ComputesAndTellsItsMemory)
{
  if (!has_device())
    GTEST_SKIP() << "no GPU here";
  const Device device = open_device();
  EXPECT_FALSE(device.name.empty());
  EXPECT_GT(device.memory, 0U);
  EXPECT_LE(device.free_memory, device.memory);
}

TEST(CudaDevice, TellsWhyThereIsNone)
{
  if (has_device())
    GTEST_SKIP() << "there is a GPU";
  try
  {
    open_device();
    FAIL() << "opened a device that is not there";
  }
  catch (const DeviceError& error)
  {
    const std::string text = error.what();
    EXPECT_TRUE(text.find("no GPU is visible") != std::string::npos ||
                text.find("no driver of NVIDIA's") != std::string::npos)
        << text;
  }
}

TEST(CudaDevice, NamesCausesOfErrors)
{
  const auto text_of = [](cudaError_t error) -> std::string
  {
    try
    {
      check(error, "a call");
    }
    catch (const DeviceError& thrown)
    {
      return thrown.what();
    }
    return {};
  };
  EXPECT_EQ(text_of(cudaSuccess), "");
  EXPECT_EQ(
      text_of(cudaErrorMemoryAllocation),
      "a call: the memory of the GPU is exhausted; a smaller grid, or a GPU with more (cudaErrorMemoryAllocation)");
  EXPECT_EQ(text_of(cudaErrorNoKernelImageForDevice),
            "a call: the program was compiled for other GPUs; compile it with CMAKE_CUDA_ARCHITECTURES of this one "
            "(cudaErrorNoKernelImageForDevice)");
  EXPECT_EQ(text_of(cudaErrorInvalidValue), "a call: invalid argument (cudaErrorInvalidValue)");
}

} // namespace
} // namespace brinell::cuda::device_test
