#include "life/life_summary.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "text/engineering_text.hpp"

namespace ringfilm::app {
namespace {

std::size_t index_of(const std::string& name) {
  const auto& all = life::life_quantities();
  const auto found = std::find_if(all.begin(), all.end(), [&](const auto& one) { return one.name == name; });
  return static_cast<std::size_t>(found - all.begin());
}

std::string band_text(const life::LifeState& state, std::size_t quantity) {
  const life::Band band = life::band_of(state, quantity);
  return band.low < band.high ? fmt::format("{:.1f}..{:.1f}", band.low, band.high) : "";
}

std::string row(const life::LifeState& state) {
  const auto value = [&state](const char* name) { return state.values[index_of(name)]; };
  return fmt::format("{:>8.6g} {:<13} {:>8.4g} {:>8.4g} {:>7.2f} {:>15} {:>7.2f} {:>7.0f} {:>7.3f} {:>7.4f}\n",
                     state.time / life::kHour, io::state_origin_word(state.state_origin),
                     number_in(state.ring.roughness, kMicrometre), state.ring.boundary_shear_strength_coefficient,
                     value("mean_power_loss"), band_text(state, index_of("mean_power_loss")),
                     number_in(value("fmep"), kKilopascal),
                     number_in(value("mean_absolute_oil_flow"), kMilligramPerSecond),
                     value("lambda_ratio_at_peak_pressure"), value("peak_friction_coefficient_firing"));
}

std::string turned_line(const life::LifeState& state) {
  if (state.turned.empty()) return "";
  const std::size_t power = index_of("mean_power_loss"), flow = index_of("mean_absolute_oil_flow");
  return fmt::format("{:>8.6g} h, ring turned over: {:.2f} W, {:.0f} mg/s\n", state.time / life::kHour,
                     state.turned[power], number_in(state.turned[flow], kMilligramPerSecond));
}

std::string worn_table(const io::LifeDocument& document) {
  const std::vector<life::LifeState>& states = document.result.states;
  if (states.empty() || !states.front().worn) return "";
  const EngineeringText shown;
  std::string text;
  for (const life::WornQuantity& quantity : life::worn_quantities()) {
    if (!life::value_of(quantity, *states.front().worn)) continue;
    if (text.empty()) text = fmt::format("\n{:>8}", "hours");
    text += fmt::format(" {:>21}", quantity.heading);
  }
  text += "\n";
  for (const life::LifeState& state : states) {
    text += fmt::format("{:>8.6g}", state.time / life::kHour);
    for (const life::WornQuantity& quantity : life::worn_quantities()) {
      if (const auto value = life::value_of(quantity, *state.worn))
        text += fmt::format(" {:>21}", shown(quantity, *value));
    }
    text += "\n";
  }
  return text;
}

std::string points_table(const io::LifeDocument& document) {
  const std::vector<life::OperatingPoint>& points = document.file.life.points;
  if (points.size() == 1) return "";
  std::string text = fmt::format("\n{:>8} {:<24} {:>7} {:>8} {:>8} {:>9} {:>9}\n", "hours", "operating point",
                                 "share %", "power W", "FMEP kPa", "film um", "flow mg/s");
  for (const life::LifeState& state : document.result.states) {
    for (std::size_t i = 0; i < points.size(); ++i) {
      const auto value = [&](const char* name) { return state.points[i][index_of(name)]; };
      text += fmt::format("{:>8.6g} {:<24} {:>7.3g} {:>8.2f} {:>8.2f} {:>9.3f} {:>9.0f}\n", state.time / life::kHour,
                          points[i].name, 100 * points[i].share, value("mean_power_loss"),
                          number_in(value("fmep"), kKilopascal), number_in(value("min_film_thickness"), kMicrometre),
                          number_in(value("mean_absolute_oil_flow"), kMilligramPerSecond));
    }
  }
  return text;
}

std::string least_wear_line(const life::LifeState& state) {
  if (state.least_wear.empty()) return "";
  const auto [low, high] =
      std::minmax_element(state.least_wear.begin(), state.least_wear.end(),
                          [](const life::WearBound& a, const life::WearBound& b) { return a.area < b.area; });
  return fmt::format(
      "{:>8.6g} h: the face has lost at least {:.2g} to {:.2g} um mm, by how much of its edges is trusted\n",
      state.time / life::kHour, number_in(low->area, kWornArea), number_in(high->area, kWornArea));
}

std::string fit_table(const life::CoefficientFit& fit) {
  std::string text = fmt::format("\n{:>8} {:<26} {:>16} {:>8} {:>16}\n", "hours", "fitted to", "worn area um mm",
                                 "rms um", "coefficient m2/N");
  for (const life::FittedCoefficient& row : fit.rows) {
    const bool is_bound = row.basis == life::FitBasis::kMinWear;
    const std::string basis = is_bound ? "least wear, edges - " + text_in(row.trusted, kMillimetre, 3)
                                       : "closest face, +-" + text_in(row.trusted, kMillimetre, 2);
    text += fmt::format("{:>8.6g} {:<26} {:>16.3g} {:>8} {:>16}\n", row.time / life::kHour, basis,
                        number_in(row.worn_area, kWornArea),
                        row.rms ? fmt::format("{:.2f}", number_in(*row.rms, kMicrometre)) : "",
                        row.coefficient ? fmt::format("{:.2g}", *row.coefficient)
                        : row.is_flat   ? "face is flat"
                                        : "not determined");
  }
  return text +
         fmt::format("the measured faces allow mean coefficients from {:.2g} to {:.2g} m2/N, a factor of {:.3g}\n",
                     fit.range.low, fit.range.high, fit.range.high / fit.range.low);
}

std::string wear_table(const io::LifeDocument& document) {
  const life::WearEffort& effort = document.result.wear->effort;
  std::string text;
  for (const life::LifeState& state : document.result.states) {
    for (const life::FaceDistance& distance : state.from_measured) {
      text +=
          fmt::format("{:>8.6g} h: {} rms from the measured face within {} of the middle\n", state.time / life::kHour,
                      text_in(distance.rms, kMicrometre, 3), text_in(distance.half_width, kMillimetre, 2));
    }
  }
  if (const auto& implied = document.result.wear->implied) {
    text += fmt::format("mean coefficient that the measured faces imply as a lower bound: {:.2g} to {:.2g} m2/N\n",
                        implied->low, implied->high);
  }
  if (const auto& fit = document.result.wear->fit) text += fit_table(*fit);
  return text + fmt::format("{} jumps, {} rejected; stages of a jump differ by up to {}, volumes by {:.1g}\n",
                            effort.jumps, effort.rejected_jumps, text_in(effort.stage_difference, kMicrometre, 2),
                            effort.balance_error);
}

std::string when(const std::optional<double>& time) {
  return time ? fmt::format("after {:.4g} h", *time / life::kHour) : "not within the reported hours";
}

std::string end_lines(const io::LifeDocument& document) {
  std::string text;
  for (std::size_t i = 0; i < document.result.ends.size(); ++i) {
    const life::EndRule& rule = document.file.life.end_rules[i];
    const life::EndOfLife& end = document.result.ends[i];
    text += fmt::format("end of life by {}: {}", rule.quantity, when(end.time));
    if (end.starts_above) text += *end.starts_above ? ", starts above the limit" : ", starts below the limit";
    for (std::size_t k = 0; k < document.result.ends[i].other_paths.size(); ++k) {
      text +=
          fmt::format("; {}: {}", document.result.other_paths[k].name, when(document.result.ends[i].other_paths[k]));
    }
    text += "\n";
  }
  return text;
}

}  // namespace

std::string life_summary(const io::LifeDocument& document) {
  const life::Life& life = document.file.life;
  std::string text = fmt::format("{}\nmeasured states: {}; operating points: {}\n\n", life.title, life.states.size(),
                                 life.points.size());
  text += fmt::format("{:>8} {:<13} {:>8} {:>8} {:>7} {:>15} {:>7} {:>7} {:>7} {:>7}\n", "hours", "state is",
                      "sigma um", "zeta", "power W", "band W", "FMEP kPa", "flow mg/s", "lambda", "mu");
  for (const life::LifeState& state : document.result.states) text += row(state);
  text += "\n";
  for (const life::LifeState& state : document.result.states) text += turned_line(state);
  for (const life::LifeState& state : document.result.states) text += least_wear_line(state);
  text += points_table(document);
  text += worn_table(document);
  if (document.result.wear) text += wear_table(document);
  text += end_lines(document);
  text += fmt::format("\n{} cycles\n", document.result.cycles);
  for (const cycle::Note& note : document.result.notes) {
    text += fmt::format("note ({} cycles): {}\n", note.count, note.message);
  }
  return text;
}

}  // namespace ringfilm::app
