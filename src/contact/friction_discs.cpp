// SPDX-License-Identifier: BSD-3-Clause
#include "friction_discs.hpp"

#include "foundation/sharing.hpp"

#include <algorithm>

namespace brinell::contact
{

Along Forced::solution(const AlongMatrix& m, const Along& right) const
{
  if (!any())
    return {};
  // If all cells slip in the same direction, m is singular along it: the regularisation sets this component to zero.
  const double regular = 1e-14 * (m.xx + m.yy);
  const double xx = m.xx + regular, yy = m.yy + regular;
  if (!(regular > 0.0))
    return {};
  if (!y)
    return {right.x / xx, 0.0};
  if (!x)
    return {0.0, right.y / yy};
  const double determinant = xx * yy - m.xy * m.xy;
  return {(yy * right.x - m.xy * right.y) / determinant, (xx * right.y - m.xy * right.x) / determinant};
}

namespace
{

/// Sum of bounded shears, and its derivative with respect to the vector added to each shear.
struct Total
{
  Along shear;
  AlongMatrix growth;
  double bound = 0.0;
  Total& operator+=(const Total& other)
  {
    shear += other.shear;
    growth += other.growth;
    bound += other.bound;
    return *this;
  }
};

void add(const Along& q, double bound, Total& total)
{
  const double size = q.size();
  total.bound += bound;
  if (size <= bound)
  {
    total.shear += q;
    total.growth += {1.0, 1.0, 0.0};
    return;
  }
  const Along n = (1.0 / size) * q;
  const double turned = bound / size;
  total.shear += bound * n;
  total.growth += {turned * n.y * n.y, turned * n.x * n.x, -turned * n.x * n.y};
}

} // namespace

bool balance(const Forced& forced, const Along& sum, bool of_slip, std::span<const double> bound,
             std::span<const Zone> zone, std::span<double> x, std::span<double> y)
{
  const auto moves = [&](std::size_t i) { return of_slip || zone[i] == Zone::stick; };
  const auto total = [&](const Along& added)
  {
    const auto part = [&](std::size_t first, std::size_t last)
    {
      Total here;
      for (std::size_t i = first; i < last; ++i)
        if (moves(i))
          add({x[i] + added.x, y[i] + added.y}, bound[i], here);
        else
          here.shear += {x[i], y[i]};
      return here;
    };
    return sum_of_pieces(bound.size(), part);
  };
  constexpr int most_turns = 60;
  constexpr double rounding = 1e-14;
  Along added;
  Total now = total(added);
  Along missing = forced.part(sum - now.shear);
  const double accuracy = rounding * now.bound;
  for (int turn = 0; turn < most_turns && missing.size() > accuracy; ++turn)
  {
    Along step = forced.solution(now.growth, missing);
    // The full Newton step is right near the solution; farther away it may overshoot.
    bool is_nearer = false;
    for (int halving = 0; halving < most_turns && !is_nearer; ++halving)
    {
      const Total next = total(added + step);
      const Along left = forced.part(sum - next.shear);
      is_nearer = left.size() < missing.size();
      if (is_nearer)
      {
        added += step;
        now = next;
        missing = left;
      }
      step = 0.5 * step;
    }
    if (!is_nearer)
      break;
  }
  for_pieces(bound.size(),
             [&](std::size_t first, std::size_t last)
             {
               for (std::size_t i = first; i < last; ++i)
                 if (moves(i))
                 {
                   const Along q = bounded({x[i] + added.x, y[i] + added.y}, bound[i]);
                   x[i] = q.x;
                   y[i] = q.y;
                 }
             });
  constexpr double good = 1e-10;
  return missing.size() <= good * now.bound;
}

} // namespace brinell::contact
