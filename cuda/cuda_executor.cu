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

/// Lengths of 64 bits, because all planes together may have more values than 32 bits count. The layouts are told, since those that
/// cuFFT assumes depend on whether a transform is in place.
CudaExecutor::Transform::Plan::Plan(int px, int py, int pitch, int planes, cufftType type)
{
  cufftHandle handle = 0;
  check(cufftCreate(&handle), "plan of a transform");
  handle_ = handle;
  using Lengths = std::array<long long, 2>;
  Lengths lengths{py, px}, real{py, pitch}, waves{py, px / 2 + 1};
  const auto plane = [](const Lengths& of) { return of[0] * of[1]; };
  Lengths& in = type == CUFFT_D2Z ? real : waves;
  Lengths& out = type == CUFFT_D2Z ? waves : real;
  std::size_t work = 0;
  const cufftResult result = cufftMakePlanMany64(handle, static_cast<int>(lengths.size()), lengths.data(), in.data(), 1,
                                                 plane(in), out.data(), 1, plane(out), type, planes, &work);
  if (result != CUFFT_SUCCESS)
    cufftDestroy(handle);
  check(result, "plan of a transform");
}

CudaExecutor::Transform::Plan::~Plan()
{
  if (handle_)
    cufftDestroy(*handle_);
}

CudaExecutor::Transform::Transform(const SurfaceGrid& grid, int px, int py, int planes)
    : padding_{static_cast<std::size_t>(grid.nx), static_cast<std::size_t>(grid.ny), static_cast<std::size_t>(px),
               static_cast<std::size_t>(py)},
      planes_(static_cast<std::size_t>(planes)), is_padded_(px != grid.nx || py != grid.ny),
      forward_(px, py, is_padded_ ? static_cast<int>(padding_.pitch()) : px, planes, CUFFT_D2Z),
      inverse_(px, py, is_padded_ ? static_cast<int>(padding_.pitch()) : px, planes, CUFFT_Z2D)
{
}

/// A transform from one array to another leaves real numbers as they are, though the signature of cuFFT does not promise it.
void CudaExecutor::Transform::forward(const double* fields, ComplexNumber* spectra)
{
  double* from = const_cast<double*>(fields);
  if (is_padded_)
  {
    from = reinterpret_cast<double*>(spectra);
    CudaExecutor().run("padding", planes_ * padding_.padded(), device::Embed{padding_, fields, from});
  }
  check(cufftExecD2Z(forward_.handle(), from, reinterpret_cast<cufftDoubleComplex*>(spectra)), "transform of fields");
}

void CudaExecutor::Transform::inverse(ComplexNumber* spectra, double* fields)
{
  double* to = is_padded_ ? reinterpret_cast<double*>(spectra) : fields;
  check(cufftExecZ2D(inverse_.handle(), reinterpret_cast<cufftDoubleComplex*>(spectra), to), "transform of spectra");
  if (is_padded_)
    CudaExecutor().run("end of padding", planes_ * padding_.cells(), device::Extract{padding_, to, fields});
}

} // namespace brinell::cuda
