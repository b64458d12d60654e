#include "ringfilm/study/statistics/main_values.hpp"

#include <stdexcept>

namespace ringfilm::study {

const std::vector<std::string>& main_values() {
  static const std::vector<std::string> names = {
      "fmep",        "mean_power_loss",       "mean_total_friction", "peak_total_friction", "min_film_thickness",
      "mixed_share", "mean_absolute_oil_flow"};
  return names;
}

std::vector<double> values_of_base(const Plan& plan, std::span<const double> all, std::size_t base, Among among) {
  if (all.size() < plan.size()) throw std::out_of_range("fewer values than the plan has scenarios");
  std::vector<double> values;
  for (std::uint64_t p = 0; p < plan.n_points(base); ++p) {
    if (among == Among::kAll || plan.is_sample(p)) values.push_back(all[plan.scenario(base, p)]);
  }
  return values;
}

bool has_sample(const Plan& plan) { return plan.is_sample(0); }

}  // namespace ringfilm::study
