#include "ringfilm/cycle/cycle_values.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <utility>

#include "ringfilm/cycle/between_samples.hpp"
#include "ringfilm/cycle/regimes.hpp"
#include "ringfilm/cycle/setup/contact_setup.hpp"
#include "ringfilm/cycle/setup/indicated_pressure.hpp"
#include "ringfilm/cycle/setup/kinematics.hpp"
#include "ringfilm/models/oil/oil_fit.hpp"

namespace ringfilm::cycle {
namespace {

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

/// Masses of gas through a broken film, and how long gas holds the ring off the liner. Straight lines lie between the
/// samples: the flow begins and ends with a jump.
void put_gas_through_film(const std::vector<Sample>& samples, double duration, CycleValues& values) {
  for (std::size_t k = 0; k < samples.size(); ++k) {
    const std::size_t before = (k == 0 ? samples.size() : k) - 1;
    const double share = 0.5 * (interval(samples, before) + interval(samples, k)) / kCycleDeg;
    const double mass = samples[k].gas_flow_through_film * share * duration;
    (mass > 0 ? values.gas_through_film_forward : values.gas_through_film_back) += std::abs(mass);
    if (samples[k].distance_off_liner > 0) values.off_liner_share += share;
  }
}

BetweenSamples between(const std::vector<Sample>& samples) {
  std::vector<double> angles;
  for (const Sample& s : samples) angles.push_back(s.crank_angle_deg);
  return BetweenSamples(std::move(angles));
}

/// Values of the curves through the samples of a cycle. Film thickness and lambda ratio change by factors between two
/// steps where a ring lifts off or comes down: the curve is that of their logarithm.
class Curves {
  using Member = double Sample::*;
  static bool is_logarithmic(Member member) {
    return member == &Sample::min_film_thickness || member == &Sample::lambda_ratio;
  }
  /// A value as the curve has it, and back.
  static double on_curve(double value, Member member) {
    constexpr double kAboveZero = std::numeric_limits<double>::min();
    return is_logarithmic(member) ? std::log(std::max(value, kAboveZero)) : value;
  }
  static double from_curve(double value, Member member) { return is_logarithmic(member) ? std::exp(value) : value; }
  auto curve(Member member) const {
    return [this, member](std::size_t k) { return on_curve(samples_[k].*member, member); };
  }

 public:
  using Place = BetweenSamples::Place;

  explicit Curves(const std::vector<Sample>& samples) : samples_(samples), between_(between(samples)) {}

  template <class Value>
  double mean(const Value& value) const {
    return between_.mean([&](std::size_t k) { return value(samples_[k]); });
  }
  double mean(Member member) const {
    return mean([member](const Sample& s) { return s.*member; });
  }
  double at(double crank_angle_deg, Member member) const {
    return from_curve(between_.at(crank_angle_deg, curve(member)), member);
  }

  Place largest(Member member) const {
    return largest_where([](double) { return true; }, member);
  }
  /// Up to an angle before and after firing TDC [degree].
  Place largest_within(double window_deg, Member member) const {
    return largest_where([=](double angle) { return std::min(angle, kCycleDeg - angle) <= window_deg; }, member);
  }
  Place smallest(Member member) const {
    const auto least = std::min_element(samples_.begin(), samples_.end(),
                                        [&](const Sample& a, const Sample& b) { return a.*member < b.*member; });
    const auto k_least = static_cast<std::size_t>(least - samples_.begin());
    const Place place = between_.largest_near(k_least, [curve = curve(member)](std::size_t k) { return -curve(k); });
    return from_curve({-place.value, place.angle_deg}, *least, member);
  }
  /// Integral of a value over a stroke, over the crank angle [degree].
  double integral(int stroke, Member member) const {
    const std::vector<double>& weights = between_.weights(stroke);
    double sum = 0;
    for (std::size_t k = 0; k < samples_.size(); ++k) sum += weights[k] * (samples_[k].*member);
    return sum;
  }

 private:
  /// A place of the curve as a value, that of the sample without rounding where it is the place.
  static Place from_curve(Place place, const Sample& sample, Member member) {
    const bool is_sample = place.angle_deg == sample.crank_angle_deg;
    return {is_sample ? sample.*member : from_curve(place.value, member), place.angle_deg};
  }
  template <class Within>
  Place largest_where(const Within& is_within, Member member) const {
    std::optional<std::size_t> top;
    for (std::size_t k = 0; k < samples_.size(); ++k) {
      if (!is_within(samples_[k].crank_angle_deg)) continue;
      if (!top || samples_[k].*member > samples_[*top].*member) top = k;
    }
    if (!top) return {0, 0};
    const Place place = between_.largest_near(*top, curve(member));
    const Sample& sample = samples_[*top];
    if (is_within(place.angle_deg)) return from_curve(place, sample, member);
    return {sample.*member, sample.crank_angle_deg};
  }

  const std::vector<Sample>& samples_;
  BetweenSamples between_;
};

/// eq-full-film-lambda [-]; nothing where the asperities cannot carry that much at any separation.
std::optional<double> full_film_lambda_ratio(const RingSetup& ring) {
  constexpr int kHalvings = 40;
  const double limit = kFullFilmBelow * ring.elastic_pressure;
  const auto carries_more = [&](double h) { return ring.contact->contact(h).pressure > limit; };
  double low = 0, high = ring.contact->reach();
  if (!carries_more(low)) return std::nullopt;
  for (int i = 0; i < kHalvings; ++i) {
    const double middle = 0.5 * (low + high);
    (carries_more(middle) ? low : high) = middle;
  }
  return high / ring.sigma;
}

}  // namespace

CycleValues cycle_values(const Setup& setup, const std::vector<Sample>& base) {
  const double duration = cycle_time(setup);
  const Curves curves(base);
  CycleValues v;
  v.mean_power_loss = curves.mean([](const Sample& s) { return s.power_loss; });
  v.energy_per_cycle = v.mean_power_loss * duration;
  v.fmep = v.energy_per_cycle / swept_volume(setup.input.engine);
  v.mean_boundary_power =
      curves.mean([](const Sample& s) { return s.boundary_friction * std::abs(s.piston_velocity); });
  v.mean_viscous_power = curves.mean([](const Sample& s) { return s.viscous_friction * std::abs(s.piston_velocity); });
  v.archard_wear_load = curves.mean([](const Sample& s) { return s.archard_wear_load_rate; }) * duration;

  const auto put = [](const BetweenSamples::Place& place, double& value, double& angle) {
    value = place.value;
    angle = place.angle_deg;
  };
  const auto mean_and_peak = [&](double Sample::*part, double& average, double& peak, double& angle) {
    average = curves.mean(part);
    put(curves.largest(part), peak, angle);
  };
  mean_and_peak(&Sample::boundary_friction, v.mean_boundary_friction, v.peak_boundary_friction,
                v.peak_boundary_friction_angle);
  mean_and_peak(&Sample::viscous_friction, v.mean_viscous_friction, v.peak_viscous_friction,
                v.peak_viscous_friction_angle);
  mean_and_peak(&Sample::total_friction, v.mean_total_friction, v.peak_total_friction, v.peak_total_friction_angle);

  put(curves.largest(&Sample::viscous_heating_rise), v.peak_viscous_heating_rise, v.peak_viscous_heating_rise_angle);
  put(curves.largest(&Sample::max_local_deformation), v.peak_local_deformation, v.peak_local_deformation_angle);
  const auto up = curves.largest(&Sample::twist), down = curves.smallest(&Sample::twist);
  put(up.value >= -down.value ? up : down, v.peak_twist, v.peak_twist_angle);
  put(curves.largest(&Sample::flash_temperature), v.peak_flash_temperature, v.peak_flash_temperature_angle);

  put(curves.largest(&Sample::friction_coefficient), v.peak_friction_coefficient, v.peak_friction_coefficient_angle);
  v.peak_friction_coefficient_firing = curves.largest_within(kFiringWindowDeg, &Sample::friction_coefficient).value;

  put(curves.smallest(&Sample::min_film_thickness), v.min_film_thickness, v.min_film_thickness_angle);
  v.max_film_thickness = curves.largest(&Sample::min_film_thickness).value;
  v.min_lambda_ratio = curves.smallest(&Sample::lambda_ratio).value;
  v.peak_mean_real_pressure = curves.largest(&Sample::mean_real_pressure).value;
  const models::CyclePressure& gas = setup.ring.lands.above;
  v.peak_gas_pressure = gas.peak();
  v.peak_gas_pressure_angle = gas.peak_angle_deg();
  v.lambda_ratio_at_peak_pressure = curves.at(v.peak_gas_pressure_angle, &Sample::lambda_ratio);
  put_regime_shares(base, v);

  const double mean_load = curves.mean([](const Sample& s) { return s.applied_load; });
  const auto load_mean = [&](double Sample::*member) {
    return curves.mean([&](const Sample& s) { return s.*member * s.applied_load; }) / mean_load;
  };
  v.mean_friction_coefficient = load_mean(&Sample::friction_coefficient);
  v.mean_stribeck_number = load_mean(&Sample::stribeck_number);
  v.mean_lambda_ratio = load_mean(&Sample::lambda_ratio);

  v.net_oil_flow = curves.mean([](const Sample& s) { return s.oil_flow_middle; });
  v.mean_absolute_oil_flow = curves.mean([](const Sample& s) { return std::abs(s.oil_flow_middle); });
  v.peak_film_pressure = curves.largest(&Sample::peak_film_pressure).value;
  v.mean_cavitated_fraction = curves.mean([](const Sample& s) { return s.cavitated_fraction; });
  put_gas_through_film(base, duration, v);

  const auto stroke_energy = [&](int stroke) {
    return curves.integral(stroke, &Sample::power_loss) * duration / kCycleDeg;
  };
  v.power_stroke_energy = stroke_energy(0);
  v.exhaust_stroke_energy = stroke_energy(1);
  v.intake_stroke_energy = stroke_energy(2);
  v.compression_stroke_energy = stroke_energy(3);
  return v;
}

CycleValues no_cycle_values() {
  CycleValues v;
  for (const CycleQuantity& quantity : cycle_quantities()) {
    v.*quantity.value = std::numeric_limits<double>::quiet_NaN();
  }
  return v;
}

StrokeProfile stroke_profile(const Setup& setup, const std::vector<Sample>& base, double archard_wear_load) {
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
  double sum = 0;
  for (const double density : profile.archard_wear_load_density) sum += density * bin;
  if (sum > 0) {
    for (double& density : profile.archard_wear_load_density) density *= archard_wear_load / sum;
  }
  return profile;
}

OilOfCycle oil_of_cycle(const LinerOil& oil) {
  const auto goes_down = [](std::size_t stroke) { return stroke % 2 == 0; };
  return {oil.of_last_cycle(),
          [&oil, goes_down](std::size_t stroke, double begin, double end) {
            return oil.mean(oil.passes()[stroke].before, begin, end, goes_down(stroke));
          },
          [&oil, goes_down](std::size_t stroke, double begin, double end) {
            return oil.mean(oil.passes()[stroke].after, begin, end, !goes_down(stroke));
          }};
}

void add_liner_oil(const Setup& setup, const OilOfCycle& oil, CycleValues& values, StrokeProfile& profile) {
  const double length = setup.input.ring_length(), rho = setup.ring.oil.density;
  values.oil_scraped_up = oil.account.scraped_up * length;
  values.oil_scraped_down = oil.account.scraped_down * length;
  values.oil_replenished = oil.account.replenished * length;
  const double bin = setup.engine.crank.stroke() / kStrokeBins;
  for (std::size_t stroke = 0; stroke < kStrokes; ++stroke) {
    for (int b = 0; b < kStrokeBins; ++b) {
      profile.film_ahead[stroke].push_back(oil.ahead(stroke, b * bin, (b + 1) * bin) / rho);
      profile.film_behind[stroke].push_back(oil.behind(stroke, b * bin, (b + 1) * bin) / rho);
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
      {"oil_viscosity", setup.ring.oil.viscosity},
      {"oil_density", setup.ring.oil.density},
      {"face_height_minimum", setup.ring.face.minimum().height},
      {"face_height_chamber_edge", grid.node_height.front()},
      {"face_height_crankcase_edge", grid.node_height.back()},
      {"nominal_contact_area", c.ring_length() * c.ring.face_width},
      {"swept_volume", swept_volume(c.engine)},
      {"mean_piston_speed", 2 * c.engine.stroke * c.operating.speed / (2 * std::numbers::pi)},
  };
  const models::CyclePressure cylinder =
      c.ring.pressure_above.is_stated() ? cylinder_pressure(c) : setup.ring.lands.above;
  values["imep"] = indicated_pressure(c.engine, cylinder).net;
  if (const auto index = compression_index(c, cylinder)) values["compression_index"] = *index;
  if (const auto& pair = setup.ring.asperities) values["roughness_parameter"] = pair->N * pair->beta * pair->sigma;
  if (const auto lambda = full_film_lambda_ratio(setup.ring)) values["full_film_lambda_ratio"] = *lambda;
  if (const auto curve = plateau_curve(c.contact)) {
    values["Rpq"] = curve->Rpq;
    values["Rvq"] = curve->Rvq;
    values["Rmq"] = curve->Rmq;
    values["plateau_roughness"] = setup.ring.asperities->sigma;
    values["plateau_offset"] = plateau_offset(c.contact);
  }
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
  const auto oil = setup.ring.oil.range->at(setup.ring.oil.temperature);
  if (const models::OilFit* fit = oil->fit()) {
    values["property_fit_error"] = fit->error;
    values["property_fit_pressure"] = fit->high;
  }
  return values;
}

}  // namespace ringfilm::cycle
