#include "ringfilm/study/verification/trends.hpp"

#include <algorithm>
#include <cmath>

#include "ringfilm/base/find_by_name.hpp"
#include "ringfilm/cycle/pack/gas_quantities.hpp"

namespace ringfilm::study {
namespace {

bool is_expected(const Trend& trend, const std::vector<double>& values, double change_of_other) {
  using enum TrendExpectation;
  const double first = values.front(), last = values.back(), least = trend.least_change;
  const double change = relative_change(values);
  // A step against the trend that is smaller than a change is scatter.
  const auto never_against = [&](double sign) {
    for (std::size_t i = 1; i < values.size(); ++i) {
      if (sign * (values[i] / values[i - 1] - 1) < -least) return false;
    }
    return true;
  };
  const auto [smallest, largest] = std::minmax_element(values.begin(), values.end());
  switch (trend.expectation) {
    case kRises:
      return change > least && never_against(1);
    case kFalls:
      return change < -least && never_against(-1);
    case kHasMinimumInside:
      return std::min(first, last) > *smallest * (1 + least);
    case kUnchanged:
      return *largest <= first * (1 + least) && *smallest >= first * (1 - least);
    case kLargerChangeThan:
      return std::abs(change) > std::abs(change_of_other);
    case kWithin:
      return *smallest >= trend.least_limit && *largest <= trend.most_limit;
  }
  return false;
}

}  // namespace

std::optional<cycle::Quantity> find_probed(const TrendProbe& probe, const std::string& name) {
  const auto found_in = [&](const auto& quantities) -> std::optional<cycle::Quantity> {
    const auto* found = find_by_name(quantities, name);
    return found == nullptr ? std::nullopt : std::optional<cycle::Quantity>(*found);
  };
  if (probe.window) return found_in(cycle::curve_quantities());
  const auto of_cycle = found_in(cycle::cycle_quantities());
  const bool is_alone = name == probe.quantity;  // a value of the rings has no share in one of the gas
  return of_cycle || !is_alone ? of_cycle : found_in(cycle::gas_sum_quantities());
}

cycle::Quantity probed_quantity(const TrendProbe& probe) {
  cycle::Quantity quantity = find_probed(probe, probe.quantity).value();
  if (!probe.share_of) return quantity;
  quantity.long_name += " over " + find_probed(probe, *probe.share_of).value().long_name;
  quantity.unit = "1";
  quantity.display_unit = "%";
  return quantity;
}

bool is_of_gas(const TrendProbe& probe) { return !probe.window && cycle::is_gas_sum(probe.quantity); }

const std::vector<std::pair<std::string, TrendExpectation>>& trend_expectations() {
  using enum TrendExpectation;
  static const std::vector<std::pair<std::string, TrendExpectation>> table = {
      {"rises", kRises},         {"falls", kFalls},
      {"unchanged", kUnchanged}, {"has-minimum-inside", kHasMinimumInside},
      {"within", kWithin},       {"larger-change-than", kLargerChangeThan}};
  return table;
}

const std::vector<std::pair<std::string, Agreement>>& agreements() {
  static const std::vector<std::pair<std::string, Agreement>> table = {{"agrees", Agreement::kAgrees},
                                                                       {"disagrees", Agreement::kDisagrees}};
  return table;
}

double relative_change(const std::vector<double>& values) { return values.back() / values.front() - 1; }

Agreement agreement(const Trend& trend, const std::vector<double>& values, double change_of_other) {
  const bool is_complete = std::none_of(values.begin(), values.end(), [](double value) { return std::isnan(value); });
  return is_complete && is_expected(trend, values, change_of_other) ? Agreement::kAgrees : Agreement::kDisagrees;
}

}  // namespace ringfilm::study
