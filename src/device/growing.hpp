// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "active_kernels.hpp"

#include <algorithm>
#include <cstddef>
#include <span>

namespace brinell::device
{

/// An array in memory of an executor that is made longer, and never shorter; its values stay.
template <typename Executor, typename Value>
class Growing
{
public:
  explicit Growing(const Executor& executor, std::size_t of_each = 1) : executor_(&executor), of_each_(of_each) {}

  /// @param count  of things with `of_each` values each
  void grow(std::size_t count)
  {
    const std::size_t needed = count * of_each_;
    if (needed <= memory_.size())
      return;
    Memory longer = executor_->template allocate<Value>(std::max(needed, memory_.size() + memory_.size() / 2));
    executor_->run("longer array", memory_.size(), CopyValues<Value>{memory_.data(), longer.data()});
    memory_ = std::move(longer);
  }
  [[nodiscard]] Value* data() { return memory_.data(); }
  /// Copies the values of `count` things to the processor.
  void read(std::size_t count, Value* to) const
  {
    if (count * of_each_ > 0)
      executor_->read(memory_, std::span<Value>(to, count * of_each_));
  }
  void write(std::span<const Value> from)
  {
    if (!from.empty())
      executor_->write(from, memory_);
  }

private:
  using Memory = typename Executor::template Memory<Value>;
  const Executor* executor_;
  std::size_t of_each_;
  Memory memory_{};
};

} // namespace brinell::device
