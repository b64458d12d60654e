#include "ringfilm/cycle/advice/gas_edge_notes.hpp"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>

#include "ringfilm/base/constants.hpp"
#include "ringfilm/base/display.hpp"

namespace ringfilm::cycle {
namespace {

/// The crank angles [degree] between which all samples lie that satisfy a condition: what is outside is the longest
/// stretch of the cycle without one. Nothing where none does.
template <class Condition>
std::optional<std::pair<double, double>> span_of(const std::vector<Sample>& samples, const Condition& condition) {
  std::vector<double> angles;
  for (const Sample& sample : samples) {
    if (condition(sample)) angles.push_back(sample.crank_angle_deg);
  }
  if (angles.empty()) return std::nullopt;
  std::size_t first = 0;
  double longest = angles.front() + base::kCycleDeg - angles.back();
  for (std::size_t i = 1; i < angles.size(); ++i) {
    if (angles[i] - angles[i - 1] <= longest) continue;
    longest = angles[i] - angles[i - 1];
    first = i;
  }
  return std::pair(angles[first], angles[(first + angles.size() - 1) % angles.size()]);
}

/// How much gas blows through a broken film; nothing of a cycle that was not finished.
std::string words_on_gas_through_film(const CycleValues& values) {
  const double forward = values.gas_through_film_forward, back = values.gas_through_film_back;
  if (forward + back == 0) return "";
  return ", and " + text_in(forward, kMilligram, 3) + " of gas per cycle blow through towards the crankcase" +
         (back > 0 ? ", " + text_in(back, kMilligram, 3) + " back" : "") + "; an upper bound (eq-face-flow)";
}

void append_breakthrough_note(const std::vector<Sample>& base, const CycleValues& values, std::vector<Note>& notes) {
  const auto broken = [](const Sample& s) { return s.gas_breakthrough > 0; };
  const auto span = span_of(base, broken);
  if (!span) return;
  notes.push_back(
      {"gas-breaks-through",
       formatted("gas of an edge reaches the lowest place of the face, first at %.0f and last at %.0f degree: the "
                 "film does not hold it there%s",
                 span->first, span->second, words_on_gas_through_film(values).c_str()),
       std::count_if(base.begin(), base.end(), broken)});
}

void append_off_liner_note(const std::vector<Sample>& base, std::vector<Note>& notes) {
  const auto off = [](const Sample& s) { return s.distance_off_liner > 0; };
  const auto span = span_of(base, off);
  if (!span) return;
  double farthest = 0;
  for (const Sample& s : base) farthest = std::max(farthest, s.distance_off_liner);
  notes.push_back(
      {"radial-collapse",
       formatted("gas holds the ring off the liner, first at %.0f and last at %.0f degree, by up to %s: its "
                 "pressures on the face exceed tension and gas behind the ring, and what closes the ring "
                 "is its own stiffness and the end gap (eq-radial-collapse)",
                 span->first, span->second, text_in(farthest, kMicrometre, 3).c_str()),
       std::count_if(base.begin(), base.end(), off)});
}

}  // namespace

void append_gas_edge_notes(const std::vector<Sample>& base, const CycleValues& values, std::vector<Note>& notes) {
  append_breakthrough_note(base, values, notes);
  append_off_liner_note(base, notes);
}

}  // namespace ringfilm::cycle
