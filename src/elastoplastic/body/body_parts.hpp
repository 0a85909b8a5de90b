// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/elastoplastic/body.hpp"
#include "evaluation.hpp"

/// Functions of several parts of a body.
namespace brinell::elastoplastic
{

/// Plastic flow in all active cells.
void flow(BodyParts& body, Integration integration);
/// Computes the images g(q) of the trials from the stress of the evaluation.
/// @returns the largest von Mises norm of g - q over the yield stress, among the cells that yield
[[nodiscard]] double map_trials(BodyParts& body);
/// Moves the trials of the active cells from `first` on, which have not been evaluated yet, to the nearest stress of the yield
/// surface. Without plastic strain this is the stress of the material law; g - q, the excess of the stress over it, is then the
/// residual that belongs to the evaluation that found the cells. A trial of g would have no residual there but one in the next
/// evaluation, at the same trial, and the difference of the two would mislead the acceleration.
void put_on_yield_surface(BodyParts& body, std::size_t first);
/// Adds cells to the active set.
/// @param q_field   on the whole grid, read `shift` columns to the left of each cell; cells without a value there are not added
/// @param fraction  of the yield stress above which a cell is active; negative: every cell
void collect_active(BodyParts& body, const std::vector<double>& q_field, int shift, double fraction);
/// Copies the stress of the independent rows to their mirror images.
void complete_stress(BodyParts& body);
/// Stores the q of the active cells, with their mirror images, as the guess for the next increment.
void store_guess(BodyParts& body);
/// Recovers the guess from the fields, for instance of a checkpoint: guessed cells are those whose q differs from the stress.
void recover_guess(BodyParts& body);

/// Locked-in elastic energy [J].
/// @param zone  contains all cells with plastic strain
[[nodiscard]] double locked_in_energy(const BodyParts& body, const halfspace::SurfaceLoad& load,
                                      const PlasticZone& zone);
/// Of a body that ranks share: gives the active cells that were added last their places among those of all ranks.
/// @param added  number of them in each own layer
void number_active_cells(BodyParts& body, const std::vector<double>& added);
/// Values of the active cells of all ranks in the order of their places.
[[nodiscard]] std::vector<double> in_order(const BodyParts& body, std::span<const double> of_own_cells);
/// Sum over copies times dissipation of the active cells, added to `sum` one after the other.
[[nodiscard]] double with_dissipation(const BodyParts& body, double sum, double volume);
/// Sum of term(cell) over the plastic zone of all ranks, as by sum_of_pieces over the cells of the whole body.
/// @param piece  cells of a piece
[[nodiscard]] double sum_over_zone(const BodyParts& body, const PlasticZone& zone, std::size_t piece,
                                   const std::function<double(std::size_t)>& term);
/// The layers of all ranks of a field, for the first rank; empty for the others.
[[nodiscard]] std::vector<double> gathered(const BodyParts& body, std::span<const double> own_field);

/// Of a body on a device: counterparts of Body::begin, integrate and update, from the flow on.
void begin_on_device(BodyParts& body, int shift, double fraction, bool from_stress);
[[nodiscard]] double integrate_on_device(BodyParts& body, Integration integration);
[[nodiscard]] bool update_on_device(BodyParts& body, const halfspace::SurfaceLoad& load);
/// Puts the body on the device of its settings.
void put_on_device(BodyParts& body);
/// Copies the active cells of a trial, and their strain, from the device.
void read_active(BodyParts& body);

/// Work of the thermal stress on the plastic strain of the present increment, by the trapezoidal rule [J].
[[nodiscard]] double thermal_work_of_trial(const BodyParts& body);

} // namespace brinell::elastoplastic
