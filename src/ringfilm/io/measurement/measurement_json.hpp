#pragma once
#include <string>
#include <utility>
#include <vector>

#include "ringfilm/io/measurement/measurement.hpp"
#include "ringfilm/io/result/result_file.hpp"

namespace ringfilm::io {

/// Numbers at the top of the JSON, in SI, in their order.
using NamedNumbers = std::vector<std::pair<std::string, double>>;

/// Lists of numbers at the top of the JSON, in SI, in their order.
using NamedLists = std::vector<std::pair<std::string, std::vector<double>>>;

/// Rows of numbers at the top of the JSON, a list each, in their order.
using NamedRows = std::vector<std::pair<std::string, std::vector<std::vector<double>>>>;

/// Objects of lists at the top of the JSON, in SI, in their order; a list of one is a number.
using NamedObjects = std::vector<std::pair<std::string, NamedLists>>;

/// The document as one JSON object in SI: title, `numbers`, `lists`, `rows` and `objects` by their names (a whole
/// number without a point), `values` of all groups, `tables`, `curves` (a long one with the lows and highs of its
/// stretches only, and `thinned_from`, the number of its points), `maps` without their heights, `sources`,
/// `statements`, `notes`, `fragment`, program and commit. JSON has no NaN: such a value is null. Throws
/// std::logic_error as check_measurement does, and where a number has the name of a part.
std::string measurement_json(const Measurement& measurement, const NamedNumbers& numbers, const Provenance& provenance,
                             const NamedLists& lists = {}, const NamedRows& rows = {},
                             const NamedObjects& objects = {});

}  // namespace ringfilm::io
