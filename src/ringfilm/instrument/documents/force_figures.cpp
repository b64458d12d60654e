#include "ringfilm/instrument/documents/force_figures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "ringfilm/instrument/documents/surface_values.hpp"

namespace ringfilm::instrument {
namespace {

constexpr double kNoForce = std::numeric_limits<double>::quiet_NaN();
constexpr std::size_t kMaxLoops = 3;  // loops in one figure, so that they can be distinguished

constexpr int kLinePoints = 100;  // points of a drawn line, so that its signs lie apart from the measured ones

/// Letters, digits and "_"; at least one letter at the start.
std::string word_of(const std::string& name) {
  std::string word;
  for (const char c : name) {
    const bool digit = c >= '0' && c <= '9';
    const bool letter = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
    if (letter || (digit && !word.empty())) {
      word += c;
    } else if (!word.empty() && word.back() != '_') {
      word += '_';
    }
  }
  while (!word.empty() && word.back() == '_') word.pop_back();
  return word.empty() ? "sample" : word;
}

std::string load_text(double load, surface::LoadUnit unit) {
  return unit == surface::LoadUnit::kVolt ? fmt::format("{:.4g} V", load) : text_in(load, kNanonewton, 4);
}

/// The first loop of some loads, from the lowest to the highest.
std::vector<const surface::FrictionLoop*> some_loops(const ForceSample& sample) {
  std::vector<const surface::FrictionLoop*> first;
  for (const surface::FrictionLoop& loop : sample.loops) {
    const bool known = std::any_of(first.begin(), first.end(), [&](const auto* f) { return f->load == loop.load; });
    if (!known) first.push_back(&loop);
  }
  std::stable_sort(first.begin(), first.end(), [](const auto* a, const auto* b) { return a->load < b->load; });
  if (first.size() <= kMaxLoops) return first;
  std::vector<const surface::FrictionLoop*> some;
  for (std::size_t k = 0; k < kMaxLoops; ++k) some.push_back(first[k * (first.size() - 1) / (kMaxLoops - 1)]);
  return some;
}

io::MeasuredCurve empty_loop_curve(const ForceSample& sample, const std::string& name) {
  return curve_of(name, "Friction loops, " + sample.name, "", {"position", "position along the line", "m", "um"},
                  {"lateral_signal", "lateral signal", "V", "mV"});
}

void add_loop(io::MeasuredCurve& curve, const surface::FrictionLoop& loop, const std::string& word, std::size_t number,
              surface::LoadUnit unit) {
  const std::string at = " at " + load_text(loop.load, unit);
  curve.series.push_back({fmt::format("trace_{}_{}", word, number), "trace" + at, loop.trace_V, false});
  curve.series.push_back({fmt::format("retrace_{}_{}", word, number), "retrace" + at, loop.retrace_V, false});
}

void mark_ends(io::MeasuredCurve& curve, double end_share) {
  if (!(end_share > 0)) return;
  const double cut = end_share * (curve.x.back() - curve.x.front());
  curve.marks = {{curve.x.front() + cut, "from here"}, {curve.x.back() - cut, "to here"}};
}

}  // namespace

std::vector<std::string> words_of(const SampleList& samples) {
  std::vector<std::string> words;
  std::set<std::string> taken;
  for (const ForceSample* sample : samples) {
    const std::string plain = word_of(sample->name);
    std::string word = plain;
    for (int k = 2; !taken.insert(word).second; ++k) word = fmt::format("{}_{}", plain, k);
    words.push_back(word);
  }
  return words;
}

std::string load_unit_of(surface::LoadUnit unit) { return unit == surface::LoadUnit::kVolt ? "V" : "N"; }
std::string load_display_of(surface::LoadUnit unit) { return unit == surface::LoadUnit::kVolt ? "V" : "nN"; }

std::vector<io::MeasuredCurve> loop_curves(const ForceSample& sample, const std::string& word, double end_share) {
  const std::vector<const surface::FrictionLoop*> loops = some_loops(sample);
  if (loops.empty()) return {};
  const bool one_grid = std::all_of(loops.begin(), loops.end(),
                                    [&](const auto* loop) { return loop->position_m == loops.front()->position_m; });
  std::vector<io::MeasuredCurve> curves;
  for (std::size_t k = 0; k < loops.size(); ++k) {
    if (k == 0 || !one_grid) {
      curves.push_back(empty_loop_curve(sample, one_grid ? "loops_" + word : fmt::format("loops_{}_{}", k + 1, word)));
      curves.back().x = loops[k]->position_m;
      mark_ends(curves.back(), end_share);
      curves.back().caption =
          "The lateral signal on the way there and back, the first loop of " +
          std::string(one_grid && loops.size() > 1 ? "some loads" : "a load") +
          ". Half the distance of both ways, between the upright lines, is the friction signal; their common slope and "
          "waves are those of the sample.";
    }
    add_loop(curves.back(), *loops[k], word, k + 1, sample.load_unit);
  }
  return curves;
}

io::MeasuredCurve friction_curve(const SampleList& samples, const std::vector<std::string>& words,
                                 const surface::Calibration& calibration) {
  const std::string unit = load_unit_of(calibration.load_unit), display = load_display_of(calibration.load_unit);
  io::MeasuredCurve curve =
      curve_of("friction_against_load", "Friction against load",
               "Friction signal times calibration factor, the mean of each load, and the line through them by total "
               "least squares. The slope of a line is the coefficient of boundary shear strength; what is left at "
               "load zero is adhesion.",
               {"load", "load", unit, display}, {"friction", "friction", unit, display});
  struct Place {
    double load;
    std::size_t sample;
    double tmr_V;
  };
  std::vector<Place> places;
  double least = 0, most = 0;  // from zero on: there the lines show adhesion
  for (std::size_t s = 0; s < samples.size(); ++s) {
    for (const surface::LoadFriction& load : samples[s]->loads) {
      places.push_back({load.load, s, load.tmr_V});
      least = std::min(least, load.load);
      most = std::max(most, load.load);
    }
  }
  for (int k = 0; k <= kLinePoints; ++k) {
    places.push_back({least + (most - least) * k / kLinePoints, samples.size(), kNoForce});
  }
  std::stable_sort(places.begin(), places.end(), [](const Place& a, const Place& b) { return a.load < b.load; });
  for (const Place& place : places) curve.x.push_back(place.load);
  for (std::size_t s = 0; s < samples.size(); ++s) {
    std::vector<double> points, line;
    for (const Place& place : places) {
      points.push_back(place.sample == s ? calibration.psi * place.tmr_V : kNoForce);
      line.push_back(calibration.psi * (samples[s]->line.offset + samples[s]->line.slope * place.load));
    }
    curve.series.push_back({"friction_" + words[s], samples[s]->name + " (measured)", std::move(points), true});
    curve.series.push_back({"line_" + words[s], samples[s]->name + ", line", std::move(line), false});
  }
  return curve;
}

}  // namespace ringfilm::instrument
