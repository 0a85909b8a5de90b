// SPDX-License-Identifier: BSD-3-Clause
#include "judgement_parts.hpp"

#include "simulation/plan/roughness.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace brinell::quality
{

using namespace simulation;

namespace
{

constexpr double fewest_cells_of_dent = 4.0; ///< per edge radius of a dent, to resolve the pressure on its shoulder
constexpr double fewest_cells_of_wave = 8.0; ///< per shortest wavelength, to resolve peaks of pressure and their area
constexpr double lost_share = 0.5;           ///< of these, with which nothing can be said about errors

class OfTextures
{
public:
  OfTextures(const Facts& facts, std::vector<Warning>& warnings) : f_(facts), warnings_(warnings) {}

  /// @return whether a texture is lost
  bool tell()
  {
    for (std::size_t body = 0; body < f_.textures.size(); ++body)
    {
      const std::vector<TexturePart>& parts = f_.textures[body]->parts;
      for (std::size_t i = 0; i < parts.size(); ++i)
      {
        const std::string name =
            fmt::format("{}.texture{}", body == 0 ? "lower" : "upper", parts.size() > 1 ? fmt::format("[{}]", i) : "");
        std::visit([&](const auto& part) { of_texture(name, part); }, parts[i]);
      }
    }
    return is_lost_;
  }

private:
  void of_texture(const std::string& name, const Dent& dent)
  {
    const double cell = std::max(f_.cell[0], f_.cell[1]);
    if (!(dent.edge_radius < 0.999 * fewest_cells_of_dent * cell))
      return;
    is_lost_ = is_lost_ || dent.edge_radius < lost_share * fewest_cells_of_dent * cell;
    warnings_.push_back(
        {"coarse_texture", fmt::format("{}: a {} with an edge radius of {} is not resolved by cells of {}: use at "
                                       "least {:g} cells per edge radius",
                                       name, dent.depth < 0.0 ? "bump" : "dent", length_text(dent.edge_radius),
                                       length_text(cell), fewest_cells_of_dent)});
  }

  void of_texture(const std::string& name, const HeightMap& map)
  {
    if (map.dx < 0.999 * f_.cell[0] || map.dy < 0.999 * f_.cell[1])
    {
      is_lost_ = true;
      warnings_.push_back({"coarse_texture",
                           fmt::format("{}: the points of the height map, {} x {} apart, are finer than the cells, {} "
                                       "x {}: each cell has the mean height over its area, and finer roughness is lost",
                                       name, length_text(map.dx), length_text(map.dy), length_text(f_.cell[0]),
                                       length_text(f_.cell[1]))});
    }
    else if (const auto [wave_x, wave_y] = shortest_waves(map); rms_slope(map) > 0.0)
      of_waves(name, "measured heights with waves down to about", wave_x, wave_y);
  }

  void of_texture(const std::string& name, const Sinusoid& s)
  {
    of_waves(name, "waves of", s.wavelength_x, s.wavelength_y);
  }
  void of_texture(const std::string& name, const RandomSurface& surface)
  {
    of_waves(name, "roughness with waves down to", surface.parameters().cutoff, surface.parameters().cutoff);
  }

  /// Warns for the axis with fewer cells per wave.
  void of_waves(const std::string& name, const char* what, double wavelength_x, double wavelength_y)
  {
    const double cells_x = wavelength_x / f_.cell[0], cells_y = wavelength_y / f_.cell[1];
    const double cells = std::min(cells_x, cells_y);
    if (!(cells < 0.999 * fewest_cells_of_wave))
      return;
    is_lost_ = is_lost_ || cells < lost_share * fewest_cells_of_wave;
    warnings_.push_back(
        {"coarse_texture",
         fmt::format("{}: {} {} are not resolved by cells of {}{}; at least {:g} cells per shortest wave are needed "
                     "for contact area and peak pressure",
                     name, what, length_text(cells_x < cells_y ? wavelength_x : wavelength_y),
                     length_text(cells_x < cells_y ? f_.cell[0] : f_.cell[1]),
                     cells < 2.0 ? ": only the mean over each cell counts" : "", fewest_cells_of_wave)});
  }

  const Facts& f_;
  std::vector<Warning>& warnings_;
  bool is_lost_ = false;
};

} // namespace

bool warn_of_textures(const Facts& facts, std::vector<Warning>& warnings)
{
  return OfTextures(facts, warnings).tell();
}

} // namespace brinell::quality
