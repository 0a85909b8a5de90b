// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>

namespace brinell
{

/// Items 0, 1, 2, ... of some number, dealt out to ranks like cards: `together` neighbours to the first rank, as many to the
/// second, and so on, and then to the first again. What is done in the first few items only, such as plastic flow in the layers
/// next to the surface, is thereby shared as well. More items at the end change nothing for the others.
class Dealt
{
public:
  Dealt(int ranks, int together) : ranks_(ranks), together_(together) {}

  [[nodiscard]] int ranks() const { return ranks_; }
  [[nodiscard]] int owner(int item) const { return item / together_ % ranks_; }
  /// Number of items of a rank among the first `items`.
  [[nodiscard]] int count(int rank, int items) const
  {
    const int turn = together_ * ranks_;
    return items / turn * together_ + std::clamp(items % turn - rank * together_, 0, together_);
  }
  /// Place of an item among those of its owner.
  [[nodiscard]] int place(int item) const { return item / (together_ * ranks_) * together_ + item % together_; }
  /// The item of a rank at a place.
  [[nodiscard]] int item(int rank, int place) const
  {
    return (place / together_ * ranks_ + rank) * together_ + place % together_;
  }

private:
  int ranks_, together_;
};

/// Neighbouring items of a number of them, divided as evenly as possible: earlier ranks have one more.
struct Portion
{
  int first, end;

  Portion(int rank, int ranks, int items)
      : first(items / ranks * rank + std::min(rank, items % ranks)),
        end(items / ranks * (rank + 1) + std::min(rank + 1, items % ranks))
  {
  }
  [[nodiscard]] int count() const { return end - first; }
  [[nodiscard]] bool contains(int item) const { return first <= item && item < end; }
};

/// Who has what of a body that several ranks compute: layers in pairs, because mirrored fields are transformed in pairs of layers,
/// and neighbouring blocks of wavenumbers.
///
/// A rank has whole layers. All that is done within a layer, its transforms, moments and rows, is therefore done as by a rank alone,
/// with the same digits; and the fields of a rank are like those of a body with fewer layers.
class Share
{
public:
  static constexpr int layers_together = 2;

  Share() : Share(0, 1) {}
  Share(int rank, int ranks) : rank_(rank), layers_(ranks, layers_together) {}

  [[nodiscard]] int rank() const { return rank_; }
  [[nodiscard]] int ranks() const { return layers_.ranks(); }
  [[nodiscard]] bool is_all() const { return ranks() == 1; }
  [[nodiscard]] const Dealt& layers() const { return layers_; }
  /// Number of own layers among the first `layers` of the body: they are the first own ones.
  [[nodiscard]] int count(int layers) const { return layers_.count(rank_, layers); }
  /// Layer of the body that is own layer number `own`.
  [[nodiscard]] int layer(int own) const { return layers_.item(rank_, own); }
  [[nodiscard]] bool has(int layer) const { return layers_.owner(layer) == rank_; }
  /// Number of an own layer.
  [[nodiscard]] int place(int layer) const { return layers_.place(layer); }
  /// Blocks of wavenumbers of a rank, and the own ones.
  [[nodiscard]] Portion blocks(int rank, int of_all) const { return {rank, ranks(), of_all}; }
  [[nodiscard]] Portion blocks(int of_all) const { return blocks(rank_, of_all); }

private:
  int rank_;
  Dealt layers_;
};

} // namespace brinell
