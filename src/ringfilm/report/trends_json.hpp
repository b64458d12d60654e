#pragma once
#include <string>
#include <vector>

#include "ringfilm/io/result/result_file.hpp"
#include "ringfilm/study/verification/trends.hpp"

namespace ringfilm::report {

/// What `ringfilm verify --trends` found, as JSON in SI: trends with their published statements, levels and outcomes,
/// then inexpressible, program and commit. A NaN is null.
std::string trends_json(const std::vector<study::TrendOutcome>& outcomes,
                        const std::vector<study::InexpressibleTrend>& inexpressible, const io::Provenance& provenance);

}  // namespace ringfilm::report
