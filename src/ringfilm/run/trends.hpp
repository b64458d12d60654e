#pragma once
#include <functional>
#include <string>
#include <vector>

#include "ringfilm/study/verification/trends.hpp"

namespace ringfilm::run {

/// Computes trends as anyone would: each level is a case file with settings, read and run like `ringfilm run` does.
/// Equal runs are computed once. Throws InputError where a case with its settings breaks a rule, with the trend.
/// @param is_selected which trends are computed, by their id; those that they are compared with are, too
/// @param done receives each outcome as soon as it is known; may be empty
std::vector<study::TrendOutcome> run_trends(const study::TrendList& list,
                                            const std::function<bool(const std::string& id)>& is_selected,
                                            const std::function<void(const study::TrendOutcome&)>& done);

}  // namespace ringfilm::run
