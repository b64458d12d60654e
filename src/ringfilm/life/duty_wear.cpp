#include "ringfilm/life/duty_wear.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <optional>

#include "ringfilm/cycle/setup/setup.hpp"
#include "ringfilm/life/duty_batch.hpp"

namespace ringfilm::life {
namespace {

/// Share by which roughness or zeta may change within a jump.
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

EndGapWear end_gap_wear(const WornDepths& depths) {
  return {*std::max_element(depths.face.begin(), depths.face.end()), depths.liner};
}

}  // namespace

DutyWear::DutyWear(const Life& life, const CycleIntegrators& integrators, PackGas& gas)
    : life_(life),
      integrators_(integrators),
      gas_(gas),
      base_(life.points.front().input),
      n_points_(n_duty_points(life)),
      face_(with_surface({})),
      tilts_(tilts_of(life.wear)) {}

/// Means over the surface whose wear smooths the pair; before anything is worn that of an unworn one.
RunInDepth DutyWear::run_in_at(const WornDepths& now) const {
  const RunningIn& law = *life_.running_in;
  if (now.face.empty()) return {};
  if (law.surface == RunningInSurface::kLiner) return run_in_depth(now.liner, {}, law.depth_scale);
  return run_in_depth(now.face, face_.share(), law.depth_scale);
}

/// eq-life-run-in-mean; that of the case, to the bit, where nothing is worn.
double DutyWear::run_in_roughness_at(const WornDepths& now) const {
  const double start = run_in_roughness(base_);
  return start - (1 - run_in_at(now).excess_left) * (start - life_.running_in->roughness_limit);
}

void DutyWear::put_running_in(const WornDepths& now, WornProfile& worn) const {
  if (!life_.running_in) return;
  const RunningIn& law = *life_.running_in;
  worn.running_in_roughness = run_in_roughness_at(now);
  worn.smoothing_share =
      least_depth_scale(base_, law.roughness_limit) / law.depth_scale * run_in_at(now).loss_per_depth;
}

/// Roughness and shear strength, with the face before any wear.
RingState DutyWear::surface_at(const WornDepths& now) const {
  if (life_.running_in) return run_in_state(base_, run_in_roughness_at(now));
  if (life_.wear.surface == WornSurface::kFrozen) return ring_state_of(base_);
  RingState state = state_on_path(life_.states, life_.path, now.time, base_.solver.cells);
  state.face = base_.ring.face;
  return state;
}

RingState DutyWear::ring_at(const WornDepths& now, double tilt) const {
  RingState state = surface_at(now);
  state.face = face_.face(now.face, tilt);
  state.gap = end_gap_wear(now);
  return state;
}

double DutyWear::roughness_at(const WornDepths& now) const { return cycle::prepare(with_surface(now)).ring.sigma; }

double DutyWear::area(const std::vector<double>& worn) const {
  double area = 0;
  for (std::size_t i = 0; i < worn.size(); ++i) area += face_.share()[i] * worn[i];
  return area;
}

double DutyWear::tilt_spacing() const { return tilts_.size() < 2 ? 0 : tilts_[1] - tilts_[0]; }

std::size_t DutyWear::n_liner() const {
  constexpr std::size_t kOfACycle = 100;  // bins of CycleResult::stroke along the stroke
  return life_.wear.liner_coefficient ? kOfACycle : 0;
}

std::vector<CycleRequest> DutyWear::requests(const WornDepths& now) {
  std::vector<CycleRequest> requests;
  for (const double tilt : tilts_) {
    const RingState ring = ring_at(now, tilt);
    for (std::size_t i = 0; i < n_points_; ++i) {
      const OperatingPoint& point = life_.points[i];
      requests.push_back({gas_.with_pressures(with_ring_state(point.input, ring), i, ring.gap),
                          hours_text(now.time) + ", " + point.name});
      cycle::Output& output = requests.back().input.output;
      output = {};
      output.crank_angle_step_deg = point.input.solver.crank_step_deg;
    }
  }
  return requests;
}

WearLoad DutyWear::load(const WornDepths& now) {
  const std::vector<CycleRequest> all = requests(now);
  const std::vector<cycle::CycleResult> results = integrators_.side_by_side(all);
  cycles_ += static_cast<long>(results.size());
  WearLoad load;
  load.face.assign(face_.n_nodes(), 0.0);
  load.liner.assign(n_liner(), 0.0);
  std::size_t next = 0;
  for (const double tilt : tilts_) {
    for (std::size_t i = 0; i < n_points_; ++i, ++next) {
      add_cycle(all[next], {now.face, tilt}, results[next], life_.points[i].share / static_cast<double>(tilts_.size()),
                load);
    }
  }
  if (!load.liner.empty()) liner_position_ = results.front().stroke.liner_position;
  weight_edges(load);
  return load;
}

void DutyWear::add_cycle(const CycleRequest& request, const TiltedFace& worn, const cycle::CycleResult& result,
                         double weight, WearLoad& load) const {
  const cycle::Case& input = request.input;
  const AsperityPressure pressure(input);
  const std::vector<double> level = face_.heights(worn.depth, worn.tilt);
  const double circumference = std::numbers::pi * input.engine.bore;
  const double share_of_sample = 1 / static_cast<double>(result.samples.size());
  std::vector<double> face(level.size(), 0.0);
  std::vector<double> turned;
  double carried = 0;
  for (const cycle::Sample& sample : result.samples) {
    const double speed = std::abs(sample.piston_velocity) * share_of_sample;
    carried += sample.asperity_load / circumference * speed;
    // A positive twist takes the chamber edge away from the liner, a positive tilt the other one.
    const std::vector<double>& heights =
        sample.twist == 0 ? level : (turned = face_.heights(worn.depth, worn.tilt - sample.twist));
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
  const double cycles_per_second = input.operating.speed / (4 * std::numbers::pi);
  for (std::size_t i = 0; i < load.liner.size(); ++i) {
    load.liner[i] += weight * result.stroke.archard_wear_load_density[i] / circumference * cycles_per_second;
  }
}

void DutyWear::weight_edges(WearLoad& load) const {
  if (life_.wear.edge_factor == 1) return;
  const double middle = 0.5 * base_.ring.face_width;
  for (std::size_t i = 0; i < load.face.size(); ++i) {
    if (std::abs(face_.x()[i] - middle) > life_.wear.edge_distance) load.face[i] *= life_.wear.edge_factor;
  }
}

bool DutyWear::surface_changes_much(const WornDepths& from, const WornDepths& to) const {
  const RingState a = surface_at(from), b = surface_at(to);
  const auto change = [](double before, double after) { return before > 0 ? std::abs(after / before - 1) : 0.0; };
  return std::max({change(a.roughness, b.roughness), change(a.Rpq.value_or(0), b.Rpq.value_or(0)),
                   change(a.boundary_shear_strength_coefficient, b.boundary_shear_strength_coefficient)}) >
         kSurfaceChange;
}

}  // namespace ringfilm::life
