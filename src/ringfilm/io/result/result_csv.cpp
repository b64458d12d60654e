#include "ringfilm/io/result/result_csv.hpp"

#include <fmt/format.h>

#include <cmath>

namespace ringfilm::io {
namespace {

std::string header(const std::string& name, const std::string& unit) {
  return unit == "1" ? name : name + " [" + unit + "]";
}

std::string exact_number(double value) {
  return std::isnan(value) ? "nan" : fmt::format("{}", value + 0.0);  // the sign of a NaN or a zero has no meaning
}

}  // namespace

std::string result_csv(const std::vector<cycle::Sample>& samples, const std::optional<study::ErrorEstimate>& errors,
                       const std::vector<cycle::UnrolledSample>& unrolled) {
  const auto& quantities = cycle::curve_quantities();
  const bool has_errors = errors && study::has_values(*errors);
  std::string csv;
  const char* separator = "";
  const auto add = [&](const std::string& cell) {
    csv += separator + cell;
    separator = ",";
  };
  for (const auto& quantity : quantities) add(header(quantity.name, quantity.unit));
  for (const auto& quantity : cycle::unrolled_quantities()) {
    if (!unrolled.empty()) add(header(quantity.name, quantity.unit));
  }
  for (const auto& quantity : quantities) {
    if (has_errors && study::has_error(quantity)) add(header(quantity.name + "_error", quantity.unit));
  }
  csv += '\n';
  for (std::size_t k = 0; k < samples.size(); ++k) {
    separator = "";
    for (const auto& quantity : quantities) add(exact_number(samples[k].*quantity.value));
    for (const auto& quantity : cycle::unrolled_quantities()) {
      if (!unrolled.empty()) add(exact_number(unrolled[k].*quantity.value));
    }
    for (const auto& quantity : quantities) {
      if (has_errors && study::has_error(quantity)) add(exact_number(errors->samples[k].*quantity.value));
    }
    csv += '\n';
  }
  return csv;
}

std::string result_csv(const ResultDocument& document) {
  const auto of = [](const ResultDocument& one) {
    return result_csv(one.result.samples, one.errors, one.result.unrolled_samples);
  };
  if (!document.is_pack()) return of(document);
  std::string all;
  for (std::size_t i = 0; i < document.rings.size(); ++i) {
    const std::string csv = of(document.rings[i]);
    std::size_t begin = 0;
    for (std::size_t end = csv.find('\n'); end != std::string::npos; begin = end + 1, end = csv.find('\n', begin)) {
      if (begin == 0 && i > 0) continue;  // the header, which all rings have
      all += (begin == 0 ? "ring," : fmt::format("{},", i + 1)) + csv.substr(begin, end + 1 - begin);
    }
  }
  return all;
}

}  // namespace ringfilm::io
