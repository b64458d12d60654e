#include "ringfilm/report/payload/payload_numbers.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <iterator>

namespace ringfilm::report {

using nlohmann::ordered_json;

ordered_json exact(double value) { return std::isfinite(value) ? ordered_json(value) : ordered_json(nullptr); }

ordered_json rounded(double value, int digits) {
  if (!std::isfinite(value)) return nullptr;
  fmt::memory_buffer text;
  fmt::format_to(std::back_inserter(text), "{:.{}g}", value, digits);
  double parsed = 0;
  std::from_chars(text.data(), text.data() + text.size(), parsed);
  return parsed;
}

ordered_json exact_list(const std::vector<double>& values) {
  ordered_json list = ordered_json::array();
  for (const double value : values) list.push_back(exact(value));
  return list;
}

ordered_json rounded_list(const std::vector<double>& values, int digits) {
  ordered_json list = ordered_json::array();
  for (const double value : values) list.push_back(rounded(value, digits));
  return list;
}

}  // namespace ringfilm::report
