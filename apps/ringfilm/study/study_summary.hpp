#pragma once
#include <string>

#include "ringfilm/io/study/study_result.hpp"

namespace ringfilm::app {

/// What a study found, for the terminal: main values of the cycle with their quantiles for each base, indices where
/// they were asked for, and what was not solved.
std::string study_summary(const io::StudyRows& rows);

}  // namespace ringfilm::app
