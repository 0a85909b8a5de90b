// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <concepts>
#include <functional>
#include <memory>
#include <utility>

namespace brinell::constitutive
{

/// What a law must have; hardening.hpp says what these mean. A law without `work(e)` has it integrated numerically.
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

/// Integral of a yield stress from 0 to e [J/m^3], for laws of which no closed form is known: Gauss's rule on parts that grow
/// from the start, where a power law is steep.
[[nodiscard]] double integrated_work(const std::function<double(double)>& yield_stress, double e);

/// A law that is none of those of this library: any struct with their members, or functions.
/// Two are equal if one is a copy of the other, or if both hold laws of one type that can be compared and are equal. Bodies of
/// materials that are not equal are never taken for twins: they are solved apart.
class UserHardening
{
public:
  // A copy is none of its own laws; asked first, or whether it can be copied would depend on itself.
  template <typename Law>
  requires(!std::same_as<Law, UserHardening>) && LawOfAUser<Law> explicit UserHardening(Law law)
      : law_(std::make_shared<const Model<Law>>(std::move(law)))
  {
    require_valid();
  }
  /// @param yield_stress  sigma_y(e) [Pa], > 0, non-decreasing
  /// @param modulus       its slope [Pa], >= 0
  /// Functions cannot be compared: only copies are equal.
  /// @throws InputError if they are not that for some strains from 0 to 1
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
