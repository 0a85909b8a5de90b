// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/constitutive/flow.hpp"
#include "brinell/constitutive/hardening.hpp"

#include <cstddef>
#include <memory>
#include <span>

/// The return mapping on a GPU. The header needs no CUDA.
namespace brinell::cuda
{

/// Return mapping of cells with one hardening law, as constitutive::flow. Each call copies its fields to the device and back.
class ReturnMappingOnDevice
{
public:
  /// Uses the device that `open_device` has selected for this thread.
  /// @param terms  of kinematic hardening
  /// @throws DeviceError, InputError for a UserHardening and for many terms
  ReturnMappingOnDevice(const constitutive::HardeningLaw& law, constitutive::Integration integration, std::size_t cells,
                        std::span<const constitutive::KinematicTerm> terms = {});
  ~ReturnMappingOnDevice();
  ReturnMappingOnDevice(ReturnMappingOnDevice&&) noexcept;
  ReturnMappingOnDevice& operator=(ReturnMappingOnDevice&&) noexcept;

  /// Stress before the increment and trial deviator [component][cell], equivalent plastic strain before the increment.
  struct Before
  {
    std::span<const double> start, trial, equivalent;
  };
  /// Plastic strain [component][cell] of the increment, its equivalent, and the plastic work; back stresses [term][component][cell] before
  /// and after the increment.
  struct Flow
  {
    std::span<double> strain, increment, dissipation, backstress{};
  };
  /// @param stiffness  see constitutive::flow
  void flow(const Before& before, double stiffness, const Flow& out);

private:
  struct Fields;
  std::unique_ptr<Fields> fields_;
};

} // namespace brinell::cuda
