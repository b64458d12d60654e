#include "ringfilm/cycle/cycle_values.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "ringfilm/cycle/integration/kinematics.hpp"
#include "ringfilm/models/oil/oil_fit.hpp"

namespace ringfilm::cycle {
namespace {

/// Below this lambda ratio lubrication counts as mixed.
constexpr double kMixedBelow = 3;
constexpr double kFiringWindowDeg = 60;
constexpr int kStrokeBins = 100;

double swept_volume(const Engine& e) { return std::numbers::pi / 4 * e.bore * e.bore * e.stroke; }

double cycle_time(const Setup& setup) { return 4 * std::numbers::pi / setup.input.operating.speed; }

/// From one sample to the next one, across the end of the cycle as well [degree].
double interval(const std::vector<Sample>& samples, std::size_t k) {
  if (samples.size() == 1) return kCycleDeg;
  const double to = k + 1 < samples.size() ? samples[k + 1].crank_angle_deg : samples[0].crank_angle_deg + kCycleDeg;
  return to - samples[k].crank_angle_deg;
}

/// Mean over the crank angle by the trapezoidal rule.
template <typename Value>
double mean(const std::vector<Sample>& samples, Value value) {
  double sum = 0, before = interval(samples, samples.size() - 1);
  for (std::size_t k = 0; k < samples.size(); ++k) {
    const double after = interval(samples, k);
    sum += 0.5 * (before + after) * value(samples[k]);
    before = after;
  }
  return sum / kCycleDeg;
}

/// Share of the cycle in which `value`, straight between the samples, is below the limit [-].
template <typename Value>
double share_below(const std::vector<Sample>& samples, double limit, Value value) {
  double sum = 0;
  for (std::size_t k = 0; k < samples.size(); ++k) {
    const double a = value(samples[k]), b = value(samples[(k + 1) % samples.size()]);
    const double low = std::min(a, b), high = std::max(a, b);
    const double share = high < limit ? 1 : low >= limit ? 0 : (limit - low) / (high - low);
    sum += share * interval(samples, k);
  }
  return sum / kCycleDeg;
}

struct Peak {
  double value;
  double angle_deg;
  std::size_t place;
};

/// Steps of more unequal lengths do not show the bend between them.
constexpr double kMostUnequal = 2.1;

/// The parabola through a sample and its neighbours, at an angle from it; flat where their steps are too unequal.
struct Parabola {
  double value, slope = 0, bend = 0, left = 0, right = 0;

  Parabola(const std::vector<Sample>& samples, std::size_t k, double Sample::*member) : value(samples[k].*member) {
    const std::size_t n = samples.size();
    if (n < 3) return;
    left = interval(samples, (k + n - 1) % n);
    right = interval(samples, k);
    if (std::max(left, right) > kMostUnequal * std::min(left, right)) return;
    const double to_left = (value - samples[(k + n - 1) % n].*member) / left;
    const double to_right = (samples[(k + 1) % n].*member - value) / right;
    slope = (to_left * right + to_right * left) / (left + right);
    bend = (to_right - to_left) / (left + right);
  }
  double at(double shift) const { return value + shift * (slope + shift * bend); }
};

/// The vertex next to an extreme sample.
Peak vertex(const std::vector<Sample>& samples, std::size_t k, double Sample::*member) {
  const Parabola parabola(samples, k, member);
  const double shift = parabola.bend != 0 ? -parabola.slope / (2 * parabola.bend) : 0;
  const bool is_near = 2 * shift >= -parabola.left && 2 * shift <= parabola.right;
  if (!is_near) return {samples[k].*member, samples[k].crank_angle_deg, k};
  return {parabola.at(shift), std::fmod(samples[k].crank_angle_deg + shift + kCycleDeg, kCycleDeg), k};
}

std::size_t place_of_largest(const std::vector<Sample>& samples, double Sample::*member) {
  const auto it = std::max_element(samples.begin(), samples.end(),
                                   [&](const Sample& a, const Sample& b) { return a.*member < b.*member; });
  return static_cast<std::size_t>(it - samples.begin());
}

/// Of what has kinks at the dead centres, which are steps.
Peak largest_sample(const std::vector<Sample>& samples, double Sample::*member) {
  const std::size_t k = place_of_largest(samples, member);
  return {samples[k].*member, samples[k].crank_angle_deg, k};
}

Peak largest(const std::vector<Sample>& samples, double Sample::*member) {
  return vertex(samples, place_of_largest(samples, member), member);
}

Peak smallest(const std::vector<Sample>& samples, double Sample::*member) {
  const auto it = std::min_element(samples.begin(), samples.end(),
                                   [&](const Sample& a, const Sample& b) { return a.*member < b.*member; });
  return vertex(samples, static_cast<std::size_t>(it - samples.begin()), member);
}

/// Trapezoidal rule over the samples of a stroke.
double stroke_energy(const Setup& setup, const std::vector<Sample>& samples, int stroke) {
  double energy = 0;
  for (std::size_t k = 0; k < samples.size(); ++k) {
    // A crank step that a dead centre divides goes to the stroke that holds its middle.
    const double step = interval(samples, k);
    const double middle = samples[k].crank_angle_deg + 0.5 * step;
    if (static_cast<int>(middle / 180) != stroke) continue;
    energy += 0.5 * (samples[k].power_loss + samples[(k + 1) % samples.size()].power_loss) * step;
  }
  return energy * cycle_time(setup) / kCycleDeg;
}

}  // namespace

CycleValues cycle_values(const Setup& setup, const std::vector<Sample>& base) {
  const double duration = cycle_time(setup);
  CycleValues v;
  v.mean_power_loss = mean(base, [](const Sample& s) { return s.power_loss; });
  v.energy_per_cycle = v.mean_power_loss * duration;
  v.fmep = v.energy_per_cycle / swept_volume(setup.input.engine);
  v.mean_boundary_power = mean(base, [](const Sample& s) { return s.boundary_friction * std::abs(s.piston_velocity); });
  v.mean_viscous_power = mean(base, [](const Sample& s) { return s.viscous_friction * std::abs(s.piston_velocity); });
  v.archard_wear_load = mean(base, [](const Sample& s) { return s.archard_wear_load_rate; }) * duration;

  const auto mean_and_peak = [&](double Sample::*part, double& average, double& peak, double& angle) {
    average = mean(base, [&](const Sample& s) { return s.*part; });
    const Peak p = largest(base, part);
    peak = p.value;
    angle = p.angle_deg;
  };
  mean_and_peak(&Sample::boundary_friction, v.mean_boundary_friction, v.peak_boundary_friction,
                v.peak_boundary_friction_angle);
  mean_and_peak(&Sample::viscous_friction, v.mean_viscous_friction, v.peak_viscous_friction,
                v.peak_viscous_friction_angle);
  mean_and_peak(&Sample::total_friction, v.mean_total_friction, v.peak_total_friction, v.peak_total_friction_angle);

  const Peak heating = largest(base, &Sample::viscous_heating_rise);
  v.peak_viscous_heating_rise = heating.value;
  v.peak_viscous_heating_rise_angle = heating.angle_deg;
  const Peak deformation = largest(base, &Sample::max_local_deformation);
  v.peak_local_deformation = deformation.value;
  v.peak_local_deformation_angle = deformation.angle_deg;
  const Peak flash = largest(base, &Sample::flash_temperature);
  v.peak_flash_temperature = flash.value;
  v.peak_flash_temperature_angle = flash.angle_deg;

  const Peak mu = largest_sample(base, &Sample::friction_coefficient);
  v.peak_friction_coefficient = mu.value;
  v.peak_friction_coefficient_angle = mu.angle_deg;
  for (const Sample& s : base) {
    if (std::abs(std::remainder(s.crank_angle_deg, kCycleDeg)) <= kFiringWindowDeg) {
      v.peak_friction_coefficient_firing = std::max(v.peak_friction_coefficient_firing, s.friction_coefficient);
    }
  }

  const Peak thinnest = smallest(base, &Sample::min_film_thickness);
  v.min_film_thickness = thinnest.value;
  v.min_film_thickness_angle = thinnest.angle_deg;
  v.max_film_thickness = largest(base, &Sample::min_film_thickness).value;
  v.min_lambda_ratio = smallest(base, &Sample::lambda_ratio).value;
  v.peak_mean_real_pressure = largest(base, &Sample::mean_real_pressure).value;
  const Peak gas = largest_sample(base, &Sample::gas_pressure);  // an input
  v.peak_gas_pressure = gas.value;
  v.peak_gas_pressure_angle = gas.angle_deg;
  const double beyond = vertex(base, gas.place, &Sample::gas_pressure).angle_deg - gas.angle_deg;
  v.lambda_ratio_at_peak_pressure =
      Parabola(base, gas.place, &Sample::lambda_ratio).at(std::remainder(beyond, kCycleDeg));
  v.mixed_share = share_below(base, kMixedBelow, [](const Sample& s) { return s.lambda_ratio; });

  const double mean_load = mean(base, [](const Sample& s) { return s.applied_load; });
  const auto load_mean = [&](double Sample::*member) {
    return mean(base, [&](const Sample& s) { return s.*member * s.applied_load; }) / mean_load;
  };
  v.mean_friction_coefficient = load_mean(&Sample::friction_coefficient);
  v.mean_stribeck_number = load_mean(&Sample::stribeck_number);
  v.mean_lambda_ratio = load_mean(&Sample::lambda_ratio);

  v.net_oil_flow = mean(base, [](const Sample& s) { return s.oil_flow_middle; });
  v.mean_absolute_oil_flow = mean(base, [](const Sample& s) { return std::abs(s.oil_flow_middle); });
  v.peak_film_pressure = largest(base, &Sample::peak_film_pressure).value;
  v.mean_cavitated_fraction = mean(base, [](const Sample& s) { return s.cavitated_fraction; });

  v.power_stroke_energy = stroke_energy(setup, base, 0);
  v.exhaust_stroke_energy = stroke_energy(setup, base, 1);
  v.intake_stroke_energy = stroke_energy(setup, base, 2);
  v.compression_stroke_energy = stroke_energy(setup, base, 3);
  return v;
}

CycleValues no_cycle_values() {
  CycleValues v;
  for (const CycleQuantity& quantity : cycle_quantities()) {
    v.*quantity.value = std::numeric_limits<double>::quiet_NaN();
  }
  return v;
}

StrokeProfile stroke_profile(const Setup& setup, const std::vector<Sample>& base) {
  const double stroke = setup.engine.crank.stroke();
  const double bin = stroke / kStrokeBins;
  StrokeProfile profile;
  for (int b = 0; b < kStrokeBins; ++b) profile.liner_position.push_back((b + 0.5) * bin);
  profile.archard_wear_load_density.assign(kStrokeBins, 0.0);
  for (std::size_t k = 0; k < base.size(); ++k) {
    const Sample& a = base[k];
    const Sample& b = base[(k + 1) % base.size()];
    const double low = std::min(a.piston_position, b.piston_position);
    const double high = std::max(a.piston_position, b.piston_position);
    const double step_time = cycle_time(setup) * interval(base, k) / kCycleDeg;
    const double work = 0.5 * (a.archard_wear_load_rate + b.archard_wear_load_rate) * step_time;
    const int first = std::clamp(static_cast<int>(low / bin), 0, kStrokeBins - 1);
    const int last = std::clamp(static_cast<int>(high / bin), 0, kStrokeBins - 1);
    for (int i = first; i <= last; ++i) {
      const double overlap = std::min(high, (i + 1) * bin) - std::max(low, i * bin);
      const double share = first == last ? 1.0 : std::max(overlap, 0.0) / (high - low);
      profile.archard_wear_load_density[i] += work * share / bin;
    }
  }
  return profile;
}

void add_liner_oil(const Setup& setup, const LinerOil& oil, CycleValues& values, StrokeProfile& profile) {
  const double length = setup.input.ring_length(), rho = setup.ring.oil.density;
  const LinerOil::Account account = oil.of_last_cycle();
  values.oil_scraped_up = account.scraped_up * length;
  values.oil_scraped_down = account.scraped_down * length;
  values.oil_replenished = account.replenished * length;
  const double bin = setup.engine.crank.stroke() / kStrokeBins;
  for (std::size_t stroke = 0; stroke < kStrokes; ++stroke) {
    const LinerOil::Pass& pass = oil.passes()[stroke];
    const bool down = stroke % 2 == 0;
    for (int b = 0; b < kStrokeBins; ++b) {
      const double begin = b * bin, end = (b + 1) * bin;
      profile.film_ahead[stroke].push_back(oil.mean(pass.before, begin, end, down) / rho);
      profile.film_behind[stroke].push_back(oil.mean(pass.after, begin, end, !down) / rho);
    }
  }
}

std::map<std::string, double> derived_values(const Setup& setup, const film::FilmGrid& grid) {
  const Case& c = setup.input;
  std::map<std::string, double> values = {
      {"elastic_pressure", setup.ring.elastic_pressure},
      {"tangential_force",
       models::tangential_force_from_elastic_pressure(setup.ring.elastic_pressure, c.ring.face_width, c.engine.bore)},
      {"composite_modulus", setup.ring.E_prime},
      {"roughness", setup.ring.sigma},
      {"roughness_parameter", c.contact.asperity_density * c.contact.asperity_radius * setup.ring.sigma},
      {"oil_viscosity", setup.ring.oil.viscosity},
      {"oil_density", setup.ring.oil.density},
      {"face_height_minimum", setup.ring.face.minimum().height},
      {"face_height_chamber_edge", grid.node_height.front()},
      {"face_height_crankcase_edge", grid.node_height.back()},
      {"nominal_contact_area", c.ring_length() * c.ring.face_width},
      {"swept_volume", swept_volume(c.engine)},
      {"mean_piston_speed", 2 * c.engine.stroke * c.operating.speed / (2 * std::numbers::pi)},
  };
  if (!setup.ring.asperities) values.erase("roughness_parameter");
  const auto summits = setup.ring.asperities ? models::summit_statistics(*setup.ring.asperities) : std::nullopt;
  if (summits) {
    values["asperity_bandwidth"] = summits->bandwidth;
    values["asperity_slope"] = summits->rms_slope;
    values["summit_plane_offset"] = summits->summit_offset;
    if (c.contact.hardness) {
      values["plasticity_index"] =
          models::plasticity_index(*setup.ring.asperities, summits->summit_spread, *c.contact.hardness);
    }
  }
  if (const auto& hths = setup.ring.oil.hths_viscosity) values["hths_viscosity"] = *hths;
  if (const models::OilFit* fit = setup.ring.oil.range->at(setup.ring.oil.temperature)->fit()) {
    values["property_fit_error"] = fit->error;
    values["property_fit_pressure"] = fit->high;
  }
  return values;
}

}  // namespace ringfilm::cycle
