#pragma once
#include <string>
#include <vector>

#include "commands/command_study.hpp"

namespace ringfilm::app {

struct SubmitOptions {
  StudyOptions study;       ///< threads = 0: one a task
  std::uint64_t parts = 0;  ///< 0: as many as are there already, else 8
  std::string engine;
  bool is_rehearsal = false;         ///< write the scripts and show them, submit nothing
  std::vector<std::string> further;  ///< options for the engine, as the user wrote them
};

/// Writes the scripts that compute the parts of a study and join them, and hands them to the scheduler. Throws
/// InputError before anything is written, FailedChecks where the scheduler refuses.
void submit_study(const SubmitOptions& options);

}  // namespace ringfilm::app
