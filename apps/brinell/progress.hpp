// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <chrono>
#include <cstddef>
#include <string>
#include <string_view>

namespace brinell::app
{

/// A progress bar followed by text, of at most `width` characters. If there is not enough room the bar is shortened first, then
/// parts of the text are left out, except the last one (the time left), and finally the bar.
/// @param text  parts separated by two blanks
[[nodiscard]] std::string progress_line(double share, std::string_view text, std::size_t width);

/// Shows the progress of a run on stderr: a bar on a terminal, otherwise one line per tenth of the steps; nothing if quiet.
class Progress
{
public:
  explicit Progress(bool quiet, int done_before = 0);
  ~Progress(); ///< leaves the terminal on a clean line
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// @param step   counts from 0
  /// @param where  position of the step in the motion
  void step(int step, int step_count, const std::string& where, int evaluations);
  /// Prints a message on a line of its own.
  void remark(const std::string& text);

private:
  using Clock = std::chrono::steady_clock;

  bool quiet_, terminal_;
  int done_before_; ///< steps of an earlier process
  bool bar_is_shown_ = false;
  int tenths_ = 0;
  Clock::time_point start_ = Clock::now();
};

} // namespace brinell::app
