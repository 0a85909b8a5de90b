// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/elastoplastic/effect.hpp"

#include <cmath>

namespace brinell::elastoplastic
{

std::span<const double> Interaction::pressure_before() const
{
  return friction_ != nullptr ? friction_->pressure_before(pressure_) : pressure_;
}

bool Interaction::knows_slip() const
{
  return friction_ == nullptr || friction_->knows_slip();
}

std::vector<double> Interaction::slip_length() const
{
  return friction_ != nullptr ? friction_->slip_length(slid_) : std::vector<double>(pressure_.size(), slid_);
}

std::vector<double> Interaction::shear() const
{
  std::vector<double> shear(pressure_.size());
  if (friction_ != nullptr)
    for (const std::span<const double>& part : friction_->shears())
      for (std::size_t i = 0; i < part.size(); ++i)
        shear[i] = std::hypot(shear[i], part[i]);
  return shear;
}

Interface::Onset Interaction::onset() const
{
  return friction_ != nullptr ? friction_->onset(pressure_) : Interface::Onset{};
}

} // namespace brinell::elastoplastic
