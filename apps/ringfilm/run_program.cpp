#include "run_program.hpp"

#include <stdlib.h>

#include <exception>
#include <iostream>

#include "commands/command_line.hpp"
#include "commands/commands.hpp"
#include "exit_codes.hpp"
#include "ringfilm/base/error.hpp"
#include "stop_request.hpp"
#include "text/terminal_text.hpp"

namespace ringfilm::app {
namespace {

int print_error(const InputError& error) {
  const std::size_t n = error.faults().size();
  std::cerr << error.what() << n << (n == 1 ? " error" : " errors") << "; nothing was run or written (exit code "
            << kBadInput << ")\n";
  return kBadInput;
}

int carry_out(const Request& request) {
  if (!request.command) return request.exit_code;
  try {
    request.command();
    std::cout.flush();
    if (std::cout) return kFine;
    std::cerr << "standard output: could not be written in full; is the disk full or the pipe closed? (exit code "
              << kCouldNotWrite << ")\n";
    return kCouldNotWrite;
  } catch (const InputError& error) {
    return print_error(error);
  } catch (const ConvergenceError& error) {
    std::cerr << error.what() << "\nthe computation was not finished (exit code " << kNoConvergence << ")\n";
    return kNoConvergence;
  } catch (const FailedChecks& failed) {
    std::cout.flush();
    std::cerr << failed.what() << " (exit code " << kSomethingFailed << ")\n";
    return kSomethingFailed;
  } catch (const Stopped& stop) {
    const int code = kStopped + stop.signal();
    std::cerr << stop.what() << " (exit code " << code << ")\n";
    return code;
  } catch (const OutputError& error) {
    std::cerr << error.what() << "\nnot all output was written (exit code " << kCouldNotWrite << ")\n";
    return kCouldNotWrite;
  }
}

}  // namespace

int run_program(int argc, const char* const* argv) {
  // HDF5 refuses to write where the file system has no locks (many cluster folders); we write under names of our own.
  constexpr int kKeepWhatTheUserSet = 0;
  ::setenv("HDF5_USE_FILE_LOCKING", "BEST_EFFORT", kKeepWhatTheUserSet);
  const PrintableStreams printable_streams;
  try {
    return carry_out(read_command_line(argc, argv));
  } catch (const std::exception& error) {
    std::cerr << "ringfilm: internal error: " << error.what()
              << "\nthis is a fault of the program; please report it with "
              << "the case file (exit code " << kBug << ")\n";
    return kBug;
  }
}

}  // namespace ringfilm::app
