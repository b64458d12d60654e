#pragma once
#include <csignal>
#include <optional>
#include <stdexcept>
#include <string>

namespace ringfilm::app {

/// A command that ended early because a signal asked for it (exit code 128 + signal).
class Stopped : public std::runtime_error {
 public:
  Stopped(const std::string& message, int signal) : std::runtime_error(message), signal_(signal) {}
  int signal() const { return signal_; }

 private:
  int signal_;
};

/// While it lives, Ctrl-C and a polite kill are noted instead of ending the program; a second one ends it at once. A
/// signal that the program was set to ignore when it was started (nohup, a script's background) stays ignored.
class StopRequest {
 public:
  StopRequest();
  StopRequest(const StopRequest&) = delete;
  StopRequest& operator=(const StopRequest&) = delete;
  ~StopRequest();

  bool is_made() const;
  /// What the command throws then, once it has kept what is to be kept.
  Stopped stopped(const std::string& message) const;

 private:
  std::optional<struct sigaction> interrupt_before_, kill_before_;
};

}  // namespace ringfilm::app
