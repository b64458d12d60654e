#pragma once
#include <optional>
#include <string>
#include <vector>

#include "commands/commands.hpp"

namespace ringfilm::app {

/// What `gas` was asked for.
struct GasOptions {
  std::string case_path;
  std::vector<io::Override> overrides;
  std::optional<std::string> csv, output;
  std::vector<std::string> varied;  ///< as written: KEY=VALUE, VALUE, ...
  SummaryForm summary = SummaryForm::kTable;
};

/// Computes the gas of a ring pack over a cycle.
void gas(const GasOptions& options);

}  // namespace ringfilm::app
