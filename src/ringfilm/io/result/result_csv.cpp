#include "ringfilm/io/result/result_csv.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "ringfilm/io/result/result_document.hpp"

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

namespace {

/// Is the sum over the rings that of the pack?
bool adds_up(const cycle::CurveQuantity& quantity) {
  static const std::set<std::string> names = {
      "hydrodynamic_load",     "asperity_load",  "boundary_friction", "viscous_friction", "viscous_friction_liner",
      "viscous_friction_ring", "total_friction", "friction_on_liner", "power_loss",       "archard_wear_load_rate",
      "applied_load"};
  return names.contains(quantity.name);
}

/// Is it the same for each ring?
bool is_of_engine(const cycle::CurveQuantity& quantity) {
  static const std::set<std::string> names = {"crank_angle", "piston_position", "piston_velocity", "sliding_distance"};
  return names.contains(quantity.name);
}

/// Rows of the sums over all rings, where each has been computed for the same crank angles.
std::string rows_of_all(const ResultDocument& pack) {
  const auto& first = pack.rings.front().result.samples;
  const auto has_all = [&](const ResultDocument& ring) { return ring.result.samples.size() == first.size(); };
  if (pack.rings.size() < 2 || !pack.result.complete || !std::ranges::all_of(pack.rings, has_all)) return "";
  std::vector<cycle::Sample> sums = first;
  for (std::size_t k = 0; k < sums.size(); ++k) {
    for (const auto& quantity : cycle::curve_quantities()) {
      if (is_of_engine(quantity)) continue;
      double& value = sums[k].*quantity.value;
      value = adds_up(quantity) ? 0 : std::numeric_limits<double>::quiet_NaN();
      for (const ResultDocument& ring : pack.rings) {
        if (adds_up(quantity)) value += ring.result.samples[k].*quantity.value;
      }
    }
  }
  std::string rows;
  const bool has_errors = pack.rings.front().errors && study::has_values(*pack.rings.front().errors);
  for (const cycle::Sample& sample : sums) {
    rows += "all";
    for (const auto& quantity : cycle::curve_quantities()) rows += "," + exact_number(sample.*quantity.value);
    for (std::size_t i = 0; i < cycle::unrolled_quantities().size(); ++i) {
      if (!pack.rings.front().result.unrolled_samples.empty()) rows += ",nan";
    }
    for (const auto& quantity : cycle::curve_quantities()) {
      if (has_errors && study::has_error(quantity)) rows += ",nan";
    }
    rows += '\n';
  }
  return rows;
}

}  // namespace

std::string result_csv(const ResultDocument& document) {
  const auto of = [](const ResultDocument& one) {
    return result_csv(one.result.samples, one.errors, one.result.unrolled_samples);
  };
  if (!document.is_pack()) return of(document);
  std::string all;
  const std::vector<std::size_t> numbers = ring_numbers(document);
  for (std::size_t i = 0; i < document.rings.size(); ++i) {
    const long rail = document.rings[i].rail;
    const std::string number = fmt::format("{}{}", numbers[i], rail > 0 ? fmt::format(".{}", rail) : "");
    const std::string csv = of(document.rings[i]);
    std::size_t begin = 0;
    for (std::size_t end = csv.find('\n'); end != std::string::npos; begin = end + 1, end = csv.find('\n', begin)) {
      if (begin == 0 && i > 0) continue;  // the header, which all rings have
      all += (begin == 0 ? "ring" : number) + "," + csv.substr(begin, end + 1 - begin);
    }
  }
  return all + rows_of_all(document);
}

}  // namespace ringfilm::io
