#include "ringfilm/life/archard_run.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "ringfilm/base/display.hpp"
#include "ringfilm/base/table.hpp"
#include "ringfilm/cycle/advice/note_topics.hpp"
#include "ringfilm/life/coefficient_fit.hpp"
#include "ringfilm/life/duty_batch.hpp"
#include "ringfilm/life/duty_wear.hpp"
#include "ringfilm/life/wear/face_distance.hpp"
#include "ringfilm/life/wear/wear_bounds.hpp"

namespace ringfilm::life {
namespace {

/// Depth within which a waviness decays: p_a/|p_a'| at usual separations, a share of the roughness
/// (docs/theory/life.md).
constexpr double kDecayDepth = 0.3;

class Scenario {
 public:
  Scenario(const Life& life, const CycleIntegrators& integrators, PackGas& gas)
      : life_(life), integrators_(integrators), gas_(gas), wear_(life, integrators, gas) {}

  LifeResult run();

  /// Depths and values of the duty alone, for the end of a range: its states without fields, notes and points.
  LifeResult run_values();

 private:
  void integrate();
  void check_wedge(const WornDepths& now);
  WornProfile profile(const WornDepths& depths);
  WearThrough end_of_coating(const WornDepths& depths);
  void compare_with_measured(LifeState& state) const;
  std::optional<CoefficientRange> implied_coefficient() const;
  void append_tilt_note();
  void append_jump_note();
  void append_notes();

  const Life& life_;
  const CycleIntegrators& integrators_;
  PackGas& gas_;
  DutyWear wear_;
  LifeResult result_;
};

void Scenario::check_wedge(const WornDepths& now) {
  if (result_.wear->wedge_gone) return;
  const std::vector<double> heights = wear_.face().heights(now.face, 0);
  if (std::min(heights.front(), heights.back()) < wear_.roughness_at(now)) result_.wear->wedge_gone = now.time;
}

WornProfile Scenario::profile(const WornDepths& depths) {
  WornProfile worn = worn_profile(depths.face, wear_.area(depths.face), life_.wear.coating_thickness);
  worn.liner_depth = depths.liner;
  wear_.put_running_in(depths, worn);
  gas_.put_blow_by(worn);
  return worn;
}

/// With the depth of the coating without the round-off of its interpolation, so that a limit of that depth is met.
WearThrough Scenario::end_of_coating(const WornDepths& depths) {
  const double thickness = life_.wear.coating_thickness.value_or(kAssumedCoating);
  WearThrough end{depths.time, profile(depths)};
  end.worn.largest_depth = thickness;
  end.worn.end_gap_growth = end_gap_growth(thickness);
  if (end.worn.coating_left) end.worn.coating_left = 0;
  return end;
}

void Scenario::compare_with_measured(LifeState& state) const {
  for (const MeasuredState& measured : life_.states) {
    if (measured.time != state.time) continue;
    const FaceHeights face = face_heights(measured.input);
    std::vector<double> heights;
    for (const double x : state.x) heights.push_back(interpolate_linear(face.x, face.height, x));
    for (const double half_width : compared_half_widths()) {
      if (half_width > 0.5 * face.width()) continue;
      state.from_measured.push_back({half_width, rms_distance(state.x, state.face_height, heights, half_width)});
    }
  }
}

/// The scenario's mean coefficient, scaled from its worn area to the least ones that the measured faces allow: for one
/// surface the faces that a scenario passes do not depend on the coefficient, which only sets the clock.
std::optional<CoefficientRange> Scenario::implied_coefficient() const {
  if (life_.states.size() < 2) return std::nullopt;
  const MeasuredState &first = life_.states.front(), &last = life_.states.back();
  for (const LifeState& state : result_.states) {
    if (state.time != last.time || state.time == 0 || state.worn->worn_area <= 0) continue;
    const double mean = coefficient_integral(life_.wear, 0, state.time) / state.time;
    const FaceHeights from = face_heights(first.input), to = face_heights(last.input);
    CoefficientRange range{std::numeric_limits<double>::infinity(), 0};
    for (const double share : trusted_margins()) {
      const double area = least_wear(from, to, share * from.width(), Tilt::kFree).area;
      range.low = std::min(range.low, mean * area / state.worn->worn_area);
      range.high = std::max(range.high, mean * area / state.worn->worn_area);
    }
    return range;
  }
  return std::nullopt;
}

/// Radius of a face at its lowest point, from its heights within a tenth of its width to both sides [m].
double radius_at_lowest(const std::vector<double>& x, const std::vector<double>& height) {
  const std::size_t n = x.size(), reach = n / 10;
  const auto found = std::min_element(height.begin(), height.end()) - height.begin();
  const std::size_t k = std::clamp<std::size_t>(static_cast<std::size_t>(found), reach, n - 1 - reach);
  const double before = x[k] - x[k - reach], after = x[k + reach] - x[k];
  const double bend =
      2 * ((height[k + reach] - height[k]) / after - (height[k] - height[k - reach]) / before) / (before + after);
  return bend > 0 ? 1 / bend : std::numeric_limits<double>::infinity();
}

/// eq-life-tilt: tilts farther apart wear facets.
void Scenario::append_tilt_note() {
  const double spacing = wear_.tilt_spacing();
  if (spacing == 0 || result_.states.empty()) return;
  const LifeState& last = result_.states.back();
  const double radius = radius_at_lowest(last.x, last.face_height);
  const double sigma = wear_.roughness_at({last.time, last.worn->depth, last.worn->liner_depth});
  const double allowed = 0.5 * std::sqrt(2 * sigma / radius);
  if (spacing <= allowed) return;
  result_.notes.push_back({"tilt-samples-few", "tilts are " + number_text(number_in(spacing, kArcMinute)) +
                                                   " arc minutes apart; the worn face needs " +
                                                   number_text(number_in(allowed, kArcMinute)) +
                                                   " or less: take more wear.tilt_samples"});
}

/// Equal jumps are not taken again where they are too long.
void Scenario::append_jump_note() {
  if (life_.wear.jumps && result_.wear->effort.lacks_last_stage) {
    result_.notes.push_back({"jumps-few",
                             "the jump through the coating has its first stage alone, since a face that deep has no "
                             "cycle: take more wear.jumps, or leave them out"});
  }
  if (const auto& depth = result_.wear->effort.coarse_depth) {
    result_.notes.push_back(
        {"jumps-coarse", "the coating lasts to no later reported time: its end was found by jumps of " +
                             text_in(*depth, kMicrometre) + ", within a few per cent; report earlier hours"});
  }
  const double difference = result_.wear->effort.stage_difference, allowed = Wear{}.jump_error;
  if (!life_.wear.jumps || difference <= 1.5 * allowed) return;
  result_.notes.push_back({"jumps-few", "the stages of a jump differ by up to " + text_in(difference, kMicrometre) +
                                            ", more than " + text_in(allowed, kMicrometre) +
                                            ": take more wear.jumps, or leave them out"});
}

/// @param which scenario, e.g. " with the ring turned over"; empty: the one that is reported
void append_coating_note(const Life& life, const std::optional<WearThrough>& end, const std::string& which,
                         LifeResult& result) {
  if (!end) return;
  const auto& stated = life.wear.coating_thickness;
  const double thickness = stated.value_or(kAssumedCoating);
  result.notes.push_back({"coating-worn-through", "the coating of " + text_in(thickness, kMicrometre) +
                                                      (stated ? "" : " (assumed: state wear.coating_thickness)") +
                                                      " is worn through after " + hours_text(end->time) + which +
                                                      "; nothing later was computed"});
}

void Scenario::append_notes() {
  cycle::sort_notes(result_.notes);
  append_coating_note(life_, result_.wear->worn_through, "", result_);
  if (const auto& when = result_.wear->wedge_gone) {
    result_.notes.push_back(
        {"wedge-gone", "after " + hours_text(*when) +
                           " an edge of the face is within the roughness of its lowest point: the converging "
                           "wedge is gone there, and wear accelerates"});
  }
  const std::string origin = life_.wear.source == CoefficientSource::kFitted
                                 ? "is fitted to the measured faces with this duty"
                                 : "is an input of this scenario";
  result_.notes.push_back(
      {"wear-scenario", "the wear coefficient " + origin +
                            ", not a property of the coating: oil temperature, duty and roughness change the "
                            "implied one by more than a factor of two"});
  if (life_.running_in) {
    result_.notes.push_back({"roughness-runs-in",
                             "the roughness follows the worn depth by [running_in]: its limit and depth scale are "
                             "inputs of this scenario, and shear strength stays as it is"});
  }
  append_tilt_note();
  append_jump_note();
  if (life_.wear.surface == WornSurface::kPath) append_held_note(life_, result_);
}

void Scenario::integrate() {
  result_.wear.emplace();
  result_.wear->coefficient = life_.wear.coefficient;
  wear_.put_running_in({}, result_.unworn);
  std::vector<double> times;
  for (const ReportedTime& reported : life_.times) times.push_back(reported.time);
  WearLimits limits;
  limits.deepest = life_.wear.coating_thickness.value_or(kAssumedCoating);
  limits.decay_depth = kDecayDepth * wear_.roughness_at({});
  if (life_.wear.surface == WornSurface::kPath || life_.running_in) {
    limits.is_too_long = [this](const WornDepths& from, const WornDepths& to) {
      return wear_.surface_changes_much(from, to);
    };
  }
  limits.after_jump = [this](const WornDepths& now) { check_wedge(now); };
  const WearHistory history = integrate_wear(
      life_.wear, times, wear_.face().n_nodes(), wear_.n_liner(),
      [this](const WornDepths& now) { return wear_.load(now); }, limits);
  result_.wear->effort = history.effort;
  if (history.worn_through) result_.wear->worn_through = end_of_coating(*history.worn_through);
  result_.liner_position = wear_.liner_position();
  result_.cycles = wear_.cycles();
  for (const WornDepths& depths : history.states) {
    LifeState& state = result_.states.emplace_back();
    state.time = depths.time;
    state.state_origin = StateOrigin::kScenario;
    state.ring = wear_.ring_at(depths);
    state.worn = profile(depths);
  }
}

LifeResult Scenario::run_values() {
  integrate();
  DutyBatch batch(life_, gas_, Points::kOfTheDuty);
  for (LifeState& state : result_.states) batch.add(state.ring, hours_text(state.time), into(life_, state.values));
  result_.cycles += batch.integrate(integrators_.side_by_side);
  return std::move(result_);
}

LifeResult Scenario::run() {
  integrate();
  DutyBatch reported(life_, gas_, Points::kAll), others(life_, gas_, Points::kOfTheDuty);
  for (LifeState& state : result_.states) {
    state.point_gas = gas_.sums(state.ring.gap);
    reported.add(state.ring, hours_text(state.time),
                 [this, &state](const auto& results) { take_duty(life_, results, state, result_.notes); });
  }
  add_parts(life_, result_.states, others);
  result_.cycles += reported.integrate(integrators_.alone);
  result_.cycles += others.integrate(integrators_.side_by_side);
  for (LifeState& state : result_.states) compare_with_measured(state);
  if (life_.wear.source == CoefficientSource::kStated) result_.wear->implied = implied_coefficient();
  append_notes();
  return std::move(result_);
}

/// The scenario of the ring with its two edges exchanged from the start.
Life turned_life(Life life) {
  for (OperatingPoint& point : life.points) {
    point.input = with_ring_state(point.input, turned(ring_state_of(point.input)));
  }
  return life;
}

Life with_coefficient(Life life, double coefficient) {
  life.wear.coefficient = coefficient;
  return life;
}

std::string two_digits(double value) {
  const double unit = std::pow(10, std::floor(std::log10(value)) - 1);
  return number_text(std::round(value / unit) * unit);
}

/// The other end of a range as another path of the states; nothing where it ended earlier.
void append_path(const std::string& name, LifeResult end, LifeResult& result) {
  result.other_paths.push_back({name, {}});
  result.cycles += end.cycles;
  result.wear->other_worn_through.push_back(std::move(end.wear->worn_through));
  for (std::size_t i = 0; i < result.states.size(); ++i) {
    LifeState& state = result.states[i];
    const bool is_there = i < end.states.size();
    state.other_paths.push_back(is_there ? std::move(end.states[i].values) : LifeValues{});
    state.other_worn.push_back(is_there ? std::move(end.states[i].worn) : std::nullopt);
  }
}

/// The geometric mean of what the faces allow, with the ends of that range as other paths.
LifeResult run_fitted(const Life& life, const CycleIntegrators& integrators, PackGas& gas) {
  CoefficientFit fit = fit_coefficient(life, integrators, gas);
  const auto [low, high] = fit.range;
  const Life mean = with_coefficient(life, std::sqrt(low * high));
  LifeResult result = Scenario(mean, integrators, gas).run();
  for (const auto& [name, end] : {std::pair{"lowest fitted coefficient", low}, {"highest fitted coefficient", high}}) {
    const Life other = with_coefficient(life, end);
    append_path(name, Scenario(other, integrators, gas).run_values(), result);
    append_coating_note(life, result.wear->other_worn_through.back(), std::string(" with the ") + name, result);
  }
  result.cycles += fit.cycles;
  result.notes.push_back({"coefficient-fitted", "the measured faces allow coefficients from " + two_digits(low) +
                                                    " to " + two_digits(high) +
                                                    " m2/N; the values are those of the geometric mean, the band those "
                                                    "of both ends: no single one follows from the faces"});
  result.wear->fit = std::move(fit);
  return result;
}

}  // namespace

LifeResult run_archard(const Life& life, const CycleIntegrators& integrators, PackGas& gas) {
  if (life.wear.source == CoefficientSource::kFitted) return run_fitted(life, integrators, gas);
  LifeResult result = Scenario(life, integrators, gas).run();
  if (life.wear.orientations == WornOrientations::kGiven) return result;
  const Life other = turned_life(life);
  LifeResult end = Scenario(other, integrators, gas).run_values();
  result.cycles += end.cycles;
  for (std::size_t i = 0; i < std::min(result.states.size(), end.states.size()); ++i) {
    result.states[i].turned = std::move(end.states[i].values);
    result.states[i].turned_worn = std::move(end.states[i].worn);
  }
  append_coating_note(life, end.wear->worn_through, " with the ring turned over", result);
  result.wear->turned_worn_through = std::move(end.wear->worn_through);
  return result;
}

}  // namespace ringfilm::life
