#include "ringfilm/gas_path/solve_gas_path.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <utility>

#include "ringfilm/gas_path/composition.hpp"
#include "ringfilm/gas_path/cycle_integration.hpp"
#include "ringfilm/gas_path/static_twist.hpp"

namespace ringfilm::gas_path {
namespace {

/// Relative change of a pressure from cycle to cycle below which it repeats.
constexpr double kRepeats = 1e-8;
/// Where rings move, changes below that are taken once no more cycle makes them smaller.
constexpr double kRepeatsInMotion = 1e-6;
constexpr int kMaxCycles = 50;
/// No cycle begins after so many steps: half a minute with four rings.
constexpr long kMaxSteps = 500'000;
/// More cycles that a motion is followed which does not repeat by then, the longest period that is looked for, and how
/// near a ring comes to its place before [side clearance].
constexpr int kMaxFollowed = 100;
constexpr std::size_t kMaxPeriod = 12;
constexpr double kAlikePosition = 1e-4;
/// Share of a pressure that Newton's method on the cycle leaves alone where nothing determines it, squared.
constexpr double kIndeterminate = 1e-20;

/// Newton's method changes a pressure by this share at the most, upwards; half of it downwards.
constexpr double kMaxJump = 4.0;

double largest_change(const std::vector<double>& before, const std::vector<double>& after) {
  double largest = 0;
  for (std::size_t i = 0; i < before.size(); ++i) {
    largest = std::max(largest, std::abs(after[i] - before[i]) / std::max(before[i], after[i]));
  }
  return largest;
}

/// Begin of the next cycle by Newton's method: (1 - S) step = end - begin in the sense of least squares, since gas that
/// is shut in may have any pressure.
std::vector<double> newton_begin(const std::vector<double>& begin, const std::vector<double>& end,
                                 const std::vector<double>& sensitivity, double lowest, double highest) {
  const std::size_t n = begin.size();
  std::vector<double> normal(n * n, 0.0), step(n, 0.0);
  const auto of_map = [&](std::size_t i, std::size_t k) { return (i == k ? 1.0 : 0.0) - sensitivity[i * n + k]; };
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t k = 0; k < n; ++k) {
      for (std::size_t j = 0; j < n; ++j) normal[i * n + k] += of_map(j, i) * of_map(j, k);
      step[i] += of_map(k, i) * (end[k] - begin[k]);
    }
    normal[i * n + i] += kIndeterminate;
  }
  LuFactors factors;
  if (!factors.factorize(normal, n)) return end;
  factors.solve(step);
  std::vector<double> next(n);
  for (std::size_t i = 0; i < n; ++i) {
    const double longest = kMaxJump * begin[i];
    next[i] = std::clamp(begin[i] + std::clamp(step[i], -longest / 2, longest), lowest, highest);
  }
  return next;
}

/// Rings on their lower flanks, gas at the pressure of the crankcase.
PackState first_state(const Network& network) {
  const std::size_t n = network.pack().rings.size();
  const double p = network.pack().crankcase.pressure(CycleIntegration::kBeginDeg) / PackSystem::kPressureUnit;
  return {std::vector<double>(network.inner().size(), p), std::vector<double>(n, 0.0), std::vector<double>(n, 0.0),
          std::vector<Contact>(n, Contact::kLowerFlank)};
}

double lowest_pressure(const models::CyclePressure& pressure) {
  double lowest = pressure.pressure(0);
  for (int angle = 1; angle < 720; ++angle) lowest = std::min(lowest, pressure.pressure(angle));
  return lowest;
}

/// Strokes in which each ring leaves its lower flank more than once, and how often it does in the cycle.
std::vector<RingMotionValues> motion_values(const std::vector<RingEvent>& events, const std::vector<Ring>& rings) {
  std::vector<RingMotionValues> values(rings.size());
  for (std::size_t i = 0; i < rings.size(); ++i) values[i].has_groove = rings[i].kind == RingKind::kCompression;
  std::vector<int> last_stroke(rings.size(), -1);
  for (const RingEvent& event : events) {
    if (event.event != FlankEvent::kLeavesLower) continue;
    const int stroke = static_cast<int>(event.crank_angle_deg / 180);
    RingMotionValues& ring = values[event.ring - 1];
    ring.flutters = ring.flutters || last_stroke[event.ring - 1] == stroke;
    last_stroke[event.ring - 1] = stroke;
    ++ring.departures;
  }
  return values;
}

/// What twists a ring on its lower flank, from degree to degree.
void add_static_twist(const Network& network, std::size_t ring, GasPathResult& result) {
  const Ring& of = network.pack().rings[ring];
  if (of.face_width == 0 || of.youngs_modulus == 0) return;
  const RingBorders& at = network.borders(ring);
  RingMotionValues& values = result.motion[ring];
  double largest = 0, largest_at = 0;
  std::size_t n_twisted = 0;
  for (std::size_t angle = 0; angle < result.pressure.size(); ++angle) {
    const std::vector<double>& p = result.pressure[angle];
    const double radians = static_cast<double>(angle) * std::numbers::pi / 180;
    const double twist = static_twist(network, ring, radians, p[at.above], p[at.groove], p[at.below], p.back()).angle;
    if (twist != 0) ++n_twisted;
    if (std::abs(twist) <= std::abs(largest)) continue;
    largest = twist;
    largest_at = static_cast<double>(angle);
  }
  values.largest_static_twist_angle_deg = largest_at;
  values.largest_static_twist = largest;
  values.twisted_share = static_cast<double>(n_twisted) / static_cast<double>(result.pressure.size());
}

/// What presses the rings on their lower flanks, from degree to degree.
void add_seating_forces(const Network& network, GasPathResult& result) {
  for (std::size_t i = 0; i < result.motion.size(); ++i) {
    RingMotionValues& ring = result.motion[i];
    if (!ring.has_groove) continue;
    const RingBorders& at = network.borders(i);
    ring.least_seating_force = std::numeric_limits<double>::infinity();
    std::size_t n_unseated = 0;
    for (std::size_t angle = 0; angle < result.pressure.size(); ++angle) {
      const std::vector<double>& p = result.pressure[angle];
      const double radians = static_cast<double>(angle) * std::numbers::pi / 180;
      const double force = -network.axial_force(i, radians, p[at.above], p[at.groove], p[at.below], p.back());
      if (force < 0) ++n_unseated;
      if (force >= ring.least_seating_force) continue;
      ring.least_seating_force = force;
      ring.least_seating_force_angle_deg = static_cast<double>(angle);
    }
    ring.unseated_share = static_cast<double>(n_unseated) / static_cast<double>(result.pressure.size());
    add_static_twist(network, i, result);
  }
}

/// Where gas presses rings off the liner, from degree to degree.
void add_collapse(const Network& network, GasPathResult& result) {
  for (std::size_t i = 0; i < result.motion.size(); ++i) {
    const Ring& ring = network.pack().rings[i];
    if (!ring.collapse.is_possible() || network.borders(i).above == network.borders(i).below) continue;
    RingMotionValues& values = result.motion[i];
    std::size_t n_off = 0;
    for (const std::vector<double>& pressure : result.pressure) {
      const double excess = network.pressure_off_liner(i, pressure);
      if (excess <= 0) continue;
      ++n_off;
      values.farthest_off_liner = std::max(values.farthest_off_liner, ring.collapse.distance(excess));
    }
    values.off_liner_share = static_cast<double>(n_off) / static_cast<double>(result.pressure.size());
  }
}

/// Is gas and rings one as the other?
bool is_alike(const PackState& a, const PackState& b) {
  if (a.contact != b.contact || largest_change(a.pressure, b.pressure) > kRepeatsInMotion) return false;
  for (std::size_t i = 0; i < a.position.size(); ++i) {
    if (std::abs(a.position[i] - b.position[i]) > kAlikePosition) return false;
  }
  return true;
}

/// A motion that was followed for more cycles.
struct Followed {
  int cycles = 0;      ///< for so many
  int period = 0;      ///< in cycles; 0: none was found
  double change = 0;   ///< largest relative change of a pressure from one period to the next; without one, of a cycle
  double blow_by = 0;  ///< mean of the period [kg]
};

/// Follows a motion that does not repeat from cycle to cycle until it repeats after several: a ring that flutters may
/// double its period.
/// @param n_steps made so far @param of_last_cycle largest relative change of a pressure
Followed follow_to_period(CycleIntegration& cycle, long n_steps, double of_last_cycle) {
  std::vector<PackState> states{cycle.state()};
  std::vector<double> of_cycle;
  Followed followed;
  followed.change = of_last_cycle;
  for (int n = 0; n < kMaxFollowed && n_steps < kMaxSteps; ++n) {
    cycle.integrate();
    n_steps += cycle.n_steps();
    states.push_back(cycle.state());
    of_cycle.push_back(cycle.result().blow_by);
    const auto change = [&states](std::size_t period) {
      return largest_change(states[states.size() - 1 - period].pressure, states.back().pressure);
    };
    followed.cycles = n + 1;
    followed.change = change(1);
    for (std::size_t period = 1; period <= kMaxPeriod && period < states.size(); ++period) {
      if (!is_alike(states.back(), states[states.size() - 1 - period])) continue;
      followed.period = static_cast<int>(period);
      followed.change = change(period);
      followed.blow_by = std::accumulate(of_cycle.end() - followed.period, of_cycle.end(), 0.0) / followed.period;
      return followed;
    }
  }
  return followed;
}

}  // namespace

namespace {

GasPathResult solve_with_these_faces(const Pack& pack, const Network& network) {
  CycleIntegration cycle(network, first_state(network));
  const double unit = PackSystem::kPressureUnit;
  double lowest = std::numeric_limits<double>::infinity(), highest = 0;
  for (const Region& region : network.regions()) {
    if (region.given == nullptr) continue;
    lowest = std::min(lowest, lowest_pressure(*region.given) / unit);
    highest = std::max(highest, region.given->peak() / unit);
  }
  double change = 0, change_before = 0;
  bool repeats = false, has_jumped = false;
  int n = 0, n_to_follow = 0, n_to_wait = 1;
  long n_steps = 0;
  while (!repeats && n < kMaxCycles && n_steps < kMaxSteps) {
    const PackState begin = cycle.state();
    cycle.integrate();
    n_steps += cycle.n_steps();
    ++n;
    const PackState& end = cycle.state();
    change = largest_change(begin.pressure, end.pressure);
    const bool same_contact = begin.contact == end.contact;
    repeats = same_contact && (change <= kRepeats || (change <= kRepeatsInMotion && n > 8));
    // The sensitivity leaves changes of contact out: where it leads astray, more and more cycles follow one
    // another before it is asked again.
    if (has_jumped && change > 0.5 * change_before) {
      n_to_follow = n_to_wait;
      n_to_wait *= 2;
    }
    has_jumped = !repeats && same_contact && n_to_follow == 0 && !begin.pressure.empty();
    n_to_follow = std::max(0, n_to_follow - 1);
    if (has_jumped) {
      cycle.set_pressures(newton_begin(begin.pressure, end.pressure, cycle.sensitivity(), lowest, highest));
    }
    change_before = change;
  }
  const Followed followed = repeats ? Followed{0, 1, change, 0} : follow_to_period(cycle, n_steps, change);
  GasPathResult result = cycle.result();
  if (followed.period > 1) result.blow_by = followed.blow_by;
  result.periodicity = followed.change;
  result.repeats = followed.period == 1;
  result.period = followed.period;
  result.cycles = n + followed.cycles;
  result.motion = motion_values(result.events, pack.rings);
  add_seating_forces(network, result);
  add_collapse(network, result);
  add_composition(network, cycle.flow_steps(), result);
  return result;
}

}  // namespace

/// The faces are sealed at first. Rings that gas presses off the liner then are free to leave it, and so on.
GasPathResult solve_gas_path(const Pack& pack, const GivenPressures& below) {
  Pack opened = pack;
  for (;;) {
    const Network network(opened, below);
    GasPathResult result = solve_with_these_faces(opened, network);
    bool is_new = false;
    for (std::size_t i = 0; i < opened.rings.size(); ++i) {
      const bool leaves = result.motion[i].off_liner_share > 0 && !opened.rings[i].leaves_liner;
      is_new = is_new || leaves;
      opened.rings[i].leaves_liner = opened.rings[i].leaves_liner || leaves;
    }
    if (!is_new) return result;
  }
}

}  // namespace ringfilm::gas_path
