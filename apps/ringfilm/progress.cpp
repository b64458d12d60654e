#include "progress.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <iostream>

#include "text/terminal_text.hpp"

namespace ringfilm::app {
namespace {

constexpr auto kSilentFirst = std::chrono::milliseconds(500);
constexpr auto kBetweenLines = std::chrono::milliseconds(100);
constexpr const char* kEraseLine = "\r\x1b[K";

}  // namespace

ProgressLine::ProgressLine() : is_terminal_(::isatty(STDERR_FILENO) == 1), next_(Clock::now() + kSilentFirst) {}

ProgressLine::~ProgressLine() {
  if (!is_shown_) return;
  command_terminal(std::cerr, kEraseLine);
  std::cerr << std::flush;
}

void ProgressLine::show(const std::string& text) {
  if (!is_terminal_ || Clock::now() < next_) return;
  next_ = Clock::now() + kBetweenLines;
  is_shown_ = true;
  command_terminal(std::cerr, kEraseLine);
  std::cerr << text << std::flush;
}

void RunProgress::advanced(int cycle, double crank_angle_deg) {
  line_.show(fmt::format("{}: cycle {}, {:.0f} degree", name_, cycle, crank_angle_deg));
}

void RunProgress::advanced(double time, double end_time) {
  line_.show(fmt::format("{}: {:.4g} of {:.4g} s", name_, time, end_time));
}

void RunProgress::others_ended(int n_done, int n_total) {
  line_.show(fmt::format("{} of {} other grids and choices", n_done, n_total));
}

}  // namespace ringfilm::app
