#include "ringfilm/io/study/study_flat_notes.hpp"

#include <fmt/format.h>

#include "ringfilm/io/text/units.hpp"

namespace ringfilm::io {
namespace {

std::string number(double value, const study::Factor& factor, const Units& units) {
  if (factor.unit == "1" || factor.unit.empty()) return fmt::format("{:.4g}", value);
  const double shown = units.scale(factor.display_unit, factor.unit).from_si(value);
  return fmt::format("{:.4g} {}", shown, factor.display_unit);
}

}  // namespace

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
      factors += fmt::format(" from {} to {}", number(range.low, factor, units), number(range.high, factor, units));
    }
    if (factors.empty()) continue;
    notes.push_back(fmt::format(
        "{} changes by less than {:.2g} % with {}, the other factors unchanged: such a factor cannot be "
        "fitted to a measured {}",
        plan.values().quantities[value].name, 100 * tolerance, factors, plan.values().quantities[value].name));
  }
  return notes;
}

}  // namespace ringfilm::io
