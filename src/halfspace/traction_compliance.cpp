// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/halfspace/traction_compliance.hpp"

#include "brinell/foundation/error.hpp"
#include "brinell/green/surface_terms.hpp"
#include "foundation/blocked_fft.hpp"
#include "foundation/sharing.hpp"
#include "parity_spectrum.hpp"
#include "require_surface.hpp"

#include <omp.h>
#include <vector>

namespace brinell::halfspace
{

namespace
{

/// Places in green::SurfaceTerms.
enum : std::size_t
{
  xx,
  yy,
  xy,
  x,
  y,
  term_count
};
constexpr std::array<Parity, term_count> parities{
    {{false, false}, {false, false}, {true, true}, {true, false}, {false, true}}};

/// The displacement along z, x and y of a pressure and the shears along x and y.
using Triple = std::array<ComplexLanes, 3>;
/// Spectra of the terms for `lane_count` wavenumbers, as their parities say.
using Terms = std::array<Lanes, term_count>;

} // namespace

struct TractionCompliance::Operator
{
  green::PairConstants constants;
  BlockedFft fft;
  int rows;                   ///< stored rows, ky >= 0
  AlignedVector<Terms> terms; ///< [block][row]

  Operator(const SurfaceGrid& grid, const green::PairConstants& pair, double reference)
      : constants(pair), fft(grid, padded_lengths(grid).x, padded_lengths(grid).y, 1), rows(fft.py() / 2 + 1),
        terms(static_cast<std::size_t>(fft.blocks()) * static_cast<std::size_t>(rows))
  {
    const PaddedFft padded(grid, fft.px(), fft.py());
    if (grid.is_periodic())
      tabulate_waves(padded);
    else
      tabulate_cells(padded, reference);
  }

  [[nodiscard]] Terms& terms_at(int row, int column)
  {
    return terms[static_cast<std::size_t>(column / lane_count) * static_cast<std::size_t>(rows) +
                 static_cast<std::size_t>(row)];
  }

  void tabulate_cells(const PaddedFft& padded, double reference)
  {
    const Quadrant<green::SurfaceTerms> response = cell_surface_terms(padded.grid(), reference);
    for (std::size_t t = 0; t < term_count; ++t)
      parity_spectrum(
          padded, parities[t], [&](int i, int j) { return response.at(i, j)[t]; },
          [&](int row, int column, double number) { terms_at(row, column)[t][column % lane_count] = number; });
  }

  void tabulate_waves(const PaddedFft& padded)
  {
    for (int row = 0; row < rows; ++row)
      for (int i = row == 0 ? 1 : 0; i < padded.kx(); ++i) // what is uniform displaces nothing
      {
        const green::SurfaceTerms value = green::surface_wave_terms(padded.wavenumber_x(i), padded.wavenumber_y(row));
        for (std::size_t t = 0; t < term_count; ++t)
        {
          // At the shortest wave of an even number of cells nothing that is odd can be told.
          const bool is_told =
              !(parities[t].odd_x && 2 * i == padded.px()) && !(parities[t].odd_y && 2 * row == padded.py());
          terms_at(row, i)[t][i % lane_count] = is_told ? value[t] : 0.0;
        }
      }
  }

  [[nodiscard]] Triple displaced(int row, const Terms& term, const Triple& load) const
  {
    const auto& [pressure, shear_x, shear_y] = load;
    const auto times = [&](std::size_t t, double factor, const ComplexLanes& value)
    { return (factor * term[t]) * parities[t].phased(row, fft.py(), value); };
    const Lanes inverse_distance = constants.normal * (term[xx] + term[yy]);
    const double along = constants.along, coupling = constants.coupling;
    return {inverse_distance * pressure + times(x, coupling, shear_x) + times(y, coupling, shear_y),
            inverse_distance * shear_x + times(xx, along, shear_x) + times(xy, along, shear_y) -
                times(x, coupling, pressure),
            inverse_distance * shear_y + times(xy, along, shear_x) + times(yy, along, shear_y) -
                times(y, coupling, pressure)};
  }

  using Scratch = std::array<BlockedFft::Scratch, 3>; ///< of one thread, for z, x and y

  /// From the rows of one block and back to them.
  void apply_to_block(int block, const std::array<bool, 3>& loaded, const std::array<bool, 3>& wanted,
                      std::array<AlignedVector<Complex>, 3>& values, Scratch& own) const
  {
    for (std::size_t d = 0; d < 3; ++d)
      if (loaded[d])
        fft.columns_forward(values[d].data(), block, 0, 1, own[d]);
    const Terms* of_block = terms.data() + static_cast<std::ptrdiff_t>(block) * rows;
    for (int row = 0; row < fft.py(); ++row)
    {
      const std::ptrdiff_t line = static_cast<std::ptrdiff_t>(row) * lane_count;
      Triple load;
      for (std::size_t d = 0; d < 3; ++d)
        if (loaded[d])
          load[d] = load_lanes(own[d].columns.data() + line);
      const Triple result = displaced(row, of_block[std::min(row, fft.py() - row)], load);
      for (std::size_t d = 0; d < 3; ++d)
        if (wanted[d])
          store_lanes(result[d], own[d].columns.data() + line);
    }
    for (std::size_t d = 0; d < 3; ++d)
      if (wanted[d])
        fft.columns_inverse(own[d], block, 0, 1, values[d].data());
  }
};

TractionCompliance::TractionCompliance(const SurfaceGrid& grid, const Elastic& body1, const Elastic& body2,
                                       double reference)
{
  if (grid.is_periodic_x() != grid.is_periodic_y() && !(reference > 0.0))
    throw InternalError("TractionCompliance: with one periodic axis the displacement needs a reference distance, > 0");
  operator_ = std::make_unique<Operator>(grid, green::pair_constants(body1, body2), reference);
}

TractionCompliance::~TractionCompliance() = default;
TractionCompliance::TractionCompliance(TractionCompliance&&) noexcept = default;
TractionCompliance& TractionCompliance::operator=(TractionCompliance&&) noexcept = default;

const SurfaceGrid& TractionCompliance::grid() const
{
  return operator_->fft.grid();
}

void TractionCompliance::apply(const SurfaceLoad& load, const SurfaceDisplacement& displacement) const
{
  require_load("TractionCompliance::apply", load, grid().size());
  require_displacement("TractionCompliance::apply", displacement, grid().size());
  const BlockedFft& fft = operator_->fft;
  const std::array<std::span<const double>, 3> in{load.pressure, load.shear_x, load.shear_y};
  const std::array<std::span<double>, 3> out{displacement.z, displacement.x, displacement.y};
  std::array<bool, 3> loaded{}, wanted{};
  std::array<AlignedVector<Complex>, 3> rows;
  for (std::size_t d = 0; d < 3; ++d)
  {
    loaded[d] = !in[d].empty();
    wanted[d] = !out[d].empty();
    if (loaded[d] || wanted[d])
      rows[d].resize(fft.rows_size());
  }
  const int threads = is_shared(grid().size()) ? omp_get_max_threads() : 1;
#pragma omp parallel num_threads(threads)
  {
    Operator::Scratch own;
    for (BlockedFft::Scratch& scratch : own)
      scratch = fft.make_scratch();
    for (std::size_t d = 0; d < 3; ++d)
    {
#pragma omp for schedule(static)
      for (int batch = 0; batch < (loaded[d] ? fft.batches() : 0); ++batch)
        fft.rows_forward(in[d].data(), 0, batch, rows[d].data(), own[d]);
    }
#pragma omp for schedule(static)
    for (int block = 0; block < fft.blocks(); ++block)
      operator_->apply_to_block(block, loaded, wanted, rows, own);
    for (std::size_t d = 0; d < 3; ++d)
    {
#pragma omp for schedule(static)
      for (int batch = 0; batch < (wanted[d] ? fft.batches() : 0); ++batch)
        fft.rows_inverse(rows[d].data(), 0, batch, out[d].data(), own[d]);
    }
  }
}

} // namespace brinell::halfspace
