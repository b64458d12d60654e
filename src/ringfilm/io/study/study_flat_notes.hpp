#pragma once
#include <string>
#include <vector>

#include "ringfilm/study/statistics/flat_factors.hpp"

namespace ringfilm::io {

/// One sentence for each value that hardly changes with one or more factors of the study, in the units of people.
/// @param tolerance below which it changes, relative [-]
std::vector<std::string> flat_notes(const study::Plan& plan, const std::vector<study::FlatRange>& ranges,
                                    double tolerance);

}  // namespace ringfilm::io
