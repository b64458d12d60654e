#pragma once
#include <chrono>
#include <cstdint>
#include <string>

#include "progress.hpp"

namespace ringfilm::app {

/// Prints how far a study is: on a terminal a line with a bar that is written over, elsewhere a line now and then.
class StudyProgress {
 public:
  /// @param done scenarios that were there at the start
  StudyProgress(std::string name, std::uint64_t done, std::uint64_t total);

  /// `done` of all scenarios are there, `unsolved` of those computed here have no solution.
  void show(std::uint64_t done, std::uint64_t unsolved);

 private:
  using Clock = std::chrono::steady_clock;

  std::string text(std::uint64_t done, std::uint64_t unsolved, Clock::time_point now) const;

  std::string name_;
  std::uint64_t done_at_start_, total_;
  Clock::time_point start_ = Clock::now(), last_line_ = start_;
  bool is_terminal_;
  ProgressLine line_;
};

}  // namespace ringfilm::app
