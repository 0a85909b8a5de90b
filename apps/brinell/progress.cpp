// SPDX-License-Identifier: BSD-3-Clause
#include "progress.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fmt/format.h>
#include <unistd.h>

namespace brinell::app
{

namespace
{

constexpr int bar_width = 24;

std::string duration_text(double seconds)
{
  const long total = std::lround(seconds);
  if (total < 60)
    return fmt::format("{} s", total);
  if (total < 3600)
    return fmt::format("{} min {:02} s", total / 60, total % 60);
  return fmt::format("{} h {:02} min", total / 3600, total / 60 % 60);
}

} // namespace

Progress::Progress(bool quiet, int done_before)
    : quiet_(quiet), terminal_(isatty(STDERR_FILENO) == 1), done_before_(done_before)
{
}

Progress::~Progress()
{
  if (bar_is_shown_)
    fmt::print(stderr, "\n");
}

void Progress::remark(const std::string& text)
{
  if (quiet_)
    return;
  fmt::print(stderr, "{}brinell: {}\n", bar_is_shown_ ? "\r\x1b[K" : "", text);
  bar_is_shown_ = false;
}

void Progress::step(int step, int step_count, const std::string& where, int iterations)
{
  if (quiet_)
    return;
  const int done = step + 1;
  const int total = std::max(step_count, done); // the count is an estimate
  const double seconds = std::chrono::duration<double>(Clock::now() - start_).count();
  const double left = seconds / std::max(1, done - done_before_) * (total - done);
  const std::string text = fmt::format("step {}/{}  {}  {} iteration{}  {} left", done, total, where, iterations,
                                       iterations == 1 ? "" : "s", duration_text(left));
  if (terminal_)
  {
    const auto filled = static_cast<std::size_t>(static_cast<long>(bar_width) * done / total);
    fmt::print(stderr, "\r[{}{}] {}\x1b[K", std::string(filled, '#'), std::string(bar_width - filled, '.'), text);
    bar_is_shown_ = true;
  }
  else if (const auto tenths = static_cast<int>(10L * done / total); tenths > tenths_)
  {
    tenths_ = tenths;
    fmt::print(stderr, "{}\n", text);
  }
  std::fflush(stderr);
}

} // namespace brinell::app
