#include "ringfilm/life/end_of_life.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include "ringfilm/base/find_by_name.hpp"

namespace ringfilm::life {
namespace {

constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

double worn_value(const std::optional<WornProfile>& worn, const std::string& name) {
  if (!worn) return kUnknown;
  return value_of(*find_by_name(worn_quantities(), name), *worn).value_or(kUnknown);
}

/// A state on one of several paths; `values` are empty where the path ended before.
struct OnPath {
  const LifeValues& values;
  const std::optional<WornProfile>& worn;
};
using StateOnPath = std::function<OnPath(const LifeState&)>;

OnPath on_other_path(const LifeState& state, std::size_t k) {
  return {state.other_paths[k], state.other_worn.empty() ? state.worn : state.other_worn[k]};
}

std::optional<std::size_t> life_quantity_index(const std::string& name) {
  for (std::size_t i = 0; i < life_quantities().size(); ++i) {
    if (life_quantities()[i].name == name) return i;
  }
  return std::nullopt;
}

/// A quantity over the running time of a path.
struct Series {
  std::vector<double> times, values;

  void append(double time, double value) {
    times.push_back(time);
    values.push_back(value);
  }
};

Series cycle_series(const LifeResult& result, const StateOnPath& on_path, std::size_t quantity) {
  Series series;
  for (const LifeState& state : result.states) {
    const LifeValues& values = on_path(state).values;
    series.append(state.time, values.empty() ? kUnknown : values[quantity]);
  }
  return series;
}

/// What is worn of a scenario is also known at its start and where its coating ends.
Series worn_series(const LifeResult& result, const StateOnPath& on_path, const std::optional<WearThrough>& end,
                   const std::string& quantity) {
  Series series;
  const bool is_computed = end || (!result.states.empty() && !on_path(result.states.front()).values.empty());
  if (!is_computed) return series;
  if (result.wear && (result.states.empty() || result.states.front().time > 0)) {
    series.append(0, worn_value(result.unworn, quantity));
  }
  for (const LifeState& state : result.states) {
    const auto& [values, worn] = on_path(state);
    if (values.empty()) break;
    series.append(state.time, worn_value(worn, quantity));
  }
  if (end) series.append(end->time, worn_value(end->worn, quantity));
  return series;
}

}  // namespace

const std::vector<cycle::Quantity>& limitable_quantities() {
  static const std::vector<cycle::Quantity> table = [] {
    std::vector<cycle::Quantity> all(life_quantities().begin(), life_quantities().end());
    all.insert(all.end(), worn_quantities().begin(), worn_quantities().end());
    return all;
  }();
  return table;
}

void append_notes_of_ends(const Life& life, LifeResult& result) {
  for (const EndRule& rule : life.end_rules) {
    const bool is_known = life_quantity_index(rule.quantity).has_value() ||
                          (result.wear && result.wear->worn_through &&
                           !std::isnan(worn_value(result.wear->worn_through->worn, rule.quantity))) ||
                          std::any_of(result.states.begin(), result.states.end(), [&](const LifeState& state) {
                            return !std::isnan(worn_value(state.worn, rule.quantity));
                          });
    if (is_known) continue;
    result.notes.push_back(
        {"end-of-life-not-known",
         "end_of_life." + rule.quantity + " is not determined by this life: its limit is not checked", 1});
  }
}

std::optional<double> reaching_time(const std::vector<double>& times, const std::vector<double>& values, double limit) {
  if (values.empty() || std::isnan(values.front())) return std::nullopt;
  const bool from_below = values.front() < limit;
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (std::isnan(values[i])) return std::nullopt;
    const bool is_met = from_below ? values[i] >= limit : values[i] <= limit;
    if (!is_met) continue;
    if (i == 0) return times[0];
    const double share = (limit - values[i - 1]) / (values[i] - values[i - 1]);
    return times[i - 1] + share * (times[i] - times[i - 1]);
  }
  return std::nullopt;
}

std::vector<EndOfLife> ends_of_life(const Life& life, const LifeResult& result) {
  const WearSummary no_wear;
  const WearSummary& wear = result.wear ? *result.wear : no_wear;
  std::vector<EndOfLife> ends;
  for (const EndRule& rule : life.end_rules) {
    const auto index = life_quantity_index(rule.quantity);
    std::optional<bool> starts_above;  // on the path of the life, which is asked first
    const auto when = [&](const std::optional<WearThrough>& through, const StateOnPath& on_path) {
      const Series series =
          index ? cycle_series(result, on_path, *index) : worn_series(result, on_path, through, rule.quantity);
      if (!starts_above && !series.values.empty() && !std::isnan(series.values.front())) {
        starts_above = series.values.front() > rule.limit;
      }
      return reaching_time(series.times, series.values, rule.limit);
    };
    EndOfLife end;
    end.time = when(wear.worn_through, [](const LifeState& state) { return OnPath{state.values, state.worn}; });
    for (std::size_t k = 0; k < result.other_paths.size(); ++k) {
      end.other_paths.push_back(when(k < wear.other_worn_through.size() ? wear.other_worn_through[k] : std::nullopt,
                                     [k](const LifeState& state) { return on_other_path(state, k); }));
    }
    end.turned = when(wear.turned_worn_through, [](const LifeState& state) {
      return OnPath{state.turned, state.turned_worn ? state.turned_worn : state.worn};
    });
    end.starts_above = starts_above;
    ends.push_back(std::move(end));
  }
  return ends;
}

}  // namespace ringfilm::life
