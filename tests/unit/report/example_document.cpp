#include "example_document.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace example {
namespace {

using namespace ringfilm;
using std::numbers::pi;

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

double gas_pressure(double angle) {
  const double turned = angle > 360 ? angle - 720 : angle;
  return 1e5 + 61e5 * std::exp(-std::pow((turned - 20) / (turned < 20 ? 42 : 34), 2));
}

cycle::Sample sample(double angle, double friction) {
  cycle::Sample s;
  s.crank_angle_deg = angle;
  const double phi = angle * pi / 180;
  s.piston_velocity = -6.2 * (std::sin(phi) + 0.14 * std::sin(2 * phi));
  const double speed = std::abs(s.piston_velocity);
  s.piston_position = 0.03975 * (1 - std::cos(phi));
  s.sliding_distance = 0.159 * angle / 360;
  s.gas_pressure = gas_pressure(angle);
  s.crankcase_pressure = 101325;
  s.applied_load = 335.5e-6 * (s.gas_pressure + 2e5);
  s.min_film_thickness = (0.55e-6 + 0.75e-6 * std::sqrt(speed)) * std::pow(1e6 / (s.gas_pressure + 9e5), 0.25);
  s.lambda_ratio = s.min_film_thickness / 0.48e-6;
  s.asperity_load = s.applied_load * friction * std::exp(-1.3 * (s.lambda_ratio - 0.7));
  s.asperity_load_share = std::min(1.0, friction * std::exp(-1.3 * (s.lambda_ratio - 0.7)));
  s.hydrodynamic_load = s.applied_load - s.asperity_load;
  s.asperity_contact_area = s.asperity_load * 6e-11;
  s.boundary_friction = 0.358 * s.asperity_load;
  s.viscous_friction = 1.1 * speed;
  s.viscous_friction_liner = s.piston_velocity > 0 ? s.viscous_friction : -s.viscous_friction;
  s.viscous_friction_ring = 0.9 * s.viscous_friction_liner;
  s.total_friction = s.boundary_friction + s.viscous_friction;
  s.friction_on_liner = s.piston_velocity > 0 ? s.total_friction : -s.total_friction;
  s.friction_coefficient = s.total_friction / s.applied_load;
  s.power_loss = s.total_friction * speed;
  s.archard_wear_load_rate = s.asperity_load * speed;
  s.oil_flow_middle = -3e-4 * s.piston_velocity * s.min_film_thickness / 1e-6;
  s.stribeck_number = 5e-3 * speed / ((s.gas_pressure + 2e5) * 0.48e-6);
  s.peak_film_pressure = s.gas_pressure * 1.02;
  s.cavitated_fraction = 0.3 * std::abs(std::sin(phi));
  s.rupture_position = speed > 1 ? 0.7e-3 : kNaN;
  s.reformation_position = kNaN;
  s.newton_iterations = 4;
  s.crank_sub_steps = 1;
  return s;
}

cycle::CycleValues values(double friction) {
  cycle::CycleValues v;
  v.mean_boundary_power = 106.3 * friction;
  v.mean_viscous_power = 11.75;
  v.mean_power_loss = v.mean_boundary_power + v.mean_viscous_power;
  v.energy_per_cycle = v.mean_power_loss * 0.08;
  v.fmep = v.energy_per_cycle / 494.6e-6;
  v.peak_boundary_friction = 387.6 * friction;
  v.peak_boundary_friction_angle = 20;
  v.peak_viscous_friction = 6.25;
  v.peak_viscous_friction_angle = 55;
  v.peak_total_friction = 391.8 * friction;
  v.peak_total_friction_angle = 20;
  v.peak_friction_coefficient = 0.237 * friction;
  v.peak_friction_coefficient_angle = 540;
  v.peak_friction_coefficient_firing = 0.1846 * friction;
  v.min_film_thickness = 0.6173e-6;
  v.min_film_thickness_angle = 20;
  v.max_film_thickness = 2.42e-6;
  v.peak_gas_pressure = 62e5;
  v.peak_gas_pressure_angle = 20;
  v.lambda_ratio_at_peak_pressure = 1.286;
  v.min_lambda_ratio = 1.286;
  v.boundary_regime_cycle_share = 0.08;
  v.mixed_regime_cycle_share = 0.55;
  v.full_film_cycle_share = 0.37;
  v.boundary_regime_distance_share = 0.04;
  v.mixed_regime_distance_share = 0.43;
  v.full_film_distance_share = 0.53;
  v.boundary_regime_energy_share = 0.4;
  v.mixed_regime_energy_share = 0.55;
  v.full_film_energy_share = 0.05;
  v.net_oil_flow = 92.65e-6;
  v.mean_absolute_oil_flow = 868.7e-6;
  v.peak_film_pressure = 62e5;
  v.archard_wear_load = 23.7 * friction;
  v.power_stroke_energy = 5.1 * friction;
  v.exhaust_stroke_energy = 0.9;
  v.intake_stroke_energy = 1.0;
  v.compression_stroke_energy = 2.4 * friction;
  return v;
}

cycle::FaceFields fields() {
  cycle::FaceFields f;
  constexpr int kNodes = 121;
  constexpr double kWidth = 1.2e-3;
  for (int i = 0; i < kNodes; ++i) {
    f.x.push_back(kWidth * i / (kNodes - 1));
    f.face_height.push_back(27e-6 * std::pow(2.0 * i / (kNodes - 1) - 1, 2));
  }
  for (double angle : {0.0, 20.0, 90.0, 180.0, 270.0, 450.0, 540.0, 700.0}) {
    f.crank_angle_deg.push_back(angle);
    const double top = gas_pressure(angle);
    for (int i = 0; i < kNodes; ++i) {
      const double u = static_cast<double>(i) / (kNodes - 1);
      f.film_thickness.push_back(f.face_height[i] + 0.7e-6);
      f.film_pressure.push_back(u < 0.7 ? top * (1 - u * u) + 1e5 : 101325);
      f.film_content.push_back(u < 0.7 ? 1 : 1 - 0.8 * (u - 0.7));
      f.lambda_ratio.push_back(f.film_thickness.back() / 0.48e-6);
      f.asperity_pressure.push_back(8e6 * std::exp(-f.face_height[i] / 0.4e-6));
    }
  }
  return f;
}

std::vector<study::LedgerEntry> ledger(double friction) {
  cycle::CycleValues other = values(friction);
  other.fmep *= 0.91;
  other.mean_power_loss *= 0.91;
  other.min_film_thickness *= 1.06;
  other.lambda_ratio_at_peak_pressure *= 1.06;
  other.mean_absolute_oil_flow *= 0.42;
  study::LedgerEntry lifted{
      .topic = "reynolds-exit-cavitation",
      .statement = "The film ends where its pressure slope vanishes; nothing is stated on how it forms again.",
      .consequence = "",
      .source = "docs/theory/assumptions.md#cavitation",
      .can_be_lifted = true,
      .variants = {{.setting = "film.cavitation = \"mass-conserving\"", .values = other, .reason = ""},
                   {.setting = "contact.composite_modulus = \"190 GPa\"",
                    .values = {},
                    .solved = false,
                    .reason = "nothing balances the load at 12 degree"}}};
  study::LedgerEntry fixed{.topic = "oil-supply",
                           .statement = "The chamber edge is flooded: oil at 62 bar is pushed through the ring.",
                           .consequence = "Physically that is gas; the flow during the power stroke is too high.",
                           .source = "docs/theory/assumptions.md#oil-supply",
                           .variants = {}};
  return {lifted, fixed};
}

/// Errors of two thousandths of the largest of each curve, three hundredths of each value.
study::ErrorEstimate errors(const cycle::CycleResult& result) {
  study::ErrorEstimate e = study::no_estimate(result.samples.size());
  e.runs = {{.cells = 200, .crank_step_deg = 1, .step_error = 1e-3, .reason = ""},
            {.cells = 400, .crank_step_deg = 1, .step_error = 1e-3, .reason = ""}};
  for (const cycle::CurveQuantity& q : cycle::curve_quantities()) {
    if (!study::has_error(q)) continue;
    double largest = 0;
    for (const cycle::Sample& s : result.samples) largest = std::fmax(largest, std::abs(s.*q.value));
    const bool is_input = q.value == &cycle::Sample::gas_pressure;
    for (cycle::Sample& s : e.samples) s.*q.value = is_input ? 0 : 0.002 * largest;
  }
  for (const cycle::CycleQuantity& q : cycle::cycle_quantities()) {
    e.values.*q.value = 0.03 * std::abs(result.values.*q.value);
  }
  return e;
}

}  // namespace

io::ResultDocument document(const std::string& title, double friction) {
  io::ResultDocument d;
  d.title = title;
  d.inputs = {{"engine.bore", "0.089", "89 mm", false, "cylinder bore, B"},
              {"engine.stroke", "0.0795", "79.5 mm", false, "piston stroke, S"},
              {"engine.connecting_rod_length", "0.1381", "138.1 mm", true, "connecting rod, centre to centre"},
              {"operating.speed", "157.07963267948966", "1500 rpm", false, "engine speed"},
              {"operating.oil_temperature", "393.15", "120 degC", false, "temperature of the oil film"},
              {"gas.cylinder_pressure", "\"/somewhere/trace.csv\"", "/somewhere/trace.csv", false, "CSV file"},
              {"solver.crank_step", "\"1 degree\"", "1 degree", false, "crank step of the integration", 1, "degree"},
              {"gas.trace_origin", "\"synthetic\"", "synthetic", false, "measured, computed or synthetic"},
              {"ring.face_width", "0.0012", "1.2 mm", false, "axial width of the face, b"},
              {"contact.boundary_shear_strength_coefficient", friction == 1.0 ? "0.3581" : "0.29",
               friction == 1.0 ? "0.3581" : "0.29", false, "zeta, the slope F_LFM of lateral force microscopy"},
              {"film.cavitation", "\"reynolds-exit\"", "reynolds-exit", true, "what happens where the film ruptures"}};
  d.resolved_case = fmt::format("title = \"{}\"\n[engine]\nbore = \"0.089 m\"\n", title);
  d.files = {{"case", "/somewhere/cases/styles2014/new.toml", std::string(64, 'a')},
             {"gas.cylinder_pressure", "cylinder_pressure.csv", std::string(64, '7')}};
  d.input_notes = {"the density at 120 degree Celsius is extrapolated"};
  d.provenance = {"ringfilm 0.2.0", "0123456789ab", "GNU 12.2.0, Release", "avx2, 1 lane"};
  for (int k = 0; k < 720; ++k) d.result.samples.push_back(sample(k, friction));
  d.result.values = values(friction);
  d.result.fields = fields();
  for (int k = 0; k < 80; ++k) {
    d.result.stroke.liner_position.push_back(0.0005 + 0.001 * k);
    d.result.stroke.archard_wear_load_density.push_back(friction * 2800 * std::exp(-std::pow((k - 7) / 9.0, 2)) + 90);
  }
  d.result.derived = {{"elastic_pressure", 0.2e6},
                      {"composite_modulus", 134.8e9},
                      {"oil_viscosity", 5.0633e-3},
                      {"full_film_lambda_ratio", 3.8}};
  d.result.notes = {
      {"synthetic-trace", "the cylinder pressure is SYNTHETIC: computed, not measured", 1},
      {"shear-rate-high", "shear rate U/h up to 3.1e+06 1/s (at 75 degree) while the oil is taken as Newtonian", 412}};
  d.result.effort = {.cycles_integrated = 3,
                     .periodicity_error = 2e-10,
                     .crank_steps = 2160,
                     .newton_iterations = 8123,
                     .max_load_residual = 3e-13,
                     .max_newton_step = 4e-9,
                     .max_mass_residual = 2e-14};
  d.errors = errors(d.result);
  d.ledger = ledger(friction);
  d.ledger_computed = true;
  d.comparison = {{.published = {.source = "paper, section 4",
                                 .quantity = "lambda_ratio_at_peak_pressure",
                                 .statement = "lambda ratio at peak cylinder pressure",
                                 .value = 1.41,
                                 .decided_by = "contact.composite_modulus, ring tension"},
                   .computed = 1.286,
                   .deviation = 1.286 / 1.41 - 1,
                   .strongest_setting = "contact.composite_modulus = \"190 GPa\"",
                   .with_strongest_setting = 1.402},
                  {.published = {.source = "paper, Fig. 10",
                                 .quantity = "peak_friction_coefficient_firing",
                                 .statement = "highest friction coefficient between TDC and the peak",
                                 .value = 0.17,
                                 .decided_by = ""},
                   .computed = 0.1846 * friction,
                   .deviation = 0.1846 * friction / 0.17 - 1,
                   .strongest_setting = "",
                   .with_strongest_setting = {}},
                  {.published = {.source = "independent implementation",
                                 .quantity = "mean_power_loss",
                                 .statement = "mean friction power",
                                 .value = 118.0,
                                 .decided_by = ""},
                   .computed = d.result.values.mean_power_loss,
                   .deviation = d.result.values.mean_power_loss / 118.0 - 1,
                   .strongest_setting = "",
                   .with_strongest_setting = {}}};
  return d;
}

namespace {

constexpr double kFace = 1.2e-3, kBore = 89e-3, kEndGap = 0.3e-3;
constexpr double kLength = pi * kBore - kEndGap;

/// Strips that lie close at both ends.
std::vector<double> strips() {
  std::vector<double> y = {0};
  for (double cell = kFace / 50; y.back() + cell < kLength / 2; cell = std::min(1.3 * cell, 5e-3)) {
    y.push_back(y.back() + cell);
  }
  for (std::size_t j = y.size(); j-- > 0;) y.push_back(kLength - y[j]);
  return y;
}

/// Rises from 0 at the ends of the ring to 1 within some face widths.
double away_from_ends(double y) { return 1 - std::exp(-std::min(y, kLength - y) / (0.4 * kFace)); }

void add_node(cycle::UnrolledFields& f, double angle, double x, double y) {
  const double s = x / kFace, gas = gas_pressure(angle), along = away_from_ends(y);
  const bool is_cavity = s > 0.68 && s < 0.9 && along > 0.35;
  const double wedge = s < 0.62 ? std::sin(pi * s / 0.62) * along * (3e5 + 1.1 * gas) : 0;
  f.film_pressure.push_back(static_cast<float>(is_cavity ? 1e5 : 1e5 + (gas - 1e5) * (1 - s) + wedge));
  f.film_content.push_back(static_cast<float>(is_cavity ? 1 - 0.45 * std::sin(pi * (s - 0.68) / 0.22) * along : 1));
  f.film_thickness.push_back(static_cast<float>(0.7e-6 + 56e-6 * std::pow(s - 0.45, 2)));
  f.asperity_pressure.push_back(0);
}

}  // namespace

void add_unrolled_film(io::ResultDocument& document, CircumferentialGrid expected) {
  cycle::UnrolledFields& f = document.result.unrolled;
  f.circumference = pi * kBore;
  f.end_gap = kEndGap;
  f.gap_position = pi / 3;
  f.y = strips();
  const bool is_full = expected == CircumferentialGrid::kFields;
  for (int i = 0; is_full && i <= 120; ++i) f.x.push_back(kFace * i / 120);
  for (int k = 0; k < (is_full ? 24 : 240); ++k) {
    const double angle = k * 720.0 / (is_full ? 24 : 240) + (is_full ? 20 : 0);
    f.crank_angle_deg.push_back(angle);
    for (const double y : f.y) {
      for (const double x : f.x) add_node(f, angle, x, y);
      if (is_full) continue;
      f.strip_hydrodynamic_load.push_back(static_cast<float>(1e3 + 8e-4 * gas_pressure(angle) * away_from_ends(y)));
      f.strip_peak_film_pressure.push_back(static_cast<float>(gas_pressure(angle) * (1 + 1.1 * away_from_ends(y))));
    }
  }
  for (const cycle::Sample& s : document.result.samples) {
    const double phi = s.crank_angle_deg * pi / 180;
    document.result.unrolled_samples.push_back(
        {.gap_leakage = (is_full ? 2e-9 : 1.4e-9) * s.gas_pressure / 62e5,
         .ends_share_load = 2e-3 + 1e-3 * std::cos(phi),
         .ends_share_friction = -4e-4,
         .ends_share_flow = s.oil_flow_middle == 0 ? kNaN : 1e-3 + 1e-6 / s.oil_flow_middle,
         .gap_leakage_low_end = 0,
         .gap_leakage_high_end = 0,
         .oil_flow_without_ends = s.oil_flow_middle});
  }
  document.result.unrolled_values.mean_absolute_gap_leakage = 0.7e-9;
  document.result.unrolled_values.gap_leakage_share = 1.2e-4;
  document.result.unrolled_values.ends_share_mean_load = 2e-3;
}

}  // namespace example
