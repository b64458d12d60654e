#pragma once
#include <string>
#include <vector>

#include "commands/commands.hpp"

namespace ringfilm::app {

struct FacesOptions {
  std::vector<std::string> case_paths;
  SummaryForm summary = SummaryForm::kTable;
};
/// Prints the least wear between the faces of cases.
void compare_faces(const FacesOptions& options);

}  // namespace ringfilm::app
