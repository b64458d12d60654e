#pragma once
#include <chrono>
#include <string>

#include "ringfilm/cycle/simulate.hpp"

namespace ringfilm::app {

/// One line on standard error that is written over and over and gone at the end. Silent where standard error is not a
/// terminal, and for work that is done before one could read it.
class ProgressLine {
 public:
  ProgressLine();
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;
  ~ProgressLine();

  void show(const std::string& text);

 private:
  using Clock = std::chrono::steady_clock;
  bool is_terminal_;
  bool is_shown_ = false;
  Clock::time_point next_;
};

/// Prints the progress of an integration on a line.
class IntegrationProgress : public cycle::Observer {
 public:
  IntegrationProgress(ProgressLine& line, std::string what) : line_(line), what_(std::move(what)) {}
  void advanced(int cycle, double crank_angle_deg) override;

 private:
  ProgressLine& line_;
  std::string what_;
};

}  // namespace ringfilm::app
