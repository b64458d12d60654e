#pragma once
#include <csignal>
#include <optional>

namespace ringfilm::app {

/// While it lives, Ctrl-C and a polite kill are noted instead of ending the program; a second one ends it at once. A
/// signal that the program was set to ignore when it was started (nohup, a script's background) stays ignored.
class StopRequest {
 public:
  StopRequest();
  StopRequest(const StopRequest&) = delete;
  StopRequest& operator=(const StopRequest&) = delete;
  ~StopRequest();

  bool is_made() const;

 private:
  std::optional<struct sigaction> interrupt_before_, kill_before_;
};

}  // namespace ringfilm::app
