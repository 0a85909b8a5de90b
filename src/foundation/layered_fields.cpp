// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/foundation/layered_fields.hpp"

#include "foundation/sharing.hpp"

#include <algorithm>
#include <utility>

namespace brinell
{

namespace
{

std::size_t as_size(int count)
{
  return static_cast<std::size_t>(count);
}

} // namespace

LayeredFields::LayeredFields(const VolumeGrid& grid, std::vector<std::vector<double>> fields)
    : LayeredFields(grid, std::make_shared<const Communicator>(), Share(), std::move(fields))
{
}

LayeredFields::LayeredFields(const VolumeGrid& whole, std::shared_ptr<const Communicator> ranks, const Share& share,
                             std::vector<std::vector<double>> own)
    : grid_(whole), ranks_(std::move(ranks)), share_(share),
      own_(std::move(own)), z_{0, whole.nz, 1}, y_{0, whole.surface.ny, 1}, x_{0, whole.surface.nx, 1}
{
}

std::array<std::size_t, 3> LayeredFields::shape() const
{
  return {as_size(z_.count), as_size(y_.count), as_size(x_.count)};
}

LayeredFields LayeredFields::selected(const Spaced& z, const Spaced& y, const Spaced& x) &&
{
  LayeredFields fields = std::move(*this);
  fields.z_ = z;
  fields.y_ = y;
  fields.x_ = x;
  return fields;
}

LayeredFields LayeredFields::combined(const std::function<double(std::size_t own_cell)>& value) const
{
  std::vector<double> results(own_.front().size());
  for_pieces(results.size(),
             [&](std::size_t first, std::size_t last)
             {
               for (std::size_t cell = first; cell < last; ++cell)
                 results[cell] = value(cell);
             });
  LayeredFields fields(grid_, ranks_, share_, {});
  fields.own_.push_back(std::move(results));
  return std::move(fields).selected(z_, y_, x_);
}

/// The rows of the layers of a part that are those of this rank.
std::vector<double> LayeredFields::own_part(std::size_t field, const Slab& slab) const
{
  std::vector<double> values;
  for (int k = slab.first_layer; k < slab.first_layer + slab.layers; ++k)
    if (const int layer = z_.item(k); share_.has(layer))
      for (int j = slab.first_row; j < slab.first_row + slab.rows; ++j)
      {
        const auto row =
            own_[field].begin() + static_cast<std::ptrdiff_t>(grid_.index(x_.first, y_.item(j), share_.place(layer)));
        if (x_.stride == 1)
          values.insert(values.end(), row, row + x_.count);
        else
          for (int i = 0; i < x_.count; ++i)
            values.push_back(row[static_cast<std::ptrdiff_t>(i) * x_.stride]);
      }
  return values;
}

std::vector<double> LayeredFields::part(std::size_t field, const Slab& slab) const
{
  std::vector<double> own = own_part(field, slab);
  if (ranks_->is_alone())
    return own;
  const std::size_t rows = as_size(slab.rows) * as_size(x_.count); // values of a layer
  std::vector<std::size_t> counts(as_size(ranks_->size()));
  for (int k = slab.first_layer; k < slab.first_layer + slab.layers; ++k)
    counts[as_size(share_.layers().owner(z_.item(k)))] += rows;
  const bool receives = ranks_->rank() == 0;
  std::vector<double> by_rank(receives ? rows * as_size(slab.layers) : 0), values(by_rank.size());
  ranks_->gather(own, counts, by_rank);
  if (!receives)
    return {};
  std::vector<std::size_t> next(counts.size()); // place of the next layer of each rank
  for (std::size_t rank = 1; rank < counts.size(); ++rank)
    next[rank] = next[rank - 1] + counts[rank - 1];
  for (int n = 0; n < slab.layers; ++n)
  {
    std::size_t& from = next[as_size(share_.layers().owner(z_.item(slab.first_layer + n)))];
    std::copy_n(by_rank.begin() + static_cast<std::ptrdiff_t>(from), rows,
                values.begin() + static_cast<std::ptrdiff_t>(as_size(n) * rows));
    from += rows;
  }
  return values;
}

std::vector<double> LayeredFields::whole(std::size_t field) const
{
  return part(field, {0, z_.count, 0, y_.count});
}

} // namespace brinell
