#include "ringfilm/cycle/advice/note_topics.hpp"

#include <algorithm>
#include <cmath>

namespace ringfilm::cycle {

const std::vector<NoteTopic>& note_topics() {
  using enum Trust;
  using enum NoteCount;
  using enum BadEnd;
  static const std::vector<NoteTopic> table = {
      {"friction-too-high", kNone, kCase, "fmep", kMax},
      {"film-too-thick", kNone, kCrankAngles, "max_film_thickness", kMax},
      {"film-below-molecules", kNone, kCrankAngles, "min_film_thickness", kMin},
      {"film-pressure-high", kNone, kCrankAngles, "peak_film_pressure", kMax},
      {"shear-stress-high", kNone, kCrankAngles},
      {"mass-residual", kNone, kOccurrences},
      {"face-too-steep", kNone, kCase},
      {"lambda-ratio-too-low", kNone, kCrankAngles, "min_lambda_ratio", kMin},
      {"synthetic-trace", kLimited, kCase},
      {"gas-peak-place", kLimited, kCase},
      {"gas-imep-differs", kLimited, kCase},
      {"gas-compression-low", kLimited, kCase},
      {"gas-compression-high", kLimited, kCase},
      {"roughness-parameter-unusual", kLimited, kCase},
      {"roughness-from-ra", kLimited, kCase},
      {"modulus-unusual", kLimited, kCase},
      {"boundary-shear-strength-high", kLimited, kCase},
      {"boundary-friction-dry", kLimited, kCase},
      {"eyring-stress-high", kLimited, kCase},
      {"viscosity-high", kLimited, kCase},
      {"viscosity-low", kLimited, kCase},
      {"ring-tension-high", kLimited, kCase},
      {"engine-size-unusual", kLimited, kCase},
      {"supply-film-thin", kLimited, kCase},
      {"gas-trace-jump", kLimited, kCase},
      {"gas-pressure-low", kLimited, kCase},
      {"gas-pressure-high", kLimited, kCase},
      {"valve-timing-unusual", kLimited, kCase},
      {"burn-duration-short", kLimited, kCase},
      {"face-points-few", kLimited, kCase},
      {"cells-too-long", kLimited, kCase},
      {"gap-finer-than-cells", kLimited, kCase},
      {"coarse-grid", kLimited, kCase},
      {"end-cells-long", kLimited, kCase},
      {"step-control-at-its-limit", kLimited, kOccurrences},
      {"oil-not-settled", kLimited, kCase},
      {"mass-not-kept", kLimited, kOccurrences},
      {"load-rises-with-separation", kLimited, kCase},
      {"load-at-several-separations", kLimited, kOccurrences},
      {"pressed-closer-than-gap", kLimited, kCase},
      {"polynomial-beyond-range", kLimited, kOccurrences},
      {"oil-table-left", kLimited, kOccurrences, "peak_film_pressure", kMax},
      {"lambda-ratio-low", kLimited, kCrankAngles, "min_lambda_ratio", kMin},
      {"contact-law-left", kLimited, kCrankAngles, "min_film_thickness", kMin},
      {"contact-law-extrapolated", kLimited, kCase},
      {"land-law-left", kLimited, kCrankAngles, "min_film_thickness", kMin},
      {"land-width-differs", kLimited, kCase},
      {"land-lift-flooded", kLimited, kCase},
      {"flow-factors-left", kLimited, kCrankAngles, "min_film_thickness", kMin},
      {"flow-factors-extrapolated", kLimited, kCrankAngles, "max_film_thickness", kMax},
      {"contact-beyond-hardness", kLimited, kCrankAngles, "peak_mean_real_pressure", kMax},
      {"contact-plastic", kLimited, kCase},
      {"asperities-inconsistent", kLimited, kCase},
      {"asperity-slopes-high", kLimited, kCase},
      {"supply-beyond-inlet", kLimited, kCase},
      {"ring-distance-assumed", kLimited, kCase},
      {"bore-taken-as-round", kLimited, kCase},
      {"viscous-heating-high", kLimited, kCrankAngles, "peak_viscous_heating_rise", kMax},
      {"shear-rate-high", kLimited, kCrankAngles},
      {"gas-path-not-periodic", kLimited, kCase},
      {"ring-unseated", kLimited, kCase},
      {"radial-collapse", kLimited, kCrankAngles},
      {"ring-twist-omitted", kLimited, kCase},
      {"coating-thin", kLimited, kCase},
      {"gap-leakage-grows", kLimited, kCase},
      {"edge-flow-grows", kLimited, kCase},
      {"surfaces-flattened", kLimited, kCase},
      {"viscosity-extrapolated", kLimited, kCase},
      {"viscosity-off-line", kLimited, kCase},
      {"density-extrapolated", kLimited, kCase},
      {"gas-pegged", kFull, kCase},
      {"gas-breaks-through", kFull, kCrankAngles},
      {"friction-mostly-boundary", kFull, kCase},
      {"supply-steep", kFull, kCase},
      {"error-estimate-missing", kFull, kCase},
      {"error-estimate-one-sided", kFull, kCase},
      {"cavitation-pressure-lowered", kFull, kCase},
      {"separation-adds-to-gap", kFull, kCase},
      {"ring-flutter", kFull, kCase},
      {"oil-ring-missing", kFull, kCase},
      {"water-condenses", kFull, kCase},
      {"crankcase-flammable", kFull, kCase},
      {"oil-diluted", kFull, kCase},
      {"own-oil", kFull, kCase},
      {"cells-graded", kFull, kCase},
      {"menisci-not-used", kFull, kCase},
      {"accuracy-asked-for", kFull, kCase},
      {"accuracy-reached", kFull, kCase},
      {"conform-not-used", kFull, kCase},
      {"free-shape-smoothed", kFull, kCase},
      {"properties-exact", kFull, kCase},
      {"beyond-property-fit", kFull, kOccurrences},
      {"bracketed-search", kFull, kOccurrences},
      {"shorter-steps", kFull, kOccurrences},
      {"step-control-without-effect", kFull, kOccurrences},
      {"eased-start", kFull, kOccurrences},
  };
  return table;
}

const NoteTopic* note_topic(const std::string& topic) {
  const std::size_t rank = note_rank(topic);
  return rank < note_topics().size() ? &note_topics()[rank] : nullptr;
}

std::size_t note_rank(const std::string& topic) {
  const std::vector<NoteTopic>& all = note_topics();
  const auto found = std::find_if(all.begin(), all.end(), [&](const NoteTopic& one) { return topic == one.name; });
  return static_cast<std::size_t>(found - all.begin());
}

void sort_notes(std::vector<Note>& notes) {
  std::stable_sort(notes.begin(), notes.end(),
                   [](const Note& a, const Note& b) { return note_rank(a.topic) < note_rank(b.topic); });
}

std::optional<double> note_badness(const std::string& topic, const std::function<double(std::size_t)>& value) {
  const NoteTopic* entry = note_topic(topic);
  if (entry == nullptr || entry->measure == nullptr) return std::nullopt;
  const double measured = value(*cycle_quantity_index(entry->measure));
  if (!std::isfinite(measured)) return std::nullopt;
  return entry->bad_end == BadEnd::kMax ? measured : -measured;
}

std::optional<double> note_badness(const std::string& topic, std::span<const double> values) {
  return note_badness(topic, [values](std::size_t i) { return values[i]; });
}

}  // namespace ringfilm::cycle
