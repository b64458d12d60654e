#include "ringfilm/io/study/factor_notes.hpp"

#include <fmt/format.h>

#include <numeric>
#include <utility>

#include "ringfilm/io/text/units.hpp"

namespace ringfilm::io {

std::vector<std::string> flat_notes(const study::Plan& plan, const std::vector<study::FlatRange>& ranges,
                                    double tolerance) {
  const Units units;
  std::vector<std::string> notes;
  for (std::size_t value = 0; value < plan.values().quantities.size(); ++value) {
    std::string factors;
    for (const study::FlatRange& range : ranges) {
      if (range.value != value) continue;
      const study::Factor& factor = plan.study().factors[range.factor];
      factors += fmt::format("{}\"{}\"", factors.empty() ? "" : ", ", factor.name);
      if (range.is_whole) continue;
      const auto end = [&](double x) { return units.shown(x, factor.unit, factor.display_unit, 4); };
      factors += " from " + end(range.low) + " to " + end(range.high);
    }
    if (factors.empty()) continue;
    const std::string name = plan.values().quantities[value].long_name;
    notes.push_back(
        fmt::format("the {} changes by less than {:.2g} % with {}, the other factors unchanged: such a factor cannot "
                    "be fitted to a measured one",
                    name.substr(0, name.find(':')), 100 * tolerance, factors));
  }
  return notes;
}

FactorNotes::FactorNotes(const study::Plan& plan) : plan_(plan), idle_(plan), flat_(plan, study::kNotMeasured) {}

std::vector<std::size_t> FactorNotes::columns() {
  takes_all_ = !idle_.is_decided();
  if (!takes_all_) return flat_.watched();
  std::vector<std::size_t> all(plan_.values().quantities.size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  return all;
}

void FactorNotes::add(std::uint64_t scenario, std::span<const double> values) {
  if (!takes_all_) return flat_.add(scenario, values);
  std::vector<double> watched;
  for (const std::size_t i : flat_.watched()) watched.push_back(values[i]);
  if (!watched.empty()) flat_.add(scenario, watched);
  idle_.add(scenario, values);
}

std::vector<std::string> FactorNotes::notes() const {
  std::vector<std::string> notes = idle_.notes();
  for (std::string& note : flat_notes(plan_, flat_.ranges(idle_), study::kNotMeasured)) {
    notes.push_back(std::move(note));
  }
  return notes;
}

}  // namespace ringfilm::io
