// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/constitutive/flow.hpp"
#include "brinell/constitutive/hardening.hpp"
#include "brinell/foundation/error.hpp"
#include "brinell/foundation/host_device.hpp"
#include "constitutive/linear_return.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>
#include <string>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

namespace brinell::device
{

/// Terms of kinematic hardening, few enough for a thread to keep their back stresses.
struct KinematicTerms
{
  static constexpr std::size_t most = 4;
  std::array<constitutive::KinematicTerm, most> terms{};
  std::size_t count = 0;
};

/// The return mapping of a point.
/// @tparam has_backstress  two functions, because back stresses take memory of a thread
template <typename Law, bool has_backstress>
struct FlowRule
{
  using BackStresses = std::array<Deviator, KinematicTerms::most>;

  Law law;
  constitutive::Integration integration;
  KinematicTerms kinematic;
  double stiffness; ///< c [Pa] of the trial deviator s + c d_eps: constitutive::flow

  /// @param factor  of the yield stress
  /// @param e       equivalent plastic strain before the increment
  /// @param back    back stresses before the increment, and after it
  [[nodiscard]] BRINELL_HOST_DEVICE constitutive::PlasticIncrement
  operator()(double factor, const Deviator& start, const Deviator& trial, double e, BackStresses& back) const
  {
    const constitutive::ScaledLaw<Law> scaled{law, factor};
    const double mu = 0.5 * stiffness;
    if constexpr (has_backstress)
      return constitutive::kinematic_return(
          start, trial, e, mu, scaled, integration == constitutive::Integration::path ? 0.5 : 1.0,
          std::span<const constitutive::KinematicTerm>(kinematic.terms.data(), kinematic.count),
          std::span<Deviator>(back.data(), kinematic.count));
    else
      return without_backstress(scaled, start, trial, e, mu);
  }

private:
  [[nodiscard]] BRINELL_HOST_DEVICE constitutive::PlasticIncrement
  without_backstress(const constitutive::ScaledLaw<Law>& scaled, const Deviator& start, const Deviator& trial, double e,
                     double mu) const
  {
    if (integration == constitutive::Integration::backward_euler)
      return constitutive::radial_return(trial, e, mu, scaled);
    if constexpr (constitutive::is_linear<Law>)
    {
      constitutive::PointsOf<double> point;
      point.start = start.v;
      point.trial = trial.v;
      point.yield = scaled.yield_stress_at(e);
      point.modulus = scaled.modulus_at(e);
      constitutive::path_return(point, mu);
      return {Deviator{point.strain}, point.equivalent, point.dissipation};
    }
    else
      return constitutive::path_return(start, trial, e, mu, scaled);
  }
};

/// Material law of a body, with its tables in memory of an executor.
template <typename Executor>
class HeldLaw
{
public:
  /// @param terms  of kinematic hardening
  /// @throws InputError for a UserHardening, which is a program of the processor, and for more than KinematicTerms::most terms
  HeldLaw(const constitutive::HardeningLaw& law, std::span<const constitutive::KinematicTerm> terms,
          const Executor& executor)
      : executor_(&executor), kinematic_(held(terms)),
        law_(std::visit([this](const auto& l) { return this->held(l); }, law))
  {
  }

  HeldLaw(HeldLaw&&) noexcept = default; // columns of a table stay where they are
  HeldLaw& operator=(HeldLaw&&) noexcept = default;

  [[nodiscard]] const KinematicTerms& kinematic() const { return kinematic_; }
  /// @returns use(law)
  template <typename Use>
  auto visit(const Use& use) const
  {
    return std::visit(use, law_);
  }

private:
  using Law = std::variant<constitutive::PerfectPlasticity, constitutive::LinearHardening, constitutive::SwiftHardening,
                           constitutive::LudwikHardening, constitutive::VoceHardening, constitutive::HardeningTable>;
  using Array = typename Executor::template Memory<double>;

  static KinematicTerms held(std::span<const constitutive::KinematicTerm> terms)
  {
    if (terms.size() > KinematicTerms::most)
      throw InputError("kinematic hardening of " + std::to_string(terms.size()) +
                       " terms; allowed on a device: at most " + std::to_string(KinematicTerms::most));
    KinematicTerms kinematic;
    std::copy(terms.begin(), terms.end(), kinematic.terms.begin());
    kinematic.count = terms.size();
    return kinematic;
  }
  template <typename Of>
  Law held(const Of& law)
  {
    if constexpr (std::is_same_v<Of, constitutive::UserHardening>)
      throw InputError(
          "a hardening law of your own is a program of the processor; a device computes with those of brinell, "
          "of which a tabulated one has any shape");
    else if constexpr (std::is_same_v<Of, constitutive::TabulatedHardening>)
      return copied(law.table());
    else
      return law;
  }
  constitutive::HardeningTable copied(constitutive::HardeningTable table)
  {
    for (const double** column : {&table.strain, &table.stress, &table.modulus, &table.works})
    {
      columns_.push_back(executor_->template allocate<double>(table.count));
      executor_->write(std::span<const double>(*column, table.count), columns_.back());
      *column = columns_.back().data();
    }
    return table;
  }

  const Executor* executor_;
  KinematicTerms kinematic_;
  std::vector<Array> columns_; ///< of a table
  Law law_;
};

} // namespace brinell::device
