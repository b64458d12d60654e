#pragma once
#include <string>
#include <vector>

#include "commands/commands.hpp"

namespace ringfilm::app {

/// Prints the ids and statements of the published trends; computes nothing.
void list_trends(const std::vector<std::string>& filters);

/// Computes the published trends of measured rings and prints what follows them. Throws FailedChecks where an outcome
/// is not the recorded one.
/// @param filters parts of ids; empty: all trends
void verify_trends(const std::vector<std::string>& filters, SummaryForm summary);

}  // namespace ringfilm::app
