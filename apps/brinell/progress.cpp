// SPDX-License-Identifier: BSD-3-Clause
#include "progress.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

namespace brinell::app
{

namespace
{

constexpr std::size_t longest_bar = 24, shortest_bar = 8;

/// Number of columns of the terminal on stderr; a common width if it is unknown.
std::size_t terminal_width()
{
  winsize size{};
  return ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0 ? size.ws_col : 80;
}

std::string duration_text(double seconds)
{
  const long total = std::lround(seconds);
  if (total < 60)
    return fmt::format("{} s", total);
  if (total < 3600)
    return fmt::format("{} min {:02} s", total / 60, total % 60);
  return fmt::format("{} h {:02} min", total / 3600, total / 60 % 60);
}

/// Drops parts of the text until it fits; the last part always stays.
std::string fitting_text(std::string_view text, std::size_t width)
{
  constexpr std::string_view between = "  ";
  std::string kept(text);
  while (kept.size() > width)
  {
    const auto last = kept.rfind(between);
    if (last == kept.npos || last == 0)
      break;
    const auto before = kept.rfind(between, last - 1);
    kept = before == kept.npos ? kept.substr(last + between.size()) : kept.substr(0, before) + kept.substr(last);
  }
  return kept;
}

} // namespace

std::string progress_line(double share, std::string_view text, std::size_t width)
{
  constexpr std::size_t around = 3; // brackets and a blank
  const std::string fitting = fitting_text(text, width > shortest_bar + around ? width - shortest_bar - around : 0);
  if (fitting.size() + shortest_bar + around > width)
    return fitting_text(text, width).substr(0, width);
  const std::size_t bar = std::min(width - fitting.size() - around, longest_bar);
  const auto filled = static_cast<std::size_t>(static_cast<double>(bar) * std::clamp(share, 0.0, 1.0));
  return fmt::format("[{}{}] {}", std::string(filled, '#'), std::string(bar - filled, '.'), fitting);
}

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

void Progress::step(int step, int step_count, const std::string& where, int evaluations)
{
  if (quiet_)
    return;
  const int done = step + 1;
  const int total = std::max(step_count, done); // the count is an estimate
  const double seconds = std::chrono::duration<double>(Clock::now() - start_).count();
  const double left = seconds / std::max(1, done - done_before_) * (total - done);
  const std::string text = fmt::format("step {}, {}/{} done  {}  {} evaluation{}  {} left", step, done, total, where,
                                       evaluations, evaluations == 1 ? "" : "s", duration_text(left));
  if (terminal_)
  {
    // A line that fills the last column would wrap into the next line.
    fmt::print(stderr, "\r{}\x1b[K", progress_line(static_cast<double>(done) / total, text, terminal_width() - 1));
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
