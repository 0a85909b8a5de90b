// SPDX-License-Identifier: BSD-3-Clause
#include "mirrored_fft.hpp"

#include "foundation/blocked_fft.hpp"
#include "foundation/lane_functions.hpp"

#include <algorithm>

namespace brinell::halfspace
{

namespace
{

ComplexLanes times(const Complex& f, const ComplexLanes& a)
{
  return {f.real() * a.re - f.imag() * a.im, f.real() * a.im + f.imag() * a.re};
}

} // namespace

MirroredFft::MirroredFft(const VolumeGrid& grid, int px, int py)
    : grid_(grid), half_((grid.surface.ny + 1) / 2), rows_(grid.surface.nx, px), columns_(py),
      phase_(phases_of_mirror(grid.surface.ny, py))
{
}

std::size_t MirroredFft::rows_size() const
{
  return static_cast<std::size_t>(rows_.blocks() * planes_of_group * groups(grid_.nz)) *
         static_cast<std::size_t>(rows());
}

MirroredFft::Plane MirroredFft::plane(int number, int layers)
{
  const int first = number / planes_of_group * layers_of_group;
  const int place = number % planes_of_group;
  const auto part = [&](int layer, int component) { return layer < layers ? Part{layer, component} : Part{}; };
  if (place == planes_of_group - 1)
    return {part(first, Deviator::xz), part(first + 1, Deviator::xz), true};
  const int layer = first + place / 2;
  if (place % 2 == 0)
    return {part(layer, Deviator::xx), part(layer, Deviator::xy), false};
  return {part(layer, Deviator::yy), part(layer, Deviator::yz), false};
}

MirroredFft::Scratch MirroredFft::make_scratch() const
{
  const auto plane = static_cast<std::size_t>(rows());
  const auto length = static_cast<std::size_t>(py());
  return {rows_.make_work(),
          AlignedVector<ComplexLanes>(columns_.work_size()),
          AlignedVector<double>(plane * static_cast<std::size_t>(grid_.surface.nx)),
          AlignedVector<ComplexLanes>(plane * static_cast<std::size_t>(rows_.blocks())),
          AlignedVector<ComplexLanes>(plane),
          AlignedVector<ComplexLanes>(length),
          {AlignedVector<ComplexLanes>(length), AlignedVector<ComplexLanes>(length)}};
}

RowFft::Spectra MirroredFft::layout(int planes) const
{
  return {static_cast<std::ptrdiff_t>(planes) * rows(),
          planes > 1 && rows_size() * sizeof(ComplexLanes) > cached_bytes};
}

std::ptrdiff_t MirroredFft::field_at(const Part& part) const
{
  return (static_cast<std::ptrdiff_t>(part.component) * grid_.nz + part.layer) *
         static_cast<std::ptrdiff_t>(grid_.surface.size());
}

/// The sum of an even and an odd field in all rows, from their independent rows from `first_row` on. On the plane y = 0 the odd
/// field is zero.
void MirroredFft::pack(const double* even, const double* odd, int first_row, double* plane) const
{
  const std::ptrdiff_t nx = grid_.surface.nx;
  const std::ptrdiff_t ny = grid_.surface.ny;
  for (std::ptrdiff_t j = first_row; j < half_; ++j)
  {
    const double *e = even + j * nx, *o = odd + j * nx;
    double *own = plane + j * nx, *opposite = plane + (ny - 1 - j) * nx;
    if (2 * j == ny - 1)
    {
      std::copy_n(e, nx, own);
      continue;
    }
#pragma omp simd
    for (std::ptrdiff_t i = 0; i < nx; ++i)
    {
      own[i] = e[i] + o[i];
      opposite[i] = e[i] - o[i];
    }
  }
}

/// Copies the independent rows of two even fields into one plane, those of the second in reverse order.
void MirroredFft::pack_shared(const Plane& parts, const double* deviators, const std::array<int, 2>& first_rows,
                              double* plane) const
{
  const std::ptrdiff_t nx = grid_.surface.nx;
  const double* first = deviators + field_at(parts.first);
  std::copy(first + first_rows[0] * nx, first + half_ * nx, plane + first_rows[0] * nx);
  if (!parts.second.is_there())
    return;
  const double* second = deviators + field_at(parts.second);
  for (std::ptrdiff_t j = first_rows[1]; j < half_; ++j)
    std::copy_n(second + j * nx, nx, plane + (rows() - 1 - j) * nx);
}

void MirroredFft::unpack(const double* plane, double* even, double* odd) const
{
  const std::ptrdiff_t nx = grid_.surface.nx;
  const std::ptrdiff_t ny = grid_.surface.ny;
  for (std::ptrdiff_t j = 0; j < half_; ++j)
  {
    const double *own = plane + j * nx, *opposite = plane + (ny - 1 - j) * nx;
    double *e = even + j * nx, *o = odd + j * nx;
#pragma omp simd
    for (std::ptrdiff_t i = 0; i < nx; ++i)
    {
      e[i] = 0.5 * (own[i] + opposite[i]);
      o[i] = 0.5 * (own[i] - opposite[i]);
    }
  }
}

void MirroredFft::split(const ComplexLanes* both, ComplexLanes* even, ComplexLanes* odd) const
{
  for (int n = 0; n <= py() / 2; ++n)
  {
    const ComplexLanes own = 0.5 * both[n];
    const ComplexLanes opposite =
        times(0.5 * std::conj(phase_[static_cast<std::size_t>(n)]), both[n == 0 ? 0 : py() - n]);
    even[n] = own + opposite;
    odd[n] = own - opposite;
  }
}

void MirroredFft::join(const ComplexLanes* even, const ComplexLanes* odd, ComplexLanes* both) const
{
  both[0] = even[0] + odd[0];
  for (int n = 1; n <= py() / 2; ++n)
  {
    both[py() - n] = times(phase_[static_cast<std::size_t>(n)], even[n] - odd[n]);
    both[n] = even[n] + odd[n];
  }
}

/// The spectrum of an even field at its wavenumbers < 0 along y, from those >= 0.
void MirroredFft::complete_even(ComplexLanes* spectrum) const
{
  for (int n = 1; 2 * n < py(); ++n)
    spectrum[py() - n] = times(phase_[static_cast<std::size_t>(n)], spectrum[n]);
}

void MirroredFft::rows_forward(const double* deviators, int number, int layers, const std::array<int, 2>& first_rows,
                               ComplexLanes* out, Scratch& scratch) const
{
  rows_forward_to(deviators, number, layers, first_rows, out + static_cast<std::ptrdiff_t>(number) * rows(),
                  layout(planes_of_group * groups(grid_.nz)), scratch);
}

void MirroredFft::rows_forward_to(const double* deviators, int number, int layers, const std::array<int, 2>& first_rows,
                                  ComplexLanes* out, const RowFft::Spectra& apart, Scratch& scratch) const
{
  const Plane parts = plane(number, layers);
  const std::ptrdiff_t nx = grid_.surface.nx;
  double* field = scratch.field.data();
  int begin = first_rows[0], end = rows() - first_rows[1]; // range of the nonzero rows
  if (parts.is_shared)
    pack_shared(parts, deviators, first_rows, field);
  else
  {
    begin = std::min(first_rows[0], first_rows[1]);
    end = std::max(begin, grid_.surface.ny - begin);
    pack(deviators + field_at(parts.first), deviators + field_at(parts.second), begin, field);
  }
  for (int first = begin; first < end; first += RowFft::most_rows)
    rows_.forward(field + first * nx, std::min(RowFft::most_rows, end - first), out + first, apart, scratch.row_work);
  for (int block = 0; block < rows_.blocks(); ++block, out += apart.apart)
  {
    std::fill(out, out + begin, ComplexLanes{});
    std::fill(out + end, out + rows(), ComplexLanes{});
  }
}

void MirroredFft::columns_forward(const ComplexLanes* in, int block, int group, int layers, ComplexLanes* spectrum,
                                  int pitch, Scratch& scratch) const
{
  const int ny = grid_.surface.ny;
  const std::ptrdiff_t planes = planes_of_group * groups(grid_.nz);
  const auto spectrum_of = [&](const Part& part)
  { return spectrum + static_cast<std::ptrdiff_t>(Deviator::size * part.layer + part.component) * pitch; };
  for (int place = 0; place < planes_of_group; ++place)
  {
    const int number = planes_of_group * group + place;
    const Plane parts = plane(number, layers);
    const ComplexLanes* series = in + (block * planes + number) * rows();
    if (parts.is_empty())
      continue;
    if (number + 1 < planes)
      for (std::ptrdiff_t j = 0; j < rows(); ++j)
        fetch_soon(series + rows() + j); // of the next plane
    if (!parts.is_shared)
    {
      columns_.forward(series, ny, scratch.spectrum.data(), scratch.column_work.data());
      split(scratch.spectrum.data(), spectrum_of(parts.first), spectrum_of(parts.second));
      continue;
    }
    for (const bool is_second : {false, true})
    {
      const Part& part = is_second ? parts.second : parts.first;
      for (std::ptrdiff_t j = 0; part.is_there() && j < half_; ++j)
        scratch.series[static_cast<std::size_t>(j)] = scratch.series[static_cast<std::size_t>(ny - 1 - j)] =
            series[is_second ? rows() - 1 - j : j];
      if (part.is_there())
        columns_.forward(scratch.series.data(), ny, spectrum_of(part), scratch.column_work.data());
    }
  }
}

void MirroredFft::columns_inverse_to(const Plane& parts, const ComplexLanes* first, const ComplexLanes* second,
                                     ComplexLanes* out, Scratch& scratch) const
{
  if (!parts.is_shared)
  {
    join(first, second, scratch.spectrum.data());
    columns_.inverse(scratch.spectrum.data(), out, grid_.surface.ny, scratch.column_work.data());
    std::fill(out + grid_.surface.ny, out + rows(), ComplexLanes{});
    return;
  }
  for (const ComplexLanes* part : {first, second})
  {
    if (part == nullptr)
      break;
    std::copy_n(part, py() / 2 + 1, scratch.spectrum.data());
    complete_even(scratch.spectrum.data());
    columns_.inverse(scratch.spectrum.data(), out, half_, scratch.column_work.data());
    out += half_;
  }
}

void MirroredFft::rows_inverse_from(const Plane& parts, const ComplexLanes* rows_of_plane, const RowFft::Spectra& apart,
                                    double* deviators, Scratch& scratch) const
{
  const std::ptrdiff_t nx = grid_.surface.nx;
  const double scale = 1.0 / (static_cast<double>(rows_.length()) * py());
  const int used = parts.is_shared && !parts.second.is_there() ? half_ : rows();
  double* field = scratch.field.data();
  for (int first = 0; first < used; first += RowFft::most_rows)
    rows_.inverse(rows_of_plane + first, apart, std::min(RowFft::most_rows, used - first), scale, field + first * nx,
                  scratch.row_work);
  if (!parts.is_shared)
    return unpack(field, deviators + field_at(parts.first), deviators + field_at(parts.second));
  std::copy_n(field, half_ * nx, deviators + field_at(parts.first));
  if (parts.second.is_there())
    std::copy_n(field + half_ * nx, half_ * nx, deviators + field_at(parts.second));
}

} // namespace brinell::halfspace
