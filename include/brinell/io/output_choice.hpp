// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// Which part of the fields of a run is stored: the table `output` of a case.
namespace brinell::io
{

/// Bodies whose fields are stored.
enum class StoredBodies
{
  both,
  lower,
  upper
};

/// How the numbers of the fields are stored.
enum class Precision
{
  double_precision,
  single
};

/// Words of `output.fields`: all fields, those on surfaces, those within the bodies, and those on surfaces one by one. Pressure
/// and gap of the contact are always stored.
[[nodiscard]] const std::vector<std::string>& field_words();

/// Whether a field is chosen by a list of these words.
/// @param field  name of its dataset: "shear_x"
[[nodiscard]] bool chooses(const std::vector<std::string>& words, std::string_view field);

/// The part of the cells of a body that is stored.
struct StoredCells
{
  std::optional<double> depth{}; ///< of the deepest layer that is stored at least in part [m]
  /// First and last coordinate on the surface of the body [m]; equal ones choose the nearest column or row.
  std::optional<std::vector<double>> region_x{}, region_y{};
  std::optional<std::vector<double>> region_z{}; ///< first and last depth [m], of both bodies; not with `depth`
  int stride = 1;                                ///< of the columns and rows
  int stride_z = 1;                              ///< of the layers

  /// Whether all cells of the bodies are stored.
  [[nodiscard]] bool is_everything() const
  {
    return !depth && !region_x && !region_y && !region_z && stride == 1 && stride_z == 1;
  }
};

/// A point within a body at which each step records stress and strain.
struct HistoryPoint
{
  bool is_upper = false;
  double x = 0.0, y = 0.0, depth = 0.0; ///< in the coordinates of the body [m]
};

/// As the case says. Without fields, those within bodies that cannot yield are left out unless `asks_for_fields_within`, and all
/// others are stored as far as the result stays small.
struct OutputChoice
{
  std::optional<std::vector<std::string>> fields; ///< out of `field_words`
  StoredBodies bodies = StoredBodies::both;
  std::optional<Precision> precision;
  StoredCells cells;
  std::vector<HistoryPoint> points;
};

/// Whether fields within the bodies are asked for: by name, or by a part of the body that has no other fields, namely a depth, a
/// plane or a point with a history.
[[nodiscard]] bool asks_for_fields_within(const OutputChoice& choice);

/// Parts of the result that a run stores.
struct StoredParts
{
  std::vector<std::string> in_steps{"all"}, in_final{"all"}; ///< out of `field_words`
  StoredBodies bodies = StoredBodies::both;
  Precision precision = Precision::double_precision;
  StoredCells cells;
};

} // namespace brinell::io
