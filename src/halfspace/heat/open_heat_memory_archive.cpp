// SPDX-License-Identifier: BSD-3-Clause
#include "open_heat_memory.hpp"

#include <fmt/format.h>

/// Saving and restoring the state of the memory.
namespace brinell::halfspace
{

OpenHeatMemory::Heat OpenHeatMemory::heat() const
{
  Heat result{{near_.heat()}, time_};
  for (const FartherImages& images : farther_)
    if (images.lattices)
      for (const HeatMemory* memory : {&images.lattices->twice, &images.lattices->once})
        result.lattices.push_back(memory->heat());
  return result;
}

void OpenHeatMemory::set_heat(const Heat& heat)
{
  const std::vector<HeatMemory*> all = lattices();
  for (std::size_t n = 0; n < all.size(); ++n)
    all[n]->set_heat(heat.lattices[n]);
  time_ = heat.time;
}

void OpenHeatMemory::exchange(Archive& archive)
{
  int n = 0;
  for (HeatMemory* memory : lattices())
  {
    HeatMemory::WholeHeat heat = memory->whole_heat();
    archive(fmt::format("lattice{}", n), heat.waves);
    archive.list(fmt::format("amended{}", n), heat.amended);
    archive(fmt::format("duration{}", n), heat.motion.duration, 0.0, times_.duration);
    archive(fmt::format("velocity_x{}", n), heat.motion.velocity_x);
    archive(fmt::format("velocity_y{}", n), heat.motion.velocity_y);
    if (archive.gives())
      memory->set_whole_heat(heat);
    if (layers_)
    {
      std::vector<double> in_body = memory->whole_heat_in_body();
      archive.list(fmt::format("body{}", n), in_body);
      if (archive.gives())
        memory->set_whole_heat_in_body(in_body);
    }
    ++n;
  }
  archive("time", time_, 0.0, times_.duration);
}

} // namespace brinell::halfspace
