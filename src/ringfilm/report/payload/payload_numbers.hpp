#pragma once
#include <nlohmann/json.hpp>
#include <vector>

/// Numbers for the script of a page: JSON has no NaN: such a value becomes null.
namespace ringfilm::report {

nlohmann::ordered_json exact(double value);

/// With so many significant digits.
nlohmann::ordered_json rounded(double value, int digits);

nlohmann::ordered_json exact_list(const std::vector<double>& values);
nlohmann::ordered_json rounded_list(const std::vector<double>& values, int digits);

}  // namespace ringfilm::report
