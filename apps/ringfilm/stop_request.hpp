#pragma once

namespace ringfilm::app {

/// While it lives, Ctrl-C and a polite kill are noted instead of ending the program; a second one ends it at once.
class StopRequest {
 public:
  StopRequest();
  StopRequest(const StopRequest&) = delete;
  StopRequest& operator=(const StopRequest&) = delete;
  ~StopRequest();

  bool is_made() const;
};

}  // namespace ringfilm::app
