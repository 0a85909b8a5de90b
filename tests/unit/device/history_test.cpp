// SPDX-License-Identifier: BSD-3-Clause
#include "device/history.hpp"

#include "device/host_executor.hpp"
#include "random_field.hpp"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <vector>

/// The acceleration on an executor against that of the engine, whose sums have another order.
namespace brinell::device::history_test
{
namespace
{

using elastoplastic::Anderson;
using elastoplastic::AndersonWeights;

/// A fixed point of more and more unknowns, not linear.
struct Map
{
  std::vector<double> target = test::random_field(6000, 1), slope = test::random_field(6000, 2, -0.9, 0.9);

  [[nodiscard]] std::vector<double> at(const std::vector<double>& x) const
  {
    std::vector<double> g(x.size());
    for (std::size_t i = 0; i < x.size(); ++i)
      g[i] = target[i] + slope[i] * std::sin(x[i] + 0.3 * x[(i + 7) % x.size()]);
    return g;
  }
};

class OnExecutor
{
public:
  explicit OnExecutor(int depth) : weights_(static_cast<std::size_t>(depth))
  {
    history_.set_depth(weights_.depth(), 0);
  }

  void change_map() { weights_.change_map(); }
  void deepen(int depth, double damping)
  {
    const AndersonWeights::Moved moved = weights_.deepen(depth, damping);
    history_.set_depth(moved.depth, moved.first);
  }
  void advance(std::vector<double>& x, const std::vector<double>& g, const std::vector<double>& y)
  {
    const AndersonWeights::Entry entry = weights_.next();
    weights_.add(entry, history_.record(entry, x.size(), x.data(), g.data(), y.data()));
    weight_ = weights_.weights();
    history_.combine(weight_, x.size(), g.data(), x.data());
  }
  [[nodiscard]] std::vector<double> residual() { return history_.residual(weight_); }

private:
  HostExecutor host_;
  AndersonWeights weights_;
  History<HostExecutor> history_{host_};
  std::vector<double> weight_;
};

double largest_difference(const std::vector<double>& a, const std::vector<double>& b)
{
  double largest = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i)
    largest = std::max(largest, std::abs(a[i] - b[i]));
  return largest;
}

void expect_alike(int deepens_at)
{
  SCOPED_TRACE(testing::Message() << "deeper at " << deepens_at);
  const Map map;
  Anderson engine(4);
  OnExecutor twin(4);
  std::vector<double> x(10, 0.5), there;
  for (int pass = 0; pass < 16; ++pass)
  {
    x.resize(pass < 3 ? 10 : pass < 6 ? 700 : pass < 9 ? 730 : 6000, 0.5);
    const std::vector<double> g = map.at(x);
    std::vector<double> y(x.size());
    for (std::size_t i = 0; i < x.size(); ++i)
      y[i] = 1.1 * (g[i] - x[i]);
    if (pass == 7)
    {
      engine.change_map();
      twin.change_map();
    }
    if (pass == deepens_at)
    {
      engine.deepen(9, 0.05);
      twin.deepen(9, 0.05);
    }
    there = x;
    engine.advance(there, g, y);
    twin.advance(x, g, y);
    EXPECT_LE(largest_difference(x, there), 1e-12) << pass; // values are about 1
    EXPECT_LE(largest_difference(twin.residual(), engine.residual()), 1e-12) << pass;
    x = there; // each pass by itself: differences do not add up
  }
}

TEST(DeviceHistory, CombinesAsTheEngine)
{
  expect_alike(100);
}

TEST(DeviceHistory, KeepsMoreAsTheEngine)
{
  for (const int pass : {0, 3, 8, 12}) // before, while and after the ring is full
    expect_alike(pass);
}

} // namespace
} // namespace brinell::device::history_test
