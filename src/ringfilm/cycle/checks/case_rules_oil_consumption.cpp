#include "ringfilm/cycle/checks/case_rules_oil_consumption.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "ringfilm/base/display.hpp"
#include "ringfilm/cycle/checks/case_rules.hpp"

namespace ringfilm::cycle {
namespace {

const std::string kDistillation = "lubricant.distillation", kNoack = "lubricant.noack";
constexpr double kRounding = 1e-6;  ///< rounding of shares that are typed [-]

/// Hottest place of the liner, or the one temperature of the oil; 0 where neither is stated [K].
double hottest_wall(const Case& c) {
  double hottest = c.thermal.liner.empty() ? c.operating.oil_temperature : 0;
  for (const StrokeValue& point : c.thermal.liner) hottest = std::max(hottest, point.value);
  return hottest;
}

}  // namespace

void append_cylinder_breaches(const Engine& engine, std::vector<RuleBreach>& breaches) {
  if (!engine.cylinders || *engine.cylinders == std::round(*engine.cylinders)) return;
  breaches.push_back({"engine.cylinders", "engine.cylinders = " + number_text(*engine.cylinders) + " is not whole",
                      "state how many cylinders the engine has, for example 4"});
}

void append_oil_consumption_breaches(const Case& c, std::vector<RuleBreach>& breaches) {
  append_cylinder_breaches(c.engine, breaches);
  for (const auto& [key, value] : {std::pair{"operating.brake_power", c.operating.brake_power},
                                   std::pair{"operating.fuel_rate", c.operating.fuel_rate}}) {
    if (!value || c.engine.cylinders) continue;
    breaches.push_back({"engine.cylinders",
                        std::string(key) + " is that of the engine, and engine.cylinders is missing",
                        "write, for example, cylinders = 4 in [engine]", RuleBreach::By::kMissingKey});
  }
  if (!c.lubricant.evaporates() || !c.follows_oil()) return;
  if (c.lubricant.noack && !c.lubricant.distillation.empty()) {
    breaches.push_back({kNoack, kNoack + " and " + kDistillation + " are both stated",
                        "keep one of them: either states how the oil evaporates"});
    return;
  }
  const std::vector<models::OilFraction> fractions = c.lubricant.fractions();
  double sum = 0;
  for (std::size_t i = 0; i < fractions.size(); ++i) {
    sum += fractions[i].share;
    if (i == 0 || fractions[i].boiling_point > fractions[i - 1].boiling_point) continue;
    breaches.push_back({kDistillation,
                        kDistillation + " has the boiling point " + text_in(fractions[i].boiling_point, kCelsius) +
                            " after " + text_in(fractions[i - 1].boiling_point, kCelsius),
                        "list the fractions by rising boiling points, at 1.01325 bar"});
  }
  if (std::abs(sum - 1) > kRounding) {
    breaches.push_back({kDistillation, "the shares in " + kDistillation + " add up to " + number_text(sum) + ", not 1",
                        "state the share of the mass of each fraction, the heaviest one included"});
  }
  const double hottest = hottest_wall(c), last = fractions.back().boiling_point;
  if (hottest < last) return;
  breaches.push_back({kDistillation,
                      "the liner is as hot as " + text_in(hottest, kCelsius) + ", above the last boiling point in " +
                          kDistillation + ", " + text_in(last, kCelsius) + ": no oil would remain",
                      "check the boiling points, which are those at 1.01325 bar, and thermal.liner"});
}

}  // namespace ringfilm::cycle
