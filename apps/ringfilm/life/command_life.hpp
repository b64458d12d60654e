#pragma once
#include <optional>
#include <string>

#include "commands/commands.hpp"

namespace ringfilm::app {

struct LifeOptions {
  std::string life_path;
  std::optional<std::string> output;  ///< NetCDF
  SummaryForm summary = SummaryForm::kTable;
  int threads = 0;  ///< 0: as many as the machine runs at once
};
void run_life(const LifeOptions& options);

}  // namespace ringfilm::app
