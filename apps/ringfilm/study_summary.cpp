#include "study_summary.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "ringfilm/io/units.hpp"
#include "ringfilm/study/sobol_indices.hpp"
#include "ringfilm/study/statistics.hpp"

namespace ringfilm::app {
namespace {

/// What is told of every study; the others stand in its files.
const std::vector<std::string> kMainValues = {
    "fmep",        "mean_power_loss",       "mean_total_friction", "peak_total_friction", "min_film_thickness",
    "mixed_share", "mean_absolute_oil_flow"};

class Summary {
 public:
  explicit Summary(const io::StudyRows& rows) : rows_(rows), plan_(rows.plan) {}

  std::string text() {
    const study::Study& study = plan_.study();
    text_ = fmt::format("{}\n", study.title);
    for (const std::string& note : rows_.notes()) text_ += fmt::format("note: {}\n", note);
    for (std::size_t b = 0; b < study.bases.size(); ++b) tell_base(b);
    tell_unsolved();
    return text_;
  }

 private:
  /// Values of the points of one base, in their order: those of a sample alone, or all.
  std::vector<double> of_base(const std::vector<double>& all, std::size_t base, bool sample_only) const {
    std::vector<double> values;
    for (std::uint64_t p = 0; p < plan_.n_points(base); ++p) {
      if (!sample_only || plan_.is_sample(p)) values.push_back(all[plan_.scenario(base, p)]);
    }
    return values;
  }

  void tell_base(std::size_t base) {
    const bool is_sample = plan_.is_sample(0);
    text_ += fmt::format("\nbase {}, {} scenarios\n", plan_.study().bases[base].name, plan_.n_points(base));
    text_ += is_sample ? fmt::format("  {:<24}{:>16}{:>16}{:>16}{:>16}\n", "", "mean", "5 %", "50 %", "95 %")
                       : fmt::format("  {:<24}{:>16}{:>16}{:>16}\n", "", "lowest", "median", "highest");
    const auto& quantities = cycle::cycle_quantities();
    for (std::size_t i = 0; i < quantities.size(); ++i) {
      if (std::find(kMainValues.begin(), kMainValues.end(), quantities[i].name) == kMainValues.end()) continue;
      const std::vector<double> all = rows_.values(i);
      tell_value(quantities[i], of_base(all, base, is_sample), is_sample);
      if (plan_.study().sampling.indices != study::Indices::kNone && quantities[i].name == kMainValues.front())
        indices_ = indices_text(of_base(all, base, false), quantities[i].name);
    }
    text_ += std::exchange(indices_, "");
  }

  void tell_value(const cycle::Quantity& quantity, const std::vector<double>& values, bool is_sample) {
    const std::vector<double> sorted = study::sorted_values(values);
    if (sorted.empty()) return;
    const auto shown = [&](double x) {
      const double converted = units_.scale(quantity.display_unit, quantity.unit).from_si(x);
      const std::string unit = quantity.display_unit == "1" ? "" : " " + quantity.display_unit;
      return fmt::format("{:>16}", fmt::format("{:.5g}{}", converted, unit));
    };
    text_ += fmt::format("  {:<24}", quantity.name);
    const auto mean = study::mean_of(values);
    if (is_sample) {
      text_ += mean ? shown(mean->value) : fmt::format("{:>16}", "");
      for (const double share : {0.05, 0.5, 0.95}) text_ += shown(study::quantile_of(sorted, share).value);
    } else {
      text_ += shown(sorted.front()) + shown(study::quantile_of(sorted, 0.5).value) + shown(sorted.back());
    }
    text_ += "\n";
  }

  std::string indices_text(const std::vector<double>& values, const std::string& of) const {
    const auto found = study::sobol_indices(values, plan_.groups().size());
    if (!found) return "";
    std::string text = fmt::format("  share in the variance of {}, with 95 % intervals\n", of);
    for (std::size_t g = 0; g < plan_.groups().size(); ++g) {
      const auto& [first, total] = std::pair{found->first[g], found->total[g]};
      text +=
          fmt::format("    {:<36} alone {:5.2f} ({:.2f} to {:.2f})   with interactions {:5.2f} ({:.2f} to {:.2f})\n",
                      plan_.groups()[g].name, first.value, first.low, first.high, total.value, total.low, total.high);
    }
    return text;
  }

  void tell_unsolved() {
    const auto unsolved = rows_.unsolved();
    if (unsolved.empty()) return;
    text_ += fmt::format("\n{} of {} scenarios were not solved; the first:\n", unsolved.size(), plan_.size());
    constexpr std::size_t kTold = 3;
    for (std::size_t i = 0; i < std::min(unsolved.size(), kTold); ++i)
      text_ += fmt::format("  scenario {}: {}\n", unsolved[i].scenario, unsolved[i].reason);
  }

  const io::StudyRows& rows_;
  const study::Plan& plan_;
  io::Units units_;
  std::string text_, indices_;
};

}  // namespace

std::string study_summary(const io::StudyRows& rows) { return Summary(rows).text(); }

}  // namespace ringfilm::app
