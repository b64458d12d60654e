#include "ringfilm/cycle/integration/unrolled_sampling.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "ringfilm/base/display.hpp"
#include "ringfilm/cycle/integration/sampling.hpp"
#include "ringfilm/cycle/setup/kinematics.hpp"
#include "ringfilm/film/cavitation.hpp"

namespace ringfilm::cycle {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

/// The part of `whole` that is not there if all of the ring is like its strip halfway; NaN where there is no whole.
double share_of_ends(double whole, double without_ends) { return whole == 0 ? kNone : 1 - without_ends / whole; }

double flow_from_chamber(double flow_middle, Axis axis) {
  return axis == Axis::kFromChamber ? flow_middle : -flow_middle;
}

double total_friction(const Contact& contact, const film::StripIntegrals& strip, double asperity_area) {
  return boundary_friction(contact, strip.asperity_load, asperity_area) +
         std::abs(strip.shear_couette + strip.shear_poiseuille);
}

/// A ring is lifted off where it is carried by less than this share of what presses it on beyond the gas at its edges.
constexpr double kLiftedOff = 0.1;

/// eq-film-2d-open-area.
bool is_lifted_off(const Setup& setup, const film::FilmInputs& inputs, const film::StripIntegrals& strip) {
  const double at_edges = 0.5 * (inputs.left.pressure + inputs.right.pressure) * setup.input.ring.face_width;
  return strip.hydrodynamic_load + strip.asperity_load - at_edges < kLiftedOff * (inputs.load - at_edges);
}

void add_clearance(const Setup& setup, const TimeIntegration& integration, const Instant& instant,
                   const std::vector<film::StripIntegrals>& strips, UnrolledSample& s) {
  const film::CircumferentialGrid& around = integration.film2d()->around;
  const double gap = setup.input.ring.end_gap.value_or(0), radius = setup.input.engine.bore / 2;
  for (int j = 0; j < around.n_strips(); ++j) {
    const double separation = instant.state->h_m + integration.rise(*instant.state, j);
    if (separation > s.max_clearance) {
      s.max_clearance = separation;
      s.max_clearance_place = number_in((0.5 * gap + around.y[j]) / radius, kDegree);
    }
    if (!is_lifted_off(setup, instant.at.inputs, strips[j])) continue;
    s.open_area += around.share[j] * separation;
    s.gas_opening += around.share[j] / (2 * std::numbers::pi * radius) * separation * separation * separation;
    s.lifted_angle += number_in(around.share[j] / radius, kDegree);
  }
  s.gas_opening = std::cbrt(s.gas_opening);
}

}  // namespace

UnrolledSample unrolled_sample(const Setup& setup, const TimeIntegration& integration, const Instant& instant,
                               const film::Film2dIntegrals& integrals, const Sample& whole) {
  const film::CircumferentialGrid& around = integration.film2d()->around;
  const double length = around.length;
  const film::StripIntegrals& strip = integrals.strips.at(around.halfway());
  UnrolledSample s;
  s.gap_leakage_low_end = integrals.flow_low;
  s.gap_leakage_high_end = integrals.flow_high;
  s.gap_leakage = integrals.flow_low + integrals.flow_high;
  s.oil_flow_without_ends = flow_from_chamber(strip.flow_middle, instant.at.axis) * length;
  s.load_without_ends = (strip.hydrodynamic_load + strip.asperity_load) * length;
  s.ends_share_load = share_of_ends(whole.hydrodynamic_load + whole.asperity_load, s.load_without_ends);
  const double area = setup.input.bends() ? strip.asperity_area : integrals.mean.asperity_area;
  s.friction_without_ends = total_friction(setup.input.contact, strip, area) * length;
  s.ends_share_friction = share_of_ends(whole.total_friction, s.friction_without_ends);
  s.ends_share_flow = share_of_ends(whole.oil_flow_middle, s.oil_flow_without_ends);
  add_clearance(setup, integration, instant, integrals.strips, s);
  return s;
}

UnrolledValues unrolled_values(const std::vector<Sample>& whole, const std::vector<UnrolledSample>& samples) {
  UnrolledValues v;
  double load = 0, load_without_ends = 0, power = 0, power_without_ends = 0, flow = 0, flow_without_ends = 0;
  for (std::size_t k = 0; k < whole.size(); ++k) {
    const UnrolledSample& s = samples[k];
    v.mean_gap_leakage += s.gap_leakage;
    v.mean_absolute_gap_leakage += std::abs(s.gap_leakage);
    if (k == 0 || std::abs(s.gap_leakage) > std::abs(v.peak_gap_leakage)) {
      v.peak_gap_leakage = s.gap_leakage;
      v.peak_gap_leakage_angle = whole[k].crank_angle_deg;
    }
    v.mean_open_area += s.open_area;
    if (k == 0 || s.open_area > v.peak_open_area) {
      v.peak_open_area = s.open_area;
      v.peak_open_area_angle = whole[k].crank_angle_deg;
    }
    if (k == 0 || s.max_clearance > v.peak_clearance) {
      v.peak_clearance = s.max_clearance;
      v.peak_clearance_angle = whole[k].crank_angle_deg;
    }
    load += whole[k].hydrodynamic_load + whole[k].asperity_load;
    load_without_ends += s.load_without_ends;
    power += whole[k].power_loss;
    power_without_ends += s.friction_without_ends * std::abs(whole[k].piston_velocity);
    flow += std::abs(whole[k].oil_flow_middle);
    flow_without_ends += std::abs(s.oil_flow_without_ends);
  }
  const auto n = static_cast<double>(whole.size());
  v.mean_gap_leakage /= n;
  v.mean_open_area /= n;
  v.mean_absolute_gap_leakage /= n;
  v.gap_leakage_share = flow == 0 ? kNone : v.mean_absolute_gap_leakage / (flow / n);
  v.ends_share_mean_load = share_of_ends(load, load_without_ends);
  v.ends_share_friction_power = share_of_ends(power, power_without_ends);
  v.ends_share_absolute_flow = share_of_ends(flow, flow_without_ends);
  return v;
}

double ring_imbalance(const film::Film2dProblem& problem, const film::Film2dInputs& inputs,
                      const film::FilmState& state, const std::vector<film::StripIntegrals>& strips) {
  const auto carried = [&](int j) { return strips[j].hydrodynamic_load + strips[j].asperity_load - inputs.load_of(j); };
  std::vector<double> displaced = film::displacements(problem, state.h_m, state.ring);
  for (int j = 0; j < problem.around.n_strips(); ++j) {
    displaced[problem.ring.of_strip(j)] -= problem.ring.flattening * carried(j);
  }
  const std::vector<double> force = film::bending_force(problem.ring, inputs, displaced);
  double left = 0;
  for (int j = 0; j < problem.around.n_strips(); ++j) {
    left += std::abs(force[problem.ring.of_strip(j)] + problem.around.share[j] * carried(j));
  }
  return left / (inputs.strip.load * problem.around.length);
}

UnrolledValues no_unrolled_values() {
  UnrolledValues v;
  for (const UnrolledCycleQuantity& quantity : unrolled_cycle_quantities()) v.*quantity.value = kNone;
  return v;
}

void UnrolledRecorder::keep(const TimeIntegration& integration, const Instant& instant,
                            const film::Film2dIntegrals& integrals, const Sample& whole) {
  samples_[instant.crank_angle_deg] = unrolled_sample(setup_, integration, instant, integrals, whole);
}

void UnrolledRecorder::keep_fields(const TimeIntegration& integration, const Instant& instant,
                                   const film::Film2dIntegrals& integrals) {
  UnrolledFields kept;
  const auto keep = [](std::vector<float>& field, double value) { field.push_back(static_cast<float>(value)); };
  for (const film::StripIntegrals& strip : integrals.strips) {
    keep(kept.strip_hydrodynamic_load, strip.hydrodynamic_load);
    keep(kept.strip_asperity_load, strip.asperity_load);
    keep(kept.strip_peak_film_pressure, strip.peak_pressure);
    keep(kept.strip_cavitated_fraction, strip.cavitated_fraction);
    keep(kept.strip_min_film_thickness, strip.min_film_thickness);
    keep(kept.strip_total_friction, total_friction(setup_.input.contact, strip, strip.asperity_area));
    keep(kept.strip_oil_flow_middle, flow_from_chamber(strip.flow_middle, instant.at.axis));
    keep(kept.strip_lifted_off, is_lifted_off(setup_, instant.at.inputs, strip) ? 1 : 0);
  }
  for (const double deviation : integration.bore_at_strips(instant.at)) keep(kept.strip_bore_deviation, deviation);
  if (setup_.input.output.reduction == FieldReduction::kAlongFace) {
    fields_[instant.crank_angle_deg] = std::move(kept);
    return;
  }
  const film::Film2dProblem& problem = *integration.film2d();
  const film::FilmState& state = *instant.state;
  const bool local = problem.strip.contact_spread == film::ContactSpread::kLocal;
  const double closed = film::closed_film(problem);
  const int n = problem.n_across();
  for (int j = 0; j < problem.around.n_strips(); ++j) {
    const double separation = state.h_m + integration.rise(state, j);
    const double of_contact = film::closed_separation(separation, closed);
    for (int k = 0; k < n; ++k) {
      const std::size_t at = static_cast<std::size_t>(j) * n + (instant.at.axis == Axis::kFromChamber ? k : n - 1 - k);
      const double height = problem.gap.node[at], h = separation + height;
      keep(kept.film_thickness, h);
      keep(kept.film_pressure, state.p[at]);
      keep(kept.film_content, film::film_content(problem.strip.cavitation, state.deficit[at]));
      keep(kept.asperity_pressure, setup_.ring.contact->contact(local ? of_contact + height : of_contact).pressure);
    }
  }
  fields_[instant.crank_angle_deg] = std::move(kept);
}

void UnrolledRecorder::add_to(CycleResult& result, const TimeIntegration& integration,
                              const std::vector<Sample>& base) const {
  for (const Sample& sample : result.samples) result.unrolled_samples.push_back(samples_.at(sample.crank_angle_deg));
  std::vector<UnrolledSample> of_base;
  for (const Sample& sample : base) of_base.push_back(samples_.at(sample.crank_angle_deg));
  result.unrolled_values = result.complete ? unrolled_values(base, of_base) : no_unrolled_values();

  const Case& c = setup_.input;
  UnrolledFields& all = result.unrolled;
  all.circumference = std::numbers::pi * c.engine.bore;
  all.end_gap = c.ring.end_gap.value_or(0);
  all.gap_position = c.ring.end_gap ? radians(c.ring.gap_position_deg) : 0;
  all.x = integration.film2d()->strip.grid.x;
  all.y = integration.film2d()->around.y;
  for (const auto& [angle_deg, kept] : fields_) all.crank_angle_deg.push_back(angle_deg);
  for (const auto* fields : {&unrolled_fields(), &strip_fields()}) {
    for (const UnrolledField& field : *fields) {
      std::vector<float>& to = all.*field.values;
      for (const auto& [angle_deg, kept] : fields_) {
        const std::vector<float>& from = kept.*field.values;
        if (to.empty()) to.reserve(from.size() * fields_.size());
        to.insert(to.end(), from.begin(), from.end());
      }
    }
  }
}

}  // namespace ringfilm::cycle
