#pragma once
#include <chrono>
#include <string>

#include "ringfilm/run/run.hpp"

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

/// Prints the progress of a run on a line.
class RunProgress : public run::Observer {
 public:
  void begins(const std::string& name) override { name_ = name; }
  void advanced(int cycle, double crank_angle_deg) override;
  void advanced(double time, double end_time) override;
  void others_ended(int n_done, int n_total) override;

 private:
  ProgressLine line_;
  std::string name_;
};

}  // namespace ringfilm::app
