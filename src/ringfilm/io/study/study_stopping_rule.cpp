#include "ringfilm/io/study/study_stopping_rule.hpp"

#include <fmt/format.h>

#include "ringfilm/cycle/result/result.hpp"
#include "ringfilm/io/text/units.hpp"
#include "ringfilm/study/statistics/stopping_rule.hpp"

namespace ringfilm::io {

std::vector<std::string> until_notes(const study::Plan& plan, const std::vector<double>& values) {
  const study::Study& study = plan.study();
  if (!study.sampling.until) return {};
  const study::StoppingRule& until = *study.sampling.until;
  const cycle::Quantity& quantity = plan.values().quantities[*plan.values().index(until.value)];
  const auto bases = study::interval_widths(plan, values);
  const Units units;
  const auto shown = [&](double width) { return units.shown(width, quantity.unit, quantity.display_unit, 4); };
  const bool is_sure = study::is_sure(until, bases);
  std::string note =
      fmt::format("{} {} points: the 95 % interval of {} is ", is_sure ? "stopped after" : "gave up after",
                  study.sampling.scenarios, study::statistic_words(until));
  for (std::size_t i = 0; i < bases.size(); ++i) {
    if (i > 0) note += ", ";
    note += bases[i].width ? shown(*bases[i].width) + " wide" : "unknown, with too few solved scenarios,";
    if (bases.size() > 1) note += fmt::format(" for {}", study.bases[bases[i].base].name);
  }
  return {fmt::format("{}; required: {}", note, shown(until.width))};
}

}  // namespace ringfilm::io
