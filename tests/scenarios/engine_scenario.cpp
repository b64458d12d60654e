#include "engine_scenario.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

#include "../unit/cycle/styles_case.hpp"
#include "repeatable_numbers.hpp"

namespace ringfilm::cycle::testing {
namespace {

using ringfilm::scenarios::RepeatableNumbers;

/// The coordinates of one point of the sequence, asked for one after the other and always in the same order.
class Coordinates {
 public:
  Coordinates(std::uint64_t seed, int index) : shift_(seed), index_(index) {}

  double between(double low, double high) { return low + (high - low) * next(); }
  double log_between(double low, double high) { return low * std::pow(high / low, next()); }
  int one_of(int n) { return std::min(static_cast<int>(n * next()), n - 1); }

 private:
  double next() {
    static constexpr std::array kPrimes = {2,   3,   5,   7,   11,  13,  17,  19,  23,  29,  31,  37,  41,  43,
                                           47,  53,  59,  61,  67,  71,  73,  79,  83,  89,  97,  101, 103, 107,
                                           109, 113, 127, 131, 137, 139, 149, 151, 157, 163, 167, 173};
    const double value = shift_.next() + index_ * std::sqrt(static_cast<double>(kPrimes.at(i_prime_++)));
    return value - std::floor(value);
  }

  RepeatableNumbers shift_;
  double index_;
  std::size_t i_prime_ = 0;
};

constexpr double kNewRingPeak = 62e5;  // of the trace that is scaled [Pa]
constexpr double kSuction = 0.9e5;     // where that trace is lowest, about [Pa]
constexpr double kMinPressure = 3e4;   // a closed throttle [Pa]
constexpr double kTraceStepDeg = 0.25;
constexpr double kFewCells = 1.6;  // skews the cells towards few, where costs are low

/// Oscillation that dies out, as pressure pick-ups show it after knock.
struct Knock {
  double start_deg, period_deg, decay_deg, share;  // share of the pressure at the start [-]
};
/// The pressure changes by a factor within one sample and comes back.
struct Step {
  double start_deg, length_deg, factor;
};

double interpolated(const SampledTrace& trace, double angle) {
  const auto& x = trace.crank_angle_deg;
  const double in_range = x.front() + std::fmod(angle - x.front() + 1440, 720);
  const auto next = std::upper_bound(x.begin(), x.end(), in_range);
  if (next == x.end()) return trace.value.back();
  const auto i = static_cast<std::size_t>(next - x.begin());
  const double share = (in_range - x[i - 1]) / (x[i] - x[i - 1]);
  return trace.value[i - 1] + share * (trace.value[i] - trace.value[i - 1]);
}

void draw_trace(Coordinates& at, RepeatableNumbers& noise, EngineScenario& scenario) {
  Case& c = scenario.input;
  const double peak = at.log_between(1e5, 300e5);
  scenario.trace = static_cast<TraceKind>(at.one_of(5));
  const double rpm = c.operating.speed * 60 / (2 * std::numbers::pi);
  const double frequency = at.log_between(4e3, 20e3);  // of the chamber's modes [Hz]
  const Knock knock{at.between(5, 40), std::max(6 * rpm / frequency, 2 * kTraceStepDeg), at.between(5, 40),
                    at.between(0.02, 0.4)};
  const Step step{at.between(0, 700), at.between(1, 20), at.log_between(0.3, 3)};
  const bool knocks = scenario.trace == TraceKind::kKnock || scenario.trace == TraceKind::kKnockAndStep;
  const bool steps = scenario.trace == TraceKind::kStep || scenario.trace == TraceKind::kKnockAndStep;
  const double ripple = scenario.trace == TraceKind::kNoisy ? 0.01 * peak : 0.0;

  SampledTrace trace;
  for (int i = 0; i < static_cast<int>(720 / kTraceStepDeg); ++i) {
    const double angle = i * kTraceStepDeg;
    const auto scaled = [&](double at_deg) {
      const double p = interpolated(*c.gas.cylinder_pressure, at_deg);
      return kSuction + (p - kSuction) * (peak - kSuction) / (kNewRingPeak - kSuction);
    };
    double p = scaled(angle) + ripple * noise.between(-1, 1);
    if (knocks && angle >= knock.start_deg) {
      const double since = angle - knock.start_deg;
      p += knock.share * scaled(knock.start_deg) * std::exp(-since / knock.decay_deg) *
           std::sin(2 * std::numbers::pi * since / knock.period_deg);
    }
    if (steps && angle >= step.start_deg && angle < step.start_deg + step.length_deg) p *= step.factor;
    trace.crank_angle_deg.push_back(angle);
    trace.value.push_back(std::max(p, kMinPressure));
  }
  scenario.peak_pressure = *std::max_element(trace.value.begin(), trace.value.end());
  c.gas.cylinder_pressure = std::move(trace);
}

double rise_of(const RingFace& face) {
  if (face.form == FaceForm::kParabola) return face.crown_height;
  const auto [low, high] = std::minmax_element(face.height.begin(), face.height.end());
  return *high - *low;
}

/// Rise of the paper's polynomials, x in mm up to 1.2 mm, height in um.
double rise_of_polynomial(const std::vector<double>& coefficients) {
  double low = 1e9;
  double high = -1e9;
  for (int i = 0; i <= 1200; ++i) {
    double height = 0;
    for (const double a : coefficients) height = height * (i * 1e-3) + a;
    low = std::min(low, height);
    high = std::max(high, height);
  }
  return (high - low) * 1e-6;
}

void draw_face(Coordinates& at, RepeatableNumbers& noise, EngineScenario& scenario) {
  Case& c = scenario.input;
  RingFace& face = c.ring.face;
  const double crown = at.log_between(1e-6, 200e-6);
  const double apex = std::clamp(at.between(-0.05, 1.05), 0.0, 1.0);  // one in eleven at an edge
  const double width = at.log_between(0.6e-3, 4e-3);
  const double roughening = at.log_between(1e-9, 0.3e-6);
  const int n = 20 + at.one_of(380);
  const double worn_share = at.between(0.01, 0.6);  // of the crown
  if (face.form == FaceForm::kPolynomial && scenario.face <= FaceKind::kEmbeddedPolynomial) {
    scenario.rise = rise_of_polynomial(face.coefficients);
    return;
  }
  c.ring.face_width = width;
  face.coefficients.clear();
  if (scenario.face == FaceKind::kParabola) {
    face.form = FaceForm::kParabola;
    face.crown_height = crown;
    face.apex = apex;
  } else {
    face.form = FaceForm::kPoints;
    const double flat = scenario.face == FaceKind::kWornFlat ? worn_share * crown : 0.0;
    const double amplitude = std::min(scenario.face == FaceKind::kWornFlat ? 0.1 * roughening : roughening, crown);
    for (int i = 0; i <= n; ++i) {
      const double share = static_cast<double>(i) / n;
      const double form = crown * std::pow((share - apex) / std::max(apex, 1 - apex), 2);
      face.x.push_back(share * width);
      face.height.push_back(std::max(form, flat) + amplitude * noise.between(-1, 1));
    }
    face.x.back() = width;
  }
  scenario.rise = rise_of(face);
}

}  // namespace

const char* name(FaceKind kind) {
  constexpr std::array kNames = {"new", "run-in", "embedded", "parabola", "noisy-points", "worn-flat"};
  return kNames.at(static_cast<std::size_t>(kind));
}

const char* name(TraceKind kind) {
  constexpr std::array kNames = {"smooth", "noisy", "knock", "step", "knock-and-step"};
  return kNames.at(static_cast<std::size_t>(kind));
}

EngineScenario engine_scenario(std::uint64_t seed, int index) {
  static const Case new_ring = styles_new_ring();
  static const Case run_in_ring = styles_run_in_ring();
  static const Case embedded_ring = styles_embedded_ring();
  Coordinates at(seed, index);
  RepeatableNumbers noise(seed ^ (static_cast<std::uint64_t>(index) * 0xd1b54a32d192ed03u));

  constexpr std::array kFaces = {FaceKind::kNewPolynomial, FaceKind::kRunInPolynomial, FaceKind::kEmbeddedPolynomial,
                                 FaceKind::kParabola,      FaceKind::kParabola,        FaceKind::kNoisyPoints,
                                 FaceKind::kNoisyPoints,   FaceKind::kWornFlat};
  EngineScenario scenario;
  scenario.face = kFaces.at(static_cast<std::size_t>(at.one_of(kFaces.size())));
  scenario.input = scenario.face == FaceKind::kRunInPolynomial      ? run_in_ring
                   : scenario.face == FaceKind::kEmbeddedPolynomial ? embedded_ring
                                                                    : new_ring;
  Case& c = scenario.input;
  draw_face(at, noise, scenario);

  const double running = at.log_between(500, 9000);
  const double cranked = at.log_between(50, 500);
  c.operating.speed = (at.one_of(16) == 0 ? cranked : running) * 2 * std::numbers::pi / 60;
  c.operating.oil_temperature = 273.15 + at.between(-30, 180);
  draw_trace(at, noise, scenario);

  c.contact.roughness = at.log_between(0.03e-6, 2e-6);
  c.contact.asperity_radius = at.log_between(0.3e-6, 10e-6);
  c.contact.asperity_density = at.between(0.03, 0.08) / (c.contact.asperity_radius * c.contact.roughness);
  c.contact.lambda_ratio = at.one_of(8) == 0 ? LambdaRatio::kNominal : LambdaRatio::kLocal;
  c.contact.integrals = at.one_of(8) == 0 ? ContactIntegrals::kPolynomial4Digit : ContactIntegrals::kExact;
  c.lubricant.compressibility = at.one_of(4) == 0 ? Compressibility::kNone : Compressibility::kDowsonHigginson;
  c.ring.face.orientation = static_cast<Orientation>(at.one_of(3));
  c.ring.elastic_pressure.reset();
  c.ring.tangential_force = at.log_between(1, 100);
  c.film.cavitation_pressure = at.between(0, 1e5);
  c.film.cavitation = at.one_of(2) == 0 ? Cavitation::kReynoldsExit : Cavitation::kMassConserving;

  c.solver.cells = static_cast<int>(30 * std::pow(1600.0 / 30, std::pow(at.between(0, 1), kFewCells)));
  constexpr std::array kCrankStepsDeg = {0.5, 1.0, 1.0, 1.0, 2.0, 5.0};
  c.solver.crank_step_deg = kCrankStepsDeg.at(static_cast<std::size_t>(at.one_of(kCrankStepsDeg.size())));
  c.solver.crank_step_control = at.one_of(3) == 0 ? StepControl::kAdaptive : StepControl::kFixed;
  constexpr std::array kStartsDeg = {270.0, 270.0, 90.0, 450.0, 630.0, 30.0, 0.0, 180.0};
  scenario.start_angle_deg = kStartsDeg.at(static_cast<std::size_t>(at.one_of(kStartsDeg.size())));
  if (at.one_of(8) == 0) scenario.side_spacing_deg = 7.3;

  constexpr std::array kLaws = {ViscosityPressure::kRoelands, ViscosityPressure::kBarus, ViscosityPressure::kNone};
  c.lubricant.viscosity_pressure = kLaws.at(static_cast<std::size_t>(at.one_of(kLaws.size())));
  c.lubricant.law_parameters["pressure_viscosity_coefficient"] = at.log_between(0.5e-8, 3e-8);
  return scenario;
}

void put_gas_at_edges(Case& c) {
  c.film.cavitation = Cavitation::kMassConserving;
  c.film.chamber_edge = c.film.crankcase_edge = EdgeFluid::kGas;
  c.solver.method = Method::kCoupledNewton;
}

void lay_oil_on_liner(int index, Case& c) {
  const double golden = 0.5 * (std::sqrt(5.0) - 1), place = std::fmod(golden * index, 1.0);
  c.film.supply = OilSupply::kFilmOnLiner;
  c.supply.film = {{0, 0.3e-6 * std::pow(20 / 0.3, place)}};
  c.supply.reach = (0.05 + 0.2 * std::fmod(golden * place, 1.0)) * c.engine.stroke;
  const double steps = 180 / c.solver.crank_step_deg;
  if (steps != std::round(steps)) c.solver.crank_step_deg = 1;
  if (c.ring.face.orientation == Orientation::kLeadingEdge) c.ring.face.orientation = Orientation::kX0Chamber;
}

}  // namespace ringfilm::cycle::testing
