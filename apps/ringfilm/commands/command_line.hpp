#pragma once
#include <functional>

namespace ringfilm::app {

/// What the arguments of a command line request.
struct Request {
  std::function<void()> command;  ///< empty: help or a refusal was printed and `exit_code` is final
  int exit_code = 0;
};

/// Reads the command line; prints help, version or what is wrong with it.
Request read_command_line(int argc, const char* const* argv);

}  // namespace ringfilm::app
