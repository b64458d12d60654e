#include "ringfilm/life/archard_run.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <numbers>
#include <optional>

#include "ringfilm/base/number_text.hpp"
#include "ringfilm/base/table.hpp"
#include "ringfilm/cycle/integration/setup.hpp"
#include "ringfilm/cycle/note_topics.hpp"
#include "ringfilm/life/duty_batch.hpp"
#include "ringfilm/life/face_distance.hpp"
#include "ringfilm/life/wear_bounds.hpp"
#include "ringfilm/life/worn_face.hpp"

namespace ringfilm::life {
namespace {

/// Share by which sigma or zeta may change within a jump.
constexpr double kSurfaceChange = 0.02;

/// Tilts that stand for all between -a and a: the middles of as many equal parts.
std::vector<double> tilts_of(const Wear& wear) {
  if (wear.tilt_spread == 0) return {0};
  std::vector<double> tilts;
  for (int j = 0; j < wear.tilt_samples; ++j) {
    tilts.push_back(wear.tilt_spread * ((2.0 * j + 1) / wear.tilt_samples - 1));
  }
  return tilts;
}

/// Asperity pressure as the film of a case has it, so that its integral over the face is the load that was carried.
class AsperityPressure {
 public:
  explicit AsperityPressure(const cycle::Case& c)
      : contact_(cycle::prepare(c).ring.contact),
        is_local_(c.contact.lambda_ratio == cycle::LambdaRatio::kLocal),
        fitted_(c.solver.properties == cycle::Properties::kFitted ? contact_->fitted() : std::nullopt) {}

  /// @param h_m at the lowest point [m] @param height of the face above it [m] @returns [Pa]
  double operator()(double h_m, double height) const {
    const double h = h_m + (is_local_ ? height : 0.0);
    if (h >= contact_->reach()) return 0;
    if (!fitted_) return contact_->contact(h).pressure;
    if (h >= fitted_->reach) return 0;
    const double argument = std::max(h, 0.0) * (models::ContactFit::kEnd / fitted_->reach);
    return fitted_->pressure_scale * models::ContactFit::integral(fitted_->fit->P52, argument).value;
  }

 private:
  std::shared_ptr<const models::AsperityContact> contact_;
  bool is_local_;
  std::optional<models::FittedContact> fitted_;
};

class Scenario {
 public:
  Scenario(const Life& life, const CycleIntegrators& integrators)
      : life_(life),
        integrators_(integrators),
        base_(life.points.front().input),
        face_(with_surface(base_, 0)),
        tilts_(tilts_of(life.wear)) {}

  LifeResult run();

 private:
  /// Face, roughness and shear strength at a running time, without wear.
  RingState surface_at(double time) const {
    if (life_.wear.surface == WornSurface::kFrozen) return ring_state_of(base_);
    RingState state = state_on_path(life_.states, life_.path, time, base_.solver.cells);
    state.face = base_.ring.face;
    return state;
  }

  cycle::Case with_surface(const cycle::Case& c, double time) const { return with_ring_state(c, surface_at(time)); }

  RingState ring_at(double time, const std::vector<double>& worn, double tilt) const {
    RingState state = surface_at(time);
    state.face = face_.face(worn, tilt);
    return state;
  }

  WearLoad load(double time, const std::vector<double>& worn);
  void add_cycle(const OperatingPoint& point, const cycle::Case& input, const std::vector<double>& heights,
                 const cycle::CycleResult& result, double weight, WearLoad& load) const;
  void weight_edges(WearLoad& load) const;
  bool surface_changes_much(double from, double to) const;
  void check_wedge(const WornDepths& now);
  WornProfile profile(const WornDepths& depths) const;
  LifeState reported_state(const WornDepths& depths) const;
  void compare_with_measured(LifeState& state) const;
  std::optional<CoefficientRange> implied_coefficient() const;
  void append_tilt_note();
  void append_notes();

  const Life& life_;
  const CycleIntegrators& integrators_;
  const cycle::Case& base_;
  WornFace face_;
  std::vector<double> tilts_;
  LifeResult result_;
};

std::size_t liner_places(const Life& life) {
  constexpr std::size_t kOfACycle = 100;  // of CycleResult::stroke
  return life.wear.liner_coefficient ? kOfACycle : 0;
}

WearLoad Scenario::load(double time, const std::vector<double>& worn) {
  std::vector<CycleRequest> requests;
  for (const double tilt : tilts_) {
    const RingState ring = ring_at(time, worn, tilt);
    for (const OperatingPoint& point : life_.points) {
      requests.push_back({with_ring_state(point.input, ring), hours_text(time) + ", " + point.name});
      cycle::Output& output = requests.back().input.output;
      output = {};
      output.crank_angle_step_deg = point.input.solver.crank_step_deg;
    }
  }
  const std::vector<cycle::CycleResult> results = integrators_.side_by_side(requests);
  result_.cycles += static_cast<long>(results.size());
  WearLoad load;
  load.face.assign(face_.n_nodes(), 0.0);
  load.liner.assign(liner_places(life_), 0.0);
  auto next = results.begin();
  std::size_t request = 0;
  for (const double tilt : tilts_) {
    const std::vector<double> heights = face_.heights(worn, tilt);
    for (const OperatingPoint& point : life_.points) {
      add_cycle(point, requests[request++].input, heights, *next++, point.share / static_cast<double>(tilts_.size()),
                load);
    }
  }
  if (!load.liner.empty()) result_.liner_position = results.front().stroke.liner_position;
  weight_edges(load);
  return load;
}

void Scenario::add_cycle(const OperatingPoint& point, const cycle::Case& input, const std::vector<double>& heights,
                         const cycle::CycleResult& result, double weight, WearLoad& load) const {
  const AsperityPressure pressure(input);
  const double circumference = std::numbers::pi * input.engine.bore;
  const double share_of_sample = 1 / static_cast<double>(result.samples.size());
  std::vector<double> face(heights.size(), 0.0);
  double carried = 0;
  for (const cycle::Sample& sample : result.samples) {
    const double speed = std::abs(sample.piston_velocity) * share_of_sample;
    carried += sample.asperity_load / circumference * speed;
    for (std::size_t i = 0; i < heights.size(); ++i) {
      face[i] += pressure(sample.min_film_thickness, heights[i]) * speed;
    }
  }
  double over_face = 0;
  for (std::size_t i = 0; i < face.size(); ++i) {
    over_face += face_.share()[i] * face[i];
    load.face[i] += weight * face[i];
  }
  if (carried > 0) load.balance_error = std::max(load.balance_error, std::abs(over_face / carried - 1));
  const double cycles_per_second = point.input.operating.speed / (4 * std::numbers::pi);
  for (std::size_t i = 0; i < load.liner.size(); ++i) {
    load.liner[i] += weight * result.stroke.archard_wear_load_density[i] / circumference * cycles_per_second;
  }
}

void Scenario::weight_edges(WearLoad& load) const {
  if (life_.wear.edge_factor == 1) return;
  const double middle = 0.5 * base_.ring.face_width;
  for (std::size_t i = 0; i < load.face.size(); ++i) {
    if (std::abs(face_.x()[i] - middle) > life_.wear.edge_distance) load.face[i] *= life_.wear.edge_factor;
  }
}

bool Scenario::surface_changes_much(double from, double to) const {
  const RingState a = surface_at(from), b = surface_at(to);
  const auto change = [](double before, double after) { return before > 0 ? std::abs(after / before - 1) : 0.0; };
  return std::max(change(a.roughness, b.roughness), change(a.boundary_shear_strength_coefficient,
                                                           b.boundary_shear_strength_coefficient)) > kSurfaceChange;
}

void Scenario::check_wedge(const WornDepths& now) {
  if (result_.wear->wedge_gone) return;
  const std::vector<double> heights = face_.heights(now.face, 0);
  const double sigma = cycle::prepare(with_surface(base_, now.time)).ring.sigma;
  if (std::min(heights.front(), heights.back()) < sigma) result_.wear->wedge_gone = now.time;
}

WornProfile Scenario::profile(const WornDepths& depths) const {
  WornProfile worn;
  worn.depth = depths.face;
  worn.liner_depth = depths.liner;
  for (std::size_t i = 0; i < depths.face.size(); ++i) worn.worn_area += face_.share()[i] * depths.face[i];
  worn.largest_depth = *std::max_element(depths.face.begin(), depths.face.end());
  worn.end_gap_growth = 2 * std::numbers::pi * worn.largest_depth;
  if (const auto& thickness = life_.wear.coating_thickness) worn.coating_left = *thickness - worn.largest_depth;
  return worn;
}

LifeState Scenario::reported_state(const WornDepths& depths) const {
  LifeState state;
  state.time = depths.time;
  state.standing = Standing::kScenario;
  state.ring = ring_at(depths.time, depths.face, 0);
  state.worn = profile(depths);
  return state;
}

/// Half widths over which faces are compared: without the outer part, where scans are least to be trusted.
constexpr double kCompared[] = {0.5e-3, 0.3e-3};

void Scenario::compare_with_measured(LifeState& state) const {
  for (const MeasuredState& measured : life_.states) {
    if (measured.time != state.time) continue;
    const FaceHeights face = face_heights(measured.input);
    std::vector<double> heights;
    for (const double x : state.x) heights.push_back(interpolate_linear(face.x, face.height, x));
    for (const double half_width : kCompared) {
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
  if (tilts_.size() < 2 || result_.states.empty()) return;
  const LifeState& last = result_.states.back();
  const double sigma = cycle::prepare(with_surface(base_, last.time)).ring.sigma;
  const double radius = radius_at_lowest(last.x, last.face_height);
  const double spacing = tilts_[1] - tilts_[0], allowed = 0.5 * std::sqrt(2 * sigma / radius);
  if (spacing <= allowed) return;
  constexpr double kArcMinute = std::numbers::pi / 180 / 60;
  result_.notes.push_back({"tilt-samples-few",
                           "tilts are " + number_text(spacing / kArcMinute) +
                               " arc minutes apart; the worn face needs " + number_text(allowed / kArcMinute) +
                               " or less: take more wear.tilt_samples",
                           1});
}

void Scenario::append_notes() {
  cycle::sort_notes(result_.notes);
  if (const auto& when = result_.wear->worn_through) {
    result_.notes.push_back({"coating-worn-through",
                             "the coating of " + number_text(*life_.wear.coating_thickness * 1e6) +
                                 " um is worn through after " + hours_text(*when) + "; nothing later was computed",
                             1});
  }
  if (const auto& when = result_.wear->wedge_gone) {
    result_.notes.push_back({"wedge-gone",
                             "after " + hours_text(*when) +
                                 " an edge of the face is within the roughness of its lowest point: the converging "
                                 "wedge is gone there, and wear accelerates",
                             1});
  }
  result_.notes.push_back({"wear-scenario",
                           "the wear coefficient is an input of this scenario, not a property of the coating: oil "
                           "temperature, duty and roughness change the implied one by more than a factor of two",
                           1});
  append_tilt_note();
  if (life_.wear.surface == WornSurface::kPath) append_held_note(life_, result_);
}

LifeResult Scenario::run() {
  result_.wear.emplace();
  std::vector<double> times;
  for (const ReportedTime& reported : life_.times) times.push_back(reported.time);
  WearLimits limits;
  limits.deepest = life_.wear.coating_thickness;
  if (life_.wear.surface == WornSurface::kPath) {
    limits.is_too_long = [this](double from, double to) { return surface_changes_much(from, to); };
  }
  limits.after_jump = [this](const WornDepths& now) { check_wedge(now); };
  const WearHistory history = integrate_wear(
      life_.wear, times, face_.n_nodes(), liner_places(life_),
      [this](double time, const std::vector<double>& worn) { return load(time, worn); }, limits);
  result_.wear->effort = history.effort;
  result_.wear->worn_through = history.worn_through;
  for (const WornDepths& depths : history.states) result_.states.push_back(reported_state(depths));
  DutyBatch reported(life_), others(life_);
  for (LifeState& state : result_.states) {
    reported.add(state.ring, hours_text(state.time),
                 [this, &state](const auto& results) { take_duty(life_, results, state, result_.notes); });
  }
  add_parts(life_, result_.states, others);
  result_.cycles += reported.integrate(integrators_.alone);
  result_.cycles += others.integrate(integrators_.side_by_side);
  for (LifeState& state : result_.states) compare_with_measured(state);
  result_.wear->implied = implied_coefficient();
  append_notes();
  return std::move(result_);
}

}  // namespace

LifeResult run_archard(const Life& life, const CycleIntegrators& integrators) {
  return Scenario(life, integrators).run();
}

}  // namespace ringfilm::life
