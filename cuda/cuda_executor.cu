// SPDX-License-Identifier: BSD-3-Clause
#include "cuda/cuda_executor.cuh"

#include "cuda/device.hpp"

#include <array>
#include <string>

namespace brinell::cuda
{

namespace
{

std::string cause_of(cufftResult result)
{
  switch (result)
  {
  case CUFFT_ALLOC_FAILED:
    return "the memory of the GPU is exhausted; a smaller grid, or a GPU with more";
  case CUFFT_INVALID_SIZE:
    return "cuFFT has no transform of this length";
  case CUFFT_INVALID_DEVICE:
    return "cuFFT has no code for this GPU";
  case CUFFT_SETUP_FAILED:
    return "cuFFT cannot begin; is its version that of the driver?";
  default:
    return "cuFFT has failed";
  }
}

} // namespace

void check(cufftResult result, const char* action)
{
  if (result != CUFFT_SUCCESS)
    throw DeviceError(std::string(action) + ": " + cause_of(result) + " (cufftResult " + std::to_string(result) + ")");
}

/// Lengths of 64 bits, because all planes together may have more values than 32 bits count.
CudaExecutor::Transform::Plan::Plan(const SurfaceGrid& grid, int planes, cufftType type)
{
  cufftHandle handle = 0;
  check(cufftCreate(&handle), "plan of a transform");
  handle_ = handle;
  std::array<long long, 2> lengths{grid.ny, grid.nx};
  std::size_t work = 0;
  const cufftResult result = cufftMakePlanMany64(handle, static_cast<int>(lengths.size()), lengths.data(), nullptr, 1,
                                                 0, nullptr, 1, 0, type, planes, &work);
  if (result != CUFFT_SUCCESS)
    cufftDestroy(handle);
  check(result, "plan of a transform");
}

CudaExecutor::Transform::Plan::~Plan()
{
  if (handle_)
    cufftDestroy(*handle_);
}

CudaExecutor::Transform::Transform(const SurfaceGrid& grid, int planes)
    : forward_(grid, planes, CUFFT_D2Z), inverse_(grid, planes, CUFFT_Z2D)
{
}

/// A transform from one array to another leaves real numbers as they are, though cuFFT does not promise so in its signature.
void CudaExecutor::Transform::forward(const double* fields, ComplexNumber* spectra)
{
  check(cufftExecD2Z(forward_.handle(), const_cast<double*>(fields), reinterpret_cast<cufftDoubleComplex*>(spectra)),
        "transform of fields");
}

void CudaExecutor::Transform::inverse(ComplexNumber* spectra, double* fields)
{
  check(cufftExecZ2D(inverse_.handle(), reinterpret_cast<cufftDoubleComplex*>(spectra), fields),
        "transform of spectra");
}

} // namespace brinell::cuda
