#include "study/study_progress.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <iostream>

namespace ringfilm::app {
namespace {

constexpr auto kBetweenLogLines = std::chrono::seconds(10);
constexpr int kBarLength = 24;

std::string duration_text(double seconds) {
  constexpr double kMinute = 60, kHour = 3600;
  if (seconds < 2 * kMinute) return fmt::format("{:.0f} s", seconds);
  if (seconds < 2 * kHour) return fmt::format("{:.0f} min", seconds / kMinute);
  return fmt::format("{:.1f} h", seconds / kHour);
}

}  // namespace

StudyProgress::StudyProgress(std::string name, std::uint64_t done, std::uint64_t total)
    : name_(std::move(name)), done_at_start_(done), total_(total), is_terminal_(::isatty(STDERR_FILENO) == 1) {}

std::string StudyProgress::text(std::uint64_t done, std::uint64_t unsolved, Clock::time_point now) const {
  const double seconds = std::chrono::duration<double>(now - start_).count();
  const double rate = seconds > 0 ? static_cast<double>(done - done_at_start_) / seconds : 0;
  std::string text = fmt::format("{} of {} done, {} left, {} not solved", done, total_, total_ - done, unsolved);
  if (rate > 0) {
    text += fmt::format(", {:.3g} a second, {} to go", rate, duration_text(static_cast<double>(total_ - done) / rate));
  }
  return text;
}

void StudyProgress::show(std::uint64_t done, std::uint64_t unsolved) {
  const Clock::time_point now = Clock::now();
  if (is_terminal_) {
    const int n = total_ == 0 ? kBarLength : static_cast<int>(kBarLength * done / total_);
    line_.show(fmt::format("{} [{:-<{}}] {}", name_, std::string(n, '#'), kBarLength, text(done, unsolved, now)));
  } else if (now - last_line_ >= kBetweenLogLines) {
    last_line_ = now;
    std::cerr << fmt::format("{}: {}\n", name_, text(done, unsolved, now)) << std::flush;
  }
}

}  // namespace ringfilm::app
