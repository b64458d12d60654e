#include "ringfilm/study/ensemble/supply_slope.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "ringfilm/base/display.hpp"
#include "ringfilm/case/conditions.hpp"
#include "ringfilm/cycle/advice/note_topics.hpp"
#include "ringfilm/study/ensemble/assumed_inputs.hpp"

namespace ringfilm::study {
namespace {

constexpr double kStep = 0.2;
/// A change of the FMEP from which on the note is worth its place; assumed.
constexpr double kSteep = 0.05;

bool has_default_supply(const cycle::Case& c) {
  return cycle::is_engine(c.conditions) && !c.stated.contains("supply.film");
}

cycle::Case with_supply(const cycle::Case& c, double factor) {
  cycle::Case changed = c;
  for (cycle::StrokeValue& point : changed.supply.film) point.value *= factor;
  return changed;
}

double fmep(const Ending& ending) { return ending.result.values.fmep; }

std::string change_words(double change) {
  return fmt::format("{:.0f} % {}", 100 * std::abs(change), change < 0 ? "lower" : "higher");
}

std::string band_words(double one, double other) {
  const double low = number_in(std::min(one, other), kKilopascal), high = number_in(std::max(one, other), kKilopascal);
  return fmt::format("; between {} and {}, what packs leave at 1000 to 4000 rpm, it lies between {:.3g} and {:.3g} kPa",
                     text_in(cycle::kOilRingFilms.low, kMicrometre, 2),
                     text_in(cycle::kOilRingFilms.high, kMicrometre, 2), low, high);
}

}  // namespace

std::vector<cycle::Case> supply_cases(const cycle::Case& c) {
  if (c.film.supply_at_inlet() == cycle::OilSupply::kFlooded || c.supply.film.empty() || !is_quick(c)) return {};
  const cycle::Case coarse = coarse_case(c);
  std::vector<cycle::Case> cases = {coarse, with_supply(coarse, 1 - kStep), with_supply(coarse, 1 + kStep)};
  if (has_default_supply(c)) {
    for (const double film : {cycle::kOilRingFilms.low, cycle::kOilRingFilms.high}) {
      cases.push_back(coarse);
      cases.back().supply.film = {{0, film}};
    }
  }
  return cases;
}

std::optional<cycle::Note> supply_note(const cycle::Case& c, std::span<const Ending> ended) {
  if (ended.empty() || !std::ranges::all_of(ended, &Ending::is_solved)) return std::nullopt;
  const double less = fmep(ended[1]) / fmep(ended[0]) - 1, more = fmep(ended[2]) / fmep(ended[0]) - 1;
  if (std::max(std::abs(less), std::abs(more)) <= kSteep) return std::nullopt;
  const bool is_default = has_default_supply(c);
  const std::string film = c.supply.film.size() > 1
                               ? "varies along the stroke"
                               : text_in(c.supply.film.front().value, kMicrometre, 3) + (is_default ? ", default" : "");
  std::string message = fmt::format(
      "friction depends steeply on supply.film ({}): with 20 % less oil on the liner the FMEP is {}, with 20 % more {}",
      film, change_words(less), change_words(more));
  if (is_default) message += band_words(fmep(ended[3]), fmep(ended[4]));
  return cycle::Note{kSupplySteep, message, 1};
}

void add_supply_note(const cycle::Case& c, cycle::CycleResult& result) {
  const std::vector<cycle::Case> cases = supply_cases(c);
  if (cases.empty()) return;
  const BatchOptions one_thread{1, {}, {}};
  std::optional<cycle::Note> note = supply_note(c, endings(cases, {}, one_thread));
  if (!note) return;
  result.notes.push_back(std::move(*note));
  cycle::sort_notes(result.notes);
}

}  // namespace ringfilm::study
