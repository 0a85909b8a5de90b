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

/// Textures of surfaces, fixed to the material of the bodies: dents, waves, roughness, measured heights.
/// docs/theory/simulation.md (roughness)
namespace brinell::simulation
{

/// A round dent with a shoulder, depth * 10^(-10 (r/w)^2) cos(2 pi r/w) with w = 4 edge_radius, as often used for rolling over
/// dents (Lubrecht, Venner; Ville and Nelias 1999). It crosses the undisturbed surface at the edge radius, has half of its depth
/// at half of that radius, and the crest of its shoulder, 4 % of the depth high, at 1.26 times that radius. Negative
/// depth: a bump.
struct Dent
{
  double x = 0.0, y = 0.0;  ///< centre on the body's surface [m]
  double depth = 0.0;       ///< [m]
  double edge_radius = 0.0; ///< where it crosses the undisturbed surface [m], > 0

  [[nodiscard]] double wavelength() const { return 4.0 * edge_radius; } ///< w [m]
  bool operator==(const Dent&) const = default;
};

/// Heights on a grid, interpolated linearly between its points; outside the grid they are zero, or repeat periodically.
struct HeightMap
{
  int nx = 0, ny = 0;            ///< points, x runs fastest
  double dx = 0.0, dy = 0.0;     ///< [m]
  double x = 0.0, y = 0.0;       ///< centre on the body's surface [m]
  std::vector<double> heights{}; ///< positive out of the body [m]
  bool periodic = false;         ///< the map covers the plane, with the periods nx dx and ny dy
  bool operator==(const HeightMap&) const = default;
};

/// Root mean square of the slopes between neighbouring points; 0 without neighbours.
[[nodiscard]] double rms_slope(const HeightMap& map);

/// The shortest wavelengths along x and y that carry more than 2 % of the mean square curvature [m], at least two
/// points; so noise far below the roughness does not count. Infinite where the map is straight.
[[nodiscard]] std::array<double, 2> shortest_waves(const HeightMap& map);

/// Waves on the whole surface: the height amplitude * cos(2 pi (X - x)/wavelength_x) cos(2 pi (Y - y)/wavelength_y) at (X, Y).
/// Along an axis of infinite wavelength there are no waves, and the cosine is 1.
struct Sinusoid
{
  double amplitude = 0.0; ///< from the mean to a crest [m]
  double wavelength_x = std::numeric_limits<double>::infinity(),
         wavelength_y = std::numeric_limits<double>::infinity(); ///< [m], > 0
  double x = 0.0, y = 0.0;                                       ///< position of a crest [m]
  bool operator==(const Sinusoid&) const = default;
};

/// Parameters of an isotropic self-affine surface. Its power spectral density falls with the wavenumber as q^(-2 (1 + hurst))
/// from the wavelength `rolloff` to `cutoff`; it is constant for longer waves up to the size, and zero for waves shorter than the
/// cutoff.
struct SelfAffine
{
  double hurst = 0.8;                 ///< Hurst exponent, 0 to 1
  std::optional<double> rms_height{}; ///< root mean square of the height [m] over a period; or
  std::optional<double> rms_slope{};  ///< root mean square of the gradient's magnitude [-]: exactly one of both
  double rolloff = std::numeric_limits<double>::infinity(); ///< [m], >= cutoff; from the size on: no roll-off
  double cutoff = 0.0;                                      ///< [m], > 0, not longer than the size
  double size_x = 0.0, size_y = 0.0;                        ///< period, and longest wave [m]
  std::uint64_t seed = 0; ///< different seeds give different surfaces with the same spectrum
  bool operator==(const SelfAffine&) const = default;
};

/// A Gaussian random surface with the spectrum of `SelfAffine`: a sum of waves with wavevectors (2 pi i/size_x, 2 pi j/size_y)
/// and normally distributed complex amplitudes, scaled so that the rms over a period is exactly the given one. The random numbers
/// of each wave depend on nothing but seed and wave, not on cells, other parameters, machine or libraries: finer cells see the
/// same surface, and a shorter cutoff only adds waves. The amplitudes are computed once; copies share them.
class RandomSurface
{
public:
  struct Waves;

  /// @throws InputError if parameters are out of range
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

/// A texture is the sum of its parts; without parts the surface is smooth. It is fixed to the material and moves with it through
/// the contact, whereas the shape stays with the contact.
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

/// Depth of the surface at (x, y), positive into the body [m]. For a random surface this sums over all waves; on a grid use
/// `depths`.
[[nodiscard]] double depth(const Texture& texture, double x, double y);
/// Depth of the texture for a cell of dx by dy around (x, y) [m]: the depth at its centre, or the mean over the cell if the
/// texture is finer than the cells, so that no detail between the centres is lost. Waves shorter than two cells count as finer.
[[nodiscard]] double cell_depth(const Texture& texture, double x, double y, double dx, double dy);

/// `depth` and `cell_depth` for all cells of a grid, whose cell (0, 0) has its centre at (x0, y0) [m].
[[nodiscard]] std::vector<double> depths(const Texture& texture, const SurfaceGrid& grid, double x0, double y0);
[[nodiscard]] std::vector<double> cell_depths(const Texture& texture, const SurfaceGrid& grid, double x0, double y0);

/// Whether the texture repeats with the periods size_x along x and size_y along y [m].
[[nodiscard]] bool is_periodic(const Texture& texture, double size_x, double size_y);
/// Why the texture does not repeat, for messages: "texture[1]: a dent does not repeat", with a number only if there are several
/// parts; empty if it repeats.
[[nodiscard]] std::optional<std::string> reason_against_period(const Texture& texture, double size_x, double size_y);

/// Bounds on the extent of a texture.
struct TextureReach
{
  double height = 0.0; ///< largest height above the smooth surface [m]
  double half_width_y =
      0.0; ///< along y from the middle of the body's surface [m]; infinite if the texture covers the plane
};
[[nodiscard]] TextureReach reach(const Texture& texture);

/// Samples a function of x and y as a height map. Unlike a function, sampled heights can be stored with a result, compared, and
/// read by another process that resumes the run.
/// @param height  at a point of the body's surface, positive out of the body [m].
/// @param nx, ny  numbers of points; dx, dy their distances [m]: as fine as the cells, or finer.
/// @param x, y  centre of the map on the body's surface [m]; outside the map the surface is smooth.
/// @throws InputError if there are no points, or if a height is not finite
[[nodiscard]] HeightMap sampled(const std::function<double(double x, double y)>& height, int nx, int ny, double dx,
                                double dy, double x = 0.0, double y = 0.0);

} // namespace brinell::simulation
