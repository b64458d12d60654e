#pragma once
#include <optional>
#include <string>
#include <vector>

#include "commands/commands.hpp"

namespace ringfilm::app {

struct LifeOptions {
  std::string life_path;
  std::optional<std::string> output;  ///< NetCDF
  std::optional<std::string> page;    ///< web page
  SummaryForm summary = SummaryForm::kTable;
  int threads = 0;  ///< 0: as many as the machine runs at once
};
void run_life(const LifeOptions& options);

struct FacesOptions {
  std::vector<std::string> case_paths;
  SummaryForm summary = SummaryForm::kTable;
};
/// Prints the least wear between the faces of cases.
void compare_faces(const FacesOptions& options);

}  // namespace ringfilm::app
