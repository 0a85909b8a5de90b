// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/simulation/scenario.hpp"
#include "stepper.hpp"
#include "stress_samples.hpp"

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace brinell::simulation
{

/// Follows the stress of each cell of one body over a cycle. Cells are material points: the grid belongs to the body, and the contact
/// moves over it. Of each step the columns near the contact are kept.
class FatigueOfBody
{
public:
  FatigueOfBody(const ShapedBody& body, std::size_t side);

  /// Takes over the state after a step.
  /// @param cycle  a change begins a new one
  void add(int cycle, const Stepper::Present& present);

  [[nodiscard]] const FatigueFields& fields() const { return result().fields; }
  [[nodiscard]] const FatigueSummary& summary() const { return result().summary; }
  [[nodiscard]] bool has_criterion() const { return fatigue_.criterion != constitutive::Fatigue::Criterion::none; }

  void exchange(Archive& archive);

private:
  struct Result
  {
    FatigueFields fields;
    FatigueSummary summary;
  };
  /// Columns [first, end).
  struct Columns
  {
    int first, end;
  };
  /// The state that an elastic body had under a pressure, which the next steps may share.
  struct Computed
  {
    std::vector<double> pressure, shear_x, shear_y;
    int column = 0; ///< of the contact grid
    double fraction = 0.0;
    int first = 0, count = 0; ///< columns of the sample
    std::vector<float> values;
  };

  [[nodiscard]] Sample untouched(const VolumeGrid& grid) const;
  void resize(const VolumeGrid& grid, double x0);
  void begin_cycle(int cycle);
  [[nodiscard]] std::optional<Columns> pressed_columns(const Stepper::Present& present) const;
  void take_sample(const Stepper::Present& present, Columns columns);
  [[nodiscard]] bool take_shared(const Stepper::Present& present, Columns columns);
  void follow_strain(const elastoplastic::BodyView& view);

  [[nodiscard]] const Result& result() const;
  struct Lanes;
  void gather(int strip, int first_column, Lanes& lanes) const;
  void judge_strip(int strip, const constitutive::FatigueCriterion& criterion, Lanes& lanes, FatigueFields& fields,
                   std::span<float> slack) const;
  void judge_strain(int strip, FatigueFields& fields) const;
  struct Candidate
  {
    double bound;
    int strip, column;
  };
  [[nodiscard]] std::vector<Candidate> candidates(bool on_planes, const std::vector<float>& slack,
                                                  FatigueFields& fields) const;
  double settle(std::vector<Candidate> cells, double share, const constitutive::FatigueCriterion& criterion,
                FatigueFields& fields) const;
  [[nodiscard]] double exact_utilisation(int strip, int column, const constitutive::FatigueCriterion& criterion) const;
  void copy_to_mirror_images(FatigueFields& fields) const;
  void summarise(Result& result) const;
  void find_life(Result& result) const;
  /// Strips within the layers on the body, which come first and are not judged: the constants are those of the substrate.
  [[nodiscard]] int strips_of_coats() const;
  [[nodiscard]] std::optional<Columns> passed_columns() const;
  [[nodiscard]] Columns judged_columns() const;

  const ShapedBody& body_;
  std::size_t side_;
  constitutive::Fatigue fatigue_;
  double shear_modulus_, yield_strain_;
  int numbers_;
  VolumeGrid grid_{};
  double x0_ = 0.0;
  bool turns_ = false; ///< the strain is that of a body of which this one is the mirror image in x
  StressSamples samples_;
  Computed computed_;
  std::vector<float> equivalent_, strain_;             ///< [cell], [cell][component], independent rows
  std::vector<float> first_equivalent_, first_strain_; ///< when the cycle began
  double shared_error_ = 0.0;                          ///< because steps share a sample [Pa]
  int cycle_ = 0;
  double first_x_ = 0.0, last_x_ = 0.0;  ///< least and largest position of the contact in the cycle [m]
  double half_ = 0.0;                    ///< largest half-length of the contact in the cycle [m]
  double most_pressure_ = 0.0;           ///< in the cycle [Pa]
  mutable std::optional<Result> result_; ///< of the present state
};

/// Layers of cells with their centres in the layers on a body.
[[nodiscard]] int layers_of_coats(const constitutive::Material& material, const VolumeGrid& grid);

/// Whether the fatigue of a body is computed.
[[nodiscard]] bool follows_fatigue(const ShapedBody& body);

/// The fatigue of the bodies of a run that ask for it.
class FatigueRecorder
{
public:
  FatigueRecorder(const ShapedBody& lower, const ShapedBody& upper);

  [[nodiscard]] bool is_wanted() const { return bodies_[0] || bodies_[1]; }
  /// Takes over the state after a step.
  void add(int cycle, const Stepper::Present& present);
  /// Adds the fields of fatigue to those of the state.
  void attach(StepFields& fields) const;
  [[nodiscard]] std::array<std::optional<FatigueSummary>, 2> summaries() const;
  void exchange(Archive& archive);

private:
  std::array<std::optional<FatigueOfBody>, 2> bodies_;
};

} // namespace brinell::simulation
