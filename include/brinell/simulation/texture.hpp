// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/foundation/grid.hpp"

#include <array>
#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

/// What lies on the surfaces of bodies, fixed to their material: dents, waves, roughness, measured heights.
/// docs/theory/simulation.md (roughness)
namespace brinell::simulation
{

/// A round dent with a shoulder, depth * 10^(-10 (r/radius)^2) cos(2 pi r/radius), as often used for rolling over dents
/// (Lubrecht, Venner; Ville and Nelias 1999). Negative depth: a bump.
struct Dent
{
  double x = 0.0, y = 0.0; ///< centre on the body's surface [m]
  double depth = 0.0;      ///< [m]
  double radius = 0.0;     ///< [m], > 0; the dent itself reaches to a quarter of it
  bool operator==(const Dent&) const = default;
};

/// Heights on a grid, linear between its points; outside, zero or the same again.
struct HeightMap
{
  int nx = 0, ny = 0;            ///< points, x runs fastest
  double dx = 0.0, dy = 0.0;     ///< [m]
  double x = 0.0, y = 0.0;       ///< centre on the body's surface [m]
  std::vector<double> heights{}; ///< out of the body positive [m]
  bool periodic = false;         ///< the map covers the plane, with the periods nx dx and ny dy
  bool operator==(const HeightMap&) const = default;
};

/// Root mean square of the slopes between neighbouring points; 0 without neighbours.
[[nodiscard]] double rms_slope(const HeightMap& map);

/// Wavelengths along x and y that the height's second differences have over its first ones [m]: that of waves of one length, and
/// near the shortest of a roughness; two points at least. Infinite where the map is straight.
[[nodiscard]] std::array<double, 2> shortest_waves(const HeightMap& map);

/// Waves on the whole surface: the height amplitude * cos(2 pi (X - x)/wavelength_x) cos(2 pi (Y - y)/wavelength_y) at (X, Y).
/// Along an axis of infinite wavelength there are none, and its cosine is 1.
struct Sinusoid
{
  double amplitude = 0.0; ///< from the mean to a crest [m]
  double wavelength_x = std::numeric_limits<double>::infinity(),
         wavelength_y = std::numeric_limits<double>::infinity(); ///< [m], > 0
  double x = 0.0, y = 0.0;                                       ///< a crest [m]
  bool operator==(const Sinusoid&) const = default;
};

/// A self-affine surface in numbers. Its power spectral density falls as q^(-2 (1 + hurst)) from the wavelength `rolloff` to
/// `cutoff`, is constant for longer waves up to the size, and zero for shorter ones. It is isotropic.
struct SelfAffine
{
  double hurst = 0.8;                                       ///< exponent of Hurst, 0 to 1
  std::optional<double> rms_height{};                       ///< root mean square of the height [m] over a period; or
  std::optional<double> rms_slope{};                        ///< that of the gradient's length [-]: one of the two
  double rolloff = std::numeric_limits<double>::infinity(); ///< [m], >= cutoff; from the size on: no roll-off
  double cutoff = 0.0;                                      ///< [m], > 0, not longer than the size
  double size_x = 0.0, size_y = 0.0;                        ///< period, and longest wave [m]
  std::uint64_t seed = 0;                                   ///< other seeds give other surfaces with the same spectrum
  bool operator==(const SelfAffine&) const = default;
};

/// A Gaussian surface with the spectrum of `SelfAffine`: a sum of the waves of its period (2 pi i/size_x, 2 pi j/size_y) whose
/// complex amplitudes are normal, scaled so that the rms over a period is the given one, exactly. Every wave has its own
/// random numbers, whatever the cells, the other parameters, the machine and the libraries: finer cells see the same surface,
/// and a shorter cutoff adds waves to it. Made once; copies share the amplitudes.
class RandomSurface
{
public:
  struct Waves;

  /// @throws InputError of parameters out of range
  explicit RandomSurface(const SelfAffine& parameters);

  [[nodiscard]] const SelfAffine& parameters() const { return parameters_; }
  [[nodiscard]] double rms_height() const { return rms_height_; } ///< [m]
  [[nodiscard]] double rms_slope() const { return rms_slope_; }
  [[nodiscard]] const Waves& waves() const { return *waves_; }
  bool operator==(const RandomSurface& other) const { return parameters_ == other.parameters_; }

private:
  SelfAffine parameters_;
  std::shared_ptr<const Waves> waves_;
  double rms_height_ = 0.0, rms_slope_ = 0.0;
};

using TexturePart = std::variant<Dent, HeightMap, Sinusoid, RandomSurface>;

/// The sum of its parts; smooth without any. Fixed to the material, where the shape stays with the contact.
struct Texture
{
  std::vector<TexturePart> parts{};

  Texture() = default;
  // Not explicit: a texture mostly has one part.
  Texture(const Dent& part) : parts{part} {}
  Texture(HeightMap part) : parts{std::move(part)} {}
  Texture(const Sinusoid& part) : parts{part} {}
  Texture(RandomSurface part) : parts{std::move(part)} {}
  Texture(std::vector<TexturePart> sum) : parts(std::move(sum)) {}

  [[nodiscard]] bool is_smooth() const { return parts.empty(); }
  bool operator==(const Texture&) const = default;
};

/// Depth into the body of its surface at (x, y) [m]. For a random surface the sum over all of its waves: on a grid take
/// `depths`.
[[nodiscard]] double depth(const Texture& texture, double x, double y);
/// What a cell of dx by dy around (x, y) has of it [m]: the depth at its centre, or the mean over it if the texture is finer
/// than the cells, so that nothing falls between their centres. Waves are finer if they are shorter than two cells.
[[nodiscard]] double cell_depth(const Texture& texture, double x, double y, double dx, double dy);

/// The same at all cells of a grid, whose cell (0, 0) has its centre at (x0, y0).
[[nodiscard]] std::vector<double> depths(const Texture& texture, const SurfaceGrid& grid, double x0, double y0);
[[nodiscard]] std::vector<double> cell_depths(const Texture& texture, const SurfaceGrid& grid, double x0, double y0);

/// Whether the texture is the same again after size_x along x and after size_y along y [m].
[[nodiscard]] bool is_periodic(const Texture& texture, double size_x, double size_y);
/// What a body is told whose texture is not: "texture[1]: a dent does not repeat", the number only of several parts.
[[nodiscard]] std::optional<std::string> reason_against_period(const Texture& texture, double size_x, double size_y);

/// What a texture can add to its body at most.
struct TextureReach
{
  double height = 0.0;       ///< above the smooth surface [m]
  double half_width_y = 0.0; ///< from the middle of the body's surface [m]; infinite where it covers the plane
};
[[nodiscard]] TextureReach reach(const Texture& texture);

/// A texture from a function of x and y: its heights on a grid of points, out of the body positive. A function itself could be
/// neither stored with a result nor compared nor taken up by another process; its heights can, and so can the run.
/// @param height  at a place on the body's surface [m].
/// @param nx, ny  points; dx, dy their distances [m]: as fine as the cells, or finer.
/// @param x, y  centre of the map on the body's surface [m]; outside it the surface is smooth.
/// @throws InputError without points, or if the function gives a height that is not finite
[[nodiscard]] HeightMap sampled(const std::function<double(double x, double y)>& height, int nx, int ny, double dx,
                                double dy, double x = 0.0, double y = 0.0);

} // namespace brinell::simulation
