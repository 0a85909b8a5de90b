// SPDX-License-Identifier: BSD-3-Clause
#include "records.hpp"

#include "brinell/foundation/error.hpp"
#include "brinell/simulation/indentation.hpp"
#include "brinell/simulation/rolling.hpp"
#include "brinell/simulation/tugging.hpp"

#include <array>
#include <fmt/format.h>
#include <limits>

namespace brinell::simulation
{

void take_totals(const StepRecord& last, double largest_work, RunTotals& totals)
{
  totals.work = last.work;
  totals.dissipation_lower = last.dissipation_lower;
  totals.dissipation_upper = last.dissipation_upper;
  totals.energy_residual = last.energy_residual;
  totals.energy_elastic = last.energy_elastic;
  if (largest_work > 0.0)
    totals.energy_balance_error =
        (last.work - last.dissipation_lower - last.dissipation_upper - last.energy_residual - last.energy_elastic) /
        largest_work;
  totals.max_residual_lower = last.max_residual_lower;
  totals.max_residual_upper = last.max_residual_upper;
  totals.max_equivalent_plastic_strain = last.max_equivalent_plastic_strain;
  totals.coverage = last.coverage;
}

void Coverage::exchange(Archive& archive)
{
  archive("contact_columns", contact_columns);
  archive("contact_rows", contact_rows);
  archive("plastic_layers", plastic_layers);
}

void StepRecord::exchange(Archive& archive)
{
  archive("step", step, 0, std::numeric_limits<int>::max() - 1);
  archive("pass", pass, 0, std::numeric_limits<int>::max() - 1);
  archive("contact_area", contact_area);
  archive("max_pressure", max_pressure);
  archive("F_n", F_n);
  archive("work", work);
  archive("dissipation_lower", dissipation_lower);
  archive("dissipation_upper", dissipation_upper);
  archive("energy_residual", energy_residual);
  archive("energy_elastic", energy_elastic);
  archive("max_residual_lower", max_residual_lower);
  archive("max_residual_upper", max_residual_upper);
  archive("max_equivalent_plastic_strain", max_equivalent_plastic_strain);
  archive("iterations", iterations);
  archive("coverage", coverage);
}

void GridChange::exchange(Archive& archive)
{
  archive("step", step);
  int code = static_cast<int>(extent);
  archive("extent", code, 0, static_cast<int>(Extent::upper_layers));
  extent = static_cast<Extent>(code);
  archive("before", before);
  archive("after", after);
}

namespace
{

struct ExtentText
{
  const char *name, *grows, *unit;
};

/// In the order of GridChange::Extent.
constexpr std::array extents{
    ExtentText{"contact_columns", "the grid of the contact grows", "columns"},
    ExtentText{"rows", "all grids grow", "rows"},
    ExtentText{"lower_columns", "the grid of the lower body grows", "columns"},
    ExtentText{"upper_columns", "the grid of the upper body grows", "columns"},
    ExtentText{"lower_layers", "the grid of the lower body grows", "layers"},
    ExtentText{"upper_layers", "the grid of the upper body grows", "layers"},
};

} // namespace

const char* extent_name(GridChange::Extent extent)
{
  return extents.at(static_cast<std::size_t>(extent)).name;
}

std::string text(const GridChange& change)
{
  const ExtentText& e = extents.at(static_cast<std::size_t>(change.extent));
  return fmt::format("step {}: {} from {} to {} {}", change.step, e.grows, change.before, change.after, e.unit);
}

void TuggingRecord::exchange(Archive& archive)
{
  StepRecord::exchange(archive);
  archive("X", X);
  archive("theta", theta);
  archive("interference", interference);
  archive("height", height);
  archive("F_X", F_X);
  archive("F_Y", F_Y);
  archive("F_Z", F_Z);
  archive("F_X_macro", F_X_macro);
  archive("F_Z_macro", F_Z_macro);
  archive("F_X_lower", F_X_lower);
  archive("F_X_upper", F_X_upper);
}

void TuggingPeaks::exchange(Archive& archive)
{
  archive("peak_F_X", peak_F_X);
  archive("X_at_peak_F_X", X_at_peak_F_X);
  archive("min_F_X", min_F_X);
  archive("peak_F_Z", peak_F_Z);
  archive("F_X_aligned", F_X_aligned);
  archive("F_Z_aligned", F_Z_aligned);
  archive("load_ratio_aligned", load_ratio_aligned);
  archive("load_ratio_end", load_ratio_end);
  archive("work_to_alignment", work_to_alignment);
}

void IndentationRecord::exchange(Archive& archive)
{
  StepRecord::exchange(archive);
  archive("place", place);
  archive("x", x);
  archive("approach", approach);
  archive("contact_radius", contact_radius);
  archive("mean_pressure", mean_pressure);
  archive("residual_depth", residual_depth);
  archive("pile_up", pile_up);
}

void Indent::exchange(Archive& archive)
{
  archive("place", place);
  archive("cycle", cycle);
  archive("x", x);
  archive("max_load", max_load);
  archive("max_approach", max_approach);
  archive("contact_area", contact_area);
  archive("hardness", hardness);
  archive("loading_stiffness", loading_stiffness);
  archive("unloading_stiffness", unloading_stiffness);
  archive("final_approach", final_approach);
  archive("residual_depth", residual_depth);
  archive("pile_up", pile_up);
  archive("work", work);
}

void RollingRecord::exchange(Archive& archive)
{
  StepRecord::exchange(archive);
  archive("x", x);
  archive("approach", approach);
  archive("F_X", F_X);
}

void RollingPass::exchange(Archive& archive)
{
  archive("rut_depth", rut_depth);
  archive("shoulder_height", shoulder_height);
  archive("max_equivalent_plastic_strain", max_equivalent_plastic_strain);
  archive("track_plastic_strain", track_plastic_strain);
  archive("track_plastic_increment", track_plastic_increment);
  archive("dissipation", dissipation);
  archive("resistance", resistance);
  archive("unsteadiness", unsteadiness);
  archive("mean_F_X", mean_F_X);
  archive("max_pressure", max_pressure);
}

} // namespace brinell::simulation
