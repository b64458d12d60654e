#include "ringfilm/gas_path/cycle_integration.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>
#include <utility>

#include "ringfilm/base/constants.hpp"
#include "ringfilm/base/error.hpp"
#include "ringfilm/base/number_text.hpp"

namespace ringfilm::gas_path {
namespace {

constexpr int kCycleDegrees = static_cast<int>(base::kCycleDeg);
/// Relative error of a pressure, and error of the position and the velocity of a ring, that a step may have.
constexpr double kPressureError = 1e-6, kPositionError = 1e-6, kVelocityError = 1e-5;
/// First step of a cycle, and after a change of contact the longest [degree].
constexpr double kFirstStep = 0.1;
/// No step is shorter; where one would have to be, the integration stops [degree].
constexpr double kMinStep = 1e-10;
/// A ring lies on a flank that it is so near to [side clearance].
constexpr double kTouching = 1e-9;
/// Places within a step where changes of contact and peaks of pressure are looked for.
constexpr std::array<double, 6> kLooks = {0.1550510257216822, 0.3, 0.45, 0.6449489742783178, 0.82, 1.0};
/// More changes of contact in a cycle are not followed.
constexpr std::size_t kMaxEvents = 20000;

double wrapped_angle(double angle) { return angle >= base::kCycleDeg ? angle - base::kCycleDeg : angle; }

/// Events that can end the present contact of a ring.
std::array<FlankEvent, 2> possible_events(Contact contact) {
  if (contact == Contact::kLowerFlank) return {FlankEvent::kLeavesLower, FlankEvent::kLeavesLower};
  if (contact == Contact::kUpperFlank) return {FlankEvent::kLeavesUpper, FlankEvent::kLeavesUpper};
  return {FlankEvent::kLandsLower, FlankEvent::kLandsUpper};
}

bool is_landing(FlankEvent event) { return event == FlankEvent::kLandsLower || event == FlankEvent::kLandsUpper; }

double flank(FlankEvent landing) { return landing == FlankEvent::kLandsUpper ? 1.0 : 0.0; }

}  // namespace

CycleIntegration::CycleIntegration(const Network& network, PackState begin)
    : network_(network),
      system_(network),
      state_(std::move(begin)),
      pressure_(network.n_regions()),
      flow_(network.paths().size()) {
  system_.set_contacts(state_);
}

void CycleIntegration::begin_cycle() {
  angle_ = kBeginDeg;
  n_steps_ = 0;
  flow_steps_.clear();
  next_step_ = kFirstStep;  // equal in each cycle, so that equal beginnings have equal ends
  step_.forget();
  result_ = {};
  result_.paths = network_.paths();
  for (const Region& region : network_.regions()) result_.regions.push_back({region.name, 0, 0, 0});
  result_.pressure.assign(kCycleDegrees, {});
  result_.flow.assign(kCycleDegrees, {});
  result_.position.assign(kCycleDegrees, {});
  result_.transported.assign(network_.paths().size(), 0);
  result_.back.assign(network_.paths().size(), 0);
  passed_.assign(network_.paths().size(), 0);
  const std::size_t n = system_.n_inner();
  sensitivity_.assign(system_.size() * n, 0);
  for (std::size_t i = 0; i < n; ++i) sensitivity_[i * n + i] = 1;
}

void CycleIntegration::record_degree(int degree) {
  system_.unknowns(state_, y_);
  system_.flows(angle_, y_, pressure_, flow_);
  result_.pressure[degree] = pressure_;
  result_.flow[degree] = flow_;
  for (std::size_t i = 0; i < state_.position.size(); ++i) {
    result_.position[degree].push_back(state_.position[i] * network_.pack().rings[i].side_clearance);
  }
}

void CycleIntegration::integrate(long most_steps) {
  most_steps_ = most_steps;
  begin_cycle();
  const auto stored = [&] {
    double mass = 0;
    for (std::size_t i = 0; i < state_.pressure.size(); ++i) {
      mass += network_.regions()[network_.inner()[i]].capacity * state_.pressure[i] * PackSystem::kPressureUnit;
    }
    return mass;
  };
  stored_before_ = stored();
  for (int i = 0; i < kCycleDegrees; ++i) {
    record_degree((static_cast<int>(kBeginDeg) + i) % kCycleDegrees);
    advance_to(kBeginDeg + i + 1);
  }
  double in = 0, out = 0, blow_by = 0, gross = 0;
  const std::size_t crankcase = network_.n_regions() - 1;
  for (std::size_t k = 0; k < result_.paths.size(); ++k) {
    const Path& path = result_.paths[k];
    if (!network_.is_inner(path.from)) in += result_.transported[k];
    if (!network_.is_inner(path.to)) out += result_.transported[k];
    if (path.to == crankcase) blow_by += result_.transported[k];
    if (path.from == crankcase) blow_by -= result_.transported[k];
    if (!network_.is_inner(path.from) || !network_.is_inner(path.to)) gross += passed_[k];
  }
  result_.blow_by = blow_by;
  const double defect = std::abs(in - out - (stored() - stored_before_));
  result_.mass_defect = defect > 0 ? defect / (gross + stored_before_) : 0;
}

void CycleIntegration::advance_to(double end_deg) {
  while (end_deg - angle_ > kMinStep) {
    leave_flanks();
    system_.unknowns(state_, y_);
    const double remaining = end_deg - angle_;
    double h = std::min(next_step_, remaining);
    if (remaining - h < 0.1 * h) h = remaining;
    h = attempt(h);
    std::vector<Found> found = first_events(h);
    if (!found.empty()) h = shorten_to(found, h);
    commit(h);
    angle_ = h == remaining ? end_deg : angle_ + h;
    if (!found.empty()) conclude(found.front());
  }
  angle_ = end_deg;
}

/// Solves a step of that length or a shorter one whose error is small enough. @returns its length [degree]
double CycleIntegration::attempt(double h) {
  scale_.resize(y_.size());
  for (std::size_t i = 0; i < system_.n_inner(); ++i) scale_[i] = kPressureError * std::max(y_[i], 1e-3);
  for (std::size_t k = 0; k < system_.free_rings().size(); ++k) {
    const std::size_t at = system_.place(k);
    scale_[at] = kPositionError;
    scale_[at + 1] = kVelocityError * std::max(std::abs(y_[at + 1]), 1e-2);
  }
  const double asked = h;
  for (;;) {
    if (++n_steps_ > most_steps_) {
      stop("a cycle takes more than " + std::to_string(most_steps_) + " steps, here of " + number_text(h) + " degree");
    }
    const RadauStep::Outcome outcome = step_.solve(system_, angle_, y_, h, scale_);
    const double growth =
        outcome.solved ? std::clamp(0.9 * std::pow(std::max(outcome.error, 1e-8), -0.25), 0.2, 4.0) : 0.25;
    if (outcome.solved && outcome.error <= 1) {
      const bool was_cut = h == asked && asked < next_step_;
      next_step_ = was_cut ? std::max(next_step_, h * growth) : h * growth;
      return h;
    }
    h *= std::min(growth, 0.9);
    step_.forget();
    if (h < kMinStep) stop("no step is short enough");
  }
}

/// Names the volume that makes the steps short, and what the rings did.
void CycleIntegration::stop(const std::string& reason) {
  std::vector<double> conductance(result_.paths.size()), slope(network_.n_regions(), 0.0);
  system_.conductances(angle_, y_, conductance);
  for (std::size_t k = 0; k < conductance.size(); ++k) {
    for (const std::size_t region : {result_.paths[k].from, result_.paths[k].to}) slope[region] += conductance[k];
  }
  std::string text = "the gas between the rings was not found at " + number_text(wrapped_angle(angle_)) +
                     " degree of crank angle: " + reason;
  const auto& inner = network_.inner();
  const auto quickness = [&](std::size_t r) { return slope[r] / network_.regions()[r].capacity; };
  const auto quickest =
      std::max_element(inner.begin(), inner.end(), [&](auto a, auto b) { return quickness(a) < quickness(b); });
  if (quickest != inner.end() && slope[*quickest] > 0) {
    text += "; " + network_.regions()[*quickest].name + " follows its neighbours within " +
            number_text(1 / quickness(*quickest)) + " s, state a larger volume or narrower gaps there";
  }
  if (network_.pack().ring_motion == RingMotion::kAxial) {
    text += "; the rings have changed flanks " + std::to_string(result_.events.size()) +
            " times in this cycle, state larger ring masses, or gas_path.ring_motion = \"seated\"";
  }
  throw ConvergenceError(text, wrapped_angle(angle_));
}

double CycleIntegration::event_value(std::size_t ring, FlankEvent event, double share, double h) {
  at_.resize(y_.size());
  step_.interpolate(share, at_);
  const auto& free = system_.free_rings();
  switch (event) {
    case FlankEvent::kLeavesLower:
      return system_.acceleration(ring, angle_ + share * h, at_);
    case FlankEvent::kLeavesUpper:
      return -system_.acceleration(ring, angle_ + share * h, at_);
    default:
      break;
  }
  const auto k = static_cast<std::size_t>(std::find(free.begin(), free.end(), ring) - free.begin());
  const double position = at_[system_.place(k)];
  return event == FlankEvent::kLandsLower ? -position - kTouching : position - 1 - kTouching;
}

/// Share of the step at which an event happens that has not happened at `low` and has at `high`.
double CycleIntegration::locate(std::size_t ring, FlankEvent event, double low, double high, double h) {
  for (int i = 0; i < 60 && high - low > 1e-13; ++i) {
    const double middle = (low + high) / 2;
    (event_value(ring, event, middle, h) > 0 ? high : low) = middle;
  }
  return high;
}

/// The earliest change of contact in the step that was solved last, if there is one.
std::vector<CycleIntegration::Found> CycleIntegration::first_events(double h) {
  std::vector<Found> found;
  if (network_.pack().ring_motion == RingMotion::kSeated) return found;
  for (std::size_t ring = 0; ring < state_.contact.size(); ++ring) {
    if (!network_.has_groove(ring)) continue;
    for (const FlankEvent event : possible_events(state_.contact[ring])) {
      double low = 0;
      for (const double share : kLooks) {
        if (!found.empty() && low >= found.front().share) break;
        if (event_value(ring, event, share, h) > 0) {
          const double at = locate(ring, event, low, share, h);
          if (found.empty() || at < found.front().share) found = {{ring, event, at}};
          break;
        }
        low = share;
      }
    }
  }
  return found;
}

/// Solves the step once more up to the event; a ring that lands is brought to its flank. Where that step cannot be
/// solved, a shorter one is, in which nothing happens. @returns its length [degree]
double CycleIntegration::shorten_to(std::vector<Found>& found, double h) {
  const Found event = found.front();
  double length = std::max(event.share * h, 10 * kMinStep);
  for (int i = 0; i < 4; ++i) {
    step_.forget();
    ++n_steps_;
    if (!step_.solve(system_, angle_, y_, length, scale_).solved) break;
    if (!is_landing(event.event) || i == 3) return length;
    const auto& free = system_.free_rings();
    const auto k = static_cast<std::size_t>(std::find(free.begin(), free.end(), event.ring) - free.begin());
    const double beyond = step_.stage(2)[system_.place(k)] - flank(event.event);
    const double velocity = step_.stage(2)[system_.place(k) + 1];
    if (std::abs(beyond) < 1e-8 || std::abs(beyond) > 0.5 * std::abs(velocity) * length) return length;
    length = std::clamp(length - beyond / velocity, 10 * kMinStep, h);
  }
  found.clear();
  return attempt(0.5 * length);
}

/// Takes the end of the step that was solved last. The masses change by what passes along the paths, so that none is
/// lost or made.
void CycleIntegration::commit(double h) {
  update_peaks(h);
  const std::size_t n_paths = result_.paths.size(), n_inner = system_.n_inner();
  std::vector<double> moved(n_paths, 0.0);
  FlowStep masses;
  masses.forward.assign(n_paths, 0.0);
  masses.back.assign(n_paths, 0.0);
  for (std::size_t j = 0; j < RadauStep::kStages; ++j) {
    const double weight = RadauStep::kWeights[j] * h;
    system_.flows(angle_ + RadauStep::kNodes[j] * h, step_.stage(j), pressure_, flow_);
    for (std::size_t k = 0; k < n_paths; ++k) {
      const double mass = weight * system_.seconds_per_degree() * flow_[k];
      moved[k] += mass;
      passed_[k] += std::abs(mass);
      result_.back[k] += std::max(-mass, 0.0);
      masses.forward[k] += std::max(mass, 0.0);
      masses.back[k] += std::max(-mass, 0.0);
    }
    for (std::size_t i = 0; i < pressure_.size(); ++i) {
      result_.regions[i].mean_pressure += weight / base::kCycleDeg * pressure_[i];
    }
  }
  step_.carry(sensitivity_, n_inner);
  system_.take(step_.stage(2), state_);
  const std::vector<double> quadrature = moved;
  close_balance(h, moved);
  for (std::size_t k = 0; k < n_paths; ++k) result_.transported[k] += moved[k];
  if (network_.pack().composition) record_flows(h, std::move(masses), quadrature, moved);
}

/// Keeps the masses of the step that was taken. @param step what its stages move along the paths, and back
/// @param net_before mass along each path by the stages @param moved with what closes the balance [kg]
void CycleIntegration::record_flows(double h, FlowStep step, const std::vector<double>& net_before,
                                    const std::vector<double>& moved) {
  step.begin_deg = angle_;
  step.end_deg = angle_ + h;
  const auto& inner = network_.inner();
  for (std::size_t i = 0; i < inner.size(); ++i) {
    const double unit = network_.regions()[inner[i]].capacity * PackSystem::kPressureUnit;
    step.mass_before.push_back(unit * y_[i]);
    step.mass_after.push_back(unit * state_.pressure[i]);
  }
  for (std::size_t k = 0; k < moved.size(); ++k) {
    const double closing = moved[k] - net_before[k];
    (closing > 0 ? step.forward[k] : step.back[k]) += std::abs(closing);
  }
  flow_steps_.push_back(std::move(step));
}

/// Masses at the end of a step and masses that the quadrature moves along the paths differ by rounding, and by what the
/// iteration leaves. One more step of the iteration, eq-balance-closure, removes the difference: a slow region takes it
/// as pressure, a fast one as flow. @param moved mass along each path [kg]
void CycleIntegration::close_balance(double h, std::vector<double>& moved) {
  const std::size_t n = system_.n_inner();
  const double seconds = h * system_.seconds_per_degree();
  std::vector<double> matrix(n * n, 0.0), missed(n), exchange(moved.size());
  system_.conductances(angle_ + h, step_.stage(2), exchange);
  for (double& one : exchange) one *= seconds;
  for (std::size_t i = 0; i < n; ++i) {
    matrix[i * n + i] = network_.regions()[network_.inner()[i]].capacity;
    missed[i] = matrix[i * n + i] * PackSystem::kPressureUnit * (y_[i] - step_.stage(2)[i]);
  }
  for (std::size_t k = 0; k < moved.size(); ++k) {
    const Path& path = result_.paths[k];
    for (const auto& [region, other, sign] :
         {std::tuple{path.from, path.to, -1.0}, std::tuple{path.to, path.from, 1.0}}) {
      if (!network_.is_inner(region)) continue;
      const std::size_t row = network_.unknown(region);
      missed[row] += sign * moved[k];
      matrix[row * n + row] += exchange[k];
      if (network_.is_inner(other)) matrix[row * n + network_.unknown(other)] -= exchange[k];
    }
  }
  LuFactors factors;
  factors.factorize(matrix, n);
  factors.solve(missed);
  const auto change = [&](std::size_t region) {
    return network_.is_inner(region) ? missed[network_.unknown(region)] : 0;
  };
  for (std::size_t i = 0; i < n; ++i) state_.pressure[i] += missed[i] / PackSystem::kPressureUnit;
  for (std::size_t k = 0; k < moved.size(); ++k) {
    moved[k] += exchange[k] * (change(result_.paths[k].from) - change(result_.paths[k].to));
  }
}

void CycleIntegration::update_peaks(double h) {
  at_.resize(y_.size());
  for (const double share : kLooks) {
    step_.interpolate(share, at_);
    for (std::size_t i = 0; i < system_.n_inner(); ++i) {
      RegionValues& region = result_.regions[network_.inner()[i]];
      const double p = at_[i] * PackSystem::kPressureUnit;
      if (p <= region.peak_pressure) continue;
      region.peak_pressure = p;
      region.peak_pressure_angle_deg = wrapped_angle(angle_ + share * h);
    }
  }
}

/// Lets go the rings that no longer press on their flanks.
void CycleIntegration::leave_flanks() {
  if (network_.pack().ring_motion == RingMotion::kSeated) return;
  for (std::size_t ring = 0; ring < state_.contact.size(); ++ring) {
    if (!network_.has_groove(ring) || state_.contact[ring] == Contact::kFree) continue;
    system_.unknowns(state_, y_);
    const double a = system_.acceleration(ring, angle_, y_);
    const bool lower = state_.contact[ring] == Contact::kLowerFlank;
    if (lower ? a <= 0 : a >= 0) continue;
    conclude({ring, lower ? FlankEvent::kLeavesLower : FlankEvent::kLeavesUpper, 0});
  }
}

void CycleIntegration::conclude(const Found& found) {
  if (result_.events.size() >= kMaxEvents) {
    throw ConvergenceError("the rings change their flanks more than " + std::to_string(kMaxEvents) + " times a cycle",
                           wrapped_angle(angle_));
  }
  result_.events.push_back({found.ring + 1, wrapped_angle(angle_), found.event});
  const std::vector<std::size_t> free_before = system_.free_rings();
  state_.velocity[found.ring] = 0;
  state_.contact[found.ring] = Contact::kFree;
  if (is_landing(found.event)) {
    state_.position[found.ring] = flank(found.event);
    state_.contact[found.ring] = found.event == FlankEvent::kLandsUpper ? Contact::kUpperFlank : Contact::kLowerFlank;
  }
  system_.set_contacts(state_);
  reshape_sensitivity(free_before);
  step_.forget();
  next_step_ = std::min(next_step_, kFirstStep);
}

void CycleIntegration::reshape_sensitivity(const std::vector<std::size_t>& free_before) {
  const std::size_t n = system_.n_inner();
  std::vector<double> rows(system_.size() * n, 0.0);
  std::copy_n(sensitivity_.begin(), n * n, rows.begin());
  const auto& free = system_.free_rings();
  for (std::size_t k = 0; k < free.size(); ++k) {
    const auto before = std::find(free_before.begin(), free_before.end(), free[k]) - free_before.begin();
    if (static_cast<std::size_t>(before) == free_before.size()) continue;
    std::copy_n(sensitivity_.begin() + (n + 2 * before) * n, 2 * n, rows.begin() + system_.place(k) * n);
  }
  sensitivity_ = std::move(rows);
}

GasPathResult CycleIntegration::result() const {
  GasPathResult result = result_;
  for (std::size_t r = 0; r < result.regions.size(); ++r) {
    const models::CyclePressure* given = network_.regions()[r].given;
    if (given == nullptr) continue;
    result.regions[r].peak_pressure = given->peak();
    result.regions[r].peak_pressure_angle_deg = given->peak_angle_deg();
  }
  std::stable_sort(result.events.begin(), result.events.end(),
                   [](const RingEvent& a, const RingEvent& b) { return a.crank_angle_deg < b.crank_angle_deg; });
  result.duration = base::kCycleDeg * system_.seconds_per_degree();
  result.trapped_mass = network_.pack().trapped_mass;
  return result;
}

}  // namespace ringfilm::gas_path
