#include "ringfilm/report/trends_json.hpp"

#include <nlohmann/json.hpp>

#include "ringfilm/report/payload/payload_numbers.hpp"

namespace ringfilm::report {
namespace {

using nlohmann::ordered_json;
using study::Trend;
using study::TrendExpectation;

ordered_json levels_array(const study::TrendOutcome& outcome) {
  ordered_json levels = ordered_json::array();
  for (std::size_t i = 0; i < outcome.values.size(); ++i) {
    const study::TrendLevel& level = outcome.trend.levels[i];
    levels.push_back({{"name", level.name}, {"set", level.settings}, {"value", exact(outcome.values[i])}});
  }
  return levels;
}

ordered_json trend_object(const study::TrendOutcome& outcome) {
  const Trend& trend = outcome.trend;
  ordered_json object = {{"id", trend.id},
                         {"statement", trend.statement},
                         {"size", trend.size},
                         {"source", trend.source},
                         {"assumed", trend.assumed},
                         {"base", trend.base},
                         {"set", trend.settings},
                         {"quantity", outcome.quantity.long_name},
                         {"unit", outcome.quantity.unit},
                         {"ring", trend.probe.ring ? ordered_json(*trend.probe.ring) : ordered_json(nullptr)},
                         {"levels", levels_array(outcome)},
                         {"change", exact(outcome.change)},
                         {"expect", study::word_of(study::trend_expectations(), trend.expectation)},
                         {"outcome", study::word_of(study::agreements(), outcome.found)},
                         {"known", study::word_of(study::agreements(), trend.known)},
                         {"reason", trend.reason},
                         {"as_recorded", outcome.is_as_recorded()},
                         {"stops", outcome.stops}};
  if (trend.expectation == TrendExpectation::kLargerChangeThan) object["than"] = trend.than;
  if (trend.expectation == TrendExpectation::kWithin) object["limits"] = {trend.least_limit, trend.most_limit};
  return object;
}

}  // namespace

std::string trends_json(const std::vector<study::TrendOutcome>& outcomes,
                        const std::vector<study::InexpressibleTrend>& inexpressible, const io::Provenance& provenance) {
  ordered_json trends = ordered_json::array(), others = ordered_json::array();
  for (const study::TrendOutcome& outcome : outcomes) trends.push_back(trend_object(outcome));
  for (const auto& [id, statement, source, reason] : inexpressible) {
    others.push_back({{"id", id}, {"statement", statement}, {"source", source}, {"reason", reason}});
  }
  const ordered_json result = {{"trends", std::move(trends)},
                               {"inexpressible", std::move(others)},
                               {"program", provenance.program},
                               {"commit", provenance.commit}};
  return result.dump(2, ' ', false, ordered_json::error_handler_t::replace) + "\n";
}

}  // namespace ringfilm::report
