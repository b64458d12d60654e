#pragma once

namespace ringfilm::app {

/// The whole program but for its process: reads the arguments, does what they request, prints what went wrong on
/// standard error. @returns the exit code
int run_program(int argc, const char* const* argv);

}  // namespace ringfilm::app
