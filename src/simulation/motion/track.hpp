// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/simulation/rolling.hpp"
#include "column_statistics.hpp"

namespace brinell::simulation
{

/// Evaluates each pass at the middle of the track.
class TrackReader
{
public:
  /// @param distance  length of the track [m]
  /// @param shift     from record to record [m]
  TrackReader(double distance, double shift);

  void begin_pass(const elastoplastic::Body& lower);
  void add(const RollingRecord& before, const RollingRecord& record);
  [[nodiscard]] RollingPass end_pass(const elastoplastic::CoupledContact& pair) const;

  void exchange(Archive& archive);

private:
  double quarter_; ///< length of a quarter of the track [m]: means are over the middle half
  /// Energy absorbed by both bodies [J] when the contact was at x [m].
  struct Uptake
  {
    double x = 0.0, energy = 0.0;
    void exchange(Archive& archive);
  };
  using Statistics = ColumnStatistics<RollingRecord>;
  void add_tangential(const RollingRecord& before, const RollingRecord& record);
  void fill_tangential(RollingPass& pass) const;

  std::vector<double> plastic_strain_; ///< equivalent plastic strain under the middle, before the pass
  Uptake first_, centre_, last_;       ///< over the middle half of the track
  Statistics whole_;                   ///< over the pass, with pressing on and lifting off
  Statistics middle_;                  ///< over the middle half of the track
  Statistics before_, after_;          ///< over the first and the second half of the last quarter of the track
  double farthest_ = 0.0;              ///< largest x of the contact in the pass [m]
};

/// Depth profile under the middle of a body's grid.
[[nodiscard]] TrackProfile track_profile(const VolumeGrid& grid, const StepFields::Within& body);

} // namespace brinell::simulation
