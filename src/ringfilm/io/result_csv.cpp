#include "ringfilm/io/result_csv.hpp"

#include <fmt/format.h>

#include <cmath>

namespace ringfilm::io {

std::string result_csv(const std::vector<cycle::Sample>& samples) {
  const auto& quantities = cycle::curve_quantities();
  std::string csv;
  const char* separator = "";
  for (const auto& quantity : quantities) {
    csv += separator + quantity.name;
    if (quantity.unit != "1") csv += " [" + quantity.unit + "]";
    separator = ",";
  }
  csv += '\n';
  for (const cycle::Sample& sample : samples) {
    separator = "";
    for (const auto& quantity : quantities) {
      const double value = sample.*quantity.value;
      csv += separator;
      csv += std::isnan(value) ? "nan" : fmt::format("{}", value + 0.0);  // the sign of a NaN or a zero says nothing
      separator = ",";
    }
    csv += '\n';
  }
  return csv;
}

}  // namespace ringfilm::io
