#pragma once
#include <string>
#include <vector>

#include "ringfilm/case/case.hpp"

namespace ringfilm::io {

/// A complete case file (resolved_case) for another folder, in which files are named as seen from there.
/// @param heading comments in front, line by line
std::string resolved_case_in(const std::string& folder, const cycle::Case& c, const std::vector<std::string>& heading);

}  // namespace ringfilm::io
