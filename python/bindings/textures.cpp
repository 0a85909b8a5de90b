// SPDX-License-Identifier: BSD-3-Clause
#include "arrays.hpp"
#include "module.hpp"

#include "brinell/io/height_file.hpp"
#include "brinell/io/printable.hpp"
#include "brinell/io/units.hpp"
#include "brinell/simulation/bearing.hpp"
#include "brinell/simulation/filling.hpp"
#include "brinell/simulation/texture.hpp"

#include <nanobind/stl/array.h>
#include <nanobind/stl/filesystem.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/tuple.h>

#include <algorithm>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <tuple>
#include <vector>

namespace brinell::python
{

using namespace nb::literals;

namespace
{

/// Heights of a random surface, [y, x], at nx * ny points around its origin whose distances divide the size.
Output random_heights(const std::tuple<double, double>& size, const std::tuple<int, int>& points, double cutoff,
                      const std::optional<double>& rms_height, const std::optional<double>& rms_slope, double hurst,
                      const std::optional<double>& rolloff, std::uint64_t seed)
{
  const auto [size_x, size_y] = size;
  const auto [nx, ny] = points;
  constexpr int most = 1 << 15;
  if (nx < 1 || ny < 1 || nx > most || ny > most)
    throw InputError(fmt::format("{} x {} points; allowed: 1 to {} along either axis", nx, ny, most));
  const simulation::SelfAffine parameters{.hurst = hurst,
                                          .rms_height = rms_height,
                                          .rms_slope = rms_slope,
                                          .rolloff = rolloff.value_or(std::numeric_limits<double>::infinity()),
                                          .cutoff = cutoff,
                                          .size_x = size_x,
                                          .size_y = size_y,
                                          .seed = seed};
  const SurfaceGrid grid{nx, ny, size_x / nx, size_y / ny};
  std::vector<double> heights = without_lock(
      [&]
      {
        const simulation::Texture surface = simulation::RandomSurface(parameters);
        std::vector<double> h = simulation::depths(surface, grid, grid.x(0), grid.y(0));
        for (double& height : h)
          height = -height;
        return h;
      });
  return array(std::move(heights), {static_cast<std::size_t>(ny), static_cast<std::size_t>(nx)});
}

/// Sk, Spk, Svk, Smr1 and Smr2 of the heights of a map, [y, x].
auto bearing(const Input& heights)
{
  const auto given = std::span(heights.data(), heights.size());
  const simulation::Bearing b =
      without_lock([&] { return simulation::bearing_of(std::vector<double>(given.begin(), given.end())); });
  return std::tuple{b.core_height, b.peak_height, b.valley_depth, b.peak_share, b.valley_share};
}

/// "3.85 mm" in m.
double length(const std::string& text)
{
  io::Quantity quantity;
  try
  {
    quantity = io::quantity(text);
  }
  catch (const InputError& error)
  {
    throw InputError(fmt::format("\"{}\" {}", text, error.what()));
  }
  if (quantity.dimension == io::dimension::none)
    throw InputError(fmt::format("\"{}\" has no unit; allowed: a length with its unit, as \"3.85 mm\"", text));
  if (!(quantity.dimension == io::dimension::length))
    throw InputError(
        fmt::format("\"{}\" is a {}; allowed: a length, as \"3.85 mm\"", text, io::dimension_name(quantity.dimension)));
  return quantity.value;
}

/// Contents of a text file of heights, or the reason why it is none.
struct HeightText
{
  io::HeightFile file;
  std::optional<std::string> refusal;
};

HeightText height_text(const std::filesystem::path& path, const std::optional<std::string>& unit,
                       const std::optional<std::string>& layout)
try
{
  const auto kind = layout ? io::height_layout(*layout) : io::HeightLayout::automatic;
  return {without_lock([&] { return io::read_height_text(path, {.unit = unit, .layout = kind}); }), std::nullopt};
}
catch (const io::NoHeightText& error)
{
  return {{}, io::printable(error.what())};
}

Output filled(const Input& heights)
{
  std::vector<double> values(heights.data(), heights.data() + heights.size());
  const std::size_t ny = heights.shape(0), nx = heights.shape(1);
  return array(without_lock([&] { return simulation::filled(std::move(values), nx); }), {ny, nx});
}

} // namespace

void bind_textures(nb::module_& m)
{
  m.def("random_heights", &random_heights, "size"_a, "points"_a, "cutoff"_a, "rms_height"_a.none(),
        "rms_slope"_a.none(), "hurst"_a, "rolloff"_a.none(), "seed"_a);
  m.def("bearing", &bearing, "heights"_a);
  m.def("length", &length, "text"_a);
  m.def("with_plain_signs", &io::with_plain_signs, "text"_a);
  nb::class_<HeightText>(m, "HeightText")
      .def_ro("refusal", &HeightText::refusal)
      .def_prop_ro(
          "heights",
          [](const HeightText& text)
          {
            const io::HeightTable& table = text.file.table;
            return array(std::vector<double>(table.heights),
                         {table.heights.size() / std::max<std::size_t>(table.columns, 1), table.columns});
          },
          nb::rv_policy::automatic)
      .def_prop_ro("spacing", [](const HeightText& text) { return text.file.spacing; })
      .def_prop_ro("x", [](const HeightText& text) { return text.file.x; })
      .def_prop_ro("y", [](const HeightText& text) { return text.file.y; })
      .def_prop_ro("periodic", [](const HeightText& text) { return text.file.periodic; })
      .def_prop_ro("gaps", [](const HeightText& text) { return text.file.gaps; })
      .def_prop_ro("first_gap", [](const HeightText& text) { return text.file.first_gap; });
  m.def("height_text", &height_text, "file"_a, "unit"_a.none(), "layout"_a.none());
  m.def("filled", &filled, "heights"_a);
}

} // namespace brinell::python
