#pragma once
#include <optional>
#include <string>
#include <vector>

#include "ringfilm/cycle/result/result.hpp"
#include "ringfilm/io/result/result_file.hpp"
#include "ringfilm/study/ensemble/error_estimate.hpp"

namespace ringfilm::io {

/// The curves as CSV text: a row per crank angle, a column per entry of cycle::curve_quantities(), header `name [unit]`
/// or `name` alone if dimensionless. SI, angles in degrees, each number in the fewest digits that give it back exactly;
/// `nan` where a quantity does not exist at that angle. An unrolled film adds a column for every entry of
/// cycle::unrolled_quantities(). With errors a column `name_error [unit]` for every curve that has one, after all
/// others.
/// @param unrolled as many as samples, or none
std::string result_csv(const std::vector<cycle::Sample>& samples,
                       const std::optional<study::ErrorEstimate>& errors = {},
                       const std::vector<cycle::UnrolledSample>& unrolled = {});

/// All of a result; of a pack the rows of one ring after the other, with its number in the first column, `ring`.
std::string result_csv(const ResultDocument& document);

}  // namespace ringfilm::io
