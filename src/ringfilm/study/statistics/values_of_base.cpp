#include "ringfilm/study/statistics/values_of_base.hpp"

#include <stdexcept>

namespace ringfilm::study {

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
