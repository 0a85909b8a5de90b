// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <concepts>
#include <functional>
#include <memory>
#include <utility>

namespace brinell::constitutive
{

/// Requirements on a user-defined law; hardening.hpp defines the members. If a law has no `work(e)`, the work is integrated
/// numerically.
template <typename Law>
concept LawOfAUser = std::copy_constructible<Law> && requires(const Law& law, double e)
{
  {
    law.yield_stress_at(e)
    } -> std::convertible_to<double>;
  {
    law.modulus_at(e)
    } -> std::convertible_to<double>;
};

/// Integral of a yield stress from 0 to e [J/m^3], for laws without a known closed form: Gauss quadrature on intervals whose
/// length grows with the distance from e = 0, where a power law is steep.
[[nodiscard]] double integrated_work(const std::function<double(double)>& yield_stress, double e);

/// A user-defined law: any struct with the members of a law, or a pair of functions.
/// Two are equal if one is a copy of the other, or if both hold equal laws of the same equality-comparable type. Bodies whose
/// materials are not equal are never treated as identical: each is solved separately.
class UserHardening
{
public:
  // Exclude UserHardening itself first: otherwise the check of whether it is copyable would depend on itself.
  template <typename Law>
  requires(!std::same_as<Law, UserHardening>) && LawOfAUser<Law> explicit UserHardening(Law law)
      : law_(std::make_shared<const Model<Law>>(std::move(law)))
  {
    require_valid();
  }
  /// @param yield_stress  sigma_y(e) [Pa], > 0, non-decreasing
  /// @param modulus       its slope [Pa], >= 0
  /// Functions cannot be compared: only copies of this object are equal to it.
  /// @throws InputError if these conditions are violated at one of the sampled strains between 0 and 1
  UserHardening(std::function<double(double)> yield_stress, std::function<double(double)> modulus);

  [[nodiscard]] double yield_stress_at(double e) const { return law_->yield_stress_at(e); }
  [[nodiscard]] double modulus_at(double e) const { return law_->modulus_at(e); }
  [[nodiscard]] double work(double e) const { return law_->work(e); }

  friend bool operator==(const UserHardening& a, const UserHardening& b)
  {
    return a.law_ == b.law_ || a.law_->equals(*b.law_);
  }

private:
  struct Interface
  {
    Interface() = default;
    Interface(const Interface&) = delete;
    Interface& operator=(const Interface&) = delete;
    virtual ~Interface() = default;
    [[nodiscard]] virtual double yield_stress_at(double e) const = 0;
    [[nodiscard]] virtual double modulus_at(double e) const = 0;
    [[nodiscard]] virtual double work(double e) const = 0;
    [[nodiscard]] virtual bool equals(const Interface& other) const = 0;
  };

  template <typename Law>
  struct Model final : Interface
  {
    explicit Model(Law l) : law(std::move(l)) {}
    [[nodiscard]] double yield_stress_at(double e) const override { return law.yield_stress_at(e); }
    [[nodiscard]] double modulus_at(double e) const override { return law.modulus_at(e); }
    [[nodiscard]] double work(double e) const override
    {
      if constexpr (requires { law.work(e); })
        return law.work(e);
      else
        return integrated_work([this](double at) { return law.yield_stress_at(at); }, e);
    }
    [[nodiscard]] bool equals(const Interface& other) const override
    {
      if constexpr (std::equality_comparable<Law>)
      {
        const auto* same = dynamic_cast<const Model*>(&other);
        return same != nullptr && same->law == law;
      }
      else
        return false;
    }

    Law law;
  };

  void require_valid() const;

  std::shared_ptr<const Interface> law_;
};

} // namespace brinell::constitutive
