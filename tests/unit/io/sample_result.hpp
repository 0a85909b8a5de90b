// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/io/result_directory.hpp"
#include "brinell/io/summary_json.hpp"
#include "io/results/hdf5.hpp"
#include "sample.hpp"

#include <cmath>

/// A result made by hand, and how its files are read.
namespace brinell::io::sample
{

namespace fs = std::filesystem;

inline std::vector<double> dataset(const fs::path& file, const std::string& path, std::vector<hsize_t>* shape = nullptr)
{
  const h5::Handle h5 = h5::open_file(file);
  const h5::Handle data(H5Dopen2(h5.id(), path.c_str(), H5P_DEFAULT));
  if (data.id() < 0)
    return {};
  const h5::Handle space(H5Dget_space(data.id()));
  std::vector<double> values(static_cast<std::size_t>(H5Sget_simple_extent_npoints(space.id())));
  H5Dread(data.id(), H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data());
  if (shape)
  {
    shape->resize(static_cast<std::size_t>(H5Sget_simple_extent_ndims(space.id())));
    H5Sget_simple_extent_dims(space.id(), shape->data(), nullptr);
  }
  return values;
}

inline std::vector<double> numbers_attribute(const fs::path& file, const std::string& object, const char* name)
{
  const h5::Handle h5 = h5::open_file(file);
  const h5::Handle attribute(H5Aopen_by_name(h5.id(), object.c_str(), name, H5P_DEFAULT, H5P_DEFAULT));
  const h5::Handle space(H5Aget_space(attribute.id()));
  std::vector<double> values(static_cast<std::size_t>(H5Sget_simple_extent_npoints(space.id())));
  H5Aread(attribute.id(), H5T_NATIVE_DOUBLE, values.data());
  return values;
}

inline std::string text_attribute(const fs::path& file, const std::string& object, const char* name)
{
  const h5::Handle h5 = h5::open_file(file);
  const h5::Handle attribute(H5Aopen_by_name(h5.id(), object.c_str(), name, H5P_DEFAULT, H5P_DEFAULT));
  const h5::Handle type(H5Aget_type(attribute.id()));
  char* data = nullptr;
  H5Aread(attribute.id(), type.id(), &data);
  std::string text = data ? data : "";
  H5free_memory(data);
  return text;
}

inline std::string text_dataset(const fs::path& file, const std::string& path)
{
  const h5::Handle h5 = h5::open_file(file);
  const h5::Handle data(H5Dopen2(h5.id(), path.c_str(), H5P_DEFAULT));
  const h5::Handle type(H5Dget_type(data.id()));
  char* text = nullptr;
  H5Dread(data.id(), type.id(), H5S_ALL, H5S_ALL, H5P_DEFAULT, &text);
  std::string result = text ? text : "";
  H5free_memory(text);
  return result;
}

inline bool exists(const fs::path& file, const std::string& path)
{
  return H5Lexists(h5::open_file(file).id(), path.c_str(), H5P_DEFAULT) > 0;
}

inline simulation::TuggingSummary hand_made_summary(const Case& c)
{
  simulation::TuggingSummary s;
  s.steps = 2;
  s.final_state = snapshot();
  if (c.first_yield)
  {
    s.peak_F_X = 0.25 * c.first_yield->critical.load;
    s.work = 3.0 * c.first_yield->critical.energy;
    s.max_residual_lower = 0.5 * c.first_yield->critical.interference;
  }
  s.X_at_peak_F_X = -0.3;
  s.load_ratio_end = std::nan("");
  return s;
}

inline void write_complete(const fs::path& folder, const Case& c)
{
  ResultDirectory results(folder, c, {});
  results.add(columns(0));
  results.add(0, columns(0), fields());
  results.add(columns(1));
  const simulation::TuggingSummary summary = hand_made_summary(c);
  results.add_final(fields_of(summary.final_state), columns(1));
  results.finish(summary_text(c, simulation::TuggingPlan{}, summary, {.wall_time = 1.5, .threads = 3}));
}

} // namespace brinell::io::sample
